//! Soil and wires: units, planes, angles and counts.

use super::towers::{monopile, reference};
use super::{odd, of, one, quiet};
use towermodes::Quantity::{SoilPlaneRatio, SoilSpring, WinklerLengths, WireAngle, WireDiameter};
use towermodes::{Place, SoilRow, TowerDescription, Warning};
use towermodes_testing::{Says, parts};

fn soil(factor: f64) -> impl FnOnce(&mut TowerDescription) {
    move |t| {
        each_row(t, |row| {
            row.stiffness.x_n_per_m2 *= factor;
            row.stiffness.y_n_per_m2 *= factor;
        });
    }
}

fn each_row(t: &mut TowerDescription, change: impl Fn(&mut SoilRow)) {
    for row in t.soil.iter_mut().flatten() {
        change(row);
    }
}

#[test]
fn soil_that_is_too_soft_to_hold() {
    // Base springs of 6e9 N m are 0.66 EI/H: the soil has to hold. Over its 30 m the mean spring is
    // 7.6e7 N/m2 with the firmer layer; EI of 6.5 m with a wall of 66 mm is 1.45e12 N m2:
    // (4EI/k)^(1/4) = 16.6 m, so the length is 1.8 of these, and half of one with 1/170 of the
    // springs.
    quiet(monopile(), soil(1.0 / 120.0));
    let place = Place::Soil {
        layer: 0,
        row: 0,
        key: "x",
    };
    odd(WinklerLengths, place, monopile(), soil(1.0 / 250.0));
    // A footing that holds by itself may have any soil around it.
    quiet(monopile(), |t| {
        soil(1.0 / 250.0)(t);
        t.foundation = towermodes::Foundation::Springs(towermodes::FoundationSprings {
            lateral_n_per_m: 1e10,
            rocking_n_m: 1e12,
            coupling_n: 0.0,
            vertical_n_per_m: 1e10,
            torsion_n_m: 1e12,
        });
    });
}

#[test]
fn soil_in_kilonewtons() {
    // The stiffest row of the first layer has 1.2e8 N/m2, that of the second 3e7.
    let stiffest = |n_per_m2: f64| {
        move |t: &mut TowerDescription| {
            t.soil.truncate(1);
            soil(n_per_m2 / 1.2e8)(t);
            t.foundation = towermodes::Foundation::Clamped;
        }
    };
    let has = |warnings: &[Warning]| {
        let odd = |w: &&Warning| {
            matches!(
                w,
                Warning::Unusual {
                    quantity: SoilSpring,
                    ..
                }
            )
        };
        warnings.iter().filter(odd).count()
    };
    assert_eq!(has(&of(monopile(), stiffest(5.1e4))), 0);
    assert_eq!(has(&of(monopile(), stiffest(4.9e4))), 1);
    assert_eq!(has(&of(monopile(), stiffest(0.99e12))), 0);
    assert_eq!(has(&of(monopile(), stiffest(1.01e12))), 1);
    let (_, said) = one(monopile(), |t| {
        t.soil.truncate(1);
        soil(1e-3)(t);
    });
    said.says("not kN/m2");
}

#[test]
fn soil_that_is_softer_in_one_direction() {
    let ratio = |ratio: f64| {
        move |t: &mut TowerDescription| {
            t.soil[0][1].stiffness.y_n_per_m2 = ratio * t.soil[0][1].stiffness.x_n_per_m2;
        }
    };
    let place = Place::Soil {
        layer: 0,
        row: 1,
        key: "y",
    };
    for inside in [9.9, 1.0 / 9.9] {
        quiet(monopile(), ratio(inside));
    }
    for outside in [10.1, 1.0 / 10.1, 1e-3] {
        odd(SoilPlaneRatio, place, monopile(), ratio(outside));
    }
}

fn wires(
    count: usize,
    stiffness_n_per_m: f64,
    angle_deg: f64,
) -> impl FnOnce(&mut TowerDescription) {
    move |t| {
        t.wires = vec![parts::wires(20.0, count, stiffness_n_per_m, angle_deg)];
    }
}

fn at(key: &'static str) -> Place {
    Place::Wires { index: 0, key }
}

#[test]
fn wires_in_kilonewtons() {
    // 20 m up at 45 degrees: 28.3 m. EA/L of a wire of 3 mm: 1.6e11 pi/4 0.003^2 / 28.28 = 39 986
    // N/m.
    quiet(reference(), wires(4, 40.1e3, 45.0));
    let change = wires(4, 39.9e3, 45.0);
    let diameter_m = odd(WireDiameter, at("stiffness"), reference(), change);
    assert!((diameter_m - 0.003).abs() < 1e-5);
    // 1.15e6 N/m in kN/m.
    let change = wires(4, 1.15e3, 38.7);
    odd(WireDiameter, at("stiffness"), reference(), change);
}

#[test]
fn angles_in_radians_and_counts() {
    for angle_deg in [0.785, 1.99] {
        let change = wires(4, 1e6, angle_deg);
        odd(WireAngle, at("angle_deg"), reference(), change);
    }
    quiet(reference(), wires(4, 1e6, 2.01));
    // Level wires to a building.
    quiet(reference(), wires(4, 1e6, 0.0));
    quiet(reference(), wires(24, 1e6, 45.0));
    for count in [25, 1_000_000_000] {
        let (warning, said) = one(reference(), wires(count, 1e6, 45.0));
        assert_eq!(warning.place(), Some(at("count")));
        assert!(said.contains("at most 24"), "{said}");
    }
}

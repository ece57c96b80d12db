//! Floating platforms: heights, masses, inertias, springs and signs.

use super::towers::floater;
use super::{odd, of, one, quiet};
use towermodes::Quantity::{
    HeaveFrequency, PlatformDepth, PlatformShare, RadiusOfBody, SurgeFrequency,
};
use towermodes::{FloatingPlatform, Foundation, Place, TowerDescription, Warning};
use towermodes_testing::{Says, assert_matches};

fn platform(change: impl FnOnce(&mut FloatingPlatform)) -> impl FnOnce(&mut TowerDescription) {
    move |t| match &mut t.foundation {
        Foundation::Floating(platform) => change(platform),
        _ => panic!("no platform"),
    }
}

fn at(key: &'static str) -> Place {
    Place::Foundation { key }
}

#[test]
fn the_spar_is_quiet() {
    quiet(floater(), |_| {});
}

#[test]
fn centres_and_heights_far_below() {
    // The tower is 77.6 m high on a base at 10 m: four heights are 310.4 m.
    let centre = |z_m: f64| platform(move |p| p.center_m[2] = z_m);
    quiet(floater(), centre(-300.0));
    odd(PlatformDepth, at("center"), floater(), centre(-301.0));
    odd(PlatformDepth, at("center"), floater(), centre(-90000.0));
    let beside = |x_m: f64| platform(move |p| p.center_m[0] = x_m);
    odd(PlatformDepth, at("center"), floater(), beside(311.0));
    quiet(floater(), beside(30.0));
    let height = |m: f64| platform(move |p| p.mooring.height_m = m);
    let place = at("mooring_height");
    odd(PlatformDepth, place, floater(), height(-90000.0));
    let height = |m: f64| platform(move |p| p.added_mass.height_m = m);
    let place = at("added_mass_height");
    odd(PlatformDepth, place, floater(), height(-90000.0));
    let height = |m: f64| platform(move |p| p.hydrostatic.height_m = m);
    let place = at("hydrostatic_height");
    odd(PlatformDepth, place, floater(), height(-90000.0));
    quiet(floater(), height(-0.5));
}

#[test]
fn platforms_in_tonnes() {
    // The turbine has 565 t. The inertia goes with the mass.
    let mass = |kg: f64| {
        platform(move |p| {
            let factor = kg / p.mass_kg;
            p.mass_kg = kg;
            let inertia = &mut p.inertia_kg_m2;
            (inertia.xx, inertia.yy, inertia.zz) = (
                factor * inertia.xx,
                factor * inertia.yy,
                factor * inertia.zz,
            );
        })
    };
    let carried_kg = {
        let tower = towermodes::Tower::new(floater()).expect("a tower");
        tower.mass_kg() + tower.rna().mass_kg
    };
    quiet(floater(), mass(0.051 * carried_kg));
    let change = mass(0.049 * carried_kg);
    odd(PlatformShare, at("mass"), floater(), change);
}

#[test]
fn inertias_of_platforms() {
    let inertia = |factor: f64| {
        platform(move |p| {
            let inertia = &mut p.inertia_kg_m2;
            (inertia.xx, inertia.yy, inertia.zz) = (
                factor * inertia.xx,
                factor * inertia.yy,
                factor * inertia.zz,
            );
        })
    };
    // sqrt(4e9/7.5e6) is 23.1 m; the tower and the way down to the centre are 177.6 m: a factor of
    // 59.1.
    quiet(floater(), inertia(59.0));
    odd(RadiusOfBody, at("inertia"), floater(), inertia(59.3));
    odd(RadiusOfBody, at("inertia"), floater(), inertia(1e-3));
    let wide = |zz: f64| platform(move |p| p.inertia_kg_m2.zz = zz);
    quiet(floater(), wide(8.07e9));
    let (warning, said) = one(floater(), wide(8.09e9));
    assert_matches!(warning, Warning::TriangleInequality { .. });
    said.begins("foundation: ");
}

#[test]
fn springs_of_water_and_moorings_in_kilonewtons() {
    // 8.3e6 kg on (3.3e5 + 1.2e4) N/m have 0.0323 Hz; 0.008 Hz are 6.1 % of that stiffness.
    let heave = |factor: f64| {
        platform(move |p| {
            p.hydrostatic.matrix[2][2] *= factor;
            p.mooring.matrix[2][2] *= factor;
        })
    };
    quiet(floater(), heave(0.063));
    odd(HeaveFrequency, at("hydrostatic"), floater(), heave(0.060));
    odd(HeaveFrequency, at("hydrostatic"), floater(), heave(1e-3));
    // 16.07e6 kg on 4.1e4 N/m have 0.00804 Hz: 0.001 Hz are 1.55 % of it.
    let surge = |factor: f64| {
        platform(move |p| {
            for i in [0, 1] {
                p.mooring.matrix[i][i] *= factor;
                // The couplings go with it.
                for j in [3, 4] {
                    p.mooring.matrix[i][j] *= factor;
                    p.mooring.matrix[j][i] *= factor;
                }
            }
        })
    };
    quiet(floater(), surge(0.0157));
    odd(SurgeFrequency, at("mooring"), floater(), surge(0.0153));
    odd(SurgeFrequency, at("mooring"), floater(), surge(1e-3));
}

#[test]
fn couplings_of_platforms() {
    let turned = |which: fn(&mut FloatingPlatform) -> &mut [[f64; 6]; 6]| {
        platform(move |p| {
            let matrix = which(p);
            for (i, j) in [(0, 4), (4, 0), (1, 3), (3, 1)] {
                matrix[i][j] *= -1.0;
            }
        })
    };
    for (which, key, above_m) in [
        (
            (|p| &mut p.added_mass.matrix) as fn(&mut FloatingPlatform) -> &mut [[f64; 6]; 6],
            "added_mass",
            4.95e8 / 8e6 - 10.0,
        ),
        (|p| &mut p.mooring.matrix, "mooring", 2.8e6 / 4.1e4 - 10.0),
    ] {
        let warnings = of(floater(), turned(which));
        let found = warnings.iter().find_map(|w| match w {
            Warning::ActsAbove { above_m, .. } => Some((w.place(), *above_m)),
            _ => None,
        });
        let (place, got_m) = found.unwrap_or_else(|| panic!("{warnings:?}"));
        assert_eq!(place, Some(at(key)));
        assert!((got_m - above_m).abs() < 1e-9, "{got_m}");
    }
    // 5 % of sqrt(8e6 3.8e10) = 5.51e8 are 2.76e7.
    let along = |value: f64| {
        platform(move |p| {
            p.added_mass.matrix[0][3] = value;
            p.added_mass.matrix[3][0] = value;
        })
    };
    quiet(floater(), along(2.7e7));
    let (warning, _) = one(floater(), along(2.8e7));
    assert_matches!(warning, Warning::CouplingAlongAxis { .. });
}

/// What differs by less than a ten-thousandth of its size is rounding; entries that are zero have
/// the size of their diagonal entries.
#[test]
fn matrices_that_are_not_quite_symmetric() {
    // sqrt(8e6 8e6) = 8e6: half of 800 is 5e-5 of it.
    let noise = |value: f64| platform(move |p| p.added_mass.matrix[0][1] = value);
    quiet(floater(), noise(790.0));
    let (warning, said) = one(floater(), noise(1600.0));
    assert_matches!(warning, Warning::Symmetrized { difference, .. } if (difference - 1e-4).abs() < 1e-12);
    assert_eq!(
        said,
        "the platform's added mass is not symmetric: half the difference of opposite entries is up to 0.01 % of their size; the mean of both is used"
    );
}

/// The tower of a turbine in a current is as short as its platform is deep.
fn short(change: impl FnOnce(&mut FloatingPlatform)) -> Vec<Warning> {
    of(floater(), |t| {
        t.stations[1].height_m = 24.0;
        platform(|p| {
            // A cube of water of this mass has an edge of 13.46 m.
            p.mass_kg = 2.5e6;
            p.center_m[2] = 4.0;
            change(p);
        })(t);
    })
}

#[test]
fn wide_platforms_of_short_towers() {
    let said = |inertia: f64| {
        let warnings = short(|p| {
            let own = &mut p.inertia_kg_m2;
            (own.xx, own.yy, own.zz) = (inertia, inertia, inertia);
        });
        let said = warnings.iter().map(ToString::to_string);
        // The rotor-nacelle assembly of this short tower has such a warning too.
        said.filter(|said| said.contains("radius of gyration"))
            .filter(|said| !said.starts_with("rotor-nacelle assembly"))
            .collect::<Vec<_>>()
    };
    // 24 m and 45 m, more than the 20 m from the centre to the top of the tower.
    assert_eq!(said(1.5e9), Vec::<String>::new());
    assert_eq!(
        said(5e9).len(),
        1,
        "{:?}",
        short(|p| p.inertia_kg_m2.xx = 5e9)
    );
}

#[test]
fn lines_may_begin_a_little_above_the_base_of_a_short_tower() {
    let is_above = |z_m: f64| {
        let warnings = short(|p| {
            let force = 4.1e4 * z_m;
            for (i, j, value) in [(0, 4, force), (1, 3, -force)] {
                p.mooring.matrix[i][j] = value;
                p.mooring.matrix[j][i] = value;
            }
        });
        let mut warnings = warnings.iter();
        warnings.any(|w| matches!(w, Warning::ActsAbove { .. }))
    };
    assert!(!is_above(11.5));
    assert!(is_above(12.5));
}

//! Diameters, walls and materials.

use super::towers::{reference, rich};
use super::{odd, of, one, quiet};
use towermodes::Quantity::{Density, MaterialWaveSpeed, YoungsModulus};
use towermodes::{Material, Place, Station, TowerDescription, Warning};
use towermodes_testing::{changed, stations};

/// Eleven stations of the reference tower.
fn eleven() -> TowerDescription {
    let station = |k: usize| {
        let s = k as f64 / 10.0;
        Station::new(87.6 * s, 6.0 - 2.13 * s, 0.027 - 0.008 * s)
    };
    changed!(reference(), stations = (0..11).map(station).collect())
}

fn is_wall(warning: &Warning, index: usize) -> bool {
    matches!(warning, Warning::UnusualWall { .. })
        && warning.place() == Some(Place::Station { index, key: "wall" })
}

#[test]
fn walls_of_steel_thicker_than_a_30th_of_the_diameter() {
    let wall = |t: f64| {
        move |d: &mut TowerDescription| {
            d.stations = vec![Station::new(0.0, 3.96, t), Station::new(60.0, 3.96, t)];
        }
    };
    quiet(reference(), wall(3.96 / 30.1));
    let (warning, _) = one(reference(), wall(3.96 / 29.9));
    assert!(is_wall(&warning, 0), "{warning:?}");
    // 0.18 for 0.018.
    let said = one(reference(), wall(0.18)).1;
    assert!(
        said.starts_with("station 1: wall thickness 0.18 m at z = 0 m is 1/22 of the diameter 3.96 m; expected 1/500 to 1/30"),
        "{said}"
    );
    // A mast of a small turbine is a pipe.
    quiet(reference(), |d| {
        d.stations = stations(&[(0.0, 0.22, 0.02), (12.0, 0.22, 0.02)]);
    });
    // Concrete has thick walls.
    quiet(rich(), |_| {});
    quiet(reference(), |d| {
        d.materials[0] = Material::from_poissons_ratio(2500.0, 3.6e10, 0.2);
        wall(0.39)(d);
    });
}

#[test]
fn flanges_are_thick_and_short() {
    let ring = |height_m: f64| {
        move |t: &mut TowerDescription| {
            let (low, high) = (43.8, 43.8 + height_m);
            t.stations = vec![
                Station::new(0.0, 5.0, 0.03),
                Station::new(low, 5.0, 0.03),
                Station::new(low, 5.0, 0.25),
                Station::new(high, 5.0, 0.25),
                Station::new(high, 5.0, 0.03),
                Station::new(87.6, 5.0, 0.03),
            ];
        }
    };
    // Half of its length belongs to each of its two rows; 2.5 m is half the diameter.
    quiet(reference(), ring(4.9));
    assert!(is_wall(&one(reference(), ring(5.1)).0, 2));
}

#[test]
fn the_worst_wall_is_named() {
    let warnings = of(eleven(), |t| {
        t.stations[3].wall_thickness_m = 0.24;
        t.stations[7].wall_thickness_m = 0.9;
    });
    let walls: Vec<&Warning> = warnings
        .iter()
        .filter(|w| matches!(w, Warning::UnusualWall { .. }))
        .collect();
    assert!(walls.len() == 1 && is_wall(walls[0], 7), "{warnings:?}");
}

#[test]
fn walls_and_diameters_a_power_of_ten_off() {
    let out_of_line = |key, index, warnings: &[Warning]| {
        let place = Some(Place::Station { index, key });
        warnings
            .iter()
            .any(|w| matches!(w, Warning::RowOutOfLine { .. }) && w.place() == place)
    };
    let wall = |factor: f64| of(eleven(), move |t| t.stations[5].wall_thickness_m *= factor);
    assert_eq!(wall(3.9), []);
    // Within a power of ten and 0.12: 7.6 to 13.2 times. In between a grouted connection may be.
    assert!(!out_of_line("wall", 5, &wall(7.5)));
    assert!(out_of_line("wall", 5, &wall(7.7)));
    assert!(out_of_line("wall", 5, &wall(0.1)));
    let diameter = |factor: f64| of(eleven(), move |t| t.stations[5].outer_diameter_m *= factor);
    assert_eq!(diameter(1.9), []);
    assert!(out_of_line("diameter", 5, &diameter(0.1)));
    // A step is two rows.
    let stepped = of(reference(), |t| {
        t.stations = vec![
            Station::new(0.0, 8.0, 0.4),
            Station::new(40.0, 8.0, 0.4),
            Station::new(40.0, 8.0, 0.04),
            Station::new(80.0, 6.0, 0.03),
        ];
        t.materials[0] = Material::from_poissons_ratio(2500.0, 3.6e10, 0.2);
    });
    assert_eq!(stepped, []);
}

/// Two cans, the upper one beginning with a diameter.
fn cans(diameter_m: f64) -> impl Fn(&mut TowerDescription) {
    move |t| {
        t.stations = stations(&[
            (0.0, 6.0, 0.03),
            (40.0, 6.0, 0.03),
            (40.0, diameter_m, 0.03),
            (87.6, 4.0, 0.02),
        ]);
    }
}

#[test]
fn steps_of_the_diameter_between_welded_cans() {
    // A tenth of the larger diameter.
    quiet(reference(), cans(5.41));
    quiet(reference(), cans(6.66));
    let (warning, said) = one(reference(), cans(5.37));
    assert_eq!(
        said,
        "station 3: the outer diameter steps by 630 mm at z = 40 m, from 6 m below to 5.37 m above: check both diameters"
    );
    let (index, key) = (2, "diameter");
    assert_eq!(warning.place(), Some(Place::Station { index, key }));
    // A tower on a monopile has another wall.
    quiet(reference(), |t| {
        cans(5.0)(t);
        t.stations[0].wall_thickness_m = 0.06;
        t.stations[1].wall_thickness_m = 0.06;
    });
    // A mast of pipes in each other, a steel tower on one of concrete.
    quiet(reference(), |t| {
        t.stations = stations(&[
            (0.0, 0.3, 0.01),
            (6.0, 0.3, 0.01),
            (6.0, 0.2, 0.01),
            (12.0, 0.2, 0.01),
        ]);
    });
    quiet(reference(), |t| {
        t.materials = vec![
            Material::from_poissons_ratio(2500.0, 3.6e10, 0.2),
            t.materials[0],
        ];
        cans(5.0)(t);
        t.stations[2].material = 1;
        t.stations[3].material = 1;
    });
}

#[test]
fn densities_and_moduli() {
    let with = |rho: f64, e: f64| {
        move |t: &mut TowerDescription| {
            t.materials[0] = Material::from_poissons_ratio(rho, e, 0.3);
        }
    };
    let at = |key| Place::Material { index: 0, key };
    quiet(reference(), with(301.0, 1e10));
    odd(Density, at("density"), reference(), with(299.0, 1e10));
    quiet(reference(), with(24.9e3, 9e11));
    odd(Density, at("density"), reference(), with(25.1e3, 9e11));
    quiet(reference(), with(400.0, 1.01e9));
    // E in GPa, in MPa.
    for modulus in [0.99e9, 210.0, 2.1e5] {
        let place = at("youngs_modulus");
        odd(YoungsModulus, place, reference(), with(400.0, modulus));
    }
    // Steel's modulus with the density of half of it: sqrt(2.1e11/2187) is 9800 m/s.
    quiet(reference(), with(2190.0, 2.1e11));
    let change = with(2180.0, 2.1e11);
    odd(MaterialWaveSpeed, at("density"), reference(), change);
    // sqrt(E/8500) = 1500 m/s.
    quiet(reference(), with(8500.0, 1.92e10));
    let change = with(8500.0, 1.9e10);
    odd(MaterialWaveSpeed, at("density"), reference(), change);
}

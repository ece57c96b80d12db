//! Sizes that cannot be computed with are refused at their place, and no text has three hundred
//! digits.

use super::towers::reference;
use towermodes::{Place, Problem, Rna, Station, Tower, TowerDescription};
use towermodes_testing::{Says, assert_matches, parts};

#[track_caller]
fn refused(change: impl FnOnce(&mut TowerDescription)) -> (Place, String) {
    let mut description = reference();
    change(&mut description);
    let error = Tower::new(description).expect_err("out of scale");
    assert_matches!(error.problem, Problem::OutOfScale { .. });
    let said = error.to_string();
    assert!(said.len() < 160, "{said}");
    (error.place, said)
}

#[test]
fn walls_of_nothing() {
    let wall = |t: f64| {
        move |d: &mut TowerDescription| {
            for station in &mut d.stations {
                station.wall_thickness_m = t;
            }
        }
    };
    let (place, said) = refused(wall(1e-300));
    let (index, key) = (0, "wall");
    assert_eq!(place, Place::Station { index, key });
    said.reads("station 1: wall thickness is 1e-300 m; its magnitude must be from 1e-15 to 1e9 m");
    refused(wall(0.99e-15));
    let thin = |t| {
        let mut description = reference();
        wall(t)(&mut description);
        Tower::new(description)
    };
    assert!(thin(1.01e-15).is_ok());
}

#[test]
fn lengths_and_masses_beyond_all_measure() {
    refused(|t| t.stations[1].height_m = 1e300);
    refused(|t| t.stations[1] = Station::new(1.01e9, 3.87, 0.019));
    refused(|t| t.stations[0].outer_diameter_m = 1e300);
    refused(|t| t.rna = Rna::point(1e300));
    refused(|t| t.rna = Rna::point(1.01e30));
    refused(|t| t.materials[0].youngs_modulus_pa = 1e300);
    refused(|t| t.materials[0].density_kg_per_m3 = 1e-31);
    refused(|t| t.gravity_m_per_s2 = 1e-300);
    let mut long = reference();
    long.stations[1].height_m = 0.99e9;
    assert!(Tower::new(long).is_ok());
    let mut heavy = reference();
    heavy.rna = Rna::point(0.99e30);
    assert!(Tower::new(heavy).is_ok());
}

#[test]
fn huge_springs_are_still_rigid() {
    use towermodes::Foundation;
    let mut description = reference();
    description.foundation =
        Foundation::Springs(parts::springs(1e21, 1e21, 0.0, 1e21, f64::INFINITY));
    assert!(Tower::new(description).is_ok());
}

#[test]
fn heights_that_differ_look_different() {
    let mut description = reference();
    description.point_masses = vec![towermodes::PointMass {
        height_m: 87.600_000_01,
        mass_kg: 1e3,
        ..Default::default()
    }];
    let said = Tower::new(description)
        .expect_err("above the top")
        .to_string();
    said.says("height 87.60000001 m is not on the tower, which reaches from 0 m to 87.6 m");
}

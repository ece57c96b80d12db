//! Every description that no tower can have is refused with its place and numbers.

use crate::towers;

use towermodes::{
    Inertia, Place, PointMass, Problem, Rna, Shear, Station, Tower, TowerDescription, TowerError,
};
use towermodes_testing::{assert_matches, changed, with};
use towers::{elliptic, reference};

fn refused(change: impl FnOnce(&mut TowerDescription)) -> TowerError {
    let mut description = reference();
    change(&mut description);
    Tower::new(description).expect_err("no tower can be like this")
}

fn place(change: impl FnOnce(&mut TowerDescription)) -> Place {
    refused(change).place
}

const NOT_POSITIVE: [f64; 5] = [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

#[test]
fn material_properties_must_be_positive_and_finite() {
    for bad in NOT_POSITIVE {
        let at = |key| Place::Material { index: 0, key };
        let found = place(|d| d.materials[0].density_kg_per_m3 = bad);
        assert_eq!(found, at("density"));
        let found = place(|d| d.materials[0].youngs_modulus_pa = bad);
        assert_eq!(found, at("youngs_modulus"));
        let found = place(|d| d.materials[0].shear_modulus_pa = bad);
        assert_eq!(found, at("shear_modulus"));
    }
}

#[test]
fn poissons_ratio_is_between_minus_one_and_a_half() {
    // E = 2.1e11: ν = 0.5 is G = 0.7e11.
    let problem = refused(|d| d.materials[0].shear_modulus_pa = 0.69e11).problem;
    assert!(
        matches!(problem, Problem::ImpossibleModuli { poissons_ratio, .. } if poissons_ratio > 0.5)
    );
}

#[test]
fn station_values_must_be_positive_and_finite() {
    for bad in NOT_POSITIVE {
        let at = |key| Place::Station { index: 1, key };
        let found = place(|d| d.stations[1].outer_diameter_m = bad);
        assert_eq!(found, at("diameter"));
        assert_eq!(place(|d| d.stations[1].wall_thickness_m = bad), at("wall"));
    }
    for bad in [f64::NAN, f64::INFINITY] {
        let at = Place::Station {
            index: 1,
            key: "height",
        };
        assert_eq!(place(|d| d.stations[1].height_m = bad), at);
    }
}

#[test]
fn a_wall_fits_into_its_tube() {
    let error = refused(|d| d.stations[0].wall_thickness_m = 3.2);
    let said =
        "station 1: outer diameter 6 m is less than twice the wall thickness 3.2 m at z = 0 m";
    assert_eq!(error.to_string(), said);
    assert!(
        Tower::new({
            let mut solid = reference();
            solid.stations[0].wall_thickness_m = 3.0;
            solid
        })
        .is_ok()
    );
}

#[test]
fn heights_rise() {
    let problem = |heights: &[f64]| {
        let stations = heights
            .iter()
            .map(|&z| Station::new(z, 5.0, 0.03))
            .collect();
        let result = Tower::new(changed!(reference(), stations));
        result.map_err(|error| error.problem)
    };
    assert_eq!(problem(&[]), Err(Problem::TooFewStations { count: 0 }));
    assert_eq!(problem(&[0.0]), Err(Problem::TooFewStations { count: 1 }));
    assert_matches!(
        problem(&[3.0, 3.0]),
        Err(Problem::NoHeight { height_m: 3.0 })
    );
    let falls = Problem::HeightDecreases {
        height_m: 5.0,
        previous_m: 9.0,
    };
    assert_eq!(problem(&[0.0, 9.0, 5.0]), Err(falls));
    assert_eq!(
        problem(&[0.0, 4.0, 4.0, 4.0, 9.0]),
        Err(Problem::HeightThrice { height_m: 4.0 })
    );
    assert!(problem(&[0.0, 4.0, 4.0, 9.0]).is_ok());
    assert!(problem(&[-1e308, 1e308]).is_err());
}

#[test]
fn a_material_must_exist() {
    let problem = refused(|d| d.stations[0].material = 1).problem;
    assert_eq!(problem, Problem::UnknownMaterial { index: 1, count: 1 });
}

#[test]
fn factors_are_checked() {
    for bad in NOT_POSITIVE {
        let found = place(|d| d.outfitting_factor = bad);
        assert_eq!(found, Place::OutfittingFactor);
        assert_eq!(place(|d| d.shear = Shear::Coefficient(bad)), Place::Shear);
    }
    assert_eq!(place(|d| d.shear = Shear::Coefficient(1.1)), Place::Shear);
}

#[test]
fn a_machine_is_heavy() {
    let rna = |change: fn(&mut Rna)| {
        refused(|d| {
            d.rna = Rna::point(3e5);
            change(&mut d.rna);
        })
    };
    assert_eq!(rna(|r| r.mass_kg = -1.0).place, Place::Rna { key: "mass" });
    let found = rna(|r| r.mass_kg = f64::NAN).place;
    assert_eq!(found, Place::Rna { key: "mass" });
    let found = rna(|r| r.center_m[2] = f64::NAN).place;
    assert_eq!(found, Place::Rna { key: "center" });
    let found = rna(|r| r.inertia_kg_m2.yy = -1.0).place;
    assert_eq!(found, Place::Rna { key: "inertia" });
    let massless = refused(|d| {
        d.rna.inertia_kg_m2 = with!(Inertia, zz = 1.0);
    });
    assert_eq!(massless.problem, Problem::InertiaWithoutMass);
}

#[test]
fn point_masses_are_on_the_tower() {
    let mass = |height_m: f64, mass_kg: f64| {
        Tower::new(TowerDescription {
            point_masses: vec![with!(PointMass, height_m, mass_kg)],
            ..reference()
        })
    };
    for height_m in [-0.1, 87.7] {
        let problem = Problem::OutsideTower {
            height_m,
            base_m: 0.0,
            top_m: 87.6,
        };
        assert_eq!(mass(height_m, 1.0).map_err(|e| e.problem), Err(problem));
    }
    assert!(mass(f64::NAN, 1.0).is_err());
    assert!(mass(40.0, -1.0).is_err());
    for height_m in [0.0, 40.0, 87.6] {
        assert!(mass(height_m, 5000.0).is_ok());
    }
}

#[test]
fn rows_of_a_property_table_must_be_positive_and_finite() {
    type Change = fn(&mut towermodes::Properties, f64);
    let changes: [(&str, Change); 8] = [
        ("mass_kg_per_m", |p, x| p.mass_kg_per_m = x),
        ("ei_fore_aft_n_m2", |p, x| p.bending_n_m2.fore_aft = x),
        ("ei_side_side_n_m2", |p, x| p.bending_n_m2.side_side = x),
        ("gj_n_m2", |p, x| p.torsion_n_m2 = x),
        ("ea_n", |p, x| p.axial_n = x),
        ("polar_inertia_kg_m", |p, x| p.polar_inertia_kg_m = x),
        ("shear_stiffness_fore_aft_n", |p, x| {
            p.shear_n = p.shear_n.map(|shear| towermodes::Planes {
                fore_aft: x,
                ..shear
            });
        }),
        ("shear_stiffness_side_side_n", |p, x| {
            p.shear_n = p.shear_n.map(|shear| towermodes::Planes {
                side_side: x,
                ..shear
            });
        }),
    ];
    for (key, change) in changes {
        for bad in NOT_POSITIVE {
            let mut description = elliptic();
            change(&mut description.properties[2].properties, bad);
            let error = Tower::new(description).expect_err("no tower can be like this");
            assert_eq!(error.place, Place::Station { index: 2, key });
        }
    }
    let mut description = elliptic();
    description.properties[1]
        .properties
        .rotary_inertia_kg_m
        .side_side = -1.0;
    let error = Tower::new(description).expect_err("negative inertia");
    assert!(matches!(
        error.problem,
        Problem::Negative { value: -1.0, .. }
    ));
}

#[test]
fn a_table_shears_in_every_row_or_in_none_and_excludes_stations() {
    let mut description = elliptic();
    description.properties[3].properties.shear_n = None;
    let error = Tower::new(description).expect_err("half a shear");
    assert_eq!(error.problem, Problem::ShearInSomeRows);
    let mut description = elliptic();
    description.stations = reference().stations;
    description.materials = reference().materials;
    let error = Tower::new(description).expect_err("two towers");
    assert_eq!(error.problem, Problem::StationsAndProperties);
    let mut description = elliptic();
    description.properties.truncate(1);
    let error = Tower::new(description).expect_err("one row");
    assert_eq!(error.problem, Problem::TooFewStations { count: 1 });
}

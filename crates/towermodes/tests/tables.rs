//! Towers as other programs describe them: added mass in tables, elements where they say, no twist
//! or stretch, foundations rigid in some directions.

use crate::towers;

use towermodes::{
    Family, FloatingPlatform, Foundation, FoundationSprings, Method, Options, Planes, Properties,
    PropertyStation, ReferredMatrix, Rna, SolveError, StiffnessFoundation, Tower, TowerDescription,
    TowerError, solve,
};
use towermodes_testing::{Says, changed, parts, with};
use towers::{all_frequencies, assert_same, monopile, reference_eccentric, solved};

fn of_method(method: Method) -> Options {
    with!(Options, method)
}

/// A tower of one prismatic section.
fn prismatic(torsion_n_m2: f64, axial_n: f64) -> TowerDescription {
    let row = |height_m| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: 4000.0,
            rotary_inertia_kg_m: Planes::both(0.0),
            polar_inertia_kg_m: 3e4,
            bending_n_m2: Planes::both(4e11),
            torsion_n_m2,
            axial_n,
            shear_n: None,
        },
    };
    TowerDescription {
        properties: vec![row(0.0), row(90.0)],
        rna: reference_eccentric().rna,
        ..TowerDescription::default()
    }
}

/// What never moves cannot be told from what hardly moves.
#[test]
fn infinite_stiffness_is_the_limit_of_a_large_one() {
    let rigid = prismatic(f64::INFINITY, f64::INFINITY);
    let stiff = prismatic(4e11 * 1e9, 1e11 * 1e9);
    for method in Method::ALL {
        let options = changed!(of_method(method), modes = 6);
        let (rigid, stiff) = (solved(&rigid, &options), solved(&stiff, &options));
        let (rigid, stiff) = (all_frequencies(&rigid), all_frequencies(&stiff));
        assert_same(&rigid, &stiff, 1e-7, method.name());
    }
}

#[test]
fn a_tower_that_does_not_twist_has_no_torsion() {
    let rigid = prismatic(f64::INFINITY, f64::INFINITY);
    let solution = solved(&rigid, &Options::default());
    let families = solution.modes.iter().map(|mode| mode.family);
    assert!(
        families
            .clone()
            .all(|f| f != Family::Torsion && f != Family::Axial)
    );
}

/// On a platform it yaws as a rigid body: f = √(K/J)/2π.
#[test]
fn a_tower_that_does_not_twist_yaws_with_its_platform() {
    let mut tower = prismatic(f64::INFINITY, f64::INFINITY);
    tower.rna = Rna::default();
    let (yaw_n_m, yaw_kg_m2) = (1e8, 2e9);
    let mut mooring = [[0.0; 6]; 6];
    for (i, stiffness) in [1e5, 1e5, 1e6, 1e10, 1e10, yaw_n_m].into_iter().enumerate() {
        mooring[i][i] = stiffness;
    }
    let mut platform = FloatingPlatform {
        mass_kg: 1e7,
        mooring: ReferredMatrix {
            matrix: mooring,
            height_m: 0.0,
        },
        ..FloatingPlatform::default()
    };
    platform.inertia_kg_m2.xx = 1e10;
    platform.inertia_kg_m2.yy = 1e10;
    platform.inertia_kg_m2.zz = yaw_kg_m2;
    tower.foundation = Foundation::Floating(Box::new(platform));
    let whole_kg_m2 = yaw_kg_m2 + 90.0 * 3e4;
    let expected = (yaw_n_m / whole_kg_m2).sqrt() / std::f64::consts::TAU;
    for method in Method::ALL {
        let solution = solved(&tower, &of_method(method));
        let yaw = solution.mode(Family::Yaw, 1).expect("yaw");
        let difference = yaw.frequency_hz / expected - 1.0;
        assert!(difference.abs() < 1e-9, "{}: {difference:e}", method.name());
        assert!(
            yaw.shape
                .iter()
                .all(|point| (point.rotation[2] - 1.0).abs() < 1e-9)
        );
    }
}

/// The water around a tube of constant diameter as a table.
#[test]
fn a_table_of_added_mass_is_the_water_it_is_of() {
    let mut wet = monopile();
    for station in &mut wet.stations {
        station.outer_diameter_m = 6.0;
    }
    wet.water = Some(parts::water(0.0, Some(-20.0), 1025.0, 1.0, false));
    let mut table = wet.clone();
    table.water = None;
    let mass_kg_per_m = 1025.0 * std::f64::consts::FRAC_PI_4 * 36.0;
    let row = |height_m| parts::added_mass_row(height_m, mass_kg_per_m);
    table.added_mass = vec![vec![row(-20.0), row(-7.0)], vec![row(-7.0), row(0.0)]];
    for method in [Method::RmjeExact, Method::Spectral, Method::Bmodes] {
        let options = of_method(method);
        let (wet, table) = (solved(&wet, &options), solved(&table, &options));
        let (wet, table) = (all_frequencies(&wet), all_frequencies(&table));
        // The border between the tables is one more place to cut.
        let tolerance = if method == Method::Spectral {
            1e-9
        } else {
            3e-5
        };
        assert_same(&table, &wet, tolerance, method.name());
    }
}

#[test]
fn added_mass_that_cannot_be_is_refused() {
    let refused = |rows: &[(f64, f64)]| {
        let rows = rows
            .iter()
            .map(|&(height_m, mass_kg_per_m)| parts::added_mass_row(height_m, mass_kg_per_m));
        let description = changed!(reference_eccentric(), added_mass = vec![rows.collect()]);
        let error: TowerError = Tower::new(description).expect_err("no tower");
        error.problem.to_string()
    };
    refused(&[(0.0, 1.0)]).says("at least two rows, but has 1");
    refused(&[(0.0, -1.0), (10.0, 1.0)]).says("negative");
    refused(&[(10.0, 1.0), (0.0, 1.0)]).says("below the previous row");
    refused(&[(0.0, 1.0), (500.0, 1.0)]).says("extends from 0 m to 500 m");
    refused(&[(0.0, f64::NAN), (10.0, 1.0)]).says("NaN");
}

/// The elements of BModes where it is told, and where it would put them itself.
#[test]
fn borders_that_are_the_usual_ones_change_nothing() {
    let tower = prismatic(3e11, 1e11);
    let equal = changed!(of_method(Method::Bmodes), segments = Some(12));
    let told = Options {
        borders_m: Some((0..=12).map(|k| 7.5 * f64::from(k)).collect()),
        ..of_method(Method::Bmodes)
    };
    let (equal, told) = (solved(&tower, &equal), solved(&tower, &told));
    assert_eq!(told.segments, 12);
    assert_same(&all_frequencies(&told), &all_frequencies(&equal), 1e-13, "");
}

#[test]
fn borders_that_cannot_be_are_refused() {
    let tower = Tower::new(prismatic(3e11, 1e11)).expect("a tower");
    let refused = |method: Method, borders_m: &[f64]| {
        let options = changed!(of_method(method), borders_m = Some(borders_m.to_vec()));
        solve(&tower, &options).expect_err("no mesh")
    };
    let elsewhere = refused(Method::RmjeExact, &[0.0, 90.0]);
    assert!(matches!(elsewhere, SolveError::BordersOfOthers));
    for borders_m in [
        &[0.0, 80.0][..],
        &[1.0, 90.0],
        &[0.0, 50.0, 40.0, 90.0],
        &[0.0, f64::NAN, 90.0],
        &[0.0, 90.0, 95.0],
        &[],
    ] {
        let error = refused(Method::Bmodes, borders_m);
        assert!(error.is_usage(), "{borders_m:?}: {error}");
    }
}

/// A matrix that is rigid in some directions is the springs that are.
#[test]
fn a_stiffness_can_be_infinite_in_some_directions() {
    let springs = FoundationSprings {
        lateral_n_per_m: 2e9,
        rocking_n_m: 2e11,
        coupling_n: -1e10,
        ..FoundationSprings::RIGID
    };
    let mut stiffness = [[0.0; 6]; 6];
    for (i, value) in [2e9, 2e9, f64::INFINITY, 2e11, 2e11, f64::INFINITY]
        .into_iter()
        .enumerate()
    {
        stiffness[i][i] = value;
    }
    stiffness[0][4] = -1e10;
    stiffness[4][0] = -1e10;
    stiffness[1][3] = 1e10;
    stiffness[3][1] = 1e10;
    let on = |foundation| changed!(reference_eccentric(), foundation);
    let matrix = with!(StiffnessFoundation, stiffness);
    let options = Options::default();
    let matrix = solved(&on(Foundation::Stiffness(Box::new(matrix))), &options);
    let springs = solved(&on(Foundation::Springs(springs)), &options);
    assert_same(
        &all_frequencies(&matrix),
        &all_frequencies(&springs),
        1e-14,
        "",
    );
}

#[test]
fn rows_that_disagree_about_infinity_are_refused() {
    let mut description = prismatic(f64::INFINITY, 1e11);
    description.properties[1].properties.torsion_n_m2 = 1e11;
    let error = Tower::new(description).expect_err("no tower");
    error.problem.says("gj_n_m2");
}

//! Foundations, soil, water, wires and gravity of a file are those of its tower.

use towermodes::{Tower, Warning};
use towermodes_files::tower_from_toml;
use towermodes_testing::Says;

const TOWER: &str = "[material]
density = 8000.0
youngs_modulus = 2.0e11
shear_modulus = 8.0e10
[tower]
stations = [[-20.0, 6.0, 0.06], [80.0, 4.0, 0.02]]
";

#[track_caller]
fn tower(ground: &str) -> Tower {
    tower_from_toml(&format!("{TOWER}{ground}")).expect("a tower")
}

/// A matrix in TOML with these entries and zeros.
fn matrix(entries: &[(usize, usize, &str)]) -> String {
    let mut rows = [["0"; 6]; 6];
    for &(row, column, entry) in entries {
        rows[row - 1][column - 1] = entry;
        rows[column - 1][row - 1] = entry;
    }
    let rows = rows.map(|row| format!("[{}]", row.join(", ")));
    format!("[{}]", rows.join(", "))
}

#[track_caller]
fn assert_near(value: f64, expected: f64) {
    let allowed = 1e-12 * expected.abs();
    assert!((value - expected).abs() <= allowed, "{value} {expected}");
}

#[test]
fn a_tower_is_clamped_without_a_foundation_and_with_that_type() {
    for text in ["", "[foundation]\ntype = \"clamped\"\n"] {
        let tower = tower(text);
        assert!(tower.base().is_clamped());
        assert_eq!(tower.gravity_m_per_s2(), 0.0);
    }
}

#[test]
fn matrices_of_stiffness_and_mass() {
    let stiffness = matrix(&[
        (1, 1, "2e9"),
        (2, 2, "3e9"),
        (3, 3, "4e9"),
        (4, 4, "5e10"),
        (5, 5, "6e10"),
        (6, 6, "7e10"),
        (1, 5, "-1e9"),
        (2, 4, "+1_500_000_000"),
    ]);
    let mass = matrix(&[(1, 1, "1e5"), (4, 4, "2e6")]);
    let tower = tower(&format!(
        "[foundation]\ntype = \"stiffness\"\nmatrix = {stiffness}\nmass = {mass}\n"
    ));
    let base = tower.base();
    assert_eq!(base.moves, [true; 6]);
    let diagonal: [f64; 6] = std::array::from_fn(|i| base.stiffness[i][i]);
    assert_eq!(diagonal, [2e9, 3e9, 4e9, 5e10, 6e10, 7e10]);
    assert_eq!((base.stiffness[0][4], base.stiffness[4][0]), (-1e9, -1e9));
    assert_eq!((base.stiffness[1][3], base.stiffness[3][1]), (1.5e9, 1.5e9));
    assert_eq!((base.inertia[0][0], base.inertia[3][3]), (1e5, 2e6));
    assert!(!tower.planes_are_equal());
}

#[test]
fn springs_some_of_them_rigid() {
    let tower = tower(
        r#"[foundation]
type = "springs"
lateral = 1e8
rocking = 2e10
vertical = inf
torsion = +inf
coupling = -4e8
"#,
    );
    let base = tower.base();
    assert_eq!(base.moves, [true, true, false, true, true, false]);
    assert_eq!((base.stiffness[0][0], base.stiffness[1][1]), (1e8, 1e8));
    assert_eq!((base.stiffness[3][3], base.stiffness[4][4]), (2e10, 2e10));
    assert_eq!((base.stiffness[0][4], base.stiffness[1][3]), (-4e8, 4e8));
    assert_eq!((base.stiffness[2][2], base.stiffness[5][5]), (0.0, 0.0));
    assert!(tower.planes_are_equal());
}

#[test]
fn a_footing_on_a_half_space() {
    let text = r#"[foundation]
type = "half-space"
radius = 8.0
soil_shear_modulus = 5e7
soil_poissons_ratio = 0.5
"#;
    let on_the_surface = tower(text);
    let stiffness = &on_the_surface.base().stiffness;
    // 4GR/(1−ν), 32(1−ν)GR/(7−8ν), 8GR³/(3(1−ν)), 16GR³/3.
    assert_near(stiffness[2][2], 3.2e9);
    assert_near(stiffness[0][0], 6.4e9 / 3.0);
    assert_near(stiffness[4][4], 8.0 * 5e7 * 512.0 / 1.5);
    assert_near(stiffness[5][5], 16.0 * 5e7 * 512.0 / 3.0);
    let embedded = tower(&format!("{text}embedment = 4.0\n"));
    // 1 + 0.6 (1−ν) e/R.
    assert_near(embedded.base().stiffness[2][2], 3.2e9 * 1.15);
}

#[test]
fn a_floating_platform() {
    let added = matrix(&[(1, 1, "8e6"), (5, 5, "4e10")]);
    let hydrostatic = matrix(&[(3, 3, "3e5"), (4, 4, "-5e9"), (5, 5, "-5e9")]);
    let mooring = matrix(&[(1, 1, "4e4"), (2, 2, "4e4"), (6, 6, "1e8")]);
    let tower = tower(&format!(
        r#"[foundation]
type = "floating"
mass = 7e6
center = [0.5, 0.0, -90.0]
inertia = {{ xx = 4e9, yy = 5e9, zz = 2e8, xz = 1e7 }}
added_mass = {added}
added_mass_height = -20.0
hydrostatic = {hydrostatic}
hydrostatic_height = 0.0
mooring = {mooring}
mooring_height = -70.0
[gravity]
"#
    ));
    let base = tower.base();
    assert!(base.floats && base.moves == [true; 6]);
    // The tower's base is at −20 m: the added mass is about it, the platform's centre 70 m below.
    assert_eq!(base.inertia[0][0], 7e6 + 8e6);
    assert_eq!(base.inertia[1][1], 7e6);
    assert_near(base.inertia[0][4], -7e6 * 70.0);
    let expected = 4e10 + 5e9 + 7e6 * (70.0 * 70.0 + 0.5 * 0.5);
    assert_near(base.inertia[4][4], expected);
    assert_near(base.inertia[3][5], 1e7 + 7e6 * 0.5 * 70.0);
    // The moorings pull 50 m below the base.
    assert_eq!(base.stiffness[0][0], 4e4);
    assert_near(base.stiffness[0][4], -4e4 * 50.0);
    assert_near(base.stiffness[4][4], -5e9 + 4e4 * 2500.0);
    assert_eq!((base.stiffness[2][2], base.stiffness[5][5]), (3e5, 1e8));
    assert_eq!(tower.gravity_m_per_s2(), 9.80665);
    let moment = 7e6 * -90.0 + tower.mass_kg() * -20.0;
    assert_near(base.overturning_kg_m, moment);
}

#[test]
fn matrices_that_are_not_quite_symmetric_are_answered_with_a_warning() {
    let mooring = "[[4e4, 0, 0, 0, -1.00e6, 0], [0, 4e4, 0, 0, 0, 0], [0, 0, 1e4, 0, 0, 0],
        [0, 0, 0, 3e8, 0, 0], [-1.02e6, 0, 0, 0, 3e8, 0], [0, 0, 0, 0, 0, 1e8]]";
    let tower = tower(&format!(
        "[foundation]\ntype = \"floating\"\nmass = 7e6\ncenter = [0, 0, -90]\n\
         inertia = {{ xx = 4e9, yy = 4e9, zz = 2e8 }}\nmooring = {mooring}\nmooring_height = -20.0\n"
    ));
    assert_near(tower.base().stiffness[0][4], -1.01e6);
    let said = tower.warnings();
    assert!(matches!(said[0], Warning::Symmetrized { .. }), "{said:?}");
}

#[test]
fn soil_where_it_is() {
    let tower = tower(
        r#"[[soil]]
name = "sand"
rows = [[-30.0, 4e7, 6e7], [-10.0, 0, 0]]
[[soil]]
rows = [[-12.0, 1e6, 2e6, 3e6, 4e6], [-8.0, 1e6, 2e6, 3e6, 4e6]]
"#,
    );
    // From -20 to -12, -10, -8 and 80 m.
    let pieces = tower.pieces();
    assert_eq!(pieces.len(), 4);
    let ends = |index: usize| pieces[index].environment.soil.expect("soil");
    let [bottom, top] = ends(0);
    assert_near(bottom.x_n_per_m2, 2e7);
    assert_near(bottom.y_n_per_m2, 3e7);
    assert_eq!((bottom.z_n_per_m2, bottom.torsion_n), (0.0, 0.0));
    assert_near(top.x_n_per_m2, 4e6);
    // Two layers together.
    let [bottom, _] = ends(1);
    assert_near(bottom.x_n_per_m2, 5e6);
    assert_eq!((bottom.z_n_per_m2, bottom.torsion_n), (3e6, 4e6));
    assert_near(ends(2)[1].y_n_per_m2, 2e6);
    assert_eq!(pieces[3].environment.soil, None);
}

#[test]
fn water_with_its_defaults_and_without() {
    let quarter = std::f64::consts::FRAC_PI_4;
    let around = |text: &str| {
        let tower = tower(text);
        let environments: Vec<_> = tower
            .pieces()
            .iter()
            .map(|piece| piece.environment)
            .collect();
        environments
            .iter()
            .map(|a| (a.outside_kg_per_m3, a.inside_kg_per_m3))
            .collect::<Vec<_>>()
    };
    let sea = around("[water]\nlevel = 10.0\n");
    assert_eq!(sea, [(1025.0 * quarter, 0.0), (0.0, 0.0)]);
    let lake = around(
        "[water]\nlevel = 10\nbed = -5\ndensity = 1000\nadded_mass_coefficient = 0.5\nflooded = true\n",
    );
    assert_eq!(
        lake,
        [
            (0.0, 1000.0 * quarter),
            (500.0 * quarter, 1000.0 * quarter),
            (0.0, 0.0)
        ]
    );
}

#[test]
fn wires_masses_and_machine_by_height() {
    let tower = tower(
        r#"[[wires]]
height = 60.0
count = 4
stiffness = 1e6
angle_deg = 60.0
azimuth_deg = 45.0
[[point_mass]]
height = 40.0
mass = 5000.0
inertia = { xx = 10, yy = 20.0, zz = 30.0, xy = 1.0 }
[rna]
mass = 350e3
center = [-0.41, 0.0, 1.97]
"#,
    );
    let [mass, wires, rna] = tower.attachments() else {
        panic!("{:?}", tower.attachments());
    };
    assert_eq!((mass.height_m, mass.mass_kg), (40.0, 5000.0));
    assert_eq!((mass.inertia[4][4], mass.inertia[3][4]), (20.0, 1.0));
    assert_eq!(wires.height_m, 60.0);
    // n/2 k cos² and n k sin².
    assert_near(wires.stiffness[0][0], 0.5e6);
    assert_near(wires.stiffness[1][1], 0.5e6);
    assert_near(wires.stiffness[2][2], 3e6);
    assert_eq!((rna.height_m, rna.mass_kg), (80.0, 350e3));
    assert_near(rna.inertia[0][4], 350e3 * 1.97);
    assert_near(rna.inertia[2][4], 350e3 * 0.41);
}

#[test]
fn gravity_is_on_where_its_table_is() {
    let gravity = |text: &str| tower(text).gravity_m_per_s2();
    assert_eq!(gravity("[gravity]\n"), 9.80665);
    assert_eq!(gravity("[gravity]\nacceleration = 9.81\n"), 9.81);
    assert_eq!(gravity("[gravity]\nacceleration = 0\n"), 0.0);
}

#[test]
fn a_table_of_properties_stands_on_the_same_ground() {
    let table = r#"[tower.properties]
z_m = [-20.0, 80.0]
mass_kg_per_m = [5000, 3000]
ei_fore_aft_n_m2 = [6.0e11, 1.2e11]
gj_n_m2 = [5.0e11, 0.9e11]
ea_n = [1.4e11, 0.6e11]
polar_inertia_kg_m = [5.0e4, 0.9e4]
[[soil]]
rows = [[-20.0, 1e7, 1e7, 1e7, 1e7], [0.0, 0, 0, 0, 0]]
[foundation]
type = "springs"
lateral = 0
rocking = 0
vertical = 1e9
torsion = inf
"#;
    let tower = tower_from_toml(table).expect("a tower");
    assert_eq!(tower.pieces().len(), 2);
    assert!(tower.pieces()[0].environment.soil.is_some());
    assert_eq!(tower.base().moves, [true, true, true, true, true, false]);
    let mistakes = tower_from_toml(&format!("{table}[water]\nlevel = 0.0\n"));
    let mistakes = mistakes.expect_err("the table has no diameters");
    let said = &mistakes[0].message();
    said.says("table of properties has none");
}

#[test]
fn the_examples_stand_on_what_they_say() {
    let example = |text: &str| {
        let tower = tower_from_toml(text).expect("a tower");
        assert!(tower.warnings().is_empty(), "{:?}", tower.warnings());
        tower
    };
    let monopile = example(include_str!("../../../examples/monopile.toml"));
    // Cut at the bend of the soil, the bed, the water level and the step.
    let tops: Vec<f64> = monopile.pieces().iter().map(|piece| piece.top_m).collect();
    assert_eq!(tops, [-30.0, -20.0, 0.0, 10.0, 97.6]);
    assert_eq!(monopile.base().moves, [true; 6]);
    let spar = example(include_str!("../../../examples/floating.toml"));
    assert!(spar.base().floats);
    // The weights make it stable in pitch about the water plane.
    let pitch = 7.5e6 * 90.0 - spar.mass_kg() * 48.8 - 350e3 * 89.57;
    assert!(pitch * spar.gravity_m_per_s2() > 5.0e9);
    let guyed = example(include_str!("../../../examples/guyed.toml"));
    assert_eq!(guyed.attachments().len(), 3);
    assert!(guyed.planes_are_equal() && guyed.gravity_m_per_s2() > 9.8);
}

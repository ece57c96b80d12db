//! Towers of windIO files: both versions, walls and tables, monopiles, assemblies, and what is said
//! of mistakes.

use crate::sources::source;
use crate::windio_files;

use towermodes::{
    Inertia, Material, MissingPart, Options, PointMass, Properties, PropertyStation, Rna, Rotor,
    Station, Tower, TowerDescription, solve,
};
use towermodes_files::{
    Diagnostic, DiagnosticKind, InMemory, Input, ReadError, ReadOptions, Source, TowerInput,
    TowerPart, read_source, read_windio, write_toml, write_windio,
};
use towermodes_testing::{Says, changed, number, rows, with};
use windio_files::{LAYERED, TABLE, VERSION_1, VERSION_2};

fn read_part(text: &str, part: TowerPart) -> Result<TowerInput, ReadError> {
    let source = source("turbine.yaml", text);
    let options = with!(ReadOptions, part);
    read_windio(source, &options)
}

fn read(text: &str) -> TowerInput {
    read_part(text, TowerPart::All).expect("a tower")
}

/// The first mistake, its line and column.
fn mistake(text: &str) -> (usize, usize, String) {
    let error = read_part(text, TowerPart::All)
        .and_then(|input| input.tower())
        .expect_err("a mistake");
    let ReadError::Mistakes { mistakes, .. } = error else {
        panic!("{error}");
    };
    let first: &Diagnostic = &mistakes[0];
    assert!(first.span.end <= text.len(), "{first:?}");
    let (line, column) = first.line_and_column(text);
    (line, column, first.message())
}

/// What the notes say of parts that are missing.
fn missing_parts(input: &TowerInput) -> String {
    let notes = input.notes.iter().filter(|note| note.is_on_missing_part());
    notes.map(|note| format!("{}\n", note.message)).collect()
}

fn has_note(input: &TowerInput, words: &str) -> bool {
    input.notes.iter().any(|note| note.message.contains(words))
}

/// Line and column of the first place of a text, moved by some characters.
fn place(text: &str, needle: &str, moved: usize) -> (usize, usize) {
    let at = text.find(needle).expect("in the text") + moved;
    let what = String::new();
    Diagnostic::new(at..at, DiagnosticKind::Missing { what }).line_and_column(text)
}

fn near(value: f64, expected: f64, tolerance: f64) {
    let error = (value - expected).abs();
    let holds = error <= tolerance * expected.abs();
    assert!(holds, "{value} instead of {expected}");
}

fn assert_rows(stations: &[Station], expected: &[(f64, f64, f64)]) {
    let rows = stations
        .iter()
        .map(|s| (s.height_m, s.outer_diameter_m, s.wall_thickness_m));
    let rows: Vec<_> = rows.collect();
    assert_eq!(rows.len(), expected.len(), "{rows:?}");
    for (row, expected) in rows.iter().zip(expected) {
        let error =
            (row.0 - expected.0).abs() + (row.1 - expected.1).abs() + (row.2 - expected.2).abs();
        assert!(error < 1e-12, "{row:?} instead of {expected:?}");
    }
}

#[test]
fn each_quantity_has_its_own_grid() {
    let input = read_part(VERSION_2, TowerPart::Tower).expect("a tower");
    // Heights bend at 0.25, the wall steps at 0.5, the diameter is straight.
    let expected = [
        (10.0, 6.0, 0.04),
        (30.0, 5.5, 0.04),
        (50.0, 5.0, 0.04),
        (50.0, 5.0, 0.03),
        (90.0, 4.0, 0.02),
    ];
    assert_rows(&input.description.stations, &expected);
    assert_eq!(input.description.name, "small");
    assert_eq!(input.description.outfitting_factor, 1.1);
    let steel = input.description.materials[0];
    // 1e9 without a point is text to older YAML; G is E/(2 (1 + 0.25)).
    assert_eq!(steel.youngs_modulus_pa, 200e9);
    assert_eq!(steel.shear_modulus_pa, 80e9);
    assert_eq!(steel.density_kg_per_m3, 8000.0);
}

#[test]
fn tower_and_monopile_are_joined() {
    let input = read(VERSION_2);
    let expected = [
        (-40.0, 6.0, 0.06),
        (10.0, 6.0, 0.06),
        (10.0, 6.0, 0.04),
        (30.0, 5.5, 0.04),
        (50.0, 5.0, 0.04),
        (50.0, 5.0, 0.03),
        (90.0, 4.0, 0.02),
    ];
    assert_rows(&input.description.stations, &expected);
    let masses = &input.description.point_masses;
    let masses: Vec<_> = masses.iter().map(|m| (m.height_m, m.mass_kg)).collect();
    assert_eq!(masses, [(10.0, 5e4), (-40.0, 2e5), (90.0, 700.0)]);
    // The factors differ: they are in the densities.
    assert_eq!(input.description.outfitting_factor, 1.0);
    let densities = input
        .description
        .materials
        .iter()
        .map(|m| m.density_kg_per_m3);
    let densities: Vec<f64> = densities.collect();
    near(densities[0], 8000.0, 1e-15);
    near(densities[1], 8800.0, 1e-15);
    assert_eq!(input.description.stations[0].material, 0);
    assert_eq!(input.description.stations[2].material, 1);
    assert!(has_note(&input, "the mudline is not known"));
    input.tower().expect("a tower");
}

/// A monopile below the mudline stands in the soil of the file.
#[test]
fn version_1_stands_in_the_soil_of_the_file() {
    let input = read(VERSION_1);
    let expected = [(-50.0, 6.0, 0.05), (10.0, 6.0, 0.05), (90.0, 4.0, 0.02)];
    // The monopile's top is the tower's base: one station.
    assert_rows(&input.description.stations, &expected);
    assert!(has_note(
        &input,
        "the 30 m of the monopile below the mudline at z = -20 m stand in elastic soil"
    ));
    assert!(!missing_parts(&input).contains("below the mudline"));
    assert!(!missing_parts(&input).contains("those in air"));
    assert!(has_note(
        &input,
        "shear modulus 1.4e8 Pa, Poisson's ratio 0.4"
    ));
    assert!(has_note(&input, "bed = -20.0"));
    assert_eq!(input.description.water, None);
    // 1.2 E = 1.2 · 2 (1 + ν) G, from the mudline down.
    let tower = input.tower().expect("a tower");
    let springs = tower.springs_of_soil();
    let ends = springs.iter().map(|at| (at.height_m, at.lateral_n_per_m2));
    for ((height_m, spring), expected_m) in ends.zip([-50.0, -20.0]) {
        near(height_m, expected_m, 1e-15);
        near(spring, 1.2 * 2.0 * 1.4 * 1.4e8, 1e-12);
    }
    let alone = read_part(VERSION_1, TowerPart::Monopile).expect("a monopile");
    assert_rows(&alone.description.stations, &expected[..2]);
    assert_eq!(alone.description.rna, Rna::default());
}

#[test]
fn version_1_is_cut_at_the_mudline_without_soil() {
    let input = read(&VERSION_1.replace(", soil_shear_modulus: 140.e+6, soil_poisson: 0.4", ""));
    let expected = [(-20.0, 6.0, 0.05), (10.0, 6.0, 0.05), (90.0, 4.0, 0.02)];
    assert_rows(&input.description.stations, &expected);
    missing_parts(&input).says("below the mudline");
    assert_eq!(input.description.ground, None);
}

#[test]
fn a_rotor_of_straight_blades_has_its_moments() {
    // Three uniform blades of 10 kg/m from 1 m to 11 m: 300 kg; polar inertia 3 * 10 (11^3 - 1)/3 =
    // 13300, half of it diametral.
    let input = read(VERSION_1);
    let rna = &input.description.rna;
    // Hub of 500 kg at the apex, nacelle of 1000 kg and yaw of 200 kg on the axis.
    assert_eq!(rna.mass_kg, 2000.0);
    near(rna.center_m[0], -5.0 * 800.0 / 2000.0, 1e-14);
    let z_m = (2.0 * 800.0 + 1.0 * 1000.0) / 2000.0;
    near(rna.center_m[2], z_m, 1e-14);
    let J { xx, zz } = steiner(z_m);
    near(rna.inertia_kg_m2.xx, xx, 1e-13);
    near(rna.inertia_kg_m2.zz, zz, 1e-13);
    assert!(has_note(
        &input,
        "nacelle 1000 kg, yaw system 200 kg, hub 500 kg, 3 blades 300 kg"
    ));
    assert!(!has_note(&input, "INCOMPLETE"));
}

#[test]
fn why_there_is_no_turning_turbine_is_said() {
    let reason = |text: &str| {
        let input = read(text);
        assert!(input.turbine.is_none());
        input.turbine_missing.expect("a reason").to_string()
    };
    let without = reason(VERSION_1);
    let key = "the blade has no elastic_properties_mb.six_x_six.stiff_matrix";
    without.says(key);
    let stiff = VERSION_1.replace(
        "                inertia_matrix:\n                    grid: [0.0, 1.0]",
        "                stiff_matrix: {grid: [0, 1], values: [[1], [1]]}\n                inertia_matrix:\n                    grid: [0.0, 1.0]",
    );
    assert_ne!(stiff, VERSION_1);
    let straight = reason(&stiff);
    straight.says("the stiffness matrices of windIO's blades are not read");
    straight.begins("turbine.yaml:");
    let curved = reason(&stiff.replace(
        "x: {grid: [0, 1], values: [0, 0]}\n                y",
        "x: {grid: [0, 0.5, 1], values: [0, 0.25, 2]}\n                y",
    ));
    // Half of 2 m less 0.25 m.
    curved.says("the axis of the blade is curved, 0.75 m off");
    let monopile = read_part(VERSION_1, TowerPart::Monopile).expect("a monopile");
    assert_eq!(monopile.turbine_missing, None);
}

#[test]
fn chords_of_straight_blades_have_their_moment() {
    // Chords of 1 m from 1 m to 11 m: (11^2 - 1)/2 = 60 m3.
    let rotor = |text: &str| read(text).description.damping.rotor;
    let moment_m3 = rotor(VERSION_1).expect("it has chords").chord_moment_m3;
    near(moment_m3, 60.0, 1e-14);
    // Tapered to a point at the tip, over the same kinked axis: chords (11 - r)/10 m.
    let constant = "chord: {grid: [0, 1], values: [1, 1]}";
    let tapered = "chord: {grid: [0, 0.3, 1], values: [1, 0.7, 0]}";
    let moment_m3 = rotor(&VERSION_1.replace(constant, tapered)).map(|r| r.chord_moment_m3);
    // Integral of r (11 - r)/10 from 1 to 11.
    let by_hand = (11.0 * 60.0 - (1331.0 - 1.0) / 3.0) / 10.0;
    near(moment_m3.expect("it has chords"), by_hand, 1e-13);
    // A mistake in them refuses no tower.
    for wrong in [
        "chord: {grid: [0, 1], values: [1]}",
        "chord: 3",
        "chord: {grid: [0, 1], values: [-1, -1]}",
    ] {
        assert_eq!(rotor(&VERSION_1.replace(constant, wrong)), None, "{wrong}");
    }
    let alone = read_part(VERSION_1, TowerPart::Monopile).expect("a monopile");
    assert_eq!(alone.description.damping.rotor, None);
}

struct J {
    xx: f64,
    zz: f64,
}

fn steiner(z_m: f64) -> J {
    // (mass, x, z, own xx, own zz)
    let bodies = [
        (1000.0, 0.0, 1.0, 40.0, 60.0),
        (200.0, 0.0, 0.0, 0.0, 0.0),
        (500.0, -5.0, 2.0, 70.0, 0.0),
        (300.0, -5.0, 2.0, 13_300.0, 6650.0),
    ];
    let sum = |f: &dyn Fn((f64, f64, f64, f64, f64)) -> f64| bodies.into_iter().map(f).sum();
    J {
        xx: sum(&|(m, _, z, own, _)| own + m * (z - z_m) * (z - z_m)),
        zz: sum(&|(m, x, _, _, own)| own + m * (x + 2.0) * (x + 2.0)),
    }
}

#[test]
fn what_the_assembly_lacks_is_said() {
    let input = read(VERSION_2);
    assert!(has_note(
        &input,
        "INCOMPLETE ROTOR-NACELLE ASSEMBLY: 100000 kg"
    ));
    assert!(has_note(&input, "does not give the mass of hub, blades"));
    missing_parts(&input).says("INCOMPLETE");
    assert!(!missing_parts(&input).contains("shear modulus"));
    let drivetrain = "    drivetrain:";
    let start = VERSION_2.find(drivetrain).expect("there");
    let end = VERSION_2.find("materials:").expect("there");
    let bare = format!("{}{}", &VERSION_2[..start], &VERSION_2[end..]);
    assert!(has_note(&read(&bare), "NO ROTOR-NACELLE ASSEMBLY"));
    missing_parts(&read(&bare)).says("NO ROTOR-NACELLE ASSEMBLY");
    // The mark keeps resonance from being judged, in this file and in the tower file of it.
    let marked = |text: &str| read(text).description.missing_parts;
    let lacks = vec![MissingPart::Hub, MissingPart::Blades];
    assert_eq!(marked(VERSION_2), lacks);
    let (tower_file, _) = write_toml(&input.description);
    let written = source("t.toml", tower_file);
    let again = read_source(written, &InMemory::default(), &ReadOptions::default());
    let Input::Tower(again) = again.expect("a tower") else {
        panic!("a blade");
    };
    assert_eq!(again.description.missing_parts, lacks);
    // A hub without mass shows a machine; a tower alone has none, and nobody asked for one.
    let hub = bare.replacen("components:\n", "components:\n    hub: {diameter: 4}\n", 1);
    assert_ne!(hub, bare);
    let all = vec![MissingPart::Nacelle, MissingPart::Hub, MissingPart::Blades];
    assert_eq!(marked(&hub), all);
    assert_eq!(marked(&bare), []);
    let options = with!(ReadOptions, without_rna = true);
    let text = source("t.yaml", VERSION_2);
    let alone = read_windio(text, &options).expect("a tower");
    assert_eq!(alone.description.missing_parts, []);
    assert_eq!(marked(VERSION_1), []);
    // An inertia that no body has.
    let text = VERSION_2.replace("[1.0e5, 2e5, 3e5, 0, 0, 0]", "[0, 0, 0, 0, 0, 7e5]");
    let input = read(&text);
    assert!(has_note(&input, "is impossible: a principal moment"));
    assert_eq!(input.description.rna.inertia_kg_m2, Inertia::default());
}

#[test]
fn layers_are_summed_from_outside_in() {
    let input = read(LAYERED);
    let rows = &input.description.properties;
    assert!(input.description.stations.is_empty());
    // At the base: steel from 3 to 2.95 m, concrete from 2.95 to 2.65 m.
    let pi = std::f64::consts::PI;
    let ring = |a: f64, b: f64, n: i32| pi * (a.powi(n) - b.powi(n));
    let (steel_a, concrete_a) = (ring(3.0, 2.95, 2), ring(2.95, 2.65, 2));
    let (steel_i, concrete_i) = (ring(3.0, 2.95, 4) / 4.0, ring(2.95, 2.65, 4) / 4.0);
    let first = &rows[0].properties;
    let expected = 1.05 * (8000.0 * steel_a + 2500.0 * concrete_a);
    near(first.mass_kg_per_m, expected, 1e-12);
    let expected = 2e11 * steel_i + 4e10 * concrete_i;
    near(first.bending_n_m2.fore_aft, expected, 1e-12);
    near(first.axial_n, 2e11 * steel_a + 4e10 * concrete_a, 1e-12);
    let expected = 2.0 * (8e10 * steel_i + 16e9 * concrete_i);
    near(first.torsion_n_m2, expected, 1e-12);
    let inertia = 1.05 * (8000.0 * steel_i + 2500.0 * concrete_i);
    near(first.rotary_inertia_kg_m.side_side, inertia, 1e-12);
    near(first.polar_inertia_kg_m, 2.0 * inertia, 1e-12);
    // Half way between rows the straight line is near the true value.
    let top_m = 80.0;
    for pair in rows.windows(2).filter(|p| p[0].height_m < p[1].height_m) {
        let z = 0.5 * (pair[0].height_m + pair[1].height_m);
        let outer = 3.0 - 1.0 * z / top_m;
        let inner = outer - 0.05;
        let core = if z < 40.0 {
            inner - 0.3 * (1.0 - z / 40.0)
        } else {
            inner
        };
        let ei = (2e11 * ring(outer, inner, 4) + 4e10 * ring(inner, core, 4)) / 4.0;
        let line = 0.5
            * (pair[0].properties.bending_n_m2.fore_aft + pair[1].properties.bending_n_m2.fore_aft);
        near(line, ei, 1.1e-5);
    }
    assert!(rows.len() < 400, "{}", rows.len());
    input.tower().expect("a tower");
}

#[test]
fn layers_one_above_the_other_are_tubes() {
    let concrete_below = LAYERED
        .replace("values: [0.3, 0.0, 0.0]", "values: [0.3, 0.2, 0.0, 0.0]")
        .replace(
            "grid: [0.0, 0.5, 1.0] # concrete",
            "grid: [0.0, 0.5, 0.5, 1.0]",
        )
        .replace("values: [0.05, 0.05]", "values: [0.0, 0.0, 0.05, 0.05]")
        .replace("grid: [0.0, 1.0] # steel", "grid: [0.0, 0.5, 0.5, 1.0]");
    let input = read(&concrete_below);
    let expected = [
        (0.0, 6.0, 0.3),
        (40.0, 5.0, 0.2),
        (40.0, 5.0, 0.05),
        (80.0, 4.0, 0.05),
    ];
    assert_rows(&input.description.stations, &expected);
    let material = |at: usize| {
        let material = input.description.stations[at].material;
        input.description.materials[material].density_kg_per_m3
    };
    assert_eq!((material(0), material(2)), (2500.0, 8000.0));
    input.tower().expect("a tower");
}

#[test]
fn tables_are_read_where_there_are_no_layers() {
    let input = read(TABLE);
    let rows = &input.description.properties;
    let row = |at: usize| rows[at].properties;
    assert_eq!(rows.len(), 3);
    assert_eq!(rows[1].height_m, 40.0);
    assert_eq!(row(1).mass_kg_per_m, 4000.0);
    // About y, K55, is fore-aft.
    assert_eq!(row(1).bending_n_m2.fore_aft, 4e11);
    assert_eq!(row(1).bending_n_m2.side_side, 5e11);
    assert_eq!(row(0).torsion_n_m2, 3e11);
    assert_eq!(row(2).axial_n, 1.5e10);
    assert_eq!(row(0).shear_n, None);
    assert!(has_note(&input, "no rotary inertia"));
    // A thin tube of 6 m: m D^2/8 and m D^2/4.
    assert_eq!(row(0).rotary_inertia_kg_m.fore_aft, 5000.0 * 36.0 / 8.0);
    assert_eq!(row(0).polar_inertia_kg_m, 5000.0 * 36.0 / 4.0);
    input.tower().expect("a tower");
    // Without GJ and EA it neither twists nor stretches.
    let bending_only: Vec<&str> = TABLE
        .lines()
        .filter(|l| !l.contains("K33") && !l.contains("K66"))
        .collect();
    let input = read(&bending_only.join("\n"));
    let row = input.description.properties[0].properties;
    assert_eq!(row.torsion_n_m2, f64::INFINITY);
    assert_eq!(row.axial_n, f64::INFINITY);
    assert!(has_note(
        &input,
        "the elastic properties have no GJ: the tower is rigid in torsion"
    ));
    let (line, column, message) = mistake(&TABLE.replace("5000.0, 3000.0", "5000.0, -3000.0"));
    let expected = place(TABLE, "5000.0, 3000.0", 8);
    assert_eq!((line, column), expected, "{message}");
}

#[test]
fn tables_of_version_1_are_read() {
    let zeros = |at: &[(usize, f64)]| {
        let mut row = [0.0; 21];
        for &(at, value) in at {
            row[at] = value;
        }
        format!("{row:?}")
    };
    let stiffness = zeros(&[(11, 3e10), (15, 5e11), (18, 4e11), (20, 3e11)]);
    let inertia = zeros(&[
        (0, 5e3),
        (6, 5e3),
        (11, 5e3),
        (15, 20.0),
        (18, 10.0),
        (20, 30.0),
    ]);
    let axis = "{x: {grid: [0, 1], values: [0, 0]}, z: {grid: [0, 1], values: [0, 80]}}";
    let text = format!(
        "components:\n  tower:\n    outer_shape_bem: {{reference_axis: {axis}}}\n    elastic_properties_mb:\n      six_x_six:\n        stiff_matrix: {{grid: [0, 1], values: [{stiffness}, {stiffness}]}}\n        inertia_matrix: {{grid: [0, 1], values: [{inertia}, {inertia}]}}\n"
    );
    let input = read(&text);
    let row = input.description.properties[1].properties;
    assert_eq!(input.description.properties[1].height_m, 80.0);
    assert_eq!(row.mass_kg_per_m, 5e3);
    assert_eq!(row.bending_n_m2.fore_aft, 4e11);
    assert_eq!(row.bending_n_m2.side_side, 5e11);
    assert_eq!((row.torsion_n_m2, row.axial_n), (3e11, 3e10));
    let rotary = row.rotary_inertia_kg_m;
    assert_eq!((rotary.fore_aft, rotary.side_side), (10.0, 20.0));
    assert_eq!(row.polar_inertia_kg_m, 30.0);
    assert!(!has_note(&input, "couplings"));
}

#[test]
fn tables_beside_layers_are_compared() {
    let beam = |mass: f64| {
        let table = format!(
            "            elastic_properties:\n                stiffness_matrix: {{grid: [0, 1], K44: [1e12, 1e11], K55: [1e12, 1e11]}}\n                inertia_matrix: {{grid: [0, 1], mass: [{mass}, 2750.4]}}\n            layers:"
        );
        VERSION_1_AS_2.replace("            layers:", &table)
    };
    // pi t (D - t) rho f: 8224.7 kg/m at the base and 2200.6 kg/m at the top of the tower, by hand.
    let agreeing = beam(8224.7).replace("2750.4", "2200.6");
    assert!(!has_note(&read(&agreeing), "disagree"));
    let input = read(&beam(8224.7));
    assert!(has_note(&input, "at z = 90 m 2750.4 and 2200.62 kg/m"));
}

/// A tower of one layer in version 2.
const VERSION_1_AS_2: &str = "
windIO_version: '2.0'
components:
    tower:
        outer_shape:
            outer_diameter: {grid: [0, 1], values: [6.0, 4.0]}
        structure:
            outfitting_factor: 1.1
            layers:
              - {name: wall, material: 7, thickness: {grid: [0, 1], values: [0.05, 0.02]}}
        reference_axis:
            z: {grid: [0, 1], values: [10, 90]}
materials:
  - {name: 7, orth: 0, rho: 8000, E: 2e11, nu: 0.25}
";

#[test]
fn mistakes_are_shown_where_they_are() {
    let check = |from: &str, to: &str, at: &str, moved: usize, words: &str| {
        let text = VERSION_2.replacen(from, to, 1);
        assert_ne!(text, VERSION_2, "{from} is not in the file");
        let (line, column, message) = mistake(&text);
        assert_eq!((line, column), place(&text, at, moved), "{to}: {message}");
        assert!(message.contains(words), "{to}: {message}");
    };
    let table = r#"
        [6.0, 4.0] | [6.0, -4.0] | -4.0 | 0 | outer diameter is -4 m
        [6.0, 4.0] | [6.0, .nan] | .nan | 0 | not a finite number
        [6.0, 4.0] | [6.0, 4.0, 3.0] | [6.0, 4.0 | 0 | has 3 values instead of 2, the number of values in its grid
        [6.0, 4.0] | [6.0, four] | four | 0 | must be a number, found `four`
        [0.0, 0.25, 1.0] | [0.0, 0.25, 0.9] | 0.9] | 0 | is 0.9, but must be 1
        [0.0, 0.25, 1.0] | [0.1, 0.25, 1.0] | 0.1, | 0 | is 0.1, but must be 0
        [0.0, 0.5, 0.5, 1.0] | [0.0, 0.5, 0.4, 1.0] | 0.4, 1.0 | 0 | 0.4 follows 0.5
        [10, 30.0, 90.0] | [10, 95.0, 90.0] | 90.0] | 0 | is not in increasing order
        [10, 30.0, 90.0] | [5, 30.0, 90.0] | 5, 30 | 0 | 5 m below the top of the monopile
        [10, 30.0, 90.0] | [12, 30.0, 90.0] | 12, 30 | 0 | 2 m above the top of the monopile
        material: steel | material: stel | stel | 0 | there is no material `stel`
        0.04, 0.04, 0.03, 0.02 | 0.04, 0.04, 0.03, 0.0 | 0.0] | 0 | wall thickness
        0.04, 0.04, 0.03, 0.02 | 2.54, 2.54, 0.03, 0.02 | 2.54, 0 | 6 | less than twice
        rho: 8000 | rho: -8000 | -8000 | 0 | density is -8000
        nu: 0.25 | nu: 0.5 | 0.5\n | 0 | Poisson's ratio
        ␣␣␣␣nu: 0.25 |  | name: steel | 0 | has no `G`
        outfitting_factor: 1.1 | outfitting_factor: x | x\n | 0 | outfitting factor
        mass: 100000 | mass: -1 | -1\n | 0 | must be non-negative
        transition_piece_mass: 5e4 | transition_piece_mass: -5 | -5\n | 0 | mass is -5 kg
        "#;
    for [from, to, at, moved, words] in rows(table) {
        check(from, to, at, number(moved), words);
    }
}

#[test]
fn files_that_are_no_turbine_are_refused() {
    let message = |text: &str| mistake(text).2;
    message("").says("empty");
    message("[1, 2]").says("the file must be a map, found a list");
    message("a: b: c").says("invalid YAML");
    message("name: x\n").says("no `tower`");
    message("components: {tower: 3}").says("no `reference_axis`");
    let cut = &VERSION_2[..VERSION_2.find("30.0, 90.0").expect("there")];
    let (line, _, text) = mistake(cut);
    text.says("invalid YAML");
    // The bracket that is not closed, or the end.
    assert!(line >= 1, "{line}: {text}");
    assert!(line <= cut.lines().count() + 1, "{line}: {text}");
    let no_monopile = read_part(VERSION_1_AS_2, TowerPart::Monopile);
    no_monopile.expect_err("none").says("no `monopile`");
}

#[test]
fn anchors_may_be_defined_again_and_names_may_be_numbers() {
    let text = VERSION_1_AS_2
        .replace(
            "{grid: [0, 1], values: [6.0, 4.0]}",
            "{grid: &g [0, 1], values: [6.0, 4.0]}",
        )
        .replace(
            "{grid: [0, 1], values: [0.05, 0.02]}",
            "{grid: *g, values: [0.05, 0.02]}",
        )
        .replace(
            "z: {grid: [0, 1], values: [10, 90]}",
            "z: {grid: &g [0, 0.5, 1], values: &z [10, 60, 90]}",
        );
    let input = read(&text);
    let expected = [(10.0, 6.0, 0.05), (60.0, 5.0, 0.035), (90.0, 4.0, 0.02)];
    assert_rows(&input.description.stations, &expected);
    // With a byte order mark and Windows line ends the places are still right.
    let windows = format!("\u{feff}{}", text.replace('\n', "\r\n")).replace("4.0]}", "-4.0]}");
    let (line, _, message) = mistake(&windows);
    message.says("outer diameter is -4 m");
    assert_eq!(line, place(&windows, "-4.0", 0).0);
}

#[test]
fn bombs_do_not_explode() {
    let mut bomb = String::from("a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n");
    for level in 1..12 {
        let alias = format!("*a{}", level - 1);
        let list = [alias.as_str(); 10].join(", ");
        bomb.push_str(&format!("a{level}: &a{level} [{list}]\n"));
    }
    let in_use = format!("{bomb}materials: *a11\n{VERSION_1_AS_2}").replacen(
        "\nmaterials:\n",
        "\nother:\n",
        1,
    );
    assert!(read_part(&in_use, TowerPart::All).is_err());
    let deep = format!("components: {}", "[".repeat(100_000));
    assert!(read_part(&deep, TowerPart::All).is_err());
    let layer = "              - {name: wall, material: 7, thickness: {grid: [0, 1], values: [0.05, 0.02]}}\n";
    let many = VERSION_1_AS_2.replace(layer, &layer.repeat(5000));
    mistake(&many).2.says("5000 layers");
    let wide = VERSION_1_AS_2.replace("[6.0, 4.0]", &format!("[{}]", "6.0, ".repeat(300_000)));
    assert!(read_part(&wide, TowerPart::All).is_err());
}

#[test]
fn no_damage_makes_it_panic() {
    for text in [VERSION_1, VERSION_2, LAYERED, TABLE] {
        for at in (0..text.len()).filter(|at| text.is_char_boundary(*at)) {
            let _ = read_part(&text[..at], TowerPart::All).and_then(|input| input.tower());
        }
        for (from, to) in [
            ("0", "1e308"),
            (".", "e"),
            ("1", "-1"),
            ("[", "{"),
            (", ", ": "),
        ] {
            for (at, _) in text.match_indices(from) {
                let damaged = format!("{}{to}{}", &text[..at], &text[at + from.len()..]);
                let _ = read_part(&damaged, TowerPart::All).and_then(|input| input.tower());
            }
        }
    }
}

#[test]
fn small_gaps_are_closed() {
    let text = VERSION_2.replace("[10, 30.0, 90.0]", "[10.05, 30.0, 90.0]");
    let input = read(&text);
    assert!(has_note(&input, "the gap of 0.05 m"));
    assert_eq!(input.description.stations[1].height_m, 10.05);
    assert_eq!(input.description.stations[2].height_m, 10.05);
}

fn tubes() -> TowerDescription {
    TowerDescription {
        name: "a \"tower\": #1".to_owned(),
        materials: vec![Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10)],
        stations: vec![
            Station::new(0.1, 6.0, 0.027),
            Station::new(33.3, 5.1, 0.025),
            Station::new(33.3, 5.1, 0.023),
            Station::new(87.6, 3.87, 0.019),
        ],
        outfitting_factor: 1.07,
        rna: Rna {
            mass_kg: 350_000.7,
            center_m: [-0.41, 0.01, 1.97],
            inertia_kg_m2: Inertia {
                xx: 4.37e7,
                yy: 2.35e7,
                zz: 2.54e7,
                xy: 3.0,
                xz: 1.17e6,
                yz: -5.0,
            },
        },
        point_masses: vec![with!(PointMass, height_m = 33.3, mass_kg = 1234.5)],
        ..TowerDescription::default()
    }
}

fn written(description: &TowerDescription) -> (TowerInput, String) {
    let tower = Tower::new(description.clone()).expect("a tower");
    let (text, notes) = write_windio(&tower, description).expect("a file");
    assert!(!notes.is_empty());
    (read(&text), text)
}

#[test]
fn what_is_written_is_read_again() {
    let description = tubes();
    let (input, text) = written(&description);
    let again = &input.description;
    assert_eq!(again.stations, description.stations);
    assert_eq!(again.materials, description.materials);
    assert_eq!(again.rna, description.rna);
    assert_eq!(again.name, description.name);
    assert_eq!(again.outfitting_factor, 1.07);
    assert_eq!(again.point_masses.len(), 1);
    near(again.point_masses[0].height_m, 33.3, 1e-14);
    assert_eq!(again.point_masses[0].mass_kg, 1234.5);
    assert!(!has_note(&input, "disagree"), "{text}");
}

#[test]
fn several_materials_are_written_as_layers_and_read_again() {
    let mut description = tubes();
    description
        .materials
        .push(Material::from_shear_modulus(2500.0, 4e10, 1.6e10));
    description.stations[2].material = 1;
    // A change of material without a step of the tube.
    description
        .stations
        .insert(3, changed!(Station::new(50.0, 4.5, 0.02), material = 0));
    let (input, _) = written(&description);
    assert_eq!(input.description.stations.len(), 5);
    for (again, station) in input.description.stations.iter().zip(&description.stations) {
        assert_eq!(again.height_m, station.height_m);
        assert_eq!(again.outer_diameter_m, station.outer_diameter_m);
        assert_eq!(again.wall_thickness_m, station.wall_thickness_m);
    }
    let (before, after) = (
        Tower::new(description).expect("one"),
        input.tower().expect("one"),
    );
    near(after.mass_kg(), before.mass_kg(), 1e-14);
}

#[test]
fn tables_are_written_and_read_again() {
    let both = |fore_aft, side_side| towermodes::Planes {
        fore_aft,
        side_side,
    };
    let row = |height_m: f64, scale: f64| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: 5000.0 * scale,
            rotary_inertia_kg_m: both(21.0 * scale, 22.0 * scale),
            polar_inertia_kg_m: 43.0 * scale,
            bending_n_m2: both(6e11 * scale, 5e11 * scale),
            torsion_n_m2: 4e11 * scale,
            axial_n: 1e11 * scale,
            shear_n: Some(both(2e10 * scale, 3e10 * scale)),
        },
    };
    let description = TowerDescription {
        properties: vec![
            row(-5.0, 1.0),
            row(40.0, 0.7),
            row(40.0, 0.6),
            row(83.3, 0.31),
        ],
        ..TowerDescription::default()
    };
    let (input, _) = written(&description);
    assert_eq!(input.description.properties, description.properties);
}

#[test]
fn what_cannot_be_written_is_said() {
    let mut description = tubes();
    description.gravity_m_per_s2 = 9.81;
    description.point_masses[0].inertia_kg_m2.xx = 1.0;
    description.wires.push(towermodes::Wires {
        height_m: 50.0,
        count: 3,
        stiffness_n_per_m: 1e6,
        angle_deg: 45.0,
    });
    let tower = Tower::new(description.clone()).expect("a tower");
    let (_, notes) = write_windio(&tower, &description).expect("a file");
    let all: String = notes.iter().map(ToString::to_string).collect();
    all.says_all("gravity & wires & inertias of point masses & steps & drag");
    let mut description = tubes();
    let above = 33.3_f64.next_up();
    description.stations[2].height_m = above;
    let tower = Tower::new(description.clone()).expect("a tower");
    let error = write_windio(&tower, &description).expect_err("too close");
    error.says("too close");
}

/// The rotor of a file with other parts, and what is said of it.
fn rotor_of(text: &str) -> (Option<Rotor>, Vec<String>) {
    let input = read(text);
    let notes = input.rotor_notes.iter();
    let notes = notes.map(|note| note.message.clone()).collect();
    (input.description.rotor, notes)
}

#[track_caller]
fn assert_rotor(text: &str, blades: usize, [lowest_rpm, highest_rpm]: [f64; 2]) -> Vec<String> {
    let (rotor, notes) = rotor_of(text);
    let rotor = rotor.expect("a rotor");
    assert_eq!(rotor.blades, blades);
    near(rotor.lowest_rpm, lowest_rpm, 1e-15);
    near(rotor.highest_rpm, highest_rpm, 1e-15);
    notes
}

/// At its own place, not at that of the speeds.
#[test]
fn too_many_blades_are_wrong_where_they_stand() {
    let text = format!(
        "{VERSION_2}assembly: {{number_of_blades: 11}}\ncontrol: {{rated_rotor_speed: 7.5}}\n"
    );
    let (line, column) = place(&text, "number_of_blades: 11", 18);
    let (at_line, at_column, message) = mistake(&text);
    assert_eq!((at_line, at_column), (line, column));
    message.says("from 1 to 10");
}

/// Up to the rated speed; what shuts the machine down is no speed of operation.
#[test]
fn speeds_of_version_2_are_in_rpm() {
    let blades = "assembly: {number_of_blades: 2}\n";
    let with = |control: &str| format!("{VERSION_2}{blades}control: {control}\n");
    let notes = assert_rotor(
        &with("{min_rotor_speed: 5, rated_rotor_speed: 7.5, max_rotor_speed: 9}"),
        2,
        [5.0, 7.5],
    );
    assert_eq!(notes.len(), 1);
    notes[0].says("max_rotor_speed = 9 rpm is a protection limit");
    // A single speed is no range.
    let table = r#"
        {rated_rotor_speed: 7.5} | no min_rotor_speed: the operating speeds are unknown
        {min_rotor_speed: 0, rated_rotor_speed: 7.5} | min_rotor_speed is 0, the default
        "#;
    for [control, said] in rows(table) {
        let (rotor, notes) = rotor_of(&with(control));
        assert!(rotor.is_none() && notes[0].contains(said), "{notes:?}");
    }
    let unsaid = format!("{VERSION_2}control: {{min_rotor_speed: 5, rated_rotor_speed: 7.5}}\n");
    let notes = assert_rotor(&unsaid, 3, [5.0, 7.5]);
    notes[0].says("no number_of_blades: 3 is assumed");
    for none in ["{}", "{min_rotor_speed: 5}", "{rated_rotor_speed: 0}"] {
        assert_eq!(rotor_of(&with(none)), (None, Vec::new()), "{none}");
        assert_eq!(read(&with(none)).blades, Some(2), "{none}");
    }
    assert_eq!(rotor_of(VERSION_2).0, None);
    assert_eq!(read(VERSION_2).blades, None);
    let input = read(&unsaid);
    assert_eq!(input.blades, None);
    // Told apart from the others: it matters only where nobody says another number.
    assert_eq!(input.rotor_notes.blades.len(), 1);
    assert_eq!(input.rotor_notes.others.len(), 0);
}

/// 0.8 rad/s is 7.6394 rpm; with 240 m the tips have 96 m/s, and 7.6 rad/s would be 912 m/s.
#[test]
fn speeds_of_version_1_are_in_the_unit_that_the_tips_allow() {
    let with = |diameter: &str, torque: &str| {
        let assembly = format!("number_of_blades: 3, {diameter}");
        let text = VERSION_1.replace("number_of_blades: 3,", &assembly);
        format!("{text}control: {{torque: {torque}}}\n")
    };
    let diameter = "rotor_diameter: 240.0,";
    let factor = 30.0 / std::f64::consts::PI;
    let radians = "{VS_minspd: 0.5, VS_maxspd: 0.8}";
    let notes = assert_rotor(&with(diameter, radians), 3, [0.5 * factor, 0.8 * factor]);
    assert_eq!(notes.len(), 1, "{notes:?}");
    notes[0].says("the rated speed may be lower");
    let turns = "{VS_minspd: 5.0, VS_maxspd: 7.6}";
    let notes = assert_rotor(&with(diameter, turns), 3, [5.0, 7.6]);
    notes[0].says("read in rpm");
    notes[0].says("912 m/s");
    // 150 m/s is at 1.25 rad/s.
    assert_rotor(
        &with(diameter, "{VS_minspd: 1, VS_maxspd: 1.25}"),
        3,
        [factor, 1.25 * factor],
    );
    assert_rotor(
        &with(diameter, "{VS_minspd: 1, VS_maxspd: 1.26}"),
        3,
        [1.0, 1.26],
    );
    let notes = assert_rotor(&with("", radians), 3, [0.5 * factor, 0.8 * factor]);
    notes[0].says("which cannot be checked because rotor_diameter is missing");
    // So do files that say version 2 and have the older keys.
    let newer = format!(
        "{VERSION_2}assembly: {{number_of_blades: 3, rotor_diameter: 240}}\ncontrol: {{torque: {turns}}}\n"
    );
    assert_rotor(&newer, 3, [5.0, 7.6]);
    let (rotor, notes) = rotor_of(&with(diameter, "{VS_maxspd: 0.8}"));
    assert!(rotor.is_none(), "{notes:?}");
    notes[0].says("no VS_minspd");
}

#[test]
fn speeds_that_no_rotor_has_are_refused_where_they_stand() {
    let with = |control: &str| {
        let blades = "assembly: {number_of_blades: 3}\n";
        format!("{VERSION_2}{blades}control: {control}\n")
    };
    let table = r#"
        {min_rotor_speed: 9, rated_rotor_speed: 7.5} | 7.5} | lowest rotor speed, 9 rpm, is above the highest, 7.5 rpm
        {rated_rotor_speed: -7.5} | -7.5 | highest speed
        {rated_rotor_speed: fast} | fast | highest rotor speed
        {min_rotor_speed: {}, rated_rotor_speed: 7} | {}, rated | lowest rotor speed
        "#;
    for [control, needle, message] in rows(table) {
        let text = with(control);
        let (line, column, said) = mistake(&text);
        assert_eq!((line, column), place(&text, needle, 0), "{said}");
        said.says(message);
    }
}

#[test]
fn real_rotors_are_those_of_their_machines() {
    // 7.56 rpm is rated; 0.5236 and 0.7917 rad/s are 5 and 7.56 rpm, 0.6283 and 0.9094 rad/s 6 and
    // 8.684 rpm; the last in rpm, against the schema.
    let table = r#"
        windio/v2/IEA-15-240-RWT.yaml | 5.00001169 | 7.55998712
        windio/v1/IEA-15-240-RWT.yaml | 5.0 | 7.56
        openfast/iea10/IEA-10-198-RWT.yaml | 6.0 | 8.684
        openfast/nrel5mw_land/nrel5mw.yaml | 6.9 | 12.1
    "#;
    for [path, lowest_rpm, highest_rpm] in rows(table) {
        let Some(input) = real_part(path, TowerPart::All) else {
            return;
        };
        let rotor = input.description.rotor.expect(path);
        assert_eq!(rotor.blades, 3);
        near(rotor.lowest_rpm, number(lowest_rpm), 1e-5);
        near(rotor.highest_rpm, number(highest_rpm), 1e-4);
    }
}

/// A real file, if the environment says where they are.
fn real(path: &str) -> Option<Source> {
    let Some(folder) = std::env::var_os("TOWERMODES_PEER_DATA") else {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
        return None;
    };
    let path = std::path::Path::new(&folder).join(path);
    Some(Source::from_path(&path).expect("a file of TOWERMODES_PEER_DATA"))
}

fn real_part(path: &str, part: TowerPart) -> Option<TowerInput> {
    let options = with!(ReadOptions, part);
    real(path).map(|source| read_windio(source, &options).expect("a tower"))
}

#[test]
fn the_15_mw_tower_has_the_mass_and_frequencies_of_openfast() {
    let files = [
        "windio/v1/IEA-15-240-RWT.yaml",
        "windio/v2/IEA-15-240-RWT.yaml",
        "openfast/iea15_monopile/IEA-15-240-RWT.yaml",
    ];
    let mut masses = Vec::new();
    for path in files {
        let Some(mut input) = real_part(path, TowerPart::Tower) else {
            return;
        };
        input.description.rna = Rna::default();
        let tower = input.tower().expect("a tower");
        // Trapezoids of the rows of OpenFAST's tower file of this turbine over 129.386 m.
        near(tower.mass_kg(), 853_463.237, 5e-3);
        masses.push(tower.mass_kg());
        let solution = solve(&tower, &Options::default()).expect("modes");
        let fore_aft = |mode: &&towermodes::Mode| mode.label().ends_with("fore-aft bending");
        let bending = |n: usize| {
            let mut modes = solution.modes.iter().filter(fore_aft);
            modes.nth(n).map_or(f64::NAN, |mode| mode.frequency_hz)
        };
        // 400 cubic beam elements with rotary inertia on the rows of that file, clamped and without
        // assembly.
        near(bending(0), 0.77357, 5e-3);
        near(bending(1), 3.23338, 5e-3);
    }
    // Conical walls of eleven stations, integrated by hand.
    near(masses[0], 853_610.124, 1e-9);
    assert_eq!(masses[0], masses[1]);
    // With the steps of 1 mm it is the table of OpenFAST.
    near(masses[2], 853_463.237, 1e-9);
}

#[test]
fn the_15_mw_assembly_is_that_of_its_parts() {
    let path = "windio/v2/IEA-15-240-RWT.yaml";
    let Some(input) = real_part(path, TowerPart::Tower) else {
        return;
    };
    // Drive train, yaw, hub and three blades put together by another program, the blades in 20000
    // points.
    let rna = &input.description.rna;
    near(rna.mass_kg, 947_543.209, 1e-8);
    near(rna.center_m[0], -7.395_873_897, 1e-8);
    near(rna.center_m[1], -0.099_602_044, 1e-7);
    near(rna.center_m[2], 4.606_854_131, 1e-8);
    near(rna.inertia_kg_m2.xx, 346_828_640.79, 1e-8);
    near(rna.inertia_kg_m2.yy, 197_363_299.73, 1e-8);
    near(rna.inertia_kg_m2.zz, 198_099_433.01, 1e-8);
    near(rna.inertia_kg_m2.xz, -11_882_357.143, 1e-8);
    let whole = real_part(path, TowerPart::All).expect("set");
    // The example's elastic mass of the monopile is that of no steel.
    assert!(has_note(&whole, "of the monopile disagree"));
}

#[test]
fn other_real_files_are_read() {
    // The first begins at the tip of its monopile, in the soil of the file.
    let table = r#"
        openfast/iea10/IEA-10-198-RWT.yaml | -72.6 | 115.63
        openfast/nrel5mw_land/nrel5mw.yaml | 0.0 | 87.6974416
        openfast/nrel5mw_land/nrel5mw_tower.yaml | 0.0 | 87.6974416
        openfast/nrel5mw_oc3hywind/nrel5mw-spar_oc3.yaml | 10.0 | 87.6
        openfast/nrel5mw_oc3monopile/nrel5mw_monopile.yaml | -55.0 | 10.0
        windio/v1/IEA-15-240-RWT.yaml | -75.0 | 144.386
        windio/v2/IEA-15-240-RWT.yaml | -75.0 | 144.386
    "#;
    for [path, base_m, top_m] in rows(table) {
        let is_monopile = path.ends_with("monopile.yaml");
        let part = if is_monopile {
            TowerPart::Monopile
        } else {
            TowerPart::All
        };
        let Some(input) = real_part(path, part) else {
            return;
        };
        let tower = input.tower().expect("a tower");
        let expected = (number(base_m), number(top_m));
        assert_eq!((tower.base_m(), tower.top_m()), expected, "{path}");
    }
    // Its tower begins 10 m below the top of its monopile.
    let path = "openfast/nrel5mw_oc3monopile/nrel5mw_monopile.yaml";
    let source = real(path).expect("set");
    let error = read_windio(source, &ReadOptions::default()).expect_err("an overlap");
    error.says("10 m below the top of the monopile");
}

//! The digits of an independent program with the same dimensions.

use std::f64::consts::PI;
use std::path::PathBuf;

use towermodes::mooring::{Mooring, Pose};
use towermodes::{FloatingPlatform, Foundation, Options, solve};
use towermodes_files::{ReadOptions, Source, TowerInput, read_windio};
use towermodes_testing::Says;

use super::texts::volturnus;

fn read_as(text: String, whole_members: bool) -> TowerInput {
    let name = "floater.yaml".to_owned();
    let options = ReadOptions {
        whole_members,
        ..ReadOptions::default()
    };
    let input = read_windio(Source { name, text }, &options);
    input.unwrap_or_else(|error| panic!("{error}"))
}

fn read(text: String) -> TowerInput {
    read_as(text, false)
}

fn platform(input: &TowerInput) -> &FloatingPlatform {
    match &input.description.foundation {
        Foundation::Floating(platform) => platform,
        other => panic!("it does not float: {other:?}"),
    }
}

/// Tower and rotor-nacelle assembly of the reference, kg, less the mast of these texts.
fn top_kg() -> f64 {
    2414442.159 - 7800.0 * PI * 9.95 * 0.05 * 10.0
}

#[track_caller]
fn assert_close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found / expected - 1.0).abs();
    assert!(
        error <= tolerance,
        "{what}: {found}, expected {expected}: {error:e}"
    );
}

/// Mass (kg), centre (m) and M55 about the origin; A11, A33, A44, A66, A15; C33, C44, C55.
type Digits = (bool, [f64; 3], [f64; 5], [f64; 3]);

const DIGITS: [Digits; 2] = [
    (
        false,
        [15115840.884, -14.350_947_862_0, 15740972658.0],
        [
            13678314.729,
            9042125.5783,
            5952259385.2,
            27212700134.0,
            -166170000.0,
        ],
        [4491631.9644, 2636109626.5, 2636109394.9],
    ),
    (
        true,
        [17627542.433, -14.629_676_482_9, 18086018798.0],
        [
            14934165.567,
            11553827.128,
            7950710487.7,
            30525791459.0,
            -186891600.0,
        ],
        [4491631.9644, 2229553055.2, 2229552823.6],
    ),
];

#[test]
fn volturnus_has_mass_water_and_ballast_of_an_independent_program() {
    for (whole_members, [mass, z, about_origin], a, c) in DIGITS {
        let input = read_as(volturnus(top_kg()), whole_members);
        let platform = platform(&input);
        let [x, _, height] = platform.center_m;
        assert_close("mass", platform.mass_kg, mass, 1e-10);
        assert_close("centre", height, z, 1e-10);
        let arm = x * x + height * height;
        let inertia = platform.inertia_kg_m2.yy + platform.mass_kg * arm;
        assert_close("M55", inertia, about_origin, 1e-9);
        let added = platform.added_mass.matrix;
        let hydrostatic = platform.hydrostatic.matrix;
        for (what, found, expected, tolerance) in [
            ("A11", added[0][0], a[0], 1e-10),
            ("A33", added[2][2], a[1], 1e-10),
            ("A44", added[3][3], a[2], 1e-9),
            ("A66", added[5][5], a[3], 1e-10),
            ("A15", added[0][4], a[4], 1e-6),
            ("C33", hydrostatic[2][2], c[0], 1e-10),
            ("C44", hydrostatic[3][3], c[1], 1e-10),
            ("C55", hydrostatic[4][4], c[2], 1e-10),
        ] {
            assert_close(what, found, expected, tolerance);
        }
    }
}

#[test]
fn volturnus_has_the_mooring_of_an_independent_program() {
    let input = read(volturnus(top_kg()));
    let lines = platform(&input).mooring_lines.as_ref().expect("lines");
    let mooring = Mooring::new(lines.description.clone()).expect("a mooring");
    let load = mooring.at(&Pose::default()).expect("a state").load;
    for (i, j, expected) in [
        (0, 0, 93906.328563),
        (2, 2, 65969.826107),
        (3, 3, 264195351.84),
        (5, 5, 277781130.85),
        (0, 4, 997909.29867),
    ] {
        assert_close("K", load.stiffness[i][j], expected, 1e-8);
    }
    assert_close("Fz", load.force[2], -6563814.5615, 1e-9);
    let notes: Vec<&str> = input
        .notes
        .iter()
        .map(|note| note.message.as_str())
        .collect();
    let chain = notes
        .iter()
        .find(|note| note.contains("chain"))
        .expect("a note");
    chain.says("681.077 kg/m");
}

#[test]
fn an_unballasted_platform_is_said_to_be_out_of_balance() {
    let heavy = read(volturnus(2e8));
    let note = heavy
        .notes
        .iter()
        .find(|note| note.message.contains("out of balance"));
    note.expect("a note").message.says("undisplaced position");
}

#[test]
fn a_public_spar_has_the_volume_and_mass_of_an_independent_program() {
    let Some(folder) = std::env::var_os("TOWERMODES_PEER_DATA") else {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
        return;
    };
    let path = PathBuf::from(folder).join("openfast/nrel5mw_oc3hywind/nrel5mw-spar_oc3.yaml");
    let source = Source::from_path(&path).expect("the file is there");
    let input = read_windio(source, &ReadOptions::default()).unwrap_or_else(|e| panic!("{e}"));
    let platform = platform(&input);
    let hydrostatic = platform.hydrostatic.matrix;
    let weight_of_water = 1025.0 * input.description.gravity_m_per_s2;
    // The reference has eight digits.
    assert_close("A_w", hydrostatic[2][2], weight_of_water * 33.183072, 3e-8);
    // ρ g V z_b and the water plane.
    let moment = -8030.447124 * 62.066433 + 33.183072 * 3.25 * 3.25 / 4.0;
    assert_close("C44", hydrostatic[3][3], weight_of_water * moment, 1e-7);
    let volume = input
        .notes
        .iter()
        .find(|note| note.message.contains("m3 cut"));
    volume.expect("a note").message.says("8030.4 m3 cut");
    let tower = input.tower().unwrap_or_else(|error| panic!("{error}"));
    let solution = solve(&tower, &Options::default()).unwrap_or_else(|e| panic!("{e}"));
    assert!(solution.certificate.complete);
}

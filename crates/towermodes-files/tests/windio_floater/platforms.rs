//! The digits of an independent program with the same dimensions.

use std::f64::consts::PI;
use std::path::PathBuf;

use towermodes::mooring::{Mooring, Pose};
use towermodes::{FloatingPlatform, Foundation, Options, solve};
use towermodes_files::{MemberEnds, ReadOptions, Source, TowerInput, read_windio};
use towermodes_testing::Says;

use super::texts::volturnus;

fn read_as(text: String, member_ends: MemberEnds) -> TowerInput {
    let name = "floater.yaml".to_owned();
    let options = ReadOptions {
        member_ends,
        ..ReadOptions::default()
    };
    let input = read_windio(Source { name, text }, &options);
    input.unwrap_or_else(|error| panic!("{error}"))
}

fn read(text: String) -> TowerInput {
    read_as(text, MemberEnds::Balance)
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
type Digits = (MemberEnds, [f64; 3], [f64; 5], [f64; 3]);

const DIGITS: [Digits; 2] = [
    (
        MemberEnds::Cut,
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
        MemberEnds::Whole,
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
    for (member_ends, [mass, z, about_origin], a, c) in DIGITS {
        let input = read_as(volturnus(top_kg()), member_ends);
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
    let message = &note.expect("a note").message;
    message.says("undisplaced position");
    message.says("t less than the turbine without variable ballast, of which there are at most ");
}

/// The notes with these words.
fn notes<'n>(input: &'n TowerInput, words: &str) -> Vec<&'n str> {
    let messages = input.notes.iter().map(|note| note.message.as_str());
    messages.filter(|message| message.contains(words)).collect()
}

/// The texts that are used in several places are noted in one sentence.
#[test]
fn members_without_a_coefficient_of_added_mass_have_one_note() {
    let words = "no coefficient of added mass";
    let text = volturnus(top_kg());
    assert!(notes(&read(text.clone()), words).is_empty());
    let one = read(text.replacen("              Ca: 1.0\n", "", 1));
    let [note] = notes(&one, words)[..] else {
        panic!("one note");
    };
    assert_eq!(
        note,
        "member `main_column` has no coefficient of added mass: Ca = 1 is assumed"
    );
    let most = read(text.replace("              Ca: 1.0\n", ""));
    let [note] = notes(&most, words)[..] else {
        panic!("one note");
    };
    note.says("7 members (`main_column` to `upper3`) have no");
    // Tower and platform are of the same steel.
    let steel = text.replace(
        "E: 200.e+009, nu: 0.3, G: 79.3e+009",
        "E: 200.e+9, nu: 0.3, G: 70.e+9",
    );
    assert_eq!(notes(&read(steel), "G of material").len(), 1);
}

/// The angle between stiffeners, rad, with the digits of a file.
#[expect(clippy::approx_constant)]
const SPACING: f64 = 0.523599;

/// The platform with longitudinal stiffeners in its middle column.
fn stiffened(spacing: f64, version: u8) -> TowerInput {
    let stiffeners = format!(
        "                longitudinal_stiffeners: {{material: steel, web_height: 0.2, web_thickness: 0.1, flange_width: 0.2, flange_thickness: 0.1, spacing: {spacing}}}\n"
    );
    let before = "                bulkhead: {material: steel, thickness: {grid: [0.0, 1.0]";
    let mut text = volturnus(top_kg()).replacen(before, &(stiffeners + before), 1);
    if version == 2 {
        text = text.replace(
            "name: VolturnUS-S\n",
            "windIO_version: '2.0'\nname: VolturnUS-S\n",
        );
        for (old, new) in [
            (
                "outer_shape_bem:\n            reference_axis",
                "reference_axis",
            ),
            (
                "            outer_diameter: {grid: [0, 1], values: [10.0, 10.0]}\n        internal_structure_2d_fem",
                "        outer_shape: {outer_diameter: {grid: [0, 1], values: [10.0, 10.0]}}\n        structure",
            ),
            ("3.14159265", "180.0"),
            ("1.0471976", "60.0"),
            ("1.0471975", "60.0"),
        ] {
            assert!(text.contains(old), "{old}");
            text = text.replace(old, new);
        }
    }
    read(text)
}

/// Twelve stiffeners of 0.04 m2 on 35 m.
#[test]
fn stiffeners_that_overlap_have_their_angle_in_the_other_unit() {
    let words = "longitudinal stiffeners";
    let without = platform(&read(volturnus(top_kg()))).mass_kg;
    let in_rad = stiffened(SPACING, 1);
    assert!(notes(&in_rad, words).is_empty());
    // Ballast balances the platform: its mass stays.
    assert_close("mass", platform(&in_rad).mass_kg, without, 1e-12);
    let ballast = |input: &TowerInput| {
        let note = notes(input, "the variable ballast is")[0].to_owned();
        let words: Vec<&str> = note.split(' ').collect();
        words[4].parse::<f64>().expect("tonnes")
    };
    let steel_t = 12.0 * 0.04 * 35.0 * 7.8;
    let less_t = ballast(&read(volturnus(top_kg()))) - ballast(&in_rad);
    assert!((less_t - steel_t).abs() < 0.2, "{less_t} t, {steel_t} t");
    for (spacing, version) in [(SPACING.to_degrees(), 1), (SPACING, 2)] {
        let input = stiffened(spacing, version);
        let said = notes(&input, words);
        assert_eq!(said.len(), 1, "{said:?}");
        said[0].says(&format!("in windIO {version} the spacing is in"));
        assert!(
            (ballast(&input) - ballast(&in_rad)).abs() < 0.2,
            "{version}"
        );
    }
    assert!(notes(&stiffened(SPACING.to_degrees(), 2), words).is_empty());
}

/// Walls and bulkheads of a member are scaled to the mass that the user gives, fixed ballast too.
#[test]
fn a_member_may_have_its_mass_from_the_user() {
    let of = |given: &str| {
        let text = volturnus(2e8);
        let member = "            - name: column2\n";
        read(text.replace(
            member,
            &format!("{member}              member_mass_user: {given}\n"),
        ))
    };
    let words = "member_mass_user";
    let [light, heavy] = [of("900000.0"), of("1.9e6")];
    // The platform is out of balance, so that no ballast water follows its mass.
    let [a, b] = [&light, &heavy].map(platform);
    assert_close("mass", b.mass_kg - a.mass_kg, 1e6, 1e-9);
    // The column stands at y = -44.8 m.
    let y_m = |p: &FloatingPlatform| p.center_m[1] * p.mass_kg;
    let expected = -51.75 * std::f64::consts::FRAC_PI_3.sin() * 1e6;
    let moved = y_m(b) - y_m(a);
    assert!(
        (moved.abs() / expected.abs() - 1.0).abs() < 1e-6,
        "{moved} {expected}"
    );
    notes(&light, words)[0].says("member `column2` has member_mass_user = 900000 kg");
    assert!(notes(&of("0.0"), words).is_empty());
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
        .find(|note| note.message.contains("m3 if they are cut"));
    volume
        .expect("a note")
        .message
        .says("8030.4 m3 if they are cut");
    let tower = input.tower().unwrap_or_else(|error| panic!("{error}"));
    let solution = solve(&tower, &Options::default()).unwrap_or_else(|e| panic!("{e}"));
    assert!(solution.certificate.complete);
}

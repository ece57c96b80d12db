//! Frequencies of substructures as an independent program computes them from the same files: nodal
//! finite elements with dense matrices, and the exact Timoshenko beam.
//!
//! `crates/towermodes/tests/frame.rs` has the same structures without files.

use towermodes::frame::{FrameOptions, FrameSolveError, count_frame_modes, solve_frame};
use towermodes_files::{Interface, SubdynInput};
use towermodes_testing::numbers;

use super::texts::input;

/// The printed digits of the independent program.
const DIGITS: f64 = 3e-10;

pub fn solved(input: &SubdynInput, interface: Interface, subdyn: bool, modes: usize) -> Vec<f64> {
    let frame = input
        .frame(interface)
        .unwrap_or_else(|error| panic!("{error}"));
    let recipe = subdyn.then_some(input.recipe());
    let solution = solve_frame(
        &frame,
        &FrameOptions {
            modes,
            recipe,
            ..FrameOptions::default()
        },
    );
    let solution = solution.unwrap_or_else(|error| panic!("{error}"));
    solution
        .modes
        .iter()
        .map(|mode| mode.frequency_hz)
        .collect()
}

fn assert_hz(what: &str, found: &[f64], expected: &[f64]) {
    for (found, expected) in found.iter().zip(expected) {
        let error = (found / expected - 1.0).abs();
        assert!(
            error < DIGITS,
            "{what}: {found} Hz, expected {expected} Hz: {error:e}"
        );
    }
}

/// Mass (kg); frequencies of SubDyn's element and of the exact beam with the interface free, and of
/// the exact beam with the interface held.
fn check<const N: usize, const M: usize>(
    changes: &[(&str, &str)],
    mass_kg: f64,
    [subdyn, exact]: [&str; 2],
    held: &str,
) {
    let input = input(changes);
    let found = input.frame(Interface::Free).expect("a frame").mass_kg();
    assert!((found - mass_kg).abs() < 1e-6, "{found} kg");
    assert_hz(
        "subdyn",
        &solved(&input, Interface::Free, true, N),
        &numbers::<N>(subdyn),
    );
    assert_hz(
        "exact",
        &solved(&input, Interface::Free, false, N),
        &numbers::<N>(exact),
    );
    assert_hz(
        "held",
        &solved(&input, Interface::Held, false, M),
        &numbers::<M>(held),
    );
}

/// The same for mechanisms: the modes without stiffness, which have 0 Hz and a warning, and counts
/// beside the frequencies.
fn check_mechanism<const N: usize>(changes: &[(&str, &str)], still: usize, subdyn: &str) {
    let input = input(changes);
    let frame = input.frame(Interface::Free).expect("a frame");
    let options = FrameOptions {
        modes: still + N,
        recipe: Some(input.recipe()),
        ..FrameOptions::default()
    };
    let solution = solve_frame(&frame, &options).expect("modes");
    let warning = solution.mechanism.expect("a mechanism").to_string();
    assert!(warning.contains("joint 2"), "{warning}");
    let modes_hz: Vec<f64> = solution
        .modes
        .iter()
        .map(|mode| mode.frequency_hz)
        .collect();
    assert_eq!(modes_hz[..still], vec![0.0; still]);
    let count = |hz: f64| count_frame_modes(&frame, input.recipe(), hz).expect("a count");
    assert_eq!(count(0.01), still);
    for (below, hz) in (still..).zip(numbers::<N>(subdyn)) {
        let listed = modes_hz.iter().any(|own| (own / hz - 1.0).abs() < 1e-8);
        assert!(listed, "{hz}: {modes_hz:?}");
        // Modes without stiffness cost the independent program two digits.
        let near = 1e-8 * hz;
        let (before, after) = (count(hz - near), count(hz + near));
        assert!(
            before <= below && after > below,
            "{hz}: {before}, {below}, {after}"
        );
    }
}

const ONE_TUBE: [(&str, &str); 3] = [
    ("NJoints", "1 0 0 -20 1 0 0 0 0\n2 0 0 0 1 0 0 0 0"),
    ("NInterf", "2 1 1 1 1 1 1 1"),
    ("NMembers", "1 1 2 1 1 1c 0"),
];

fn on_soil(flags: &'static str) -> Vec<(&'static str, &'static str)> {
    [&ONE_TUBE[..], &[("NReact", flags)]].concat()
}

#[test]
fn soil_acts_on_the_motions_whose_flags_are_0() {
    check::<5, 4>(
        &on_soil("1 0 0 0 0 0 0 \"ssi.txt\""),
        33149.895755,
        [
            "1.3918582502 1.4394188667 10.654205749 11.0076187899 13.9015389621",
            "1.3918473771 1.4394072265 10.6489535376 11.0016783227 13.8977693564",
        ],
        "11.0354006883 11.383731541 27.33713141 27.4080314754",
    );
    check::<4, 2>(
        &on_soil("1 1 1 1 0 0 1 \"ssi.txt\""),
        33149.895755,
        [
            "2.5128594311 2.5483435727 22.3695003947 22.411041046",
            "2.5128244018 2.5483070546 22.3508201602 22.3922658448",
        ],
        "21.758561502 21.8033866676",
    );
    check::<5, 2>(
        &on_soil("1 1 1 1 1 1 1 \"ssi.txt\""),
        29149.895755,
        [
            "4.955014654 4.955014654 28.3729846735 28.3729846735 40.3615271641",
            "4.9547585555 4.9547585555 28.3385702386 28.3385702386 40.1033696187",
        ],
        "27.863232002 27.863232002",
    );
}

#[test]
fn pins_universal_and_ball_joints_are_those_of_the_table() {
    let with = |joint: &'static str| {
        let joints = format!("1 0 0 -20 1 0 0 0 0\n{joint}\n3 0 0 0 1 0 0 0 0");
        [("NJoints", &*joints.leak())]
    };
    check::<4, 2>(
        &with("2 0 0 -10 3 1 2 0 2d8"),
        29149.895755,
        [
            "2.7236804441 4.954463669 15.0109611703 28.2876253572",
            "2.7237300737 4.9547585555 15.0191320804 28.3385702385",
        ],
        "19.8764036863 27.8632320019",
    );
    // Torsion of eight linear elements: ω² = 6 (c/h)² (1 − cos θ)/(2 + cos θ), θ = π/16.
    check_mechanism::<3>(
        &with("2 0 0 -10 3 0 1 0 0"),
        1,
        "4.954463669 13.3139980726 28.2876253339",
    );
    check_mechanism::<3>(
        &with("2 0 0 -10 2 0 0 0 0"),
        2,
        "13.3139980742 13.3139980742 40.1678215776",
    );
    check_mechanism::<3>(
        &with("2 0 0 -10 4 0 0 0 0"),
        3,
        "13.3139980706 13.3139980706 64.7563331502",
    );
}

#[test]
fn joint_stiffness_acts_between_members_at_angles() {
    let bent = |joint: &'static str| {
        let joints = format!("1 -5 0 -20 1 0 0 0 0\n{joint}\n3 0 0 0 1 0 0 0 0");
        [("NJoints", &*joints.leak())]
    };
    check::<4, 3>(
        &bent("2 0 1 -10 2 0 0 0 2e8"),
        31007.979751,
        [
            "2.8524548805 2.8898192712 10.215500353 11.7842334168",
            "2.8525120256 2.8898787324 10.2186162266 11.7880714903",
        ],
        "17.33993902 36.9058031649 60.3308012724",
    );
    let three = [
        (
            "NJoints",
            "1 -5 0 -20 1 0 0 0 0\n2 0 1 -10 4 0 0 0 1e8\n3 0 0 0 1 0 0 0 0\n4 4 3 -20 1 0 0 0 0",
        ),
        ("NReact", "1 1 1 1 1 1 1\n4"),
        ("NMembers", "1 1 2 1 1 1c 0\n2 2 3 1 1 1c 0\n3 4 2 1 1 1c 0"),
    ];
    check::<4, 3>(
        &three,
        46974.035205,
        [
            "2.8588219443 3.0971522822 13.9175515653 17.8972034698",
            "2.8588794412 3.09722389 13.9236576179 17.891423308",
        ],
        "17.4053988798 44.2246330136 57.0510906945",
    );
}

/// A mast with four stays; the first table has the properties of the stays.
fn mast(cables: &'static str) -> [(&'static str, &'static str); 6] {
    [
        ("NCablePropSets", cables),
        (
            "NJoints",
            "1 0 0 -20 1 0 0 0 0\n2 0 0 -5 1 0 0 0 0\n3 0 0 0 1 0 0 0 0\n4 10 0 -20 1 0 0 0 0\n5 -10 0 -20 1 0 0 0 0\n6 0 12 -20 1 0 0 0 0\n7 0 -12 -20 1 0 0 0 0",
        ),
        ("NReact", "1\n4\n5\n6\n7"),
        (
            "NMembers",
            "1 1 2 1 1 1c 0\n2 2 3 1 1 1c 0\n3 4 2 1 1 2 -1\n4 5 2 1 1 2 -1\n5 6 2 1 1 2 -1\n6 7 2 1 1 2 -1",
        ),
        ("NPropSetsCyl", "1 2.1e11 8.08e10 7850 0.8 0.02"),
        ("NInterf", "3"),
    ]
}

#[test]
fn cables_have_the_stiffness_of_their_pretension() {
    check::<4, 2>(
        &mast("1 1e8 20 2e6 0"),
        9154.668299,
        [
            "4.7605144034 5.0813848976 12.2897899103 12.2963761635",
            "4.7603075505 5.0811309987 12.283452664 12.2899814577",
        ],
        "12.4460236124 12.5081536582",
    );
    // SubDyn 5.0 leaves it out: cables without pretension, whose axial stiffness is EA/L0 and whose
    // mass is that of L0 with T0 = 0.02 EA.
    check::<4, 2>(
        &mast("1 1.02e8 19.607843137254902 0 0"),
        9154.668299,
        [
            "4.5716376138 4.9126794463 12.2863342372 12.2928949974",
            "4.5714559335 4.912450871 12.280027084 12.2865305583",
        ],
        "12.411920126 12.4758002241",
    );
}

#[test]
fn rigid_links_and_springs_connect_their_joints() {
    let joints = "1 0 0 -20 1 0 0 0 0\n2 0 0 -8 1 0 0 0 0\n3 0 0 0 1 0 0 0 0";
    let with_arm = "1 0 0 -20 1 0 0 0 0\n2 0 0 -8 1 0 0 0 0\n3 0 0 0 1 0 0 0 0\n4 3 1 -7 1 0 0 0 0";
    let hz = [
        "4.2559198576 4.302602092 16.3224136144 24.2095910807",
        "4.2561714876 4.3028685453 16.3231822877 24.2405151366",
    ];
    let held = "19.3822694935 22.3953585123";
    let arm = [
        ("NJoints", with_arm),
        ("NMembers", "1 1 2 1 1 1c 0\n2 2 3 1 1 1c 0\n3 2 4 7 7 3 -1"),
        ("NRigidPropSets", "7 0.0"),
        ("NCmass", "4 8e3 1e4 2e4 3e4 0 0 0 0 0 0"),
    ];
    check::<4, 2>(&arm, 37149.895755, hz, held);
    let offset = [
        ("NJoints", joints),
        ("NCmass", "2 8e3 1e4 2e4 3e4 0 0 0 3 1 1"),
    ];
    check::<4, 2>(&offset, 37149.895755, hz, held);
    let heavy = [
        (
            "NJoints",
            "1 0 0 -20 1 0 0 0 0\n2 0 0 -8 1 0 0 0 0\n3 0 0 0 1 0 0 0 0\n4 3 1 -7 1 0 0 0 0\n5 3 5 -7 1 0 0 0 0",
        ),
        (
            "NMembers",
            "1 1 2 1 1 1c 0\n2 2 3 1 1 1c 0\n3 2 4 1 1 3 -1\n4 4 5 1 1 3 -1",
        ),
        ("NRigidPropSets", "1 500"),
    ];
    check::<4, 2>(
        &heavy,
        32808.208150,
        [
            "4.6126202921 4.647252119 21.7185463549 26.1194051916",
            "4.6129349743 4.647579028 21.7227259498 26.1575972592",
        ],
        "24.0374575119 24.9117819032",
    );
    let spring = [
        (
            "NJoints",
            "1 0 0 -20 1 0 0 0 0\n2 0 0 -10 1 0 0 0 0\n3 0 0 -9 1 0 0 0 0\n4 0 0 0 1 0 0 0 0",
        ),
        ("NInterf", "4 1"),
        ("NMembers", "1 1 2 1 1 1c 0\n2 3 4 1 1 1c 0\n3 2 3 1 1 5 -1"),
        (
            "NSpringPropSets",
            "1 3e7 0 0 0 1e7 0 4e7 0 0 0 0 5e7 0 0 0 2e8 0 0 1e8 0 3e8",
        ),
    ];
    check::<4, 2>(
        &spring,
        27692.400967,
        [
            "2.395018396 2.9885324791 9.7451728485 11.5259083154",
            "2.3950537243 2.988593752 9.7448847613 11.5271945025",
        ],
        "21.1793026433 21.5919283065",
    );
}

/// A rectangle that lies on its side is the rectangle with the sides exchanged; a cosine matrix
/// says the same as a spin.
#[test]
fn sections_turn_with_the_spin() {
    let members = |spin: &'static str| format!("1 1 2 1 1 1r {spin}\n2 2 3 1 1 1r {spin}");
    let solve = |members: &str, table: &str, rows: &str, text: &dyn Fn(String) -> String| {
        let changes = [
            ("NMembers", members),
            (table, rows),
            ("NCOSMs", "7 0 1 0 -1 0 0 0 0 1"),
        ];
        let text = text(super::texts::deck(&changes));
        let input = super::texts::read(&text).unwrap_or_else(|error| panic!("{error}"));
        solved(&input, Interface::Free, false, 5)
    };
    let as_is = |text: String| text;
    let rec = "NPropSetsRec";
    let upright = solve(
        &members("0"),
        rec,
        "1 2.1e11 8.08e10 7850 2.0 1.2 0.03",
        &as_is,
    );
    let lying = solve(
        &members("90"),
        rec,
        "1 2.1e11 8.08e10 7850 1.2 2.0 0.03",
        &as_is,
    );
    assert_hz("lying", &upright, &lying);
    assert!(upright[1] / upright[0] > 1.3, "{upright:?}");
    // The same numbers by the table of arbitrary sections.
    let input = input(&[
        ("NMembers", &members("0")),
        (rec, "1 2.1e11 8.08e10 7850 2.0 1.2 0.0"),
    ]);
    let solid = solved(&input, Interface::Free, false, 5);
    let nu: f64 = 2.1 / (2.0 * 0.808) - 1.0;
    let shear = 2.4 * 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
    let (about_x, about_y) = (2.0 * 1.2_f64.powi(3) / 12.0, 1.2 * 2.0_f64.powi(3) / 12.0);
    let ratio: f64 = 1.2 / 2.0;
    let torsion = 0.6_f64.powi(3) * (16.0 / 3.0 - 3.36 * ratio * (1.0 - ratio.powi(4) / 12.0));
    let polar = about_x + about_y;
    let row =
        format!("1 2.1e11 8.08e10 7850 2.4 {shear} {shear} {about_x} {about_y} {polar} {torsion}");
    let given =
        |members: &str, text: &dyn Fn(String) -> String| solve(members, "NXPropSets", &row, text);
    assert_hz(
        "given",
        &given("1 1 2 1 1 4 0\n2 2 3 1 1 4 0", &as_is),
        &solid,
    );
    // Before OpenFAST 4.1 the last column is the number of a cosine matrix.
    let older = |text: String| text.replace("MSpin/COSMID", "COSMID");
    assert_hz(
        "turned",
        &given("1 1 2 1 1 4 7\n2 2 3 1 1 4 7", &older),
        &solid,
    );
}

#[test]
fn euler_bernoulli_members_do_not_shear() {
    let text = super::texts::deck(&[]).replace("3 FEMMod", "1 FEMMod");
    let input = super::texts::read(&text).expect("a substructure");
    let exact = solved(&input, Interface::Free, false, 1)[0];
    // The cantilever: 1.8751² √(EI/m)/(2π L²), less what rotary inertia takes off (here below 1 %).
    let tube = towermodes::tower::Tube {
        outer_diameter_m: 2.0,
        wall_thickness_m: 0.03,
    };
    let bending = 2.1e11 * tube.second_moment_of_area_m4();
    let mass = 7850.0 * tube.area_m2();
    let slender =
        1.8751040687_f64.powi(2) * (bending / mass).sqrt() / (std::f64::consts::TAU * 400.0);
    assert!(
        exact < slender && exact > 0.99 * slender,
        "{exact} Hz, {slender} Hz"
    );
    let shearing = solved(&super::texts::input(&[]), Interface::Free, false, 1)[0];
    assert!(exact > shearing);
    let subdyn = solved(&input, Interface::Free, true, 1)[0];
    assert!((subdyn / exact - 1.0).abs() < 1e-3);
}

/// A spring that carries a joint without mass adds no finite mode and changes none.
#[test]
fn a_joint_without_mass_has_no_modes_of_its_own() {
    let changes = [
        ("NMembers", "1 1 2 1 1 1c 0\n2 2 3 1 1 5 0"),
        (
            "NSpringPropSets",
            "1 1e8 0 0 0 0 0 1e8 0 0 0 0 1e8 0 0 0 1e9 0 0 1e9 0 1e9",
        ),
    ];
    // One element, as in SubDyn, so that no inner node has modes.
    let read = |changes: &[(&str, &str)]| {
        let text = super::texts::deck(changes).replace("4 NDiv", "1 NDiv");
        super::texts::read(&text).unwrap_or_else(|error| panic!("{error}"))
    };
    let alone = read(&[
        ("NJoints", "1 0 0 -20 1 0 0 0 0\n2 0 0 -10 1 0 0 0 0"),
        ("NInterf", "2 1 1 1 1 1 1 1"),
        ("NMembers", "1 1 2 1 1 1c 0"),
    ]);
    let sprung = read(&changes);
    let expected = solved(&alone, Interface::Free, true, 6);
    assert_hz(
        "sprung",
        &solved(&sprung, Interface::Free, true, 6),
        &expected,
    );
    let frame = sprung.frame(Interface::Free).expect("a frame");
    let options = FrameOptions {
        modes: 8,
        recipe: Some(sprung.recipe()),
        ..FrameOptions::default()
    };
    let expected = FrameSolveError::Unresolved {
        modes: 8,
        resolved: 6,
    };
    assert_eq!(solve_frame(&frame, &options), Err(expected));
}

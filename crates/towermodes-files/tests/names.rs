//! Names of coupled modes with their shares, against an independent code (Ritz, all six motions).

use std::path::{Path, PathBuf};

use towermodes::{Change, Options, Solver, Tower, solve};
use towermodes_files::read_tower;
use towermodes_testing::{number, rows, with};

fn example(name: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    root.join("../../examples").join(name)
}

fn input(name: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    root.join("tests/names").join(name)
}

/// Solves the tower of a file with changed numbers and compares names, frequencies to four
/// decimals, and shares in whole percent: "SS1 0.3195 100, FA1 0.3215 100".
#[track_caller]
fn assert_named(file: &Path, changes: &[(&str, f64)], expected: &str) {
    let mut description = read_tower(file).expect("a file").input.description;
    for (name, value) in changes {
        let change = Change::parse(name, &description).expect("a number");
        change.apply(&mut description, *value);
    }
    let tower = Tower::new(description).expect("a tower");
    let expected: Vec<&str> = expected.split(", ").collect();
    let options = with!(Options, modes = expected.len());
    let solution = solve(&tower, &options).expect("modes");
    let mut solver = Solver::new(options.clone());
    let quick = solver.frequencies(&tower).expect("modes");
    for ((mode, quick), expected) in solution.modes.iter().zip(&quick.modes).zip(expected) {
        let family = match mode.family.name() {
            "fore-aft" => "FA",
            "side-side" => "SS",
            "torsion" => "T",
            other => other,
        };
        let got = format!("{family}{}", mode.order);
        let [name, hz, percent] = expected.split(' ').collect::<Vec<_>>()[..] else {
            panic!("{expected}");
        };
        let case = format!(
            "{changes:?}: {expected}, got {got} {} Hz",
            mode.extrapolated_hz
        );
        assert_eq!(got, name, "{case}");
        let hz: f64 = hz.parse().expect("a frequency");
        // The code of the reference is exact to about 1e-5.
        let holds = (mode.extrapolated_hz - hz).abs() < 5.1e-5 + 2e-5 * hz;
        assert!(holds, "{case}");
        let percent: f64 = percent.parse().expect("a share");
        // Rounding, and 0.4 where two frequencies meet and one is off by 1e-5: 17 for each 0.1 %.
        let holds = (100.0 * mode.share() - percent).abs() < 1.0;
        assert!(holds, "{case}, {}", mode.share());
        let wanted = (quick.name(), quick.shares);
        assert_eq!(wanted, (mode.name(), mode.shares), "{case}");
    }
}

/// Torsion and side-side bending of the 5 MW tower meet as the inertia about z falls.
#[test]
fn torsion_and_side_side_bending_exchange_names_where_they_meet() {
    let file = example("nrel-5mw.toml");
    let below = "SS1 0.3195 100, FA1 0.3215 100, ";
    for (factor, pair, third_hz) in [
        (0.9, "T1 1.6491 100, SS2 1.9671 100", "4.8073"),
        (0.64, "T1 1.9501 99, SS2 1.9674 99", "4.8074"),
        (0.632, "T1 1.9617 88, SS2 1.9679 88", "4.8074"),
        (0.63, "T1 1.9641 69, SS2 1.9685 69", "4.8074"),
        (0.629, "T1 1.9650 52, SS2 1.9691 52", "4.8075"),
        (0.628, "SS2 1.9657 66, T1 1.9700 66", "4.8075"),
        (0.62, "SS2 1.9668 98, T1 1.9812 98", "4.8075"),
        (0.5, "SS2 1.9671 100, T1 2.2008 100", "4.8076"),
    ] {
        let expected = format!("{below}{pair}, FA2 2.2180 100, SS3 {third_hz} 100, FA3 5.1452 100");
        assert_named(&file, &[("scale(rna.inertia.zz)", factor)], &expected);
    }
}

/// Rotor-nacelle assemblies beside the tower in both directions: no mode has 60 % of its energy in
/// one motion, and changes by 2 % exchange no names.
#[test]
fn modes_of_two_planes_keep_their_names_under_small_changes() {
    let set = |[wall, z, xx]: [f64; 3]| {
        [
            ("stations[1].wall", wall),
            ("rna.center[2]", z),
            ("rna.inertia.xx", xx),
        ]
    };
    let short = input("short-tower.toml");
    for (numbers, expected) in [
        (
            [0.024071125392924445, 1.1196884125314053, 1848472.9865407844],
            "FA1 0.3287 66, SS1 0.3291 66, T1 1.6510 99, FA2 3.0181 59, SS2 3.2201 59, FA3 7.9353 53, SS3 8.6023 57",
        ),
        (
            [0.024431465860452008, 1.0969174994689783, 1904512.160425122],
            "FA1 0.3292 52, SS1 0.3295 52, T1 1.6569 99, FA2 3.0187 55, SS2 3.2164 55, FA3 7.9402 51, SS3 8.5933 55",
        ),
        (
            [0.024208395785174378, 1.106487807307874, 1909891.2271652685],
            "FA1 0.3289 50, SS1 0.3292 51, T1 1.6532 99, FA2 3.0140 55, SS2 3.2117 55, FA3 7.9290 50, SS3 8.5786 55",
        ),
        (
            [0.02491688917410297, 1.0911805412403746, 1888696.44010166],
            "FA1 0.3297 56, SS1 0.3300 56, T1 1.6647 99, FA2 3.0283 56, SS2 3.2263 56, FA3 7.9669 51, SS3 8.6285 56",
        ),
    ] {
        assert_named(&short, &set(numbers), expected);
    }
    let soft = input("soft-tower.toml");
    for (numbers, expected) in [
        (
            [0.12645979796500262, 0.8643335297975279, 13617716750.96068],
            "SS1 0.1281 59, FA1 0.1307 59, T1 0.3086 100, SS2 0.5163 60, FA2 0.5958 60, SS3 2.6565 63, FA3 2.6715 63",
        ),
        (
            [0.12947221705046463, 0.866949215714546, 13416809489.817081],
            "SS1 0.1287 57, FA1 0.1313 57, T1 0.3091 100, SS2 0.5184 58, FA2 0.5981 58, SS3 2.6543 61, FA3 2.6693 61",
        ),
    ] {
        assert_named(&soft, &set(numbers), expected);
    }
}

/// Thinner walls lower every frequency of a coupled tower and exchange no names.
#[test]
fn names_stay_where_all_walls_become_thinner() {
    let file = input("short-tower.toml");
    let tower = [
        ("stations[1].wall", 0.024189505),
        ("rna.center[2]", 1.1327627906331306),
        ("rna.inertia.xx", 1857812.07),
    ];
    let table = r#"
        1.0 | FA1 0.3288 64, SS1 0.3291 64, T1 1.6530 99, FA2 3.0183 58, SS2 3.2192 59, FA3 7.9409 53, SS3 8.6058 57
        0.7 | FA1 0.2855 60, SS1 0.2859 60, T1 1.4025 99, FA2 2.7736 59, SS2 2.9879 59, FA3 7.4475 52, SS3 8.0612 56
        0.65 | FA1 0.2769 60, SS1 0.2773 60, T1 1.3547 99, FA2 2.7201 59, SS2 2.9373 59, FA3 7.3534 51, SS3 7.9549 56
        0.6 | FA1 0.2678 59, SS1 0.2681 59, T1 1.3047 99, FA2 2.6614 59, SS2 2.8817 59, FA3 7.2553 51, SS3 7.8434 56
        0.55 | FA1 0.2581 59, SS1 0.2584 59, T1 1.2522 99, FA2 2.5967 59, SS2 2.8201 59, FA3 7.1528 51, SS3 7.7264 56
        0.5 | FA1 0.2477 58, SS1 0.2480 59, T1 1.1969 99, FA2 2.5249 59, SS2 2.7513 59, FA3 7.0455 50, SS3 7.6037 56
        "#;
    for [factor, expected] in rows(table) {
        let factor = number(factor);
        let changes = [&tower[..], &[("scale(stations[*].wall)", factor)]].concat();
        assert_named(&file, &changes, expected);
    }
}

/// A centre of mass beside the tower at an angle to the wind, with equal inertias about x and y.
#[test]
fn planes_that_turn_exchange_their_names_at_45_degrees() {
    let file = example("nrel-5mw.toml");
    let table = r#"
        0.0 | SS1 0.3196 99, FA1 0.3200 100, T1 1.5400 99, FA2 2.0399 100, SS2 2.1033 100, FA3 4.8633 98, SS3 4.9863 100
        30.0 | SS1 0.3196 75, FA1 0.3200 75, T1 1.5400 99, FA2 2.0399 75, SS2 2.1033 75, FA3 4.8633 73, SS3 4.9863 75
        44.0 | SS1 0.3196 51, FA1 0.3200 52, T1 1.5400 99, FA2 2.0399 52, SS2 2.1033 52, FA3 4.8633 51, SS3 4.9863 52
        44.999 | SS1 0.3196 50, FA1 0.3200 50, T1 1.5400 99, FA2 2.0399 50, SS2 2.1033 50, FA3 4.8633 49, SS3 4.9863 50
        45.0 | FA1 0.3196 50, SS1 0.3200 50, T1 1.5400 99, FA2 2.0399 50, SS2 2.1033 50, FA3 4.8633 49, SS3 4.9863 50
        45.001 | FA1 0.3196 50, SS1 0.3200 50, T1 1.5400 99, SS2 2.0399 50, FA2 2.1033 50, SS3 4.8633 49, FA3 4.9863 50
        46.0 | FA1 0.3196 51, SS1 0.3200 52, T1 1.5400 99, SS2 2.0399 52, FA2 2.1033 52, SS3 4.8633 51, FA3 4.9863 52
        90.0 | FA1 0.3196 99, SS1 0.3200 100, T1 1.5400 99, SS2 2.0399 100, FA2 2.1033 100, SS3 4.8633 98, FA3 4.9863 100
        "#;
    for [degrees, expected] in rows(table) {
        let degrees = number(degrees);
        let angle = f64::to_radians(degrees);
        let zero_or = |value: f64| if value.abs() < 1e-12 { 0.0 } else { value };
        let changes = [
            ("rna.inertia.xx", 3e7),
            ("rna.inertia.yy", 3e7),
            ("rna.inertia.zz", 2.3e7),
            ("rna.center[0]", zero_or(3.0 * angle.cos())),
            ("rna.center[1]", zero_or(3.0 * angle.sin())),
            ("rna.center[2]", 2.0),
        ];
        assert_named(&file, &changes, expected);
    }
}

#[test]
fn uncoupled_modes_have_their_motion_alone() {
    assert_named(
        &example("monopile.toml"),
        &[],
        "SS1 0.1832 100, FA1 0.1840 100, SS2 0.8414 100, FA2 0.8671 100, T1 1.1375 100, SS3 1.7431 100, FA3 2.0091 100, SS4 3.4327 100, FA4 3.7347 100",
    );
}

/// Six modes as one rigid body, each name once, then the tower on its platform.
#[test]
fn a_floating_tower_has_its_six_rigid_names_first() {
    let file = example("floating.toml");
    let description = read_tower(file).expect("a file").input.description;
    let tower = Tower::new(description).expect("a tower");
    let solution = solve(&tower, &with!(Options, modes = 9)).expect("modes");
    let names = solution.modes.iter().map(|mode| mode.name().to_string());
    let expected = "sway surge heave roll pitch yaw side-side-1 fore-aft-1 torsion-1";
    let names: Vec<String> = names.map(|name| name.replace(' ', "-")).collect();
    assert_eq!(names.join(" "), expected);
}

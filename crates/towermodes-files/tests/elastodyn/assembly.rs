//! Blades and the rotor-nacelle assembly against calculations by hand.

use towermodes_files::RotorLock::{Free, Locked};
use towermodes_files::elastodyn::{
    BladeMasses, lump_rna, read_blade_file, read_elastodyn, read_main_file, read_tower_file,
};
use towermodes_files::{ReadOptions, RotorLock};
use towermodes_testing::{Says, rows, with};

use crate::elastodyn::texts::{BLADE, TOWER, close, deck, files, main_file, main_text, source};

#[test]
fn the_assembly_is_that_of_the_hand_calculation() {
    let rna = deck(&[]).rna;
    // Blades: 1000 kg, centre 6 m from the apex, 1000 · 10²/12 about it.
    let total = 3000.0 + 500.0 + 2000.0 + 300.0;
    close(rna.mass_kg, total, 1e-9);
    close(rna.center_m[0], -11500.0 / total, 1e-12);
    close(rna.center_m[1], 1000.0 / total, 1e-12);
    close(rna.center_m[2], 9000.0 / total, 1e-12);
    // About the tower top; the rotor's 3 (1000 · 100/12 + 1000 · 36) = 133000, half of it about y
    // and z.
    let tensor = rna.tensor_about([0.0; 3]);
    let expected = 133000.0 + 70.0 + 2.0 + 3500.0 * 4.0 + 2000.0 * 1.25;
    close(tensor[0][0], expected, 1e-8);
    let expected = 66500.0 + 3000.0 * 20.0 + 500.0 * 13.0 + 2000.0 * 2.0;
    close(tensor[1][1], expected, 1e-8);
    let expected = 66500.0 + 3000.0 * 16.0 + 500.0 * 9.0 + 4000.0;
    close(tensor[2][2], expected, 1e-8);
    close(tensor[0][2], 3000.0 * 8.0 + 500.0 * 6.0 - 2000.0, 1e-8);
    close(tensor[0][1], -1000.0, 1e-8);
    close(tensor[1][2], -1000.0, 1e-8);
}

/// The assembly of the small turbine with its rotor held in a way.
fn assembly(changes: &[(&str, &str)], rotor: RotorLock) -> Result<towermodes::RigidBody, String> {
    let options = with!(ReadOptions, rotor);
    let main = source("main.dat", main_text(5, changes));
    let deck = read_elastodyn(main, &files(TOWER), &options);
    deck.map(|deck| deck.rna).map_err(|error| error.to_string())
}

/// J_r = 133000 + 70, J_g = 2 and q = 3: locked J_r + J_g; free J_r J_g (1 − q)²/(J_r + J_g q²) =
/// 133070 · 2 · 4/133088.
#[test]
fn a_free_rotor_takes_its_inertia_off_the_shaft_alone() {
    let others = 3500.0 * 4.0 + 2000.0 * 1.25;
    let of = |rotor| assembly(&[], rotor).expect("an assembly");
    let [locked, free] = [of(Locked), of(Free)].map(|rna| rna.tensor_about([0.0; 3]));
    close(locked[0][0], 133_072.0 + others, 1e-8);
    close(free[0][0], 133_070.0 * 8.0 / 133_088.0 + others, 1e-8);
    for i in 0..3 {
        for j in 0..3 {
            if (i, j) != (0, 0) {
                close(free[i][j], locked[i][j], 1e-8);
            }
        }
    }
    // A gearbox that reverses: 133070 · 2 · 16/133088.
    let reversed = assembly(&[("GBRatio", "-3")], Free).expect("an assembly");
    let xx = reversed.tensor_about([0.0; 3])[0][0];
    close(xx, 133_070.0 * 32.0 / 133_088.0 + others, 1e-8);
    // The ratio is nothing to a locked rotor.
    let locked_at = |ratio| assembly(&[("GBRatio", ratio)], Locked).expect("an assembly");
    assert_eq!(locked_at("1"), locked_at("97"));
}

#[test]
fn a_free_rotor_is_balanced() {
    for changes in [
        &[("NumBl", "1")][..],
        &[("TipMass(2)", "10")],
        &[("PreCone(3)", "5")],
    ] {
        assembly(changes, Locked).expect("it may be held");
        let refused = assembly(changes, Free).expect_err("it would swing");
        refused.says("the free rotor is not balanced");
    }
    let pair = [("NumBl", "2"), ("HubIner_Teeter", "600")];
    assembly(&pair, Free).expect("two blades alike");
}

#[test]
fn tilt_cone_and_azimuth_have_elastodyns_signs() {
    let nothing = [
        ("NacMass", "0"),
        ("NacYIner", "0"),
        ("YawBrMass", "0"),
        ("HubCM", "0"),
    ];
    let with =
        |changes: &[(&'static str, &'static str)]| main_file(5, &[&nothing, changes].concat());
    // A hub of the NREL 5-MW turbine's place: 2.4 m above the tower top.
    let main = with(&[
        ("OverHang", "-5.0191"),
        ("ShftTilt", "-5"),
        ("Twr2Shft", "1.96256"),
    ]);
    let hub = lump_rna(&main, &[], Locked);
    close(hub.center_m[0], -5.0191 * 5f64.to_radians().cos(), 1e-12);
    close(hub.center_m[2], 2.400_003_388, 1e-8);
    // Upwind cone: 6 m sin 30° upwind of the apex.
    let cone = [
        ("PreCone(1)", "-30"),
        ("PreCone(2)", "-30"),
        ("PreCone(3)", "-30"),
        ("HubMass", "0"),
    ];
    let uniform = BladeMasses {
        mass_kg: 1000.0,
        first_moment_kg_m: 5000.0,
        second_moment_kg_m2: 1e5 / 3.0,
    };
    close(
        lump_rna(&with(&cone), &[uniform; 3], Locked).center_m[0],
        -4.0 - 3.0,
        1e-12,
    );
    // The second blade stands 120° of a turn about x, which carries y to z, from the first: its tip
    // is at y = −11 sin 120°, z = 11 cos 120° from the apex.
    let tip = with(&[("TipMass(2)", "100"), ("HubMass", "0")]);
    let center = lump_rna(&tip, &[BladeMasses::default(); 3], Locked).center_m;
    close(center[1], -11.0 * 120f64.to_radians().sin(), 1e-12);
    close(center[2], 2.0 - 5.5, 1e-12);
}

#[test]
fn two_blades_have_a_teeter_pin() {
    let changes = [
        ("NumBl", "2"),
        ("NacMass", "0"),
        ("NacYIner", "0"),
        ("YawBrMass", "0"),
        ("GenIner", "0"),
        ("Twr2Shft", "0"),
        ("UndSling", "-0.5"),
        ("HubCM", "0.25"),
        ("HubIner", "400"),
    ];
    let blade = BladeMasses {
        mass_kg: 1000.0,
        first_moment_kg_m: 5000.0,
        second_moment_kg_m2: 1e5 / 3.0,
    };
    // The apex is 0.5 m downwind of the pin at −4 m; the hub's inertia about its centre 400 − 500 ·
    // 0.75².
    let own = 400.0 - 500.0 * 0.5625;
    let blades = 2.0 * (1000.0 * 100.0 / 12.0 + 36000.0);
    let main = main_file(1, &changes);
    let tensor = lump_rna(&main, &[blade; 2], Locked).tensor_about([0.0; 3]);
    close(tensor[0][0], blades + own, 1e-8);
    let expected = blades + own + 2000.0 * 3.5 * 3.5 + 500.0 * 3.25 * 3.25;
    close(tensor[1][1], expected, 1e-8);
    close(tensor[2][2], 2000.0 * 3.5 * 3.5 + 500.0 * 3.25 * 3.25, 1e-8);
    let main = main_file(5, &[&changes[..], &[("HubIner_Teeter", "400")]].concat());
    let tensor = lump_rna(&main, &[blade; 2], Locked).tensor_about([0.0; 3]);
    close(tensor[0][0], blades + 400.0, 1e-8);
    let expected = blades + own + 2000.0 * 3.5 * 3.5 + 500.0 * 3.25 * 3.25;
    close(tensor[1][1], expected, 1e-8);
    let mistake = read_main_file(&source("m", main_text(5, &changes))).expect_err("too small");
    mistake.message().says("281.25");
}

#[test]
fn blades_have_five_six_or_seventeen_columns() {
    let mass =
        |text: &str| read_blade_file(&source("b", text)).map(|blade| blade.masses(10.0).mass_kg);
    assert_eq!(mass(BLADE), Ok(1000.0));
    let five = BLADE.replace("PitchAxis ", "").replace(" 0.25 ", " ");
    assert_eq!(mass(&five), Ok(1000.0));
    let got = mass(&five.replace("BlFract StrcTwst BMassDen", "a b c"));
    assert_eq!(got, Ok(1000.0));
    let seventeen = BLADE
        .replace("PitchAxis", "AeroCent")
        .replace("1e9 1e9", "1 1 1 1 1 1 1 1 1 1 1 1 1");
    assert_eq!(mass(&seventeen), Ok(1000.0));
    let table = r#"
        ␣0 0.25 13 50 | ␣0 0.25 13 0 | BMassDen of row 1 is 0
        ␣1 0.25 0 50 | ␣0.9 0.25 0 50 | BlFract of the last row is 0.9
        ␣1 0.25 0 50 1e9 1e9 | ␣1 0.25 0 | 3 numbers instead of 5 or 6
        2 NBlInpSt | 9999999999 NBlInpSt | is 9999999999
        ␣2 AdjBlMs\n |  | expected AdjBlMs here, found AdjFlSt
        "#;
    for [from, to, says] in rows(table) {
        let mistake = mass(&BLADE.replacen(from, to, 1)).expect_err(to);
        mistake.message().says(says);
    }
}

/// Files of FAST 7 begin with a ruler and their title between rulers; then come the user's line and
/// the first heading.
#[test]
fn files_of_fast_7_begin_with_one_more_ruler() {
    let fast_7 = |text: &str, title: &str, flag: &str| {
        let ruler = "-".repeat(80);
        let lines = text.lines().skip(2).map(|line| match line {
            count if count.contains("InpSt") => format!("{count}\r\nFalse  {flag}  - (flag)"),
            line => line.to_owned(),
        });
        let body = lines.collect::<Vec<_>>().join("\r\n");
        format!("{ruler}\r\n-------- {title} --------\r\na small turbine\r\n{body}\r\n")
    };
    let text = fast_7(TOWER, "FAST TOWER FILE", "CalcTMode");
    let (tower, spans, _) = read_tower_file(&source("t", text.as_str())).expect("a tower file");
    assert_eq!(tower.rows.len(), 3);
    assert_eq!(tower.header[1], "a small turbine");
    assert_eq!(&text[spans[1][0].clone()], "-40.5");
    let text = fast_7(BLADE, "FAST INDIVIDUAL BLADE FILE", "CalcBMode");
    let blade = read_blade_file(&source("b", text)).expect("a blade file");
    assert_eq!(blade.masses(10.0).mass_kg, 1000.0);
}

/// One row is the whole blade: 100 kg/m over 10 m, ∫ μ r² dr = 100 · 10³/3.
#[test]
fn a_blade_of_one_row_is_uniform() {
    let text = BLADE
        .replace("2 NBlInpSt", "1 NBlInpSt")
        .replace(" 1 0.25 0 50 1e9 1e9\n", "");
    let masses = read_blade_file(&source("b", text.as_str())).map(|blade| blade.masses(10.0));
    let masses = masses.expect("a uniform blade");
    close(masses.mass_kg, 1000.0, 1e-12);
    close(masses.second_moment_kg_m2, 1e5 / 3.0, 1e-9);
    let off = text.replace(" 0 0.25 13", " 1 0.25 13");
    let mistake = read_blade_file(&source("b", off)).expect_err("it begins at 0");
    mistake.message().says("BlFract of the first row is 1");
}

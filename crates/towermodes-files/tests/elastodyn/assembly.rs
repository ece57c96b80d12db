//! Blades and the rotor-nacelle assembly against calculations by hand.

use towermodes_files::elastodyn::{
    BladeMasses, lump_rna, read_blade_file, read_main_file, read_tower_file,
};

use crate::elastodyn::texts::{BLADE, TOWER, close, deck, main_file, main_text, source};

#[test]
fn the_assembly_is_that_of_the_hand_calculation() {
    let rna = deck(&[]).rna;
    // Blades: 1000 kg, centre 6 m from the apex, 1000 · 10²/12 about it.
    let total = 3000.0 + 500.0 + 2000.0 + 300.0;
    close(rna.mass_kg, total, 1e-9);
    close(rna.center_m[0], -11500.0 / total, 1e-12);
    close(rna.center_m[1], 1000.0 / total, 1e-12);
    close(rna.center_m[2], 9000.0 / total, 1e-12);
    // About the tower top; the rotor's 3 (1000 · 100/12 + 1000 · 36) = 133000, half of it about y and z.
    let tensor = rna.tensor_about([0.0; 3]);
    close(
        tensor[0][0],
        133000.0 + 70.0 + 18.0 + 3500.0 * 4.0 + 2000.0 * 1.25,
        1e-8,
    );
    close(
        tensor[1][1],
        66500.0 + 3000.0 * 20.0 + 500.0 * 13.0 + 2000.0 * 2.0,
        1e-8,
    );
    close(
        tensor[2][2],
        66500.0 + 3000.0 * 16.0 + 500.0 * 9.0 + 4000.0,
        1e-8,
    );
    close(tensor[0][2], 3000.0 * 8.0 + 500.0 * 6.0 - 2000.0, 1e-8);
    close(tensor[0][1], -1000.0, 1e-8);
    close(tensor[1][2], -1000.0, 1e-8);
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
    let hub = lump_rna(&main, &[]);
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
        lump_rna(&with(&cone), &[uniform; 3]).center_m[0],
        -4.0 - 3.0,
        1e-12,
    );
    // The second blade stands 120° of a turn about x, which carries y to z, from the first: its tip is at y = −11 sin 120°,
    // z = 11 cos 120° from the apex.
    let tip = with(&[("TipMass(2)", "100"), ("HubMass", "0")]);
    let center = lump_rna(&tip, &[BladeMasses::default(); 3]).center_m;
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
    // The apex is 0.5 m downwind of the pin at −4 m; the hub's inertia about its centre 400 − 500 · 0.75².
    let own = 400.0 - 500.0 * 0.5625;
    let blades = 2.0 * (1000.0 * 100.0 / 12.0 + 36000.0);
    let main = main_file(1, &changes);
    let tensor = lump_rna(&main, &[blade; 2]).tensor_about([0.0; 3]);
    close(tensor[0][0], blades + own, 1e-8);
    close(
        tensor[1][1],
        blades + own + 2000.0 * 3.5 * 3.5 + 500.0 * 3.25 * 3.25,
        1e-8,
    );
    close(tensor[2][2], 2000.0 * 3.5 * 3.5 + 500.0 * 3.25 * 3.25, 1e-8);
    let main = main_file(5, &[&changes[..], &[("HubIner_Teeter", "400")]].concat());
    let tensor = lump_rna(&main, &[blade; 2]).tensor_about([0.0; 3]);
    close(tensor[0][0], blades + 400.0, 1e-8);
    close(
        tensor[1][1],
        blades + own + 2000.0 * 3.5 * 3.5 + 500.0 * 3.25 * 3.25,
        1e-8,
    );
    let mistake = read_main_file(&source("m", main_text(5, &changes))).expect_err("too small");
    assert!(mistake.hint.expect("a hint").contains("281.25"));
}

#[test]
fn blades_have_five_six_or_seventeen_columns() {
    let mass =
        |text: &str| read_blade_file(&source("b", text)).map(|blade| blade.masses(10.0).mass_kg);
    assert_eq!(mass(BLADE), Ok(1000.0));
    let five = BLADE.replace("PitchAxis ", "").replace(" 0.25 ", " ");
    assert_eq!(mass(&five), Ok(1000.0));
    assert_eq!(
        mass(&five.replace("BlFract StrcTwst BMassDen", "a b c")),
        Ok(1000.0)
    );
    let seventeen = BLADE
        .replace("PitchAxis", "AeroCent")
        .replace("1e9 1e9", "1 1 1 1 1 1 1 1 1 1 1 1 1");
    assert_eq!(mass(&seventeen), Ok(1000.0));
    for (from, to, says) in [
        (" 0 0.25 13 50", " 0 0.25 13 0", "BMassDen of row 1 is 0"),
        (
            " 1 0.25 0 50",
            " 0.9 0.25 0 50",
            "BlFract of the last row is 0.9",
        ),
        (" 1 0.25 0 50 1e9 1e9", " 1 0.25 0", "BMassDen is number 4"),
        ("2 NBlInpSt", "9999999999 NBlInpSt", "is 9999999999"),
        (
            " 2 AdjBlMs\n",
            "",
            "expected AdjBlMs here, but the line says AdjFlSt",
        ),
    ] {
        let mistake = mass(&BLADE.replacen(from, to, 1)).expect_err(to);
        assert!(mistake.message.contains(says), "{mistake}");
    }
}

#[test]
fn fast_7_has_one_more_line() {
    let text = TOWER
        .replace("rows\n", "rows\nFalse CalcTMode - (flag)\n")
        .replace('\n', "\r\n");
    let (tower, ..) = read_tower_file(&source("t", text)).expect("a tower file of FAST 7");
    assert_eq!(tower.rows.len(), 3);
    let blade = BLADE.replace("NBlInpSt\n", "NBlInpSt\nFalse CalcBMode - (flag)\n");
    assert_eq!(
        read_blade_file(&source("b", blade))
            .expect("a blade")
            .rows
            .len(),
        2
    );
}

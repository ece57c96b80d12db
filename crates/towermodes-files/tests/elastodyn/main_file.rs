//! Main files of all versions, and their mistakes.

use towermodes_files::ReadOptions;
use towermodes_files::elastodyn::{read_elastodyn, read_main_file};

use crate::elastodyn::texts::{TOWER, files, main_file, main_text, source};

#[test]
fn main_files_of_all_versions_say_the_same() {
    let (old, new) = (main_file(1, &[]), main_file(5, &[]));
    assert_eq!(old.gravity_m_per_s2, Some(9.81));
    assert_eq!(
        (new.gravity_m_per_s2, new.hub_teeter_inertia_kg_m2),
        (None, Some(0.0))
    );
    for main in [&old, &new] {
        assert_eq!(
            (main.blade_count, main.tower_nodes, main.blade_nodes),
            (3, 20, 17)
        );
        assert_eq!((main.tower_top_m, main.tower_base_m), (40.0, 0.0));
        assert_eq!(main.nacelle_center_m, [1.0, 0.5, 1.0]);
        assert_eq!(main.hub_inertia_kg_m2, 70.0);
        assert_eq!(main.gearbox_ratio, 3.0);
        assert_eq!(main.tower_file, "tower.dat");
    }
    let text = main_text(5, &[]);
    assert_eq!(&text[new.span("TowerHt").expect("a place")], "40");
}

#[test]
fn every_block_of_lines_may_be_missing_on_its_own() {
    let whole = main_text(5, &[]);
    let without = |names: &[&str]| {
        let lines = whole
            .lines()
            .filter(|line| !names.iter().any(|name| line.contains(name)));
        lines.collect::<Vec<_>>().join("\n")
    };
    for names in [
        &["PitchDOF"][..],
        &["PtfmRefxt", "PtfmRefyt"],
        &["PBrIner", "BlPIner"],
        &["HubIner_Teeter"],
        &["PtfmXYIner", "PtfmYZIner", "PtfmXZIner"],
        &["YAW-FRICTION", "YawFrctMod", "M_", "sig_v", "OmgCut"],
    ] {
        let main = read_main_file(&source("m", without(names))).expect(names[0]);
        assert_eq!(main.tower_file, "tower.dat");
        assert_eq!(main.nacelle_mass_kg, 2000.0);
    }
    let mistake =
        read_main_file(&source("m", without(&["NacMass"]))).expect_err("a line is missing");
    assert_eq!(
        mistake.message,
        "expected NacMass here, but the line says NacYIner"
    );
    let mistake =
        read_main_file(&source("m", without(&["BlPIner(2)"]))).expect_err("one of a block");
    assert_eq!(
        mistake.message,
        "expected BlPIner(2) here, but the line says BlPIner(3)"
    );
}

#[test]
fn the_rules_of_the_main_file_have_their_places() {
    for (key, value, says) in [
        ("NumBl", "4", "NumBl (number of blades) is 4"),
        ("TipRad", "0.5", "TipRad is 0.5 m and HubRad 1 m"),
        ("TowerBsHt", "50", "TowerHt is 40 m and TowerBsHt 50 m"),
        ("ShftTilt", "95", "is 95"),
        ("HubMass", "-1", "is -1"),
        ("NacYIner", "2499", "NacYIner is 2499 kg m2"),
        ("TwrNodes", "0", "is 0"),
        ("TwrFile", "\"\"", "is empty"),
        ("TwFADOF1", "7", "true or false"),
        ("GenIner", "\"2\"", "a number"),
    ] {
        let text = main_text(5, &[(key, value)]);
        let mistake = read_main_file(&source("m", text)).expect_err(key);
        assert!(mistake.message.contains(says), "{mistake}");
    }
    let fast_7 = "a\nb\n---\n1 ADAMSPrep - mode\n3 NumBl - n\n9 TipRad - m\n\"t\" TwrFile - f\n";
    let error = read_elastodyn(source("m", fast_7), &files(TOWER), &ReadOptions::default());
    assert!(
        error
            .expect_err("FAST 7")
            .to_string()
            .contains("not understood as a main file")
    );
}

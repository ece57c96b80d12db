//! Main files of all versions, and their mistakes.

use towermodes_files::elastodyn::read_main_file;
use towermodes_files::{InMemory, ReadOptions, read_source};
use towermodes_testing::{Says, rows};

use crate::elastodyn::texts::{main_file, main_text, source};

#[test]
fn main_files_of_all_versions_say_the_same() {
    let (old, new) = (main_file(1, &[]), main_file(5, &[]));
    assert_eq!(old.gravity_m_per_s2, Some(9.81));
    assert_eq!(new.gravity_m_per_s2, None);
    assert_eq!(new.hub_teeter_inertia_kg_m2, Some(0.0));
    for main in [&old, &new] {
        assert_eq!(main.blade_count, 3);
        assert_eq!(main.tower_nodes, 20);
        assert_eq!(main.blade_nodes, Some(17));
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
    assert_eq!(mistake.message(), "expected NacMass here, found NacYIner");
    let mistake =
        read_main_file(&source("m", without(&["BlPIner(2)"]))).expect_err("one of a block");
    mistake
        .message()
        .reads("expected BlPIner(2) here, found BlPIner(3)");
}

#[test]
fn the_rules_of_the_main_file_have_their_places() {
    let table = r#"
        NumBl | 4 | NumBl (number of blades) is 4
        TipRad | 0.5 | TipRad is 0.5 m, but must be greater than HubRad, 1 m
        TowerBsHt | 50 | TowerHt is 40 m, but must be above TowerBsHt, 50 m
        TowerHt | 0 | TowerHt is 0 m, but must be above TowerBsHt, 0 m
        ShftTilt | 95 | is 95
        HubMass | -1 | is -1
        NacYIner | 2499 | NacYIner is 2499 kg m2
        TwrNodes | 0 | is 0
        TwrFile | "" | found an empty text
        TwFADOF1 | 7 | true or false
        GenIner | "2" | a number
        "#;
    for [key, value, says] in rows(table) {
        let text = main_text(5, &[(key, value)]);
        let mistake = read_main_file(&source("m", text)).expect_err(key);
        mistake.message().says(says);
    }
}

/// ElastoDyn 1.00 has the base's height as two lengths and the platform's reference point as a
/// depth; up to 1.01 there is no BldNodes.
#[test]
fn the_first_layouts_are_read() {
    let modern = main_text(1, &[("TowerBsHt", "3"), ("PtfmRefzt", "-2")]);
    let without_nodes: String = modern
        .lines()
        .filter(|line| !line.contains("BldNodes"))
        .map(|line| format!("{line}\n"))
        .collect();
    let read = |text: &str| read_main_file(&source("m", text));
    let v1_01 = read(&without_nodes).expect("ElastoDyn 1.01");
    assert_eq!(v1_01.blade_nodes, None);
    let v1_00 = without_nodes
        .replace(
            "  3   TowerBsHt - some words\n",
            "  5   TwrRBHt - some words\n  2   TwrDraft - some words\n",
        )
        .replace("  -2   PtfmRefzt", "  2   PtfmRef");
    assert!(v1_00.contains("TwrDraft") && v1_00.contains("PtfmRef "));
    let v1_00 = read(&v1_00).expect("ElastoDyn 1.00");
    for main in [&v1_00, &v1_01] {
        assert_eq!((main.tower_top_m, main.tower_base_m), (40.0, 3.0));
        assert_eq!(main.platform.reference_m, [0.0, 0.0, -2.0]);
        assert_eq!(main.tower_file, "tower.dat");
    }
    // The two lengths come together.
    let half = without_nodes.replace("  3   TowerBsHt", "  3   TwrRBHt");
    let mistake = read(&half).expect_err("no TwrDraft");
    mistake.message().says("expected TwrDraft here");
}

/// FAST 7 has most of the names in an order of its own; the hint says what to do.
#[test]
fn a_main_file_of_fast_7_is_refused_as_one() {
    let names = "FlapDOF1 FlapDOF2 EdgeDOF TeetDOF DrTrDOF GenDOF YawDOF TwFADOF1 TwFADOF2 TwSSDOF1 TwSSDOF2 CompAero CompNoise \
                 OoPDefl IPDefl TeetDefl Azimuth RotSpeed NacYaw TTDspFA TTDspSS TipRad HubRad PSpnElN UndSling HubCM OverHang NacCMxn \
                 NacCMyn NacCMzn TowerHt Twr2Shft TwrRBHt ShftTilt Delta3 PreCone(1) PreCone(2) PreCone(3) AzimB1Up YawBrMass NacMass \
                 HubMass TipMass(1) TipMass(2) TipMass(3) NacYIner GenIner HubIner GBoxEff GenEff GBRatio GBRevers HSSBrTqF HSSBrDT \
                 DTTorSpr DTTorDmp PtfmModel PtfmFile TwrNodes TwrFile YawSpr YawDamp Furling FurlFile TeetMod";
    let mut text = "-----\n------- FAST INPUT FILE -------\na turbine\nwords\n\
                    ------- SIMULATION CONTROL -------\nFalse Echo - e\n1 ADAMSPrep - mode\n3 NumBl - n\n"
        .to_owned();
    for name in names.split_whitespace() {
        text += &format!("   1   {name}   - words\n");
    }
    let expected = source("turbine.fst", text);
    let error = read_source(expected, &InMemory::default(), &ReadOptions::default());
    let error = error.expect_err("FAST 7");
    let towermodes_files::ReadError::Mistakes { mistakes, .. } = &error else {
        panic!("{error}");
    };
    assert!(
        mistakes[0]
            .message()
            .contains("this is a main file of FAST 7"),
        "{error}"
    );
    let hint = mistakes[0].hint.as_deref().unwrap_or_default();
    hint.says("give its tower file alone");
}

//! Synthetic files of a small turbine.

use std::collections::BTreeMap;

pub use crate::sources::source;
use towermodes_files::elastodyn::{ElastoDynDeck, MainFile, read_elastodyn, read_main_file};
use towermodes_files::{InMemory, ReadOptions};

/// The parameters of a main file of OpenFAST 5 by section; `+` before those that older versions do
/// not have.
pub const MAIN: &[(&str, &str)] = &[
    ("SIMULATION CONTROL", "Echo Method DT"),
    (
        "DEGREES OF FREEDOM",
        "FlapDOF1 FlapDOF2 EdgeDOF +PitchDOF TeetDOF DrTrDOF GenDOF YawDOF TwFADOF1 TwFADOF2 TwSSDOF1 TwSSDOF2 PtfmSgDOF PtfmSwDOF PtfmHvDOF PtfmRDOF PtfmPDOF PtfmYDOF",
    ),
    (
        "INITIAL CONDITIONS",
        "OoPDefl IPDefl BlPitch(1) BlPitch(2) BlPitch(3) TeetDefl Azimuth RotSpeed NacYaw TTDspFA TTDspSS PtfmSurge PtfmSway PtfmHeave PtfmRoll PtfmPitch PtfmYaw",
    ),
    (
        "TURBINE CONFIGURATION",
        "NumBl TipRad HubRad PreCone(1) PreCone(2) PreCone(3) HubCM UndSling Delta3 AzimB1Up OverHang ShftGagL ShftTilt NacCMxn NacCMyn NacCMzn NcIMUxn NcIMUyn NcIMUzn Twr2Shft TowerHt TowerBsHt PtfmCMxt PtfmCMyt PtfmCMzt +PtfmRefxt +PtfmRefyt PtfmRefzt",
    ),
    (
        "MASS AND INERTIA",
        "TipMass(1) TipMass(2) TipMass(3) +PBrIner(1) +PBrIner(2) +PBrIner(3) +BlPIner(1) +BlPIner(2) +BlPIner(3) HubMass HubIner +HubIner_Teeter GenIner NacMass NacYIner YawBrMass PtfmMass PtfmRIner PtfmPIner PtfmYIner +PtfmXYIner +PtfmYZIner +PtfmXZIner",
    ),
    ("BLADE", "BldNodes BldFile(1) BldFile(2) BldFile(3)"),
    (
        "ROTOR-TEETER",
        "TeetMod TeetDmpP TeetDmp TeetCDmp TeetSStP TeetHStP TeetSSSp TeetHSSp",
    ),
    (
        "+YAW-FRICTION",
        "+YawFrctMod +M_CSmax +M_FCSmax +M_MCSmax +M_CD +M_FCD +M_MCD +sig_v +sig_v2 +OmgCut",
    ),
    ("DRIVETRAIN", "GBoxEff GBRatio DTTorSpr DTTorDmp"),
    ("FURLING", "Furling FurlFile"),
    ("TOWER", "TwrNodes TwrFile"),
];

/// Values of a small turbine, see [`the_assembly_is_that_of_the_hand_calculation`].
pub const VALUES: &[(&str, &str)] = &[
    ("DT", "Default"),
    ("NumBl", "3"),
    ("TipRad", "11"),
    ("HubRad", "1"),
    ("HubCM", "1"),
    ("OverHang", "-4"),
    ("NacCMxn", "1"),
    ("NacCMyn", "0.5"),
    ("NacCMzn", "1"),
    ("Twr2Shft", "2"),
    ("TowerHt", "40"),
    ("HubMass", "500"),
    ("HubIner", "70"),
    ("GenIner", "2"),
    ("NacMass", "2000"),
    ("NacYIner", "4000"),
    ("YawBrMass", "300"),
    ("BldNodes", "17"),
    ("BldFile(1)", "\"parts\\blade.dat\""),
    ("BldFile(2)", "\"parts\\blade.dat\""),
    ("BldFile(3)", "\"parts\\blade.dat\""),
    ("GBRatio", "3"),
    ("FurlFile", "\"unused\""),
    ("TwrNodes", "20"),
    ("TwrFile", "\"tower.dat\""),
];

/// A main file, of OpenFAST 5 or with the sections of OpenFAST 1, with some values changed.
pub fn main_text(version: usize, changes: &[(&str, &str)]) -> String {
    let mut values: BTreeMap<&str, &str> = VALUES.iter().copied().collect();
    values.extend(changes.iter().copied());
    let mut text = "ELASTODYN INPUT FILE\na small turbine\n".to_owned();
    for (title, keys) in MAIN {
        if !title.starts_with('+') || version == 5 {
            text += &format!("------- {} -------\n", title.trim_start_matches('+'));
        }
        for key in keys
            .split(' ')
            .filter(|key| !key.starts_with('+') || version == 5)
        {
            let key = key.trim_start_matches('+');
            let is_flag = key == "Echo" || key == "Furling" || key.contains("DOF");
            let value = values
                .get(key)
                .copied()
                .unwrap_or(if is_flag { "False" } else { "0" });
            let name = if version == 5 {
                key.to_owned()
            } else {
                key.replace(['(', ')'], "")
            };
            text += &format!("  {value}   {name} - some words\n");
        }
        if *title == "SIMULATION CONTROL" && version == 1 {
            text += "------- ENVIRONMENTAL CONDITION -------\n9.81 Gravity - (m/s^2)\n";
        }
    }
    text + "------- OUTPUT -------\nTrue SumPrint - more\n"
}

pub const TOWER: &str = "a tower
TowerHt = 40 m, TowerBsHt = 10 m
------- TOWER PARAMETERS -------
 3 NTwInpSt - rows
 1 TwrFADmp(1) - %
 2 TwrFADmp(2) - %
 3 TwrSSDmp(1) - %
 4 TwrSSDmp(2) - %
------- TOWER ADJUSTMUNT FACTORS -------
 1 FAStTunr(1) - (-)
 1.5 FAStTunr(2) - (-)
 1 SSStTunr(1) - (-)
 1 SSStTunr(2) - (-)
 2 AdjTwMa - (-)
 3 AdjFASt - (-)
 4 AdjSSSt - (-)
------- DISTRIBUTED TOWER PROPERTIES -------
 HtFract TMassDen TwFAStif TwSSStif
 (-) (kg/m) (Nm^2) (Nm^2)
 0.0 1.0D3 1e10 2e10 7 7 7 7 7 7
 0.25 900 9e9 1.8e10
 1.0 800 8e9 1.6e10
------- TOWER FORE-AFT MODE SHAPES -------
 0.5 TwFAM1Sh(2) - x^2
 0.5 TwFAM1Sh(3) - x^3
 0 TwFAM1Sh(4) - x^4
 0 TwFAM1Sh(5) - x^5
 0 TwFAM1Sh(6) - x^6
 -40.5 TwFAM2Sh(2) - x^2
 41.5 TwFAM2Sh(3) - x^3
 0 TwFAM2Sh(4) - x^4
 0 TwFAM2Sh(5) - x^5
 0 TwFAM2Sh(6) - x^6
------- TOWER SIDE-TO-SIDE MODE SHAPES -------
 1 TwSSM1Sh(2) - x^2
 0.001 TwSSM1Sh(3) - x^3
 0 TwSSM1Sh(4) - x^4
 0 TwSSM1Sh(5) - x^5
 0 TwSSM1Sh(6) - x^6
 1 TwSSM2Sh(2) - x^2
 0 TwSSM2Sh(3) - x^3
 0 TwSSM2Sh(4) - x^4
 0 TwSSM2Sh(5) - x^5
 0 TwSSM2Sh(6) - x^6
";

pub const MASSES: &str = "------- TOWER CONCENTRATED MASSES -------
 2 NTwCMass - count
 HtFract TwCMass
 (-) (kg)
 0.5 1200
 1 30
";

/// A uniform blade of 100 kg/m.
pub const BLADE: &str = "a blade
of 10 m
------- BLADE PARAMETERS -------
 2 NBlInpSt
 1 BldFlDmp(1)
 1 BldFlDmp(2)
 1 BldEdDmp(1)
------- BLADE ADJUSTMENT FACTORS -------
 1 FlStTunr(1)
 1 FlStTunr(2)
 2 AdjBlMs
 1 AdjFlSt
 1 AdjEdSt
------- DISTRIBUTED BLADE PROPERTIES -------
 BlFract PitchAxis StrcTwst BMassDen FlpStff EdgStff
 (-) (-) (deg) (kg/m) (Nm^2) (Nm^2)
 0 0.25 13 50 1e9 1e9
 1 0.25 0 50 1e9 1e9
";

pub fn files(tower: &str) -> InMemory {
    let files = [("tower.dat", tower), ("parts\\blade.dat", BLADE)];
    InMemory {
        files: files
            .map(|(name, text)| (name.to_owned(), text.to_owned()))
            .into(),
    }
}

pub fn main_file(version: usize, changes: &[(&str, &str)]) -> MainFile {
    read_main_file(&source("main.dat", main_text(version, changes))).expect("a main file")
}

pub fn deck(changes: &[(&str, &str)]) -> ElastoDynDeck {
    let main = source("main.dat", main_text(5, changes));
    read_elastodyn(
        main,
        &files(&(TOWER.to_owned() + MASSES)),
        &ReadOptions::default(),
    )
    .expect("a deck")
}

pub fn close(value: f64, expected: f64, tolerance: f64) {
    let holds = (value - expected).abs() <= tolerance;
    assert!(holds, "{value} is not {expected}");
}

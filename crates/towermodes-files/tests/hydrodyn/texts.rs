//! Short files of HydroDyn, in the layouts of all versions.

use towermodes_files::{HydrodynInput, InMemory, ReadError, Source, WaterDefaults, read_hydrodyn};

/// The layouts that differ in places or names of what is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Layout {
    /// FAST 8: water in the file, flags of the platform's forces, AddF0 in a row.
    Fast8,
    /// OpenFAST 2.6: AddF0 in a column, lists for bodies.
    V26,
    /// OpenFAST 3.1: density and depth `default`.
    V31,
    /// OpenFAST 4.1: no water, two kinds of sections, more columns.
    V41,
}

pub const LAYOUTS: [Layout; 4] = [Layout::Fast8, Layout::V26, Layout::V31, Layout::V41];

/// Water of 1025 kg/m³, 40 m deep.
pub const WATER: WaterDefaults = WaterDefaults {
    density_kg_per_m3: Some(1025.0),
    depth_m: Some(40.0),
    level_m: Some(0.0),
};

/// A vertical tube of radius 2 m, wall 0.1 m, from −30 m to 10 m.
pub const TUBE: [(&str, &str); 6] = [
    ("NAxCoef", "1 0 0.6 1"),
    ("NJoints", "1 0 0 -30 1 0\n2 0 0 10 1 0"),
    ("NPropSets", "1 4.0 0.1"),
    ("Simpl", "1.0 1.1 0.9 1.2 1 1 0.3 0.4 1 1"),
    ("NMembers", "1 1 2 1 1 1 0.5 1 F"),
    ("NFillGroups", "1 1 -5 1000"),
];

/// A table of the file: the name of its number of rows here, in the newest version, and the names
/// of its columns before and since OpenFAST 4.1.
type Table = (&'static str, &'static str, &'static str, &'static str);

const TABLES: [Table; 8] = [
    (
        "NAxCoef",
        "NAxCoef",
        "AxCoefID AxCd AxCa AxCp",
        "AxCoefID AxCd AxCa AxCp",
    ),
    (
        "NJoints",
        "NJoints",
        "JointID Jointxi Jointyi Jointzi JointAxID JointOvrlp",
        "JointID Jointxi Jointyi Jointzi JointAxID JointOvrlp",
    ),
    (
        "NPropSets",
        "NPropSetsCyl",
        "PropSetID PropD PropThck",
        "PropSetID PropD PropThck",
    ),
    (
        "NCoefDpth",
        "NCoefDpthCyl",
        "Dpth DpthCd DpthCdMG DpthCa DpthCaMG DpthAxCa DpthAxCaMG",
        "Dpth DpthCd DpthCdMG DpthCa DpthCaMG DpthAxCa DpthAxCaMG",
    ),
    (
        "NCoefMembers",
        "NCoefMembersCyl",
        "MemberID MemberCa1 MemberCa2 MemberCaMG1 MemberCaMG2 MemberAxCa1 MemberAxCa2 MemberAxCaMG1 MemberAxCaMG2",
        "MemberID MemberCa1 MemberCa2 MemberCaMG1 MemberCaMG2 MemberAxCa1 MemberAxCa2 MemberAxCaMG1 MemberAxCaMG2",
    ),
    (
        "NMembers",
        "NMembers",
        "MemberID MJointID1 MJointID2 MPropSetID1 MPropSetID2 - MDivSize MCoefMod PropPot",
        "MemberID MJointID1 MJointID2 MPropSetID1 MPropSetID2 MSecGeom MDivSize MCoefMod PropPot",
    ),
    (
        "NFillGroups",
        "NFillGroups",
        "FillNumM FillMList FillFSLoc FillDens",
        "FillNumM FillMList FillFSLoc FillDens",
    ),
    (
        "NMGDepths",
        "NMGDepths",
        "MGDpth MGThck MGDens",
        "MGDpth MGThck MGDens",
    ),
];

/// A file with the rows of some tables; those of [`TUBE`] otherwise. `AddCLin` and `PotMod` are
/// tables of one row too.
pub fn deck(layout: Layout, changes: &[(&str, &str)]) -> String {
    let rows_of = |name: &str| {
        let is_it = |rows: &&(&str, &str)| rows.0 == name;
        let rows = changes.iter().find(is_it).or(TUBE.iter().find(is_it));
        rows.map_or("", |(_, rows)| rows.trim())
    };
    let mut text = "------- HydroDyn Input File -------\na tube\nFalse Echo - Echo\n".to_owned();
    text += match layout {
        Layout::Fast8 | Layout::V26 => {
            "1025 WtrDens - density\n40 WtrDpth - depth\n0 MSL2SWL - level\n"
        }
        Layout::V31 => {
            "\"default\" WtrDens - density\n\"DEFAULT\" WtrDpth - depth\ndefault MSL2SWL - level\n"
        }
        Layout::V41 => "",
    };
    let or = |rows: &'static str, given: &str| match given {
        "" => rows.to_owned(),
        given => given.to_owned(),
    };
    text += &format!("{} PotMod - model\n", or("0", rows_of("PotMod")));
    text += "\"body\" PotFile - root\n2 WAMITULEN - unit\n0 PtfmRefxt - x\n0 PtfmRefyt - y\n";
    text += "-4 PtfmRefzt - z\n0 PtfmRefztRot - turn\n100 PtfmVol0 - volume\n0 PtfmCOBxt - x\n0 PtfmCOByt - y\n";
    text += &format!("{} NBody - bodies\n", or("1", rows_of("NBody")));
    if layout == Layout::Fast8 {
        text += "---- FLOATING PLATFORM FORCE FLAGS ----\nTrue PtfmSgF - surge\n1 2 3 4 5 6 AddF0 - preload\n";
    } else {
        text += "1 AddF0 - preload\n2\n3\n4\n5\n6\n";
    }
    for name in ["AddCLin", "AddBLin", "AddBQuad"] {
        let first = or("0 0 0 0 0 0", rows_of(name));
        text += &format!("{first} {name} - matrix\n");
        text += &"0 0 0 0 0 0\n".repeat(5);
    }
    for (name, newest, columns, new_columns) in TABLES {
        let rows = rows_of(name);
        let number = rows.lines().filter(|row| !row.is_empty()).count();
        let (name, columns) = match layout {
            Layout::V41 => (newest, new_columns),
            Layout::Fast8 | Layout::V26 | Layout::V31 => (name, columns),
        };
        let units = "(-) ".repeat(columns.split(' ').count());
        text += &format!("------- TABLE -------\n{number} {name} - rows\n{columns}\n{units}\n");
        rows.lines()
            .for_each(|row| text += &format!("{}\n", row.trim()));
        if name.starts_with("NPropSets") {
            text += "------- SIMPLE -------\nSimplCd SimplCdMG SimplCa SimplCaMG SimplCp SimplCpMG SimplAxCa SimplAxCaMG SimplAxCp SimplAxCpMG\n";
            text += &format!("(-) (-)\n{}\n", rows_of("Simpl"));
        }
    }
    text + "------- OUTPUT -------\nTrue HDSum - summary\nEND\n"
}

/// Added mass of a sphere-like body at three frequencies, and its stiffness.
pub const WAMIT_1: &str =
    "-1 1 1 2.0\n-1 3 3 3.0\n0 1 1 1.0\n0 3 3 1.5\n10 1 1 1.8 0.1\n10 3 3 2.5 0.1\n";
pub const WAMIT_HST: &str = "3 3 5.0\n4 4 7.0\n5 5 7.5\n";

/// Reads a file with these files of WAMIT.
pub fn read_with(text: &str, wamit: [&str; 2]) -> Result<HydrodynInput, ReadError> {
    let [added, stiffness] = wamit.map(str::to_owned);
    let files = [
        ("body.1".to_owned(), added),
        ("body.hst".to_owned(), stiffness),
    ];
    let files = InMemory {
        files: files.into(),
    };
    let (name, text) = ("HydroDyn.dat".to_owned(), text.to_owned());
    read_hydrodyn(Source { name, text }, &files, "", WATER)
}

pub fn read(text: &str) -> Result<HydrodynInput, ReadError> {
    read_with(text, [WAMIT_1, WAMIT_HST])
}

/// The input of a file with these rows, in the layout of OpenFAST 3.1.
pub fn input(changes: &[(&str, &str)]) -> HydrodynInput {
    read(&deck(Layout::V31, changes)).unwrap_or_else(|error| panic!("{error}"))
}

//! Short files of SubDyn, in the layout of OpenFAST 5.

use towermodes_files::{InMemory, ReadError, Source, SubdynInput, read_subdyn};

/// The tables of a file: a key for tests, the number of rows, and the names of the columns.
const TABLES: [(&str, &str, &str); 12] = [
    (
        "STRUCTURE JOINTS",
        "NJoints",
        "JointID JointXss JointYss JointZss JointType JointDirX JointDirY JointDirZ JointStiff",
    ),
    (
        "BASE REACTION JOINTS",
        "NReact",
        "RJointID RctTDXss RctTDYss RctTDZss RctRDXss RctRDYss RctRDZss SSIfile",
    ),
    (
        "INTERFACE JOINTS",
        "NInterf",
        "IJointID TPID ItfTDXss ItfTDYss ItfTDZss ItfRDXss ItfRDYss ItfRDZss",
    ),
    (
        "- MEMBERS -",
        "NMembers",
        "MemberID MJointID1 MJointID2 MPropSetID1 MPropSetID2 MType MSpin/COSMID",
    ),
    (
        "CIRCULAR BEAM CROSS-SECTION PROPERTIES",
        "NPropSetsCyl",
        "PropSetID YoungE ShearG MatDens XsecD XsecT",
    ),
    (
        "RECTANGULAR BEAM CROSS-SECTION PROPERTIES",
        "NPropSetsRec",
        "PropSetID YoungE ShearG MatDens XsecSa XsecSb XsecT",
    ),
    (
        "ARBITRARY BEAM CROSS-SECTION PROPERTIES",
        "NXPropSets",
        "PropSetID YoungE ShearG MatDens XsecA XsecAsx XsecAsy XsecJxx XsecJyy XsecJ0 XsecJt",
    ),
    (
        "CABLE PROPERTIES",
        "NCablePropSets",
        "PropSetID EA MatDens T0 CtrlChannel",
    ),
    (
        "RIGID LINK PROPERTIES",
        "NRigidPropSets",
        "PropSetID MatDens",
    ),
    (
        "SPRING ELEMENT PROPERTIES",
        "NSpringPropSets",
        "PropSetID k11 k12",
    ),
    (
        "MEMBER COSINE MATRICES COSM(i,j)",
        "NCOSMs",
        "COSMID COSM11 COSM12",
    ),
    (
        "JOINT ADDITIONAL CONCENTRATED MASSES",
        "NCmass",
        "CMJointID JMass JMXX JMYY JMZZ JMXY JMXZ JMYZ MCGX MCGY MCGZ",
    ),
];

/// Two tubes of 10 m, one on the other, from the sea bed to the interface.
pub const TUBES: [(&str, &str); 5] = [
    (
        "NJoints",
        "1 0 0 -20 1 0 0 0 0\n2 0 0 -10 1 0 0 0 0\n3 0 0 0 1 0 0 0 0",
    ),
    ("NReact", "1 1 1 1 1 1 1 \"\""),
    ("NInterf", "3 1 1 1 1 1 1 1"),
    ("NMembers", "1 1 2 1 1 1c 0\n2 2 3 1 1 1c 0"),
    ("NPropSetsCyl", "1 2.1e11 8.08e10 7850 2.0 0.03"),
];

/// A file with the rows of some tables; those of [`TUBES`] otherwise.
pub fn deck(changes: &[(&str, &str)]) -> String {
    let mut text = "------- SubDyn MultiMember Support Structure Input File -------\ntubes\n\
        ------- SIMULATION CONTROL -------\nFalse Echo - Echo\n\"DEFAULT\" SDdeltaT - step\n\
        ------- FEA and CRAIG-BAMPTON PARAMETERS -------\n3 FEMMod - element\n4 NDiv - parts\n\
        8 Nmodes - modes\n1 JDampings - damping\n"
        .to_owned();
    for (heading, count, names) in TABLES {
        let is_it = |rows: &&(&str, &str)| rows.0 == count;
        let rows = changes.iter().find(is_it).or(TUBES.iter().find(is_it));
        let rows = rows.map_or("", |(_, rows)| rows.trim());
        let number = rows.lines().filter(|row| !row.is_empty()).count();
        let units = "(-) ".repeat(names.split(' ').count());
        text += &format!("------- {heading} -------\n{number} {count} - rows\n{names}\n{units}\n");
        rows.lines()
            .for_each(|row| text += &format!("{}\n", row.trim()));
    }
    text + "------- OUTPUT: SUMMARY & OUTFILE -------\nTrue SumPrint - summary\nEND\n"
}

/// The soil of the file `ssi.txt`.
pub const SOIL: &str = "!---- Pile head ----!\n\
    -1.98E+08 Kxty\n1.35E+09 Ktyty\n2.00E+08 Kytx\n1.30E+09 Ktxtx\n7.00E+08 Ktztz\n\
    5.04E+07 Kxx\n3.10D+05 kxy\n5.60E+07 Kyy\n2.54E+08 Kzz\n\n\
    4.0E+03 Mxx\n4.0E+03 Myy\n3.0E+03 Mzz\n-9.0E+03 Mxty\n9.0E+03 Mytx\n";

pub fn read(text: &str) -> Result<SubdynInput, ReadError> {
    read_with(text, SOIL)
}

/// The same with another file of soil stiffness.
pub fn read_with(text: &str, soil: &str) -> Result<SubdynInput, ReadError> {
    let files = InMemory {
        files: [("ssi.txt".to_owned(), soil.to_owned())].into(),
    };
    let (name, text) = ("SubDyn.dat".to_owned(), text.to_owned());
    read_subdyn(Source { name, text }, &files)
}

/// The input of a file with these rows.
pub fn input(changes: &[(&str, &str)]) -> SubdynInput {
    read(&deck(changes)).unwrap_or_else(|error| panic!("{error}"))
}

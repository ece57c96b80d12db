//! The records of the main file of ElastoDyn in their order, in all layouts of the file: the only
//! table that is used for recognition, reading, names and messages.
//!
//! Source: `ReadPrimaryFile` in `ElastoDyn_IO.f90` from FAST 8 to OpenFAST 5.0.

use super::super::record::{ACUTE, ANY, HALF_TURN, Kind, NON_NEGATIVE, Record, record};

/// Records that follow each other in every layout that has them.
pub(super) struct Block {
    /// The layouts that have it.
    pub(super) presence: Presence,
    /// The title of the section that it opens.
    pub(crate) heading: Option<&'static str>,
    pub(crate) records: &'static [Record],
}

/// The layouts that have a block.
pub(super) enum Presence {
    /// All layouts.
    Always,
    /// Layouts that contain one of the names of the block.
    IfNamed,
    /// Layouts without these names, which replaced the block in earlier versions.
    Unless(&'static [&'static str]),
}

const fn block(heading: Option<&'static str>, records: &'static [Record]) -> Block {
    let presence = Presence::Always;
    Block {
        presence,
        heading,
        records,
    }
}

const fn optional(records: &'static [Record]) -> Block {
    let (presence, heading) = (Presence::IfNamed, None);
    Block {
        presence,
        heading,
        records,
    }
}

const fn optional_section(heading: &'static str, records: &'static [Record]) -> Block {
    let (presence, heading) = (Presence::IfNamed, Some(heading));
    Block {
        presence,
        heading,
        records,
    }
}

/// A parameter that is not read.
const fn unread(name: &'static str) -> Record {
    record(name, "a value", Kind::Other)
}

/// Records that replace older ones.
const fn instead_of(old: &'static [&'static str], records: &'static [Record]) -> Block {
    let (presence, heading) = (Presence::Unless(old), None);
    Block {
        presence,
        heading,
        records,
    }
}

/// All blocks in order. The following blocks are not in every layout: the heights of the tower's
/// base and of the platform's reference point, with other names in ElastoDyn 1.00; the number of
/// blade nodes, not in ElastoDyn 1.00 and 1.01; gravity, in the `.fst` file since OpenFAST 3.0;
/// products of inertia of the platform and yaw friction, since 4.0; the hub's inertia about the
/// teeter axis, since 4.2; inertias of pitch bearings and blades, the platform's reference point in
/// x and y, and pitch actuators, since 5.0.
pub(super) const BLOCKS: &[Block] = &[
    block(
        Some("SIMULATION CONTROL"),
        &[unread("Echo"), unread("Method"), unread("DT")],
    ),
    optional_section(
        "ENVIRONMENTAL CONDITION",
        &[record(
            "Gravity",
            "acceleration of gravity, m/s2",
            NON_NEGATIVE,
        )],
    ),
    block(
        Some("DEGREES OF FREEDOM"),
        &[
            record("FlapDOF1", "flag", Kind::Other),
            record("FlapDOF2", "flag", Kind::Other),
            record("EdgeDOF", "flag", Kind::Other),
        ],
    ),
    optional(&[record("PitchDOF", "flag", Kind::Other)]),
    block(
        None,
        &[
            record("TeetDOF", "flag", Kind::Other),
            record("DrTrDOF", "flag", Kind::Other),
            record("GenDOF", "flag", Kind::Other),
            record("YawDOF", "flag", Kind::Other),
            record("TwFADOF1", "flag", Kind::Other),
            record("TwFADOF2", "flag", Kind::Other),
            record("TwSSDOF1", "flag", Kind::Other),
            record("TwSSDOF2", "flag", Kind::Other),
            record("PtfmSgDOF", "flag", Kind::Other),
            record("PtfmSwDOF", "flag", Kind::Other),
            record("PtfmHvDOF", "flag", Kind::Other),
            record("PtfmRDOF", "flag", Kind::Other),
            record("PtfmPDOF", "flag", Kind::Other),
            record("PtfmYDOF", "flag", Kind::Other),
        ],
    ),
    block(
        Some("INITIAL CONDITIONS"),
        &[
            unread("OoPDefl"),
            unread("IPDefl"),
            record("BlPitch(1)", "blade pitch, degrees", HALF_TURN),
            record("BlPitch(2)", "blade pitch, degrees", HALF_TURN),
            record("BlPitch(3)", "blade pitch, degrees", HALF_TURN),
            unread("TeetDefl"),
            unread("Azimuth"),
            record("RotSpeed", "rotor speed, rpm", NON_NEGATIVE),
            unread("NacYaw"),
            unread("TTDspFA"),
            unread("TTDspSS"),
            unread("PtfmSurge"),
            unread("PtfmSway"),
            unread("PtfmHeave"),
            unread("PtfmRoll"),
            unread("PtfmPitch"),
            unread("PtfmYaw"),
        ],
    ),
    block(
        Some("TURBINE CONFIGURATION"),
        &[
            record("NumBl", "number of blades", Kind::Count(1)),
            record("TipRad", "radius of the blade tips, m", NON_NEGATIVE),
            record("HubRad", "radius of the blade roots, m", NON_NEGATIVE),
            record("PreCone(1)", "coning angle, degrees", ACUTE),
            record("PreCone(2)", "coning angle, degrees", ACUTE),
            record("PreCone(3)", "coning angle, degrees", ACUTE),
            record("HubCM", "offset of the hub, m", ANY),
            record("UndSling", "undersling, m", ANY),
            record("Delta3", "angle of the teeter pin, degrees", ACUTE),
            unread("AzimB1Up"),
            record("OverHang", "overhang, m", ANY),
            unread("ShftGagL"),
            record("ShftTilt", "shaft tilt, degrees", ACUTE),
            record("NacCMxn", "offset of the nacelle, m", ANY),
            record("NacCMyn", "offset of the nacelle, m", ANY),
            record("NacCMzn", "offset of the nacelle, m", ANY),
            unread("NcIMUxn"),
            unread("NcIMUyn"),
            unread("NcIMUzn"),
            record(
                "Twr2Shft",
                "height of the shaft above the tower top, m",
                ANY,
            ),
            record("TowerHt", "height of the tower top, m", ANY),
        ],
    ),
    optional(&[
        record("TwrRBHt", "length of the rigid base, m", ANY),
        record("TwrDraft", "depth of the platform, m", ANY),
    ]),
    instead_of(
        &["TwrRBHt", "TwrDraft"],
        &[record("TowerBsHt", "height of the tower base, m", ANY)],
    ),
    block(
        None,
        &[
            record("PtfmCMxt", "centre of the platform, m", ANY),
            record("PtfmCMyt", "centre of the platform, m", ANY),
            record("PtfmCMzt", "centre of the platform, m", ANY),
        ],
    ),
    optional(&[
        record("PtfmRefxt", "reference point of the platform, m", ANY),
        record("PtfmRefyt", "reference point of the platform, m", ANY),
    ]),
    optional(&[record("PtfmRef", "depth of the reference point, m", ANY)]),
    instead_of(
        &["PtfmRef"],
        &[record(
            "PtfmRefzt",
            "reference point of the platform, m",
            ANY,
        )],
    ),
    block(
        Some("MASS AND INERTIA"),
        &[
            record("TipMass(1)", "mass, kg", NON_NEGATIVE),
            record("TipMass(2)", "mass, kg", NON_NEGATIVE),
            record("TipMass(3)", "mass, kg", NON_NEGATIVE),
        ],
    ),
    optional(&[
        unread("PBrIner(1)"),
        unread("PBrIner(2)"),
        unread("PBrIner(3)"),
        unread("BlPIner(1)"),
        unread("BlPIner(2)"),
        unread("BlPIner(3)"),
    ]),
    block(
        None,
        &[
            record("HubMass", "mass, kg", NON_NEGATIVE),
            record("HubIner", "inertia, kg m2", NON_NEGATIVE),
        ],
    ),
    optional(&[record("HubIner_Teeter", "inertia, kg m2", NON_NEGATIVE)]),
    block(
        None,
        &[
            record("GenIner", "inertia, kg m2", NON_NEGATIVE),
            record("NacMass", "mass, kg", NON_NEGATIVE),
            record("NacYIner", "inertia, kg m2", NON_NEGATIVE),
            record("YawBrMass", "mass, kg", NON_NEGATIVE),
            record("PtfmMass", "mass, kg", NON_NEGATIVE),
            record("PtfmRIner", "inertia, kg m2", NON_NEGATIVE),
            record("PtfmPIner", "inertia, kg m2", NON_NEGATIVE),
            record("PtfmYIner", "inertia, kg m2", NON_NEGATIVE),
        ],
    ),
    optional(&[
        record("PtfmXYIner", "product of inertia, kg m2", ANY),
        record("PtfmYZIner", "product of inertia, kg m2", ANY),
        record("PtfmXZIner", "product of inertia, kg m2", ANY),
    ]),
    block(Some("BLADE"), &[]),
    optional(&[record(
        "BldNodes",
        "number of blade elements",
        Kind::Count(1),
    )]),
    block(
        None,
        &[
            record("BldFile(1)", "name of a blade file", Kind::Other),
            record("BldFile(2)", "name of a blade file", Kind::Other),
            record("BldFile(3)", "name of a blade file", Kind::Other),
        ],
    ),
    block(
        Some("ROTOR-TEETER"),
        &[
            unread("TeetMod"),
            unread("TeetDmpP"),
            unread("TeetDmp"),
            unread("TeetCDmp"),
            unread("TeetSStP"),
            unread("TeetHStP"),
            unread("TeetSSSp"),
            unread("TeetHSSp"),
        ],
    ),
    optional_section(
        "YAW-FRICTION",
        &[
            unread("YawFrctMod"),
            unread("M_CSmax"),
            unread("M_FCSmax"),
            unread("M_MCSmax"),
            unread("M_CD"),
            unread("M_FCD"),
            unread("M_MCD"),
            unread("sig_v"),
            unread("sig_v2"),
            unread("OmgCut"),
        ],
    ),
    block(
        Some("DRIVETRAIN"),
        &[
            unread("GBoxEff"),
            record("GBRatio", "gearbox ratio", ANY),
            record(
                "DTTorSpr",
                "torsional stiffness of the shaft, N m/rad",
                NON_NEGATIVE,
            ),
            unread("DTTorDmp"),
        ],
    ),
    block(
        Some("FURLING"),
        &[record("Furling", "flag", Kind::Other), unread("FurlFile")],
    ),
    block(
        Some("TOWER"),
        &[
            record("TwrNodes", "number of tower elements", Kind::Count(1)),
            record("TwrFile", "name of the tower file", Kind::Other),
        ],
    ),
];

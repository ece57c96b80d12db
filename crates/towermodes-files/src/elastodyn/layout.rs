//! The layouts that the main file of ElastoDyn has had, and which of them a file has.
//!
//! OpenFAST reads the file by position, each version in its own layout; the layouts differ in
//! blocks of lines that came or went (`ReadPrimaryFile` in `ElastoDyn_IO.f90` from FAST 8 to
//! OpenFAST 5.0). A file has the blocks whose names it says.

use std::collections::{BTreeMap, HashMap};

use super::names::{is_ruler, name_on, plain};
use super::positional::misplaced;
use crate::diagnostic::Diagnostic;
use crate::records::{Line, Lines};

/// Lines that stand together in every layout that has them.
struct Block {
    /// Which layouts have it.
    presence: Presence,
    /// The title of the section that it opens.
    heading: Option<&'static str>,
    keys: &'static [&'static str],
}

/// Which layouts have a block.
enum Presence {
    /// All.
    Always,
    /// Those that have one of its own names.
    IfSaid,
    /// Those that do not have these names, which stood in its place before.
    Unless(&'static [&'static str]),
}

const fn block(heading: Option<&'static str>, keys: &'static [&'static str]) -> Block {
    let presence = Presence::Always;
    Block {
        presence,
        heading,
        keys,
    }
}

const fn optional(keys: &'static [&'static str]) -> Block {
    let (presence, heading) = (Presence::IfSaid, None);
    Block {
        presence,
        heading,
        keys,
    }
}

const fn optional_section(heading: &'static str, keys: &'static [&'static str]) -> Block {
    let (presence, heading) = (Presence::IfSaid, Some(heading));
    Block {
        presence,
        heading,
        keys,
    }
}

/// Lines in the place of older ones.
const fn instead_of(old: &'static [&'static str], keys: &'static [&'static str]) -> Block {
    let (presence, heading) = (Presence::Unless(old), None);
    Block {
        presence,
        heading,
        keys,
    }
}

/// All blocks in order. Those that came or went: the heights of the tower's base and of the
/// platform's reference point, which ElastoDyn 1.00 has under other names; the number of blade
/// nodes, not in ElastoDyn 1.00 and 1.01; gravity, in the `.fst` file since OpenFAST 3.0; products
/// of inertia of the platform and yaw friction, since 4.0; the hub's inertia about the teeter axis,
/// since 4.2; inertias of pitch bearings and blades, the platform's reference point in x and y, and
/// pitch actuators, since 5.0.
const BLOCKS: &[Block] = &[
    block(Some("SIMULATION CONTROL"), &["Echo", "Method", "DT"]),
    optional_section("ENVIRONMENTAL CONDITION", &["Gravity"]),
    block(
        Some("DEGREES OF FREEDOM"),
        &["FlapDOF1", "FlapDOF2", "EdgeDOF"],
    ),
    optional(&["PitchDOF"]),
    block(
        None,
        &[
            "TeetDOF",
            "DrTrDOF",
            "GenDOF",
            "YawDOF",
            "TwFADOF1",
            "TwFADOF2",
            "TwSSDOF1",
            "TwSSDOF2",
            "PtfmSgDOF",
            "PtfmSwDOF",
            "PtfmHvDOF",
            "PtfmRDOF",
            "PtfmPDOF",
            "PtfmYDOF",
        ],
    ),
    block(
        Some("INITIAL CONDITIONS"),
        &[
            "OoPDefl",
            "IPDefl",
            "BlPitch(1)",
            "BlPitch(2)",
            "BlPitch(3)",
            "TeetDefl",
            "Azimuth",
            "RotSpeed",
            "NacYaw",
            "TTDspFA",
            "TTDspSS",
            "PtfmSurge",
            "PtfmSway",
            "PtfmHeave",
            "PtfmRoll",
            "PtfmPitch",
            "PtfmYaw",
        ],
    ),
    block(
        Some("TURBINE CONFIGURATION"),
        &[
            "NumBl",
            "TipRad",
            "HubRad",
            "PreCone(1)",
            "PreCone(2)",
            "PreCone(3)",
            "HubCM",
            "UndSling",
            "Delta3",
            "AzimB1Up",
            "OverHang",
            "ShftGagL",
            "ShftTilt",
            "NacCMxn",
            "NacCMyn",
            "NacCMzn",
            "NcIMUxn",
            "NcIMUyn",
            "NcIMUzn",
            "Twr2Shft",
            "TowerHt",
        ],
    ),
    optional(&["TwrRBHt", "TwrDraft"]),
    instead_of(&["TwrRBHt", "TwrDraft"], &["TowerBsHt"]),
    block(None, &["PtfmCMxt", "PtfmCMyt", "PtfmCMzt"]),
    optional(&["PtfmRefxt", "PtfmRefyt"]),
    optional(&["PtfmRef"]),
    instead_of(&["PtfmRef"], &["PtfmRefzt"]),
    block(
        Some("MASS AND INERTIA"),
        &["TipMass(1)", "TipMass(2)", "TipMass(3)"],
    ),
    optional(&[
        "PBrIner(1)",
        "PBrIner(2)",
        "PBrIner(3)",
        "BlPIner(1)",
        "BlPIner(2)",
        "BlPIner(3)",
    ]),
    block(None, &["HubMass", "HubIner"]),
    optional(&["HubIner_Teeter"]),
    block(
        None,
        &[
            "GenIner",
            "NacMass",
            "NacYIner",
            "YawBrMass",
            "PtfmMass",
            "PtfmRIner",
            "PtfmPIner",
            "PtfmYIner",
        ],
    ),
    optional(&["PtfmXYIner", "PtfmYZIner", "PtfmXZIner"]),
    block(Some("BLADE"), &[]),
    optional(&["BldNodes"]),
    block(None, &["BldFile(1)", "BldFile(2)", "BldFile(3)"]),
    block(
        Some("ROTOR-TEETER"),
        &[
            "TeetMod", "TeetDmpP", "TeetDmp", "TeetCDmp", "TeetSStP", "TeetHStP", "TeetSSSp",
            "TeetHSSp",
        ],
    ),
    optional_section(
        "YAW-FRICTION",
        &[
            "YawFrctMod",
            "M_CSmax",
            "M_FCSmax",
            "M_MCSmax",
            "M_CD",
            "M_FCD",
            "M_MCD",
            "sig_v",
            "sig_v2",
            "OmgCut",
        ],
    ),
    block(
        Some("DRIVETRAIN"),
        &["GBoxEff", "GBRatio", "DTTorSpr", "DTTorDmp"],
    ),
    block(Some("FURLING"), &["Furling", "FurlFile"]),
    block(Some("TOWER"), &["TwrNodes", "TwrFile"]),
];

/// What a line of a layout is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Entry {
    Heading(&'static str),
    Key(&'static str),
}

impl Entry {
    fn name(self) -> &'static str {
        match self {
            Self::Heading(name) | Self::Key(name) => name,
        }
    }
}

/// The entries of the layout that has some names.
fn layout(names: &[Option<&'static str>]) -> Vec<Entry> {
    let is_said = |key: &&'static str| names.contains(&Some(*key));
    let is_there = |block: &&Block| match block.presence {
        Presence::Always => true,
        Presence::IfSaid => block.keys.iter().any(is_said),
        Presence::Unless(old) => !old.iter().any(is_said),
    };
    let blocks = BLOCKS.iter().filter(is_there);
    let entries = blocks.flat_map(|block| {
        let heading = block.heading.map(Entry::Heading);
        heading
            .into_iter()
            .chain(block.keys.iter().copied().map(Entry::Key))
    });
    entries.collect()
}

/// More lines than any layout has need not be looked at.
const LONGEST: usize = 200;

/// Each parameter's line in a main file, up to the name of the tower file; two free lines come
/// first, blank ones count nowhere.
pub(super) fn lines_by_key(text: &str) -> Result<BTreeMap<&'static str, Line<'_>>, Diagnostic> {
    let mut all = Lines::new(text);
    all.expect("the first header line")?;
    all.expect("the second header line")?;
    let lines: Vec<Line<'_>> = all
        .clone()
        .filter(|line| !line.is_blank())
        .take(LONGEST)
        .collect();
    refuse_fast_7(&lines)?;
    let names: Vec<Option<&'static str>> = known_names(&lines);
    let layout = layout(&names);
    let is_said = |entry: &&Entry| matches!(entry, Entry::Key(key) if names.contains(&Some(*key)));
    let said = layout.iter().filter(is_said).count();
    if 2 * said < layout.len() {
        return Err(not_understood(said, &layout, &lines, &names));
    }
    let mut places = BTreeMap::new();
    for (index, entry) in layout.into_iter().enumerate() {
        let Some(line) = lines.get(index) else {
            return Err(all.ended(entry.name()));
        };
        check(entry, line, names[index])?;
        if let Entry::Key(key) = entry {
            places.insert(key, *line);
        }
    }
    Ok(places)
}

/// Which parameter each line says it is, if any.
fn known_names(lines: &[Line<'_>]) -> Vec<Option<&'static str>> {
    let keys = BLOCKS.iter().flat_map(|block| block.keys);
    let known: HashMap<String, &'static str> = keys.map(|key| (plain(key), *key)).collect();
    let name = |line| name_on(line).and_then(|name| known.get(&name).copied());
    lines.iter().map(name).collect()
}

/// That a line may be what its place says.
fn check(entry: Entry, line: &Line<'_>, name: Option<&'static str>) -> Result<(), Diagnostic> {
    match (entry, name) {
        (Entry::Key(key), Some(name)) if name != key => Err(misplaced(line, key, name)),
        (Entry::Heading(title), Some(name)) => {
            Err(misplaced(line, &format!("the heading {title}"), name))
        }
        (Entry::Key(key), None) if is_ruler(line) => {
            let message = format!("expected {key} here, but this is a heading");
            Err(Diagnostic::new(line.span(), message).with_hint("is a line missing above?"))
        }
        _ => Ok(()),
    }
}

/// The mistake that a file has too few of the names, at the first line that says another one.
fn not_understood(
    said: usize,
    layout: &[Entry],
    lines: &[Line<'_>],
    names: &[Option<&'static str>],
) -> Diagnostic {
    let is_key = |entry: &&Entry| matches!(entry, Entry::Key(_));
    let keys = layout.iter().filter(is_key).count();
    let mut pairs = layout.iter().zip(lines.iter().zip(names));
    let first = pairs.find_map(|(entry, (line, name))| match entry {
        Entry::Key(key) if *name != Some(*key) => Some((line.span(), *key)),
        _ => None,
    });
    let (span, key) = first.unwrap_or((0..0, "Echo"));
    let message = format!(
        "this is not understood as a main file of ElastoDyn: {said} of its {keys} parameters have a line with their name, and {key} is not on this one"
    );
    Diagnostic::new(span, message).with_hint(
        "main files of FAST 8 to OpenFAST 5 are read; each line is a value, its name and a description",
    )
}

/// Refuses a main file of FAST 7, which has most of the names in another order.
fn refuse_fast_7(lines: &[Line<'_>]) -> Result<(), Diagnostic> {
    let is_adams_prep = |line: &&Line<'_>| name_on(line).as_deref() == Some("adamsprep");
    let Some(line) = lines.iter().find(is_adams_prep) else {
        return Ok(());
    };
    let message = "this is a main file of FAST 7, which is not read: only FAST 7 has ADAMSPrep";
    let hint = "convert it to OpenFAST, or give its tower file alone with --tower-height";
    Err(Diagnostic::new(line.span(), message).with_hint(hint))
}

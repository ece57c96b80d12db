//! The options of MoorDyn: a value, then its name.

use std::ops::Range;

use super::column::plain;
use super::tables::Table;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::note::Note;
use crate::records::Token;
use crate::source::Source;

const DEPTH: [&str; 3] = ["wtrdpth", "depth", "waterdepth"];
const DENSITY: [&str; 5] = ["rhow", "rho", "wtrdnsty", "wtrdens", "waterdensity"];
const GRAVITY: [&str; 2] = ["g", "gravity"];
/// Friction on the seabed.
const FRICTION: [&str; 6] = ["mukt", "muka", "mut", "mua", "mu", "frictioncoefficient"];
/// Waves and current.
const WATER: [&str; 4] = ["waterkin", "wavekin", "currents", "current"];
/// The simulation in time, damping, seabed contact and output.
const TIME: [&str; 27] = [
    "dtm",
    "kbot",
    "kb",
    "cbot",
    "cb",
    "dtic",
    "icdt",
    "tmaxic",
    "ictmax",
    "cdscaleic",
    "icdfac",
    "threshic",
    "icthresh",
    "dtout",
    "mc",
    "cv",
    "inertialf",
    "inertialframpt",
    "outswitch",
    "writelog",
    "tscheme",
    "cfl",
    "fricdamp",
    "frictdamp",
    "icgendynamic",
    "fileic",
    "disableouttime",
];

/// The options that determine the mooring at rest.
#[derive(Debug, Default)]
pub(super) struct Options<'a> {
    pub(super) depth_m: Option<f64>,
    pub(super) density_kg_per_m3: Option<f64>,
    pub(super) gravity_m_per_s2: Option<f64>,
    /// The byte range of the heading, or of the depth.
    pub(super) span: Range<usize>,
    pub(super) notes: Vec<Note>,
    /// The options of the simulation in time, with the byte of their heading.
    pub(super) of_time: Vec<&'a str>,
    pub(super) heading: usize,
}

/// Reads the options.
pub(super) fn options<'a>(table: &Table<'a>, source: &Source) -> Result<Options<'a>, Diagnostic> {
    let mut found = Options {
        span: table.span.clone(),
        heading: table.span.start,
        ..Options::default()
    };
    for line in table.lines() {
        let mut tokens = line.tokens();
        let Some(value) = tokens.next() else { continue };
        let name = tokens.next();
        let name = name.map_or("", |name| name.text);
        let (key, place) = (plain(name), value.span.start);
        let is = |names: &[&str]| names.contains(&key.as_str());
        if is(&DEPTH) {
            found.depth_m = Some(depth(&value)?);
            found.span = value.span.clone();
        } else if is(&DENSITY) {
            found.density_kg_per_m3 = Some(value.number("rhoW (density of the water)")?);
        } else if is(&GRAVITY) {
            found.gravity_m_per_s2 = Some(value.number("g (gravity)")?);
        } else if is(&FRICTION) {
            found.notes.extend((!zero(&value)).then(|| {
                let message = format!("{name} ({}) is not used: friction of lines on the seabed depends on how they moved before", value.text);
                Note::left_out(message).at(source, place)
            }));
        } else if is(&WATER) {
            found.notes.extend((!zero(&value)).then(|| {
                let message = format!(
                    "{name} ({}) is not used: the water is still",
                    quoted(value.text)
                );
                Note::left_out(message).at(source, place)
            }));
        } else if is(&TIME) {
            found.of_time.push(name);
        } else {
            found.notes.push(unknown(&value, name)?.at(source, place));
        }
    }
    Ok(found)
}

/// The depth; the name of a file with depths is refused.
fn depth(value: &Token<'_>) -> Result<f64, Diagnostic> {
    let what = "WtrDpth (depth of the water)";
    let mistake = match value.number(what) {
        Ok(depth_m) if depth_m > 0.0 => return Ok(depth_m),
        Ok(depth_m) => {
            let kind = DiagnosticKind::out_of_range_in(what, depth_m, "m", "positive");
            return Err(value.wrong(kind));
        }
        Err(mistake) => mistake,
    };
    if !value.text.contains(|c: char| c.is_alphabetic() || c == '.') || value.text.len() < 4 {
        return Err(mistake);
    }
    let message = format!(
        "WtrDpth is {}: a seabed of varying depth (bathymetry) is not modelled",
        quoted(value.text)
    );
    let hint = "give the depth at the anchors as a number, in m";
    Err(value
        .wrong(DiagnosticKind::Unsupported(message))
        .with_hint(hint))
}

/// Whether a value switches its option off.
fn zero(value: &Token<'_>) -> bool {
    value.number("").is_ok_and(|value| value == 0.0)
}

/// The note on an unknown option, unless value and name are exchanged.
fn unknown(value: &Token<'_>, name: &str) -> Result<Note, Diagnostic> {
    let first = plain(value.text);
    let is_name = |names: &[&str]| names.contains(&first.as_str());
    if is_name(&DEPTH) || is_name(&DENSITY) || is_name(&GRAVITY) {
        let kind = DiagnosticKind::misplaced("the value of an option", quoted(value.text));
        let hint = format!("write the value before the name: `{name} {}`", value.text);
        return Err(value.wrong(kind).with_hint(hint));
    }
    let message = format!("the option {} is not known and not used", quoted(name));
    Ok(Note::suspicious(message))
}

//! The operating speeds of a model, which are given in the file of its controller.
//!
//! The `.fst` file names the file of ServoDyn, which names the input of a controller DLL
//! (`DLL_InFile`). The input of ROSCO, usually `DISCON.IN`, has lines of a value, an exclamation
//! mark and a name: `VS_MinOMSpd` and `PC_RefSpd`, the lowest and the rated speed of the generator
//! in rad/s, and `WE_GearboxRatio`.
//!
//! Source: Abbas et al., *A reference open-source controller for fixed and floating offshore wind
//! turbines*, Wind Energy Science 7 (2022).

use std::f64::consts::TAU;
use std::ops::Range;

use towermodes::Plain;
use towermodes::tower::Rpm;

use super::super::fst::switch;
use super::super::main_input::main_file::MainFile;
use super::super::names::line_of;
use crate::note::Note;
use crate::resolver::{FileResolver, beside};
use crate::source::Source;

/// Lowest and rated speed of the generator, rad/s, and the gearbox ratio, in the file of ROSCO.
const LOWEST: &str = "VS_MinOMSpd";
const RATED: &str = "PC_RefSpd";
const GEARBOX: &str = "WE_GearboxRatio";

/// The control mode of ServoDyn in which the DLL sets the torque of the generator.
const BY_DLL: i64 = 5;

/// Gearbox ratios that differ by more than this fraction count as different.
const SAME_RATIO: f64 = 1e-3;

/// The operating speeds from the files.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum OperatingSpeeds {
    /// The speeds are known.
    Known(Controlled),
    /// The speeds are unknown; the note states the reason.
    Unknown(Note),
}

/// The rotor speeds of a controller.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Controlled {
    /// The lowest and the highest rotor speed, rpm.
    pub(crate) rpm: [f64; 2],
    /// Notes on their source.
    pub(crate) notes: Vec<Note>,
    /// The file of the controller.
    pub(crate) source: Source,
    /// The place of the highest speed in this file.
    pub(crate) place: Range<usize>,
}

/// The operating speeds of the controller of an `.fst` file.
pub(crate) fn operating_speeds(
    fst: &Source,
    main: &MainFile,
    files: &dyn FileResolver,
) -> OperatingSpeeds {
    let found = controller_file(fst, files).and_then(|source| controlled(source, main));
    match found {
        Ok(controlled) => OperatingSpeeds::Known(controlled),
        Err(reason) => OperatingSpeeds::Unknown(reason),
    }
}

/// The input file of the controller DLL.
fn controller_file(fst: &Source, files: &dyn FileResolver) -> Result<Source, Note> {
    if let Some((0, at)) = switch(fst, "CompServo") {
        let message = "CompServo is 0: no controller sets the speed of the rotor, so its operating speeds are unknown";
        return Err(Note::assumption(message).at(fst, at));
    }
    let named = line_of(&fst.text, "ServoFile").and_then(|line| line.first());
    let named = named.ok_or_else(|| {
        let message = format!(
            "{} has no ServoFile, which refers to the controller: the operating speeds of the rotor are unknown",
            fst.name
        );
        Note::assumption(message)
    })?;
    let path = named.text.trim();
    let servo = files.read(path).map_err(|error| {
        let message = format!(
            "the file of ServoDyn, which names the controller, cannot be read ({error}): the operating speeds of the rotor are unknown"
        );
        Note::assumption(message).at(fst, named.span.start)
    })?;
    let folder = path.rfind(['/', '\\']).map_or("", |slash| &path[..slash]);
    in_servodyn(&servo, folder, files)
}

/// The controller file that a ServoDyn file in a folder names.
fn in_servodyn(servo: &Source, folder: &str, files: &dyn FileResolver) -> Result<Source, Note> {
    match switch(servo, "VSContrl") {
        Some((BY_DLL, _)) => {}
        Some((mode, at)) => {
            let message = format!(
                "VSContrl is {mode}, so no controller DLL (5) sets the speed of the rotor, and its operating speeds are unknown"
            );
            return Err(Note::assumption(message).at(servo, at));
        }
        None => {
            let message = format!(
                "{} has no VSContrl: the operating speeds of the rotor are unknown",
                servo.name
            );
            return Err(Note::assumption(message));
        }
    }
    let named = line_of(&servo.text, "DLL_InFile").and_then(|line| line.first());
    let named = named.ok_or_else(|| {
        let message = format!(
            "{} has no DLL_InFile, the input of the controller: the operating speeds of the rotor are unknown",
            servo.name
        );
        Note::assumption(message)
    })?;
    files
        .read(&beside(folder, named.text.trim()))
        .map_err(|error| {
            let message = format!(
                "the input of the controller (DLL_InFile) cannot be read ({error}): the operating speeds of the rotor are unknown"
            );
            Note::assumption(message).at(servo, named.span.start)
        })
}

/// The speeds in the input of a controller.
fn controlled(source: Source, main: &MainFile) -> Result<Controlled, Note> {
    let [lowest, rated] = [LOWEST, RATED].map(|name| value_of(&source, name));
    let (lowest, rated) = (lowest?, rated?);
    let mut notes = Vec::new();
    let ratio = gear_ratio(&source, main, &mut notes)?;
    let rpm = [&lowest, &rated].map(|speed| speed.number / ratio * 60.0 / TAU);
    if rpm[0] > rpm[1] {
        let message = format!(
            "{LOWEST} = {} rad/s is above {RATED} = {} rad/s: the operating speeds of the rotor are unknown",
            Plain(lowest.number),
            Plain(rated.number)
        );
        return Err(Note::suspicious(message).at(&source, lowest.span.start));
    }
    let message = format!(
        "operating speeds {} to {} rpm, from {LOWEST} = {} and {RATED} = {} rad/s of the generator with the gearbox ratio {}",
        Rpm(rpm[0]),
        Rpm(rpm[1]),
        Plain(lowest.number),
        Plain(rated.number),
        Plain(ratio)
    );
    notes.insert(0, Note::new(message).at(&source, rated.span.start));
    Ok(Controlled {
        rpm,
        notes,
        place: rated.span,
        source,
    })
}

/// The ratio of generator speed to rotor speed. The rotor of the model uses the ratio of ElastoDyn;
/// the controller may use another one.
fn gear_ratio(source: &Source, main: &MainFile, notes: &mut Vec<Note>) -> Result<f64, Note> {
    let of_model = main.gearbox_ratio.abs();
    let of_controller = entry(source, GEARBOX);
    if of_model == 0.0 {
        return value_of(source, GEARBOX).map(|value| value.number);
    }
    let Some(of_controller) = of_controller else {
        return Ok(of_model);
    };
    let differs = |value: f64| (value - of_model).abs() > SAME_RATIO * of_model;
    if of_controller.number().is_none_or(differs) {
        let message = format!(
            "{GEARBOX} is {}, but GBRatio of ElastoDyn is {}: the speeds of the rotor follow from GBRatio",
            of_controller.text,
            Plain(main.gearbox_ratio)
        );
        notes.push(Note::suspicious(message).at(source, of_controller.span.start));
    }
    Ok(of_model)
}

/// A positive number of the controller input.
struct Value {
    number: f64,
    span: Range<usize>,
}

/// The positive number with a name, or the reason why there is none.
fn value_of(source: &Source, name: &str) -> Result<Value, Note> {
    let Some(entry) = entry(source, name) else {
        let message = format!(
            "{} has no {name}, so it is not an input file of ROSCO: the operating speeds of the rotor are unknown",
            source.name
        );
        return Err(Note::assumption(message));
    };
    let number = entry.number().filter(|number| *number > 0.0);
    number
        .map(|number| Value {
            number,
            span: entry.span.clone(),
        })
        .ok_or_else(|| {
            let message = format!(
                "{name} is {}, not a number above 0: the operating speeds of the rotor are unknown",
                entry.text
            );
            Note::suspicious(message).at(source, entry.span.start)
        })
}

/// The value of a line and its place.
struct Entry<'a> {
    text: &'a str,
    span: Range<usize>,
}

impl Entry<'_> {
    /// The number; Fortran also writes powers of ten with a D.
    fn number(&self) -> Option<f64> {
        let number: f64 = self.text.replace(['d', 'D'], "e").parse().ok()?;
        number.is_finite().then_some(number)
    }
}

/// The line `value ! name - description` with a name.
fn entry<'a>(source: &'a Source, name: &str) -> Option<Entry<'a>> {
    let text = source.text.as_str();
    text.lines().find_map(|line| {
        let mut words = line.split_whitespace();
        let value = words.next().filter(|value| !value.starts_with('!'))?;
        let found = words
            .map(|word| word.trim_start_matches('!'))
            .find(|word| !word.is_empty())?;
        let start = value.as_ptr() as usize - text.as_ptr() as usize;
        found.eq_ignore_ascii_case(name).then(|| Entry {
            text: value,
            span: start..start + value.len(),
        })
    })
}

//! Reads measured frequencies and the input values to be fitted: the tables `[[measured]]` and
//! `[calibrate]` of a TOML file.

mod changes;
mod mode;
mod schema;
mod unknown;

use ::toml::de::DeTable;

use super::study_file::read_study;
use super::text::reading::Reading;
use super::text::table::{Table, every_table};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::measured::{MeasuredFile, MeasuredMode};
use crate::source::Source;
use schema::MEASURED_FILE;

pub use schema::measured_schema;

/// The minimum content of a calibration file.
const LEAST: &str = "measurements need at least [[measured]] with mode = \"fore-aft 1\", frequency and deviation in Hz";

/// Reads measured frequencies and the input values to be fitted from a TOML file.
///
/// # Errors
/// [`ReadError::Mistakes`] with all mistakes that were found.
///
/// # Example
/// ```
/// use towermodes_files::{Source, read_measured};
///
/// let text = r#"
///     [calibrate.unknowns]
///     "foundation.rocking" = { bounds = [1e9, 1e12] }
///     [[measured]]
///     mode = "fore-aft 1"
///     frequency = 0.2585
///     deviation = 0.001
/// "#;
/// let source = Source { name: "measured.toml".to_owned(), text: text.to_owned() };
/// let file = read_measured(&source)?;
/// assert_eq!(file.unknowns[0].name.value, "foundation.rocking");
/// assert_eq!(file.measured[0].frequency_hz, 0.2585);
/// # Ok::<(), towermodes_files::ReadError>(())
/// ```
pub fn read_measured(source: &Source) -> Result<MeasuredFile, ReadError> {
    let read = |root: &Table<'_>, reading: &mut Reading| file(root, source, reading);
    read_study(source, (LEAST, &MEASURED_FILE), other_file, read)
}

/// The mistake that the file describes a tower, or is a study.
fn other_file(entries: &DeTable<'_>) -> Option<Diagnostic> {
    if entries.contains_key("measured") {
        return None;
    }
    let others = [
        ("tower", "a tower file, not measured frequencies"),
        ("sweep", "a sweep study, not measured frequencies"),
        ("design", "a design file, not measured frequencies"),
    ];
    let (_, found) = others.iter().find(|(key, _)| entries.contains_key(*key))?;
    let found = (*found).to_owned();
    let mistake = Diagnostic::new(0..0, DiagnosticKind::WrongFile { found });
    Some(mistake.with_hint(LEAST))
}

fn file(root: &Table<'_>, source: &Source, reading: &mut Reading) -> Option<MeasuredFile> {
    let unknowns = unknown::unknowns(root, reading);
    let measured = measured(root, reading);
    Some(MeasuredFile {
        unknowns: unknowns?,
        measured: measured?,
        source: source.clone(),
    })
}

/// All `[[measured]]`; each mode may occur only once.
fn measured(root: &Table<'_>, reading: &mut Reading) -> Option<Vec<MeasuredMode>> {
    root.require("measured", LEAST, reading)?;
    let measured = every_table(root, "measured", "mode", reading, mode::mode)?;
    if measured.is_empty() {
        let what = "a measured frequency".to_owned();
        let mistake = Diagnostic::new(0..0, DiagnosticKind::Missing { what });
        return reading.refuse(mistake.with_hint(LEAST));
    }
    for (index, one) in measured.iter().enumerate() {
        let before = measured[..index].iter();
        let is_again = |other: &&MeasuredMode| one.mode.is_some() && other.mode == one.mode;
        if let (Some(mode), Some(_)) = (one.mode, before.rev().find(is_again)) {
            let what = format!("the measured mode `{mode}`");
            let kind = DiagnosticKind::Repeated { what, times: 2 };
            reading.mistake(Diagnostic::new(one.span.clone(), kind).with_hint(
                "give one frequency for each mode; combine several measurements of a mode into their weighted mean, with the standard deviation of this mean",
            ));
        }
    }
    Some(measured)
}

//! Reads a sweep study: the table `[sweep]` of a TOML file.

mod changes;
mod correlation;
mod distribution;
mod options;
mod results;
mod sampling;
mod schema;

use ::toml::de::DeTable;

use super::study_file::read_study;
use super::text::reading::Reading;
use super::text::table::Table;
use super::text::values::text;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::source::Source;
use crate::study::{Placed, SweepRows, SweepStudy};
use schema::{STUDY, SWEEP};

pub(super) use distribution::unquoted;
pub(super) use results::{method, mode_name, segments};
pub use schema::sweep_study_schema;

/// The minimum content of a study.
const LEAST: &str = "a sweep study needs [sweep] with base = \"tower.toml\", and table = \"values.csv\" or sampling with [sweep.vary]";

/// Reads a sweep study in TOML. The base and the table are not opened.
///
/// # Errors
/// [`ReadError::Mistakes`] with all mistakes that were found.
///
/// # Example
/// ```
/// use towermodes_files::{Source, SweepRows, read_sweep_study};
///
/// let text = r#"
///     [sweep]
///     base = "nrel-5mw.toml"
///     sampling = "sobol"
///     rows = 1_000_000
///     [sweep.vary]
///     "rna.mass" = { uniform = [3.3e5, 3.7e5] }
/// "#;
/// let source = Source { name: "study.toml".to_owned(), text: text.to_owned() };
/// let study = read_sweep_study(&source)?;
/// assert_eq!(study.base.value, "nrel-5mw.toml");
/// let SweepRows::Sampled { sampling, .. } = &study.rows else { unreachable!() };
/// assert_eq!(sampling.rows, 1_000_000);
/// # Ok::<(), towermodes_files::ReadError>(())
/// ```
pub fn read_sweep_study(source: &Source) -> Result<SweepStudy, ReadError> {
    let read = |root: &Table<'_>, reading: &mut Reading| study(root, source, reading);
    read_study(source, (LEAST, &STUDY), other_file, read)
}

/// The mistake that the file describes a tower.
fn other_file(entries: &DeTable<'_>) -> Option<Diagnostic> {
    if entries.contains_key("sweep") || !entries.contains_key("tower") {
        return None;
    }
    let found = "a tower file, not a sweep study".to_owned();
    let mistake = Diagnostic::new(0..0, DiagnosticKind::WrongFile { found });
    Some(mistake.with_hint(
        "give a table of values after it, as in `towermodes sweep tower.toml values.csv`, or a sweep study with [sweep]",
    ))
}

fn study(root: &Table<'_>, source: &Source, reading: &mut Reading) -> Option<SweepStudy> {
    let value = root.require("sweep", LEAST, reading)?;
    let sweep = Table::of(value, "[sweep]", &SWEEP, reading)?;
    let base = file_of(&sweep, "base", reading);
    let options = options::options(&sweep, reading);
    let results = results::results(&sweep, reading);
    let rows = rows(&sweep, reading);
    Some(SweepStudy {
        base: base?,
        reading: options?,
        rows: rows?,
        results: results?,
        source: source.clone(),
    })
}

/// A required path.
fn file_of(sweep: &Table<'_>, key: &str, reading: &mut Reading) -> Option<Placed<String>> {
    let hint = "the path of the base tower, in any format, relative to the study";
    let value = sweep.require(key, hint, reading)?;
    let path = text(value, key, reading)?;
    if path.trim().is_empty() {
        let kind = DiagnosticKind::Missing {
            what: format!("the path `{key}`"),
        };
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint));
    }
    Some(Placed {
        value: path.to_owned(),
        span: value.span(),
    })
}

/// The table with the values, or the rule by which they are drawn.
fn rows(sweep: &Table<'_>, reading: &mut Reading) -> Option<SweepRows> {
    match (sweep.get("table"), sweep.get("sampling")) {
        (None, _) => sampling::sampled(sweep, reading),
        (Some(_), None) => {
            let needless = ["rows", "seed", "vary", "correlation"];
            let beside = "together with `table`, which has the rows";
            refuse_keys(sweep, &needless, beside, reading);
            file_of(sweep, "table", reading).map(SweepRows::Table)
        }
        (Some(_), Some(_)) => {
            sweep.refuse_unused(
                "table",
                "together with `sampling`",
                "keep one of the two",
                reading,
            );
            None
        }
    }
}

/// Reports keys that have no effect.
pub(super) fn refuse_keys(table: &Table<'_>, keys: &[&str], because: &str, reading: &mut Reading) {
    for key in keys {
        table.refuse_unused(key, because, "remove it", reading);
    }
}

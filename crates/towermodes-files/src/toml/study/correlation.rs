//! `[[sweep.correlation]]`: which of the varied numbers depend on each other.

use std::ops::Range;

use super::super::reading::Reading;
use super::super::table::{Table, suggestion};
use super::super::values::{Value, every_row, list, number, text, wrong_kind};
use super::schema::CORRELATION;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::sampling::{Correlation, CorrelationError, Sampling, SamplingError};

const HINT: &str = "write [[sweep.correlation]] in double brackets, once for each pair";
const BETWEEN: &str = "between = [\"rna.mass\", \"rna.center[2]\"]";

/// The correlations in the order of the file, with their places.
pub(super) fn correlations(
    sweep: &Table<'_>,
    reading: &mut Reading,
) -> Option<(Vec<Correlation>, Vec<Range<usize>>)> {
    let Some(value) = sweep.get("correlation") else {
        return Some((Vec::new(), Vec::new()));
    };
    let Some(rows) = value.get_ref().as_array() else {
        let mistake = wrong_kind(value, "correlation", "a list of tables");
        return reading.refuse(mistake.with_hint(HINT));
    };
    let read = |_, row: &Value<'_>| Some((correlation(row, reading)?, row.span()));
    Some(every_row(rows, read)?.into_iter().unzip())
}

fn correlation(row: &Value<'_>, reading: &mut Reading) -> Option<Correlation> {
    let table = Table::of(row, CORRELATION.name, &CORRELATION, reading)?;
    let between = table.require("between", BETWEEN, reading);
    let between = between.and_then(|value| pair(value, reading));
    let coefficient = table.require("coefficient", "from -1 to 1", reading);
    let coefficient = coefficient.and_then(|value| number(value, "coefficient", reading));
    Some(Correlation {
        between: between?,
        coefficient: coefficient?,
    })
}

/// Two names.
fn pair(value: &Value<'_>, reading: &mut Reading) -> Option<[String; 2]> {
    let values = list(value, "between", reading)?;
    let names = every_row(values, |_, name| {
        text(name, "a name in `between`", reading).map(str::to_owned)
    })?;
    let count = names.len();
    <[String; 2]>::try_from(names).ok().or_else(|| {
        let kind = DiagnosticKind::WrongCount {
            what: "between".to_owned(),
            found: count,
            items: "names",
            expected: "2".to_owned(),
        };
        reading.refuse(Diagnostic::new(value.span(), kind).with_hint(BETWEEN))
    })
}

/// The mistake of a correlation at its place; an unknown name with the nearest one that varies.
pub(super) fn refused_pair(
    error: SamplingError,
    sampling: &Sampling,
    span: Range<usize>,
) -> Diagnostic {
    let unknown = match &error {
        SamplingError::Correlation { error, .. } => match &**error {
            CorrelationError::NotVaried { name } => Some(name),
            _ => None,
        },
        _ => None,
    };
    let hint = unknown.map(|name| {
        let names = sampling.vary.iter().map(|varied| varied.name.as_str());
        suggestion(name, &Vec::from_iter(names), "[sweep.vary] has")
    });
    let mistake = Diagnostic::new(span, DiagnosticKind::Sampling(error));
    match hint {
        Some(hint) => mistake.with_hint(hint),
        None => mistake,
    }
}

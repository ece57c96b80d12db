//! `[[sweep.correlation]]`: the correlated pairs of varied inputs.

use std::ops::Range;

use super::super::text::reading::Reading;
use super::super::text::table::{Table, suggestion};
use super::super::text::values::{Value, every_row, list, number, text, wrong_kind};
use super::schema::CORRELATION;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::sampling::{
    Correlation, CorrelationError, Distribution, Sampling, SamplingError, Varied,
};

const HINT: &str = "write [[sweep.correlation]] in double brackets, once for each pair";
const BETWEEN: &str = "between = [\"rna.mass\", \"rna.center[2]\"]";

/// A correlation with its place.
pub(super) struct Placed {
    pub(super) correlation: Correlation,
    pub(super) span: Range<usize>,
    /// Whether its coefficient is that of the values, as for normal inputs, instead of the scores.
    is_of_values: bool,
}

/// The correlations in the order of the file.
pub(super) fn correlations(sweep: &Table<'_>, reading: &mut Reading) -> Option<Vec<Placed>> {
    let Some(value) = sweep.get("correlation") else {
        return Some(Vec::new());
    };
    let Some(rows) = value.get_ref().as_array() else {
        let mistake = wrong_kind(value, "correlation", "a list of tables");
        return reading.refuse(mistake.with_hint(HINT));
    };
    every_row(rows, |_, row| correlation(row, reading))
}

fn correlation(row: &Value<'_>, reading: &mut Reading) -> Option<Placed> {
    let table = Table::of(row, CORRELATION.name, &CORRELATION, reading)?;
    let between = table.require("between", BETWEEN, reading);
    let between = between.and_then(|value| pair(value, reading));
    let is_of_values = !table.has("score_coefficient");
    let key = match is_of_values {
        true => "coefficient",
        false => {
            let because = "together with `score_coefficient`";
            table.refuse_unused("coefficient", because, "remove it", reading)?;
            "score_coefficient"
        }
    };
    let coefficient = table.require(key, "from -1 to 1", reading);
    let coefficient = coefficient.and_then(|value| number(value, key, reading));
    let correlation = Correlation {
        between: between?,
        coefficient: coefficient?,
    };
    let span = row.span();
    Some(Placed {
        correlation,
        span,
        is_of_values,
    })
}

/// The mistake of the first correlation of values, which requires two normal inputs, with an input
/// that is not normal.
pub(super) fn of_values(placed: &[Placed], vary: &[Varied]) -> Result<(), SamplingError> {
    let is_normal = |name: &str| {
        let varied = vary.iter().find(|varied| varied.name.trim() == name.trim());
        varied.is_some_and(|varied| {
            matches!(
                varied.distribution,
                Distribution::Normal {
                    truncated: None,
                    ..
                }
            )
        })
    };
    for (index, pair) in placed
        .iter()
        .enumerate()
        .filter(|(_, pair)| pair.is_of_values)
    {
        let mut names = pair.correlation.between.iter();
        if let Some(name) = names.find(|name| !is_normal(name)) {
            let name = name.trim().to_owned();
            return Err((index, CorrelationError::OfValues { name }).into());
        }
    }
    Ok(())
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

/// The mistake of a correlation at its place; for an unknown name with the nearest varied one.
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

//! `sampling`, `rows`, `seed` and `[sweep.vary]`.

use std::ops::Range;

use super::super::text::reading::Reading;
use super::super::text::table::{Table, suggestion};
use super::super::text::values::{Value, text, whole};
use super::correlation::{correlations, of_values, refused_pair};
use super::distribution::varied;
use super::refuse_keys;
use super::schema::VARY;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::sampling::{Sampling, SamplingError, SamplingKind, Varied};
use crate::study::SweepRows;

/// The rows of a sweep without a table.
pub(super) fn sampled(sweep: &Table<'_>, reading: &mut Reading) -> Option<SweepRows> {
    let hint = "sampling = \"grid\", \"latin-hypercube\", \"random\" or \"sobol\", or table = \"values.csv\"";
    let sampling = sweep.require("sampling", hint, reading);
    let kind = sampling.and_then(|value| kind(value, reading));
    let hint = "add [sweep.vary] with the varied inputs, for example \"rna.mass\" = { uniform = [3.3e5, 3.7e5] }";
    let vary_value = sweep.require("vary", hint, reading);
    let vary = vary_value.and_then(|value| vary(value, kind, reading));
    let (sampling, kind) = (sampling?, kind?);
    let seed = seed(sweep, kind, reading);
    let rows = rows(sweep, kind, reading);
    let correlations = correlations(sweep, reading);
    let (vary_value, (vary, spans)) = (vary_value?, vary?);
    let correlations = correlations?;
    let rows = match rows? {
        Some(rows) => rows,
        // A grid of too many rows is refused below.
        None => Sampling::grid_rows(&vary).unwrap_or(1),
    };
    let (seed, of_kind) = (seed?, sampling.span());
    let sampling = Sampling {
        kind,
        rows,
        seed,
        vary,
        correlations: correlations
            .iter()
            .map(|one| one.correlation.clone())
            .collect(),
    };
    let checked = sampling.check();
    if let Err(error) = checked.and_then(|()| of_values(&correlations, &sampling.vary)) {
        if let SamplingError::Correlation { index, .. } = error {
            let span = correlations[index].span.clone();
            return reading.refuse(refused_pair(error, &sampling, span));
        }
        let span = place_of(&error, &sampling, &spans, sweep, of_kind, vary_value.span());
        return reading.refuse(Diagnostic::new(span, DiagnosticKind::Sampling(error)));
    }
    Some(SweepRows::Sampled {
        sampling,
        spans,
        correlation_spans: correlations.into_iter().map(|one| one.span).collect(),
    })
}

/// The place of a mistake in the whole sampling.
fn place_of(
    error: &SamplingError,
    sampling: &Sampling,
    spans: &[Range<usize>],
    sweep: &Table<'_>,
    of_kind: Range<usize>,
    of_vary: Range<usize>,
) -> Range<usize> {
    let of_rows = || sweep.get("rows").map(Value::span);
    let found = match error {
        SamplingError::TooManyForSobol { .. } => Some(of_kind),
        SamplingError::Rows { .. } | SamplingError::GridRows { .. } => of_rows(),
        SamplingError::NoLevels { name, .. } => {
            let index = sampling.vary.iter().position(|one| one.name == *name);
            index.and_then(|index| spans.get(index).cloned())
        }
        _ => None,
    };
    found.unwrap_or(of_vary)
}

/// The kind of sampling by its name.
fn kind(value: &Value<'_>, reading: &mut Reading) -> Option<SamplingKind> {
    let name = text(value, "sampling", reading)?;
    let kind = SamplingKind::ALL
        .into_iter()
        .find(|kind| kind.name() == name);
    kind.or_else(|| {
        let names = SamplingKind::ALL.map(SamplingKind::name);
        let hint = suggestion(name, &names, "there are");
        let what = "sampling";
        let kind = DiagnosticKind::UnknownName {
            what,
            name: name.to_owned(),
        };
        reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
    })
}

/// The seed, 0 by default.
fn seed(sweep: &Table<'_>, kind: SamplingKind, reading: &mut Reading) -> Option<u64> {
    if kind == SamplingKind::Grid {
        refuse_keys(sweep, &["seed"], "with sampling = \"grid\"", reading);
    }
    match sweep.get("seed") {
        None => Some(0),
        Some(value) => whole(value, "seed", 0, reading),
    }
}

/// The number of rows; `Some(None)` for a grid without it.
fn rows(sweep: &Table<'_>, kind: SamplingKind, reading: &mut Reading) -> Option<Option<u64>> {
    let value = match sweep.get("rows") {
        None if kind == SamplingKind::Grid => return Some(None),
        _ => sweep.require("rows", "number of rows, as rows = 1_000", reading)?,
    };
    whole(value, "rows", 1, reading).map(Some)
}

/// The varied inputs, in the order of the lines, with the places of the names.
fn vary(
    value: &Value<'_>,
    kind: Option<SamplingKind>,
    reading: &mut Reading,
) -> Option<(Vec<Varied>, Vec<Range<usize>>)> {
    let table = Table::with_any_keys(value, VARY.name, reading)?;
    let mut entries: Vec<_> = table.placed_entries().collect();
    entries.sort_by_key(|(_, span, _)| span.start);
    let read: Vec<Option<(Varied, Range<usize>)>> = entries
        .into_iter()
        .map(|(name, span, value)| Some((varied(name, &span, value, kind, reading)?, span)))
        .collect();
    let read: Option<Vec<_>> = read.into_iter().collect();
    Some(read?.into_iter().unzip())
}

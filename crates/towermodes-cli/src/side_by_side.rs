//! All methods on one tower, for the report and the picture of errors.

use towermodes::{Method, Options, SolveError, Tower};
use towermodes_analysis::study::{
    COMPARED_SEGMENTS, ColumnSpec, Comparison, all_methods as columns_of, compare_all_methods,
};

use crate::progress::Progress;

/// Compares all methods and shows the progress.
pub(crate) fn all_methods(
    tower: &Tower,
    options: &Options,
    segments: Option<usize>,
) -> Result<Comparison, SolveError> {
    let segments = segments.unwrap_or(COMPARED_SEGMENTS);
    let progress = Progress::of(columns_in_words(&columns_of(segments)));
    let mut solver = progress.solver(options.clone());
    compare_all_methods(tower, segments, &mut solver, |_, _| progress.done())
}

/// The names of the computations for the progress line; the reference solution is computed before
/// the first column.
pub(crate) fn columns_in_words(columns: &[ColumnSpec]) -> Vec<String> {
    let name = |spec: &ColumnSpec| match spec.segments {
        Some(segments) => format!("{} {segments}", spec.method.name()),
        None => spec.method.name().to_owned(),
    };
    let mut names: Vec<String> = columns.iter().map(name).collect();
    if let Some(first) = names.first_mut() {
        *first = format!("{}, {first}", Method::Spectral.name());
    }
    names
}

#[cfg(test)]
mod tests {
    use towermodes::Method;
    use towermodes_analysis::study::ColumnSpec;

    use super::columns_in_words;

    #[test]
    fn what_is_at_work_is_named() {
        let column = |method, segments| ColumnSpec { method, segments };
        let columns = [
            column(Method::RmjeExact, Some(60)),
            column(Method::Spectral, None),
        ];
        assert_eq!(
            columns_in_words(&columns),
            ["spectral, rmje-exact 60", "spectral"]
        );
        assert!(columns_in_words(&[]).is_empty());
    }
}

//! Pictures of the convergence of a method and of the comparison of methods.

use towermodes::{MAX_SEGMENTS, Method, Options, Tower};
use towermodes_analysis::study::{Comparison, Convergence, Fineness, Level, converge_with};
use towermodes_report::figures;

use super::Drawn;
use crate::args::{DEFAULT_DEGREES, DEFAULT_SEGMENTS, PlotArguments};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::side_by_side::all_methods;

/// Minimum number of levels that show an order.
const FEWEST_LEVELS: usize = 4;

/// The error of a method over the number of segments.
pub(super) fn convergence(tower: &Tower, arguments: &PlotArguments) -> Result<Drawn, Failure> {
    let options = arguments.study_options();
    // The numbers must increase, each only once.
    let mut given = arguments.segments().to_vec();
    given.sort_unstable();
    given.dedup();
    let mut convergence = match (options.method, &given[..]) {
        (Method::Spectral, _) => solved(tower, &options, &DEFAULT_DEGREES.map(Fineness::Degree))?,
        (_, []) => by_default(tower, &options)?,
        _ => solved(tower, &options, &listed(&given))?,
    };
    if options.method != Method::Spectral {
        each_once(&mut convergence);
    }
    let figure = figures::convergence(&convergence);
    let drawn = Drawn::new(figure, &convergence.warnings);
    Ok(drawn.computed(levels_in_words(&convergence)))
}

fn listed(segments: &[usize]) -> Vec<Fineness> {
    segments.iter().copied().map(Fineness::Segments).collect()
}

/// With the numbers of segments of `converge`, or with the minimum number of the tower and its
/// doubles.
fn by_default(tower: &Tower, options: &Options) -> Result<Convergence, Failure> {
    let mut convergence = solved(tower, options, &listed(&DEFAULT_SEGMENTS))?;
    each_once(&mut convergence);
    let fewest = convergence.levels.first().map_or(1, |level| level.segments);
    if convergence.levels.len() >= FEWEST_LEVELS {
        return Ok(convergence);
    }
    let doubled = std::iter::successors(Some(fewest), |segments| Some(2 * segments));
    let doubled: Vec<usize> = doubled
        .take(FEWEST_LEVELS)
        .take_while(|segments| *segments <= MAX_SEGMENTS)
        .collect();
    solved(tower, options, &listed(&doubled))
}

/// Removes levels with equal meshes: a tower with many parts has a minimum number of segments.
fn each_once(convergence: &mut Convergence) {
    for level in &mut convergence.levels {
        level.asked = Fineness::Segments(level.segments);
    }
    convergence.levels.dedup_by_key(|level| level.segments);
}

fn solved(tower: &Tower, options: &Options, fineness: &[Fineness]) -> Result<Convergence, Failure> {
    let piece = |fineness: &Fineness| (fineness.number().to_string(), fineness.number() as f64);
    let progress = Progress::of_weighted(fineness.iter().map(piece));
    let mut workspace = progress.workspace();
    let convergence = converge_with(tower, options, fineness, &mut workspace, |_| {
        progress.done();
    });
    convergence.map_err(Failure::Unsolved)
}

/// The difference of each method from the reference solution.
pub(super) fn error(tower: &Tower, arguments: &PlotArguments) -> Result<Drawn, Failure> {
    let segments = arguments.segments().first().copied();
    let comparison = all_methods(tower, &arguments.study_options(), segments);
    let comparison = comparison.map_err(Failure::Unsolved)?;
    let figure = figures::error(&comparison);
    let drawn = Drawn::new(figure, &comparison.warnings);
    Ok(drawn.computed(segments_in_words(&comparison)))
}

/// "10 to 320 segments, relative to the reference solution".
fn levels_in_words(convergence: &Convergence) -> String {
    let numbers = convergence.levels.iter().map(|level| level.asked.number());
    let is_degree = |level: &Level| matches!(level.asked, Fineness::Degree(_));
    let levels = match convergence.levels.first().is_some_and(is_degree) {
        true => format!("degrees {}", range(numbers)),
        false => format!("{} segments", range(numbers)),
    };
    let rotary = match convergence.rotary_inertia {
        true => "",
        false => " without rotary inertia",
    };
    format!("{levels}, relative to the reference solution{rotary}")
}

/// "60 segments", of all methods except `spectral`.
fn segments_in_words(comparison: &Comparison) -> String {
    let columns = comparison.columns.iter();
    let others = columns.filter(|column| column.method != Method::Spectral);
    format!("{} segments", range(others.map(|column| column.segments)))
}

/// "60", "10 to 320".
fn range(numbers: impl Iterator<Item = usize> + Clone) -> String {
    match (numbers.clone().min(), numbers.max()) {
        (Some(least), Some(most)) if least < most => format!("{least} to {most}"),
        (least, _) => least.unwrap_or(0).to_string(),
    }
}

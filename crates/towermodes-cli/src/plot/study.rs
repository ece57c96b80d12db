//! The pictures of methods: as their segments get more, and side by side.

use towermodes::{MAX_SEGMENTS, Method, Options, Tower};
use towermodes_analysis::study::{Comparison, Convergence, Fineness, Level, converge_with};
use towermodes_report::figures;

use super::Drawn;
use crate::args::{DEFAULT_DEGREES, DEFAULT_SEGMENTS, PlotArguments};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::side_by_side::all_methods;

/// A line through fewer numbers of segments shows no order.
const FEWEST_LEVELS: usize = 4;

/// How the error of a method falls.
pub(super) fn convergence(tower: &Tower, arguments: &PlotArguments) -> Result<Drawn, Failure> {
    let options = arguments.study_options();
    // A line has one direction, and each place once.
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

/// With the segments that `converge` has, or with the fewest that the tower can have and twice as
/// many again and again.
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

/// A tower of many pieces has a fewest number of segments: whatever is below it is the same, and is
/// shown as what it is.
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

/// How far each method is from the exact beam.
pub(super) fn error(tower: &Tower, arguments: &PlotArguments) -> Result<Drawn, Failure> {
    let segments = arguments.segments().first().copied();
    let comparison = all_methods(tower, &arguments.study_options(), segments);
    let comparison = comparison.map_err(Failure::Unsolved)?;
    let figure = figures::error(&comparison);
    let drawn = Drawn::new(figure, &comparison.warnings);
    Ok(drawn.computed(segments_in_words(&comparison)))
}

/// "10 to 320 segments, against the spectral beam".
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
    format!("{levels}, against the spectral beam{rotary}")
}

/// "60 segments", of all methods but the spectral beam.
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

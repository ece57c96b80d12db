//! Pictures of the convergence of a method and of the comparison of methods.

use towermodes::{Method, Options, Tower};
use towermodes_analysis::study::{
    Convergence, Fineness, STUDY_DEGREES, converge, converge_by_default,
};
use towermodes_report::figures;
use towermodes_report::wording::{compared_segments, levels};

use super::{Drawn, PlotArguments};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::side_by_side::all_methods;

/// The error of a method over the number of segments.
pub(super) fn convergence(tower: &Tower, arguments: &PlotArguments) -> Result<Drawn, Failure> {
    let options = arguments.study_options();
    // The numbers must increase, each only once.
    let mut given = arguments.segments().to_vec();
    given.sort_unstable();
    given.dedup();
    let study = |fineness: &[Fineness]| solved(tower, &options, fineness);
    let convergence = match (options.method, &given[..]) {
        (Method::Spectral, _) => study(&STUDY_DEGREES.map(Fineness::Degree))?,
        (_, []) => converge_by_default(study)?,
        _ => {
            let given: Vec<Fineness> = given.into_iter().map(Fineness::Segments).collect();
            let mut convergence = study(&given)?;
            convergence.remove_equal_meshes();
            convergence
        }
    };
    let figure = figures::convergence(&convergence);
    let drawn = Drawn::new(figure, &convergence.warnings);
    Ok(drawn.computed(levels(&convergence)))
}

fn solved(tower: &Tower, options: &Options, fineness: &[Fineness]) -> Result<Convergence, Failure> {
    let piece = |fineness: &Fineness| (fineness.number().to_string(), fineness.number() as f64);
    let progress = Progress::of_weighted(fineness.iter().map(piece));
    let mut solver = progress.solver(options.clone());
    let convergence = converge(tower, fineness, &mut solver, |_| progress.done());
    convergence.map_err(Failure::from)
}

/// The difference of each method from the reference solution.
pub(super) fn error(tower: &Tower, arguments: &PlotArguments) -> Result<Drawn, Failure> {
    let segments = arguments.segments().first().copied();
    let comparison = all_methods(tower, &arguments.study_options(), segments)?;
    let figure = figures::error(&comparison);
    let drawn = Drawn::new(figure, &comparison.warnings);
    Ok(drawn.computed(compared_segments(&comparison)))
}

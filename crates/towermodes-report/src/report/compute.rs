//! The computation of a report: modes, resonance, methods compared.

use thiserror::Error;
use towermodes::turbine::Turbine;
use towermodes::{
    BladeDescription, Options, Rotor, SensitivityError, Solution, SolveError, Solver, Tower,
    TowerDescription,
};
use towermodes_analysis::influence::{Influences, influences};
use towermodes_analysis::resonance::{
    Assessment, Campbell, CampbellError, CampbellOptions, assess, reach_hz, solve_to_reach,
    unknown_speeds,
};
use towermodes_analysis::soil_band::{SoilBand, SoilBandError, soil_band};
use towermodes_analysis::study::{Comparison, compare_all_methods};
use towermodes_analysis::whirl::{
    CoupledError, CoupledOptions, RotorSpeeds, coupled_campbell, coupled_limit_hz,
};

use super::content::{Circumstances, ElastoDynShapes, ReportContent, TurbineResults};

/// The input of a report.
#[derive(Debug, Clone)]
pub struct ReportRequest {
    /// The description of the tower.
    pub description: TowerDescription,
    /// The validated tower.
    pub tower: Tower,
    /// The options of the solution.
    pub options: Options,
    /// Whether more modes are solved until they cover the excitations of the rotor.
    pub covers_excitations: bool,
    /// The rotor; none if its speed is unknown.
    pub rotor: Option<Rotor>,
    /// The number of blades, if the input gives it without the speed: then there is a diagram
    /// without verdicts.
    pub blades: Option<usize>,
    /// One of the blades, if the input describes it.
    pub blade: Option<BladeDescription>,
    /// The whole turbine, if the input describes it.
    pub turbine: Option<Turbine>,
    /// The options of the resonance check.
    pub campbell: CampbellOptions,
    /// The factors of the soil stiffness for which frequencies are given too; none for a report
    /// without this section.
    pub soil_factors: Option<Vec<f64>>,
    /// Whether the report has a section on the influence of the input values on the frequencies.
    pub sensitivities: bool,
    /// Number of segments of each method in the comparison of methods.
    pub compared_segments: usize,
    /// The shapes for ElastoDyn, or the reason why there are none.
    pub elastodyn: Result<ElastoDynShapes, String>,
    /// Height at which the shapes for ElastoDyn begin, m.
    pub shapes_from_m: f64,
    /// The data that are not results; the remarks of the resonance check are added to its notes.
    pub circumstances: Circumstances,
    /// The notes on the shapes for ElastoDyn, which follow the other notes.
    pub notes_on_shapes: Vec<String>,
}

/// The long computations of a report. A program that reports their progress implements them itself.
pub trait Computation {
    /// A solver for a tower.
    fn solver(&self, options: Options) -> Solver {
        Solver::new(options)
    }

    /// Compares all methods with a number of segments.
    ///
    /// # Errors
    /// As [`compare_all_methods`].
    fn compare(
        &self,
        tower: &Tower,
        options: &Options,
        segments: usize,
    ) -> Result<Comparison, SolveError> {
        let mut solver = Solver::new(options.clone());
        compare_all_methods(tower, segments, &mut solver, |_, _| ())
    }
}

/// The computations without progress reports.
#[derive(Debug, Clone, Copy, Default)]
pub struct SilentComputation;

impl Computation for SilentComputation {}

/// A report that cannot be computed.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ContentError {
    /// The tower cannot be solved.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// The rotor or its options are invalid.
    #[error(transparent)]
    Campbell(#[from] CampbellError),
    /// A factor of the soil stiffness is out of range, or the tower has no soil.
    #[error(transparent)]
    SoilBand(#[from] SoilBandError),
}

impl ReportContent {
    /// Computes the results of a report. The comparison of methods and the shapes for ElastoDyn may
    /// be missing in it; then it gives the reason.
    ///
    /// # Errors
    /// [`ContentError`]: the tower cannot be solved, or rotor or options are invalid.
    pub fn compute(
        mut request: ReportRequest,
        computation: &impl Computation,
    ) -> Result<Self, ContentError> {
        take_unknown_speeds(&mut request, computation)?;
        let solution = solved(&mut request, computation)?;
        let (campbell, remarks) = assessed(&request, &solution)?.unzip();
        let turbine = turbine_of(&mut request, &solution);
        let soil_band = soil_band_of(&request, &solution, computation).transpose()?;
        let mut circumstances = request.circumstances;
        let remarks = remarks.into_iter().flatten();
        let remarks = remarks.chain(request.notes_on_shapes);
        circumstances.notes.extend(remarks);
        if let Some(Ok(results)) = &turbine {
            let remarks = remarks_on(results, &circumstances.notes);
            circumstances.notes.extend(remarks);
        }
        let (tower, options) = (request.tower, request.options);
        let description = &request.description;
        let influences = request
            .sensitivities
            .then(|| influences_of_lowest(description, &options));
        Ok(Self {
            comparison: computation.compare(&tower, &options, request.compared_segments),
            description: request.description,
            tower,
            options,
            solution,
            influences,
            turbine,
            soil_band,
            campbell: campbell.map(Ok),
            elastodyn: request.elastodyn,
            shapes_from_m: request.shapes_from_m,
            circumstances,
        })
    }
}

/// Replaces unknown operating speeds by the ends of a diagram without verdicts.
fn take_unknown_speeds(
    request: &mut ReportRequest,
    computation: &impl Computation,
) -> Result<(), SolveError> {
    let Some(blades) = request.blades.filter(|_| request.rotor.is_none()) else {
        return Ok(());
    };
    let mut solver = computation.solver(request.options.clone());
    let solution = solver.solve_certain(&request.tower)?;
    let of_turbine = request.turbine.as_ref().map(|of| &of.machine().blade);
    let radius_m = of_turbine
        .or(request.blade.as_ref())
        .map(|of| of.tip_radius_m);
    request.rotor = Some(unknown_speeds(blades, &solution, radius_m));
    request.campbell.speeds_are_known = false;
    Ok(())
}

/// The whole turbine at its rotor speeds, up to the limit of `campbell`.
fn turbine_of(
    request: &mut ReportRequest,
    solution: &Solution,
) -> Option<Result<TurbineResults, CoupledError>> {
    let rotor = request.rotor?;
    let turbine = request.turbine.take()?;
    let given = &request.campbell;
    let options = CoupledOptions {
        margin: given.margin,
        multiples: given.multiples.clone(),
        speeds: RotorSpeeds::Equal(given.speeds),
        speeds_are_known: given.speeds_are_known,
        ..CoupledOptions::up_to(coupled_limit_hz(&rotor, given, solution, &turbine))
    };
    let coupled = coupled_campbell(&turbine, &rotor, &options, |_| ());
    Some(coupled.map(|coupled| TurbineResults {
        against: coupled.against(solution),
        turbine,
        coupled,
    }))
}

/// The remarks on a turbine that are not among those in `said`.
fn remarks_on(results: &TurbineResults, said: &[String]) -> Vec<String> {
    let remarks = results.coupled.remarks(&results.turbine).into_iter();
    let remarks = remarks.map(|remark| remark.to_string());
    remarks.filter(|remark| !said.contains(remark)).collect()
}

/// The modes for softer and stiffer soil, if they are requested.
fn soil_band_of(
    request: &ReportRequest,
    solution: &Solution,
    computation: &impl Computation,
) -> Option<Result<SoilBand, SoilBandError>> {
    let is_whole = request.tower.missing_parts().is_none();
    let rotor = request
        .rotor
        .as_ref()
        .filter(|_| is_whole && request.campbell.speeds_are_known)
        .map(|rotor| (rotor, &request.campbell));
    let factors = request.soil_factors.as_ref()?;
    // No shapes are shown.
    let options = Options {
        points: 2,
        ..request.options.clone()
    };
    Some(soil_band(
        &request.description,
        solution,
        factors,
        rotor,
        |tower| computation.solver(options.clone()).solve_certain(tower),
    ))
}

/// The influence of every input value on the lowest modes.
fn influences_of_lowest(
    description: &TowerDescription,
    options: &Options,
) -> Result<Influences, SensitivityError> {
    let options = Options {
        modes: options.modes.min(INFLUENCED_MODES),
        ..options.clone()
    };
    influences(description, None, &mut Solver::new(options))
}

/// Number of modes whose derivatives a report contains.
const INFLUENCED_MODES: usize = 4;

/// Solves for the requested number of modes, and if requested for more until they cover the
/// excitations; the options then contain the number of modes.
fn solved(
    request: &mut ReportRequest,
    computation: &impl Computation,
) -> Result<Solution, SolveError> {
    let tower = &request.tower;
    let mut solver = computation.solver(request.options.clone());
    let solution = match request.rotor.filter(|_| request.covers_excitations) {
        Some(rotor) => solve_to_reach(&mut solver, tower, reach_hz(&rotor, &request.campbell)),
        None => solver.solve_certain(tower),
    };
    request.options.modes = solver.options.modes;
    solution
}

/// The Campbell diagram with its remarks; none without a rotor.
fn assessed(
    request: &ReportRequest,
    solution: &Solution,
) -> Result<Option<(Campbell, Vec<String>)>, CampbellError> {
    let Some(rotor) = &request.rotor else {
        return Ok(None);
    };
    let blade = request.blade.as_ref();
    let Assessment { campbell, remarks } =
        assess(&request.tower, solution, blade, rotor, &request.campbell)?;
    let remarks = remarks.iter().map(ToString::to_string).collect();
    Ok(Some((campbell, remarks)))
}

//! `towermodes plot --what soil` and `--what scour`.

use towermodes::{Rotor, Solution, Tower, TowerDescription};
use towermodes_analysis::soil_band::{scour_curve, soil_band};
use towermodes_files::{Note, TowerInput};
use towermodes_report::figures;
use towermodes_report::wording::computed_by;

use super::{Drawn, PlotArguments, options};
use crate::failure::Failure;
use crate::progress::solve;

/// Powers of √2 from a quarter to four.
fn factors() -> Vec<f64> {
    (-4..=4)
        .map(|half| 2_f64.powf(0.5 * f64::from(half)))
        .collect()
}

/// The number of depths of scour, including zero.
const DEPTHS: usize = 9;
/// The largest depth of scour, in diameters of the pile.
const DEEPEST_DIAMETERS: f64 = 2.0;

/// First bending frequencies against the stiffness of the soil.
pub(super) fn stiffness(
    input: &mut TowerInput,
    tower: &Tower,
    arguments: &PlotArguments,
) -> Result<Drawn, Failure> {
    let options = options(input, arguments)?;
    let description = &input.description;
    if !description.stands_in_soil() {
        return Err(Failure::usage(
            "--what soil needs soil: the base of the tower is clamped or floats, and there are no soil springs",
        ));
    }
    let solution = solve(tower, &options)?;
    let each = |tower: &Tower| solve(tower, &options);
    let band = soil_band(description, &solution, &factors(), None, each);
    let band = band.map_err(Failure::failed)?;
    let (rotor, margin) = rotor(input, arguments);
    let figure = figures::soil(&band, rotor.as_ref().map(|rotor| (rotor, margin)));
    let failed = band.failed.iter();
    let failed = failed.map(|at| format!("with soil x {:.3}: {}", at.factor, at.reason));
    Ok(drawn(figure, &solution, failed))
}

/// First bending frequencies against the depth of scour.
pub(super) fn scour(
    input: &mut TowerInput,
    tower: &Tower,
    arguments: &PlotArguments,
) -> Result<Drawn, Failure> {
    let options = options(input, arguments)?;
    let description = &input.description;
    let Some(diameter_m) = description.pile_diameter_m() else {
        return Err(Failure::usage(
            "--what scour needs soil in layers around the pile: [ground] in the tower file",
        ));
    };
    let solution = solve(tower, &options)?;
    let step_m = DEEPEST_DIAMETERS * diameter_m / (DEPTHS - 1) as f64;
    let mut depths_m: Vec<f64> = (0..DEPTHS).map(|step| step as f64 * step_m).collect();
    depths_m.extend(boundaries(description, DEEPEST_DIAMETERS * diameter_m));
    depths_m.sort_by(f64::total_cmp);
    depths_m.dedup();
    let each = |tower: &Tower| solve(tower, &options);
    let Some(curve) = scour_curve(description, &solution, &depths_m, each) else {
        return Err(Failure::failed(
            "the tower has no soil in layers".to_owned(),
        ));
    };
    let (rotor, margin) = rotor(input, arguments);
    let figure = figures::scour(&curve, rotor.as_ref().map(|rotor| (rotor, margin)));
    let failed = curve.failed.iter();
    let failed = failed.map(|(depth_m, why)| format!("with scour of {depth_m:.2} m: {why}"));
    Ok(drawn(figure, &solution, failed))
}

/// The depths of local scour that reach the top of a layer, at which the frequencies change their
/// slope.
fn boundaries(description: &TowerDescription, deepest_m: f64) -> Vec<f64> {
    let Some(ground) = &description.ground else {
        return Vec::new();
    };
    let surface_m = ground.surface_m - ground.scour.general_m;
    let depths_m = ground.layers.iter().map(|layer| surface_m - layer.top_m);
    let within = depths_m.filter(|depth_m| *depth_m > 0.0 && *depth_m < deepest_m);
    within.collect()
}

/// The rotor whose excitations are drawn, none if it is unknown, and the required margin.
fn rotor(input: &TowerInput, arguments: &PlotArguments) -> (Option<Rotor>, f64) {
    let rotor = arguments.rotor.rotor(input).map(|chosen| chosen.rotor);
    (rotor, arguments.rotor.options().margin)
}

fn drawn(
    figure: towermodes_report::svg::Figure,
    solution: &Solution,
    failed: impl Iterator<Item = String>,
) -> Drawn {
    Drawn {
        notes: failed.map(Note::new).collect(),
        ..Drawn::new(figure, &solution.warnings).computed(computed_by(solution))
    }
}

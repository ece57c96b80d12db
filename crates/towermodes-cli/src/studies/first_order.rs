//! The scatter of frequencies to first order.

use towermodes_files::{
    CorrelatedInputs, FirstOrderDocument, InputEffect, MarginProbability, Sampling, ScatteredInput,
    ScatteredMode, TowerInput,
};
use towermodes_sweep::{FirstOrder, MarginCheck, ModeScatter};

/// The result with the name of the tower.
pub fn document(
    input: &TowerInput,
    sampling: &Sampling,
    found: &FirstOrder,
    check: Option<&MarginCheck>,
) -> FirstOrderDocument {
    let inputs = found.inputs.iter().map(|input| ScatteredInput {
        name: input.name.clone(),
        unit: input.unit.to_owned(),
        mean: input.mean,
        deviation: input.deviation,
    });
    let correlations = sampling.correlations.iter().map(|pair| CorrelatedInputs {
        between: pair.between.clone(),
        coefficient: pair.coefficient,
    });
    let notes = input.notes.iter().map(ToString::to_string);
    FirstOrderDocument {
        tower: input.description.name.clone(),
        inputs: inputs.collect(),
        correlations: correlations.collect(),
        margin: check.map(|check| check.margin),
        modes: found
            .modes
            .iter()
            .map(|mode| of_mode(mode, check))
            .collect(),
        warnings: notes.chain(found.doubts()).collect(),
    }
}

fn of_mode(mode: &ModeScatter, check: Option<&MarginCheck>) -> ScatteredMode {
    let scatter = mode.scatter.as_ref().ok();
    let effects = scatter.map_or(Vec::new(), |scatter| {
        let effects = scatter.hz_per_unit.iter().zip(&scatter.shares);
        let effect = |(hz_per_unit, share): (&f64, &f64)| InputEffect {
            hz_per_unit: *hz_per_unit,
            share: *share,
        };
        effects.map(effect).collect()
    });
    let margins = scatter.zip(check).map_or(Vec::new(), |(scatter, check)| {
        let margins = check.multiples.iter().zip(&scatter.violated);
        let margin = |(multiple, probability): (&usize, &f64)| MarginProbability {
            multiple: *multiple,
            probability: *probability,
        };
        margins.map(margin).collect()
    });
    ScatteredMode {
        mode: mode.name.to_string(),
        label: mode.name.label(),
        mean_hz: scatter.map(|scatter| scatter.mean_hz),
        error_hz: scatter.map(|scatter| scatter.error_hz),
        deviation_hz: scatter.map(|scatter| scatter.deviation_hz),
        mean_shift_hz: scatter.and_then(|scatter| scatter.mean_shift_hz),
        inputs: effects,
        margins,
        no_scatter: mode.scatter.as_ref().err().map(ToString::to_string),
    }
}

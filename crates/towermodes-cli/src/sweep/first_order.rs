//! The scatter of frequencies to first order, without rows.

use towermodes_files::{
    CorrelatedInputs, FirstOrderDocument, InputEffect, MarginProbability, Sampling, ScatteredInput,
    ScatteredMode, write_first_order_json,
};
use towermodes_sweep::{FirstOrder, FirstOrderError, MarginCheck, ModeScatter, SweepSource};

use super::planned::Planned;
use crate::args::{SweepArguments, SweepFormat};
use crate::failure::Failure;
use crate::output::deliver;
use crate::table;

/// Differentiates at the means of the distributions, and prints what follows.
pub(super) fn run(planned: &Planned, arguments: &SweepArguments) -> Result<(), Failure> {
    let SweepSource::Sampled { sampling, .. } = &planned.source else {
        return Err(Failure::Usage(
            "--first-order needs a study with distributions in [sweep.vary]; the rows of a table have none",
        ));
    };
    let check = planned.sweep.margin_check();
    let found = planned.sweep.first_order(sampling, check.as_ref());
    let found = found.map_err(failure)?;
    let mut result = Vec::new();
    match arguments.format == Some(SweepFormat::Json) {
        true => {
            let document = document(planned, sampling, &found, check.as_ref());
            write_first_order_json(&document, &mut result)?;
        }
        false => {
            let tower = planned.input.tower().map_err(Failure::Input)?;
            let correlated = !sampling.correlations.is_empty();
            let text = table::first_order(&tower, &found, check.as_ref(), correlated);
            result.extend(text.into_bytes());
        }
    }
    deliver(&result, None)
}

fn failure(error: FirstOrderError) -> Failure {
    match error {
        FirstOrderError::Sensitivity(error) => Failure::NoSensitivity(error),
        error => Failure::WrongStudy(format!("--first-order: {error}")),
    }
}

fn document(
    planned: &Planned,
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
    FirstOrderDocument {
        tower: planned.input.description.name.clone(),
        inputs: inputs.collect(),
        correlations: correlations.collect(),
        margin: check.map(|check| check.margin),
        modes: found
            .modes
            .iter()
            .map(|mode| of_mode(mode, check))
            .collect(),
        warnings: planned
            .input
            .notes
            .iter()
            .map(ToString::to_string)
            .collect(),
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

//! The scatter of frequencies to first order, without solving rows.

use towermodes::Solver;
use towermodes_files::write_first_order_json;
use towermodes_sweep::{FirstOrderError, SweepSource};

use super::arguments::{SweepArguments, SweepFormat};
use super::planned::Planned;
use crate::failure::Failure;
use crate::messages::warn_texts;
use crate::output::Finished;
use crate::studies::first_order::document;
use crate::table;

/// Differentiates at the means of the distributions, and prints the standard deviations to first
/// order.
pub(super) fn run(planned: &Planned, arguments: &SweepArguments) -> Result<(), Failure> {
    let SweepSource::Sampled { sampling, .. } = &planned.source else {
        return Err(Failure::usage(
            "--first-order needs a study with distributions in [sweep.vary]; the rows of a table have none",
        ));
    };
    let check = planned.sweep.margin_check();
    let found = planned
        .sweep
        .first_order(sampling, check.as_ref(), Solver::default());
    let found = found.map_err(failure)?;
    warn_texts(&found.doubts());
    let result = match arguments.format == Some(SweepFormat::Json) {
        true => {
            let document = document(&planned.input, sampling, &found, check.as_ref());
            Finished::data(|json| write_first_order_json(&document, json))?
        }
        false => {
            let tower = planned.input.tower()?;
            let correlated = !sampling.correlations.is_empty();
            let text = table::first_order(&tower, &found, check.as_ref(), correlated);
            Finished::Text(text)
        }
    };
    result.deliver(None)
}

fn failure(error: FirstOrderError) -> Failure {
    match error {
        FirstOrderError::Sensitivity(error) => Failure::from(error),
        error => Failure::usage(format!("--first-order: {error}")),
    }
}

//! `towermodes elastodyn validate`.

use towermodes_analysis::Verdict;
use towermodes_analysis::elastodyn::{ValidationLimits, validate_shapes};
use towermodes_files::write_result_json;

use super::arguments::ValidateArguments;
use super::deck::judged;
use crate::args::TextFormat;
use crate::failure::Failure;
use crate::output::Finished;
use crate::table;

/// Compares the mode shapes of a deck with the computed modes of its tower.
pub(crate) fn run(arguments: &ValidateArguments) -> Result<(), Failure> {
    let judged = judged(&arguments.deck)?;
    let (main, file) = (&judged.deck.main, &judged.deck.tower);
    let flexible_m = main.tower_length_m();
    let nodes = main.tower_nodes;
    let model = file.model(flexible_m, nodes, judged.deck.rna.mass_kg);
    let limits = ValidationLimits::default();
    let validation =
        validate_shapes(&model, &file.modes(), &judged.shapes, &limits).map_err(Failure::failed)?;
    let result = match arguments.format {
        TextFormat::Table => {
            let title = &judged.deck.tower_source.name;
            let shapes = &validation.shapes;
            Finished::Text(table::judgements(
                title,
                &judged.tower,
                judged.from_m,
                shapes,
            ))
        }
        TextFormat::Json => Finished::data(|json| write_result_json(&validation, json))?,
    };
    result.deliver(None)?;
    match validation
        .shapes
        .iter()
        .filter(|j| j.verdict == Verdict::Fail)
        .count()
    {
        0 => Ok(()),
        failures => Err(Failure::failed(format!(
            "{failures} of 4 mode shapes in the file do not match the tower"
        ))
        .hint("towermodes elastodyn patch replaces them by the computed shapes")),
    }
}

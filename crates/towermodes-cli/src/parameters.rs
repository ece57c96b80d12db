//! `towermodes parameters`.

use towermodes::{Parameter, ParameterError};
use towermodes_files::{TowerInput, write_parameters_csv, write_parameters_json};

use crate::args::{Format, ParametersArguments};
use crate::failure::Failure;
use crate::input::tower_input;
use crate::messages::note;
use crate::output::{check_not_inputs, deliver};
use crate::table;

/// Lists the numbers of a tower by name.
pub(crate) fn run(arguments: &ParametersArguments) -> Result<(), Failure> {
    let format = arguments.destination.format()?;
    let input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), arguments.destination.output())?;
    let listed = listed(&input, arguments)?;
    let mut result = Vec::new();
    match format {
        Format::Table => result.extend(table::parameters(&input.description, &listed).into_bytes()),
        Format::Json => write_parameters_json(&input, &listed, &mut result)?,
        Format::Csv => write_parameters_csv(&input, &listed, &mut result)?,
    }
    note(&input.notes);
    deliver(&result, arguments.destination.output())
}

/// The numbers that at least one filter selects, each once.
fn listed(input: &TowerInput, arguments: &ParametersArguments) -> Result<Vec<Parameter>, Failure> {
    let all = Parameter::all(&input.description);
    let names: Vec<String> = all.iter().map(Parameter::to_string).collect();
    let pairs = all.into_iter().zip(&names);
    let selected = pairs.filter(|(_, name)| arguments.selects(name));
    let mut listed: Vec<Parameter> = selected.map(|(parameter, _)| parameter).collect();
    for filter in arguments.unmatched(&names) {
        // The name of a number that is not listed, such as an entry below a diagonal.
        let found = Parameter::parse_every(filter, &input.description);
        for parameter in found.map_err(no_number)? {
            if !listed.contains(&parameter) {
                listed.push(parameter);
            }
        }
    }
    Ok(listed)
}

fn no_number(error: ParameterError) -> Failure {
    Failure::usage(error).hint("without a filter the command lists all numbers")
}

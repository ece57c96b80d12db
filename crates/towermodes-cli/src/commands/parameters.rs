//! `towermodes parameters`.

use clap::Args;
use towermodes::{Parameter, ParameterError};
use towermodes_files::{TowerInput, write_parameters_csv, write_parameters_json};

use crate::args::{Destination, Format, InputArguments, csv_lines};
use crate::failure::Failure;
use crate::input::tower_input;
use crate::messages::note;
use crate::output::{Finished, check_not_inputs};
use crate::table;

const EXAMPLES: &str = "Examples:
  towermodes parameters tower.toml
  towermodes parameters tower.toml rna rotor
  towermodes parameters tower.toml 'stations[*].wall'
  towermodes parameters tower.toml --output parameters.csv
  towermodes solve tower.toml --set 'rna.mass=360000'

A name is the address of an input value in the tower file, with indices from 0: stations[2].wall is the wall thickness of the third station. --set and the columns of a sweep use the same names: NAME sets a value, 'scale(NAME)' multiplies it, 'add(NAME)' adds to it; [*] stands for every index.

Exit codes: 0 done, 1 the output failed, 2 wrong usage or wrong input, or no input value has such a name.";

/// The arguments of `parameters`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("format", |of| csv_lines(of, "One line per input value")))]
pub(crate) struct ParametersArguments {
    #[command(flatten)]
    input: InputArguments,

    /// List only the input values whose name contains one of these texts; * stands for any
    /// characters [default: all]
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,

    #[command(flatten)]
    destination: Destination,
}

impl ParametersArguments {
    /// Whether a name is to be listed.
    fn selects(&self, name: &str) -> bool {
        self.filters.is_empty() || self.filters.iter().any(|filter| contains(name, filter))
    }

    /// The filters that occur in no name.
    fn unmatched<'a>(&'a self, names: &'a [String]) -> impl Iterator<Item = &'a str> {
        let is_unmatched = |filter: &&String| !names.iter().any(|name| contains(name, filter));
        self.filters.iter().filter(is_unmatched).map(String::as_str)
    }
}

/// Whether a name contains a text in which `*` stands for any characters.
fn contains(name: &str, filter: &str) -> bool {
    let mut rest = name;
    filter.split('*').all(|piece| {
        let found = rest.split_once(piece);
        rest = found.map_or("", |(_, after)| after);
        found.is_some()
    })
}

/// Lists the input values of a tower by name.
pub(crate) fn run(arguments: &ParametersArguments) -> Result<(), Failure> {
    let format = arguments.destination.format()?;
    let input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), arguments.destination.output())?;
    let listed = listed(&input, arguments)?;
    let result = match format {
        Format::Table => Finished::Text(table::parameters(&input.description, &listed)),
        Format::Json => Finished::data(|json| write_parameters_json(&input, &listed, json))?,
        Format::Csv => Finished::data(|csv| write_parameters_csv(&input, &listed, csv))?,
    };
    note(&input.notes);
    result.deliver(arguments.destination.output())
}

/// The input values that at least one filter selects, each once.
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
    Failure::usage(error).hint("without a filter the command lists all input values")
}

#[cfg(test)]
mod tests {
    use super::contains;

    #[test]
    fn a_star_is_any_text() {
        for (filter, is_found) in [
            ("wall", true),
            ("stations[*].wall", true),
            ("stations[1*", true),
            ("", true),
            ("wall*stations", false),
            ("stations[2].wall", false),
            ("walls", false),
        ] {
            assert_eq!(contains("stations[12].wall", filter), is_found, "{filter}");
        }
    }
}

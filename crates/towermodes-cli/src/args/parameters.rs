//! The arguments of `parameters`.

use clap::Args;

use super::input::InputArguments;
use super::{Destination, csv_lines};

const EXAMPLES: &str = "Examples:
  towermodes parameters tower.toml
  towermodes parameters tower.toml rna rotor
  towermodes parameters tower.toml 'stations[*].wall'
  towermodes parameters tower.toml --output parameters.csv
  towermodes solve tower.toml --set 'rna.mass=360000'

A name is the address of a number in the tower file, with indices from 0: stations[2].wall is the wall thickness of the third station. The names are those of --set and of the columns of a sweep: NAME sets a number, 'scale(NAME)' multiplies it, 'add(NAME)' adds to it; [*] is every index.

Exit codes: 0 done, 1 the output failed, 2 wrong usage or wrong input, or no number has such a name.";

/// The arguments of `parameters`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("format", |of| csv_lines(of, "One line per number")))]
pub(crate) struct ParametersArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// List only the numbers whose name contains one of these texts; * stands for any characters
    /// [default: all]
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,

    #[command(flatten)]
    pub(crate) destination: Destination,
}

impl ParametersArguments {
    /// Whether a name is to be listed.
    pub(crate) fn selects(&self, name: &str) -> bool {
        self.filters.is_empty() || self.filters.iter().any(|filter| contains(name, filter))
    }

    /// The filters that no name contains.
    pub(crate) fn unmatched<'a>(&'a self, names: &'a [String]) -> impl Iterator<Item = &'a str> {
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

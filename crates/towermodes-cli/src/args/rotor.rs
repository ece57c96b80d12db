//! Options of the rotor: speeds, blades, multiples, required margin.

use clap::Args;
use towermodes::number::Rounded;
use towermodes::tower::MOST_BLADES;
use towermodes_analysis::resonance::{CampbellOptions, ChosenRotor, DEFAULT_MARGIN, GivenRotor};
use towermodes_files::{Note, TowerInput};

use super::parsers::{margin_parser, number_parser, speeds_parser};
use super::words::valued;

/// Heading of these options in the help.
const ROTOR: &str = "Rotor";

/// Highest multiple of the rotor speed.
const MAX_MULTIPLE: usize = 100;

/// Smaller margins in percent are probably fractions.
const LEAST_PERCENT: f64 = 1.0;

/// Rotor data that replace those of the file.
#[derive(Debug, Args)]
pub(crate) struct RotorArguments {
    /// Required separation between excitation and natural frequency, percent of the natural
    /// frequency (not a fraction as in the files of `design`) [default: 5]
    #[arg(help_heading = ROTOR, long, value_name = "PERCENT", value_parser = margin_parser)]
    margin: Option<f64>,

    /// Lowest and highest operating speed of the rotor, rpm, for example 6.9,12.1; or one constant
    /// speed [default: from the file]
    #[arg(help_heading = ROTOR, long, value_name = "LOWEST,HIGHEST", allow_hyphen_values = true, value_parser = speeds_parser)]
    rpm: Option<(f64, f64)>,

    /// Number of blades B [default: from the file, otherwise 3]
    #[arg(help_heading = ROTOR, long, value_name = "N", value_parser = number_parser(1, MOST_BLADES))]
    blades: Option<usize>,

    /// Multiples of the rotor speed to check, comma-separated [default: 1, B, 2B, 3B]
    #[arg(help_heading = ROTOR, long, value_name = "LIST", value_delimiter = ',', value_parser = number_parser(1, MAX_MULTIPLE))]
    multiples: Vec<usize>,
}

impl RotorArguments {
    /// The rotor of the file, with its data replaced by the options of the command line; none if
    /// the rotor speed is unknown.
    pub(crate) fn rotor(&self, input: &TowerInput) -> Option<ChosenRotor> {
        let given = self.given();
        given.in_place_of(input.description.rotor, input.blades)
    }

    /// Whether any of these options is given.
    pub(crate) fn is_given(&self) -> bool {
        self.margin.is_some()
            || self.rpm.is_some()
            || self.blades.is_some()
            || !self.multiples.is_empty()
    }

    /// The data that replace those of the file.
    pub(crate) fn given(&self) -> GivenRotor {
        GivenRotor {
            speeds_rpm: self.rpm,
            blades: self.blades,
        }
    }

    /// The given options as arguments of a command line.
    pub(crate) fn words(&self) -> Vec<String> {
        let multiples: Vec<String> = self.multiples.iter().map(ToString::to_string).collect();
        let multiples = Some(multiples.join(",")).filter(|list| !list.is_empty());
        let rpm = self
            .rpm
            .map(|(lowest, highest)| format!("{lowest},{highest}"));
        [
            valued("--margin", self.margin),
            valued("--rpm", rpm),
            valued("--blades", self.blades),
            valued("--multiples", multiples),
        ]
        .concat()
    }

    /// The note on a margin that is probably a fraction.
    pub(crate) fn note(&self) -> Option<Note> {
        let percent = self.margin?;
        let is_fraction = percent > 0.0 && percent < LEAST_PERCENT;
        is_fraction.then(|| {
            Note::suspicious(format!(
                "--margin is in percent: {percent} is {percent} % of the natural frequency; --margin {} is the fraction {percent}",
                Rounded(100.0 * percent),
            ))
        })
    }

    /// The options of the library.
    pub(crate) fn options(&self) -> CampbellOptions {
        CampbellOptions {
            margin: self
                .margin
                .map_or(DEFAULT_MARGIN, |percent| percent / 100.0),
            multiples: self.multiples.clone(),
            ..CampbellOptions::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::RotorArguments;

    /// The default is the value that the help states.
    #[test]
    fn the_default_margin_is_five_percent() {
        let asked = RotorArguments {
            margin: None,
            rpm: None,
            blades: None,
            multiples: Vec::new(),
        };
        assert!(!asked.is_given());
        assert_eq!(asked.options().margin, 0.05);
        let asked = RotorArguments {
            margin: Some(5.0),
            ..asked
        };
        assert!(asked.is_given());
        assert_eq!(asked.options().margin, 0.05);
        assert_eq!(asked.note(), None);
        let fraction = RotorArguments {
            margin: Some(0.07),
            ..asked
        };
        let note = fraction.note().expect("a note").message;
        assert_eq!(
            note,
            "--margin is in percent: 0.07 is 0.07 % of the natural frequency; --margin 7 is the fraction 0.07"
        );
    }
}

//! Options of the rotor: speeds, blades, multiples, required margin.

use clap::Args;
use towermodes::Rotor;
use towermodes::tower::MOST_BLADES;
use towermodes_analysis::resonance::{CampbellOptions, DEFAULT_MARGIN};

use super::parsers::{margin_parser, number_parser, speeds_parser};

/// Heading of these options in the help.
const ROTOR: &str = "Rotor";

/// Number of blades if the file does not give it.
const USUAL_BLADES: usize = 3;

/// Highest multiple of the rotor speed.
const MAX_MULTIPLE: usize = 100;

/// Rotor data that replace those of the file.
#[derive(Debug, Args)]
pub(crate) struct RotorArguments {
    /// Required separation of excitation and natural frequency, percent of the natural frequency
    /// [default: 5]
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

/// A rotor and the source of its data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ChosenRotor {
    /// The rotor.
    pub(crate) rotor: Rotor,
    /// Whether the number of blades is the default.
    pub(crate) blades_are_assumed: bool,
    /// Whether the number of blades is given on the command line.
    pub(crate) blades_are_given: bool,
    /// Whether the speeds are given on the command line.
    pub(crate) speeds_are_given: bool,
}

impl RotorArguments {
    /// The rotor of the file, with the options of the command line in place of its data; none if
    /// the rotor speed is unknown. A file may give the number of blades without the speed.
    pub(crate) fn rotor(
        &self,
        of_file: Option<Rotor>,
        blades_of_file: Option<usize>,
    ) -> Option<ChosenRotor> {
        let speeds = self.rpm.or_else(|| of_file.map(speeds_of));
        let of_rotor = of_file.map(|rotor| rotor.blades);
        let blades = self.blades.or(of_rotor).or(blades_of_file);
        let (lowest_rpm, highest_rpm) = speeds?;
        Some(ChosenRotor {
            rotor: Rotor {
                blades: blades.unwrap_or(USUAL_BLADES),
                lowest_rpm,
                highest_rpm,
            },
            blades_are_assumed: blades.is_none(),
            blades_are_given: self.blades.is_some(),
            speeds_are_given: self.rpm.is_some(),
        })
    }

    /// Whether any of these options is given.
    pub(crate) fn is_given(&self) -> bool {
        self.margin.is_some()
            || self.rpm.is_some()
            || self.blades.is_some()
            || !self.multiples.is_empty()
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

fn speeds_of(rotor: Rotor) -> (f64, f64) {
    (rotor.lowest_rpm, rotor.highest_rpm)
}

#[cfg(test)]
mod tests {
    use super::{ChosenRotor, RotorArguments};
    use towermodes::Rotor;

    const OF_FILE: Rotor = Rotor {
        blades: 2,
        lowest_rpm: 6.9,
        highest_rpm: 12.1,
    };

    fn arguments(rpm: Option<(f64, f64)>, blades: Option<usize>) -> RotorArguments {
        RotorArguments {
            margin: None,
            rpm,
            blades,
            multiples: Vec::new(),
        }
    }

    #[test]
    fn what_was_said_here_stands_in_place_of_what_the_file_says() {
        let chosen = arguments(Some((5.0, 8.0)), None).rotor(Some(OF_FILE), None);
        let rotor = Rotor {
            blades: 2,
            lowest_rpm: 5.0,
            highest_rpm: 8.0,
        };
        let expected = ChosenRotor {
            rotor,
            blades_are_assumed: false,
            blades_are_given: false,
            speeds_are_given: true,
        };
        assert_eq!(chosen, Some(expected));
        let chosen = arguments(None, Some(4)).rotor(Some(OF_FILE), Some(2));
        assert_eq!(chosen.map(|c| c.rotor.blades), Some(4));
        assert_eq!(chosen.map(|c| c.rotor.highest_rpm), Some(12.1));
        assert_eq!(chosen.map(|c| c.speeds_are_given), Some(false));
        assert_eq!(chosen.map(|c| c.blades_are_given), Some(true));
    }

    /// As the help says.
    #[test]
    fn five_percent_are_the_margin_of_nobody() {
        let asked = arguments(None, None);
        assert!(!asked.is_given());
        assert_eq!(asked.options().margin, 0.05);
        let asked = RotorArguments {
            margin: Some(5.0),
            ..asked
        };
        assert!(asked.is_given());
        assert_eq!(asked.options().margin, 0.05);
    }

    #[test]
    fn three_blades_are_assumed_and_no_speed_is() {
        let chosen = arguments(Some((5.0, 8.0)), None).rotor(None, None);
        assert_eq!(
            chosen.map(|c| (c.rotor.blades, c.blades_are_assumed)),
            Some((3, true))
        );
        assert_eq!(arguments(None, Some(3)).rotor(None, Some(3)), None);
        // A file that says no speed may say how many blades there are.
        let chosen = arguments(Some((5.0, 8.0)), None).rotor(None, Some(2));
        assert_eq!(
            chosen.map(|c| (c.rotor.blades, c.blades_are_assumed)),
            Some((2, false))
        );
    }
}

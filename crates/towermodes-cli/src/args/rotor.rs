//! What the rotor is taken for: its speeds, its blades, the margin asked for.

use clap::Args;
use towermodes::Rotor;
use towermodes::tower::MOST_BLADES;
use towermodes_analysis::resonance::{CampbellOptions, DEFAULT_MARGIN};

use super::parsers::{margin_parser, number_parser, speeds_parser};

/// The heading of what is about the rotor.
const ROTOR: &str = "Rotor";

/// Blades of a rotor whose file does not say how many.
const USUAL_BLADES: usize = 3;

/// Highest multiple of the rotor's speed: nothing excites at more.
const MAX_MULTIPLE: usize = 100;

/// The rotor, as far as it is not as the file says.
#[derive(Debug, Args)]
pub(crate) struct RotorArguments {
    /// Least distance of an excitation to a natural frequency, percent of the frequency
    /// [default: 5]
    #[arg(help_heading = ROTOR, long, value_name = "PERCENT", value_parser = margin_parser)]
    margin: Option<f64>,

    /// Lowest and highest rotor speed of operation, as 6.9,12.1, or the only one, rpm
    /// [default: what the file says]
    #[arg(help_heading = ROTOR, long, value_name = "LOWEST,HIGHEST", allow_hyphen_values = true, value_parser = speeds_parser)]
    rpm: Option<(f64, f64)>,

    /// Number of blades [default: what the file says, else 3]
    #[arg(help_heading = ROTOR, long, value_name = "N", value_parser = number_parser(1, MOST_BLADES))]
    blades: Option<usize>,

    /// Multiples of the rotor's speed, with commas between them
    /// [default: 1 and one, two and three times the number of blades]
    #[arg(help_heading = ROTOR, long, value_name = "LIST", value_delimiter = ',', value_parser = number_parser(1, MAX_MULTIPLE))]
    multiples: Vec<usize>,
}

/// A rotor, and where its numbers are from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ChosenRotor {
    /// The rotor.
    pub(crate) rotor: Rotor,
    /// Whether nobody said how many blades it has.
    pub(crate) blades_are_assumed: bool,
    /// Whether that is said on the command line.
    pub(crate) blades_are_given: bool,
    /// Whether its speeds are those of the command line.
    pub(crate) speeds_are_given: bool,
}

impl RotorArguments {
    /// The file's rotor with what was said here in place of its own; none if nobody said how fast
    /// it runs. A file may say how many blades it has and not how fast it runs.
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

    /// Whether anything is not as the file says.
    pub(crate) fn is_given(&self) -> bool {
        self.margin.is_some()
            || self.rpm.is_some()
            || self.blades.is_some()
            || !self.multiples.is_empty()
    }

    /// What the library is asked for.
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

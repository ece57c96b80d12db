//! The arguments of `damping`.

use clap::Args;
use towermodes::tower::MOST_BLADES;
use towermodes::{Damping, MAX_SEGMENTS, Method, Options};
use towermodes_analysis::damping::GivenDamping;
use towermodes_analysis::resonance::{ChosenRotor, GivenRotor};
use towermodes_files::TowerInput;

use super::input::InputArguments;
use super::model::ModelArguments;
use super::parsers::{
    loss_factor_parser, method_parser, number_parser, positive_parser, speeds_parser,
};
use super::prescribed::Prescribed;
use super::{Destination, csv_lines};

const EXAMPLES: &str = "Examples:
  towermodes damping examples/monopile.toml --loss-factor tower=0.004 --loss-factor soil=0.02
  towermodes damping tower.toml --chord-moment 6073 --rpm 6.9,12.1
  towermodes damping tower.toml --output damping.json

The damping ratio of a mode is the sum of half the loss factor of each part times the fraction of the strain energy that the part has in the mode; for water, of the kinetic energy. A loss factor is twice a damping ratio, and the logarithmic decrement divided by pi. No loss factor is assumed; the book lists those of standards.
The rotor adds damping to fore-aft motion in operation; with --chord-moment, or chord_moment in the tower file, it is computed for the lowest and the highest operating speed.

Exit codes: 0 done, 1 the computation or the output failed, 2 wrong usage or wrong input.";

/// Heading of the options of the rotor in the help.
const ROTOR: &str = "Rotor";

/// The arguments of `damping`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("format", |of| csv_lines(of, "One line per mode and part")))]
pub(crate) struct DampingArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Loss factor of a part: tower, foundation, soil, wires, water or the name of a material; may
    /// be repeated [default: from the file]
    #[arg(long = "loss-factor", value_name = "PART=VALUE", value_parser = loss_factor_parser)]
    loss_factors: Vec<(String, f64)>,

    /// Integral of chord times radius over one blade, m3 [default: from the file]
    #[arg(help_heading = ROTOR, long, value_name = "M3", value_parser = positive_parser)]
    chord_moment: Option<f64>,

    /// Slope of the lift coefficient of the blades, per rad [default: from the file, otherwise 2
    /// pi]
    #[arg(help_heading = ROTOR, long, value_name = "SLOPE", value_parser = positive_parser)]
    lift_slope: Option<f64>,

    /// Density of air, kg/m3 [default: from the file, otherwise 1.225]
    #[arg(help_heading = ROTOR, long, value_name = "DENSITY", value_parser = positive_parser)]
    air_density: Option<f64>,

    /// Lowest and highest operating speed of the rotor, rpm, for example 6.9,12.1; or one constant
    /// speed [default: from the file]
    #[arg(help_heading = ROTOR, long, value_name = "LOWEST,HIGHEST", allow_hyphen_values = true, value_parser = speeds_parser)]
    rpm: Option<(f64, f64)>,

    /// Number of blades [default: from the file, otherwise 3]
    #[arg(help_heading = ROTOR, long, value_name = "N", value_parser = number_parser(1, MOST_BLADES))]
    blades: Option<usize>,

    /// Method of computation [default: rmje-exact; bmodes for BModes decks]
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,

    /// Number of segments (bmodes and spectral: elements) [default: as solve]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Option<usize>,

    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pub(crate) destination: Destination,
}

impl DampingArguments {
    /// The options of the library.
    ///
    /// # Errors
    /// The message for an option that does not apply to the method.
    pub(crate) fn options(&self, prescribed: Prescribed) -> Result<Options, &'static str> {
        let options = prescribed.options(self.method, self.segments, &self.model)?;
        Ok(Options {
            points: 2,
            energy_parts: true,
            ..options
        })
    }

    /// The data that replace those of the file.
    pub(crate) fn given(&self) -> GivenDamping {
        GivenDamping {
            loss_factors: self.loss_factors.clone(),
            chord_moment_m3: self.chord_moment,
            lift_slope: self.lift_slope,
            air_density_kg_per_m3: self.air_density,
        }
    }

    /// The rotor of the file, with the options of the command line in place of its data; none if
    /// the rotor speed is unknown.
    pub(crate) fn rotor(&self, input: &TowerInput) -> Option<ChosenRotor> {
        let given = GivenRotor {
            speeds_rpm: self.rpm,
            blades: self.blades,
        };
        given.in_place_of(input.description.rotor, input.blades)
    }

    /// Checks that the options of the rotor have an effect.
    ///
    /// # Errors
    /// The message for an option that has none.
    pub(crate) fn check_rotor(&self, damping: &Damping) -> Result<(), &'static str> {
        let is_given = self.rpm.is_some() || self.blades.is_some();
        match damping.rotor.is_none() && is_given {
            true => Err(
                "--rpm and --blades have no effect without --chord-moment, or chord_moment in the tower file",
            ),
            false => Ok(()),
        }
    }
}

//! Options of turbines with flexible blades.

use clap::{Args, ValueEnum};
use towermodes_files::TowerInput;

use super::parsers::{frequency_parser, number_parser};

/// Heading of these options in the help.
const TURBINE: &str = "Turbine with flexible blades";
/// The largest number of rotor speeds.
const MOST_SPEEDS: usize = 1000;

/// How the generator is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum GeneratorState {
    /// It turns at the constant speed; the shaft twists between it and the hub
    Locked,
    /// It turns freely with the rotor
    Free,
}

/// How a turbine with flexible blades is solved.
#[derive(Debug, Args)]
pub(crate) struct TurbineArguments {
    /// Use the tower alone, with the rotor and the nacelle as a rigid body, and a blade alone
    #[arg(help_heading = TURBINE, long)]
    pub(crate) uncoupled: bool,

    /// Hold the generator at the rotor speed (locked) or let it turn (free) [default: as in the
    /// input]
    #[arg(help_heading = TURBINE, long, value_name = "STATE", conflicts_with = "uncoupled")]
    generator: Option<GeneratorState>,

    /// Highest frequency of the modes, Hz [default: what the excitations reach, and the second
    /// bending modes of the tower where they are less than twice as high, but not more than 40
    /// modes at rest]
    #[arg(help_heading = TURBINE, long, value_name = "HZ", conflicts_with = "uncoupled", value_parser = frequency_parser)]
    pub(crate) limit: Option<f64>,

    /// Number of equally spaced rotor speeds from standstill to 1.2 times the highest operating
    /// speed; both ends of operation are added, and speeds where modes come close [default: 25]
    #[arg(help_heading = TURBINE, long, value_name = "N", conflicts_with = "uncoupled", value_parser = number_parser(2, MOST_SPEEDS))]
    pub(crate) speeds: Option<usize>,
}

impl TurbineArguments {
    /// Holds the generator of the input's turbine as asked.
    pub(crate) fn hold_generator(&self, input: &mut TowerInput) {
        if let (Some(state), Some(turbine)) = (self.generator, &mut input.turbine) {
            turbine.generator.is_locked = state == GeneratorState::Locked;
        }
    }

    /// Whether an option is given that only a turbine has.
    pub(crate) fn is_given(&self) -> bool {
        self.limit.is_some() || self.speeds.is_some() || self.generator.is_some()
    }
}

//! Options of turbines with flexible blades.

use clap::{Args, ValueEnum};
use towermodes_files::TowerInput;

use super::parsers::{frequency_parser, number_parser};

/// Heading of these options in the help.
const TURBINE: &str = "Turbine with flexible blades";
/// The largest number of rotor speeds.
const MOST_SPEEDS: usize = 1000;

/// The state of the generator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum GeneratorState {
    /// Fixed generator speed; the shaft can twist between generator and hub
    Locked,
    /// No generator torque: the generator rotates freely with the rotor
    Free,
}

/// Options of the solution of a turbine with flexible blades.
#[derive(Debug, Args)]
pub(crate) struct TurbineArguments {
    /// Analyse the tower (rigid rotor-nacelle assembly) and one blade separately
    #[arg(help_heading = TURBINE, long)]
    pub(crate) uncoupled: bool,

    /// Generator at fixed speed (locked) or free to rotate with the rotor (free) [default: as in
    /// the input]
    #[arg(help_heading = TURBINE, long, value_name = "STATE", conflicts_with = "uncoupled")]
    generator: Option<GeneratorState>,

    /// Highest frequency computed, Hz [default: the highest excitation frequency; raised to include
    /// the second bending modes of the tower if they lie below twice that frequency; at most 40
    /// modes at rest]
    #[arg(help_heading = TURBINE, long, value_name = "HZ", conflicts_with = "uncoupled", value_parser = frequency_parser)]
    pub(crate) limit: Option<f64>,

    /// Number of equally spaced rotor speeds from standstill to 1.2 times the highest operating
    /// speed; the lowest and the highest operating speed are added, and further speeds where curves
    /// come close [default: 25]
    #[arg(help_heading = TURBINE, long, value_name = "N", conflicts_with = "uncoupled", value_parser = number_parser(2, MOST_SPEEDS))]
    pub(crate) speeds: Option<usize>,
}

impl TurbineArguments {
    /// Sets the generator of the turbine to the requested state.
    pub(crate) fn hold_generator(&self, input: &mut TowerInput) {
        if let (Some(state), Some(turbine)) = (self.generator, &mut input.turbine) {
            turbine.generator.is_locked = state == GeneratorState::Locked;
        }
    }

    /// Whether an option is given that applies only to a turbine.
    pub(crate) fn is_given(&self) -> bool {
        self.limit.is_some() || self.speeds.is_some() || self.generator.is_some()
    }
}

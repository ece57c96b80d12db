//! `towermodes damping`.

use clap::Args;
use towermodes::tower::MOST_BLADES;
use towermodes::{Options, Tower};
use towermodes_analysis::damping::{GivenDamping, damping};
use towermodes_analysis::resonance::GivenRotor;
use towermodes_files::{Note, TowerInput, write_damping_csv, write_damping_json};

use super::campbell::notes_on;
use crate::args::parsers::{loss_factor_parser, number_parser, positive_parser, speeds_parser};
use crate::args::{Destination, Format, InputArguments, SolverArguments, csv_lines};
use crate::failure::Failure;
use crate::progress::solve;
use crate::recipe::{Analysis, Answer};
use crate::table;

const EXAMPLES: &str = "Examples:
  towermodes damping examples/monopile.toml --loss-factor tower=0.004 --loss-factor soil=0.02
  towermodes damping tower.toml --chord-moment 6073 --rpm 6.9,12.1
  towermodes damping tower.toml --output damping.json

The damping ratio of a mode is the sum over all parts of (loss factor / 2) x (share of the part in the strain energy of the mode); for water, its share in the kinetic energy. A loss factor is twice a damping ratio, or the logarithmic decrement divided by pi. No loss factor is assumed; the book lists values from standards.
In operation the rotor adds aerodynamic damping to fore-aft motion. With --chord-moment, or chord_moment in the tower file, this damping is computed for the lowest and the highest operating speed.

Exit codes: 0 done, 1 the computation or the output failed, 2 wrong usage or wrong input.";

/// Heading of the options of the rotor in the help.
const ROTOR: &str = "Rotor";

/// The arguments of `damping`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("format", |of| csv_lines(of, "One line per mode and part")))]
pub(crate) struct DampingArguments {
    #[command(flatten)]
    input: InputArguments,

    /// Loss factor of a part: tower, substructure, foundation, soil, wires, water or the name of a
    /// material; may be repeated [default: from the file]
    #[arg(long = "loss-factor", value_name = "PART=VALUE", value_parser = loss_factor_parser)]
    loss_factors: Vec<(String, f64)>,

    /// First moment of the area of one blade about the rotor axis: integral of chord times radius,
    /// m3 [default: from the file]
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

    #[command(flatten)]
    solver: SolverArguments,

    #[command(flatten)]
    destination: Destination,
}

impl Analysis for DampingArguments {
    type Plan = Options;

    fn files(&self) -> (&InputArguments, &Destination) {
        (&self.input, &self.destination)
    }

    fn change(&self, input: &mut TowerInput) -> Result<(), Failure> {
        let given = GivenDamping {
            loss_factors: self.loss_factors.clone(),
            chord_moment_m3: self.chord_moment,
            lift_slope: self.lift_slope,
            air_density_kg_per_m3: self.air_density,
        };
        given.set(&mut input.description)?;
        let is_given = self.rpm.is_some() || self.blades.is_some();
        match input.description.damping.rotor.is_none() && is_given {
            true => Err("--rpm and --blades have no effect without --chord-moment, or chord_moment in the tower file".into()),
            false => Ok(()),
        }
    }

    fn plan(&self, input: &mut TowerInput) -> Result<Options, Failure> {
        Ok(Options {
            energy_parts: true,
            ..self.solver.frequencies(input)?
        })
    }

    /// Solves the tower, and computes the damping of its modes.
    fn answer(
        &self,
        tower: &Tower,
        input: &TowerInput,
        options: Options,
        format: Format,
    ) -> Result<Answer, Failure> {
        let solution = solve(tower, &options)?;
        let given = GivenRotor {
            speeds_rpm: self.rpm,
            blades: self.blades,
        };
        let chosen = given.in_place_of(input.description.rotor, input.blades);
        let rotor = chosen.as_ref().map(|chosen| &chosen.rotor);
        let damping = damping(&input.description, &solution, rotor).map_err(Failure::failed)?;
        let chosen = chosen.filter(|_| input.description.damping.rotor.is_some());
        let of_rotor = chosen.iter().flat_map(|chosen| notes_on(input, chosen));
        let remarks = damping.remarks.iter();
        let remarks = remarks.map(|remark| Note::suspicious(remark.to_string()));
        let notes: Vec<Note> = of_rotor.chain(remarks).collect();
        let all = [input.notes.as_slice(), &notes].concat();
        let answer = Answer::of(
            format,
            || table::damping(tower, &damping),
            |json| write_damping_json(tower.name(), &damping, &all, json),
            |csv| write_damping_csv(&damping, csv),
        )?;
        Ok(answer.notes(notes).warnings(&solution.warnings))
    }
}

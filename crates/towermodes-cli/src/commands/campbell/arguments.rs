//! The arguments of `campbell`.

use clap::Args;

use crate::args::{
    Destination, InputArguments, RotorArguments, SoilArguments, SolverArguments, TurbineArguments,
    csv_lines, up_to_excitations,
};

const EXAMPLES: &str = "Examples:
  towermodes campbell examples/nrel-5mw.toml
  towermodes campbell tower.toml --rpm 7.5,12.1 --margin 10
  towermodes campbell NREL5MW_ElastoDyn.dat --rpm 12.1 --multiples 1,3,6 --format csv
  towermodes campbell examples/nrel-5mw-turbine.toml --limit 3.5

An excitation nP is n times the rotor speed. The distance is the difference between excitation and natural frequency in percent of the natural frequency, at the operating speed where this difference is smallest. The margin is the required distance.

FAIL: 1P or the blade passing frequency is closer to a tower mode than the margin. WARN: 1P or the blade passing frequency is closer to a tower mode than twice the margin; or another multiple is closer to a tower mode than the margin; or any excitation is closer to a blade mode than the margin; or a blade mode could not be followed over all operating speeds. Tower modes are all modes except blade modes; torsion and the rigid-body motions of a floating platform are tower modes too.

If the tower stands in soil or on an elastic foundation, a second table has the frequencies and verdicts for half and twice the stiffness of soil and foundation. These verdicts do not change the exit code.

For a turbine with flexible blades ([turbine] in the tower file, or an ElastoDyn deck with its blade files) the diagram shows the operating turbine: coupled modes of tower, drivetrain and rotating blades in the fixed frame. The output lists the modes, pairs of whirl modes, crossings and veerings. An eigenvalue count (Sturm) proves that no mode is missing. Structure only: no aerodynamics, no controller, constant rotor speed. --uncoupled gives the diagram of the tower with a rigid rotor. Options that exist only for that diagram also switch to it: --method, --segments, --modes, --no-rotary-inertia, --hinges, --no-limits, --soil-factor.

If the operating speeds are unknown (the initial speed of a simulation is not a range), or if parts of the structure are not in the model, the command gives a diagram without verdicts.

Exit codes: 0 no pair fails; 1 at least one pair fails, nothing could be checked, or the computation or the output failed; 2 wrong usage or wrong input.";

/// The arguments of `campbell`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("modes", up_to_excitations), mut_arg("format", |of| csv_lines(of, "One line per mode and excitation, for turbines per mode and rotor speed")))]
pub(crate) struct CampbellArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    #[command(flatten)]
    pub(crate) solver: SolverArguments,

    #[command(flatten)]
    pub(crate) rotor: RotorArguments,

    #[command(flatten)]
    pub(crate) turbine: TurbineArguments,

    #[command(flatten)]
    pub(crate) soil: SoilArguments,

    /// Show every pair of mode and excitation in the table, including pairs whose frequencies
    /// differ by more than a factor of 2
    #[arg(long)]
    pub(crate) all: bool,

    #[command(flatten)]
    pub(crate) destination: Destination,
}

impl CampbellArguments {
    /// Whether options are given that apply only to the tower with a rigid rotor.
    pub(crate) fn is_of_tower_alone(&self) -> bool {
        self.solver.is_given() || self.soil.is_given()
    }
}

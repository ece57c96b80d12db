//! Options of the solution: from the command line, otherwise from the file, otherwise the default.

use clap::{Arg, Args};
use towermodes::GAUSS_HINGE_POSITION;
use towermodes::{AddedMassAt, MAX_SEGMENTS, Method, Options};
use towermodes_files::TowerInput;

use super::parsers::{added_mass_parser, hinge_parser, method_parser, number_parser};
use super::words::{flag, valued};

/// Method, mesh and model of commands that solve a tower by one method.
#[derive(Debug, Args)]
pub(crate) struct SolverArguments {
    /// Method of computation [default: rmje-exact; bmodes for BModes decks]
    #[arg(long, value_parser = method_parser())]
    pub(crate) method: Option<Method>,

    /// Number of segments (bmodes and spectral: elements) [default: same as solve]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_SEGMENTS))]
    pub(crate) segments: Option<usize>,

    #[command(flatten)]
    pub(crate) model: ModelArguments,
}

impl SolverArguments {
    /// Whether any of these options is given.
    pub(crate) fn is_given(&self) -> bool {
        self.method.is_some() || self.segments.is_some() || self.model.is_given()
    }

    /// Whether the number of modes is given.
    pub(crate) fn has_modes(&self) -> bool {
        self.model.modes.is_some()
    }

    /// The given options as arguments of a command line.
    pub(crate) fn words(&self) -> Vec<String> {
        [
            valued("--method", self.method.map(Method::name)),
            valued("--segments", self.segments),
            self.model.words(),
        ]
        .concat()
    }

    /// The options of the library; the command line has priority over the file.
    ///
    /// # Errors
    /// The message for an option that does not apply to the method.
    pub(crate) fn options(&self, input: &TowerInput) -> Result<Options, &'static str> {
        self.model.options(input, self.method, self.segments)
    }

    /// The same options without mode shapes.
    ///
    /// # Errors
    /// As [`options`](Self::options).
    pub(crate) fn frequencies(&self, input: &TowerInput) -> Result<Options, &'static str> {
        Ok(Options {
            points: 2,
            ..self.options(input)?
        })
    }
}

/// Options that apply to all methods.
#[derive(Debug, Args)]
pub(crate) struct ModelArguments {
    /// Number of modes, from the lowest [default: 8; BModes decks: the number in the deck]
    #[arg(long, value_name = "K", value_parser = number_parser(1, usize::MAX))]
    pub(crate) modes: Option<usize>,

    /// Neglect the rotary inertia of the sections in bending (with shear = false this is an
    /// Euler-Bernoulli beam)
    #[arg(long)]
    no_rotary_inertia: bool,

    /// Frequency-dependent added mass of a floating platform: own (each mode has the added mass at
    /// its own frequency), infinite (at infinite frequency, as in a linearization by OpenFAST),
    /// zero (at zero frequency), or a frequency in Hz [default: own]
    #[arg(long, value_name = "AT", value_parser = added_mass_parser)]
    added_mass: Option<AddedMassAt>,

    /// Hinge position of --method cardanic: distance from each end as a fraction of the segment
    /// length [default: 0.2113249, the Gauss points]
    #[arg(long, value_name = "FRACTION", value_parser = hinge_parser)]
    hinges: Option<f64>,

    /// Also solve models whose estimated cost is more than 4 GiB of memory or ten minutes; memory
    /// may run out
    #[arg(long)]
    no_limits: bool,
}

/// The help of `--modes` for commands that check resonance: the default depends on the rotor.
pub(crate) fn up_to_excitations(modes: Arg) -> Arg {
    modes.help(
        "Number of modes, from the lowest [default: 8, or up to 40 if the highest excitation frequency needs more; \
         BModes decks: at least the number in the deck]",
    )
}

impl ModelArguments {
    /// Whether any of these options is given.
    pub(crate) fn is_given(&self) -> bool {
        self.modes.is_some()
            || self.no_rotary_inertia
            || self.added_mass.is_some()
            || self.hinges.is_some()
            || self.no_limits
    }

    /// The given options as arguments of a command line.
    pub(crate) fn words(&self) -> Vec<String> {
        [
            valued("--modes", self.modes),
            flag("--no-rotary-inertia", self.no_rotary_inertia),
            valued("--added-mass", self.added_mass),
            valued("--hinges", self.hinges),
            flag("--no-limits", self.no_limits),
        ]
        .concat()
    }

    /// The options of the library with a method and a number of segments, if they are given; the
    /// command line has priority over the file.
    ///
    /// # Errors
    /// The message for an option that does not apply to the method.
    pub(crate) fn options(
        &self,
        input: &TowerInput,
        method: Option<Method>,
        segments: Option<usize>,
    ) -> Result<Options, &'static str> {
        let of_file = input.prescribed.options(method, segments);
        self.check(of_file.method)?;
        Ok(self.in_place_of(of_file))
    }

    /// Checks that the options apply to a substructure.
    ///
    /// # Errors
    /// The message for an option that does not apply.
    pub(crate) fn check_for_substructure(&self) -> Result<(), &'static str> {
        if self.no_rotary_inertia {
            return Err(
                "--no-rotary-inertia applies only to towers; members have rotary inertia, as in SubDyn",
            );
        }
        if self.no_limits {
            return Err("--no-limits applies only to towers");
        }
        self.check_added_mass()?;
        self.check(Method::Spectral)
    }

    /// Checks that the options apply to the method.
    ///
    /// # Errors
    /// The message for an option that does not apply.
    pub(crate) fn check(&self, method: Method) -> Result<(), &'static str> {
        if self.hinges.is_some() && method != Method::Cardanic {
            return Err(
                "--hinges applies only to --method cardanic; the joint positions of the other methods are fixed",
            );
        }
        Ok(())
    }

    /// Checks that the options apply to a rotating blade.
    ///
    /// # Errors
    /// The message for an option that does not apply.
    pub(crate) fn check_for_blade(&self) -> Result<(), &'static str> {
        if self.no_rotary_inertia {
            return Err(
                "--no-rotary-inertia applies only to towers; the blade model includes rotary inertia",
            );
        }
        if self.no_limits {
            return Err("--no-limits applies only to towers");
        }
        self.check_added_mass()?;
        self.check(Method::Bmodes)
    }

    fn check_added_mass(&self) -> Result<(), &'static str> {
        match self.added_mass {
            Some(_) => Err("--added-mass applies only to towers on floating platforms"),
            None => Ok(()),
        }
    }

    /// Options in which the given ones replace those of `options`.
    pub(crate) fn in_place_of(&self, options: Options) -> Options {
        Options {
            modes: self.modes.unwrap_or(options.modes),
            rotary_inertia: !self.no_rotary_inertia,
            added_mass: self.added_mass.unwrap_or(options.added_mass),
            hinge_position: self.hinges.unwrap_or(GAUSS_HINGE_POSITION),
            limits: !self.no_limits,
            ..options
        }
    }
}

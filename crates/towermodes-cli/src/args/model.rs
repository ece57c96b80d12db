//! Options that hold for all methods and for each command that solves.

use clap::{Arg, Args};
use towermodes::elements::GAUSS_HINGE_POSITION;
use towermodes::{DEFAULT_MODES, Method, Options};

use super::parsers::{hinge_parser, number_parser};
use super::words::{flag, valued};

/// Options that hold for all methods.
#[derive(Debug, Args)]
pub(super) struct ModelArguments {
    /// Number of modes, from the lowest [default: 8; BModes decks: the number in the deck]
    #[arg(long, value_name = "K", value_parser = number_parser(1, usize::MAX))]
    pub(super) modes: Option<usize>,

    /// Neglect the rotary inertia of the sections in bending (with shear = false this is an
    /// Euler-Bernoulli beam)
    #[arg(long)]
    no_rotary_inertia: bool,

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
pub(super) fn up_to_excitations(modes: Arg) -> Arg {
    modes.help(
        "Number of modes, from the lowest [default: 8, or up to 40 if the highest excitation frequency needs more; \
         BModes decks: at least the number in the deck]",
    )
}

impl ModelArguments {
    /// Whether any of these options is given.
    pub(super) fn is_given(&self) -> bool {
        self.modes.is_some() || self.no_rotary_inertia || self.hinges.is_some() || self.no_limits
    }

    /// The options that are given as words of a command line.
    pub(super) fn words(&self) -> Vec<String> {
        [
            valued("--modes", self.modes),
            flag("--no-rotary-inertia", self.no_rotary_inertia),
            valued("--hinges", self.hinges),
            flag("--no-limits", self.no_limits),
        ]
        .concat()
    }

    /// Whether the number of modes is given.
    pub(super) fn has_modes(&self) -> bool {
        self.modes.is_some()
    }

    /// Checks that the options apply to the method.
    ///
    /// # Errors
    /// The message for an option that does not.
    pub(super) fn check(&self, method: Method) -> Result<(), &'static str> {
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
    /// The message for an option that does not.
    pub(super) fn check_for_blade(&self) -> Result<(), &'static str> {
        if self.no_rotary_inertia {
            return Err(
                "--no-rotary-inertia applies only to towers; the blade model includes rotary inertia",
            );
        }
        if self.no_limits {
            return Err("--no-limits applies only to towers");
        }
        self.check(Method::Bmodes)
    }

    /// The default options with these changed.
    pub(super) fn options(&self) -> Options {
        Options {
            modes: self.modes.unwrap_or(DEFAULT_MODES),
            rotary_inertia: !self.no_rotary_inertia,
            hinge_position: self.hinges.unwrap_or(GAUSS_HINGE_POSITION),
            limits: !self.no_limits,
            ..Options::default()
        }
    }
}

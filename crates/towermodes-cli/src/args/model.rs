//! What is asked of every method, by each command that solves.

use clap::Args;
use towermodes::elements::GAUSS_HINGE_POSITION;
use towermodes::{DEFAULT_MODES, Method, Options};

use super::parsers::{hinge_parser, number_parser};

/// What holds whatever the method.
#[derive(Debug, Args)]
pub(super) struct ModelArguments {
    /// How many modes, from the lowest [default: 8; of BModes decks what they ask for]
    #[arg(long, value_name = "K", value_parser = number_parser(1, usize::MAX))]
    pub(super) modes: Option<usize>,

    /// Leave the rotary inertia of the sections out of bending: an Euler-Bernoulli beam
    #[arg(long)]
    no_rotary_inertia: bool,

    /// Where the hinges of the method cardanic sit, as a share of the segment from each end
    /// [default: 0.2113249, the Gauss points]
    #[arg(long, value_name = "SHARE", value_parser = hinge_parser)]
    hinges: Option<f64>,

    /// Solve what would take more than 4 GiB of memory or ten minutes too, as estimated before it
    /// begins; memory may run out then
    #[arg(long)]
    no_limits: bool,
}

impl ModelArguments {
    /// Whether anything is not as it is by default.
    pub(super) fn is_given(&self) -> bool {
        self.modes.is_some() || self.no_rotary_inertia || self.hinges.is_some() || self.no_limits
    }

    /// Whether the number of modes is given.
    pub(super) fn has_modes(&self) -> bool {
        self.modes.is_some()
    }

    /// Refuses what would mean nothing to the only method there is.
    ///
    /// # Errors
    /// What is wrong.
    pub(super) fn check(&self, method: Method) -> Result<(), &'static str> {
        if self.hinges.is_some() && method != Method::Cardanic {
            return Err(
                "--hinges is for --method cardanic; the others have their hinges where they are exact",
            );
        }
        Ok(())
    }

    /// Refuses what would mean nothing to a rotating blade.
    ///
    /// # Errors
    /// What is wrong.
    pub(super) fn check_for_blade(&self) -> Result<(), &'static str> {
        if self.no_rotary_inertia {
            return Err(
                "--no-rotary-inertia is for towers; the sections of a rotating blade keep theirs",
            );
        }
        if self.no_limits {
            return Err("--no-limits is for towers; a rotating blade is solved within its limits");
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

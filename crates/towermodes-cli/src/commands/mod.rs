//! The commands: each has a file or a folder with its options and what it does, and a line in the
//! list below.

mod calibrate;
mod campbell;
mod check;
mod compare;
mod converge;
mod convert;
mod damping;
mod design;
mod elastodyn;
mod explore;
mod parameters;
mod plot;
mod reference;
mod report;
mod sensitivities;
mod shell;
mod solve;
mod sweep;
mod verify;

#[cfg(test)]
pub(crate) use {convert::Target, report::PageFormat, solve::SolveFormat, verify::VerifyFormat};

use std::ffi::OsString;

use clap::{Parser, Subcommand};

use crate::args::Deferred;
use crate::failure::Failure;
use crate::recipe;

/// Natural frequencies and mode shapes of wind turbine towers, with error estimates and a proof, in
/// floating-point arithmetic, that no mode of the model is missing.
#[derive(Debug, Parser)]
#[command(
    name = "towermodes",
    version,
    after_help = "Example:\n  towermodes solve examples/nrel-5mw.toml"
)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// The commands of the program.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Compute the lowest natural frequencies and mode shapes of a tower or of a rotating blade.
    Solve(Deferred<solve::SolveArguments>),
    /// List the input values of a tower by name, for --set and for sweeps.
    Parameters(Deferred<parameters::ParametersArguments>),
    /// Compute the sensitivity of the frequencies to every input value, and the effect of
    /// tolerances.
    Sensitivities(Deferred<sensitivities::SensitivitiesArguments>),
    /// Solve a tower many times with changed input values: the rows of a table or of a sweep study.
    Sweep(Deferred<sweep::SweepArguments>),
    /// Find a light tower whose frequencies are in given bands.
    Design(Deferred<design::DesignArguments>),
    /// Fit input values of a tower to measured frequencies.
    Calibrate(Deferred<calibrate::CalibrateArguments>),
    /// Compare methods: frequencies, differences from the reference solution, degrees of freedom,
    /// run time.
    Compare(Deferred<compare::CompareArguments>),
    /// Show how the error of a method decreases as the number of segments increases.
    Converge(Deferred<converge::ConvergeArguments>),
    /// Check resonance margins (Campbell diagram).
    Campbell(Deferred<campbell::CampbellArguments>),
    /// Compute the damping ratios of the modes from the loss factors of the parts of the tower, and
    /// the aerodynamic damping by the rotor.
    Damping(Deferred<damping::DampingArguments>),
    /// Draw the tower, its mode shapes, its Campbell diagram or the errors of methods as SVG or
    /// PNG.
    Plot(Deferred<plot::PlotArguments>),
    /// Write a report for review, as one HTML page or as Markdown: input, assumptions, frequencies
    /// with errors, mode shapes, resonance margins.
    Report(Deferred<report::ReportArguments>),
    /// Change input values by sliders on a page in the browser; frequencies and mode shapes are
    /// updated.
    Explore(Deferred<explore::ExploreArguments>),
    /// Convert a tower to another format: TOML, BModes, ElastoDyn, windIO.
    Convert(Deferred<convert::ConvertArguments>),
    /// Compare two models of the same tower along its height, or summarise one model.
    Check(Deferred<check::CheckArguments>),
    /// Create, update and validate tower files of ElastoDyn (OpenFAST).
    Elastodyn(elastodyn::ElastoDynArguments),
    /// Check the program against published, analytical and independently computed values.
    Verify(Deferred<verify::VerifyArguments>),
    /// Print a completion script for a shell.
    Completions(shell::CompletionsArguments),
    /// Print the JSON schema of the result that a command writes with `--format json`.
    Schema(shell::SchemaArguments),
    /// Print the manual page of the program or of one of its commands.
    Man(Deferred<shell::ManArguments>),
    /// Print every command with its arguments and options as a chapter of the book.
    #[command(
        hide = true,
        after_help = "Example:\n  towermodes reference > book/src/reference/command-line.md"
    )]
    Reference,
}

impl Command {
    /// Runs the command of a command line.
    pub(crate) fn run(&self, words: &[OsString]) -> Result<(), Failure> {
        match self {
            Self::Solve(arguments) => solve::run(arguments),
            Self::Parameters(arguments) => parameters::run(arguments),
            Self::Sensitivities(arguments) => recipe::run(arguments),
            Self::Sweep(arguments) => sweep::run(arguments),
            Self::Design(arguments) => design::run(arguments),
            Self::Calibrate(arguments) => calibrate::run(arguments),
            Self::Compare(arguments) => recipe::run(arguments),
            Self::Converge(arguments) => recipe::run(arguments),
            Self::Campbell(arguments) => recipe::run(arguments),
            Self::Damping(arguments) => recipe::run(arguments),
            Self::Plot(arguments) => plot::run(arguments),
            Self::Report(arguments) => report::run(arguments, words),
            Self::Explore(arguments) => explore::run(arguments),
            Self::Convert(arguments) => convert::run(arguments),
            Self::Check(arguments) => check::run(arguments),
            Self::Elastodyn(arguments) => elastodyn::run(arguments),
            Self::Verify(arguments) => verify::run(arguments),
            Self::Completions(arguments) => shell::completions(arguments),
            Self::Schema(arguments) => shell::schema(arguments),
            Self::Man(arguments) => shell::man(arguments),
            Self::Reference => reference::run(),
        }
    }
}

//! The command line.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Args, Parser, Subcommand, ValueEnum};
use towermodes::elements::GAUSS_HINGE_POSITION;
use towermodes::{DEFAULT_MODES, DEFAULT_POINTS, MAX_POINTS, MAX_SEGMENTS, Method, Options};

/// Natural frequencies and mode shapes of wind turbine towers, certified.
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

/// What the program does.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Find the lowest natural frequencies and mode shapes of a tower.
    Solve(SolveArguments),
    /// Print a completion script for a shell.
    #[command(
        after_help = "Example:\n  towermodes completions bash > ~/.local/share/bash-completion/completions/towermodes"
    )]
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
    /// Print the JSON schema of the result of `solve --format json`.
    #[command(after_help = "Example:\n  towermodes schema > solve.schema.json")]
    Schema,
    /// Print the manual page, of the program or of one of its commands.
    #[command(after_help = "Example:\n  towermodes man solve | man -l -")]
    Man {
        /// The command.
        #[arg(value_parser = ["solve", "completions", "schema", "man"])]
        of: Option<String>,
    },
}

/// How a result is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people.
    Table,
    /// Everything, shapes included.
    Json,
    /// One line a mode.
    Csv,
}

macro_rules! examples {
    () => {
        "Examples:
  towermodes solve tower.toml
  towermodes solve tower.toml --modes 20 --format json --output modes.json
  towermodes solve tower.toml --method rmje --segments 60
  generate-tower | towermodes solve - --format csv

Exit codes: 0 done, 1 the computation or the output failed, 2 wrong usage or wrong input."
    };
}

/// The examples after the file format in short, for those who have nothing but the program.
const LONG_HELP: &str = concat!(include_str!("tower-file.txt"), "\n", examples!());

/// The arguments of `solve`.
#[derive(Debug, Args)]
#[command(after_help = examples!(), after_long_help = LONG_HELP)]
pub(crate) struct SolveArguments {
    /// The tower (TOML); - is standard input
    pub(crate) file: PathBuf,

    /// Chains of rigid bodies: rmje and cardanic, as published or with exact tapered sections, and lumped as Adams models beams;
    /// bmodes, the finite element of BModes; spectral, the beam itself
    #[arg(long, default_value = Method::RmjeExact.name(), value_parser = method_parser())]
    method: Method,

    /// Segments, or elements [default: 100, and two for each short span between steps, kinks and masses; spectral: one a piece]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Option<usize>,

    /// How many modes, from the lowest
    #[arg(long, value_name = "K", default_value_t = DEFAULT_MODES, value_parser = number_parser(1, usize::MAX))]
    modes: usize,

    /// At how many equal heights the JSON gives shapes
    #[arg(long, value_name = "P", default_value_t = DEFAULT_POINTS, value_parser = number_parser(2, MAX_POINTS))]
    points: usize,

    /// Leave the rotary inertia of the sections out of bending: an Euler-Bernoulli beam
    #[arg(long)]
    no_rotary_inertia: bool,

    /// Where the hinges of --method cardanic sit, as a share of the segment from each end [default: 0.2113249, the Gauss points]
    #[arg(long, value_name = "SHARE", value_parser = hinge_parser)]
    hinges: Option<f64>,

    /// How the result is printed
    #[arg(long, short, value_enum, default_value_t = Format::Table)]
    pub(crate) format: Format,

    /// Write the result to a file instead of standard output (-)
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

impl SolveArguments {
    /// The file the result goes to, if not to standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        self.output
            .as_deref()
            .filter(|path| *path != Path::new("-"))
    }

    /// What the library is asked for.
    pub(crate) fn options(&self) -> Options {
        Options {
            method: self.method,
            segments: self.segments,
            modes: self.modes,
            // Only the JSON has shapes.
            points: if self.format == Format::Json {
                self.points
            } else {
                2
            },
            rotary_inertia: !self.no_rotary_inertia,
            hinge_position: self.hinges.unwrap_or(GAUSS_HINGE_POSITION),
        }
    }
}

fn method_parser() -> impl TypedValueParser<Value = Method> {
    PossibleValuesParser::new(Method::ALL.map(Method::name))
        .map(|name| Method::named(&name).unwrap_or_default())
}

fn hinge_parser(text: &str) -> Result<f64, String> {
    let position = text.parse().ok().filter(|k: &f64| *k > 0.0 && *k < 0.5);
    position.ok_or_else(|| "must be between 0 and 0.5, the middle of a segment".into())
}

/// A whole number from `least` to `most`, with both in the message.
fn number_parser(
    least: usize,
    most: usize,
) -> impl Fn(&str) -> Result<usize, String> + Clone + Send + Sync {
    move |text| match text.parse::<usize>() {
        Ok(number) if (least..=most).contains(&number) => Ok(number),
        _ if most == usize::MAX => Err(format!("must be a whole number, at least {least}")),
        _ => Err(format!("must be a whole number from {least} to {most}")),
    }
}

/// Prints help, or what is wrong with the command line; a file in place of a command gets the command it needs.
pub(crate) fn report(error: &clap::Error) -> ExitCode {
    let _ = error.print();
    let file = std::env::args_os()
        .nth(1)
        .filter(|name| Path::new(name).is_file());
    if let (ErrorKind::InvalidSubcommand, Some(file)) = (error.kind(), file) {
        anstream::eprintln!(
            "\nto solve it: towermodes solve {}",
            Path::new(&file).display()
        );
    }
    ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2))
}

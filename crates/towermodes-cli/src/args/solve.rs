//! The arguments of `solve`.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use towermodes::{DEFAULT_POINTS, MAX_DEGREE, MAX_POINTS, MAX_SEGMENTS, Method, Options};

use super::ending::{Ending, EndingError};
use super::file_of;
use super::input::InputArguments;
use super::model::ModelArguments;
use super::parsers::{method_parser, number_parser};
use super::prescribed::Prescribed;

macro_rules! examples {
    () => {
        "Examples:
  towermodes solve tower.toml
  towermodes solve tower.toml --plot
  towermodes solve tower.toml --modes 20 --output modes.json
  towermodes solve tower.toml --method rmje --segments 60
  towermodes solve tower.toml --method spectral --no-rotary-inertia
  generate-tower | towermodes solve - --format csv
  towermodes solve deck.bmi --format bmodes --output deck.out
  towermodes solve IEA-15-240-RWT.yaml --part tower --no-rna

Exit codes: 0 done, 1 the computation or the output failed, 2 wrong usage or wrong input."
    };
}

/// The examples after the file format in short, for those who have nothing but the program.
const LONG_HELP: &str = concat!(include_str!("tower-file.txt"), "\n", examples!());

/// The arguments of `solve`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = examples!(), after_long_help = LONG_HELP)]
pub(crate) struct SolveArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Chains of rigid bodies: rmje and cardanic, as published or with exact tapered sections, and
    /// lumped as Adams models beams; bmodes, the finite element of BModes; spectral, the beam
    /// itself, exact to ten digits, for reference values, steep cones and towers that nearly buckle
    /// [default: rmje-exact, a chain with errors from other meshes; bmodes for BModes decks]
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,

    /// Segments, or elements
    /// [default: 100, and two for each short span between steps, kinks and masses; spectral: one a
    /// piece; BModes decks: their own elements]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Option<usize>,

    /// Polynomial degree of the elements of --method spectral
    /// [default: raised until the modes stand still]
    #[arg(long, value_name = "P", value_parser = number_parser(2, MAX_DEGREE))]
    degree: Option<usize>,

    #[command(flatten)]
    model: ModelArguments,

    /// At how many equal heights the JSON and the layout of BModes give shapes
    /// [default: 101; BModes decks: the borders of their elements]
    #[arg(long, value_name = "COUNT", value_parser = number_parser(2, MAX_POINTS))]
    points: Option<usize>,

    /// Draw the mode shapes in dots below the table, as wide as the terminal; 100 columns where
    /// there is none
    #[arg(long)]
    pub(crate) plot: bool,

    /// How the result is written
    /// [default: as the ending of --output says: .json, .csv or .txt for the table; else the table]
    #[arg(long, short, value_enum)]
    format: Option<SolveFormat>,

    /// Write the result to a file instead of standard output (-)
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

/// How the modes are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum SolveFormat {
    /// For people.
    Table,
    /// Everything there is, the shapes too.
    Json,
    /// One line a mode.
    Csv,
    /// The layout of an output file of BModes, for scripts that read these.
    Bmodes,
}

impl Ending for SolveFormat {
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("json", Self::Json),
        ("csv", Self::Csv),
        ("txt", Self::Table),
    ];
}

impl SolveArguments {
    /// How the result is written: as told, or as the ending of the file says.
    ///
    /// # Errors
    /// The two do not go together, or the ending says nothing.
    pub(crate) fn format(&self) -> Result<SolveFormat, EndingError> {
        let asked = SolveFormat::asked(self.format, self.output())?;
        Ok(asked.unwrap_or(SolveFormat::Table))
    }

    /// The file the result goes to, if not to standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }

    /// Refuses pictures where there is no table, and numbers of heights where there are no shapes.
    ///
    /// # Errors
    /// What is wrong.
    pub(crate) fn check(&self, format: SolveFormat) -> Result<(), &'static str> {
        let has_shapes = matches!(format, SolveFormat::Json | SolveFormat::Bmodes);
        if self.plot && format != SolveFormat::Table {
            return Err("--plot is for the table; towermodes plot draws files");
        }
        if self.points.is_some() && !has_shapes {
            return Err(
                "--points is for --format json and bmodes; the table and CSV have no shapes",
            );
        }
        Ok(())
    }

    /// Refuses a number of heights where the elements of the file are the heights.
    ///
    /// # Errors
    /// What is wrong.
    pub(crate) fn check_heights(
        &self,
        format: SolveFormat,
        has_own: bool,
    ) -> Result<(), &'static str> {
        if self.points.is_some() && has_own && format == SolveFormat::Bmodes {
            return Err(
                "--points does not go with --format bmodes here: the deck's own elements are the heights; --format json gives shapes at others",
            );
        }
        Ok(())
    }

    /// How many modes are wanted, if it was said here.
    pub(crate) fn modes(&self) -> Option<usize> {
        self.model.modes
    }

    /// Refuses what means nothing to a rotating blade, which has one method and the elements of its
    /// deck.
    ///
    /// # Errors
    /// What is wrong.
    pub(crate) fn check_for_blade(&self) -> Result<(), &'static str> {
        if self.method.is_some_and(|method| method != Method::Bmodes) {
            return Err("a rotating blade is solved by --method bmodes alone");
        }
        if self.segments.is_some() || self.degree.is_some() {
            return Err("a rotating blade has the elements of its deck");
        }
        if self.points.is_some() {
            return Err(
                "--points is for towers; a rotating blade is given at the borders of its elements",
            );
        }
        if self.input.reading.no_rna {
            return Err(
                "a rotating blade has no rotor-nacelle assembly; the body at its tip is in its deck",
            );
        }
        self.model.check_for_blade()
    }

    /// What the library is asked for.
    ///
    /// # Errors
    /// What is wrong if an option means nothing to the method.
    pub(crate) fn options(
        &self,
        prescribed: Prescribed,
        format: SolveFormat,
    ) -> Result<Options, &'static str> {
        let options = prescribed.options(self.method, self.segments, &self.model)?;
        if self.degree.is_some() && options.method != Method::Spectral {
            return Err("--degree is for --method spectral; the others have --segments");
        }
        Ok(Options {
            degree: self.degree,
            // Only the JSON and the pictures have shapes.
            points: match (format, self.plot) {
                (SolveFormat::Json, _) => self.points(),
                (_, true) => DEFAULT_POINTS,
                _ => 2,
            },
            ..options
        })
    }

    /// At how many equal heights shapes are wanted.
    pub(crate) fn points(&self) -> usize {
        self.points.unwrap_or(DEFAULT_POINTS)
    }
}

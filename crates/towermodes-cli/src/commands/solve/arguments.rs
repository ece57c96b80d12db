//! The arguments of `solve`.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use towermodes::frame::{FrameOptions, FrameRecipe};
use towermodes::{DEFAULT_POINTS, MAX_DEGREE, MAX_POINTS, MAX_SEGMENTS, Method, Options};
use towermodes_files::{Interface, SubdynInput, TowerInput};

use crate::args::parsers::number_parser;
use crate::args::{Destination, Ending, ModelArguments, ReadingArguments};

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
  towermodes solve examples/*.toml --output frequencies.csv
  towermodes solve examples/tripod_SubDyn.dat --method subdyn
  towermodes solve examples/spar_MoorDyn.dat

Exit codes: 0 done, 1 the computation or the output failed, 2 wrong usage or wrong input."
    };
}

/// The tower file format in short, then the examples.
const LONG_HELP: &str = concat!(include_str!("tower-file.txt"), "\n", examples!());

const SEGMENTS: &str = "Number of segments (bmodes and spectral: elements) [default: 100, plus 2 for each part shorter than 1/50 of the tower height; a part is a piece of the tower between steps, changes of taper or material, and point masses; spectral: one per part; BModes decks: the elements of the deck]";

/// The arguments of `solve`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = examples!(), after_long_help = LONG_HELP)]
pub(crate) struct SolveArguments {
    /// Tower file (.toml), BModes deck (.bmi), ElastoDyn main or tower file (.dat, or the .fst that
    /// refers to it), windIO turbine (.yaml), HAWC2 _st.dat, SubDyn file, or MoorDyn or MAP++ file
    /// (tensions and stiffness of the lines at rest); the format is detected from content and name;
    /// use - for standard input. Several files give one table of frequencies, with a column for
    /// each file
    #[arg(required = true, value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,

    #[command(flatten)]
    pub(crate) reading: ReadingArguments,

    /// Method of computation [default: rmje-exact; bmodes for BModes decks; spectral for SubDyn
    /// files]
    #[arg(long, value_parser = computation_parser())]
    method: Option<Computation>,

    #[arg(long, value_name = "N", help = SEGMENTS, value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Option<usize>,

    #[command(flatten)]
    pub(crate) model: ModelArguments,

    /// Polynomial degree of the elements of --method spectral
    /// [default: raised until the frequencies converge]
    #[arg(long, value_name = "P", value_parser = number_parser(2, MAX_DEGREE))]
    degree: Option<usize>,

    /// Number of equally spaced heights for mode shapes in JSON and BModes output
    /// [default: 101; BModes output for a BModes deck: the element boundaries of the deck]
    #[arg(long, value_name = "COUNT", value_parser = number_parser(2, MAX_POINTS))]
    points: Option<usize>,

    /// Add the derivatives of the frequencies with respect to every input value to the JSON
    /// result; towermodes sensitivities shows them as a table
    #[arg(long)]
    pub(crate) sensitivities: bool,

    /// Draw the mode shapes as text graphics below the table, as wide as the terminal, or 100
    /// columns if the output is not a terminal
    #[arg(long)]
    pub(crate) plot: bool,

    #[command(flatten)]
    pub(crate) destination: Destination<SolveFormat>,
}

const ONLY_SUBDYN: &str = "--method subdyn applies only to SubDyn files";

/// A method for towers, or the element of SubDyn for the members of a substructure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Computation {
    /// A method of the library.
    Tower(Method),
    /// SubDyn's element.
    Subdyn,
}

/// The name of the method that is only for substructures.
const SUBDYN: &str = "subdyn";

fn computation_parser() -> impl TypedValueParser<Value = Computation> {
    let value = |method: Method| PossibleValue::new(method.name()).help(method.description());
    let subdyn = "the element of SubDyn, only for SubDyn files: NDiv parts of each member";
    let subdyn = PossibleValue::new(SUBDYN).help(subdyn);
    let values = Method::ALL.map(value).into_iter().chain([subdyn]);
    PossibleValuesParser::new(values).map(|name| match name.as_str() {
        SUBDYN => Computation::Subdyn,
        name => Computation::Tower(Method::named(name).unwrap_or_default()),
    })
}

/// The format of the modes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum SolveFormat {
    /// Human-readable table.
    Table,
    /// All results, including mode shapes.
    Json,
    /// One line per mode.
    Csv,
    /// The layout of a BModes output file.
    Bmodes,
}

impl Ending for SolveFormat {
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("json", Self::Json),
        ("csv", Self::Csv),
        ("txt", Self::Table),
    ];
    const DEFAULT: Self = Self::Table;
}

impl SolveArguments {
    /// Checks that --plot and --points apply to the format.
    ///
    /// # Errors
    /// The message for an option that does not apply.
    pub(crate) fn check(&self, format: SolveFormat) -> Result<(), &'static str> {
        let has_shapes = matches!(format, SolveFormat::Json | SolveFormat::Bmodes);
        if self.plot && format != SolveFormat::Table {
            return Err("--plot applies only to the table; use towermodes plot for a picture file");
        }
        if self.sensitivities && format != SolveFormat::Json {
            return Err(
                "--sensitivities applies only to --format json; use towermodes sensitivities for a table",
            );
        }
        if self.points.is_some() && !has_shapes {
            return Err(
                "--points applies only to --format json and bmodes; the table and CSV contain no mode shapes",
            );
        }
        Ok(())
    }

    /// Checks that the options apply to several files at once.
    ///
    /// # Errors
    /// The message for an option that applies to one file only.
    pub(crate) fn check_for_several(&self, format: SolveFormat) -> Result<(), &'static str> {
        if self.plot {
            return Err("--plot applies only to one file; solve each file in a separate command");
        }
        if self.sensitivities {
            return Err(
                "--sensitivities applies only to one file; solve each file in a separate command",
            );
        }
        if format == SolveFormat::Bmodes {
            return Err(
                "--format bmodes applies only to one file, because the layout of BModes stores one tower; solve each file in a separate command",
            );
        }
        if self
            .files
            .iter()
            .filter(|file| *file == Path::new("-"))
            .count()
            > 1
        {
            return Err("standard input (-) can be given for only one of the files");
        }
        Ok(())
    }

    /// Checks that --points is not given if the elements of the file determine the heights.
    ///
    /// # Errors
    /// The message for an option that does not apply.
    pub(crate) fn check_heights(
        &self,
        format: SolveFormat,
        has_own: bool,
    ) -> Result<(), &'static str> {
        if self.points.is_some() && has_own && format == SolveFormat::Bmodes {
            return Err(
                "--points does not apply to --format bmodes with a BModes deck: the mode shapes are at the element boundaries of the deck; use --format json for other heights",
            );
        }
        Ok(())
    }

    /// Checks that the options apply to a rotating blade: it has one method, and its deck gives
    /// the elements.
    ///
    /// # Errors
    /// The message for an option that does not apply.
    pub(crate) fn check_for_blade(&self) -> Result<(), &'static str> {
        if self
            .method
            .is_some_and(|method| method != Computation::Tower(Method::Bmodes))
        {
            return Err("a rotating blade can be solved only with --method bmodes");
        }
        if self.segments.is_some() || self.degree.is_some() {
            return Err(
                "--segments and --degree do not apply to a rotating blade: its elements are given in the deck",
            );
        }
        if self.points.is_some() {
            return Err(
                "--points applies only to towers; mode shapes of a blade are at its element boundaries",
            );
        }
        if self.sensitivities {
            return Err("--sensitivities applies only to towers");
        }
        if !self.reading.settings.is_empty() {
            return Err("--set applies only to towers; change the deck of a rotating blade itself");
        }
        if self.reading.no_rna {
            return Err(
                "--no-rna does not apply to a rotating blade; its tip body is given in the deck",
            );
        }
        self.model.check_for_blade()
    }

    /// Checks that the options apply to a substructure.
    ///
    /// # Errors
    /// The message for an option that does not apply.
    pub(crate) fn check_for_substructure(&self, format: SolveFormat) -> Result<(), &'static str> {
        let given = self.reading.options();
        let only_for_towers = [
            (
                self.segments.is_some(),
                "--segments applies only to towers; the elements of a substructure are its members",
            ),
            (
                self.points.is_some(),
                "--points applies only to towers; mode shapes of a substructure are at its joints",
            ),
            (self.sensitivities, "--sensitivities applies only to towers"),
            (
                self.plot,
                "--plot applies only to towers and rotating blades",
            ),
            (
                format == SolveFormat::Bmodes,
                "--format bmodes applies only to towers and rotating blades; its layout has no joints",
            ),
            (
                !self.reading.settings.is_empty(),
                "--set applies only to towers; change the SubDyn file itself",
            ),
            (
                given.without_rna,
                "--no-rna does not apply to a SubDyn file, which has no rotor-nacelle assembly",
            ),
            (
                given.without_gravity,
                "--no-gravity does not apply to a SubDyn file, which is solved without gravity",
            ),
        ];
        if let Some((_, message)) = only_for_towers.into_iter().find(|(given, _)| *given) {
            return Err(message);
        }
        self.model.check_for_substructure()
    }

    /// Checks that no option is given that applies to modes, because mooring lines have none.
    ///
    /// # Errors
    /// The message for an option that does not apply.
    pub(crate) fn check_for_mooring(&self, format: SolveFormat) -> Result<(), &'static str> {
        let given = self.reading.options();
        let of_modes = self.method.is_some()
            || self.segments.is_some()
            || self.degree.is_some()
            || self.points.is_some()
            || self.sensitivities
            || self.plot
            || format == SolveFormat::Bmodes
            || !self.reading.settings.is_empty()
            || given.without_rna
            || given.without_gravity
            || self.model.is_given();
        match of_modes {
            true => Err(
                "a file of mooring lines has no modes: only the options --format and --output of solve apply",
            ),
            false => Ok(()),
        }
    }

    /// The options for a substructure, and whether its interface joints are fixed.
    ///
    /// # Errors
    /// The message for a method that does not apply.
    pub(crate) fn for_substructure(
        &self,
        input: &SubdynInput,
    ) -> Result<(FrameOptions, Interface), &'static str> {
        let recipe = match (self.method, self.degree) {
            (Some(Computation::Subdyn), None) => Some(input.recipe()),
            (Some(Computation::Subdyn), Some(_)) => {
                return Err("--degree does not apply to --method subdyn, whose elements are given");
            }
            (None | Some(Computation::Tower(Method::Spectral)), degree) => {
                degree.map(|degree| FrameRecipe::Spectral { degree })
            }
            (Some(Computation::Tower(_)), _) => {
                return Err(
                    "a SubDyn file can be solved only with --method spectral or --method subdyn",
                );
            }
        };
        let interface = match (self.reading.clamped, input.interface_joints.is_empty()) {
            (false, _) => Interface::Free,
            (true, false) => Interface::Held,
            (true, true) => {
                return Err(
                    "--clamped fixes the interface joints, but the file has none (NInterf is 0)",
                );
            }
        };
        let default = FrameOptions::default();
        let modes = self.model.modes.unwrap_or(default.modes);
        let options = FrameOptions {
            modes,
            recipe,
            ..default
        };
        Ok((options, interface))
    }

    /// Whether the number of modes is given.
    pub(crate) fn asks_for_modes(&self) -> bool {
        self.model.modes.is_some()
    }

    /// The options of the library.
    ///
    /// # Errors
    /// The message for an option that does not apply to the method.
    pub(crate) fn options(
        &self,
        input: &TowerInput,
        format: SolveFormat,
    ) -> Result<Options, &'static str> {
        let method = match self.method {
            Some(Computation::Subdyn) => return Err(ONLY_SUBDYN),
            Some(Computation::Tower(method)) => Some(method),
            None => None,
        };
        let options = self.model.options(input, method, self.segments)?;
        if self.degree.is_some() && options.method != Method::Spectral {
            return Err(
                "--degree applies only to --method spectral; use --segments for the other methods",
            );
        }
        Ok(Options {
            degree: self.degree,
            // Only JSON and the pictures contain mode shapes.
            points: match (format, self.plot) {
                (SolveFormat::Json, _) => self.points(),
                (_, true) => DEFAULT_POINTS,
                _ => 2,
            },
            ..options
        })
    }

    /// Number of equally spaced heights of the mode shapes.
    pub(crate) fn points(&self) -> usize {
        self.points.unwrap_or(DEFAULT_POINTS)
    }
}

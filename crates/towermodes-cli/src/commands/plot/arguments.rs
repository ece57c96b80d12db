//! The arguments of `plot`.

use std::path::{Path, PathBuf};

use clap::{Arg, Args, ValueEnum};
use towermodes::{MAX_SEGMENTS, Method, Options};
use towermodes_files::TowerInput;
use towermodes_report::svg::{Look, Theme};

use crate::args::parsers::{method_parser, number_parser, scale_parser};
use crate::args::{InputArguments, ModelArguments, RotorArguments, TurbineArguments, file_of};

const EXAMPLES: &str = "Examples:
  towermodes plot tower.toml --output shapes.svg
  towermodes plot tower.toml --what tower --output tower.png --scale 3
  towermodes plot tower.toml --what campbell --rpm 6.9,12.1 --output campbell.svg
  towermodes plot tower.toml --what convergence --method rmje --segments 10,20,40,80 --dark --output rmje.svg
  towermodes plot tower.toml --what error --png > error.png

An SVG follows the light or dark setting of the viewer; --dark makes it always dark. For mode shapes in the terminal use solve --plot.";

/// The arguments of `plot`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("modes", for_pictures))]
pub(crate) struct PlotArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Type of picture
    #[arg(long, value_enum, default_value_t = What::Shapes)]
    pub(crate) what: What,

    /// Method of computation, for shapes, structure, campbell and convergence
    /// [default: rmje-exact; bmodes for BModes decks, except for convergence]
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,

    /// Number of segments (bmodes and spectral: elements); for convergence a comma-separated list
    /// [default: same as solve for shapes and campbell, same as converge for convergence, 60 for
    /// error]
    #[arg(long, value_name = "N", value_delimiter = ',', value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Vec<usize>,

    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pub(crate) rotor: RotorArguments,

    #[command(flatten)]
    pub(crate) turbine: TurbineArguments,

    /// Title above the picture, '' for none
    /// [default: name of the tower, type of picture, method]
    #[arg(long, value_name = "TEXT")]
    pub(crate) title: Option<String>,

    /// Write the picture to a file, as SVG or PNG depending on the extension. Without this option
    /// the picture goes to standard output; if that is a terminal, the command stops with an
    /// error. With - the picture goes to standard output in any case
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,

    /// Write PNG regardless of the file extension
    #[arg(long)]
    png: bool,

    /// Dark background
    #[arg(long)]
    dark: bool,

    /// Scale of a PNG; at 1 the picture is about 900 pixels wide [default: 2]
    #[arg(long, value_parser = scale_parser)]
    scale: Option<f64>,
}

/// The help of `--modes`: the default depends on the picture.
fn for_pictures(modes: Arg) -> Arg {
    modes.help(
        "Number of modes, from the lowest [default: 8; BModes decks: the number in the deck; campbell: more, up to 40, if \
         the highest excitation frequency needs them]",
    )
}

/// The type of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum What {
    /// The tower to scale, with RNA, point masses, foundation, soil and water.
    Tower,
    /// The mode shapes, side by side.
    Shapes,
    /// The whole structure in its modes, in space: the tower with the members or the floating
    /// platform under it.
    Structure,
    /// Error of a method over the number of segments.
    Convergence,
    /// Campbell diagram: natural frequencies and excitations over rotor speed.
    Campbell,
    /// Difference of each method from the reference solution, mode by mode.
    Error,
    /// First bending frequencies over the stiffness of soil and foundation, from a quarter to four
    /// times the stiffness of the file.
    Soil,
    /// First bending frequencies over the depth of local scour, up to two pile diameters; only with
    /// soil in layers.
    Scour,
}

/// The format of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum PictureFormat {
    /// As SVG.
    Svg(Look),
    /// As PNG, with this number of pixels per unit.
    Png(Theme, f64),
}

impl PlotArguments {
    /// The given output, including `-`.
    pub(crate) fn asked_output(&self) -> Option<&Path> {
        self.output.as_deref()
    }

    /// The file that the picture is written to; none for standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }

    /// Checks that the options apply to this type of picture.
    ///
    /// # Errors
    /// The message for an option that does not.
    pub(crate) fn check(&self) -> Result<(), &'static str> {
        let solves = self.what != What::Tower;
        let has_method = solves && self.what != What::Error;
        if !has_method && self.method.is_some() {
            return Err(
                "--method does not apply to --what tower, which is not solved, and to --what error, which shows all methods",
            );
        }
        if !solves && (self.model.is_given() || !self.segments.is_empty()) {
            return Err(
                "--what tower does not solve the tower; --modes, --segments, --no-rotary-inertia, --hinges and --no-limits apply to the other pictures",
            );
        }
        if self.what == What::Convergence {
            self.model.check(self.method.unwrap_or_default())?;
        }
        let has_rotor = matches!(self.what, What::Campbell | What::Soil | What::Scour);
        if !has_rotor && self.rotor.is_given() {
            return Err(
                "--rpm, --blades, --multiples and --margin apply only to --what campbell, soil and scour",
            );
        }
        let of_turbine = self.turbine.is_given() || self.turbine.uncoupled;
        if self.what != What::Campbell && of_turbine {
            return Err(
                "--generator, --limit, --speeds and --uncoupled apply only to --what campbell",
            );
        }
        if self.what != What::Convergence && self.segments.len() > 1 {
            return Err(
                "a list of numbers of segments applies only to --what convergence; give one number",
            );
        }
        if self.what == What::Convergence
            && self.method == Some(Method::Spectral)
            && !self.segments.is_empty()
        {
            return Err(
                "--segments does not apply to --method spectral, whose degree is varied from 4 to 14; omit --segments",
            );
        }
        Ok(())
    }

    /// The file format of the picture.
    ///
    /// # Errors
    /// The message if the file extension is unknown or contradicts an option.
    pub(crate) fn format(&self) -> Result<PictureFormat, &'static str> {
        if self.output().is_some_and(Path::is_dir) {
            return Err(
                "the output is a folder; give the path of a file in it, for example FOLDER/picture.svg",
            );
        }
        let ending = self.output().map(|path| {
            let ending = path.extension().unwrap_or_default();
            ending.to_string_lossy().to_ascii_lowercase()
        });
        let is_png = match (ending.as_deref(), self.png) {
            (Some("svg"), true) => {
                return Err("--png contradicts the file extension .svg; change one of them");
            }
            (Some("svg") | None, false) => false,
            (Some("png"), _) | (_, true) => true,
            _ => {
                return Err(
                    "unknown file extension for a picture; use .svg or .png, or --png to write PNG to any file",
                );
            }
        };
        if !is_png && self.scale.is_some() {
            return Err("--scale applies only to PNG");
        }
        Ok(match (is_png, self.dark) {
            (true, false) => PictureFormat::Png(Theme::Light, self.scale.unwrap_or(2.0)),
            (true, true) => PictureFormat::Png(Theme::Dark, self.scale.unwrap_or(2.0)),
            (false, false) => PictureFormat::Svg(Look::Standalone),
            (false, true) => PictureFormat::Svg(Look::Fixed(Theme::Dark)),
        })
    }

    /// Whether the number of modes is given.
    pub(crate) fn has_modes(&self) -> bool {
        self.model.modes.is_some()
    }

    /// The solver options for mode shapes and the Campbell diagram.
    ///
    /// # Errors
    /// The message for an option that does not apply to the method.
    pub(crate) fn options(&self, input: &TowerInput) -> Result<Options, &'static str> {
        let segments = self.segments.first().copied();
        let of_file = input.prescribed.options(self.method, segments);
        self.model.check(of_file.method)?;
        Ok(self.model.in_place_of(of_file))
    }

    /// The options of a convergence study or a comparison of methods.
    pub(crate) fn study_options(&self) -> Options {
        self.model.in_place_of(Options {
            method: self.method.unwrap_or_default(),
            ..Options::default()
        })
    }

    /// Whether options are given that apply only to the tower with a rigid rotor.
    pub(crate) fn is_of_tower_alone(&self) -> bool {
        self.method.is_some() || !self.segments.is_empty() || self.model.is_given()
    }

    /// The given numbers of segments.
    pub(crate) fn segments(&self) -> &[usize] {
        &self.segments
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;
    use towermodes_report::svg::{Look, Theme};

    use super::{PictureFormat, PlotArguments};

    #[derive(Debug, Parser)]
    struct Line {
        #[command(flatten)]
        plot: PlotArguments,
    }

    fn format(words: &str) -> Result<PictureFormat, &'static str> {
        let words = format!("plot tower.toml {words}");
        let line = Line::try_parse_from(words.split_whitespace()).expect("a command line");
        line.plot.check().and_then(|()| line.plot.format())
    }

    #[test]
    fn the_ending_says_how_a_picture_is_written() {
        assert_eq!(format(""), Ok(PictureFormat::Svg(Look::Standalone)));
        assert_eq!(
            format("-o a.SVG --dark"),
            Ok(PictureFormat::Svg(Look::Fixed(Theme::Dark)))
        );
        let light = Ok(PictureFormat::Png(Theme::Light, 2.0));
        assert_eq!(format("-o a.png"), light);
        assert_eq!(format("-o a.bin --png"), light);
        assert_eq!(format("--png -o -"), light);
        assert_eq!(
            format("--png --scale 0.5 --dark"),
            Ok(PictureFormat::Png(Theme::Dark, 0.5))
        );
    }

    #[test]
    fn what_would_do_nothing_is_refused() {
        let refused = [
            "-o a.pdf",
            "-o a.svg --png",
            "-o /dev/null",
            "-o a.svg --scale 3",
            "--scale 3",
            "--what tower --modes 3",
            "--what tower --method rmje",
            "--what error --method rmje",
            "--what error --segments 9,10",
            "--what tower --segments 9",
            "--what tower --no-rotary-inertia",
            "--what tower --hinges 0.2",
            "--what convergence --hinges 0.2",
            "--rpm 12",
            "--margin 5",
            "--what tower --margin 5",
            "--uncoupled",
            "--what soil --limit 3",
            "--what shapes --segments 9,10",
            "--what convergence --method spectral --segments 9",
        ];
        for words in refused {
            assert!(format(words).is_err(), "{words}");
        }
        for words in ["-o src", "-o src/", "-o src --png"] {
            let said = format(words).expect_err(words);
            assert!(said.contains("is a folder"), "{words}: {said}");
        }
        for words in [
            "--what campbell --rpm 12 --segments 9",
            "--what campbell --margin 5",
            "--what campbell --uncoupled",
            "--what campbell --limit 3 --speeds 9",
            "-o /dev/null --png",
            "--what convergence --method rmje --segments 9,10",
            "--what convergence --method cardanic --hinges 0.2",
            "--what error --segments 9 --no-rotary-inertia --hinges 0.2",
        ] {
            assert!(format(words).is_ok(), "{words}");
        }
    }
}

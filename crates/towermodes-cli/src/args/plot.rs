//! The arguments of `plot`.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use towermodes::{MAX_SEGMENTS, Method, Options};
use towermodes_report::svg::{Look, Theme};

use super::file_of;
use super::input::InputArguments;
use super::model::ModelArguments;
use super::parsers::{method_parser, number_parser, scale_parser};
use super::prescribed::Prescribed;
use super::rotor::RotorArguments;

const EXAMPLES: &str = "Examples:
  towermodes plot tower.toml --output shapes.svg
  towermodes plot tower.toml --what tower --output tower.png --scale 3
  towermodes plot tower.toml --what campbell --rpm 6.9,12.1 --output campbell.svg
  towermodes plot tower.toml --what convergence --method rmje --segments 10,20,40,80 --dark --output rmje.svg
  towermodes plot tower.toml --what error --png > error.png

An SVG follows the reader's choice of light or dark; with --dark it is dark everywhere. For pictures in the terminal: solve --plot.";

/// The arguments of `plot`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct PlotArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// What the picture is of
    #[arg(long, value_enum, default_value_t = What::Shapes)]
    pub(crate) what: What,

    /// The method whose modes or whose convergence is shown [default: as of solve, and of converge]
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,

    /// Segments, or elements; of convergence several numbers with commas between them
    /// [default: as of solve, of converge, and of compare]
    #[arg(long, value_name = "N", value_delimiter = ',', value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Vec<usize>,

    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pub(crate) rotor: RotorArguments,

    /// The title above the picture, '' for none
    /// [default: the tower's name, what is shown, and how it was computed]
    #[arg(long, value_name = "TEXT")]
    pub(crate) title: Option<String>,

    /// Write the picture to a file, as SVG or PNG by its ending, instead of standard output, which
    /// must be no terminal unless - is given here
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,

    /// Write PNG whatever the ending
    #[arg(long)]
    png: bool,

    /// Light on dark
    #[arg(long)]
    dark: bool,

    /// Pixels of a PNG for each unit of the drawing, which is about 900 wide [default: 2]
    #[arg(long, value_parser = scale_parser)]
    scale: Option<f64>,
}

/// What a picture is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum What {
    /// The tower to scale, with what is on it, under it and around it.
    Tower,
    /// The mode shapes, side by side.
    Shapes,
    /// How the error of a method falls as its segments get more.
    Convergence,
    /// Natural frequencies and the rotor's excitations over its speed.
    Campbell,
    /// How far each method is from the exact beam, mode by mode.
    Error,
}

/// How a picture is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum PictureFormat {
    /// As SVG.
    Svg(Look),
    /// As PNG, with so many pixels a unit.
    Png(Theme, f64),
}

impl PlotArguments {
    /// What was given as output, `-` too.
    pub(crate) fn asked_output(&self) -> Option<&Path> {
        self.output.as_deref()
    }

    /// The file the picture goes to, if not to standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }

    /// Refuses what would do nothing to this picture.
    ///
    /// # Errors
    /// What is wrong.
    pub(crate) fn check(&self) -> Result<(), &'static str> {
        let solves = self.what != What::Tower;
        let has_method = solves && self.what != What::Error;
        if !has_method && self.method.is_some() {
            return Err(
                "--method is for --what shapes, campbell and convergence; error is of all methods, and tower of none",
            );
        }
        if !solves && (self.model.is_given() || !self.segments.is_empty()) {
            return Err(
                "--what tower solves nothing; --modes, --segments, --no-rotary-inertia and --hinges are for the others",
            );
        }
        if self.what == What::Convergence {
            self.model.check(self.method.unwrap_or_default())?;
        }
        if self.what != What::Campbell && self.rotor.is_given() {
            return Err("--rpm, --blades, --multiples and --margin are for --what campbell");
        }
        if self.what != What::Convergence && self.segments.len() > 1 {
            return Err("several numbers of segments are for --what convergence");
        }
        if self.what == What::Convergence
            && self.method == Some(Method::Spectral)
            && !self.segments.is_empty()
        {
            return Err(
                "the spectral beam converges with its degree, here from 4 to 14; leave --segments out",
            );
        }
        Ok(())
    }

    /// How the picture is written.
    ///
    /// # Errors
    /// What is wrong if the ending of the file says nothing, or something else.
    pub(crate) fn format(&self) -> Result<PictureFormat, &'static str> {
        if self.output().is_some_and(Path::is_dir) {
            return Err(
                "the output is a folder; give the path of a file in it, as FOLDER/picture.svg",
            );
        }
        let ending = self.output().map(|path| {
            let ending = path.extension().unwrap_or_default();
            ending.to_string_lossy().to_ascii_lowercase()
        });
        let is_png = match (ending.as_deref(), self.png) {
            (Some("svg"), true) => return Err("--png does not go with a file that ends in .svg"),
            (Some("svg") | None, false) => false,
            (Some("png"), _) | (_, true) => true,
            _ => {
                return Err(
                    "the file must end in .svg or .png, which says how the picture is written; --png writes PNG whatever the ending",
                );
            }
        };
        if !is_png && self.scale.is_some() {
            return Err("--scale is for PNG; an SVG has no pixels");
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
        self.model.has_modes()
    }

    /// How the modes of shapes, or of the resonance diagram, are found.
    ///
    /// # Errors
    /// What is wrong if an option means nothing to the method.
    pub(crate) fn options(&self, prescribed: Prescribed) -> Result<Options, &'static str> {
        prescribed.options(self.method, self.segments.first().copied(), &self.model)
    }

    /// What convergence, or the comparison of methods, is asked for.
    pub(crate) fn study_options(&self) -> Options {
        Options {
            method: self.method.unwrap_or_default(),
            ..self.model.options()
        }
    }

    /// The numbers of segments whose errors are shown, if they were said.
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
            "-o /dev/null --png",
            "--what convergence --method rmje --segments 9,10",
            "--what convergence --method cardanic --hinges 0.2",
            "--what error --segments 9 --no-rotary-inertia --hinges 0.2",
        ] {
            assert!(format(words).is_ok(), "{words}");
        }
    }
}

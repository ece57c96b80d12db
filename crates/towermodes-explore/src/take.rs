//! Files to download: the tower, its report, its pictures.

use serde::Deserialize;
use thiserror::Error;
use towermodes_analysis::resonance::GivenRotor;
use towermodes_files::{FileFormat, Rewritten, TowerInput, rewritten};
use towermodes_report::figures::{self, TitleWords, titled};
use towermodes_report::raster::{self, RasterError};
use towermodes_report::svg::{Figure, Look, Theme};
use towermodes_report::wording::computed_by;

use super::explorer::{Exploration, Explorer, Solved};
use super::refusal::Refusal;
use super::state::State;

/// Pixels for each unit of a picture.
const SCALE: f64 = 2.0;

/// A request for a file.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Take {
    /// The changed input values.
    #[serde(flatten)]
    pub state: State,
    /// The requested file.
    pub what: What,
    /// The format of a picture.
    #[serde(default)]
    pub format: PictureFormat,
}

/// The files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum What {
    /// The tower file.
    Tower,
    /// The report.
    Report,
    /// The drawing of the tower.
    TowerPicture,
    /// The mode shapes.
    ShapesPicture,
    /// The resonance diagram.
    ResonancePicture,
}

/// The formats of pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PictureFormat {
    /// SVG.
    #[default]
    Svg,
    /// PNG.
    Png,
}

/// A file to download.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Taken {
    /// Its name: letters, digits, `-`, `_` and `.`.
    pub name: String,
    /// Its media type.
    pub media_type: &'static str,
    /// Its content.
    pub content: Vec<u8>,
}

/// Why there is no file.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TakeError {
    /// The tower is refused.
    #[error("{}", .0.refused.message)]
    Refused(Refusal),
    /// There is no resonance diagram without a rotor.
    #[error("there is no resonance diagram, because the rotor speed is unknown")]
    NoRotor,
    /// The picture has too many pixels.
    #[error(transparent)]
    Picture(#[from] RasterError),
    /// The report cannot be made.
    #[error("{0}")]
    Report(String),
}

impl From<Refusal> for TakeError {
    fn from(refusal: Refusal) -> Self {
        Self::Refused(refusal)
    }
}

impl Explorer {
    /// The requested file for the tower with changed input values.
    ///
    /// # Errors
    /// [`TakeError`].
    pub fn take(&self, take: &Take) -> Result<Taken, TakeError> {
        Taken::new(self, take)
    }
}

impl Taken {
    pub(crate) fn new(explorer: &Explorer, take: &Take) -> Result<Self, TakeError> {
        let stem = stem(&explorer.exploration.file);
        match take.what {
            What::Tower => {
                let (mut input, _) = explorer.changed(&take.state)?;
                // Speeds and blades of the command line.
                let given = &explorer.exploration.rotor;
                if *given != GivenRotor::default() {
                    let rotor = explorer.rotor(&input);
                    input.description.rotor = rotor.or(input.description.rotor);
                }
                let file = rewritten(&explorer.exploration.input, &input.description);
                let head = head(&explorer.exploration, &file);
                Ok(Self {
                    // The original may lie in the same folder.
                    name: format!("{stem}-variant.toml"),
                    media_type: "application/toml",
                    content: (head + &file.text).into_bytes(),
                })
            }
            What::Report => {
                let (input, _) = explorer.changed(&take.state)?;
                let words = explorer.words("report", &take.state);
                let page = (explorer.exploration.report)(input, &words);
                Ok(Self {
                    name: format!("{stem}-report.html"),
                    media_type: "text/html; charset=utf-8",
                    content: page.map_err(TakeError::Report)?.into_bytes(),
                })
            }
            What::TowerPicture | What::ShapesPicture | What::ResonancePicture => {
                let solved = explorer.solved(&take.state)?;
                picture(&solved, take, &stem)
            }
        }
    }
}

/// The comments at the top of a newly written file: the file that it is written from, and data that
/// it does not contain.
fn head(of: &Exploration, file: &Rewritten) -> String {
    if file.anew.is_none() {
        return String::new();
    }
    let source = of.file.replace(char::is_control, " ");
    let lines = [format!("From {source} by towermodes explore.")];
    let lines = lines.into_iter().chain(left_out(&of.input, file));
    lines.map(|line| format!("# {line}\n")).collect()
}

/// Data of the original file that a tower file does not contain, in sentences.
pub(crate) fn left_out(input: &TowerInput, file: &Rewritten) -> Vec<String> {
    let Some(reason) = &file.anew else {
        return Vec::new();
    };
    let mut lacks = vec![format!(
        "comments of the old file are left out, because {reason}"
    )];
    lacks.extend(file.notes.iter().map(|note| note.message.clone()));
    let has_turbine = file.text.contains("\n[turbine]\n");
    let is_noted = input.format == FileFormat::Toml;
    if input.turbine.is_some() && !has_turbine && !is_noted {
        lacks.push("nacelle and rotor are one rigid body, without blades".to_owned());
    } else if input.blade.is_some() && !has_turbine {
        lacks.push("blades are left out".to_owned());
    }
    lacks.iter().map(|text| sentence(text)).collect()
}

fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).chain(['.']).collect()
}

fn picture(solved: &Solved, take: &Take, stem: &str) -> Result<Taken, TakeError> {
    let (figure, computed, conclusion) = drawn(solved, take.what)?;
    let words = TitleWords {
        title: None,
        computed: computed.as_deref(),
        conclusion: &conclusion,
    };
    let name = figure.name.clone();
    let figure = titled(figure, &solved.tower, &words);
    let (ending, media_type, content) = match take.format {
        PictureFormat::Svg => {
            let svg = figure.to_svg(Look::Standalone).into_bytes();
            ("svg", "image/svg+xml", svg)
        }
        PictureFormat::Png => (
            "png",
            "image/png",
            raster::png(&figure, Theme::Light, SCALE)?,
        ),
    };
    Ok(Taken {
        name: format!("{stem}-{name}.{ending}"),
        media_type,
        content,
    })
}

/// A figure with its method and its conclusion.
type Drawn = (Figure, Option<String>, Vec<String>);

fn drawn(solved: &Solved, what: What) -> Result<Drawn, TakeError> {
    let description = &solved.input.description;
    let computed = Some(computed_by(&solved.solution));
    match (what, &solved.assessment) {
        (What::ResonancePicture, None) => Err(TakeError::NoRotor),
        (What::ResonancePicture, Some(of)) => {
            let conclusion = of.campbell.conclusion();
            Ok((figures::campbell(&of.campbell), computed, conclusion))
        }
        (What::ShapesPicture, _) => {
            let figure = figures::shapes(description, &solved.tower, &solved.solution);
            Ok((figure, computed, Vec::new()))
        }
        _ => Ok((figures::tower(description, &solved.tower), None, Vec::new())),
    }
}

/// The name of a file without folder and extension, in characters that every system allows.
fn stem(file: &str) -> String {
    let name = file.rsplit(['/', '\\']).next().unwrap_or_default();
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let is_plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_');
    let plain: String = stem
        .chars()
        .map(|c| if is_plain(c) { c } else { '-' })
        .take(100)
        .collect();
    match plain.trim_matches('-') {
        "" => "tower".to_owned(),
        plain => plain.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::stem;

    #[test]
    fn names_have_no_folders_and_no_quotes() {
        assert_eq!(stem("examples/nrel-5mw.toml"), "nrel-5mw");
        assert_eq!(stem("-"), "tower");
        assert_eq!(stem("a\"b\r\nc.toml"), "a-b--c");
        assert_eq!(stem(".."), "tower");
    }
}

//! What a report is made of.

use towermodes::{Options, Planes, Solution, SolveError, Tower, TowerDescription};
use towermodes_analysis::elastodyn::TowerShapes;
use towermodes_analysis::resonance::{Campbell, CampbellError};
use towermodes_analysis::study::Comparison;

/// Results and circumstances, all that a report says.
#[derive(Debug, Clone)]
pub struct ReportContent {
    /// What it is of; empty for a title made of the tower's name.
    pub title: String,
    /// Who made it, who checked it, and under which number it is filed.
    pub title_block: TitleBlock,
    /// The input.
    pub description: TowerDescription,
    /// The tower made of it.
    pub tower: Tower,
    /// How it was solved.
    pub options: Options,
    /// Its modes, with shapes at many heights ([`Options::points`]).
    pub solution: Solution,
    /// What other methods make of it, or why they make nothing.
    pub comparison: Result<Comparison, SolveError>,
    /// Natural frequencies against the rotor's speed, or why a blade has none; nothing if there is
    /// no rotor.
    pub campbell: Option<Result<Campbell, CampbellError>>,
    /// The shapes for ElastoDyn as its tower file has them, or why there are none.
    pub elastodyn: Result<ElastoDynShapes, String>,
    /// Height from which the shapes for ElastoDyn are taken, m.
    pub shapes_from_m: f64,
    /// What the reader of the input decided, left out or could not take over.
    pub notes: Vec<String>,
    /// Those of the notes on a part of the turbine that is missing in the model: the summary
    /// repeats them.
    pub model_notes: Vec<String>,
    /// The version of the program.
    pub version: String,
    /// The command as it was typed, arguments quoted for a shell.
    pub command_line: String,
    /// The options among them that say how the input is read, for commands that draw the same
    /// tower; empty if none.
    pub reading: String,
    /// Whether the input is a tower file of this program, and not of another one.
    pub is_own_format: bool,
    /// The files that the input was read from, the main one first.
    pub files: Vec<InputFile>,
}

/// What a document control system wants to know of a report. Empty fields are left out; there is no
/// clock, so the date is what was given.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct TitleBlock {
    /// The project or the site.
    pub project: String,
    /// The number of the document.
    pub document: String,
    /// Its revision.
    pub revision: String,
    /// Who made it.
    pub author: String,
    /// Who checked it.
    pub checker: String,
    /// Its date.
    pub date: String,
}

/// The shapes in a tower file of ElastoDyn, and what it makes of them.
#[derive(Debug, Clone, PartialEq)]
pub struct ElastoDynShapes {
    /// The shapes with their fits.
    pub shapes: TowerShapes,
    /// ElastoDyn's frequencies of the first and second shape of each plane, without what the tower
    /// carries and without gravity, Hz.
    pub frequency_alone_hz: Planes<[f64; 2]>,
}

/// A file that the input was read from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InputFile {
    /// Its path as it was given.
    pub name: String,
    /// Whether size and sum are those of its text in UTF-8, because its bytes are gone: standard
    /// input, pipes.
    pub is_of_text: bool,
    /// Its size.
    pub bytes: u64,
    /// SHA-256 (FIPS 180-4) of its bytes, in hexadecimal.
    pub sha256: String,
    /// Its text, which the report repeats.
    pub text: String,
}

impl TitleBlock {
    /// The fields that were given, each with its name.
    pub(super) fn given(&self) -> Vec<(&'static str, &str)> {
        let fields = [
            ("Project", &self.project),
            ("Document", &self.document),
            ("Revision", &self.revision),
            ("Author", &self.author),
            ("Checked by", &self.checker),
            ("Date", &self.date),
        ];
        let fields = fields.map(|(name, value)| (name, value.trim()));
        let given = fields.into_iter().filter(|(_, value)| !value.is_empty());
        given.collect()
    }
}

impl ReportContent {
    /// The title, or one made of the tower's name.
    pub(super) fn heading(&self) -> String {
        let name = self.description.name.trim();
        match (self.title.trim(), name) {
            ("", "") => "Natural frequencies and mode shapes of a tower".to_owned(),
            ("", name) => format!("Natural frequencies and mode shapes: {name}"),
            (title, _) => title.to_owned(),
        }
    }

    /// The file that commands are shown with; standard input as these know it.
    pub(super) fn main_file(&self) -> &str {
        let name = self.files.first().map(|file| file.name.as_str());
        match name {
            Some("<standard input>") => "-",
            name => name.unwrap_or("tower.toml"),
        }
    }
}

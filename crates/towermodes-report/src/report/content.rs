//! The content of a report.

use sha2::{Digest, Sha256};
use towermodes::turbine::{Turbine, TurbineModes};
use towermodes::{
    Options, Planes, SensitivityError, Solution, SolveError, Tower, TowerDescription,
};
use towermodes_analysis::elastodyn::TowerShapes;
use towermodes_analysis::influence::Influences;
use towermodes_analysis::resonance::{Campbell, CampbellError};
use towermodes_analysis::soil_band::SoilBand;
use towermodes_analysis::study::Comparison;
use towermodes_analysis::whirl::{AgainstRigid, CoupledCampbell, CoupledError};

/// Everything that a report contains.
#[derive(Debug, Clone)]
pub struct ReportContent {
    /// The input.
    pub description: TowerDescription,
    /// The validated tower.
    pub tower: Tower,
    /// The options of the solution.
    pub options: Options,
    /// Its modes, with shapes at many heights ([`Options::points`]).
    pub solution: Solution,
    /// The comparison of all methods, or the reason why there is none.
    pub comparison: Result<Comparison, SolveError>,
    /// The resonance check, or why a blade could not be solved; none without a rotor.
    pub campbell: Option<Result<Campbell, CampbellError>>,
    /// The whole turbine with rotating rotor, or the reason why it could not be solved; none if the
    /// input has no turbine or no rotor speed.
    pub turbine: Option<Result<TurbineResults, CoupledError>>,
    /// The modes for softer and stiffer soil; none without soil, and if not requested.
    pub soil_band: Option<SoilBand>,
    /// The influence of the input values on the frequencies, or the reason why there is none; only
    /// if requested.
    pub influences: Option<Result<Influences, SensitivityError>>,
    /// The shapes for ElastoDyn as in its tower file, or the reason why there are none.
    pub elastodyn: Result<ElastoDynShapes, String>,
    /// Height at which the shapes for ElastoDyn begin, m.
    pub shapes_from_m: f64,
    /// The data that are not results.
    pub circumstances: Circumstances,
}

/// The modes of the whole turbine.
#[derive(Debug, Clone)]
pub struct TurbineResults {
    /// The turbine.
    pub turbine: Turbine,
    /// Its frequencies against the rotor speed.
    pub coupled: CoupledCampbell,
    /// The tower modes with rigid and with flexible rotor.
    pub against: Vec<AgainstRigid>,
}

impl TurbineResults {
    /// The modes at the highest operating speed; none if the turbine was not solved there.
    pub(super) fn at_highest(&self) -> Option<&TurbineModes> {
        let highest_rpm = self.coupled.campbell.rotor.highest_rpm;
        let distance = |rpm: f64| (rpm - highest_rpm).abs();
        let mut speeds = self.coupled.speeds.iter();
        let there = speeds.find(|speed| distance(speed.rotor_speed_rpm) <= 1e-9 * highest_rpm);
        there.map(|speed| &speed.modes)
    }
}

/// The data of a report that are not results.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Circumstances {
    /// The title; empty for a title made from the name of the tower.
    pub title: String,
    /// Author, checker and number of the document.
    pub title_block: TitleBlock,
    /// The notes: assumptions of the reader, data that it omitted or could not import, limits of
    /// the resonance check.
    pub notes: Vec<String>,
    /// The notes on parts of the turbine that are missing in the model; the summary repeats them.
    pub model_notes: Vec<String>,
    /// The version of the program.
    pub version: String,
    /// The command as it was typed, arguments quoted for a shell.
    pub command_line: String,
    /// The options of this command that control how the input is read, for commands on the same
    /// tower; may be empty.
    pub reading: String,
    /// Whether the input is a tower file of this program.
    pub is_own_format: bool,
    /// The files of the input, the main one first.
    pub files: Vec<InputFile>,
}

/// The fields of a document control system. Empty fields are omitted; the date is the given text,
/// because a report must not depend on the clock.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct TitleBlock {
    /// The project or the site.
    pub project: String,
    /// The number of the document.
    pub document: String,
    /// Its revision.
    pub revision: String,
    /// The author.
    pub author: String,
    /// The checker.
    pub checker: String,
    /// Its date.
    pub date: String,
}

/// The mode shapes in an ElastoDyn tower file, and their frequencies in ElastoDyn.
#[derive(Debug, Clone, PartialEq)]
pub struct ElastoDynShapes {
    /// The shapes with their fits.
    pub shapes: TowerShapes,
    /// ElastoDyn's frequencies for the first and second shape of each plane, without RNA and
    /// gravity, Hz.
    pub frequency_alone_hz: Planes<[f64; 2]>,
}

/// A file of the input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InputFile {
    /// Its path as it was given.
    pub name: String,
    /// Whether size and checksum refer to its text in UTF-8, because the bytes are no longer
    /// available: standard input, pipes.
    pub is_of_text: bool,
    /// Its size.
    pub bytes: u64,
    /// SHA-256 (FIPS 180-4) of its bytes, in hexadecimal.
    pub sha256: String,
    /// Its text, which the report includes.
    pub text: String,
}

impl InputFile {
    /// A file with its text and, if they are still available, its bytes.
    pub fn new(name: String, text: String, bytes: Option<&[u8]>) -> Self {
        let of = bytes.unwrap_or(text.as_bytes());
        let sum = Sha256::digest(of);
        Self {
            name,
            is_of_text: bytes.is_none(),
            bytes: of.len() as u64,
            sha256: sum.iter().map(|byte| format!("{byte:02x}")).collect(),
            text,
        }
    }
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
    /// The title, or one made from the name of the tower.
    pub(super) fn heading(&self) -> String {
        let name = self.description.name.trim();
        match (self.circumstances.title.trim(), name) {
            ("", "") => "Natural frequencies and mode shapes of a tower".to_owned(),
            ("", name) => format!("Natural frequencies and mode shapes: {name}"),
            (title, _) => title.to_owned(),
        }
    }

    /// The file name in commands; `-` for standard input.
    pub(super) fn main_file(&self) -> &str {
        let name = self
            .circumstances
            .files
            .first()
            .map(|file| file.name.as_str());
        match name {
            Some("<standard input>") => "-",
            name => name.unwrap_or("tower.toml"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::InputFile;

    #[test]
    fn a_text_without_bytes_has_the_sum_of_its_own() {
        // FIPS 180-4's example "abc".
        let sum = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        let file = |bytes| InputFile::new("<standard input>".into(), "abc".into(), bytes);
        let of_text = file(None);
        assert!(of_text.is_of_text);
        assert_eq!((of_text.bytes, of_text.sha256.as_str()), (3, sum));
        let of_bytes = file(Some(&b"\xef\xbb\xbfabc"[..]));
        assert!(!of_bytes.is_of_text);
        assert_eq!(of_bytes.bytes, 6);
        assert_ne!(of_bytes.sha256, sum);
    }
}

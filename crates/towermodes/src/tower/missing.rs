//! Parts of the structure that the source of a description has and the description lacks.

use super::foundation::Foundation;

/// A part of the structure that the source of a description has, such as a set of files of
/// OpenFAST, and the description lacks.
///
/// Frequencies are then those of the rest, and they say nothing about resonance of the whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum MissingPart {
    /// Monopile, jacket, tripod or any other structure under the tower that stands on the ground.
    Substructure,
    /// A platform that moves, of a floating turbine for example.
    Platform,
    /// The mass of the water, and the stiffness of buoyancy.
    Water,
    /// The mooring lines.
    MooringLines,
    /// The soil.
    Soil,
    /// The blades of the rotor.
    Blades,
}

impl MissingPart {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Substructure,
        Self::Platform,
        Self::Water,
        Self::MooringLines,
        Self::Soil,
        Self::Blades,
    ];

    /// Its name in files: `substructure`, `platform`, `water`, `mooring-lines`, `soil`,
    /// `blades`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Substructure => "substructure",
            Self::Platform => "platform",
            Self::Water => "water",
            Self::MooringLines => "mooring-lines",
            Self::Soil => "soil",
            Self::Blades => "blades",
        }
    }

    /// It in a sentence, with its article.
    fn in_words(self) -> &'static str {
        match self {
            Self::Substructure => "a substructure",
            Self::Platform => "a platform that moves",
            Self::Water => "water",
            Self::MooringLines => "mooring lines",
            Self::Soil => "soil",
            Self::Blades => "blades",
        }
    }
}

/// Parts that a description lacks.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MissingParts {
    /// Each once.
    pub parts: Vec<MissingPart>,
    /// Whether the tower is clamped at its base in their place.
    pub is_clamped: bool,
}

impl MissingParts {
    /// The parts that a tower on this foundation lacks, each once.
    pub(super) fn of(parts: &[MissingPart], foundation: &Foundation) -> Self {
        let mut parts = parts.to_vec();
        parts.sort_unstable();
        parts.dedup();
        let holds = parts.iter().any(|part| *part != MissingPart::Blades);
        Self {
            parts,
            is_clamped: *foundation == Foundation::Clamped && holds,
        }
    }
}

/// "clamped at the tower base; the file has a substructure and water, which are not in this model".
impl std::fmt::Display for MissingParts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let words: Vec<&str> = self.parts.iter().map(|part| part.in_words()).collect();
        let (list, verb) = match &words[..] {
            [] => return Ok(()),
            [plural] if PLURALS.contains(plural) => ((*plural).to_owned(), "are"),
            [one] => ((*one).to_owned(), "is"),
            [first @ .., last] => (format!("{} and {last}", first.join(", ")), "are"),
        };
        if self.is_clamped {
            f.write_str("clamped at the tower base; ")?;
        }
        write!(f, "the file has {list}, which {verb} not in this model")
    }
}

/// The parts whose words are a plural.
const PLURALS: [&str; 2] = ["mooring lines", "blades"];

#[cfg(test)]
mod tests {
    use super::MissingPart::{MooringLines, Platform, Substructure, Water};
    use super::{MissingPart, MissingParts};
    use crate::tower::Foundation;

    #[test]
    fn the_sentence_names_each_part_once() {
        let said =
            |parts: &[MissingPart]| MissingParts::of(parts, &Foundation::Clamped).to_string();
        assert_eq!(
            said(&[Water, Substructure, Water]),
            "clamped at the tower base; the file has a substructure and water, which are not in this model"
        );
        assert!(said(&[Substructure]).ends_with("a substructure, which is not in this model"));
        assert!(said(&[MooringLines]).ends_with("mooring lines, which are not in this model"));
        assert!(
            said(&[MooringLines, Platform, Water])
                .contains("a platform that moves, water and mooring lines, which are")
        );
        assert_eq!(said(&[]), "");
        // They hold no tower.
        let blades = said(&[MissingPart::Blades]);
        assert_eq!(blades, "the file has blades, which are not in this model");
    }
}

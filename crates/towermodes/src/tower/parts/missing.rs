//! Parts of the structure that the source of a description has and the description lacks.

/// A part of the structure that the source of a description has, such as a set of files of
/// OpenFAST, or whose mass the source does not give, and that the description lacks.
///
/// Frequencies are then those of the rest, and they say nothing about resonance of the whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum MissingPart {
    /// Monopile, jacket, tripod or any other structure under the tower that stands on the ground.
    Substructure,
    /// A moving platform, for example of a floating turbine.
    Platform,
    /// The mass of the water, and the stiffness of buoyancy.
    Water,
    /// The mooring lines.
    MooringLines,
    /// The soil.
    Soil,
    /// The nacelle.
    Nacelle,
    /// The hub of the rotor.
    Hub,
    /// The blades of the rotor.
    Blades,
}

impl MissingPart {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Substructure,
        Self::Platform,
        Self::Water,
        Self::MooringLines,
        Self::Soil,
        Self::Nacelle,
        Self::Hub,
        Self::Blades,
    ];

    /// Its name in files: `substructure`, `platform`, `water`, `mooring-lines`, `soil`, `nacelle`,
    /// `hub`, `blades`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Substructure => "substructure",
            Self::Platform => "platform",
            Self::Water => "water",
            Self::MooringLines => "mooring-lines",
            Self::Soil => "soil",
            Self::Nacelle => "nacelle",
            Self::Hub => "hub",
            Self::Blades => "blades",
        }
    }

    /// Whether it is above the tower: a part of the rotor-nacelle assembly.
    pub fn is_of_rotor_nacelle_assembly(self) -> bool {
        matches!(self, Self::Nacelle | Self::Hub | Self::Blades)
    }

    /// Its name in a sentence, with its article.
    fn in_words(self) -> &'static str {
        match self {
            Self::Substructure => "a substructure",
            Self::Platform => "a platform that moves",
            Self::Water => "water",
            Self::MooringLines => "mooring lines",
            Self::Soil => "soil",
            Self::Nacelle => "the nacelle",
            Self::Hub => "the hub",
            Self::Blades => "the blades",
        }
    }
}

/// Missing parts of a description.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MissingParts {
    /// Each once.
    pub parts: Vec<MissingPart>,
    /// Whether the tower is clamped at its base in place of these parts.
    pub is_clamped: bool,
    /// Whether it is clamped because the user asked for it (`--clamped`).
    pub is_requested: bool,
}

impl MissingParts {
    /// The parts that a tower lacks, each once.
    pub(crate) fn of(parts: &[MissingPart], is_clamped: bool) -> Self {
        let mut parts = parts.to_vec();
        parts.sort_unstable();
        parts.dedup();
        let holds = parts
            .iter()
            .any(|part| !part.is_of_rotor_nacelle_assembly());
        Self {
            parts,
            is_clamped: is_clamped && holds,
            is_requested: false,
        }
    }
}

/// "clamped at the tower base by request; the file has a substructure and water, which are not in
/// this model",
/// "the mass of the nacelle and the hub is not in this model".
impl std::fmt::Display for MissingParts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let parts = self.parts.iter().copied();
        let (above, others): (Vec<MissingPart>, Vec<MissingPart>) =
            parts.partition(|part| part.is_of_rotor_nacelle_assembly());
        let clamped = self.is_clamped.then(|| match self.is_requested {
            true => "clamped at the tower base by request".to_owned(),
            false => "clamped at the tower base".to_owned(),
        });
        let others = listed(&others).map(|list| {
            let verb = match others[..] {
                [part] if part != MissingPart::MooringLines => "is",
                _ => "are",
            };
            format!("the file has {list}, which {verb} not in this model")
        });
        let above = listed(&above).map(|list| format!("the mass of {list} is not in this model"));
        let clauses: Vec<String> = [clamped, others, above].into_iter().flatten().collect();
        f.write_str(&clauses.join("; "))
    }
}

/// "a platform that moves, water and mooring lines"; none without parts.
fn listed(parts: &[MissingPart]) -> Option<String> {
    let words: Vec<&str> = parts.iter().map(|part| part.in_words()).collect();
    match &words[..] {
        [] => None,
        [one] => Some((*one).to_owned()),
        [first @ .., last] => Some(format!("{} and {last}", first.join(", "))),
    }
}

#[cfg(test)]
mod tests {
    use super::MissingPart::{MooringLines, Platform, Substructure, Water};
    use super::{MissingPart, MissingParts};

    #[test]
    fn the_sentence_names_each_part_once() {
        let said = |parts: &[MissingPart]| MissingParts::of(parts, true).to_string();
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
        let requested = MissingParts {
            is_requested: true,
            ..MissingParts::of(&[Substructure], true)
        };
        assert_eq!(
            requested.to_string(),
            "clamped at the tower base by request; the file has a substructure, which is not in this model"
        );
        assert_eq!(said(&[]), "");
        // They hold no tower.
        let blades = said(&[MissingPart::Blades]);
        assert_eq!(blades, "the mass of the blades is not in this model");
        assert_eq!(
            said(&[MissingPart::Hub, Water, MissingPart::Nacelle]),
            "clamped at the tower base; the file has water, which is not in this model; the mass of the nacelle and the hub is not in this model"
        );
    }
}

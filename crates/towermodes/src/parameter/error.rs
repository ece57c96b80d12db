//! Errors in the names of input values of a tower.

use thiserror::Error;

use super::PARTS;
use super::holder::Holder;
use super::number::Number;
use crate::tower::TowerDescription;

/// A name that denotes no input value of the tower, or changes that contradict each other.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ParameterError {
    /// The name is empty.
    #[error("the name of the input value is missing")]
    Empty,
    /// No tower has an input value with this name.
    #[error("unknown input name `{name}`; {hint}")]
    Unknown {
        /// The name.
        name: String,
        /// A similar name that exists, or the beginnings of the names that exist.
        hint: String,
    },
    /// An input value in a table of the tower file whose values have no names.
    #[error(
        "`{name}` cannot be varied: input values of [{table}] have no names for --set, sweeps, designs and derivatives; change it in the tower file{remedy}"
    )]
    Fixed {
        /// The name.
        name: String,
        /// The table of the tower file.
        table: &'static str,
        /// What else can be done.
        remedy: &'static str,
    },
    /// The name is valid, but this tower has no such input value.
    #[error("unknown input name `{name}`: this tower has no {noun}")]
    Absent {
        /// The name.
        name: String,
        /// The part that this tower does not have.
        noun: &'static str,
    },
    /// Some entries of a list have this input value, and others do not.
    #[error("`{name}` is not an input of every entry: {lacking} has no {meaning}; use the names that exist: {}", having.join(", "))]
    Partial {
        /// The name.
        name: String,
        /// The first entry without this input value.
        lacking: String,
        /// The meaning of the input value.
        meaning: &'static str,
        /// The names of the input values that exist.
        having: Box<[String]>,
    },
    /// The name stands for the only material, but the tower has several materials.
    #[error("`{name}` is ambiguous: this tower has {count} materials; write `{instead}`")]
    SeveralMaterials {
        /// The name.
        name: String,
        /// Number of entries.
        count: usize,
        /// The name of this input value of the first material.
        instead: String,
    },
    /// The index is larger than the last index of the list.
    #[error("unknown input name `{name}`: index {index} is too large, the {noun} of this tower have {}", range(*count))]
    OutOfRange {
        /// The name.
        name: String,
        /// The index, from 0.
        index: usize,
        /// Number of entries.
        count: usize,
        /// The entries of the list in a word, such as "stations".
        noun: &'static str,
    },
    /// The brackets contain neither a number nor `*`.
    #[error("`{name}`: `{found}` is not an index; an index is a number from 0, or * for all{}", or_name(.names))]
    WrongIndex {
        /// The name.
        name: String,
        /// The text in brackets.
        found: String,
        /// The names of the entries, if they have names.
        names: Box<[String]>,
    },
    /// The name denotes several input values, but one is needed.
    #[error("`{name}` is the name of {count} input values, but one input value is needed")]
    Several {
        /// The name.
        name: String,
        /// Number of input values with this name.
        count: usize,
    },
    /// The text of a change is invalid.
    #[error(
        "`{name}` is not a change: write a name, scale(NAME), add(NAME) or set(NAME, NAME), with a closing parenthesis at the end"
    )]
    WrongForm {
        /// The text.
        name: String,
    },
    /// A later change overwrites an earlier one.
    #[error("`{second}` sets {parameter}, which `{first}` already changes; remove one of them")]
    Repeated {
        /// The name of the input value.
        parameter: String,
        /// The earlier change.
        first: String,
        /// The later change.
        second: String,
    },
}

/// The tables of the tower file whose input values have no names, and alternatives.
const FIXED: [(&str, &str); 3] = [
    (
        "turbine",
        "; for the modes of the tower the turbine is the rigid body `rna`, whose input values can be varied",
    ),
    ("drivetrain", ""),
    ("damping", ""),
];

/// The indices of a list.
fn range(count: usize) -> String {
    match count {
        0 => "no index".to_owned(),
        1 => "only index 0".to_owned(),
        count => format!("the indices 0 to {}", count - 1),
    }
}

impl ParameterError {
    /// An input value of a part that this tower does not have; `plain` is the name without its
    /// optional parts.
    pub(super) fn absent(
        written: &str,
        plain: &str,
        noun: &'static str,
        description: &TowerDescription,
    ) -> Self {
        let name = written.to_owned();
        match (plain.strip_prefix("material."), description.materials.len()) {
            (Some(key), count @ 2..) => {
                let first = description.part_names.materials.first();
                let instead = match first.filter(|material| !material.is_empty()) {
                    Some(material) => format!("materials.{material}.{key}"),
                    None => format!("materials[0].{key}"),
                };
                Self::SeveralMaterials {
                    name,
                    count,
                    instead,
                }
            }
            _ => Self::Absent { name, noun },
        }
    }

    /// A name that no input value has; `plain` is the name without its optional parts.
    pub(super) fn unknown(written: &str, plain: &str, description: &TowerDescription) -> Self {
        let name = written.trim().to_owned();
        let mut fixed = FIXED.into_iter();
        match fixed.find(|(table, _)| starts_with(plain, table)) {
            Some((table, remedy)) => Self::Fixed {
                name,
                table,
                remedy,
            },
            None => Self::Unknown {
                name,
                hint: hint(plain, description),
            },
        }
    }
}

/// The name that was probably meant; otherwise the input values of the part, or the parts.
fn hint(name: &str, description: &TowerDescription) -> String {
    let (pattern, indices) = without_indices(name);
    let is_there = |part: &Holder| part.count(description) > 0;
    let parts: Vec<Holder> = PARTS.iter().copied().filter(is_there).collect();
    if let Some(nearest) = nearest(&pattern, &parts) {
        return format!("did you mean `{}`?", filled(&nearest, &indices));
    }
    let of = parts.iter().find(|part| starts_with(&pattern, part.name()));
    if let Some(part) = of {
        let keys = part.numbers().into_iter().map(Number::name);
        let keys: Vec<&str> = keys.filter(|key| !key.is_empty()).collect();
        return format!(
            "the input values of {} are {}",
            part.name(),
            keys.join(", ")
        );
    }
    let names: Vec<&str> = parts.iter().map(|part| part.name()).collect();
    format!("names begin with {}", names.join(", "))
}

/// Whether a name denotes a part or one of its values.
fn starts_with(name: &str, part: &str) -> bool {
    name.strip_prefix(part)
        .is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

/// The pattern with the most similar spelling, if it is similar enough.
fn nearest(name: &str, parts: &[Holder]) -> Option<String> {
    /// Longest text that is compared: no pattern is half as long.
    const LONGEST: usize = 100;
    if name.len() > LONGEST {
        return None;
    }
    let name = name.to_lowercase();
    let distance = |pattern: &str| strsim::damerau_levenshtein(&name, pattern);
    let patterns = parts.iter().flat_map(|part| {
        part.numbers()
            .into_iter()
            .map(|number| part.pattern(number))
    });
    let (pattern, steps) = patterns
        .map(|pattern| {
            let steps = distance(&pattern);
            (pattern, steps)
        })
        .min_by_key(|(_, steps)| *steps)?;
    (steps <= 1 + pattern.len() / 6).then_some(pattern)
}

/// A pattern with indices; `*` where there are too few.
fn filled(pattern: &str, indices: &[&str]) -> String {
    let mut pieces = pattern.split("[]");
    let mut name = pieces.next().unwrap_or_default().to_owned();
    let is_index = |index: &&str| *index == "*" || index.parse::<usize>().is_ok();
    for (place, piece) in pieces.enumerate() {
        let index = indices.get(place).copied().filter(is_index).unwrap_or("*");
        name.push_str(&format!("[{index}]{piece}"));
    }
    name
}

/// A name with `[]` in place of each index, and the indices.
fn without_indices(name: &str) -> (String, Vec<&str>) {
    let mut plain = String::new();
    let mut indices = Vec::new();
    let mut rest = name;
    while let Some((before, after)) = rest.split_once('[') {
        plain.push_str(before);
        plain.push_str("[]");
        let (index, after) = after.split_once(']').unwrap_or((after, ""));
        indices.push(index);
        rest = after;
    }
    plain.push_str(rest);
    (plain, indices)
}

/// ", or one of the names: a, b, ...", at most a dozen.
fn or_name(names: &[String]) -> String {
    const MOST: usize = 12;
    let shown: Vec<&str> = names.iter().take(MOST).map(String::as_str).collect();
    match names.len() {
        0 => String::new(),
        count if count > MOST => format!(", or one of {count} names: {}, ...", shown.join(", ")),
        _ => format!(", or one of the names: {}", shown.join(", ")),
    }
}

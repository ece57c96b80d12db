//! Reads the name of an input value.

use super::error::ParameterError;
use super::holder::Holder;
use super::part::{Indices, Part};
use super::{PARTS, Parameter};
use crate::tower::TowerDescription;

/// The name of an input value as a user writes it.
pub(super) struct Name<'n> {
    written: &'n str,
    /// Without blanks at its ends and without `tower.` before stations and properties.
    plain: &'n str,
}

/// The text in brackets.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Index {
    /// `*`
    Every,
    /// A number.
    One(usize),
    /// Anything else.
    Wrong(String),
}

impl<'n> Name<'n> {
    /// # Errors
    /// [`ParameterError::Empty`].
    pub(super) fn parse(written: &'n str) -> Result<Self, ParameterError> {
        let plain = written.trim();
        let inner = plain.strip_prefix("tower.").filter(|inner| {
            let lists = [&super::structure::STATIONS, &super::structure::PROPERTIES];
            lists.iter().any(|list| starts_as(inner, list))
        });
        match plain {
            "" => Err(ParameterError::Empty),
            _ => Ok(Self {
                written,
                plain: inner.unwrap_or(plain),
            }),
        }
    }

    /// The input values of a tower with this name, at least one.
    pub(super) fn find(
        &self,
        description: &TowerDescription,
    ) -> Result<Vec<Parameter>, ParameterError> {
        let plain = with_index_of_material(self.plain, description);
        let (mut absent, mut partial) = (None, None);
        for (part, of) in PARTS.iter().enumerate() {
            for number in of.numbers() {
                let Some(given) = indices(&plain, &of.pattern(number)) else {
                    continue;
                };
                if of.count(description) == 0 {
                    absent = absent.or(Some(of.noun()));
                    continue;
                }
                let all = self.every(*of, &given, description)?;
                let there = |i: &Indices| number.get(description, *i).is_some();
                let parameter = |indices| Parameter {
                    part,
                    number,
                    indices,
                };
                let (having, lacking): (Vec<Indices>, Vec<Indices>) =
                    all.into_iter().partition(there);
                let having = having.into_iter().map(parameter).collect();
                let Some(lacking) = lacking.first().copied().map(parameter) else {
                    return Ok(having);
                };
                absent = Some(number.meaning());
                partial = partial.or_else(|| self.partial(lacking, &having));
            }
        }
        Err(match (partial, absent) {
            (Some(partial), _) => partial,
            (None, Some(noun)) => ParameterError::absent(self.written, &plain, noun, description),
            (None, None) => ParameterError::unknown(self.written, &plain, description),
        })
    }

    /// The error for a name whose input value exists in some entries of a list but not in others;
    /// none if no entry has it.
    fn partial(&self, lacking: Parameter, having: &[Parameter]) -> Option<ParameterError> {
        let lacking_name = lacking.to_string();
        let entry = lacking_name.rfind(']')?;
        (!having.is_empty()).then(|| ParameterError::Partial {
            name: self.written.trim().to_owned(),
            lacking: lacking_name[..=entry].to_owned(),
            meaning: lacking.meaning(),
            having: having.iter().map(Parameter::to_string).collect(),
        })
    }

    /// The rows that the indices in brackets select.
    fn every(
        &self,
        part: Holder,
        given: &[Index],
        description: &TowerDescription,
    ) -> Result<Vec<Indices>, ParameterError> {
        let one = Index::One(0);
        let (first, second) = (given.first().unwrap_or(&one), given.get(1).unwrap_or(&one));
        let mut all = Vec::new();
        let selected =
            |index: &Index, count, noun| self.selected(index, (count, noun), description);
        for i in selected(first, part.count(description), part.noun())? {
            for j in selected(second, part.rows(description, i), "rows")? {
                match part.is_symmetric() && i > j {
                    // With both indices free the lower triangle would repeat the upper one.
                    true if first == second => {}
                    true => all.push([j, i]),
                    false => all.push([i, j]),
                }
            }
        }
        match all.is_empty() {
            true => Err(ParameterError::Absent {
                name: self.written.to_owned(),
                noun: part.noun(),
            }),
            false => Ok(all),
        }
    }

    fn selected(
        &self,
        index: &Index,
        (count, noun): (usize, &'static str),
        description: &TowerDescription,
    ) -> Result<std::ops::Range<usize>, ParameterError> {
        let name = || self.written.to_owned();
        match index {
            Index::Every => Ok(0..count),
            Index::One(one) if *one < count => Ok(*one..one + 1),
            Index::One(index) => Err(ParameterError::OutOfRange {
                name: name(),
                index: *index,
                count,
                noun,
            }),
            Index::Wrong(found) => {
                let list = self.plain.split_once('[').map_or("", |(list, _)| list);
                let names = names_of(list, description).map(str::to_owned);
                Err(ParameterError::WrongIndex {
                    name: name(),
                    found: found.clone(),
                    names: names.collect(),
                })
            }
        }
    }
}

/// Whether a name begins with the name of a list and a bracket.
fn starts_as(name: &str, list: &Part) -> bool {
    let head = list.name.strip_suffix(']').unwrap_or(list.name);
    name.starts_with(head)
}

/// `materials.S355.density` with the index of the material; the only material has none, and
/// `material` without a name is that without a name among several.
fn with_index_of_material(name: &str, description: &TowerDescription) -> String {
    let names = &description.part_names.materials;
    let count = description.materials.len();
    let numbered = |index: usize, key: &str| match count {
        1 => format!("material.{key}"),
        _ => format!("materials[{index}].{key}"),
    };
    if let Some(key) = name.strip_prefix("materials[0].").filter(|_| count == 1) {
        return numbered(0, key);
    }
    if let Some(key) = name.strip_prefix("material.").filter(|_| count > 1)
        && let Some(index) = names.iter().position(String::is_empty)
    {
        return numbered(index, key);
    }
    if let Some(numbered) = with_index_of_part(name, description) {
        return numbered;
    }
    let named = name.strip_prefix("materials.");
    if let Some((material, key)) = named.and_then(|rest| rest.rsplit_once('.')) {
        let material = material.trim_matches('"');
        if let Some(index) = names.iter().position(|name| name == material) {
            return numbered(index, key);
        }
    }
    name.to_owned()
}

/// `substructure.member[leg 1].outer_diameter` with the index of the part; a whole number without
/// quotation marks is an index, as everywhere.
fn with_index_of_part(name: &str, description: &TowerDescription) -> Option<String> {
    let (list, rest) = name.split_once('[')?;
    let (written, key) = rest.split_once(']')?;
    let quoted = written.strip_prefix('"').and_then(|w| w.strip_suffix('"'));
    let is_index = written == "*" || written.trim().parse::<usize>().is_ok();
    let part = match quoted {
        Some(quoted) => quoted,
        None if is_index => return None,
        None => written.trim(),
    };
    let index = names_of(list, description).position(|name| name == part)?;
    Some(format!("{list}[{index}]{key}"))
}

/// The names of a list of parts.
fn names_of<'d>(
    list: &str,
    description: &'d TowerDescription,
) -> Box<dyn Iterator<Item = &'d str> + 'd> {
    let names = &description.part_names;
    let of_lines = match list {
        "mooring.line_type" => &names.mooring_line_types,
        "mooring.point" => &names.mooring_points,
        "mooring.line" => &names.mooring_lines,
        _ => return names_of_frame(list, description),
    };
    Box::new(of_lines.iter().map(String::as_str))
}

fn names_of_frame<'d>(
    list: &str,
    description: &'d TowerDescription,
) -> Box<dyn Iterator<Item = &'d str> + 'd> {
    let Some(frame) = description.foundation.frame() else {
        return Box::new(std::iter::empty());
    };
    let frame = frame.frame.description();
    match list {
        "substructure.joint" => Box::new(frame.joints.iter().map(|joint| &*joint.name)),
        "substructure.member" => Box::new(frame.members.iter().map(|member| &*member.name)),
        _ => Box::new(std::iter::empty()),
    }
}

/// The indices of a name that has the form of a pattern; none if it has another form.
fn indices(name: &str, pattern: &str) -> Option<Vec<Index>> {
    let mut pieces = pattern.split("[]");
    let mut rest = name.strip_prefix(pieces.next()?)?;
    let mut indices = Vec::new();
    for piece in pieces {
        let (index, after) = rest.strip_prefix('[')?.split_once(']')?;
        indices.push(match (index.trim(), index.trim().parse()) {
            ("*", _) => Index::Every,
            (_, Ok(number)) => Index::One(number),
            (other, Err(_)) => Index::Wrong(other.to_owned()),
        });
        rest = after.strip_prefix(piece)?;
    }
    rest.is_empty().then_some(indices)
}

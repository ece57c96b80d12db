//! Changes input values in the text of a tower file, so that comments and layout are kept.

use std::collections::HashMap;
use std::ops::Range;

use ::toml::de::{DeTable, DeValue};
use thiserror::Error;
use towermodes::{Parameter, TowerDescription};

use super::super::describe;
use super::super::write::{can_be_written, number, write_toml_with};
use super::values::Value;
use crate::input::{FileFormat, TowerInput};
use crate::note::Note;
use crate::places::Places;
use crate::resolver::FileResolver;
use crate::source::{FileError, Source};

/// A tower file with changed input values.
#[derive(Debug, Clone, PartialEq)]
pub struct Rewritten {
    /// The text of the file.
    pub text: String,
    /// Why the file is newly written, without the comments of the old one; none if the values are
    /// changed in the old text.
    pub anew: Option<WrittenAnew>,
    /// Notes on data that a newly written file cannot store.
    pub notes: Vec<Note>,
}

/// Why input values cannot be changed in the text of a file.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum WrittenAnew {
    /// The tower is not from a TOML file.
    #[error("the old file is not TOML")]
    NotToml,
    /// An input value is not written in the file, for example a default.
    #[error("the old file does not contain {name}")]
    Absent {
        /// The name of the input value.
        name: String,
    },
    /// An input value is in another file, for example that of the stations.
    #[error("{name} is in another file, {file}")]
    OtherFile {
        /// The name of the input value.
        name: String,
        /// The file.
        file: String,
    },
    /// The change is not limited to input values in the file, or one value in the file became two
    /// different ones.
    #[error(
        "the new tower cannot be described by changing only values in the text of the old file"
    )]
    Other,
}

/// The file of a tower with the input values of another description of it: changed in the text of
/// the old file, so that its comments are kept, or newly written if this is not possible.
///
/// A changed text is read again before it is returned: it describes exactly `changed`. A new file
/// made from another format contains the turbine of the old file, whose rigid body may differ from
/// the rigid body of `changed` by rounding.
///
/// # Example
/// ```
/// # let folder = env!("CARGO_MANIFEST_DIR");
/// # let path = format!("{folder}/../../examples/nrel-5mw.toml");
/// use towermodes::Change;
/// use towermodes_files::{read_tower, rewritten};
///
/// let input = read_tower(path)?.input;
/// let mut changed = input.description.clone();
/// Change::parse("rna.mass", &changed)?.apply(&mut changed, 3.6e5);
/// let file = rewritten(&input, &changed);
/// assert_eq!(file.anew, None);
/// assert!(file.text.contains("mass = 360000.0"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn rewritten(input: &TowerInput, changed: &TowerDescription) -> Rewritten {
    match in_text(input, changed) {
        Ok(text) => Rewritten {
            text,
            anew: None,
            notes: Vec::new(),
        },
        Err(reason) => {
            let turbine = input.turbine.as_ref();
            let is_written = turbine.is_some_and(|turbine| can_be_written(turbine, changed));
            let (text, mut notes) = write_toml_with(changed, turbine);
            notes.extend(input.prescribed.left_out());
            if !is_written && turbine.is_some() && input.format == FileFormat::Toml {
                let message = "nacelle, drivetrain and blades of the turbine are omitted: with the changed values they are one rigid body";
                notes.push(Note::left_out(message));
            }
            Rewritten {
                text,
                anew: Some(reason),
                notes,
            }
        }
    }
}

fn in_text(input: &TowerInput, changed: &TowerDescription) -> Result<String, WrittenAnew> {
    if input.format != FileFormat::Toml {
        return Err(WrittenAnew::NotToml);
    }
    let source = &input.sources[0];
    let others = Others(&input.sources[1..]);
    let old = describe(&source.text, Some(&others)).map_err(|_| WrittenAnew::Other)?;
    let document = DeTable::parse(&source.text).map_err(|_| WrittenAnew::Other)?;
    let mut values = Values::default();
    values.add_table(document.get_ref());
    let mut edits = Vec::new();
    // A number without a place may follow from one that has it, as one plane from the other.
    let mut without_place = None;
    for parameter in different(&old.description, changed) {
        match values.literals_of(parameter, &old.places, &input.sources) {
            Ok(literals) => {
                let new = number(parameter.value(changed));
                edits.extend(literals.into_iter().map(|span| (span, new.clone())));
            }
            Err(reason) => without_place = without_place.or(Some(reason)),
        }
    }
    let text = edited(&source.text, edits);
    let read = describe(&text, Some(&others));
    match read.is_ok_and(|read| is_same(read.description, changed)) {
        true => Ok(text),
        false => Err(without_place.unwrap_or(WrittenAnew::Other)),
    }
}

/// Whether two descriptions are equal, except for the mark that an RNA was written as a point mass,
/// which an RNA with inertia cannot have.
fn is_same(read: TowerDescription, changed: &TowerDescription) -> bool {
    let read = TowerDescription {
        rna_is_point: changed.rna_is_point,
        ..read
    };
    read == *changed
}

/// The input values that differ.
fn different(old: &TowerDescription, new: &TowerDescription) -> Vec<Parameter> {
    let mut all = Parameter::all(old);
    all.extend(Parameter::all(new));
    let mut found = std::collections::HashSet::new();
    let is_other = |one: &Parameter| one.value(old) != one.value(new);
    all.retain(|one| is_other(one) && found.insert(*one));
    all
}

fn edited(text: &str, mut edits: Vec<(Range<usize>, String)>) -> String {
    edits.sort_by_key(|(span, _)| span.start);
    let mut result = String::with_capacity(text.len());
    let mut done = 0;
    for (span, new) in edits {
        if span.start < done {
            continue;
        }
        result.push_str(&text[done..span.start]);
        result.push_str(&new);
        let blanks = blanks_before_comment(&text[span.end..]);
        done = span.end + blanks;
        if blanks > 0 {
            let width = (span.len() + blanks).saturating_sub(new.len()).max(1);
            result.extend(std::iter::repeat_n(' ', width));
        }
    }
    result.push_str(&text[done..]);
    result
}

/// The number of blanks before a comment that follows directly, so that comments stay aligned.
fn blanks_before_comment(text: &str) -> usize {
    let rest = text.trim_start_matches(' ');
    match rest.starts_with('#') {
        true => text.len() - rest.len(),
        false => 0,
    }
}

/// The values of a document by their byte range, each with the table that contains it.
#[derive(Default)]
struct Values<'a>(HashMap<Range<usize>, (Option<&'a DeTable<'a>>, &'a Value<'a>)>);

impl<'a> Values<'a> {
    fn add_table(&mut self, table: &'a DeTable<'a>) {
        for value in table.values() {
            self.add(Some(table), value);
        }
    }

    fn add(&mut self, parent: Option<&'a DeTable<'a>>, value: &'a Value<'a>) {
        self.0.insert(value.span(), (parent, value));
        match value.get_ref() {
            DeValue::Table(table) => self.add_table(table),
            DeValue::Array(entries) => entries.iter().for_each(|entry| self.add(None, entry)),
            _ => {}
        }
    }

    /// The byte ranges of an input value, at least one.
    fn literals_of(
        &self,
        parameter: Parameter,
        places: &Places,
        files: &[Source],
    ) -> Result<Vec<Range<usize>>, WrittenAnew> {
        let name = parameter.to_string();
        let literals = match places.exact(parameter.place()) {
            Some((0, span)) => self.literals(span, &name),
            Some((file, _)) => {
                let file = files.get(*file).map(|file| file.name.clone());
                let file = file.unwrap_or_default();
                return Err(WrittenAnew::OtherFile { name, file });
            }
            None => Vec::new(),
        };
        match literals.is_empty() {
            true => Err(WrittenAnew::Absent { name }),
            false => Ok(literals),
        }
    }

    /// The byte ranges of an input value by its name, in or next to the value at its place: the
    /// entry of a list or table, both entries of a symmetric matrix, or another key of its table.
    fn literals(&self, span: &Range<usize>, name: &str) -> Vec<Range<usize>> {
        let Some((parent, value)) = self.0.get(span) else {
            return Vec::new();
        };
        let tail = name.rsplit('.').next().unwrap_or(name);
        let of_key = parent.and_then(|table| table.get(tail));
        let own = match value.get_ref() {
            DeValue::Table(table) => table.get(tail),
            DeValue::Array(_) => None,
            _ => Some(*value),
        };
        let indices = indices_at_end(tail);
        // The place of a part is its table.
        let list = tail.split('[').next().filter(|_| !indices.is_empty());
        let value = match (value.get_ref(), list) {
            (DeValue::Table(table), Some(list)) => table.get(list).unwrap_or(value),
            _ => *value,
        };
        let entry = |path: &[usize]| {
            path.iter().try_fold(value, |value, index| {
                value.get_ref().as_array()?.get(*index)
            })
        };
        let found = match (of_key.or(own), &indices[..]) {
            (Some(one), _) => vec![one],
            (None, [row, column]) => {
                let both = [entry(&[*row, *column]), entry(&[*column, *row])];
                both.into_iter().flatten().collect()
            }
            (None, path) => entry(path).into_iter().collect(),
        };
        let numbers = found.into_iter().filter(|value| is_number(value));
        numbers.map(Value::span).collect()
    }
}

fn is_number(value: &Value<'_>) -> bool {
    matches!(value.get_ref(), DeValue::Float(_) | DeValue::Integer(_))
}

/// The indices in brackets at the end of a key such as `center[2]`.
fn indices_at_end(key: &str) -> Vec<usize> {
    let pieces = key.split('[').skip(1);
    let indices = pieces.map(|piece| piece.trim_end_matches(']').parse());
    indices.collect::<Result<_, _>>().unwrap_or_default()
}

/// The files named by a tower file, as they were read.
struct Others<'s>(&'s [Source]);

impl FileResolver for Others<'_> {
    fn read(&self, path: &str) -> Result<Source, FileError> {
        let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
        let mut sources = self.0.iter();
        let named = sources.find(|source| source.name.ends_with(name));
        let only = (self.0.len() == 1).then(|| &self.0[0]);
        let source = named.or(only).cloned();
        source.ok_or_else(|| FileError::Missing {
            name: path.to_owned(),
        })
    }
}

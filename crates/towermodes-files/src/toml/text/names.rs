//! Parts that are referred to by their names.

use std::collections::HashMap;

use towermodes::Place;

use super::reading::Reading;
use super::table::suggestion;
use super::values::{Value, every_row, list, text};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// The parts of a list by name.
pub(crate) struct Names {
    what: &'static str,
    names: Vec<String>,
    by_name: HashMap<String, usize>,
    /// Whether the list has mistakes, so that any name may belong to it.
    is_unknown: bool,
}

impl Names {
    /// The names of a list; of several equal names the first one counts.
    pub(crate) fn of<'n>(what: &'static str, names: impl Iterator<Item = &'n str>) -> Self {
        let names: Vec<String> = names.map(str::to_owned).collect();
        let numbered = names.iter().cloned().enumerate().rev();
        Self {
            what,
            by_name: numbered.map(|(index, name)| (name, index)).collect(),
            names,
            is_unknown: false,
        }
    }

    /// Refuses the first name that occurs twice in a list, at its second occurrence.
    pub(crate) fn distinct<'n>(
        what: &'static str,
        names: impl Iterator<Item = &'n str>,
        place: impl Fn(usize) -> Place,
        reading: &mut Reading,
    ) -> Option<Self> {
        let of_list = Self::of(what, names);
        let mut numbered = of_list.names.iter().enumerate();
        let second = numbered.find(|(index, name)| of_list.by_name[*name] != *index);
        let Some((index, name)) = second else {
            return Some(of_list);
        };
        let place = reading.places.own(place(index));
        let span = place.map_or(0..0, |(_, span)| span.clone());
        let times = of_list.names.iter().filter(|other| *other == name).count();
        let repeated = DiagnosticKind::Repeated {
            what: format!("the {what} `{name}`"),
            times,
        };
        let hint = format!("give each {what} a name of its own");
        reading.refuse(Diagnostic::new(span, repeated).with_hint(hint))
    }

    /// The names of a list whose mistakes were reported: every name may belong to it.
    pub(crate) fn unknown(what: &'static str) -> Self {
        Self {
            is_unknown: true,
            ..Self::of(what, std::iter::empty())
        }
    }

    /// The part that a value names.
    pub(crate) fn one(&self, value: &Value<'_>, key: &str, reading: &mut Reading) -> Option<usize> {
        let name = text(value, key, reading)?;
        if let Some(index) = self.by_name.get(name) {
            return Some(*index);
        }
        if self.is_unknown {
            return Some(0);
        }
        // Listing the names takes time, and not all of many mistakes are shown.
        if reading.is_full() {
            return None;
        }
        let known: Vec<&str> = self.names.iter().map(String::as_str).collect();
        let hint = suggestion(name, &known, "names:");
        let (what, name) = (self.what, name.to_owned());
        let kind = DiagnosticKind::UnknownName { what, name };
        reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
    }

    /// The parts that a list names.
    pub(crate) fn all(
        &self,
        value: &Value<'_>,
        key: &str,
        reading: &mut Reading,
    ) -> Option<Vec<usize>> {
        let values = list(value, key, reading)?;
        every_row(values, |_, value| self.one(value, key, reading))
    }

    /// The two parts that a list names.
    pub(crate) fn pair(
        &self,
        value: &Value<'_>,
        key: &str,
        reading: &mut Reading,
    ) -> Option<[usize; 2]> {
        let all = self.all(value, key, reading)?;
        let found = all.len();
        all.try_into().ok().or_else(|| {
            let kind = DiagnosticKind::wrong_count(key, found, 2);
            reading.refuse(Diagnostic::new(value.span(), kind))
        })
    }
}

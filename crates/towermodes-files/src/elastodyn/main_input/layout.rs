//! Recognizes the layout of a main file of ElastoDyn.
//!
//! OpenFAST reads the file by position, and each version has its own layout. The layouts differ in
//! blocks of records; a file has the blocks whose names are on its lines.

use std::collections::{BTreeMap, HashMap};

use super::super::names::{is_ruler, plain, plain_name_on};
use super::super::positional::{check_no_comment, misplaced};
use super::super::record::Record;
use super::main_records::{BLOCKS, Block, Presence};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::records::{Line, Lines};

/// A line of a layout.
#[derive(Debug, Clone, Copy)]
enum Entry {
    Heading(&'static str),
    Parameter(&'static Record),
}

impl Entry {
    fn name(&self) -> &'static str {
        match self {
            Self::Heading(name) => name,
            Self::Parameter(record) => record.name,
        }
    }

    /// Whether the entry is a parameter of this name.
    fn is(&self, name: Option<&str>) -> bool {
        matches!(self, Self::Parameter(record) if name == Some(record.name))
    }
}

/// The entries of the layout that contains these names.
fn layout(names: &[Option<&'static str>]) -> Vec<Entry> {
    let is_named = |name: &'static str| names.contains(&Some(name));
    let is_there = |block: &&Block| match block.presence {
        Presence::Always => true,
        Presence::IfNamed => block.records.iter().any(|record| is_named(record.name)),
        Presence::Unless(old) => !old.iter().any(|name| is_named(name)),
    };
    let blocks = BLOCKS.iter().filter(is_there);
    let entries = blocks.flat_map(|block| {
        let heading = block.heading.map(Entry::Heading);
        heading
            .into_iter()
            .chain(block.records.iter().map(Entry::Parameter))
    });
    entries.collect()
}

/// Largest number of lines of a layout.
const LONGEST: usize = 200;

/// A parameter with its line.
pub(crate) type Placed<'a> = (&'static Record, Line<'a>);

/// The parameters of a main file by their names, up to the name of the tower file. Two free lines
/// come first; blank lines do not count.
pub(crate) fn parameters(text: &str) -> Result<BTreeMap<&'static str, Placed<'_>>, Diagnostic> {
    let mut all = Lines::new(text);
    all.expect("the first header line")?;
    all.expect("the second header line")?;
    let lines: Vec<Line<'_>> = all
        .clone()
        .filter(|line| !line.is_blank())
        .take(LONGEST)
        .collect();
    refuse_fast_7(&lines)?;
    let names: Vec<Option<&'static str>> = known_names(&lines);
    let layout = layout(&names);
    let is_named = |entry: &&Entry| names.iter().any(|name| entry.is(*name));
    let named = layout.iter().filter(is_named).count();
    if 2 * named < layout.len() {
        return Err(not_understood(named, &layout, &lines, &names));
    }
    let mut places = BTreeMap::new();
    for (index, &entry) in layout.iter().enumerate() {
        let Some(line) = lines.get(index) else {
            return Err(all.ended(entry.name()));
        };
        if !is_exchanged(index, &layout, (&lines, &names)) {
            check(entry, line, names[index])?;
        }
        if let Entry::Parameter(record) = entry {
            places.insert(record.name, (record, *line));
        }
    }
    Ok(places)
}

/// Whether a line and its neighbour have each other's names and equal values: then it does not
/// matter that OpenFAST reads by position and not by name.
fn is_exchanged(
    index: usize,
    layout: &[Entry],
    (lines, names): (&[Line<'_>], &[Option<&'static str>]),
) -> bool {
    let value = |index: usize| {
        let first = lines.get(index)?.first()?;
        Some(first.text.to_ascii_lowercase())
    };
    let with = |other: usize| {
        let own = layout.get(index).zip(names.get(other));
        let others = layout.get(other).zip(names.get(index));
        let mut pairs = own.into_iter().chain(others).peekable();
        let is_pair = pairs.peek().is_some() && pairs.all(|(entry, name)| entry.is(*name));
        is_pair && value(index).is_some() && value(index) == value(other)
    };
    index.checked_sub(1).is_some_and(with) || with(index + 1)
}

/// The parameter whose name is on each line, if any.
fn known_names(lines: &[Line<'_>]) -> Vec<Option<&'static str>> {
    let records = BLOCKS.iter().flat_map(|block| block.records);
    let known: HashMap<String, &'static str> = records
        .map(|record| (plain(record.name), record.name))
        .collect();
    let name = |line| plain_name_on(line).and_then(|name| known.get(&name).copied());
    lines.iter().map(name).collect()
}

/// Checks that a line can be the entry at its position.
fn check(entry: Entry, line: &Line<'_>, name: Option<&'static str>) -> Result<(), Diagnostic> {
    if let Entry::Parameter(record) = entry {
        check_no_comment(line, record.name)?;
    }
    match (entry, name) {
        (Entry::Parameter(record), Some(name)) if name != record.name => {
            Err(misplaced(line, record.name, name))
        }
        (Entry::Heading(title), Some(name)) => {
            Err(misplaced(line, &format!("the heading {title}"), name))
        }
        (Entry::Parameter(record), None) if is_ruler(line) => {
            let kind = DiagnosticKind::misplaced(record.name, "a heading");
            Err(Diagnostic::new(line.span(), kind).with_hint("is a line above missing?"))
        }
        _ => Ok(()),
    }
}

/// The mistake of a file with too few of the names, at the first line without its name.
fn not_understood(
    named: usize,
    layout: &[Entry],
    lines: &[Line<'_>],
    names: &[Option<&'static str>],
) -> Diagnostic {
    let parameters = |entry: &&Entry| matches!(entry, Entry::Parameter(_));
    let count = layout.iter().filter(parameters).count();
    let mut pairs = layout.iter().zip(lines.iter().zip(names));
    let first = pairs.find_map(|(entry, (line, name))| {
        let is_other = parameters(&entry) && !entry.is(*name);
        is_other.then(|| (line.span(), entry.name()))
    });
    let (span, name) = first.unwrap_or((0..0, "Echo"));
    let found = format!(
        "not a main file of ElastoDyn: only {named} of the {count} parameters of such a file are named on their lines; {name} is expected on this line"
    );
    Diagnostic::new(span, DiagnosticKind::WrongFile { found }).with_hint(
        "main files of FAST 8 to OpenFAST 5 are read; each line is a value, its name and a description",
    )
}

/// Refuses a main file of FAST 7, which has most of the names in another order.
fn refuse_fast_7(lines: &[Line<'_>]) -> Result<(), Diagnostic> {
    let is_adams_prep = |line: &&Line<'_>| plain_name_on(line).as_deref() == Some("adamsprep");
    let Some(line) = lines.iter().find(is_adams_prep) else {
        return Ok(());
    };
    let found = "a main file of FAST 7, which is not read: only FAST 7 has ADAMSPrep".to_owned();
    let hint = "convert it to OpenFAST, or give its tower file alone with --tower-height";
    Err(Diagnostic::new(line.span(), DiagnosticKind::WrongFile { found }).with_hint(hint))
}

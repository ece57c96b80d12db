//! The tables of a file: a heading of dashes, in MoorDyn 1 the number of rows, names and units of
//! the columns, rows.

use std::ops::Range;
use std::rc::Rc;

use super::column::{Column, Layout, plain};
use super::row::{Header, Row};
use super::unused::Unused;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::note::Note;
use crate::records::{Line, Lines, Token};
use crate::source::Source;

/// Largest number of lines, points or bodies.
pub(super) const MOST_ROWS: usize = 2000;

/// Largest number of columns of a table.
const MOST_COLUMNS: usize = 64;

/// The sections of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    LineTypes,
    RodTypes,
    Bodies,
    Rods,
    Points,
    Lines,
    Loads,
    Control,
    Failure,
    Options,
    Outputs,
}

/// A section: its kind, its name in messages, and words of its heading; the order is that of the
/// search.
type Known = (Kind, &'static str, &'static [&'static str]);

#[rustfmt::skip]
const SECTIONS: [Known; 11] = [
    (Kind::LineTypes, "LINE TYPES", &["LINE DICTIONARY", "LINE TYPES"]),
    (Kind::RodTypes, "ROD TYPES", &["ROD DICTIONARY", "ROD TYPES"]),
    (Kind::Bodies, "BODIES", &["BODIES", "BODY LIST", "BODY PROPERTIES"]),
    (Kind::Rods, "RODS", &["RODS", "ROD LIST", "ROD PROPERTIES"]),
    (Kind::Points, "POINTS", &["POINTS", "POINT LIST", "POINT PROPERTIES", "CONNECTION PROPERTIES", "CONNECTIONS", "NODE PROPERTIES"]),
    (Kind::Lines, "LINES", &["LINES", "LINE LIST", "LINE PROPERTIES"]),
    (Kind::Loads, "EXTERNAL LOADS", &["EXTERNAL LOADS"]),
    (Kind::Control, "CONTROL", &["CONTROL"]),
    (Kind::Failure, "FAILURE", &["FAILURE"]),
    (Kind::Options, "OPTIONS", &["OPTIONS"]),
    (Kind::Outputs, "OUTPUTS", &["OUTPUT"]),
];

/// A section that was found.
#[derive(Debug)]
pub(super) struct Table<'a> {
    pub(super) kind: Kind,
    /// The byte range of the heading.
    pub(super) span: Range<usize>,
    lines: Vec<Line<'a>>,
}

/// All sections of a file.
#[derive(Debug)]
pub(super) struct Tables<'a> {
    found: Vec<Table<'a>>,
    /// Unknown headings.
    pub(super) unknown: Vec<Line<'a>>,
}

impl<'a> Tables<'a> {
    /// Finds the sections of a text.
    pub(super) fn of(text: &'a str) -> Result<Self, Diagnostic> {
        let mut tables = Self {
            found: Vec::new(),
            unknown: Vec::new(),
        };
        // Lines before the first heading are the title.
        let mut is_inside = false;
        for line in Lines::new(text) {
            if line.text.contains("---") {
                is_inside = tables.begin(line)?;
            } else if is_inside && !is_comment(&line) {
                tables
                    .found
                    .last_mut()
                    .into_iter()
                    .for_each(|table| table.lines.push(line));
            }
        }
        Ok(tables)
    }

    /// Begins a section; false if its heading is unknown.
    fn begin(&mut self, heading: Line<'a>) -> Result<bool, Diagnostic> {
        let words = heading.text.to_ascii_uppercase();
        let is_title = words.contains("INPUT FILE");
        let is_it = |known: &&Known| known.2.iter().any(|word| words.contains(word));
        let Some((kind, name, _)) = SECTIONS.iter().find(is_it).filter(|_| !is_title) else {
            let is_end = words.contains("NEED THIS LINE");
            if !is_title && !is_end && words.contains(|letter: char| letter.is_alphabetic()) {
                self.unknown.push(heading);
            }
            return Ok(false);
        };
        if self.find(*kind).is_some() {
            let what = format!("the section {name}");
            let kind = DiagnosticKind::Repeated { what, times: 2 };
            return Err(Diagnostic::new(heading.span(), kind));
        }
        self.found.push(Table {
            kind: *kind,
            span: heading.span(),
            lines: Vec::new(),
        });
        Ok(true)
    }

    /// A section, if the file has it.
    pub(super) fn find(&self, kind: Kind) -> Option<&Table<'a>> {
        self.found.iter().find(|table| table.kind == kind)
    }

    /// A table that each file must have.
    pub(super) fn expect(&self, kind: Kind) -> Result<&Table<'a>, Diagnostic> {
        let missing = || {
            let what = format!("the table {}", kind.name());
            Diagnostic::new(0..0, DiagnosticKind::Missing { what })
                .with_hint("a table begins with a line of dashes that contains its name")
        };
        self.find(kind).ok_or_else(missing)
    }
}

impl Kind {
    fn name(self) -> &'static str {
        let known = SECTIONS.iter().find(|(kind, ..)| *kind == self);
        known.map_or("", |(_, name, _)| name)
    }
}

/// Whether a line has no values.
fn is_comment(line: &Line<'_>) -> bool {
    let text = line.text.trim_start();
    text.is_empty() || text.starts_with(['!', '%']) || text.starts_with("# ")
}

/// The rows of a table with the names of their columns.
#[derive(Debug)]
pub(super) struct Rows<'a> {
    heading: Range<usize>,
    header: Rc<Header>,
    /// The names as written.
    names: Vec<&'a str>,
    kind: Kind,
    pub(super) rows: Vec<Row<'a>>,
}

impl<'a> Table<'a> {
    /// The lines of a section without a header, such as the options.
    pub(super) fn lines(&self) -> &[Line<'a>] {
        &self.lines
    }

    /// The number of rows, if it precedes the names of the columns, as in MoorDyn 1.
    pub(super) fn count(&self) -> Option<Token<'a>> {
        let mut tokens = self.lines.first()?.tokens();
        let first = tokens.next().filter(Token::is_number)?;
        let is_name = |token: Token<'_>| token.text.starts_with(['N', 'n']);
        tokens.next().filter(|token| is_name(token.clone()))?;
        Some(first)
    }

    /// Its rows; if the columns have none of the names of `needed`, they are read in the order of
    /// the layout.
    pub(super) fn rows(&self, needed: &[Column], layout: Layout) -> Result<Rows<'a>, Diagnostic> {
        let count = self.count();
        let mut lines = self.lines.iter().skip(usize::from(count.is_some()));
        let end = self.span.end;
        let title = self.kind.name();
        let names = lines
            .next()
            .map_or_else(Vec::new, |line| line.text.split_whitespace().collect());
        if let Some(units) = lines.next().filter(|line| !is_units(line)) {
            let kind = DiagnosticKind::misplaced(
                format!("the units of the columns of {title}"),
                quoted(units.text.trim()),
            );
            let hint = "two lines, with names and units of the columns, are above the rows of each table, and are skipped";
            return Err(Diagnostic::new(units.span(), kind).with_hint(hint));
        }
        let plain_names = distinct(&names);
        let is_known = needed
            .iter()
            .all(|column| column.named(&plain_names).is_some());
        let header = Rc::new(Header {
            names: plain_names,
            unnamed: (!is_known).then_some(layout),
        });
        let rows = lines.enumerate().map(|(index, line)| {
            let name = format!("row {} of {title}", index + 1);
            line.check_commas(&format!("a number in {name}"))?;
            Ok(Row::new(*line, header.clone(), name))
        });
        let rows: Vec<Row<'a>> = rows.collect::<Result<_, Diagnostic>>()?;
        check_count(count, rows.len(), title)?;
        if rows.len() > MOST_ROWS {
            let what = format!("rows of {title}");
            let (found, limit) = (rows.len(), MOST_ROWS);
            let kind = DiagnosticKind::TooMany { what, found, limit };
            return Err(Diagnostic::new(end..end, kind));
        }
        Ok(Rows {
            heading: self.span.clone(),
            header,
            names,
            kind: self.kind,
            rows,
        })
    }
}

/// The names in the form of [`plain`]; a name that occurs again, such as Y0 and y0 of bodies, gets
/// a 2.
fn distinct(names: &[&str]) -> Vec<String> {
    let mut distinct: Vec<String> = Vec::new();
    for name in names.iter().take(MOST_COLUMNS) {
        let name = plain(name);
        let again = if distinct.contains(&name) { "2" } else { "" };
        distinct.push(name + again);
    }
    distinct
}

/// Whether a line has units: `(m)` or `[m]`.
fn is_units(line: &Line<'_>) -> bool {
    line.text.trim_start().starts_with(['(', '[', '-'])
}

fn check_count(count: Option<Token<'_>>, rows: usize, title: &str) -> Result<(), Diagnostic> {
    let Some(count) = count else { return Ok(()) };
    let stated = count.integer(&format!("the number of rows of {title}"))?;
    if i64::try_from(rows) == Ok(stated) {
        return Ok(());
    }
    let message = format!("the number of rows of {title} is {stated}, but there are {rows} rows");
    Err(count
        .wrong(DiagnosticKind::Contradiction(message))
        .with_hint("correct the number, or add or remove rows"))
}

impl<'a> Rows<'a> {
    /// Adds the columns that are not read to the unused ones; returns the note on unknown names.
    pub(super) fn note_unused(
        &self,
        read: &[Column],
        source: &Source,
        unused: &mut Unused,
    ) -> Option<Note> {
        let title = self.kind.name();
        if self.header.unnamed.is_some() {
            let message = format!(
                "the names of the columns of {title} ({}) are not those of its format: the columns are read in its order",
                self.names.join(" ")
            );
            return Some(Note::assumption(message).at(source, self.heading.start));
        }
        let used: Vec<usize> = read.iter().filter_map(|c| self.header.index(c)).collect();
        let names = self.names.iter().enumerate();
        // Remarks such as `(optional)` are no columns.
        let names = names.filter(|(_, name)| !name.starts_with('('));
        let others = names.filter(|(index, _)| !used.contains(index));
        let others: Vec<&str> = others.map(|(_, name)| *name).collect();
        if !self.rows.is_empty() {
            let what = format!("columns of {title}");
            unused.add(&what, &others, self.heading.start);
        }
        None
    }
}

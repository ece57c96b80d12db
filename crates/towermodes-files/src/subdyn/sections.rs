//! The tables of a file: a heading of dashes, the number of rows, names and units of the columns,
//! rows.

use super::rows::Row;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::records::{Line, Lines, MAX_COUNT, Token};

/// The tables that describe the structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Joints,
    Reactions,
    Interfaces,
    Members,
    Circular,
    Rectangular,
    Arbitrary,
    Cables,
    RigidLinks,
    Springs,
    Cosines,
    Masses,
}

/// A table: its kind, its heading in messages, words of its heading in files, and all names that
/// its number of rows has had.
struct Known {
    kind: Kind,
    heading: &'static str,
    words: &'static [&'static str],
    counts: &'static [&'static str],
}

/// The rectangular sections come before the circular ones, because the older name of the circular
/// ones was used for both.
#[rustfmt::skip]
const TABLES: [Known; 12] = [
    Known { kind: Kind::Joints, heading: "STRUCTURE JOINTS", words: &["STRUCTURE JOINTS"], counts: &["njoints"] },
    Known { kind: Kind::Reactions, heading: "BASE REACTION JOINTS", words: &["REACTION JOINTS"], counts: &["nreact"] },
    Known { kind: Kind::Interfaces, heading: "INTERFACE JOINTS", words: &["INTERFACE JOINTS"], counts: &["ninterf"] },
    Known { kind: Kind::Members, heading: "MEMBERS", words: &["- MEMBERS -"], counts: &["nmembers"] },
    Known { kind: Kind::Rectangular, heading: "RECTANGULAR BEAM CROSS-SECTION PROPERTIES", words: &["RECTANGULAR"], counts: &["npropsetsrec", "npropsetsbr"] },
    Known { kind: Kind::Arbitrary, heading: "ARBITRARY BEAM CROSS-SECTION PROPERTIES", words: &["ARBITRARY", "2/2"], counts: &["nxpropsets", "npropsetsx"] },
    Known { kind: Kind::Circular, heading: "CIRCULAR BEAM CROSS-SECTION PROPERTIES", words: &["CIRCULAR", "1/2"], counts: &["npropsets", "npropsetscyl", "npropsetsbc", "npropsetsb"] },
    Known { kind: Kind::Cables, heading: "CABLE PROPERTIES", words: &["CABLE PROP"], counts: &["ncablepropsets", "npropsetsc"] },
    Known { kind: Kind::RigidLinks, heading: "RIGID LINK PROPERTIES", words: &["RIGID LINK"], counts: &["nrigidpropsets", "npropsetsr"] },
    Known { kind: Kind::Springs, heading: "SPRING ELEMENT PROPERTIES", words: &["SPRING"], counts: &["nspringpropsets", "npropsetss"] },
    Known { kind: Kind::Cosines, heading: "MEMBER COSINE MATRICES", words: &["COSINE"], counts: &["ncosms"] },
    Known { kind: Kind::Masses, heading: "JOINT ADDITIONAL CONCENTRATED MASSES", words: &["CONCENTRATED"], counts: &["ncmass"] },
];

/// A table that was found.
#[derive(Debug, Clone)]
pub(super) struct Section<'a> {
    pub(super) kind: Kind,
    /// The names of the columns.
    names: &'a str,
    pub(super) rows: Vec<Row<'a>>,
}

impl Section<'_> {
    /// Whether a column with this name exists.
    pub(super) fn has_column(&self, name: &str) -> bool {
        // What the brackets and comments behind the names explain is not a column.
        let names = self.names.split(['[', '!']).next().unwrap_or_default();
        let mut names = names.split(|c: char| c.is_whitespace() || c == '/');
        names.any(|found| found.eq_ignore_ascii_case(name))
    }
}

/// All tables of a file.
#[derive(Debug)]
pub(super) struct Sections<'a> {
    found: Vec<Section<'a>>,
}

impl<'a> Sections<'a> {
    /// Finds the tables of a text.
    pub(super) fn of(text: &'a str) -> Result<Self, Diagnostic> {
        let mut lines = Lines::new(text);
        let mut found: Vec<Section<'a>> = Vec::new();
        while let Some(line) = lines.next() {
            if !is_ruler(&line) {
                continue;
            }
            let Some(known) = known(&line, &lines) else {
                continue;
            };
            if found.iter().any(|section| section.kind == known.kind) {
                let what = format!("the table {}", known.heading);
                let kind = DiagnosticKind::Repeated { what, times: 2 };
                return Err(Diagnostic::new(line.span(), kind));
            }
            found.push(section(known, &mut lines)?);
        }
        Ok(Self { found })
    }

    /// A table, if the file has it.
    pub(super) fn find(&self, kind: Kind) -> Option<&Section<'a>> {
        self.found.iter().find(|section| section.kind == kind)
    }

    /// The rows of a table; empty if the file does not contain it, as in older files.
    pub(super) fn rows(&self, kind: Kind) -> &[Row<'a>] {
        self.find(kind).map_or(&[], |section| &section.rows)
    }

    /// A table that each file must have.
    pub(super) fn expect(&self, kind: Kind) -> Result<&Section<'a>, Diagnostic> {
        let missing = || {
            let heading = TABLES.iter().find(|known| known.kind == kind);
            let heading = heading.map_or("", |known| known.heading);
            let what = format!("the table {heading}");
            Diagnostic::new(0..0, DiagnosticKind::Missing { what })
                .with_hint("a table begins with a line of dashes and its heading")
        };
        self.find(kind).ok_or_else(missing)
    }
}

/// Whether a line is the heading of a section.
fn is_ruler(line: &Line<'_>) -> bool {
    let text = line.text.trim_start();
    text.starts_with("---") || text.starts_with("===")
}

/// A name without the differences between files.
fn plain(name: &str) -> String {
    let letters = name.chars().filter(char::is_ascii_alphanumeric).take(40);
    letters.map(|letter| letter.to_ascii_lowercase()).collect()
}

/// The table that a heading begins, identified by the name of its number of rows, otherwise by its
/// words.
fn known(heading: &Line<'_>, after: &Lines<'_>) -> Option<&'static Known> {
    let count = after.clone().find(|line| !line.is_blank())?;
    let first = count.first().filter(Token::is_number)?;
    let title = heading.text.to_ascii_uppercase();
    let mut behind = count.tokens().skip_while(Token::is_number);
    let name = plain(behind.next().map_or("", |token| token.text));
    let has_words = |known: &&Known| known.words.iter().any(|word| title.contains(word));
    let has_name = |known: &&Known| known.counts.contains(&name.as_str());
    let is_older_name = name == "npropsets";
    let rectangular = TABLES.iter().find(has_words).filter(|_| is_older_name);
    let by_name = TABLES.iter().find(has_name);
    let by_words = || TABLES.iter().find(has_words).filter(|_| !first.is_quoted);
    rectangular
        .filter(|known| known.kind == Kind::Rectangular)
        .or(by_name)
        .or_else(by_words)
}

/// The table whose heading was read.
fn section<'a>(known: &Known, lines: &mut Lines<'a>) -> Result<Section<'a>, Diagnostic> {
    let heading = known.heading;
    let line = lines.expect_filled(&format!("the number of rows of {heading}"))?;
    let count = Count::of(&line, heading)?;
    let names = headers(known, &count, lines)?;
    let mut rows: Vec<Row<'a>> = Vec::new();
    while rows.len() < count.rows {
        let what = format!("row {} of {heading}", rows.len() + 1);
        let line = lines.clone().find(|line| !line.is_blank());
        let is_row = |line: &Line<'_>| line.first().as_ref().is_some_and(Token::is_number);
        match line.filter(is_row) {
            Some(row) => {
                lines.expect_filled(&what)?;
                row.check_commas(&format!("a number in {what}"))?;
                rows.push(Row::new(row, what));
            }
            None => return Err(too_few(lines, &what, &count, rows.len())),
        }
    }
    match lines.clone().find(|line| !line.is_blank()) {
        Some(line) if !is_ruler(&line) => Err(count.too_many(&line, heading)),
        _ => Ok(Section {
            kind: known.kind,
            names,
            rows,
        }),
    }
}

/// The names of the columns; the line of units follows. An empty table needs neither.
fn headers<'a>(
    known: &Known,
    count: &Count<'_>,
    lines: &mut Lines<'a>,
) -> Result<&'a str, Diagnostic> {
    let mut names = None;
    for what in ["the names of the columns", "the units of the columns"] {
        let expected = format!("{what} of {}", known.heading);
        let next = lines.clone().find(|line| !line.is_blank());
        let is_header = |line: &Line<'_>| {
            !is_ruler(line) && !line.first().as_ref().is_some_and(Token::is_number)
        };
        match next {
            Some(line) if is_header(&line) => {
                lines.expect_filled(&expected)?;
                names.get_or_insert(line.text);
            }
            _ if count.rows == 0 => break,
            Some(line) => {
                let found = quoted(line.text.trim());
                let kind = DiagnosticKind::misplaced(expected, found);
                return Err(Diagnostic::new(line.span(), kind)
                    .with_hint("two lines with names and units are above the rows of each table"));
            }
            None => return Err(lines.ended(&expected)),
        }
    }
    Ok(names.unwrap_or_default())
}

/// The number of rows of a table.
struct Count<'a> {
    token: Token<'a>,
    /// Its name on the line.
    name: &'a str,
    rows: usize,
}

impl<'a> Count<'a> {
    fn of(line: &Line<'a>, heading: &str) -> Result<Self, Diagnostic> {
        let what = format!("the number of rows of {heading}");
        let Some(token) = line.first() else {
            let kind = DiagnosticKind::Missing { what };
            return Err(Diagnostic::new(line.span(), kind));
        };
        let value = token.integer(&what)?;
        let Some(rows) = usize::try_from(value)
            .ok()
            .filter(|rows| *rows <= MAX_COUNT)
        else {
            let rule = format!("from 0 to {MAX_COUNT}");
            let kind = DiagnosticKind::out_of_range(what, value as f64, rule);
            return Err(token.wrong(kind));
        };
        let mut behind = line.tokens().skip_while(Token::is_number);
        let name = behind.next().map_or("the number of rows", |name| name.text);
        Ok(Self { token, name, rows })
    }

    /// The mistake of a line after the rows that is not a heading.
    fn too_many(&self, line: &Line<'_>, heading: &str) -> Diagnostic {
        let expected = format!("the heading of the table after {heading}");
        let kind = DiagnosticKind::misplaced(expected, quoted(line.text.trim()));
        Diagnostic::new(line.span(), kind).with_hint(format!(
            "{} is {}: change it if there are more rows; the heading of a table begins with dashes",
            self.name, self.token.text
        ))
    }
}

/// The mistake of a line that is not a row, or of the end of the file.
fn too_few(lines: &Lines<'_>, what: &str, count: &Count<'_>, rows: usize) -> Diagnostic {
    let hint = format!(
        "{} is {}, but there {} above",
        count.name,
        count.token.text,
        match rows {
            1 => "is 1 row".to_owned(),
            rows => format!("are {rows} rows"),
        }
    );
    match lines.clone().find(|line| !line.is_blank()) {
        Some(line) => {
            let kind = DiagnosticKind::misplaced(what, quoted(line.text.trim()));
            Diagnostic::new(line.span(), kind).with_hint(hint)
        }
        None => lines.ended(what).with_hint(hint),
    }
}

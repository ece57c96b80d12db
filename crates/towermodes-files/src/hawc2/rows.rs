//! The rows of a HAWC2 subset: as many as announced, with increasing r.

use super::layout::Subset;
use super::row::{self, Row};
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::records::{Line, Lines, Token};

/// Largest number of mistakes that are collected; further ones have the same cause.
const MAX_MISTAKES: usize = 20;

/// The rows of a subset.
#[derive(Debug)]
pub(super) struct Table<'a> {
    /// The announced rows.
    pub(super) rows: Vec<Row<'a>>,
    /// The first row after the announced ones, which HAWC2 does not read, and the number of such
    /// rows.
    pub(super) unread: Option<(Line<'a>, usize)>,
}

/// Reads the rows that a subset announces.
pub(super) fn read_rows<'a>(subset: &Subset<'a>) -> Result<Table<'a>, Vec<Diagnostic>> {
    let mut lines = subset.after.clone();
    let (mut rows, mut mistakes) = (Vec::new(), Vec::new());
    let mut seen = 0;
    while seen < subset.announced && mistakes.len() < MAX_MISTAKES {
        let Some(line) = next_row(&mut lines) else {
            mistakes.push(too_few_rows(subset, &lines, seen));
            break;
        };
        seen += 1;
        if let Some(other) = line.first().filter(is_word) {
            mistakes.push(no_row(subset, &other, seen));
            break;
        }
        if row::is_full_matrix(&line) {
            // All rows have the same layout; columns of another layout need no further check.
            return Err(vec![row::full_matrix(&line)]);
        }
        match Row::parse(line) {
            Ok(row) => rows.push(row),
            Err(mistake) => mistakes.push(mistake),
        }
    }
    mistakes.extend(falling(&rows));
    if mistakes.is_empty() && rows.len() < 2 {
        let kind = DiagnosticKind::wrong_count_of("rows", "the subset", rows.len(), "at least 2");
        mistakes.push(Diagnostic::new(subset.span.clone(), kind));
    }
    if !mistakes.is_empty() {
        return Err(mistakes);
    }
    let unread = unread(lines);
    Ok(Table { rows, unread })
}

/// The first row in these lines, and the number of rows.
fn unread(mut lines: Lines<'_>) -> Option<(Line<'_>, usize)> {
    let first = next_row(&mut lines).filter(row::begins_with_number)?;
    let others = std::iter::from_fn(|| next_row(&mut lines));
    Some((
        first,
        1 + others.take_while(row::begins_with_number).count(),
    ))
}

/// The next line that is not blank; none if a set or subset begins there.
fn next_row<'a>(lines: &mut Lines<'a>) -> Option<Line<'a>> {
    while let Some(line) = lines.peek() {
        if line.text.trim_start().starts_with(['#', '$']) {
            return None;
        }
        lines.next();
        if !line.is_blank() {
            return Some(line);
        }
    }
    None
}

/// Whether a value is text, for example the name of a column.
fn is_word(token: &Token<'_>) -> bool {
    !token.is_number() && token.text.starts_with(char::is_alphabetic)
}

fn no_row(subset: &Subset<'_>, found: &Token<'_>, number: usize) -> Diagnostic {
    let (label, announced) = (subset.label(), subset.announced);
    let expected = format!("row {number} of the {announced} of {label}");
    let kind = DiagnosticKind::misplaced(expected, quoted(found.text));
    found.wrong(kind).with_hint(format!(
        "rows follow the line `${} {announced}` directly; is the number of rows in this line too large?",
        subset.number
    ))
}

fn too_few_rows(subset: &Subset<'_>, lines: &Lines<'_>, found: usize) -> Diagnostic {
    let what = subset.label();
    let kind = DiagnosticKind::wrong_count_of("rows", what, found, subset.announced);
    let hint = match lines.peek() {
        Some(_) => format!("write {found} here, or add the missing rows"),
        None => "the file ends after them: is it complete?".to_owned(),
    };
    Diagnostic::new(subset.span.clone(), kind).with_hint(hint)
}

/// The mistake at the first row where r decreases.
fn falling(rows: &[Row<'_>]) -> Option<Diagnostic> {
    let pair = rows
        .windows(2)
        .find(|pair| pair[1].of(row::R) < pair[0].of(row::R))?;
    let kind = DiagnosticKind::not_rising("r", pair[1].of(row::R), pair[0].of(row::R), "m");
    let hint = "r is the distance from the first node of the body";
    Some(Diagnostic::new(pair[1].span(row::R), kind).with_hint(hint))
}

//! The support of a point, a body or a rod, and the end of a line, as the file writes them.

use towermodes::mooring::{Carrier, RodEnd};

use super::column::Column;
use super::row::Row;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::records::Token;

/// The support of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Hold {
    Fixed,
    Platform,
    Free,
    /// The body of this number, from 1.
    Body(usize),
}

/// The end of a line, by its number from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    Point(usize),
    Rod(usize, RodEnd),
}

/// The letters, the number and the following letters of a word: `R1A` as `R`, 1 and `A`.
fn parts(text: &str) -> (String, Option<usize>, String) {
    let text: String = text
        .chars()
        .take(60)
        .collect::<String>()
        .to_ascii_uppercase();
    let from = text
        .find(|c: char| c.is_ascii_digit())
        .unwrap_or(text.len());
    let (letters, rest) = text.split_at(from);
    let to = rest
        .find(|c: char| !c.is_ascii_digit())
        .unwrap_or(rest.len());
    let (number, behind) = rest.split_at(to);
    (letters.to_owned(), number.parse().ok(), behind.to_owned())
}

/// Reads the support of a part; words of any length, as the programs accept them.
pub(super) fn hold(row: &Row<'_>, column: &Column) -> Result<Hold, Diagnostic> {
    let token = row.token(column)?;
    let (word, number, behind) = parts(token.text);
    if word.contains("PIN") || behind.contains("PIN") {
        let message = format!(
            "{} is {}: pinned bodies and rods are not modelled",
            row.what(column),
            quoted(token.text)
        );
        let hint = "use Fixed or Coupled if it cannot rotate, or Free with lines that hold it";
        return Err(row.unsupported(column, message).with_hint(hint));
    }
    let begins_with = |starts: &[&str]| starts.iter().any(|start| word.starts_with(start));
    match number {
        Some(body) if word == "BODY" && behind.is_empty() => return Ok(Hold::Body(body)),
        Some(_) if word == "TURBINE" || word == "T" => return Err(of_farm(row, column, token)),
        _ => {}
    }
    if number.is_none() && begins_with(&["FIX", "ANC"]) {
        Ok(Hold::Fixed)
    } else if number.is_none() && begins_with(&["VES", "COUP", "CPL"]) {
        Ok(Hold::Platform)
    } else if number.is_none()
        && (begins_with(&["CON", "FREE", "POINT"]) || ["P", "ROD", "R"].contains(&word.as_str()))
    {
        Ok(Hold::Free)
    } else {
        let expected = "Fixed, Vessel (or Coupled), Free (or Connect) or Body with its number";
        let found = quoted(token.text);
        let kind = DiagnosticKind::wrong_type(row.what(column), expected, found);
        Err(token.wrong(kind))
    }
}

fn of_farm(row: &Row<'_>, column: &Column, token: &Token<'_>) -> Diagnostic {
    let message = format!(
        "{} is {}: moorings that several turbines of a farm share are not modelled",
        row.what(column),
        quoted(token.text)
    );
    let hint = "give the mooring of one turbine, with Vessel in place of its number";
    row.unsupported(column, message).with_hint(hint)
}

/// The support of a body or a rod.
pub(super) fn carrier(row: &Row<'_>, column: &Column) -> Result<Carrier, Diagnostic> {
    match hold(row, column)? {
        Hold::Fixed => Ok(Carrier::Fixed),
        Hold::Platform => Ok(Carrier::Platform),
        Hold::Free => Ok(Carrier::Free),
        Hold::Body(body) => {
            let message = format!(
                "{} is body {body}: bodies and rods on other bodies are not modelled",
                row.what(column)
            );
            let hint =
                "add its mass and volume to the body, and attach its lines to points of the body";
            Err(row.unsupported(column, message).with_hint(hint))
        }
    }
}

/// Reads the end of a line: `3`, `P3`, `Point3`, `R1A` or `Rod1B`.
pub(super) fn end(row: &Row<'_>, column: &Column) -> Result<End, Diagnostic> {
    let token = row.token(column)?;
    let (word, number, behind) = parts(token.text.strip_suffix(".0").unwrap_or(token.text));
    match (word.as_str(), number, behind.as_str()) {
        ("" | "P" | "POINT" | "C" | "CON" | "CONNECT" | "N" | "NODE", Some(point), "") => {
            Ok(End::Point(point))
        }
        ("R" | "ROD", Some(rod), "A") => Ok(End::Rod(rod, RodEnd::A)),
        ("R" | "ROD", Some(rod), "B") => Ok(End::Rod(rod, RodEnd::B)),
        ("TURBINE" | "T", Some(_), _) => Err(of_farm(row, column, token)),
        _ => {
            let expected = "the number of a point, or the end of a rod as R1A or R1B";
            let found = quoted(token.text);
            let kind = DiagnosticKind::wrong_type(row.what(column), expected, found);
            Err(token.wrong(kind))
        }
    }
}

/// The index of a part by its number from 1.
pub(super) fn index(
    row: &Row<'_>,
    column: &Column,
    what: &'static str,
    number: usize,
    count: usize,
) -> Result<usize, Diagnostic> {
    if (1..=count).contains(&number) {
        return Ok(number - 1);
    }
    let span = row.get(column).map_or(row.span(), |t| t.span.clone());
    let name = number.to_string();
    let mistake = Diagnostic::new(span, DiagnosticKind::UnknownName { what, name });
    Err(mistake.with_hint(match count {
        0 => "its table has no rows".to_owned(),
        1 => "the only number in its table is 1".to_owned(),
        count => format!("its table has the numbers 1 to {count}"),
    }))
}

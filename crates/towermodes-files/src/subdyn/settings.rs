//! The parameters before the tables: the kind of element and the number of parts of each member,
//! and those that have no effect here.

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;
use crate::records::{Line, Lines, Token};
use crate::source::Source;

/// Number of lines in which the parameters are searched.
const FIRST_LINES: usize = 100;
/// Largest number of parts of a member.
const MOST_PARTS: i64 = 1000;

/// The settings for the elements of members in SubDyn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Settings {
    /// Whether beams have shear deformation (`FEMMod` 3).
    pub(super) shears: bool,
    /// Number of parts of each beam (`NDiv`).
    pub(super) divisions: usize,
}

/// Whether a text is an input file of SubDyn.
pub(crate) fn is_subdyn(text: &str) -> bool {
    let names = ["FEMMod", "NDiv"];
    let mut lines = Lines::new(text);
    names.iter().all(|name| parameter(text, name).is_some())
        && lines.any(|line| name_of(&line).is_some_and(|name| name.eq_ignore_ascii_case("NJoints")))
}

/// The name on a line, after one or more values.
fn name_of<'a>(line: &Line<'a>) -> Option<&'a str> {
    let mut tokens = line.tokens();
    tokens.next()?;
    tokens
        .find(|token| !token.is_number())
        .map(|token| token.text)
}

/// The value of a parameter.
fn parameter<'a>(text: &'a str, name: &str) -> Option<Token<'a>> {
    let mut lines = Lines::new(text).take(FIRST_LINES);
    let is_it = |line: &Line<'_>| name_of(line).is_some_and(|own| own.eq_ignore_ascii_case(name));
    lines.find(is_it)?.first()
}

fn expected<'a>(text: &'a str, name: &str) -> Result<Token<'a>, Diagnostic> {
    let missing = || Diagnostic::new(0..0, DiagnosticKind::missing_key("the file", name));
    parameter(text, name).ok_or_else(missing)
}

/// Reads the parameters.
pub(super) fn settings(text: &str) -> Result<Settings, Diagnostic> {
    let token = expected(text, "FEMMod")?;
    let shears = match token.integer("FEMMod (kind of element)")? {
        1 => false,
        3 => true,
        other => {
            let rule = "1 (Euler-Bernoulli) or 3 (Timoshenko), because SubDyn has no other element";
            let kind = DiagnosticKind::out_of_range("FEMMod", other as f64, rule);
            return Err(token.wrong(kind));
        }
    };
    let token = expected(text, "NDiv")?;
    let divisions = token.integer("NDiv (parts of each member)")?;
    if !(1..=MOST_PARTS).contains(&divisions) {
        let rule = format!("from 1 to {MOST_PARTS}");
        let kind = DiagnosticKind::out_of_range("NDiv", divisions as f64, rule);
        return Err(token.wrong(kind));
    }
    Ok(Settings {
        shears,
        divisions: divisions as usize,
    })
}

/// The notes on parameters that have no effect here.
pub(super) fn notes(source: &Source) -> Vec<Note> {
    let text = &source.text;
    let mut notes = Vec::new();
    if let Some(modes) = parameter(text, "Nmodes") {
        let message = format!(
            "Nmodes ({}) and the damping values are not used: all motions of the members are kept, without Craig-Bampton or Guyan reduction, and without damping",
            modes.text
        );
        notes.push(Note::left_out(message).at(source, modes.span.start));
    }
    if let Some((line, place)) = position(text) {
        let message = format!(
            "the initial rigid-body position ({}) is not used: the structure is solved where its joints are",
            line.split_whitespace().collect::<Vec<_>>().join(", ")
        );
        notes.push(Note::left_out(message).at(source, place));
    }
    notes
}

/// The line of the initial rigid-body position, if it is not zero.
fn position(text: &str) -> Option<(&str, usize)> {
    let mut lines = Lines::new(text).take(FIRST_LINES);
    let is_names = |line: &Line<'_>| {
        let first = line.first();
        first.is_some_and(|token| token.text.eq_ignore_ascii_case("RBSurge"))
    };
    lines.find(is_names)?;
    let values = lines.nth(1)?;
    let mut numbers = values.tokens().map_while(|token| token.number("").ok());
    numbers
        .any(|number| number != 0.0)
        .then_some((values.text, values.start))
}

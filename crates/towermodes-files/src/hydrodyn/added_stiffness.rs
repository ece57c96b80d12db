//! AddCLin and AddF0: additional stiffness and force at the origin, given by the user.

use towermodes::space::SpatialMatrix;

use super::spatial::{NONE, symmetric_part};
use super::values::Values;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;
use crate::records::{Line, Lines};
use crate::source::Source;

/// The added stiffness given by a user.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Added {
    pub(super) stiffness: SpatialMatrix,
    pub(super) force: [f64; 6],
    pub(super) notes: Vec<Note>,
}

/// Reads AddCLin and AddF0, which files of all versions contain; a line with a damaged number is
/// not recognized by its name.
pub(super) fn read(values: &Values<'_>, source: &Source) -> Result<Added, Diagnostic> {
    let mut notes = Vec::new();
    let line = expect(values, "AddCLin", "six rows of six numbers")?;
    let stiffness = symmetric(matrix(values.text, &line)?, &line, source, &mut notes);
    let line = expect(values, "AddF0", "six numbers in a row or in a column")?;
    let force = force(values.text, &line)?;
    Ok(Added {
        stiffness,
        force,
        notes,
    })
}

fn expect<'a>(values: &Values<'a>, name: &str, content: &str) -> Result<Line<'a>, Diagnostic> {
    let missing = || {
        let kind = DiagnosticKind::missing_key("the HydroDyn file", name);
        let hint = format!("{name} has {content}; the name follows the values of its first line");
        Diagnostic::new(0..0, kind).with_hint(hint)
    };
    values.line(name).ok_or_else(missing)
}

/// The lines beginning with a given one.
fn from<'a>(text: &'a str, line: &Line<'a>) -> impl Iterator<Item = Line<'a>> {
    let start = line.start;
    Lines::new(text).skip_while(move |line| line.start < start)
}

fn matrix(text: &str, first: &Line<'_>) -> Result<SpatialMatrix, Diagnostic> {
    let mut matrix = NONE;
    let mut lines = from(text, first);
    for (k, row) in matrix.iter_mut().enumerate() {
        let what = format!("row {} of AddCLin", k + 1);
        let ended = || {
            Diagnostic::new(
                first.span(),
                DiagnosticKind::EndOfFile {
                    expected: what.clone(),
                },
            )
        };
        *row = six(&lines.next().ok_or_else(ended)?, &what)?;
    }
    Ok(matrix)
}

/// Six numbers at the beginning of a line.
fn six(line: &Line<'_>, what: &str) -> Result<[f64; 6], Diagnostic> {
    line.check_commas(what)?;
    let mut row = [0.0; 6];
    let mut tokens = line.tokens();
    for (k, value) in row.iter_mut().enumerate() {
        let few = || {
            let kind = DiagnosticKind::wrong_count(what, k, 6);
            Diagnostic::new(line.span(), kind).with_hint("the matrix has six rows of six numbers")
        };
        *value = tokens.next().ok_or_else(few)?.number(what)?;
    }
    Ok(row)
}

/// Six numbers in a row, or since OpenFAST 2.6 in a column.
fn force(text: &str, first: &Line<'_>) -> Result<[f64; 6], Diagnostic> {
    let numbers = first.tokens().take_while(|token| token.is_number()).count();
    if numbers != 1 {
        return six(first, "AddF0");
    }
    let mut force = [0.0; 6];
    let mut lines = from(text, first);
    for value in &mut force {
        let ended = || {
            let kind = DiagnosticKind::wrong_count("AddF0", 1, 6);
            Diagnostic::new(first.span(), kind)
        };
        let line = lines.next().ok_or_else(ended)?;
        let token = line.first().ok_or_else(|| {
            let what = "a value of AddF0".to_owned();
            Diagnostic::new(line.span(), DiagnosticKind::Missing { what })
                .with_hint("AddF0 has six values, in a row or in a column")
        })?;
        *value = token.number("AddF0")?;
    }
    Ok(force)
}

fn symmetric(
    matrix: SpatialMatrix,
    line: &Line<'_>,
    source: &Source,
    notes: &mut Vec<Note>,
) -> SpatialMatrix {
    let (symmetric, skew) = symmetric_part(&matrix);
    if skew > 0.0 {
        let message = format!(
            "AddCLin is not symmetric: half the difference of opposite entries is up to {skew:.2} of their size; the mean of both is used"
        );
        notes.push(Note::suspicious(message).at(source, line.start));
    }
    symmetric
}

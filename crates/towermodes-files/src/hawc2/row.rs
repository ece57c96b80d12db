//! A row of a HAWC2 subset: its 19 columns.

use std::ops::Range;

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::records::{Line, Token};

/// Columns of a row, counted from 0.
pub(super) const R: usize = 0;
pub(super) const MASS: usize = 1;
pub(super) const CG: [usize; 2] = [2, 3];
pub(super) const GYRATION: [usize; 2] = [4, 5];
pub(super) const SHEAR_CENTRE: [usize; 2] = [6, 7];
pub(super) const YOUNG: usize = 8;
pub(super) const SHEAR_MODULUS: usize = 9;
pub(super) const SECOND_MOMENT: [usize; 2] = [10, 11];
pub(super) const TORSION: usize = 12;
pub(super) const SHEAR_FACTOR: [usize; 2] = [13, 14];
pub(super) const AREA: usize = 15;
pub(super) const PITCH: usize = 16;
pub(super) const ELASTIC_CENTRE: [usize; 2] = [17, 18];

/// Number of columns.
pub(super) const COLUMNS: usize = 19;
/// Number of columns of a row with a full stiffness matrix.
const FULL_MATRIX_COLUMNS: usize = 30;

/// The name of each column, its unit with a blank before it, and the range of its values.
const NAMES: [(&str, &str, Allowed); COLUMNS] = [
    ("r, the distance along the body", " m", Allowed::Any),
    ("m, mass per length", " kg/m", Allowed::Positive),
    ("x_cg", " m", Allowed::Any),
    ("y_cg", " m", Allowed::Any),
    (
        "ri_x, radius of gyration about x",
        " m",
        Allowed::NotNegative,
    ),
    (
        "ri_y, radius of gyration about y",
        " m",
        Allowed::NotNegative,
    ),
    ("x_sh", " m", Allowed::Any),
    ("y_sh", " m", Allowed::Any),
    ("E, Young's modulus", " Pa", Allowed::Positive),
    ("G, shear modulus", " Pa", Allowed::Positive),
    (
        "I_x, second moment of area about x",
        " m4",
        Allowed::Positive,
    ),
    (
        "I_y, second moment of area about y",
        " m4",
        Allowed::Positive,
    ),
    ("K, torsional constant", " m4", Allowed::Positive),
    ("k_x, shear factor", "", Allowed::NotNegative),
    ("k_y, shear factor", "", Allowed::NotNegative),
    ("A, area", " m2", Allowed::Positive),
    ("the structural pitch", " degrees", Allowed::Any),
    ("x_e", " m", Allowed::Any),
    ("y_e", " m", Allowed::Any),
];

#[derive(Clone, Copy)]
enum Allowed {
    Any,
    NotNegative,
    Positive,
}

/// The numbers of a row with its line.
#[derive(Debug, Clone)]
pub(super) struct Row<'a> {
    /// Its columns.
    pub(super) values: [f64; COLUMNS],
    /// Its line.
    pub(super) line: Line<'a>,
}

impl<'a> Row<'a> {
    /// The numbers of a line; a further number is a mistake.
    pub(super) fn parse(line: Line<'a>) -> Result<Self, Diagnostic> {
        let mut tokens = line.tokens();
        let mut values = [0.0; COLUMNS];
        for (column, value) in values.iter_mut().enumerate() {
            let token = tokens.next().ok_or_else(|| too_few(&line, column))?;
            *value = number(&token, column)?;
        }
        let others: Vec<Token<'_>> = tokens.take(FULL_MATRIX_COLUMNS - COLUMNS + 1).collect();
        let numbers = others.iter().take_while(|token| token.is_number()).count();
        match numbers {
            0 => Ok(Self { values, line }),
            more => Err(too_many(&others[0], COLUMNS + more)),
        }
    }

    /// The value of a column.
    pub(super) fn of(&self, column: usize) -> f64 {
        self.values[column]
    }

    /// The values of the columns for x and y.
    pub(super) fn pair(&self, columns: [usize; 2]) -> [f64; 2] {
        columns.map(|column| self.values[column])
    }

    /// The byte range of a column in the file.
    pub(super) fn span(&self, column: usize) -> Range<usize> {
        let token = self.line.tokens().nth(column);
        token.map_or_else(|| self.line.span(), |token| token.span)
    }
}

/// The name of a column, and its unit with a blank before it.
pub(super) fn name_and_unit(column: usize) -> (&'static str, &'static str) {
    let (name, unit, _) = NAMES[column];
    (name, unit)
}

/// Whether a line begins with a number, as rows do and headers do not.
pub(super) fn begins_with_number(line: &Line<'_>) -> bool {
    line.first().is_some_and(|token| token.is_number())
}

/// Whether a line has enough numbers for a full stiffness matrix of the section.
pub(super) fn is_full_matrix(line: &Line<'_>) -> bool {
    let numbers = line.tokens().take_while(Token::is_number);
    numbers.take(FULL_MATRIX_COLUMNS).count() == FULL_MATRIX_COLUMNS
}

/// The mistake of a line with a full matrix: only the layout with 19 columns is read.
pub(super) fn full_matrix(line: &Line<'_>) -> Diagnostic {
    let found = line.tokens().take_while(Token::is_number).count();
    let kind = DiagnosticKind::Unsupported(format!(
        "the rows have {found} columns: full 6x6 stiffness matrices (FPM) are not supported"
    ));
    let first_more = line.tokens().nth(COLUMNS);
    let span = first_more.map_or_else(|| line.span(), |token| token.span);
    Diagnostic::new(span, kind).with_hint(format!(
        "use the classic {COLUMNS} columns, with E, G, I_x, I_y, K and A"
    ))
}

/// A number in the range of its column.
fn number(token: &Token<'_>, column: usize) -> Result<f64, Diagnostic> {
    let (name, unit, allowed) = NAMES[column];
    let what = format!("column {}, {name},", column + 1);
    let value = token.number(&what)?;
    let rule = match allowed {
        Allowed::Positive if value <= 0.0 => "positive",
        Allowed::NotNegative if value < 0.0 => "non-negative",
        _ => return Ok(value),
    };
    Err(token.wrong(DiagnosticKind::out_of_range_in(
        what,
        value,
        unit.trim(),
        rule,
    )))
}

fn too_few(line: &Line<'_>, found: usize) -> Diagnostic {
    let end = line.start + line.text.trim_end().len();
    let kind = DiagnosticKind::wrong_count_of("columns", "the row", found, COLUMNS);
    let hint = format!(
        "column {}, {}, is expected here; the columns are r m x_cg y_cg ri_x ri_y x_sh y_sh E G I_x I_y K k_x k_y A pitch x_e y_e",
        found + 1,
        NAMES[found].0
    );
    Diagnostic::new(end..end, kind).with_hint(hint)
}

fn too_many(first: &Token<'_>, found: usize) -> Diagnostic {
    let kind = DiagnosticKind::wrong_count_of("columns", "the row", found, COLUMNS);
    first
        .wrong(kind)
        .with_hint("is a blank missing, or is there an extra blank?")
}

//! The values of a row, and the numbers by which rows refer to each other.

use std::collections::HashMap;
use std::ops::Range;

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::records::{Line, Token};

/// Largest number of values of a row.
const MOST: usize = 64;

/// A row of a table.
#[derive(Debug, Clone)]
pub(super) struct Row<'a> {
    line: Line<'a>,
    tokens: Vec<Token<'a>>,
    /// Its name in messages.
    name: String,
}

impl<'a> Row<'a> {
    pub(super) fn new(line: Line<'a>, name: String) -> Self {
        let tokens = line.tokens().take(MOST).collect();
        Self { line, tokens, name }
    }

    /// Number of values at its beginning.
    pub(super) fn numbers(&self) -> usize {
        self.tokens.iter().take_while(|t| t.is_number()).count()
    }

    /// The value of a column, from 0, if it exists.
    pub(super) fn get(&self, column: usize) -> Option<&Token<'a>> {
        self.tokens.get(column)
    }

    /// The value of a column.
    pub(super) fn token(&self, column: usize, name: &str) -> Result<&Token<'a>, Diagnostic> {
        let missing = || {
            let what = format!("{name} in {}", self.name);
            Diagnostic::new(self.span(), DiagnosticKind::Missing { what })
        };
        self.get(column).ok_or_else(missing)
    }

    /// The number in a column.
    pub(super) fn number(&self, column: usize, name: &str) -> Result<f64, Diagnostic> {
        let token = self.token(column, name)?;
        token.number(&format!("{name} in {}", self.name))
    }

    /// The numbers in successive columns.
    pub(super) fn numbers_from<const N: usize>(
        &self,
        first: usize,
        names: [&str; N],
    ) -> Result<[f64; N], Diagnostic> {
        let mut values = [0.0; N];
        for (k, (value, name)) in values.iter_mut().zip(names).enumerate() {
            *value = self.number(first + k, name)?;
        }
        Ok(values)
    }

    /// The integer in a column; `5.0` is accepted, because Fortran reads some tables as real
    /// numbers.
    pub(super) fn integer(&self, column: usize, name: &str) -> Result<i64, Diagnostic> {
        let token = self.token(column, name)?;
        let value = token.number("").ok().filter(|value| value.fract() == 0.0);
        match value.filter(|value| value.abs() < 1e15) {
            Some(value) => Ok(value as i64),
            None => token.integer(&format!("{name} in {}", self.name)),
        }
    }

    /// Whether a flag, 1 or 0, is set.
    pub(super) fn flag(&self, column: usize, name: &str) -> Result<bool, Diagnostic> {
        match self.integer(column, name)? {
            0 => Ok(false),
            1 => Ok(true),
            other => {
                let what = format!("{name} in {}", self.name);
                let kind = DiagnosticKind::out_of_range(what, other as f64, "1 (held) or 0 (free)");
                Err(self.wrong(column, kind))
            }
        }
    }

    /// A mistake at a column.
    pub(super) fn wrong(&self, column: usize, kind: DiagnosticKind) -> Diagnostic {
        let span = self.get(column).map_or(self.span(), |t| t.span.clone());
        Diagnostic::new(span, kind)
    }

    /// The mistake of a row whose number of values fits none of its layouts, or that contains NaN
    /// or infinity.
    pub(super) fn wrong_count(&self, expected: &str, hint: &str) -> Diagnostic {
        let token = self.get(self.numbers());
        let no_number = token.filter(|token| token.text.parse::<f64>().is_ok());
        if let Some(mistake) = no_number.and_then(|token| {
            let what = format!("a value in {}", self.name);
            token.number(&what).err()
        }) {
            return mistake;
        }
        let kind =
            DiagnosticKind::wrong_count_of("numbers", self.name.as_str(), self.numbers(), expected);
        Diagnostic::new(self.span(), kind).with_hint(hint)
    }

    pub(super) fn span(&self) -> Range<usize> {
        let first = self
            .tokens
            .first()
            .map_or(self.line.start, |t| t.span.start);
        let last = self
            .tokens
            .iter()
            .take_while(|token| token.text != "!")
            .last();
        first..last.map_or(first, |token| token.span.end)
    }
}

/// The numbers of the rows of a table, by which other tables refer to them.
#[derive(Debug, Clone, Default)]
pub(super) struct Ids {
    /// Name of a row: `joint`.
    what: &'static str,
    indices: HashMap<i64, usize>,
}

impl Ids {
    /// The numbers in the first column of a table.
    pub(super) fn of(rows: &[Row<'_>], what: &'static str) -> Result<Self, Diagnostic> {
        let mut indices = HashMap::new();
        for (index, row) in rows.iter().enumerate() {
            let id = row.integer(0, "the number")?;
            if indices.insert(id, index).is_some() {
                let what = format!("{what} {id}");
                return Err(row
                    .wrong(0, DiagnosticKind::Repeated { what, times: 2 })
                    .with_hint("each row needs a different number"));
            }
        }
        Ok(Self { what, indices })
    }

    /// The index of the row whose number is given in a column of another row.
    pub(super) fn find(
        &self,
        row: &Row<'_>,
        column: usize,
        name: &str,
    ) -> Result<usize, Diagnostic> {
        let id = row.integer(column, name)?;
        let unknown = || {
            let (what, name) = (self.what, id.to_string());
            let mistake = row.wrong(column, DiagnosticKind::UnknownName { what, name });
            let (least, most) = (self.indices.keys().min(), self.indices.keys().max());
            mistake.with_hint(match (least, most) {
                (Some(least), Some(most)) if least != most => {
                    format!(
                        "the table has {} rows, with numbers from {least} to {most}",
                        self.indices.len()
                    )
                }
                (Some(only), _) => format!("the only number in the table is {only}"),
                _ => "its table has no rows".to_owned(),
            })
        };
        self.indices.get(&id).copied().ok_or_else(unknown)
    }

    /// The index of a number, if there is one.
    pub(super) fn index(&self, id: i64) -> Option<usize> {
        self.indices.get(&id).copied()
    }
}

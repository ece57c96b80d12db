//! The values of a row.

use std::ops::Range;
use std::rc::Rc;

use super::column::{Column, Layout};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::records::{Line, Token};

/// Largest number of values of a row.
const MOST: usize = 64;

/// The columns of a table.
#[derive(Debug)]
pub(super) struct Header {
    /// The names in the form of `plain`.
    pub(super) names: Vec<String>,
    /// The program whose column order is used, if the names are not known.
    pub(super) unnamed: Option<Layout>,
}

impl Header {
    pub(super) fn index(&self, column: &Column) -> Option<usize> {
        match self.unnamed {
            Some(layout) => column.usual(layout),
            None => column.named(&self.names),
        }
    }
}

/// A row of a table.
#[derive(Debug, Clone)]
pub(super) struct Row<'a> {
    line: Line<'a>,
    tokens: Vec<Token<'a>>,
    header: Rc<Header>,
    /// The name of the row in messages: `row 2 of POINTS`.
    name: String,
}

impl<'a> Row<'a> {
    pub(super) fn new(line: Line<'a>, header: Rc<Header>, name: String) -> Self {
        let tokens = line.tokens().take(MOST).collect();
        Self {
            line,
            tokens,
            header,
            name,
        }
    }

    /// The value of a column, if the table has it.
    pub(super) fn get(&self, column: &Column) -> Option<&Token<'a>> {
        self.tokens.get(self.header.index(column)?)
    }

    /// The values from a column on.
    pub(super) fn from(&self, column: &Column) -> &[Token<'a>] {
        let first = self.header.index(column);
        first
            .and_then(|first| self.tokens.get(first..))
            .unwrap_or_default()
    }

    /// The value of a column.
    pub(super) fn token(&self, column: &Column) -> Result<&Token<'a>, Diagnostic> {
        let what = self.what(column);
        let missing = || Diagnostic::new(self.span(), DiagnosticKind::Missing { what });
        self.get(column).ok_or_else(missing)
    }

    /// The number in a column.
    pub(super) fn number(&self, column: &Column) -> Result<f64, Diagnostic> {
        self.token(column)?.number(&self.what(column))
    }

    /// The number in a column, 0 if the table does not have it.
    pub(super) fn number_or_0(&self, column: &Column) -> Result<f64, Diagnostic> {
        match self.header.index(column) {
            Some(_) => self.number(column),
            None => Ok(0.0),
        }
    }

    /// The numbers in several columns.
    pub(super) fn numbers<const N: usize>(
        &self,
        columns: &[Column; N],
    ) -> Result<[f64; N], Diagnostic> {
        let mut values = [0.0; N];
        for (value, column) in values.iter_mut().zip(columns) {
            *value = self.number(column)?;
        }
        Ok(values)
    }

    /// The numbers of a value such as `0.5|0|-8`: one, or three.
    pub(super) fn bars(&self, column: &Column) -> Result<Vec<f64>, Diagnostic> {
        let (token, what) = (self.token(column)?, self.what(column));
        let parts = token.text.split('|').take(MOST);
        let values: Result<Vec<f64>, Diagnostic> = parts
            .map(|text| {
                Token {
                    text,
                    ..token.clone()
                }
                .number(&what)
            })
            .collect();
        values
    }

    /// Checks that its number equals its position, as MoorDyn and MAP++ do.
    pub(super) fn check_id(&self, column: &Column, index: usize) -> Result<(), Diagnostic> {
        let token = self.token(column)?;
        let what = self.what(column);
        let is_right = token
            .number("")
            .is_ok_and(|number| number == (index + 1) as f64);
        if is_right {
            return Ok(());
        }
        let value = token.number(&what)?;
        let rule = format!("{}, as rows are numbered from 1 in their order", index + 1);
        Err(token.wrong(DiagnosticKind::out_of_range(what, value, rule)))
    }

    /// The name of a value in messages.
    pub(super) fn what(&self, column: &Column) -> String {
        format!("{} in {}", column.name, self.name)
    }

    /// The mistake of a value that is not modelled, at its place.
    pub(super) fn unsupported(&self, column: &Column, message: String) -> Diagnostic {
        let span = self.get(column).map_or(self.span(), |t| t.span.clone());
        Diagnostic::new(span, DiagnosticKind::Unsupported(message))
    }

    pub(super) fn span(&self) -> Range<usize> {
        let first = self
            .tokens
            .first()
            .map_or(self.line.start, |t| t.span.start);
        first..self.tokens.last().map_or(first, |token| token.span.end)
    }
}

//! The tables of a file: the number of rows with its name, names and units of the columns, rows.
//! Columns are found by their names, because newer versions have additional columns.

use std::collections::HashMap;
use std::ops::Range;

use super::values::Values;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::records::{Line, Lines, Token};

/// Largest number of rows of a table.
const MOST_ROWS: usize = 5_000;
/// Largest number of values of a row.
const MOST_VALUES: usize = 20_000;

/// A table.
#[derive(Debug, Clone, Default)]
pub(super) struct Table<'a> {
    /// The name of its number of rows.
    pub(super) name: &'static str,
    columns: Vec<String>,
    pub(super) rows: Vec<Row<'a>>,
}

/// A row of a table.
#[derive(Debug, Clone)]
pub(super) struct Row<'a> {
    line: Line<'a>,
    pub(super) tokens: Vec<Token<'a>>,
    /// Its name in messages.
    name: String,
}

impl<'a> Table<'a> {
    /// The table whose number of rows has one of these names; an empty table if the file has none.
    pub(super) fn of(
        values: &Values<'a>,
        names: &[&'static str],
        most: usize,
    ) -> Result<Self, Diagnostic> {
        let mut names = names.iter();
        let Some((name, line)) = names.find_map(|name| Some((name, values.line(name)?))) else {
            return Ok(Self::default());
        };
        let count = count(&line, name, most.min(MOST_ROWS))?;
        let start = line.start;
        let mut lines = Lines::new(values.text);
        lines.by_ref().find(|line| line.start == start);
        let columns = match count {
            0 => Vec::new(),
            _ => header(&mut lines, name)?,
        };
        let mut rows = Vec::new();
        while rows.len() < count {
            let what = format!("row {} of the table with {name} rows", rows.len() + 1);
            rows.push(row(&mut lines, what, name, count)?);
        }
        Ok(Self {
            name,
            columns,
            rows,
        })
    }

    /// The single row of a table without a number of rows, whose header has this column.
    pub(super) fn with_column(
        text: &'a str,
        column: &'static str,
    ) -> Result<Option<Self>, Diagnostic> {
        let mut lines = Lines::new(text);
        let is_header = |line: &Line<'_>| {
            let first = line.first();
            first.is_some_and(|token| !token.is_number())
                && line
                    .tokens()
                    .any(|token| token.text.eq_ignore_ascii_case(column))
        };
        let Some(line) = lines.by_ref().find(is_header) else {
            return Ok(None);
        };
        lines.expect("the units of the columns")?;
        let what = format!("the row below {column}");
        let rows = vec![row(&mut lines, what, column, 1)?];
        Ok(Some(Self {
            name: column,
            columns: names(&line),
            rows,
        }))
    }

    /// The column with one of these names.
    pub(super) fn column(&self, names: &[&str]) -> Result<usize, Diagnostic> {
        let missing = || {
            let what = format!(
                "the column {} of the table with {} rows",
                names[0], self.name
            );
            let span = self.rows.first().map_or(0..0, Row::span);
            Diagnostic::new(span, DiagnosticKind::Missing { what })
                .with_hint("the line above the units has the names of the columns")
        };
        self.column_if_any(names).ok_or_else(missing)
    }

    pub(super) fn column_if_any(&self, names: &[&str]) -> Option<usize> {
        let is_it = |own: &String| names.iter().any(|name| own.eq_ignore_ascii_case(name));
        self.columns.iter().position(is_it)
    }

    /// A number of a row by the name of its column.
    pub(super) fn number(&self, row: &Row<'_>, name: &str) -> Result<f64, Diagnostic> {
        row.number(self.column(&[name])?, name)
    }

    /// A number that is not negative.
    pub(super) fn not_negative(&self, row: &Row<'_>, name: &str) -> Result<f64, Diagnostic> {
        let value = self.number(row, name)?;
        match value >= 0.0 {
            true => Ok(value),
            false => {
                let what = format!("{name} in {}", row.name);
                let kind = DiagnosticKind::out_of_range(what, value, "0 or positive");
                Err(row.wrong(self.column(&[name])?, kind))
            }
        }
    }

    /// The rows by the number in their first column.
    pub(super) fn ids(&self, what: &'static str) -> Result<Ids, Diagnostic> {
        let mut indices = HashMap::new();
        for (index, row) in self.rows.iter().enumerate() {
            let id = row.integer(0, "the number")?;
            if indices.insert(id, index).is_some() {
                let what = format!("{what} {id}");
                let kind = DiagnosticKind::Repeated { what, times: 2 };
                return Err(row
                    .wrong(0, kind)
                    .with_hint("each row needs a different number"));
            }
        }
        Ok(Ids { what, indices })
    }
}

fn count(line: &Line<'_>, name: &str, most: usize) -> Result<usize, Diagnostic> {
    let missing = || DiagnosticKind::missing_key("the HydroDyn file", name);
    let token = line
        .first()
        .ok_or_else(|| Diagnostic::new(line.span(), missing()))?;
    let value = token.integer(name)?;
    let count = usize::try_from(value).ok().filter(|count| *count <= most);
    let kind = || DiagnosticKind::out_of_range(name, value as f64, format!("from 0 to {most}"));
    count.ok_or_else(|| token.wrong(kind()))
}

/// The names of the columns; the line of units follows.
fn header(lines: &mut Lines<'_>, name: &str) -> Result<Vec<String>, Diagnostic> {
    let line = lines.expect_filled(&format!("the names of the columns below {name}"))?;
    if line.first().is_some_and(|token| token.is_number()) {
        let expected = format!("the names of the columns below {name}");
        let kind = DiagnosticKind::misplaced(expected, quoted(line.text.trim()));
        return Err(Diagnostic::new(line.span(), kind)
            .with_hint("a line with names and a line with units are above the rows"));
    }
    lines.expect_filled(&format!("the units of the columns below {name}"))?;
    Ok(names(&line))
}

fn names(line: &Line<'_>) -> Vec<String> {
    let tokens = line.tokens().take(MOST_VALUES);
    let tokens = tokens.take_while(|token| !token.text.starts_with('['));
    tokens.map(|token| token.text.to_owned()).collect()
}

fn row<'a>(
    lines: &mut Lines<'a>,
    what: String,
    name: &str,
    count: usize,
) -> Result<Row<'a>, Diagnostic> {
    let line = lines.expect_filled(&what)?;
    if line.first().is_some_and(|token| token.is_number()) {
        let tokens = line.tokens().take(MOST_VALUES).collect();
        let name = what;
        return Ok(Row { line, tokens, name });
    }
    let kind = DiagnosticKind::misplaced(what, quoted(line.text.trim()));
    Err(Diagnostic::new(line.span(), kind).with_hint(format!(
        "{name} asks for {count} rows: is the number right?"
    )))
}

impl<'a> Row<'a> {
    /// The value of a column.
    pub(super) fn token(&self, column: usize, name: &str) -> Result<&Token<'a>, Diagnostic> {
        let missing = || {
            let what = format!("{name} in {}", self.name);
            Diagnostic::new(self.span(), DiagnosticKind::Missing { what })
        };
        self.tokens.get(column).ok_or_else(missing)
    }

    pub(super) fn number(&self, column: usize, name: &str) -> Result<f64, Diagnostic> {
        let what = format!("{name} in {}", self.name);
        self.token(column, name)?.number(&what)
    }

    /// The integer in a column; `5.0` is accepted.
    pub(super) fn integer(&self, column: usize, name: &str) -> Result<i64, Diagnostic> {
        let token = self.token(column, name)?;
        let value = token.number("").ok().filter(|value| value.fract() == 0.0);
        match value.filter(|value| value.abs() < 1e15) {
            Some(value) => Ok(value as i64),
            None => token.integer(&format!("{name} in {}", self.name)),
        }
    }

    /// A mistake at a column.
    pub(super) fn wrong(&self, column: usize, kind: DiagnosticKind) -> Diagnostic {
        let span = self
            .tokens
            .get(column)
            .map_or(self.span(), |token| token.span.clone());
        Diagnostic::new(span, kind)
    }

    pub(super) fn span(&self) -> Range<usize> {
        let first = self
            .tokens
            .first()
            .map_or(self.line.start, |token| token.span.start);
        first..self.tokens.last().map_or(first, |token| token.span.end)
    }
}

/// The numbers of the rows of a table, by which other tables refer to them.
#[derive(Debug, Clone)]
pub(super) struct Ids {
    what: &'static str,
    indices: HashMap<i64, usize>,
}

impl Ids {
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
            row.wrong(column, DiagnosticKind::UnknownName { what, name })
        };
        self.index(id).ok_or_else(unknown)
    }

    pub(super) fn index(&self, id: i64) -> Option<usize> {
        self.indices.get(&id).copied()
    }
}

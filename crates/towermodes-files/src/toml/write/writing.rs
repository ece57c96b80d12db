//! The text of a tower file while it is written, line by line.

use super::text::{number, quoted};
use crate::note::Note;
use crate::toml::schema::{KeySchema, TableSchema};

/// Number of values per line of a column of properties.
const VALUES_IN_A_LINE: usize = 5;

/// The text so far and its notes.
#[derive(Debug, Default)]
pub(super) struct Writing {
    pub(super) text: String,
    pub(super) notes: Vec<Note>,
    /// The table that is being written, whose schema contains the comments of its keys.
    table: Option<&'static TableSchema>,
}

impl Writing {
    /// Writes a line.
    pub(super) fn line(&mut self, line: impl AsRef<str>) {
        self.text.push_str(line.as_ref());
        self.text.push('\n');
    }

    /// Writes a blank line and the header of a table.
    pub(super) fn section(&mut self, table: &'static TableSchema) {
        self.section_called(table.name, table);
    }

    /// Writes a blank line and another header for a table.
    pub(super) fn section_called(&mut self, head: &str, table: &'static TableSchema) {
        self.table = Some(table);
        self.line("");
        self.line(head);
    }

    /// The comment of a key in the schema.
    pub(super) fn comment(&self, key: &str) -> String {
        let key = self.table.and_then(|table| table.key(key));
        debug_assert!(key.is_some());
        key.map(KeySchema::comment).unwrap_or_default()
    }

    /// Writes `key = value` with the comment of the schema.
    pub(super) fn value(&mut self, key: &str, value: &str) {
        let comment = self.comment(key);
        self.commented(key, value, &comment);
    }

    /// Writes `key = value` with a comment, if there is one.
    pub(super) fn commented(&mut self, key: &str, value: &str, comment: &str) {
        let line = format!("{key} = {value}");
        if comment.is_empty() {
            self.line(line);
        } else {
            self.line(format!("{line:<30} # {comment}"));
        }
    }

    /// Writes the name of a part, if it has one.
    pub(super) fn name(&mut self, name: Option<&String>) {
        if let Some(name) = name.filter(|name| !name.is_empty()) {
            self.commented("name", &quoted(name), "");
        }
    }

    pub(super) fn number(&mut self, key: &str, value: f64) {
        self.value(key, &number(value));
    }

    /// Writes the beginning of a list of rows with the comment of the schema.
    pub(super) fn open_rows(&mut self, key: &str) {
        let comment = self.comment(key);
        self.line(format!("{key} = [  # {comment}"));
    }

    pub(super) fn note(&mut self, message: impl Into<String>) {
        self.notes.push(Note::left_out(message));
    }

    /// Writes rows in brackets, one per line, with aligned columns.
    pub(super) fn rows(&mut self, cells: &[Vec<String>]) {
        let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
        let width = |column: usize| {
            let of_column = cells.iter().filter_map(|row| row.get(column));
            of_column.map(|cell| cell.chars().count()).max()
        };
        let widths: Vec<usize> = (0..columns).filter_map(width).collect();
        for row in cells {
            let aligned = row.iter().zip(&widths);
            let aligned: Vec<String> = aligned.map(|(cell, &w)| format!("{cell:>w$}")).collect();
            self.line(format!("  [{}],", aligned.join(", ")));
        }
    }

    /// Writes rows of numbers, of which only the first columns are used.
    pub(super) fn number_rows<const N: usize>(&mut self, values: &[[f64; N]], columns: usize) {
        let row = |row: &[f64; N]| row.iter().take(columns).copied().map(number).collect();
        let cells: Vec<Vec<String>> = values.iter().map(row).collect();
        self.rows(&cells);
    }

    /// Writes a list of numbers on as many lines as it needs.
    pub(super) fn list(&mut self, key: &str, values: impl Iterator<Item = f64>) {
        let cells: Vec<String> = values.map(number).collect();
        let width = cells.iter().map(String::len).max().unwrap_or(0);
        self.line(format!("{key} = ["));
        for line in cells.chunks(VALUES_IN_A_LINE) {
            let aligned: Vec<String> = line.iter().map(|cell| format!("{cell:>width$}")).collect();
            self.line(format!("  {},", aligned.join(", ")));
        }
        self.line("]");
    }
}

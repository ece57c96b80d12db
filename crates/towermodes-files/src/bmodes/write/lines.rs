//! The records of a deck's main file.

use towermodes::space::SpatialMatrix;

use super::number::{number, rounded};

/// Values on a line of those lists that go over several.
pub(super) const VALUES_IN_A_LINE: usize = 8;

/// Lines of a deck: BModes counts them, so each is written for itself.
#[derive(Default)]
pub(super) struct Lines(pub(super) String);

impl Lines {
    pub(super) fn comment(&mut self, comment: &str) {
        self.0.push_str(comment);
        self.0.push('\n');
    }

    /// A value, its name and what it is.
    pub(super) fn value(&mut self, value: &str, name: &str, meaning: &str) {
        self.comment(&format!("{value:<22} {:<17}{meaning}", format!("{name}:")));
    }

    pub(super) fn number(&mut self, value: f64, name: &str, meaning: &str) {
        self.value(&number(value), name, meaning);
    }

    /// As many values as follow from another one, over several lines; the meaning is behind the
    /// last one.
    pub(super) fn list(&mut self, values: &[String], name: &str, meaning: &str) {
        let mut lines: Vec<String> = values
            .chunks(VALUES_IN_A_LINE)
            .map(|v| v.join("  "))
            .collect();
        let last = lines.pop().unwrap_or_else(|| "0.0  0.0".into());
        for line in lines {
            self.comment(&line);
        }
        self.comment(&format!("{last}  : {name}: {meaning}"));
    }

    pub(super) fn matrix(&mut self, matrix: &SpatialMatrix) {
        for row in matrix {
            self.comment(
                &row.map(|entry| format!("{:>22}", number(rounded(entry))))
                    .join(" "),
            );
        }
    }
}

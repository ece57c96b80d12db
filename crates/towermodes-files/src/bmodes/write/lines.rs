//! The records of a deck's main file.

use towermodes::space::SpatialMatrix;

use super::super::records::parameters::Parameter;
use super::number::{number, rounded};

/// Number of values per line of lists that need several lines.
pub(super) const VALUES_IN_A_LINE: usize = 8;

/// The lines of a deck, which BModes counts.
#[derive(Default)]
pub(super) struct Lines(pub(super) String);

impl Lines {
    pub(super) fn comment(&mut self, comment: &str) {
        self.0.push_str(comment);
        self.0.push('\n');
    }

    /// A blank line and the heading of a block.
    pub(super) fn heading(&mut self, heading: &str) {
        self.comment("");
        self.comment(&format!("{:-<80}", format!("--------- {heading} ")));
    }

    /// A parameter: its value, its name and its meaning.
    pub(super) fn value(&mut self, parameter: &Parameter, value: &str) {
        let name = format!("{}:", parameter.name);
        self.comment(&format!("{value:<22} {name:<17}{}", parameter.comment()));
    }

    /// The parameters of a block.
    pub(super) fn block<const N: usize>(
        &mut self,
        parameters: [&Parameter; N],
        values: [String; N],
    ) {
        for (parameter, value) in parameters.into_iter().zip(values) {
            self.value(parameter, &value);
        }
    }

    /// A parameter with several values, on several lines; its name and meaning follow the last one.
    pub(super) fn list(&mut self, parameter: &Parameter, values: impl Iterator<Item = f64>) {
        let values: Vec<String> = values.map(number).collect();
        let mut lines: Vec<String> = values
            .chunks(VALUES_IN_A_LINE)
            .map(|v| v.join("  "))
            .collect();
        let last = lines.pop().unwrap_or_else(|| "0.0  0.0".into());
        for line in lines {
            self.comment(&line);
        }
        let Parameter { name, .. } = parameter;
        self.comment(&format!("{last}  : {name}: {}", parameter.comment()));
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

//! Formats of numbers and names in tables.

use comfy_table::{CellAlignment, Table, presets};
use towermodes::{Tower, printable};

use crate::terminal::WIDTH_OF_FILES;

/// A table without lines. Each of its lines begins with a space, by which [`super::fitted`]
/// distinguishes tables from sentences.
pub(super) fn plain_table() -> Table {
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    table
}

/// Sets columns flush right.
pub(super) fn align_right(table: &mut Table, columns: impl IntoIterator<Item = usize>) {
    for column in columns {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
}

/// A table without lines; the given columns are flush right.
pub(super) fn text_table<const N: usize>(
    header: [&str; N],
    rows: impl IntoIterator<Item = [String; N]>,
    right: impl IntoIterator<Item = usize>,
) -> String {
    let mut table = plain_table();
    table.set_header(header);
    table.add_rows(rows);
    align_right(&mut table, right);
    table.trim_fmt()
}

/// The tower's name and an empty line, if it has one.
pub(super) fn title(tower: &Tower) -> String {
    name_line(tower.name())
}

/// A name and an empty line, if there is one.
pub(super) fn name_line(name: &str) -> String {
    match name {
        "" => String::new(),
        name => printable(name) + "\n\n",
    }
}

/// Pads numbers on the right so that their decimal points are aligned.
pub(super) fn aligned(numbers: impl Iterator<Item = String>) -> Vec<String> {
    let numbers: Vec<String> = numbers.collect();
    let decimals = |number: &String| number.find('.').map_or(0, |point| number.len() - point);
    let widest = numbers.iter().map(decimals).max().unwrap_or(0);
    let padded = |number: String| {
        let padding = widest - decimals(&number);
        number + &" ".repeat(padding)
    };
    numbers.into_iter().map(padded).collect()
}

/// Units, which stay with their number.
const UNITS: [&str; 3] = ["Hz", "rpm", "%"];

/// What the lines of a sentence after the first begin with.
pub(super) const CONTINUATION: &str = "  ";

/// Characters between two columns, at least.
pub(super) const GAP: usize = 2;

/// A text in lines of at most [`WIDTH_OF_FILES`] characters: [`wrapped_to`].
pub(super) fn wrapped(text: &str) -> String {
    wrapped_to(text, WIDTH_OF_FILES)
}

/// A text in lines of at most so many characters, broken between words and not before a unit; lines
/// after the first are indented.
pub(super) fn wrapped_to(text: &str, width: usize) -> String {
    let mut lines = vec![String::new()];
    for word in words(text) {
        let Some(line) = lines.last_mut() else { break };
        if line.chars().count() + 1 + word.chars().count() > width {
            lines.push(format!("{CONTINUATION}{word}"));
        } else {
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(&word);
        }
    }
    lines.join("\n")
}

/// Whether [`wrapped`] has broken a sentence between two lines.
pub(super) fn continues(line: &str, next: &str) -> bool {
    let length = line.chars().count();
    let rest = next.strip_prefix(CONTINUATION);
    let word = rest.and_then(|rest| words(rest).into_iter().next());
    let is_full = |word: String| length + 1 + word.chars().count() > WIDTH_OF_FILES;
    length <= WIDTH_OF_FILES && word.is_some_and(is_full)
}

/// The words of a text, numbers with their units.
fn words(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match words.last_mut() {
            Some(last) if UNITS.iter().any(|unit| word.starts_with(unit)) => {
                last.push(' ');
                last.push_str(word);
            }
            _ => words.push(word.to_owned()),
        }
    }
    words
}

/// "RNA 350.000 t", "no RNA".
pub(super) fn rna(tower: &Tower) -> String {
    match tower.rna().mass_kg {
        0.0 => "no RNA".to_owned(),
        kg => format!("RNA {}", tonnes(kg)),
    }
}

/// A mass in tonnes.
pub(super) fn tonnes(kg: f64) -> String {
    if kg < 1e9 {
        format!("{:.3} t", kg / 1000.0)
    } else {
        format!("{:.6e} t", kg / 1000.0)
    }
}

#[cfg(test)]
mod tests {
    use super::{aligned, wrapped};

    #[test]
    fn long_sentences_are_broken_between_words() {
        assert_eq!(
            wrapped("No pair fails or warns."),
            "No pair fails or warns."
        );
        let number = wrapped(&format!("{} 0.2017 Hz", "b".repeat(91)));
        assert_eq!(number, format!("{}\n  0.2017 Hz", "b".repeat(91)));
        let text = "seven b ".repeat(20);
        let broken = wrapped(text.trim_end());
        // 12 times eight characters and a word of five are 101 with the space between.
        let lengths: Vec<usize> = broken.lines().map(|line| line.chars().count()).collect();
        assert_eq!(lengths, [95, 65], "{broken}");
        assert!(
            broken
                .lines()
                .nth(1)
                .is_some_and(|line| line.starts_with("  "))
        );
    }

    #[test]
    fn decimal_points_stand_in_one_column() {
        let numbers = ["0.25", "12.1234", "7"].map(String::from);
        assert_eq!(
            aligned(numbers.into_iter()),
            ["0.25  ", "12.1234", "7     "]
        );
    }
}

//! Numbers and names as people read them.

use comfy_table::{CellAlignment, Table, presets};
use towermodes::{Tower, printable};

use crate::terminal::WIDTH_OF_FILES;

/// A table without lines.
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

/// Pads numbers on the right so that their decimal points stand in one column.
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

/// Frequencies are shown with at least this many decimals, and at most with those a number holds.
const DECIMALS: std::ops::RangeInclusive<i32> = 4..=11;

/// A frequency or its error, with as many decimals as show two digits of the error.
pub(super) fn with_error(value_hz: f64, frequency_hz: f64, error_hz: f64) -> String {
    // Far from 1 Hz an exponent says more than a row of zeros.
    if frequency_hz > 0.0 && !(1e-4..1e6).contains(&frequency_hz) {
        return format!("{value_hz:.6e}");
    }
    // An error of 0 has as many as there can be.
    let decimals = 1_i32.saturating_sub(error_hz.log10().floor() as i32);
    let decimals = usize::try_from(decimals.clamp(*DECIMALS.start(), *DECIMALS.end()));
    let decimals = decimals.unwrap_or_default();
    let least = 0.1_f64.powi(i32::try_from(decimals).unwrap_or_default());
    if value_hz > 0.0 && value_hz < least {
        return format!("<{least:.decimals$}");
    }
    format!("{value_hz:.decimals$}")
}

/// Four significant digits.
pub(crate) fn four_digits(value: f64) -> String {
    if !(1e-4..1e9).contains(&value) {
        return format!("{value:.3e}");
    }
    let decimals = (3 - value.log10().floor() as i32).max(0);
    format!("{value:.*}", usize::try_from(decimals).unwrap_or_default())
}

/// Units, which stay with their number.
const UNITS: [&str; 3] = ["Hz", "rpm", "%"];

/// A text in lines of at most [`WIDTH_OF_FILES`] characters, broken between words and not before a
/// unit; lines after the first are indented.
pub(super) fn wrapped(text: &str) -> String {
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
    let mut lines = vec![String::new()];
    for word in &words {
        let Some(line) = lines.last_mut() else { break };
        if line.chars().count() + 1 + word.chars().count() > WIDTH_OF_FILES {
            lines.push(format!("  {word}"));
        } else {
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
    }
    lines.join("\n")
}

/// "1 mode", "2 modes".
pub(super) fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
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
    use super::{aligned, four_digits, with_error, wrapped};

    #[test]
    fn long_sentences_are_broken_between_words() {
        assert_eq!(wrapped("No warnings."), "No warnings.");
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

    #[test]
    fn frequencies_have_the_digits_that_their_error_leaves() {
        assert_eq!(with_error(0.321_456_789, 0.321_456_789, 3e-6), "0.3214568");
        assert_eq!(with_error(0.321_456_789, 0.321_456_789, 0.1), "0.3215");
        assert_eq!(with_error(0.25, 0.25, 0.0), "0.25000000000");
    }

    #[test]
    fn four_digits_whatever_the_size() {
        assert_eq!(four_digits(3.33105), "3.331");
        assert_eq!(four_digits(0.046_871), "0.04687");
        assert_eq!(four_digits(123_456.0), "123456");
        assert_eq!(four_digits(1e-7), "1.000e-7");
    }
}

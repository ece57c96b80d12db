//! Test cases as a table in text, with one case on each line.

use std::str::FromStr;

/// The rows of a table, one on each line: cells are separated by ` | `, and missing cells at the
/// end are empty. In a cell `\n`, `\r` and `\t` are escapes as in Rust, and `␣` is a blank at an
/// end. Lines that begin with `#` explain the rows below them. The cells live as long as the test
/// program.
pub fn rows<const N: usize>(table: &str) -> impl Iterator<Item = [&'static str; N]> {
    let lines = table.lines().map(str::trim);
    let lines = lines.filter(|line| !line.is_empty() && !line.starts_with("# "));
    lines.map(|line| {
        // A row may begin or end with an empty cell.
        let line = format!(" {line} ");
        let mut cells = line.split(" | ").map(str::trim);
        let row = std::array::from_fn(|_| plain(cells.next().unwrap_or_default()));
        assert_eq!(cells.next(), None, "more than {N} cells: {line}");
        row
    })
}

fn plain(cell: &str) -> &'static str {
    let mut text = String::new();
    let mut characters = cell.chars();
    while let Some(character) = characters.next() {
        match (character, characters.as_str().chars().next()) {
            ('␣', _) => text.push(' '),
            ('\\', Some(next @ ('n' | 'r' | 't' | '\\'))) => {
                characters.next();
                text.push(match next {
                    'n' => '\n',
                    'r' => '\r',
                    't' => '\t',
                    _ => '\\',
                });
            }
            _ => text.push(character),
        }
    }
    text.leak()
}

/// The words of a cell, separated by ` & `.
pub fn words(cell: &str) -> Vec<&str> {
    cell.split(" & ").collect()
}

/// The number of a cell.
pub fn number<T: FromStr>(cell: &str) -> T {
    let number = cell.parse().ok();
    number.unwrap_or_else(|| panic!("`{cell}` is not such a number"))
}

/// The numbers of a cell, separated by blanks.
pub fn numbers<const N: usize>(cell: &str) -> [f64; N] {
    let numbers: Vec<f64> = cell.split(' ').map(number).collect();
    let count = numbers.len();
    let numbers = numbers.try_into().ok();
    numbers.unwrap_or_else(|| panic!("{count} numbers instead of {N}: {cell}"))
}

/// The line and the column of a cell such as `3:11`.
pub fn line_and_column(cell: &str) -> (usize, usize) {
    let (line, column) = cell.split_once(':').expect("line:column");
    (number(line), number(column))
}

/// The words of a command line, separated by blanks.
pub fn arguments(line: &str) -> Vec<&str> {
    line.split(' ').collect()
}

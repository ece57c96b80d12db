//! Numbers, texts and rows as TOML.

use super::Writing;

/// Values in a line of a column of properties.
const VALUES_IN_A_LINE: usize = 5;

/// The fewest digits that are read back as the same number.
pub(super) fn number(value: f64) -> String {
    let size = value.abs();
    if value.is_nan() {
        "nan".into()
    } else if value.is_infinite() || size == 0.0 || (1e-3..1e7).contains(&size) {
        format!("{value:?}")
    } else {
        format!("{value:e}")
    }
}

/// A basic string: quotes, backslashes and all that is no visible character escaped.
pub(super) fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            '\n' => quoted.push_str("\\n"),
            '\t' => quoted.push_str("\\t"),
            c if !towermodes::is_printable(c) => {
                quoted.push_str(&format!("\\u{:04X}", u32::from(c)));
            }
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

/// Rows in brackets, one a line, their columns below each other.
pub(super) fn rows(cells: &[Vec<String>], writing: &mut Writing) {
    let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        let of_column = cells.iter().filter_map(|row| row.get(column));
        of_column.map(|cell| cell.chars().count()).max()
    };
    let widths: Vec<usize> = (0..columns).filter_map(width).collect();
    for row in cells {
        let aligned = row.iter().zip(&widths);
        let aligned: Vec<String> = aligned.map(|(cell, &w)| format!("{cell:>w$}")).collect();
        writing.line(format!("  [{}],", aligned.join(", ")));
    }
}

/// Rows of numbers.
pub(super) fn number_rows<const N: usize>(
    values: &[[f64; N]],
    columns: usize,
    writing: &mut Writing,
) {
    let row = |row: &[f64; N]| row.iter().take(columns).copied().map(number).collect();
    let cells: Vec<Vec<String>> = values.iter().map(row).collect();
    rows(&cells, writing);
}

/// A list of numbers over as many lines as it needs.
pub(super) fn list(key: &str, values: impl Iterator<Item = f64>, writing: &mut Writing) {
    let cells: Vec<String> = values.map(number).collect();
    let width = cells.iter().map(String::len).max().unwrap_or(0);
    writing.line(format!("{key} = ["));
    for line in cells.chunks(VALUES_IN_A_LINE) {
        let aligned: Vec<String> = line.iter().map(|cell| format!("{cell:>width$}")).collect();
        writing.line(format!("  {},", aligned.join(", ")));
    }
    writing.line("]");
}

#[cfg(test)]
mod tests {
    use super::{number, quoted};

    #[test]
    fn numbers_are_short_and_exact() {
        let written = [87.6, 350e3, 2.1e11, 0.0, -0.0, 5e-324, 1e-9, f64::INFINITY].map(number);
        let expected = [
            "87.6", "350000.0", "2.1e11", "0.0", "-0.0", "5e-324", "1e-9", "inf",
        ];
        assert_eq!(written, expected);
        assert_eq!(number(0.1 + 0.2), "0.30000000000000004");
        assert_eq!(
            (number(f64::NAN), number(f64::NEG_INFINITY)),
            ("nan".into(), "-inf".into())
        );
    }

    #[test]
    fn texts_are_escaped() {
        assert_eq!(
            quoted("a\"b\\c\nd\te\u{7f}\u{0}\r"),
            r#""a\"b\\c\nd\te\u007F\u0000\u000D""#
        );
        assert_eq!(quoted("Turm Süd, 87 m ✓"), "\"Turm Süd, 87 m ✓\"");
    }
}

//! What all tests of refusals expect.

use towermodes_files::tower_from_toml;

/// Expects the first mistake of a file at line:column with these words in its message and hint.
#[track_caller]
pub fn refused_text(text: &str, place: &str, message: &str, hint: &str) {
    let mistakes = tower_from_toml(text).expect_err("this is no tower");
    let first = &mistakes[0];
    let (line, column) = first.line_and_column(text);
    assert_eq!(format!("{line}:{column}"), place, "{first}");
    assert!(first.message().contains(message), "{}", first.message());
    let said = first.hint.clone().unwrap_or_default();
    assert!(said.contains(hint), "{said}");
}

/// The rows of a table of mistakes, one on each line: cells apart by ` | `, empty where they are
/// missing at the end. In a cell `\n` is the end of a line and `␣` a blank at an end; lines that
/// begin with `#` say why.
pub fn rows<const N: usize>(table: &str) -> impl Iterator<Item = [String; N]> {
    let lines = table.lines().map(str::trim);
    let lines = lines.filter(|line| !line.is_empty() && !line.starts_with("# "));
    lines.map(|line| {
        let mut cells = line.split(" | ").map(str::trim);
        let row = std::array::from_fn(|_| plain(cells.next().unwrap_or_default()));
        assert_eq!(
            cells.next(),
            None,
            "the row has more than {N} cells: {line}"
        );
        row
    })
}

fn plain(cell: &str) -> String {
    let unescaped = cell.replace("\\n", "\n").replace("\\\\", "\\");
    unescaped.replace('␣', " ")
}

/// The words of a cell, apart by ` & `.
pub fn words(cell: &str) -> Vec<&str> {
    cell.split(" & ").collect()
}

/// The line and the column of a cell such as `3:11`.
pub fn line_and_column(cell: &str) -> (usize, usize) {
    let (line, column) = cell.split_once(':').expect("line:column");
    let number = |text: &str| text.parse().expect("a number");
    (number(line), number(column))
}

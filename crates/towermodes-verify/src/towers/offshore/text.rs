//! Tables of numbers as text.

/// The cells of the rows of a table, separated by bars; empty lines are skipped.
pub(super) fn cells(table: &str) -> impl Iterator<Item = Vec<&str>> {
    let rows = table.lines().filter(|row| !row.trim().is_empty());
    rows.map(|row| row.split('|').map(str::trim).collect())
}

/// The numbers of a text, which must contain `N` numbers.
pub(super) fn numbers<const N: usize>(text: &str) -> [f64; N] {
    let numbers = text.split_whitespace().map(str::parse);
    let numbers = numbers.collect::<Result<Vec<f64>, _>>();
    let numbers = numbers.expect("numbers of the manual");
    numbers.try_into().expect("as many numbers as a row has")
}

//! What all tests of refusals expect.

use towermodes_files::tower_from_toml;
use towermodes_testing::Says;

/// Expects the first mistake of a file at line:column with these words in its message and hint.
#[track_caller]
pub fn refused_text(text: &str, place: &str, message: &str, hint: &str) {
    let mistakes = tower_from_toml(text).expect_err("this is no tower");
    let first = &mistakes[0];
    let (line, column) = first.line_and_column(text);
    assert_eq!(format!("{line}:{column}"), place, "{first}");
    first.message().says(message);
    first.hint.clone().unwrap_or_default().says(hint);
}

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

//! The verification manual as text.

use towermodes_verify::{Row, summary};

use super::text::{align_right, plain_table};

/// All rows, chapter by chapter and case by case, and the number of values within their tolerance.
pub(crate) fn verification(rows: &[Row]) -> String {
    let mut text = String::new();
    for chapter in rows.chunk_by(|a, b| a.chapter == b.chapter) {
        text.push_str(&format!(
            "{}\n\n{}\n\n",
            chapter[0].chapter.title,
            of_chapter(chapter)
        ));
    }
    text.push_str(&format!("{}\n", summary(rows)));
    text
}

/// One table, so that all columns of a chapter are aligned, with the name and the source of each
/// case above its rows and the misprints of the sources below it.
fn of_chapter(rows: &[Row]) -> String {
    let mut table = plain_table();
    table.set_header([
        "method",
        "mode",
        "expected",
        "computed",
        "difference",
        "tolerance",
        "",
    ]);
    table.add_rows(rows.iter().map(Row::cells));
    align_right(&mut table, 2..=5);
    let mut lines = table.lines();
    let mut text = lines.next().unwrap_or_default().trim_end().to_owned();
    for case in rows.chunk_by(Row::is_of_the_case_of) {
        text.push_str(&format!("\n {} ({})", case[0].case, case[0].source));
        for line in lines.by_ref().take(case.len()) {
            text.push_str(&format!("\n{}", line.trim_end()));
        }
    }
    for sentence in rows.iter().filter_map(Row::misprint) {
        text.push_str(&format!("\n\n{sentence}"));
    }
    text
}

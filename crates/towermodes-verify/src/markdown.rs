//! The manual as a chapter of the book.

use std::fmt::Write;

use crate::row::{Row, summary};

/// All rows, chapter by chapter and case by case, as Markdown.
pub fn markdown(rows: &[Row]) -> String {
    let mut text = String::from(
        "# Verification\n\n\
         Every line contains a reference value (published, analytical or computed independently) and the result of the program.\n\
         This chapter is the output of `towermodes verify --format markdown`; a test compares both. The tolerance is the rounding of\n\
         the last digit of the reference value plus an allowance for the method or the reference, which the case describes.\n\n",
    );
    let _ = writeln!(text, "{}.", summary(rows));
    for chapter in rows.chunk_by(|a, b| a.chapter == b.chapter) {
        let _ = write!(
            text,
            "\n## {}\n\n{}\n",
            chapter[0].chapter.title, chapter[0].chapter.introduction
        );
        for case in chapter.chunk_by(Row::is_of_the_case_of) {
            let _ = write!(text, "\n**{}** ({})\n\n", case[0].case, case[0].source);
            if !case[0].remark.is_empty() {
                let _ = write!(text, "{}\n\n", case[0].remark);
            }
            text.push_str("| method | mode | expected | computed | difference | tolerance | |\n|---|---|---|---|---|---|---|\n");
            for row in case {
                let _ = writeln!(text, "| {} |", cells(row).join(" | "));
            }
            for sentence in case.iter().filter_map(Row::misprint) {
                let _ = write!(text, "\n{sentence}.\n");
            }
        }
    }
    text
}

/// The cells of a row with the unit of its values.
fn cells(row: &Row) -> [String; 7] {
    let mut cells = row.cells();
    if row.unit != "1" {
        cells[2].push_str(&format!(" {}", row.unit));
    }
    cells
}

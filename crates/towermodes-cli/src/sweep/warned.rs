//! Rows of a sweep whose input is probably a mistake.

use towermodes_report::wording::counted;
use towermodes_sweep::InputWarnings;

use crate::failure::note_texts;

/// Says how many of the rows have unusual values, and the first sentences on them.
pub(super) fn report(warnings: &InputWarnings, rows: u64) {
    if warnings.rows == 0 {
        return;
    }
    let verb = if warnings.rows == 1 { "has" } else { "have" };
    let (count, rows) = (warnings.rows, counted(rows, "row"));
    let all = format!("{count} of {rows} {verb} unusual input that the base does not have");
    let sentence =
        |(row, sentence): &(u64, String)| format!("row {row}, counted from 0: {sentence}");
    let sentences = warnings.first.iter().map(sentence);
    note_texts(&Vec::from_iter(std::iter::once(all).chain(sentences)));
}

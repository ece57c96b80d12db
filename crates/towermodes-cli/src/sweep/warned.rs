//! Rows of a sweep whose input is probably a mistake, or in which modes share a motion.

use towermodes_report::wording::counted;
use towermodes_sweep::RowRemarks;

use crate::failure::note_texts;

/// Says how many of the rows have unusual values or share modes, and the first sentences on them.
pub(super) fn report([warnings, shared]: [&RowRemarks; 2], rows: u64) {
    let verb = if warnings.rows == 1 { "has" } else { "have" };
    say(
        warnings,
        rows,
        &format!("{verb} unusual input that the base does not have"),
    );
    let of = "where less than 60 % of a mode is the motion of its name: between such rows modes may \
              exchange their names (columns …_share)";
    say(shared, rows, of);
}

fn say(remarked: &RowRemarks, rows: u64, what: &str) {
    if remarked.rows == 0 {
        return;
    }
    let (count, rows) = (remarked.rows, counted(rows, "row"));
    let all = format!("{count} of {rows} {what}");
    let sentence =
        |(row, sentence): &(u64, String)| format!("row {row}, counted from 0: {sentence}");
    let sentences = remarked.first.iter().map(sentence);
    note_texts(&Vec::from_iter(std::iter::once(all).chain(sentences)));
}

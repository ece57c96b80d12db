//! Rows of a sweep whose input is probably a mistake, or in which modes share a motion.

use towermodes_report::wording::counted;
use towermodes_sweep::RowRemarks;

use crate::failure::note_texts;

/// Says how many of the rows have unusual values or share modes, and the first sentences on them.
pub(super) fn report([warnings, shared]: [&RowRemarks; 2], rows: u64) {
    let has = |of: &RowRemarks| if of.rows == 1 { "has" } else { "have" };
    let unusual = "unusual input that the base does not have";
    say(warnings, rows, &format!("{} {unusual}", has(warnings)));
    let coupled = "a mode that shares its motion with others: less than 60 % of its energy is in the \
                   motion of its name (columns …_share). Between neighbouring rows such a name may pass \
                   from one of these modes to another, and its frequency jumps by their difference";
    say(shared, rows, &format!("{} {coupled}", has(shared)));
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

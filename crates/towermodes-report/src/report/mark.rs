//! The display of verdicts and texts on a page.

use towermodes_analysis::Verdict;

use crate::wording;

/// A verdict as a class of the style sheet and as a word for the reader.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Mark {
    /// `pass`, `warn`, `fail`.
    pub name: &'static str,
    /// `PASS`, `WARN`, `FAIL`.
    pub word: &'static str,
}

impl Mark {
    /// The mark of a verdict.
    pub(super) fn of(verdict: Verdict) -> Self {
        Self {
            name: verdict.name(),
            word: wording::verdict_word(verdict),
        }
    }
}

/// A text in which a space replaces each character that is invisible or could forge the content of
/// a page.
pub(super) fn printable(text: &str) -> String {
    wording::printable(text, ' ').into_owned()
}

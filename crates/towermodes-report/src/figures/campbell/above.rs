//! The modes outside the field of a Campbell diagram, as text.

use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::Campbell;

use super::lines::Shown;
use crate::wording::{counted, verdict_word};

/// "3 modes above the frequency range, 1 FAIL"; none if there are no such modes.
pub(super) fn above_text(campbell: &Campbell, shown: &Shown) -> Option<String> {
    if shown.above.is_empty() {
        return None;
    }
    let modes = counted(shown.above.len(), "mode");
    let of_verdict = |verdict: Verdict| {
        let own = campbell.margins.iter();
        let own =
            own.filter(|margin| margin.verdict == verdict && shown.above.contains(&margin.line));
        let count = own.count();
        (count > 0).then(|| format!(", {count} {}", verdict_word(verdict)))
    };
    let verdicts = [Verdict::Fail, Verdict::Warn].into_iter();
    let verdicts: String = verdicts.filter_map(of_verdict).collect();
    Some(format!("{modes} above the frequency range{verdicts}"))
}

/// "2 modes at 0 Hz"; none if there are no such modes.
pub(super) fn unresisted_text(shown: &Shown) -> Option<String> {
    (shown.unresisted > 0).then(|| counted(shown.unresisted, "mode") + " at 0 Hz")
}

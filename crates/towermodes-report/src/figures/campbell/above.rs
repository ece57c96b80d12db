//! What is said of modes that are not in the field of a Campbell diagram.

use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::Campbell;

use super::lines::Shown;

/// "3 more modes above, 1 pair of them FAIL"; none if there are none.
pub(super) fn above_text(campbell: &Campbell, shown: &Shown) -> Option<String> {
    let modes = counted(shown.above.len(), "more mode")?;
    let of_verdict = |verdict: Verdict| {
        let own = campbell.margins.iter();
        let own =
            own.filter(|margin| margin.verdict == verdict && shown.above.contains(&margin.line));
        let count = own.count();
        (count > 0).then(|| format!(", {count} {}", verdict.name().to_uppercase()))
    };
    let verdicts = [Verdict::Fail, Verdict::Warn].into_iter();
    let verdicts: String = verdicts.filter_map(of_verdict).collect();
    Some(format!("{modes} above{verdicts}"))
}

/// "2 modes at 0 Hz"; none if there are none.
pub(super) fn unresisted_text(shown: &Shown) -> Option<String> {
    Some(counted(shown.unresisted, "mode")? + " at 0 Hz")
}

/// "1 mode", "2 modes"; none of none.
fn counted(count: usize, noun: &str) -> Option<String> {
    match count {
        0 => None,
        1 => Some(format!("1 {noun}")),
        count => Some(format!("{count} {noun}s")),
    }
}

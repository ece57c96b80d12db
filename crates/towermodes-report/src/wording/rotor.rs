//! The rotor and the verdicts on its excitations in words.

use towermodes::Rotor;
use towermodes::tower::Rpm;
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::Campbell;

use super::text::counted;

/// The operating speeds without their unit: "6.9 to 12.1", or "12.1" for a constant speed.
pub fn speed_range(rotor: &Rotor) -> String {
    let (lowest, highest) = (Rpm(rotor.lowest_rpm), Rpm(rotor.highest_rpm));
    if rotor.lowest_rpm == rotor.highest_rpm {
        lowest.to_string()
    } else {
        format!("{lowest} to {highest}")
    }
}

/// The rotor in operation: "3 blades at 6.9 to 12.1 rpm".
pub fn operation(rotor: &Rotor) -> String {
    let blades = counted(rotor.blades, "blade");
    format!("{blades} at {} rpm", speed_range(rotor))
}

/// The verdict in upper case: `PASS`, `WARN`, `FAIL`.
pub fn verdict_word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "PASS",
        Verdict::Warn => "WARN",
        Verdict::Fail => "FAIL",
    }
}

/// How many pairs of a mode and an excitation pass, warn and fail, in this order.
pub fn verdict_counts(campbell: &Campbell) -> [usize; 3] {
    let count = |verdict| {
        let margins = campbell.margins.iter();
        margins.filter(|margin| margin.verdict == verdict).count()
    };
    [Verdict::Pass, Verdict::Warn, Verdict::Fail].map(count)
}

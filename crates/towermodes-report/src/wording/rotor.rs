//! The rotor and the verdicts on its excitations as text.

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

/// The rotor of a diagram: in operation, or "3 blades, operating speeds unknown".
pub fn operation_of(campbell: &Campbell) -> String {
    match campbell.speeds_are_known() {
        true => operation(&campbell.rotor),
        false => format!(
            "{}, operating speeds unknown",
            counted(campbell.rotor.blades, "blade")
        ),
    }
}

/// The sentences of a conclusion as one text, with minus signs as in the tables beside it.
pub fn conclusion_text(sentences: &[String]) -> String {
    sentences.join(" ").replace("(-", "(\u{2212}")
}

/// The verdict in upper case: `PASS`, `WARN`, `FAIL`; `-` where there is none.
pub fn verdict_word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "PASS",
        Verdict::Warn => "WARN",
        Verdict::Fail => "FAIL",
        Verdict::Undecided => "-",
    }
}

/// The numbers of pairs of a mode and an excitation that pass, warn and fail, in this order.
pub fn verdict_counts(campbell: &Campbell) -> [usize; 3] {
    let count = |verdict| {
        let margins = campbell.margins.iter();
        margins.filter(|margin| margin.verdict == verdict).count()
    };
    [Verdict::Pass, Verdict::Warn, Verdict::Fail].map(count)
}

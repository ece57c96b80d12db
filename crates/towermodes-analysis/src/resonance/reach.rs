//! How high a rotor's excitations reach, and how high the modes of a tower are known.

use super::campbell::{Campbell, CampbellOptions};
use super::diagram::multiples;
use super::margin::is_strong;
use crate::verdict::Verdict;
use towermodes::Solution;
use towermodes::tower::Rotor;

impl Campbell {
    /// The frequencies, Hz, from the lowest, at which the tower may have modes that are not in the
    /// list and that an excitation would come near to; none if every such mode is in it.
    #[must_use]
    pub fn unjudged_hz(&self) -> Option<[f64; 2]> {
        let known_hz = self.known_to_hz?;
        let options = CampbellOptions {
            margin: self.margin,
            multiples: self.multiples.clone(),
            ..CampbellOptions::default()
        };
        let reach_hz = reach_hz(&self.rotor, &options);
        (known_hz < reach_hz).then_some([known_hz, reach_hz])
    }

    /// The worst of all margins; at best [`Verdict::Warn`] where modes are
    /// [not judged](Self::unjudged_hz).
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let worst = self.margins.iter().map(|margin| margin.verdict).max();
        let worst = worst.unwrap_or(Verdict::Pass);
        match self.unjudged_hz() {
            Some(_) => worst.max(Verdict::Warn),
            None => worst,
        }
    }
}

/// The frequency, Hz, above which no mode of a tower is near an excitation: n Ω/f − 1 is −m, or −2
/// m where that is warned of, at f = n Ω/(1 − m) or n Ω/(1 − 2 m) with the highest speed Ω.
#[must_use]
pub fn reach_hz(rotor: &Rotor, options: &CampbellOptions) -> f64 {
    let reach = |multiple: usize| {
        let warned = match is_strong(multiple, rotor) && options.margin < 0.5 {
            true => 2.0 * options.margin,
            // Within 50 % nothing is above all of it.
            false => options.margin,
        };
        multiple as f64 * rotor.highest_rpm / 60.0 / (1.0 - warned)
    };
    let reaches = multiples(rotor, options).into_iter().map(reach);
    reaches.fold(0.0, f64::max)
}

/// The frequency, Hz, below which every mode is listed; none if all that there are are.
pub(super) fn known_to_hz(solution: &Solution) -> Option<f64> {
    let listed = solution.modes.len();
    if listed >= solution.degrees_of_freedom {
        return None;
    }
    let certificate = &solution.certificate;
    match solution.modes.last() {
        // Proved modes that are not listed lie beside the last one.
        Some(last) if certificate.count > listed => Some(last.frequency_hz),
        _ => Some(certificate.below_hz),
    }
}

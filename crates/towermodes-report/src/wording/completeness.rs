//! The certificate in words: an eigenvalue count proves that no mode is missing.

use towermodes::number::{digits, end_of_range, with_error};
use towermodes::{BladeSolution, Certificate, Solution};

use super::text::counted;

/// A certificate and the list of modes that it belongs to.
#[derive(Clone, Copy)]
struct Proved {
    certificate: Certificate,
    listed: usize,
    /// The last listed frequency as it is shown, unless its error is larger than the gap above it.
    last_hz: f64,
}

impl Proved {
    /// For a list of so many modes, the last of which has this frequency and error, Hz.
    fn new(certificate: &Certificate, listed: usize, last_hz: f64, error_hz: f64) -> Self {
        let shown = with_error(last_hz, last_hz, error_hz).parse();
        let is_below = |shown_hz: &f64| (last_hz..certificate.below_hz).contains(shown_hz);
        Self {
            certificate: *certificate,
            listed,
            last_hz: shown.ok().filter(is_below).unwrap_or(last_hz),
        }
    }

    fn of(solution: &Solution) -> Self {
        let last = solution.modes.last();
        let [last_hz, error_hz] = last.map_or([0.0; 2], |m| [m.frequency_hz, m.error_hz()]);
        let listed = solution.modes.len();
        Self::new(&solution.certificate, listed, last_hz, error_hz)
    }

    fn below_hz(&self, digits: usize) -> String {
        end_of_range(self.certificate.below_hz, self.last_hz, digits)
    }

    fn in_one_line(&self) -> String {
        let except = match self.certificate.count > self.listed {
            true => " except for the other mode of the last pair",
            false => "",
        };
        let below_hz = self.below_hz(4);
        match self.certificate.uncertain_hz {
            Some(ends_hz) => format!("complete{except} below {below_hz} Hz {}", outside(ends_hz)),
            None => format!(
                "complete{except}: exactly {} below {below_hz} Hz",
                counted(self.certificate.count, "mode"),
            ),
        }
    }

    fn explained(&self) -> String {
        let below_hz = self.below_hz(6);
        match self.certificate.uncertain_hz {
            Some(ends_hz) => format!(
                "The numbers of negative pivots of K − ω²M (Sylvester's law of inertia) prove, in floating-point arithmetic, that no mode of the computed model below {below_hz} Hz is missing {}. \
                 There the added mass decreases so fast with frequency that a mode may appear again, which is not listed.",
                outside(ends_hz)
            ),
            None => format!(
                "The number of negative pivots of K − ω²M (Sylvester's law of inertia) proves, in floating-point arithmetic, that the computed model has exactly {} below {below_hz} Hz; \
                 {}. No mode of the model in this range is missing.",
                self.frequencies(),
                self.all(),
            ),
        }
    }

    fn frequencies(&self) -> String {
        match self.certificate.count {
            1 => "1 natural frequency".to_owned(),
            count => format!("{count} natural frequencies"),
        }
    }

    fn all(&self) -> String {
        match (self.certificate.count > self.listed, self.listed) {
            (false, _) => "all of them are listed".to_owned(),
            (true, 1) => "1 of them is listed; the other has the same frequency".to_owned(),
            (true, listed) => {
                format!(
                    "{listed} of them are listed; the others have the frequency of the last one"
                )
            }
        }
    }
}

/// The certificate in one line: "complete: exactly 8 modes below 8.323 Hz".
///
/// A list may end between two modes of equal frequency; then the line states it.
pub fn completeness(solution: &Solution) -> String {
    Proved::of(solution).in_one_line()
}

/// The certificate of the modes of a blade in one line.
pub fn completeness_of_blade(solution: &BladeSolution) -> String {
    let last = solution.modes.last();
    let error_hz = last.map_or(0.0, |m| m.algebraic_error_hz + m.discretization_error_hz);
    let last_hz = last.map_or(0.0, |mode| mode.frequency_hz);
    let listed = solution.modes.len();
    Proved::new(&solution.certificate, listed, last_hz, error_hz).in_one_line()
}

/// The frequency below which the list is complete, Hz.
pub fn complete_below_hz(solution: &Solution) -> String {
    Proved::of(solution).below_hz(4)
}

/// "outside 0.1639 to 0.1767 Hz", the interval that added mass by frequency leaves uncertain, with
/// as many digits as its ends need.
fn outside([from_hz, to_hz]: [f64; 2]) -> String {
    let shown = |count| [from_hz, to_hz].map(|end_hz| digits(end_hz, count));
    let mut ends = (4..16).map(shown);
    let [from, to] = ends.find(|[from, to]| from != to).unwrap_or(shown(16));
    format!("outside {from} to {to} Hz")
}

/// The certificate as a report explains it: the theorem, the count, and the conclusion.
pub fn proof_of_completeness(solution: &Solution) -> String {
    Proved::of(solution).explained()
}

#[cfg(test)]
mod tests {
    use towermodes::Certificate;

    use super::Proved;

    const NINE: Certificate = Certificate {
        complete: true,
        count: 9,
        below_hz: 8.3234,
        uncertain_hz: None,
    };

    #[test]
    fn a_list_that_ends_within_a_pair_is_named() {
        let line = |certificate: &Certificate, listed| {
            Proved::new(certificate, listed, 8.2, 0.0).in_one_line()
        };
        assert_eq!(line(&NINE, 9), "complete: exactly 9 modes below 8.323 Hz");
        let uncertain = Certificate {
            uncertain_hz: Some([0.16391, 0.17672]),
            ..NINE
        };
        let outside = "complete below 8.323 Hz outside 0.1639 to 0.1767 Hz";
        assert_eq!(line(&uncertain, 9), outside);
        let cut =
            "complete except for the other mode of the last pair: exactly 9 modes below 8.323 Hz";
        assert_eq!(line(&NINE, 8), cut);
        let proof = Proved::new(&NINE, 8, 8.2, 0.0).explained();
        assert!(proof.contains("exactly 9 natural frequencies below 8.32340 Hz; 8 of them are"));
    }

    /// Rounded to four digits the end would be below the last mode, so that one mode fewer is
    /// below it.
    #[test]
    fn the_end_is_above_the_last_mode_as_shown() {
        let ends = [(8.323_28, 1e-6, "8.3233"), (8.323_34, 1e-6, "8.32339")];
        for (last_hz, error_hz, below) in ends {
            let certificate = Certificate {
                below_hz: 8.323_395,
                ..NINE
            };
            let line = Proved::new(&certificate, 9, last_hz, error_hz).in_one_line();
            assert_eq!(line, format!("complete: exactly 9 modes below {below} Hz"));
        }
        // An error larger than the gap leaves four decimals, 8.3234, which are beyond the limit.
        let coarse = Proved::new(&NINE, 9, 8.323_36, 0.1).in_one_line();
        assert_eq!(coarse, "complete: exactly 9 modes below 8.3234 Hz");
    }
}

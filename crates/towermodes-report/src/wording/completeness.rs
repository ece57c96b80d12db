//! The certificate as text: an eigenvalue count proves that no mode is missing.

use towermodes::Certificate;
use towermodes::number::{digits, four_digits};

use super::text::counted;

/// The certificate in one line, for a list of `listed` modes: "complete: exactly 8 modes below
/// 8.323 Hz".
///
/// A list may end between two modes of equal frequency; then the text states this.
pub fn completeness(certificate: &Certificate, listed: usize) -> String {
    let except = match certificate.count > listed {
        true => " except for the other mode of the last pair",
        false => "",
    };
    let below_hz = four_digits(certificate.below_hz);
    match certificate.uncertain_hz {
        Some(ends_hz) => format!("complete{except} below {below_hz} Hz {}", outside(ends_hz)),
        None => format!(
            "complete{except}: exactly {} below {below_hz} Hz",
            counted(certificate.count, "mode"),
        ),
    }
}

/// "outside 0.1639 to 0.1767 Hz", the interval that remains uncertain because of
/// frequency-dependent added mass, with as many digits as its ends need.
fn outside([from_hz, to_hz]: [f64; 2]) -> String {
    let shown = |count| [from_hz, to_hz].map(|end_hz| digits(end_hz, count));
    let mut ends = (4..16).map(shown);
    let [from, to] = ends.find(|[from, to]| from != to).unwrap_or(shown(16));
    format!("outside {from} to {to} Hz")
}

/// The certificate with the explanation for a report: the theorem, the count, and the conclusion.
pub fn proof_of_completeness(certificate: &Certificate, listed: usize) -> String {
    let count = match certificate.count {
        1 => "1 natural frequency".to_owned(),
        count => format!("{count} natural frequencies"),
    };
    let all = match (certificate.count > listed, listed) {
        (false, _) => "all of them are listed".to_owned(),
        (true, 1) => "1 of them is listed; the other has the same frequency".to_owned(),
        (true, _) => {
            format!("{listed} of them are listed; the others have the frequency of the last one")
        }
    };
    let below_hz = digits(certificate.below_hz, 6);
    match certificate.uncertain_hz {
        Some(ends_hz) => format!(
            "The numbers of negative pivots of K − ω²M (Sylvester's law of inertia) prove that no mode below {below_hz} Hz is missing {}. \
             There the added mass decreases so fast with frequency that a mode may appear again, which is not listed.",
            outside(ends_hz)
        ),
        None => format!(
            "The number of negative pivots of K − ω²M (Sylvester's law of inertia) proves that the computed model has exactly {count} below {below_hz} Hz; \
             {all}. No mode in this range is missing."
        ),
    }
}

#[cfg(test)]
mod tests {
    use towermodes::Certificate;

    use super::{completeness, proof_of_completeness};

    #[test]
    fn a_list_that_ends_within_a_pair_is_named() {
        let certificate = Certificate {
            complete: true,
            count: 9,
            below_hz: 8.3234,
            uncertain_hz: None,
        };
        let all = "complete: exactly 9 modes below 8.323 Hz";
        assert_eq!(completeness(&certificate, 9), all);
        let uncertain = Certificate {
            uncertain_hz: Some([0.16391, 0.17672]),
            ..certificate
        };
        let outside = "complete below 8.323 Hz outside 0.1639 to 0.1767 Hz";
        assert_eq!(completeness(&uncertain, 9), outside);
        let cut =
            "complete except for the other mode of the last pair: exactly 9 modes below 8.323 Hz";
        assert_eq!(completeness(&certificate, 8), cut);
        let proof = proof_of_completeness(&certificate, 8);
        assert!(proof.contains("exactly 9 natural frequencies below 8.32340 Hz; 8 of them are"));
    }
}

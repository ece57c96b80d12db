//! The certificate in words: an eigenvalue count proves that no mode is missing.

use towermodes::Certificate;
use towermodes::number::{digits, four_digits};

use super::text::counted;

/// The certificate in one line, for a list of `listed` modes: "complete: exactly 8 modes below
/// 8.323 Hz".
///
/// A list may end between two modes of equal frequency; then the line states it.
pub fn completeness(certificate: &Certificate, listed: usize) -> String {
    let except = match certificate.count > listed {
        true => " except for the other mode of the last pair",
        false => "",
    };
    let outside = outside(certificate);
    format!(
        "complete{outside}{except}: exactly {} below {} Hz",
        counted(certificate.count, "mode"),
        four_digits(certificate.below_hz)
    )
}

/// " outside 0.1639 to 0.1767 Hz" where added mass by frequency leaves an interval uncertain.
fn outside(certificate: &Certificate) -> String {
    certificate.uncertain_hz.map_or_else(String::new, |ends| {
        let [from, to] = ends.map(four_digits);
        format!(" outside {from} to {to} Hz")
    })
}

/// The certificate as a report explains it: the theorem, the count, and the conclusion.
pub fn proof_of_completeness(certificate: &Certificate, listed: usize) -> String {
    let count = match certificate.count {
        1 => "1 natural frequency".to_owned(),
        count => format!("{count} natural frequencies"),
    };
    let all = match (certificate.count > listed, listed) {
        (false, _) => "all of them are listed".to_owned(),
        (true, 1) => "1 of them is listed; the others have the same frequency".to_owned(),
        (true, _) => {
            format!("{listed} of them are listed; the others have the frequency of the last one")
        }
    };
    format!(
        "The number of negative pivots of K − ω²M (Sylvester's law of inertia) proves that the computed model has exactly {count} below {} Hz; \
         {all}. No mode in this range{} is missing.",
        digits(certificate.below_hz, 6),
        outside(certificate)
    )
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
        let outside = "complete outside 0.1639 to 0.1767 Hz: exactly 9 modes below 8.323 Hz";
        assert_eq!(completeness(&uncertain, 9), outside);
        let cut =
            "complete except for the other mode of the last pair: exactly 9 modes below 8.323 Hz";
        assert_eq!(completeness(&certificate, 8), cut);
        let proof = proof_of_completeness(&certificate, 8);
        assert!(proof.contains("exactly 9 natural frequencies below 8.32340 Hz; 8 of them are"));
    }
}

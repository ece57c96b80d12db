//! Failures counted by their message, with numbers ignored.

/// Largest number of kinds that are counted separately.
const MOST_KINDS: usize = 100;

/// Rows whose messages differ only in their numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FailureKind {
    /// The message of the first of these rows.
    pub sentence: String,
    /// The number of this row, from 0.
    pub row: u64,
    /// Number of rows.
    pub count: u64,
}

/// The kinds of failures, in the order of their first rows.
#[derive(Debug, Clone, Default)]
pub(super) struct Failures {
    kinds: Vec<(String, FailureKind)>,
    pub(super) count: u64,
    others: u64,
}

impl Failures {
    pub(super) fn add(&mut self, row: u64, sentence: &str) {
        self.count += 1;
        let pattern = without_numbers(sentence);
        let known = self.kinds.iter().position(|(other, _)| *other == pattern);
        match known {
            Some(place) => self.kinds[place].1.count += 1,
            None if self.kinds.len() == MOST_KINDS => self.others += 1,
            None => {
                let kind = FailureKind {
                    sentence: sentence.to_owned(),
                    row,
                    count: 1,
                };
                self.kinds.push((pattern, kind));
            }
        }
    }

    /// The kinds, the most frequent first, and the number of rows of further kinds.
    pub(super) fn kinds(self) -> (Vec<FailureKind>, u64) {
        let mut kinds: Vec<FailureKind> = self.kinds.into_iter().map(|(_, kind)| kind).collect();
        kinds.sort_by_key(|kind| (std::cmp::Reverse(kind.count), kind.row));
        (kinds, self.others)
    }
}

/// A message with a placeholder for each number. An index in brackets is kept.
fn without_numbers(sentence: &str) -> String {
    let words = sentence.split_inclusive(' ').map(|word| {
        let plain = word.trim_matches([' ', ',', ';', ':', '(', ')', '.']);
        match plain.parse::<f64>().is_ok() {
            true => word.replacen(plain, "#", 1),
            false => word.to_owned(),
        }
    });
    words.collect()
}

#[cfg(test)]
mod tests {
    use super::Failures;

    #[test]
    fn failures_that_differ_in_numbers_are_of_one_kind() {
        let mut failures = Failures::default();
        for (row, sentence) in [
            (
                3,
                "stations[1].wall: wall thickness is -0.1 m; it must be positive",
            ),
            (4, "the tower buckles: the factor is 0.5, just below 1"),
            (
                7,
                "stations[1].wall: wall thickness is -1e-3 m; it must be positive",
            ),
            (9, "rna.mass is NaN; it must be finite"),
            (11, "rna.mass is inf; it must be finite"),
        ] {
            failures.add(row, sentence);
        }
        assert_eq!(failures.count, 5);
        let (kinds, others) = failures.kinds();
        let found: Vec<(u64, u64)> = kinds.iter().map(|kind| (kind.row, kind.count)).collect();
        assert_eq!((found, others), (vec![(3, 2), (9, 2), (4, 1)], 0));
        assert!(kinds[0].sentence.contains("-0.1 m"));
    }

    #[test]
    fn many_kinds_do_not_fill_the_memory() {
        let mut failures = Failures::default();
        for row in 0..1000 {
            failures.add(row, &format!("word{row}"));
        }
        let (kinds, others) = failures.kinds();
        assert_eq!((kinds.len(), others), (100, 900));
    }
}

//! Order statistics of any number of values in bounded memory, exact.
//!
//! A value is read as a whole number of 64 bits that has the same order. Each pass over the values
//! counts the next digits of the wanted ranks (radix selection), so five passes find any rank. The
//! counts need 64 KiB for each different beginning of the ranks: with the 14 ranks of seven
//! quantiles up to 0.9 MB for a column, and usually a tenth of it, as the first digits are equal.

/// Bits of a digit.
const BITS: u32 = 13;
/// Digits of a number: 5 × 13 bits and more than 64.
pub(super) const PASSES: u32 = u64::BITS.div_ceil(BITS);

/// Finds the values of given ranks.
#[derive(Debug, Clone)]
pub(super) struct Selection {
    ranks: Vec<Rank>,
    /// The counts of the next digit for each prefix that a rank has.
    counts: Vec<(u64, Vec<u64>)>,
    /// Digits that are known.
    known: u32,
}

/// A rank of which the first digits are known.
#[derive(Debug, Clone, Copy)]
struct Rank {
    /// The digits that are known.
    prefix: u64,
    /// The rank, from 0, among the values with this prefix.
    rank: u64,
}

impl Selection {
    /// Finds the values of ranks, from 0, in the order of size.
    pub(super) fn new(ranks: &[u64]) -> Self {
        let ranks = ranks.iter().map(|rank| Rank {
            prefix: 0,
            rank: *rank,
        });
        let mut selection = Self {
            ranks: ranks.collect(),
            counts: Vec::new(),
            known: 0,
        };
        selection.prepare();
        selection
    }

    /// Counts a value of this pass.
    pub(super) fn count(&mut self, value: f64) {
        let number = ordered(value);
        let prefix = digits(number, self.known);
        if let Ok(place) = self
            .counts
            .binary_search_by_key(&prefix, |(prefix, _)| *prefix)
        {
            let digit = digits(number, self.known + 1) & ((1 << BITS) - 1);
            self.counts[place].1[digit as usize] += 1;
        }
    }

    /// Ends a pass: the next digit of each rank is known.
    pub(super) fn end_pass(&mut self) {
        for rank in &mut self.ranks {
            let found = self
                .counts
                .binary_search_by_key(&rank.prefix, |(prefix, _)| *prefix);
            let counts = found.map_or(&[][..], |place| &self.counts[place].1);
            let mut digit = 0;
            for count in counts {
                if rank.rank < *count {
                    break;
                }
                rank.rank -= count;
                digit += 1;
            }
            rank.prefix = (rank.prefix << BITS) | digit;
        }
        self.known += 1;
        self.prepare();
    }

    /// The values of the ranks, after all passes.
    pub(super) fn values(&self) -> Vec<f64> {
        self.ranks.iter().map(|rank| value(rank.prefix)).collect()
    }

    fn prepare(&mut self) {
        let mut prefixes: Vec<u64> = self.ranks.iter().map(|rank| rank.prefix).collect();
        prefixes.sort_unstable();
        prefixes.dedup();
        let counts = prefixes
            .into_iter()
            .map(|prefix| (prefix, vec![0; 1 << BITS]));
        self.counts = if self.known < PASSES {
            counts.collect()
        } else {
            Vec::new()
        };
    }
}

/// The first digits of a number. 65 bits are five digits: the first has a zero in front.
fn digits(number: u64, count: u32) -> u64 {
    number.checked_shr(BITS * (PASSES - count)).unwrap_or(0)
}

/// A whole number in the order of the values.
fn ordered(value: f64) -> u64 {
    let bits = value.to_bits();
    match bits >> 63 {
        0 => bits | 1 << 63,
        _ => !bits,
    }
}

fn value(number: u64) -> f64 {
    f64::from_bits(match number >> 63 {
        0 => !number,
        _ => number & !(1 << 63),
    })
}

#[cfg(test)]
mod tests {
    use super::{PASSES, Selection};

    /// Values of all sizes and signs, in no order: the ranks are those of a sorted list.
    #[test]
    fn ranks_are_those_of_a_sorted_list() {
        let mut state = 1_u64;
        let mut values: Vec<f64> = (0..5000)
            .map(|i| {
                state = state
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1);
                match i % 4 {
                    0 => f64::from_bits(state).abs().clamp(1e-300, 1e300),
                    1 => 0.3 + 1e-9 * (state >> 40) as f64,
                    2 => -((state >> 50) as f64),
                    _ => [0.0, -0.0, 5.0, 1e-310][(state >> 62) as usize],
                }
            })
            .collect();
        let ranks = [0, 1, 2, 77, 2499, 2500, 2501, 4000, 4998, 4999];
        let mut selection = Selection::new(&ranks);
        for _ in 0..PASSES {
            for value in &values {
                selection.count(*value);
            }
            selection.end_pass();
        }
        values.sort_by(f64::total_cmp);
        let expected: Vec<u64> = ranks
            .iter()
            .map(|r| values[*r as usize].to_bits())
            .collect();
        let found = selection.values();
        assert_eq!(
            found.iter().map(|v| v.to_bits()).collect::<Vec<_>>(),
            expected
        );
    }
}

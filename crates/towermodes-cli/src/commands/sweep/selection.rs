//! Selection of the rows of a sweep for the picture, if there are too many.

/// A random selection of rows, the same for each run.
///
/// Every second or third row would omit some values of a grid, whose last input varies fastest.
/// Therefore a row is selected by a hash of its number, which has no period.
#[derive(Debug, Clone, Copy)]
pub(super) struct Selection {
    /// Rows with a larger hash are not selected.
    largest: u64,
}

impl Selection {
    /// Selects about `most` of `rows` rows; all rows if `rows` is not larger.
    pub(super) fn of(rows: u64, most: u64) -> Self {
        let share = most as f64 / rows as f64;
        Self {
            largest: match rows > most {
                true => (share * u64::MAX as f64) as u64,
                false => u64::MAX,
            },
        }
    }

    /// Whether a row is selected.
    pub(super) fn has(self, row: u64) -> bool {
        mixed(row) <= self.largest
    }
}

/// The finalizer of SplitMix64 (Steele, Lea, Flood 2014), after one step of its sequence: each bit
/// of the result depends on all bits of the number.
fn mixed(number: u64) -> u64 {
    let mut z = number.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::{Selection, mixed};

    /// The sequence of SplitMix64 with the seed 0, by its reference implementation.
    #[test]
    fn the_hash_is_that_of_the_reference() {
        assert_eq!(mixed(0), 0xe220_a839_7b1d_cdaf);
        assert_eq!(mixed(1), 0x6e78_9e6a_a1b9_65f4);
        assert_eq!(mixed(2), 0x06c4_5d18_8009_454f);
    }

    /// In a grid the last input varies fastest: each of its levels has the same share of the
    /// selected rows, within four standard deviations of a random selection.
    #[test]
    fn every_level_of_a_grid_is_selected_alike() {
        let rows = 400_000;
        let selection = Selection::of(rows, rows / 4);
        for levels in [2, 3, 4, 7, 100] {
            let mut counts = vec![0_u64; levels as usize];
            for row in (0..rows).filter(|row| selection.has(*row)) {
                counts[(row % levels) as usize] += 1;
            }
            let expected = rows as f64 / levels as f64 / 4.0;
            let allowed = 4.0 * (0.75 * expected).sqrt();
            let wrong = |count: &&u64| (**count as f64 - expected).abs() > allowed;
            assert_eq!(counts.iter().find(wrong), None, "{levels} levels");
        }
    }

    #[test]
    fn few_rows_are_all_selected() {
        let selection = Selection::of(1000, 1000);
        assert!((0..1000).all(|row| selection.has(row)));
        assert!(Selection::of(0, 1000).has(0));
    }
}

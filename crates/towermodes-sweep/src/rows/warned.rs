//! Remarks on rows.

/// Number of rows whose messages are kept.
const KEPT: usize = 5;

/// The number of rows with a remark, and the first remarks.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct RowRemarks {
    /// Number of such rows.
    pub rows: u64,
    /// The first such rows: the number of the row, from 0, and its first remark.
    pub first: Vec<(u64, String)>,
}

impl RowRemarks {
    /// Adds a row. Each thread adds its rows in their order.
    pub(crate) fn add(&mut self, row: u64, sentence: impl FnOnce() -> String) {
        self.rows += 1;
        if self.first.len() < KEPT {
            self.first.push((row, sentence()));
        }
    }

    /// Adds other remarks. The rows that are kept do not depend on the order of the calls.
    pub(crate) fn append(&mut self, mut other: Self) {
        self.rows += other.rows;
        self.first.append(&mut other.first);
        self.first.sort_unstable_by_key(|(row, _)| *row);
        self.first.truncate(KEPT);
    }
}

#[cfg(test)]
mod tests {
    use super::RowRemarks;

    #[test]
    fn the_first_rows_are_kept_whoever_solves_them() {
        let mut threads = [RowRemarks::default(), RowRemarks::default()];
        for row in 0..100_u64 {
            threads[(row / 3 % 2) as usize].add(row, || format!("row {row}"));
        }
        let [mut all, other] = threads;
        all.append(other);
        assert_eq!(all.rows, 100);
        let expected = [0, 1, 2, 3, 4].map(|row| (row, format!("row {row}")));
        assert_eq!(all.first, expected);
    }
}

//! Rows without a complete result.

use std::collections::TryReserveError;

/// The numbers of rows that failed or lack a mode, and the message of each, by increasing row
/// number.
///
/// The messages are stored as one text: ten million separate strings would need twice the memory,
/// and if the memory for one text is not available, this is an error, whereas a failed allocation
/// of a string ends the process.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FailedRows {
    rows: Vec<u64>,
    /// End of the message of each row in this text; it begins at the end of the previous message.
    ends: Vec<u64>,
    text: String,
}

impl FailedRows {
    /// Number of these rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether all rows are complete.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The number of a row, from 0, and its message, by the index in this list.
    pub fn get(&self, place: usize) -> Option<(u64, &str)> {
        let row = *self.rows.get(place)?;
        let begin = place.checked_sub(1).map_or(0, |last| self.ends[last]);
        let sentence = &self.text[begin as usize..self.ends[place] as usize];
        Some((row, sentence))
    }

    /// The number of each row, from 0, and its message.
    pub fn iter(&self) -> impl Iterator<Item = (u64, &str)> {
        (0..self.len()).filter_map(|place| self.get(place))
    }

    /// The numbers of the rows, the end of the message of each in the common text (in bytes), and
    /// this text in UTF-8.
    pub fn into_columns(self) -> (Vec<u64>, Vec<u64>, Vec<u8>) {
        (self.rows, self.ends, self.text.into_bytes())
    }

    /// Adds a row whose number is larger than all numbers in the list.
    ///
    /// # Errors
    /// If the memory is not available.
    pub(crate) fn push(&mut self, row: u64, sentence: &str) -> Result<(), TryReserveError> {
        self.rows.try_reserve(1)?;
        self.ends.try_reserve(1)?;
        self.text.try_reserve(sentence.len())?;
        self.text.push_str(sentence);
        self.rows.push(row);
        self.ends.push(self.text.len() as u64);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::FailedRows;

    #[test]
    fn sentences_of_any_length_are_kept_with_their_rows() {
        let sentence = |row: u64| format!("row {row}: {}", "ß".repeat((row % 4) as usize));
        let mut all = FailedRows::default();
        for row in 0..100 {
            all.push(row, &sentence(row)).expect("memory");
        }
        assert_eq!(all.len(), 100);
        for ((row, found), expected) in all.iter().zip(0..) {
            assert_eq!((row, found), (expected, sentence(expected).as_str()));
        }
        assert_eq!((all.get(100), all.is_empty()), (None, false));
        let (rows, ends, text) = all.into_columns();
        assert_eq!((rows[99], ends[99]), (99, text.len() as u64));
        assert_eq!(text[..ends[1] as usize], *"row 0: row 1: ß".as_bytes());
    }
}

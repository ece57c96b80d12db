//! Assignment of the modes at one speed to the modes at another speed, by their modal assurance
//! criteria (MAC).

/// A mode with at least this MAC counts as the same mode.
const SAME: f64 = 0.5;

/// A mode that veers with two others has a MAC of one third with each of three modes. With a MAC
/// below this limit it is another mode.
const BETWEEN: f64 = 0.25;

/// It is also another mode if the sum of its MACs with all modes at this speed is smaller than
/// this.
const MADE_UP: f64 = 0.75;

/// The assignment of the modes at one speed to followed modes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Assignment {
    /// For each followed mode the index of its mode at this speed, if one is assigned.
    chosen: Vec<Option<usize>>,
    /// The MAC of each followed mode (row) with each mode at this speed (column).
    mac: Vec<Vec<f64>>,
}

impl Assignment {
    /// Greedy assignment by descending MAC: the pair with the largest MAC first, then the largest
    /// among the remaining modes, and so on. `is_followed` tells whether a row takes part.
    pub(crate) fn greedy(mac: Vec<Vec<f64>>, is_followed: impl Fn(usize) -> bool) -> Self {
        let columns = mac.iter().map(Vec::len).max().unwrap_or(0);
        let followed = (0..mac.len()).filter(|row| is_followed(*row));
        let mut pairs: Vec<(usize, usize)> = followed
            .flat_map(|row| (0..columns).map(move |column| (row, column)))
            .collect();
        // Among equal MACs the closer index wins: the sort is stable.
        pairs.sort_by_key(|(row, column)| row.abs_diff(*column));
        pairs.sort_by(|a, b| mac[b.0][b.1].total_cmp(&mac[a.0][a.1]));
        let mut chosen = vec![None; mac.len()];
        let mut is_taken = vec![false; columns];
        for (row, column) in pairs {
            if chosen[row].is_none() && !is_taken[column] {
                chosen[row] = Some(column);
                is_taken[column] = true;
            }
        }
        Self { chosen, mac }
    }

    /// Assigns the first mode to the first, the second to the second, and so on.
    pub(crate) fn in_order(mac: Vec<Vec<f64>>) -> Self {
        let chosen = (0..mac.len()).map(Some).collect();
        Self { chosen, mac }
    }

    /// The index of the mode at this speed that continues a followed mode, or the MAC of the
    /// assigned mode if it is too small.
    pub(crate) fn found(&self, row: usize) -> Result<usize, f64> {
        let Some(column) = self.chosen[row] else {
            return Err(0.0);
        };
        let mac = self.mac[row][column];
        let together: f64 = self.mac[row].iter().sum();
        let is_between = mac >= BETWEEN && together >= MADE_UP;
        if mac >= SAME || is_between {
            Ok(column)
        } else {
            Err(mac)
        }
    }

    /// Difference between the MAC of a followed mode with a mode and its largest MAC with any other
    /// mode.
    pub(crate) fn lead(&self, row: usize, column: usize) -> f64 {
        let macs = &self.mac[row];
        let rivals = macs.iter().enumerate().filter(|(i, _)| *i != column);
        let rival = rivals.map(|(_, mac)| *mac).fold(0.0, f64::max);
        macs[column] - rival
    }

    /// Difference between the MAC of a followed mode with one mode and with another.
    pub(crate) fn lead_over(&self, row: usize, column: usize, other: usize) -> f64 {
        self.mac[row][column] - self.mac[row][other]
    }

    /// Exchanges the modes assigned to two followed modes.
    pub(crate) fn exchange(&mut self, a: usize, b: usize) {
        self.chosen.swap(a, b);
    }
}

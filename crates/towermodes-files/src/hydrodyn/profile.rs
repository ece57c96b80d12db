//! Values that are linear between the depths of a table.

/// Values by height, in increasing order of height.
#[derive(Debug, Clone, Default)]
pub(super) struct Profile<const N: usize> {
    rows: Vec<(f64, [f64; N])>,
}

impl<const N: usize> Profile<N> {
    pub(super) fn new(mut rows: Vec<(f64, [f64; N])>) -> Self {
        // Files list depths downwards: of two rows at one height the first is the upper one.
        if rows
            .first()
            .zip(rows.last())
            .is_some_and(|(a, b)| a.0 > b.0)
        {
            rows.reverse();
        }
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self { rows }
    }

    /// The heights of the table.
    pub(super) fn heights_m(&self) -> impl Iterator<Item = f64> {
        self.rows.iter().map(|(z_m, _)| *z_m)
    }

    /// Whether a height is within the table.
    pub(super) fn holds(&self, z_m: f64) -> bool {
        let (first, last) = (self.rows.first(), self.rows.last());
        first.is_some_and(|row| row.0 <= z_m) && last.is_some_and(|row| z_m <= row.0)
    }

    /// The values at a height, in the interval of the table that contains `middle_m`; outside the
    /// table those of the nearest row. None for an empty table.
    pub(super) fn at(&self, z_m: f64, middle_m: f64) -> Option<[f64; N]> {
        let above = self.rows.partition_point(|row| row.0 < middle_m);
        let Some((high, upper)) = self.rows.get(above) else {
            return self.rows.last().map(|row| row.1);
        };
        let Some((low, lower)) = above.checked_sub(1).map(|below| self.rows[below]) else {
            return Some(*upper);
        };
        let fraction = (z_m - low) / (high - low);
        Some(std::array::from_fn(|i| {
            lower[i] + fraction * (upper[i] - lower[i])
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::Profile;

    #[test]
    fn a_step_belongs_to_both_intervals() {
        let rows = vec![(0.0, [1.0]), (-10.0, [2.0]), (-10.0, [5.0]), (-20.0, [6.0])];
        let profile = Profile::new(rows);
        assert_eq!(profile.at(-5.0, -5.0), Some([1.5]));
        let at_step = [-9.0, -11.0].map(|middle_m| profile.at(-10.0, middle_m));
        assert_ne!(at_step[0], at_step[1]);
        assert_eq!(profile.at(3.0, 4.0), Some([1.0]));
        assert!(profile.holds(-20.0) && !profile.holds(0.1));
    }
}

//! Added mass of a floating platform by frequency.

use crate::space::SpatialMatrix;

/// Above the last frequency the added mass changes to that at infinite frequency over this fraction
/// of the frequency.
const RAMP: f64 = 1e-6;

/// The added mass of a floating platform by frequency, for the motion (x, y, z, rotation about x,
/// y, z) of a point: kg, kg m, kg m².
///
/// It is linear in the frequency between the rows, and constant above the last one, as HydroDyn
/// interpolates the results of panel codes (Jonkman, Robertson & Hayman, *HydroDyn User's Guide*,
/// 2014).
///
/// # Example
/// ```
/// use towermodes::AddedMassTable;
///
/// let heave = |mass_kg: f64| {
///     let mut matrix = [[0.0; 6]; 6];
///     matrix[2][2] = mass_kg;
///     matrix
/// };
/// let table = AddedMassTable {
///     zero: heave(4.0),
///     rows: vec![(0.5, heave(6.0)), (1.0, heave(2.0))],
///     infinite: heave(3.0),
/// };
/// let at = [0.0, 0.25, 0.75, 2.0].map(|frequency| table.at(frequency)[2][2]);
/// assert_eq!(at, [4.0, 5.0, 4.0, 3.0]);
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AddedMassTable {
    /// Added mass at frequency zero.
    pub zero: SpatialMatrix,
    /// Added mass at rising angular frequencies (rad/s), all positive.
    pub rows: Vec<(f64, SpatialMatrix)>,
    /// Added mass at infinite frequency.
    pub infinite: SpatialMatrix,
}

impl AddedMassTable {
    /// Applies a function to all matrices.
    #[must_use]
    pub fn map(mut self, change: impl Fn(&SpatialMatrix) -> SpatialMatrix) -> Self {
        self.zero = change(&self.zero);
        self.infinite = change(&self.infinite);
        for (_, matrix) in &mut self.rows {
            *matrix = change(matrix);
        }
        self
    }

    /// All matrices.
    pub fn matrices(&self) -> impl Iterator<Item = &SpatialMatrix> + Clone {
        let rows = self.rows.iter().map(|(_, matrix)| matrix);
        [&self.zero, &self.infinite].into_iter().chain(rows)
    }

    /// The added mass at an angular frequency, rad/s.
    pub fn at(&self, frequency: f64) -> SpatialMatrix {
        let above = self.rows.partition_point(|(row, _)| *row <= frequency);
        let (low, high) = (self.knot(above), self.knot(above + 1));
        let Some((from, lower)) = low.filter(|_| frequency > 0.0) else {
            return self.zero;
        };
        // At the row the result is exactly its matrix, and at infinity exactly that at infinite
        // frequency.
        match high.filter(|(to, _)| frequency < *to && frequency > from) {
            Some((to, upper)) => between(lower, upper, (frequency - from) / (to - from)),
            None if above > 0 && frequency == from => *lower,
            None => self.infinite,
        }
    }

    /// A frequency at which the slope of the added mass changes: the frequency of a row, or the end
    /// of the change to infinity. The first is frequency zero; none after the last.
    fn knot(&self, index: usize) -> Option<(f64, &SpatialMatrix)> {
        let last = self.rows.len();
        match index {
            0 => Some((0.0, &self.zero)),
            _ if index <= last => {
                let (frequency, matrix) = &self.rows[index - 1];
                Some((*frequency, matrix))
            }
            _ if index == last + 1 => Some((self.end(), &self.infinite)),
            _ => None,
        }
    }

    /// The angular frequency from which on the added mass is constant, rad/s.
    pub fn end(&self) -> f64 {
        self.rows.last().map_or(0.0, |(row, _)| row * (1.0 + RAMP))
    }

    /// The intervals of angular frequency (rad/s) in which the added mass is linear, rising.
    pub(crate) fn intervals(&self) -> impl Iterator<Item = [f64; 2]> {
        let knots = (0..self.rows.len() + 2).filter_map(|index| self.knot(index));
        let ends = self.rows.iter().map(|(row, _)| *row).chain([self.end()]);
        let starts = knots.map(|(frequency, _)| frequency);
        starts
            .zip(ends)
            .map(|(from, to)| [from, to])
            .filter(|[from, to]| from < to)
    }
}

/// The matrix at a fraction between two others.
fn between(lower: &SpatialMatrix, upper: &SpatialMatrix, fraction: f64) -> SpatialMatrix {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| lower[i][j] + fraction * (upper[i][j] - lower[i][j]))
    })
}

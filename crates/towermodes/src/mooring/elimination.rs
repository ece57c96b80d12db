//! Elimination of the free unknowns from a small dense symmetric matrix.

/// A pivot below this fraction of its scale belongs to a motion without stiffness.
const NO_STIFFNESS: f64 = 1e-11;

/// A symmetric matrix by rows, of which the lower triangle is used; its first unknowns are
/// eliminated.
#[derive(Debug, Clone, Default)]
pub(super) struct Elimination {
    /// The matrix, then the factors L and D of the eliminated part and the Schur complement of the
    /// rest.
    pub(super) matrix: Vec<f64>,
    /// Rows.
    pub(super) size: usize,
    /// Number of eliminated unknowns.
    pub(super) eliminated: usize,
}

impl Elimination {
    /// Makes the factors, after the scales times `shift` have been added to the diagonal.
    ///
    /// A motion that nothing resists, as the rotation of a rod about its axis, is coupled to
    /// nothing and left out.
    ///
    /// # Errors
    /// The unknown at which a pivot is negative: the stiffness is not positive.
    pub(super) fn factor(&mut self, scales: &[f64], shift: f64) -> Result<(), usize> {
        let n = self.size;
        for (k, scale) in scales.iter().enumerate().take(self.eliminated) {
            self.matrix[k * n + k] += shift * scale;
        }
        for (k, scale) in scales.iter().enumerate().take(self.eliminated) {
            let (pivot, least) = (self.matrix[k * n + k], NO_STIFFNESS * scale);
            if pivot < -least || pivot.is_nan() {
                return Err(k);
            }
            let is_free = pivot <= least;
            // From below, so that column k is divided where it is no longer needed.
            for i in (k + 1..n).rev() {
                let entry = self.matrix[i * n + k];
                let factor = if is_free { 0.0 } else { entry / pivot };
                for j in k + 1..=i {
                    self.matrix[i * n + j] -= factor * self.matrix[j * n + k];
                }
                self.matrix[i * n + k] = factor;
            }
            self.matrix[k * n + k] = if is_free { 0.0 } else { pivot };
        }
        Ok(())
    }

    /// Solves for the eliminated unknowns, in place.
    pub(super) fn solve(&self, right: &mut [f64]) {
        let n = self.size;
        for i in 0..self.eliminated {
            right[i] -= (0..i)
                .map(|j| self.matrix[i * n + j] * right[j])
                .sum::<f64>();
        }
        for (k, value) in right.iter_mut().enumerate().take(self.eliminated) {
            let pivot = self.matrix[k * n + k];
            *value = if pivot > 0.0 { *value / pivot } else { 0.0 };
        }
        for i in (0..self.eliminated).rev() {
            let below = i + 1..self.eliminated;
            right[i] -= below
                .map(|j| self.matrix[j * n + i] * right[j])
                .sum::<f64>();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Elimination;

    /// Springs in a row: 1 between ground and the first point, 2 to the second, 3 to the third.
    fn springs() -> Elimination {
        Elimination {
            matrix: vec![3.0, -2.0, 0.0, -2.0, 5.0, -3.0, 0.0, -3.0, 3.0],
            size: 3,
            eliminated: 2,
        }
    }

    #[test]
    fn springs_in_series_add_their_flexibilities() {
        let mut chain = springs();
        chain.factor(&[3.0, 5.0], 0.0).expect("positive");
        // 1/(1 + 1/2 + 1/3).
        assert!((chain.matrix[8] - 6.0 / 11.0).abs() < 1e-15);
        let mut forces = [0.0, 3.0];
        chain.solve(&mut forces);
        // 3 N on the second point, springs 1 and 2 to the ground, 3 to a held point.
        let second = 3.0 / (3.0 + 2.0 / 3.0);
        assert!(
            (forces[1] - second).abs() < 1e-15 && (forces[0] - second * 2.0 / 3.0).abs() < 1e-15
        );
    }

    #[test]
    fn a_negative_pivot_is_told_and_a_free_motion_left_out() {
        let mut falls = springs();
        falls.matrix[4] = 1.0;
        assert_eq!(falls.factor(&[3.0, 5.0], 0.0), Err(1));
        let mut free = springs();
        (free.matrix[3], free.matrix[4], free.matrix[7]) = (0.0, 0.0, 0.0);
        free.factor(&[3.0, 5.0], 0.0).expect("positive");
        assert_eq!(free.matrix[8], 3.0);
    }
}

//! A small Hermitian matrix: the motion of a body, and coordinates of joints that move it.

use crate::beam::{Condensed, eliminate, first_block, reduce, substitute};
use crate::scalar::{Complex, Number};

/// Largest number of coordinates: six of the body and two of joints.
const MOST: usize = 8;

/// A 6×6 Hermitian matrix of a body, bordered by up to two further coordinates.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bordered {
    entries: [[Complex; MOST]; MOST],
    /// Factors after [`Self::condense`], row by row with `rows` numbers per row.
    factors: [Complex; MOST * MOST],
    pub(super) rows: usize,
}

impl Default for Bordered {
    fn default() -> Self {
        Self::of(&[[Complex::default(); 6]; 6])
    }
}

impl Bordered {
    pub(crate) fn of(matrix: &[[Complex; 6]; 6]) -> Self {
        let mut entries = [[Complex::default(); MOST]; MOST];
        for (row, own) in entries.iter_mut().zip(matrix) {
            row[..6].copy_from_slice(own);
        }
        Self {
            entries,
            factors: [Complex::default(); MOST * MOST],
            rows: 6,
        }
    }

    /// Adds the coordinate of a joint about or along this component: everything above the joint
    /// moves in the coordinate as in the component, so the coordinate gets a copy of its row and
    /// column. Returns the index of the coordinate.
    pub(super) fn border(&mut self, component: usize) -> usize {
        let place = self.rows;
        for i in 0..place {
            self.entries[i][place] = self.entries[i][component];
            self.entries[place][i] = self.entries[component][i];
        }
        self.entries[place][place] = self.entries[component][component];
        self.rows += 1;
        place
    }

    pub(super) fn add(&mut self, i: usize, j: usize, value: f64) {
        self.entries[i][j] += Complex::real(value);
    }

    pub(super) fn add_both(&mut self, i: usize, j: usize, value: f64) {
        self.add(i, j, value);
        self.add(j, i, value);
    }

    /// Eliminates all coordinates except the motion of the body, and keeps the factors.
    pub(super) fn condense(&mut self, own: &mut Condensed) {
        let rows = self.rows;
        let factors = self.factors.chunks_exact_mut(rows).zip(&self.entries);
        for (out, row) in factors.take(rows) {
            out.copy_from_slice(&row[..rows]);
        }
        own.negative += eliminate(&mut self.factors[..rows * rows], rows, 6);
        own.matrix = first_block(&self.factors, rows);
    }

    /// Eliminates the coordinates of the joints from a right side.
    pub(crate) fn reduce(&self, right: &mut [Complex; MOST]) {
        reduce(&self.factors, self.rows, 6, &mut right[..self.rows]);
    }

    /// Computes these coordinates from the motion of the body.
    pub(super) fn substitute(&self, right: &mut [Complex; MOST]) {
        substitute(&self.factors, self.rows, 6, &mut right[..self.rows]);
    }
}

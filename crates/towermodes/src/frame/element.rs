//! An element whose first coordinates move its far end and whose others, the bubbles, do not.
//!
//! The far end moves by X v + T y for the motion v of the near end and the coordinates y, whose
//! stiffness is the identity. An orthogonal change of coordinates keeps the identity and brings T
//! to [L 0], with L lower triangular. So L Lᵀ is the flexibility of the element, and the bubbles
//! are its vibration between held ends.

use super::rigid::{self, Motion};
use crate::beam::MemberElement;
use crate::space::SpatialMatrix;

/// A row of T with a smaller part that is independent of the rows before is taken as dependent.
const INDEPENDENT: f64 = 1e-12;

/// An element in the axes of its member.
#[derive(Debug, Clone)]
pub(super) struct Element {
    /// X.
    pub(super) transfer: SpatialMatrix,
    /// The columns of L: the motion of the far end for each coordinate that moves it.
    pub(super) tip: Vec<Motion>,
    /// All coordinates, the bubbles last.
    pub(super) coordinates: usize,
    /// Inertia, stiffness to the ground, geometric stiffness for v and y: 6 + coordinates rows;
    /// empty where there is none.
    pub(super) matrices: [Vec<f64>; 3],
    /// The unit vectors of the reflections that changed the coordinates.
    reflectors: Vec<Vec<f64>>,
}

impl Element {
    /// The element that was made last.
    pub(super) fn of(made: &MemberElement, length_m: f64) -> Self {
        let mut tips = made.tip().map(<[f64]>::to_vec);
        let tips = std::array::from_fn(|_| tips.next().unwrap_or_default());
        Self::new(
            MemberElement::rigid(length_m),
            tips,
            made.matrices().clone(),
        )
    }

    /// An element with these rows of T.
    pub(super) fn new(
        transfer: SpatialMatrix,
        mut tips: [Vec<f64>; 6],
        mut matrices: [Vec<f64>; 3],
    ) -> Self {
        let coordinates = tips[0].len();
        let (mut rank, mut reflectors) = (0, Vec::new());
        for d in 0..6 {
            let Some(reflector) = reflector(&tips[d], rank) else {
                continue;
            };
            for row in &mut tips {
                reflect(&reflector, &mut row[rank..]);
            }
            for matrix in matrices.iter_mut().filter(|matrix| !matrix.is_empty()) {
                reflect_matrix(&reflector, 6 + coordinates, 6 + rank, matrix);
            }
            rank += 1;
            reflectors.push(reflector);
        }
        let column = |k: usize| std::array::from_fn(|d| tips[d][k]);
        Self {
            transfer,
            tip: (0..rank).map(column).collect(),
            coordinates,
            matrices,
            reflectors,
        }
    }

    /// The coordinates y before the change, from those after it, in place.
    pub(super) fn change_back(&self, own: &mut [f64]) {
        for (rank, reflector) in self.reflectors.iter().enumerate().rev() {
            reflect(reflector, &mut own[rank..]);
        }
    }

    /// The same without its bubbles, and with more inertia, given for the motions of both ends (12
    /// rows).
    pub(super) fn with_nodal_inertia(&self, inertia: &[[f64; 12]; 12]) -> Self {
        let moving = self.tip.len();
        let rows = 6 + moving;
        // Both ends for (v, y).
        let ends = |i: usize, j: usize| match (i < 6, j < 6) {
            (true, _) => f64::from(u8::from(i == j)),
            (false, true) => self.transfer[i - 6][j],
            (false, false) => self.tip[j - 6][i - 6],
        };
        let old = 6 + self.coordinates;
        let leading = |matrix: &Vec<f64>| -> Vec<f64> {
            let rows_of = matrix.chunks_exact(old).take(rows);
            rows_of.flat_map(|row| row[..rows].to_vec()).collect()
        };
        let [carried, ground, geometric] = &self.matrices;
        let mut sum = leading(carried);
        sum.resize(rows * rows, 0.0);
        for i in 0..rows {
            let left: [f64; 12] =
                std::array::from_fn(|b| (0..12).map(|a| ends(a, i) * inertia[a][b]).sum());
            for j in 0..rows {
                sum[i * rows + j] += (0..12).map(|b| left[b] * ends(b, j)).sum::<f64>();
            }
        }
        Self {
            transfer: self.transfer,
            tip: self.tip.clone(),
            coordinates: moving,
            reflectors: Vec::new(),
            matrices: [sum, leading(ground), leading(geometric)],
        }
    }

    /// The same in global axes; the axes of the member are the rows of `axes`.
    pub(super) fn out_of_axes(mut self, axes: &[[f64; 3]; 3]) -> Self {
        let rows = 6 + self.coordinates;
        self.transfer = rigid::matrix_out_of_axes(axes, &self.transfer);
        for column in &mut self.tip {
            *column = rigid::out_of_axes(axes, column);
        }
        for matrix in self.matrices.iter_mut().filter(|matrix| !matrix.is_empty()) {
            for row in matrix.chunks_exact_mut(rows) {
                let near: Motion = std::array::from_fn(|k| row[k]);
                row[..6].copy_from_slice(&rigid::out_of_axes(axes, &near));
            }
            for j in 0..rows {
                let near: Motion = std::array::from_fn(|k| matrix[k * rows + j]);
                let turned = rigid::out_of_axes(axes, &near);
                (0..6).for_each(|k| matrix[k * rows + j] = turned[k]);
            }
        }
        self
    }
}

/// The unit vector u for which 1 − 2 u uᵀ turns a row from `rank` on to its first entry; none if
/// nothing is left of the row there.
fn reflector(row: &[f64], rank: usize) -> Option<Vec<f64>> {
    let size = |values: &[f64]| values.iter().map(|x| x * x).sum::<f64>().sqrt();
    let rest = row.get(rank..)?;
    let (all, own) = (size(row), size(rest));
    if own <= INDEPENDENT * all || rest.is_empty() {
        return None;
    }
    let mut unit = rest.to_vec();
    unit[0] += own.copysign(unit[0]);
    let length = size(&unit);
    unit.iter_mut().for_each(|x| *x /= length);
    Some(unit)
}

fn reflect(unit: &[f64], row: &mut [f64]) {
    let along: f64 = unit.iter().zip(&*row).map(|(u, x)| u * x).sum();
    for (x, u) in row.iter_mut().zip(unit) {
        *x -= 2.0 * along * u;
    }
}

/// Reflects rows and columns from `first` on of a symmetric matrix.
fn reflect_matrix(unit: &[f64], rows: usize, first: usize, matrix: &mut [f64]) {
    for row in matrix.chunks_exact_mut(rows) {
        reflect(unit, &mut row[first..]);
    }
    let mut along = vec![0.0; rows];
    for (u, row) in unit.iter().zip(matrix[first * rows..].chunks_exact(rows)) {
        for (sum, entry) in along.iter_mut().zip(row) {
            *sum += u * entry;
        }
    }
    for (u, row) in unit
        .iter()
        .zip(matrix[first * rows..].chunks_exact_mut(rows))
    {
        for (entry, along) in row.iter_mut().zip(&along) {
            *entry -= 2.0 * u * along;
        }
    }
}

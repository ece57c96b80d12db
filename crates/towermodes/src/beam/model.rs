//! A chain of flexible elements.

use super::strain::Deformation;
use crate::scalar::Scalar;
use crate::space::{Matrix, SquareMatrix, add_scaled, levers, transform_matrix, transform_motion};
use crate::subsystem::{Coefficients, MatrixKind};

/// A chain of flexible elements, in D motion components, clamped or on a base that moves.
///
/// Each element moves with its base and deforms by itself in `coordinates` ways: its strains are
/// Legendre polynomials Σ c_k P_k, and its unknowns are y = Lᵀ c with L Lᵀ the element's stiffness
/// for c. So the stiffness of the elements is the identity, as in a [`Chain`](crate::chain::Chain),
/// and the pencil is
///
/// (1 + Jᵀ S J) y = λ Jᵀ M J y,
///
/// where J maps y to the motion of each element's base and its own y. M (inertia) and S (stiffness
/// to the ground and geometric stiffness) hold one matrix per element for these. The space is that
/// of Hermite cubics and bubble functions, but no nodal stiffness is ever formed, whose entries
/// nearly cancel in fine meshes.
///
/// Vectors hold the coordinates of the base, if it moves, then those of the elements from the base
/// up.
#[derive(Debug, Clone, Default)]
pub struct Beam<const D: usize> {
    /// The deformations of an element.
    pub(super) deformations: Vec<Deformation<D>>,
    coordinates: usize,
    pub(super) base: Option<MovingBase<D>>,
    /// Height of the base of each element, m, and its length, m.
    pub(super) ends: Vec<(f64, f64)>,
    /// Motion of each element's top for its coordinates: D rows per element.
    pub(super) tips: Vec<f64>,
    /// Inertia, foundation and geometric stiffness of each element for the motion of its base and
    /// its coordinates: D + coordinates rows per element. The last two are shorter, or empty, if
    /// the elements above have none.
    pub(super) matrices: [Vec<f64>; 3],
    /// L of each element, lower triangular: `coordinates` rows per element.
    pub(super) roots: Vec<f64>,
    /// Working memory of [`add`](Self::add).
    top: Vec<f64>,
}

/// A base that moves.
#[derive(Debug, Clone, Copy)]
pub(super) struct MovingBase<const D: usize> {
    /// Motion for a coordinate of 1; zero in fixed components.
    pub(super) unit: [f64; D],
    height_m: f64,
    /// Inertia, foundation and geometric stiffness.
    pub(super) matrices: [Matrix<D>; 3],
}

impl<const D: usize> MovingBase<D> {
    /// The components that move.
    pub(super) fn moving(&self) -> impl DoubleEndedIterator<Item = usize> + Clone + use<D> {
        let unit = self.unit;
        (0..D).filter(move |&component| unit[component] != 0.0)
    }
}

/// Index of the geometric stiffness in the list of matrices.
pub(super) const GEOMETRIC: usize = 2;

/// Index of a kind of matrix in the list.
pub(super) fn place(kind: MatrixKind) -> usize {
    match kind {
        MatrixKind::Inertia => 0,
        MatrixKind::Foundation => 1,
    }
}

impl<const D: usize> Beam<D> {
    /// Forgets all elements but keeps the memory.
    pub fn clear(&mut self) {
        self.base = None;
        self.ends.clear();
        self.tips.clear();
        self.matrices.iter_mut().for_each(Vec::clear);
        self.roots.clear();
    }

    /// Sets how elements from here on deform.
    pub fn set_deformations(&mut self, deformations: impl Iterator<Item = Deformation<D>>) {
        self.deformations.clear();
        self.deformations.extend(deformations);
        self.coordinates = self.deformations.iter().map(|d| d.count).sum();
    }

    /// How elements deform, in the order of their coordinates.
    pub fn deformations(&self) -> &[Deformation<D>] {
        &self.deformations
    }

    /// Begins with a base that moves freely in the components with a `unit`: the motion (m or rad)
    /// for a coordinate of 1. Zero holds one.
    pub fn add_base(&mut self, height_m: f64, unit: [f64; D]) {
        let moves = unit.iter().any(|unit| *unit != 0.0);
        self.base = moves.then_some(MovingBase {
            unit,
            height_m,
            matrices: [[[0.0; D]; D]; 3],
        });
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.ends.len()
    }

    /// Coordinates of each element.
    pub fn coordinates(&self) -> usize {
        self.coordinates
    }

    /// The rows of the motion of an element's top for its coordinates.
    #[inline]
    pub(super) fn tip_rows(&self, element: usize) -> std::slice::ChunksExact<'_, f64> {
        let coordinates = self.coordinates();
        let tips = &self.tips[element * D * coordinates..(element + 1) * D * coordinates];
        tips.chunks_exact(coordinates.max(1))
    }

    /// Coordinates of the base.
    pub fn base_coordinates(&self) -> usize {
        self.base.as_ref().map_or(0, |base| base.moving().count())
    }

    /// Number of unknowns: the length of every vector of this beam.
    pub fn degrees_of_freedom(&self) -> usize {
        self.base_coordinates() + self.coordinates * self.elements()
    }

    /// Number of rows of an element's matrices.
    #[inline]
    pub(super) fn rows(&self) -> usize {
        D + self.coordinates
    }

    /// Adds a matrix, given about `reference_m` (m), to the top of the last element, or to the base
    /// before the first one.
    ///
    /// The top moves by X v + T y, so a matrix B adds [X T]ᵀ B [X T].
    pub fn add(&mut self, kind: MatrixKind, reference_m: f64, matrix: Matrix<D>) {
        self.add_at(place(kind), reference_m, matrix);
    }

    /// Adds a geometric stiffness −`moment_n_m` (N m/rad) against rotation in the bending planes to
    /// the top of the last element, or to the base before the first one.
    pub fn add_geometric_stiffness(&mut self, moment_n_m: f64) {
        if const { levers(D) }.is_empty() {
            return;
        }
        let mut matrix = [[0.0; D]; D];
        for lever in const { levers(D) } {
            matrix[lever.by][lever.by] = -moment_n_m;
        }
        let last = self.ends.last();
        let top_m = last.map_or(0.0, |(base_m, length_m)| base_m + length_m);
        self.add_at(GEOMETRIC, top_m, matrix);
    }

    fn add_at(&mut self, place: usize, reference_m: f64, mut matrix: Matrix<D>) {
        let Some(&(base_m, length_m)) = self.ends.last() else {
            if let Some(base) = &mut self.base {
                transform_matrix(&mut matrix, reference_m - base.height_m);
                add_scaled(&mut base.matrices[place], 1.0, &matrix);
            }
            return;
        };
        transform_matrix(&mut matrix, reference_m - (base_m + length_m));
        let rows = self.rows();
        let mut top = std::mem::take(&mut self.top);
        top.resize(D * rows, 0.0);
        self.top_motion(self.elements() - 1, &mut top);
        add_congruent(&matrix, &top, rows, self.last_matrix(place));
        self.top = top;
    }

    /// The matrix of the last element with this index in the list.
    pub(super) fn last_matrix(&mut self, place: usize) -> &mut [f64] {
        let size = self.rows() * self.rows();
        let count = self.elements();
        let matrices = &mut self.matrices[place];
        matrices.resize(count * size, 0.0);
        &mut matrices[(count - 1) * size..]
    }

    /// The D×rows matrix [X T] of an element, row by row: the motion of its top for the motion of
    /// its base and its coordinates.
    #[inline]
    pub(super) fn top_motion(&self, element: usize, matrix: &mut [f64]) {
        let (rows, coordinates) = (self.rows(), self.coordinates);
        let tip = &self.tips[element * D * coordinates..];
        let rigid = rigid_motion::<D>(self.ends[element].1);
        for d in 0..D {
            let row = &mut matrix[d * rows..(d + 1) * rows];
            row[..D].copy_from_slice(&rigid[d]);
            row[D..].copy_from_slice(&tip[d * coordinates..(d + 1) * coordinates]);
        }
    }

    /// Whether every number is finite: false if the input's numbers overflowed on the way here.
    pub fn is_finite(&self) -> bool {
        let base = self.base.iter().flat_map(|base| {
            let matrices = base.matrices.iter().flatten().flatten();
            matrices.chain(&base.unit)
        });
        let own = self.tips.iter().chain(&self.roots);
        let mut all = own.chain(self.matrices.iter().flatten()).chain(base);
        all.all(|value| value.is_finite())
    }

    /// Whether a matrix A is the stiffness of the elements alone, which is the identity.
    pub fn is_identity(&self, a: &Coefficients) -> bool {
        let [_, foundation, geometric] = &self.matrices;
        let is_tied = a.foundation != 0.0 && !foundation.is_empty();
        let is_pressed = a.geometric != 0.0 && !geometric.is_empty();
        a.stiffness == 1.0 && a.mass == 0.0 && !(self.base.is_some() || is_tied || is_pressed)
    }

    /// An element's coordinates y turned into its strain coefficients: c = L⁻ᵀ y, in place.
    pub fn to_strains<S: Scalar>(&self, element: usize, own: &mut [S]) {
        let m = self.coordinates;
        let root = &self.roots[element * m * m..(element + 1) * m * m];
        for i in (0..m).rev() {
            own[i] = own[i].over(root[i * m + i]);
            for j in 0..i {
                own[j] -= own[i].times(root[i * m + j]);
            }
        }
    }

    /// Height of the middle of an element, m.
    pub fn middle_m(&self, element: usize) -> f64 {
        let (base_m, length_m) = self.ends[element];
        base_m + 0.5 * length_m
    }

    /// Length of an element, m.
    pub fn length_m(&self, element: usize) -> f64 {
        self.ends[element].1
    }
}

/// X(h): the rigid motion at a height h (m) above a point with known motion, as a matrix.
pub(super) fn rigid_motion<const D: usize>(rise_m: f64) -> Matrix<D> {
    let mut matrix = [[0.0; D]; D];
    for column in 0..D {
        let mut motion = [0.0; D];
        motion[column] = 1.0;
        transform_motion(&mut motion, rise_m);
        for row in 0..D {
            matrix[row][column] = motion[row];
        }
    }
    matrix
}

/// sum += Aᵀ B A for a real D×rows matrix A, all row by row.
#[inline]
pub(super) fn add_congruent<const D: usize, S: Scalar>(
    b: &SquareMatrix<S, D>,
    a: &[f64],
    rows: usize,
    sum: &mut [S],
) {
    for i in 0..rows {
        let left: [S; D] =
            std::array::from_fn(|d| (0..D).map(|e| b[e][d].times(a[e * rows + i])).sum());
        for j in 0..rows {
            let term: S = (0..D).map(|d| left[d].times(a[d * rows + j])).sum();
            sum[i * rows + j] += term;
        }
    }
}

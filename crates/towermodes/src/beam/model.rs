//! A chain of flexible elements.

use crate::chain::{Dim, Matrix, Space, lower_matrix};

/// A clamped chain of flexible elements, in D motion components.
///
/// Each element moves with its base and deforms by itself in `coordinates` ways: its strains are Legendre polynomials c_k P_k, and its
/// unknowns are y = Lᵀ c with L Lᵀ the element's stiffness for c. So the stiffness of the whole is the identity, as in a
/// [`Chain`](crate::chain::Chain), and the pencil is
///
/// y = λ Jᵀ M J y,
///
/// where J maps y to the motion of each element's base and its own y, and M holds one matrix an element for these. The space is that of
/// Hermite cubics and bubbles, but no stiffness of a node is ever formed, whose entries nearly cancel in fine meshes.
///
/// Vectors hold the coordinates element by element from the base.
#[derive(Debug, Clone, Default)]
pub struct Beam<const D: usize> {
    /// Coordinates of an element that are not shear, and all of them.
    bent: usize,
    coordinates: usize,
    /// Where each element begins, m, and its length, m.
    pub(super) ends: Vec<(f64, f64)>,
    /// Motion of each element's top by its coordinates: D rows an element.
    pub(super) tips: Vec<f64>,
    /// Inertia of each element for the motion of its base and its coordinates: D + coordinates rows an element.
    pub(super) masses: Vec<f64>,
    /// L of each element, lower triangular: `coordinates` rows an element.
    pub(super) roots: Vec<f64>,
    /// Working memory of [`add_body`](Self::add_body).
    top: Vec<f64>,
}

impl<const D: usize> Beam<D>
where
    Dim<D>: Space,
{
    /// Forgets all elements but keeps the memory; elements from here on have this many coordinates, those that shear last.
    pub fn restart(&mut self, bent: usize, sheared: usize) {
        self.bent = bent;
        self.coordinates = bent + sheared;
        self.ends.clear();
        self.tips.clear();
        self.masses.clear();
        self.roots.clear();
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.ends.len()
    }

    /// Coordinates of each element.
    pub fn coordinates(&self) -> usize {
        self.coordinates
    }

    /// Those of them that are not shear: the first ones.
    pub fn bent(&self) -> usize {
        self.bent
    }

    /// Number of unknowns: the length of every vector of this beam.
    pub fn degrees_of_freedom(&self) -> usize {
        self.coordinates * self.elements()
    }

    /// Rows of an element's inertia.
    #[inline]
    pub(super) fn rows(&self) -> usize {
        D + self.coordinates
    }

    /// Adds an inertia, given about `reference_m`, to the top of the last element; before the first that is the clamped base, which
    /// does not move.
    ///
    /// The top moves by X v + T y, so the inertia B is seen as [X T]ᵀ B [X T].
    pub fn add_body(&mut self, reference_m: f64, mut inertia: Matrix<D>) {
        let Some(&(base_m, length_m)) = self.ends.last() else {
            return;
        };
        lower_matrix(&mut inertia, reference_m - (base_m + length_m));
        let element = self.elements() - 1;
        let rows = self.rows();
        let mut top = std::mem::take(&mut self.top);
        top.resize(D * rows, 0.0);
        self.top_motion(element, &mut top);
        let mass = &mut self.masses[element * rows * rows..];
        add_congruent(&inertia, &top, rows, mass);
        self.top = top;
    }

    /// The D×rows matrix [X T] of an element, row by row: the motion of its top for the motion of its base and its coordinates.
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
        let all = self.tips.iter().chain(&self.masses).chain(&self.roots);
        all.into_iter().all(|value| value.is_finite())
    }

    /// An element's coordinates y turned into its strain coefficients: c = L⁻ᵀ y, in place.
    pub fn to_strains(&self, element: usize, own: &mut [f64]) {
        let m = self.coordinates;
        let root = &self.roots[element * m * m..(element + 1) * m * m];
        for i in (0..m).rev() {
            own[i] /= root[i * m + i];
            for j in 0..i {
                own[j] -= root[i * m + j] * own[i];
            }
        }
    }

    /// Length of an element, m.
    pub fn length_m(&self, element: usize) -> f64 {
        self.ends[element].1
    }
}

/// X(h): the rigid motion a height h (m) above one that is known, as a matrix.
pub(super) fn rigid_motion<const D: usize>(rise_m: f64) -> Matrix<D>
where
    Dim<D>: Space,
{
    let mut matrix = [[0.0; D]; D];
    for column in 0..D {
        let mut motion = [0.0; D];
        motion[column] = 1.0;
        crate::chain::raise(&mut motion, rise_m);
        for row in 0..D {
            matrix[row][column] = motion[row];
        }
    }
    matrix
}

/// sum += Aᵀ B A for a D×rows matrix A, both row by row.
#[inline]
pub(super) fn add_congruent<const D: usize>(
    b: &Matrix<D>,
    a: &[f64],
    rows: usize,
    sum: &mut [f64],
) {
    for i in 0..rows {
        let left: [f64; D] =
            std::array::from_fn(|d| (0..D).map(|e| b[e][d] * a[e * rows + i]).sum());
        for j in 0..rows {
            let term: f64 = (0..D).map(|d| left[d] * a[d * rows + j]).sum();
            sum[i * rows + j] += term;
        }
    }
}

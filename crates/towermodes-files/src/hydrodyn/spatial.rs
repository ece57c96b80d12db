//! Matrices for motions (x, y, z, rotation about x, y, z) of the origin, from matrices about other
//! points.

use towermodes::RigidBody;
use towermodes::space::SpatialMatrix;

pub(super) type Vector = [f64; 3];
pub(super) type Tensor = [[f64; 3]; 3];

pub(super) const NONE: SpatialMatrix = [[0.0; 6]; 6];

pub(super) fn between(a: Vector, b: Vector, fraction: f64) -> Vector {
    std::array::from_fn(|i| a[i] + fraction * (b[i] - a[i]))
}

pub(super) fn difference(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] - b[i])
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// Adds a matrix with a factor.
pub(super) fn add(sum: &mut SpatialMatrix, factor: f64, addend: &SpatialMatrix) {
    for (sum, addend) in sum.iter_mut().flatten().zip(addend.iter().flatten()) {
        *sum += factor * addend;
    }
}

/// T = [[1, −[r]], [0, 1]]: the motion of a point from that of the origin.
fn transfer([x, y, z]: Vector) -> SpatialMatrix {
    let mut matrix = NONE;
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] = 1.0;
    }
    (matrix[0][4], matrix[0][5]) = (z, -y);
    (matrix[1][3], matrix[1][5]) = (-z, x);
    (matrix[2][3], matrix[2][4]) = (y, -x);
    matrix
}

/// Aᵀ K A.
fn congruent(a: &SpatialMatrix, k: &SpatialMatrix) -> SpatialMatrix {
    let terms = |f: &dyn Fn(usize) -> f64| (0..6).map(f).sum::<f64>();
    let product: SpatialMatrix =
        std::array::from_fn(|i| std::array::from_fn(|j| terms(&|l| k[i][l] * a[l][j])));
    std::array::from_fn(|i| std::array::from_fn(|j| terms(&|l| a[l][i] * product[l][j])))
}

/// The matrix about the origin of a matrix about a point: Tᵀ K T.
pub(super) fn from_point(matrix: &SpatialMatrix, point_m: Vector) -> SpatialMatrix {
    congruent(&transfer(point_m), matrix)
}

/// The matrix in global axes of a matrix in axes that are rotated about z by an angle (degrees).
pub(super) fn turned_back(matrix: &SpatialMatrix, angle_deg: f64) -> SpatialMatrix {
    if angle_deg == 0.0 {
        return *matrix;
    }
    let (sin, cos) = angle_deg.to_radians().sin_cos();
    let mut to_local = NONE;
    for first in [0, 3] {
        (to_local[first][first], to_local[first][first + 1]) = (cos, sin);
        (to_local[first + 1][first], to_local[first + 1][first + 1]) = (-sin, cos);
        to_local[first + 2][first + 2] = 1.0;
    }
    congruent(&to_local, matrix)
}

/// The inertia about the origin of a mass at a point; the mass may depend on the direction.
pub(super) fn of_mass(mass_kg: &Tensor, point_m: Vector) -> SpatialMatrix {
    let mut matrix = NONE;
    for (row, masses) in matrix.iter_mut().zip(mass_kg) {
        row[..3].copy_from_slice(masses);
    }
    from_point(&matrix, point_m)
}

/// The inertia of a rigid body about a point.
pub(super) fn of_body(body: &RigidBody, point_m: Vector) -> SpatialMatrix {
    let mass: Tensor =
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { body.mass_kg } else { 0.0 }));
    let mut matrix = of_mass(&mass, difference(body.center_m, point_m));
    let own = body.inertia_kg_m2.tensor();
    for (row, own) in matrix[3..].iter_mut().zip(own) {
        for (sum, own) in row[3..].iter_mut().zip(own) {
            *sum += own;
        }
    }
    matrix
}

/// The stiffness about the origin due to a force of constant direction that acts on a rigid body at
/// a point: (F·r) 1 − ½ (r Fᵀ + F rᵀ) for rotations, the Hessian of −F·R(θ) r.
pub(super) fn of_force(force_n: Vector, point_m: Vector) -> SpatialMatrix {
    let along = dot(force_n, point_m);
    let mut matrix = NONE;
    for i in 0..3 {
        for j in 0..3 {
            let both = point_m[i] * force_n[j] + force_n[i] * point_m[j];
            matrix[3 + i][3 + j] = if i == j { along } else { 0.0 } - 0.5 * both;
        }
    }
    matrix
}

/// A force at a point as force and moment at the origin.
pub(super) fn load_of(force_n: Vector, [x, y, z]: Vector) -> [f64; 6] {
    let [fx, fy, fz] = force_n;
    [
        fx,
        fy,
        fz,
        y * fz - z * fy,
        z * fx - x * fz,
        x * fy - y * fx,
    ]
}

/// The symmetric part, and the largest omitted asymmetry: relative to √(K_ii K_jj), or to the pair
/// itself if a diagonal entry is zero.
pub(super) fn symmetric_part(matrix: &SpatialMatrix) -> (SpatialMatrix, f64) {
    let mut largest = 0.0_f64;
    let mut symmetric = *matrix;
    for i in 0..6 {
        for j in 0..i {
            let (a, b) = (matrix[i][j], matrix[j][i]);
            let mean = 0.5 * (a + b);
            (symmetric[i][j], symmetric[j][i]) = (mean, mean);
            let scale = (matrix[i][i] * matrix[j][j]).abs().sqrt();
            let scale = if scale > 0.0 {
                scale
            } else {
                a.abs().max(b.abs())
            };
            if a != b {
                largest = largest.max(0.5 * (a - b).abs() / scale);
            }
        }
    }
    (symmetric, largest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mass_has_its_moments_about_the_origin() {
        let matrix = of_mass(
            &[[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]],
            [1.0, 2.0, 3.0],
        );
        // m (y² + z²), m (x² + z²), −m x y; heave with roll: m y.
        assert_eq!(
            [matrix[3][3], matrix[4][4], matrix[3][4]],
            [26.0, 20.0, -4.0]
        );
        assert_eq!([matrix[2][3], matrix[3][2], matrix[0][4]], [4.0, 4.0, 6.0]);
    }

    #[test]
    fn weight_above_the_origin_overturns() {
        // −m g z on the diagonal, ½ m g x off it.
        let matrix = of_force([0.0, 0.0, -10.0], [1.0, 0.0, 3.0]);
        assert_eq!(
            [matrix[3][3], matrix[4][4], matrix[5][5]],
            [-30.0, -30.0, 0.0]
        );
        assert_eq!([matrix[3][5], matrix[5][3]], [5.0, 5.0]);
    }

    #[test]
    fn a_quarter_turn_changes_surge_and_sway() {
        let mut matrix = NONE;
        (matrix[0][0], matrix[1][1], matrix[0][4], matrix[4][0]) = (1.0, 2.0, 5.0, 5.0);
        let turned = turned_back(&matrix, 90.0);
        assert!((turned[0][0] - 2.0).abs() < 1e-15 && (turned[1][1] - 1.0).abs() < 1e-15);
        // Local x is global y, local y is −x.
        assert!((turned[1][3] + 5.0).abs() < 1e-15);
    }
}

//! Springs under the base of a tower.

use crate::inputs::{Input, Inputs, Limit};
use crate::space::SpatialMatrix;

/// Springs under the base, equal in both planes. An infinite spring is rigid, a zero spring is
/// none.
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
pub struct FoundationSprings {
    /// Spring against translation in x and y, N/m.
    #[input(spring("lateral", " N/m", "the lateral stiffness in x and y")
        .hint("lateral in N/m; inf is rigid, 0 is none")
        .also("kx ky kxx kyy k_x k_lateral horizontal translation kh"))]
    pub lateral_n_per_m: f64,
    /// Spring against rotation about x and y, N m/rad.
    #[input(spring("rocking", " N m", "the rocking stiffness about x and y")
        .hint("rocking in N m; inf is rigid, 0 is none")
        .also("krx kry k_rocking rotation rotational krot k_theta tilting kr"))]
    pub rocking_n_m: f64,
    /// Coupling between translation in x and rotation about y, and with the opposite sign between
    /// translation in y and rotation about x, N.
    #[input(Input::new("coupling", " N", Limit::Finite, "the coupling stiffness between x and rotation about y")
        .or(0.0)
        .quiet()
        .note("between x and rotation about y")
        .also("kxr klr cross cross_coupling k_coupling"))]
    pub coupling_n: f64,
    /// Spring against translation in z, N/m.
    #[input(spring("vertical", " N/m", "the vertical stiffness")
        .hint("vertical in N/m; inf is rigid, 0 is none")
        .also("kz kzz k_z k_vertical axial kv"))]
    pub vertical_n_per_m: f64,
    /// Spring against rotation about z, N m/rad.
    #[input(spring("torsion", " N m", "the torsional stiffness about z")
        .hint("torsion in N m; inf is rigid, 0 is none")
        .also("ktors krz kt torsional yaw"))]
    pub torsion_n_m: f64,
}

/// A spring that may be rigid.
const fn spring(key: &'static str, spaced_unit: &'static str, name: &'static str) -> Input {
    Input::new(key, spaced_unit, Limit::Stiffness, name)
        .or_infinite()
        .note("inf is rigid")
}

impl FoundationSprings {
    /// Rigid against all six motions, without coupling.
    pub const RIGID: Self = Self {
        lateral_n_per_m: f64::INFINITY,
        rocking_n_m: f64::INFINITY,
        coupling_n: 0.0,
        vertical_n_per_m: f64::INFINITY,
        torsion_n_m: f64::INFINITY,
    };

    /// The stiffness for the motion (x, y, z, rotation about x, y, z) of the base; a rigid spring
    /// is infinite on its diagonal.
    pub(crate) fn matrix(&self) -> SpatialMatrix {
        let mut matrix = SpatialMatrix::default();
        for (i, value) in self.diagonal().into_iter().enumerate() {
            matrix[i][i] = value;
        }
        for (translation, rotation, sign) in [(0, 4, 1.0), (1, 3, -1.0)] {
            matrix[translation][rotation] = sign * self.coupling_n;
            matrix[rotation][translation] = sign * self.coupling_n;
        }
        matrix
    }

    /// The springs of a stiffness matrix that is equal in both planes; none for any other matrix.
    pub fn of_matrix(matrix: &SpatialMatrix) -> Option<Self> {
        let springs = Self {
            lateral_n_per_m: matrix[0][0],
            rocking_n_m: matrix[4][4],
            coupling_n: matrix[0][4],
            vertical_n_per_m: matrix[2][2],
            torsion_n_m: matrix[5][5],
        };
        (springs.matrix() == *matrix).then_some(springs)
    }

    /// Along the diagonal of the stiffness: x, y, z, rotation about x, y, z.
    pub(crate) fn diagonal(&self) -> [f64; 6] {
        let (lateral, rocking) = (self.lateral_n_per_m, self.rocking_n_m);
        [
            lateral,
            lateral,
            self.vertical_n_per_m,
            rocking,
            rocking,
            self.torsion_n_m,
        ]
    }
}

//! The inertia tensor of a rigid body.

use crate::symmetric::eigenpairs;

/// The inertia tensor of a rigid body about its own centre of mass, kg m².
///
/// Products of inertia are the entries of the tensor (xy = −∫ x y dm).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Inertia {
    /// About the fore-aft axis (resists side-side rotation), kg m².
    pub xx: f64,
    /// About the side-side axis (resists fore-aft rotation), kg m².
    pub yy: f64,
    /// About the tower axis (resists torsion), kg m².
    pub zz: f64,
    /// Entry xy, kg m².
    pub xy: f64,
    /// Entry xz, kg m².
    pub xz: f64,
    /// Entry yz, kg m².
    pub yz: f64,
}

impl Inertia {
    /// The symmetric 3×3 tensor, kg m².
    pub fn tensor(&self) -> [[f64; 3]; 3] {
        [
            [self.xx, self.xy, self.xz],
            [self.xy, self.yy, self.yz],
            [self.xz, self.yz, self.zz],
        ]
    }

    /// The inertia with the entries of a symmetric tensor, kg m².
    pub fn from_tensor(tensor: [[f64; 3]; 3]) -> Self {
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = tensor;
        Self::from([xx, yy, zz, xy, xz, yz])
    }

    /// The principal moments of inertia in increasing order, kg m²: the eigenvalues of the tensor.
    pub fn principal_kg_m2(&self) -> [f64; 3] {
        eigenpairs(self.tensor()).0
    }
}

/// The entries xx, yy, zz, xy, xz, yz, kg m².
impl From<[f64; 6]> for Inertia {
    fn from([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> Self {
        Self {
            xx,
            yy,
            zz,
            xy,
            xz,
            yz,
        }
    }
}

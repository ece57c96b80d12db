//! The inertia tensor of a rigid body.

use crate::inputs::{Input, Inputs, Limit};
use crate::symmetric::eigenpairs;

/// The inertia tensor of a rigid body about its own centre of mass, kg m².
///
/// Products of inertia are the entries of the tensor (xy = −∫ x y dm).
#[derive(Debug, Clone, Copy, PartialEq, Default, Inputs)]
pub struct Inertia {
    /// About the fore-aft axis (resists side-side rotation), kg m².
    #[input(entry("inertia.xx", Limit::Inertia, "the inertia about the fore-aft axis"))]
    pub xx: f64,
    /// About the side-side axis (resists fore-aft rotation), kg m².
    #[input(entry("inertia.yy", Limit::Inertia, "the inertia about the side-side axis"))]
    pub yy: f64,
    /// About the tower axis (resists torsion), kg m².
    #[input(entry("inertia.zz", Limit::Inertia, "the inertia about the tower axis"))]
    pub zz: f64,
    /// Entry xy = −∫ x y dm of the tensor, kg m².
    #[input(entry("inertia.xy", Limit::Elsewhere, "the entry xy of the inertia tensor"))]
    pub xy: f64,
    /// Entry xz = −∫ x z dm of the tensor, kg m².
    #[input(entry("inertia.xz", Limit::Elsewhere, "the entry xz of the inertia tensor"))]
    pub xz: f64,
    /// Entry yz = −∫ y z dm of the tensor, kg m².
    #[input(entry("inertia.yz", Limit::Elsewhere, "the entry yz of the inertia tensor"))]
    pub yz: f64,
}

/// An entry of the tensor; the check of the whole tensor limits it.
const fn entry(key: &'static str, limit: Limit, name: &'static str) -> Input {
    Input::new(key, " kg m2", limit, name).or(0.0).quiet()
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

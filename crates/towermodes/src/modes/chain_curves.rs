//! The curve of a mode of a chain of rigid bodies.
//!
//! A segment's springs are those of its exact static stiffness, so the motions of the bodies at the segment borders are those of beam
//! nodes. Between them the beam's own curve is drawn, not the rigid bodies' steps.

use super::sampling::SegmentCurves;
use super::shape::Cubic;
use crate::chain::{Chain, Dim, Space, motions, raise};
use crate::elements::Mesh;
use crate::tower::{Plane, Tower, compliance};

/// Working memory for turning a chain's eigenvectors into curves.
#[derive(Debug, Clone, Default)]
pub struct ChainCurvesWorkspace {
    planar: Motions<2>,
    linear: Motions<1>,
}

#[derive(Debug, Clone, Default)]
struct Motions<const D: usize> {
    bodies: Vec<[f64; D]>,
    borders: Vec<[f64; D]>,
}

/// The curves of one eigenvector of a chain.
pub struct ChainCurves<'a> {
    borders_m: &'a [f64],
    motion: BorderMotion<'a>,
}

/// The motion of the segment borders: deflection and rotation in bending, one value otherwise.
enum BorderMotion<'a> {
    /// With the plane of a tower that shears.
    Bending(&'a [[f64; 2]], Option<(&'a Tower, Plane)>),
    Axial(&'a [[f64; 1]]),
}

impl<'a> ChainCurves<'a> {
    /// Those of an eigenvector of a bending chain of a tower.
    pub fn bending(
        tower: &'a Tower,
        plane: Plane,
        mesh: &'a Mesh,
        chain: &Chain<2>,
        vector: &[f64],
        workspace: &'a mut ChainCurvesWorkspace,
    ) -> Self {
        workspace.planar.find(mesh, chain, vector);
        let shears = tower.shears().then_some((tower, plane));
        Self {
            borders_m: mesh.borders_m(),
            motion: BorderMotion::Bending(&workspace.planar.borders, shears),
        }
    }

    /// Those of an eigenvector of the torsion or the axial chain.
    pub fn axial(
        mesh: &'a Mesh,
        chain: &Chain<1>,
        vector: &[f64],
        workspace: &'a mut ChainCurvesWorkspace,
    ) -> Self {
        workspace.linear.find(mesh, chain, vector);
        Self {
            borders_m: mesh.borders_m(),
            motion: BorderMotion::Axial(&workspace.linear.borders),
        }
    }

    fn curve(&self, segment: usize) -> Cubic {
        let (base_m, top_m) = (self.borders_m[segment], self.borders_m[segment + 1]);
        match &self.motion {
            BorderMotion::Bending(motion, shears) => {
                let share = shears.map_or(0.0, |(tower, plane)| {
                    shear_share(tower, plane, base_m, top_m)
                });
                Cubic::beam(motion[segment], motion[segment + 1], top_m - base_m, share)
            }
            BorderMotion::Axial(motion) => {
                Cubic::line(motion[segment][0], motion[segment + 1][0], top_m - base_m)
            }
        }
    }
}

impl SegmentCurves for ChainCurves<'_> {
    fn motion(&self, segment: usize, s: f64) -> [f64; 2] {
        let curve = self.curve(segment);
        let rotation = match self.motion {
            BorderMotion::Bending(..) => curve.rotation(s),
            BorderMotion::Axial(_) => 0.0,
        };
        [curve.value(s), rotation]
    }

    fn extreme(&self, segment: usize) -> f64 {
        self.curve(segment).extreme()
    }
}

/// The share of a segment's sliding that is shear deformation.
fn shear_share(tower: &Tower, plane: Plane, base_m: f64, top_m: f64) -> f64 {
    let piece = tower.piece_at(0.5 * (base_m + top_m));
    let compliance = compliance(piece, base_m, top_m).bending.of(plane);
    compliance.shear_m_per_n / (compliance.shear_m_per_n + compliance.deflection_m_per_n)
}

impl<const D: usize> Motions<D>
where
    Dim<D>: Space,
{
    /// The motion at every segment border: that of the body that reaches over it.
    fn find(&mut self, mesh: &Mesh, chain: &Chain<D>, vector: &[f64]) {
        motions(chain, vector, &mut self.bodies);
        self.borders.clear();
        let mut body = 0;
        for &border_m in mesh.borders_m() {
            while body < chain.joints() && chain.joint_height_m(body) <= border_m {
                body += 1;
            }
            self.borders.push(match body.checked_sub(1) {
                None => [0.0; D],
                Some(joint) => {
                    let mut motion = self.bodies[joint];
                    raise(&mut motion, border_m - chain.joint_height_m(joint));
                    motion
                }
            });
        }
    }
}

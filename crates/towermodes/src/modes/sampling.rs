//! From a chain's joint coordinates to the shape of the tower.
//!
//! A segment's springs are those of its exact static stiffness, so the motions of the bodies at the segment borders are those of beam
//! nodes. Between them the beam's own curve is drawn, not the rigid bodies' steps.

use super::family::Family;
use super::shape::{Cubic, ShapePoint};
use crate::chain::{Chain, Dim, Space, motions, raise};
use crate::elements::{Mesh, Span};
use crate::tower::{Shear, compliance};

/// Working memory for turning eigenvectors into shapes.
#[derive(Debug, Clone, Default)]
pub struct ShapeWorkspace {
    planar: Motions<2>,
    linear: Motions<1>,
}

#[derive(Debug, Clone, Default)]
struct Motions<const D: usize> {
    bodies: Vec<[f64; D]>,
    borders: Vec<[f64; D]>,
}

/// A mode as curves over the segments, ready to be sampled.
#[derive(Debug)]
pub struct ModeCurve<'a> {
    mesh: &'a Mesh,
    motion: BorderMotion<'a>,
    is_sheared: bool,
    /// The largest motion, with the sign of the top's.
    largest: f64,
}

/// The motion of the segment borders: deflection and rotation in bending, one value otherwise.
#[derive(Debug, Clone, Copy)]
enum BorderMotion<'a> {
    Bending(&'a [[f64; 2]]),
    Axial(&'a [[f64; 1]]),
}

impl<'a> ModeCurve<'a> {
    /// The curve of an eigenvector of a bending chain.
    pub fn bending(
        mesh: &'a Mesh,
        chain: &Chain<2>,
        vector: &[f64],
        workspace: &'a mut ShapeWorkspace,
    ) -> Self {
        workspace.planar.find(mesh, chain, vector);
        Self::normalized(mesh, BorderMotion::Bending(&workspace.planar.borders))
    }

    /// The curve of an eigenvector of the torsion or the axial chain.
    pub fn axial(
        mesh: &'a Mesh,
        chain: &Chain<1>,
        vector: &[f64],
        workspace: &'a mut ShapeWorkspace,
    ) -> Self {
        workspace.linear.find(mesh, chain, vector);
        Self::normalized(mesh, BorderMotion::Axial(&workspace.linear.borders))
    }

    fn normalized(mesh: &'a Mesh, motion: BorderMotion<'a>) -> Self {
        let sheared = |span: &Span| span.piece.shear != Shear::Rigid;
        let mut curve = Self {
            mesh,
            motion,
            is_sheared: mesh.spans().iter().any(sheared),
            largest: 1.0,
        };
        let mut largest = 0.0_f64;
        for segment in 0..mesh.segments() {
            largest = largest.max(curve.segment(segment).extreme().abs());
        }
        let last = mesh.segments().saturating_sub(1);
        curve.largest = largest.copysign(curve.segment(last).value(1.0));
        curve
    }

    /// The number by which the eigenvector was divided.
    pub fn largest(&self) -> f64 {
        self.largest
    }

    /// The curve over one segment, before scaling.
    fn segment(&self, segment: usize) -> Cubic {
        let borders = &self.mesh.borders_m()[segment..segment + 2];
        let length_m = borders[1] - borders[0];
        match self.motion {
            BorderMotion::Bending(motion) => {
                let share = if self.is_sheared {
                    shear_share(self.mesh, segment)
                } else {
                    0.0
                };
                Cubic::beam(motion[segment], motion[segment + 1], length_m, share)
            }
            BorderMotion::Axial(motion) => {
                Cubic::line(motion[segment][0], motion[segment + 1][0], length_m)
            }
        }
    }

    /// The shape at heights (m) on the tower, as motion of the given family.
    pub fn sample(&self, family: Family, heights_m: &[f64]) -> Vec<ShapePoint> {
        let point = |&height_m: &f64| {
            let borders = self.mesh.borders_m();
            let above = borders.partition_point(|&border| border <= height_m);
            let segment = above.clamp(1, self.mesh.segments()) - 1;
            let s = (height_m - borders[segment]) / (borders[segment + 1] - borders[segment]);
            let curve = self.segment(segment);
            let (value, rotation) = (
                curve.value(s) / self.largest,
                curve.rotation(s) / self.largest,
            );
            shape_point(family, height_m, value, rotation)
        };
        heights_m.iter().map(point).collect()
    }
}

fn shape_point(family: Family, height_m: f64, value: f64, rotation: f64) -> ShapePoint {
    let (translation, rotation) = match family {
        Family::ForeAft | Family::SideSide => ([value, 0.0, 0.0], [0.0, rotation, 0.0]),
        Family::Axial => ([0.0, 0.0, value], [0.0; 3]),
        Family::Torsion => ([0.0; 3], [0.0, 0.0, value]),
    };
    let point = ShapePoint {
        height_m,
        translation,
        rotation,
    };
    match family {
        Family::SideSide => point.turned_to_side_side(),
        _ => point,
    }
}

/// The share of a segment's sliding that is shear deformation.
fn shear_share(mesh: &Mesh, segment: usize) -> f64 {
    let borders = &mesh.borders_m()[segment..segment + 2];
    let compliance = compliance(mesh.piece_of(segment), borders[0], borders[1]);
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

//! The curve of a mode of a chain of rigid bodies.
//!
//! A segment's springs are those of its exact static stiffness, so the motions of the bodies at the
//! segment borders are those of beam nodes. Between them the beam's own curve is drawn, not the
//! rigid bodies' steps.

use super::sampling::SegmentCurves;
use super::shape::Cubic;
use crate::chain::{Chain, Chains, motions};
use crate::elements::Mesh;
use crate::parts::{Part, embedded, on_components};
use crate::space::{Dim, Space, raise};
use crate::tower::{Motion, Motions, Plane, Tower, compliance};

/// The curves of one eigenvector of a chain.
pub struct ChainCurves<'a> {
    tower: &'a Tower,
    borders_m: &'a [f64],
    /// The motion of every segment border.
    borders: Vec<[f64; 6]>,
    motions: Motions,
}

impl<'a> ChainCurves<'a> {
    /// Those of an eigenvector of a part of a tower.
    pub fn new(tower: &'a Tower, mesh: &'a Mesh, part: &Part<Chains>, vector: &[f64]) -> Self {
        let mut borders = Vec::with_capacity(mesh.borders_m().len());
        on_components!(part, member, components => {
            border_motions(mesh, &member.structure, vector, |motion| {
                borders.push(embedded(motion, &components));
            });
        });
        Self {
            tower,
            borders_m: mesh.borders_m(),
            borders,
            motions: part.motions(),
        }
    }

    fn curve(&self, segment: usize, motion: Motion) -> Cubic {
        let (base_m, top_m) = (self.borders_m[segment], self.borders_m[segment + 1]);
        let (below, above) = (&self.borders[segment], &self.borders[segment + 1]);
        let components = motion.components();
        let own = |border: &[f64; 6], k: usize| components[k].1 * border[components[k].0];
        let length_m = top_m - base_m;
        match motion {
            Motion::Bending(plane) => {
                let share = shear_share(self.tower, plane, base_m, top_m);
                let (below, above) = (
                    [own(below, 0), own(below, 1)],
                    [own(above, 0), own(above, 1)],
                );
                Cubic::beam(below, above, length_m, share)
            }
            Motion::Torsion | Motion::Axial => Cubic::line(own(below, 0), own(above, 0), length_m),
        }
    }
}

impl SegmentCurves for ChainCurves<'_> {
    fn motion(&self, segment: usize, s: f64) -> [f64; 6] {
        let mut vector = [0.0; 6];
        for motion in self.motions.iter() {
            let curve = self.curve(segment, motion);
            let values = [curve.value(s), curve.rotation(s)];
            for ((component, sign), value) in motion.components().iter().zip(values) {
                vector[*component] = sign * value;
            }
        }
        vector
    }

    fn extreme(&self, segment: usize, component: usize) -> f64 {
        let mut moved = self.motions.iter();
        let motion = moved.find(|motion| motion.components()[0].0 == component);
        motion.map_or(0.0, |motion| self.curve(segment, motion).extreme())
    }
}

/// The share of a segment's sliding that is shear deformation.
fn shear_share(tower: &Tower, plane: Plane, base_m: f64, top_m: f64) -> f64 {
    if !tower.shears() {
        return 0.0;
    }
    let piece = tower.piece_at(0.5 * (base_m + top_m));
    let compliance = compliance(piece, base_m, top_m).bending.of(plane);
    compliance.shear_m_per_n / (compliance.shear_m_per_n + compliance.deflection_m_per_n)
}

/// Tells `visit` the motion at every segment border: that of the body that reaches over it.
fn border_motions<const D: usize>(
    mesh: &Mesh,
    chain: &Chain<D>,
    vector: &[f64],
    mut visit: impl FnMut(&[f64; D]),
) where
    Dim<D>: Space,
{
    let mut bodies = Vec::with_capacity(chain.joints());
    motions(chain, vector, &mut bodies);
    let mut body = 0;
    for &border_m in mesh.borders_m() {
        while body < chain.joints() && chain.joint_height_m(body) <= border_m {
            body += 1;
        }
        visit(&match body.checked_sub(1) {
            None => [0.0; D],
            Some(joint) => {
                let mut motion = bodies[joint];
                raise(&mut motion, border_m - chain.joint_height_m(joint));
                motion
            }
        });
    }
}

//! The curve of a mode of a chain of rigid bodies.
//!
//! A segment's springs are those of its exact static stiffness, so the motions of the bodies at the
//! segment borders are those of beam nodes. Between them the beam's own curve is drawn, not the
//! rigid bodies' steps.

use super::cubic::Cubic;
use super::model::Chain;
use super::product::motions;
use crate::space::transform_motion;
use crate::subsystem::{Coordinates, SegmentCurves, ShearFraction};
use crate::tower::{Motion, Motions};

/// The curves of one eigenvector of a chain.
pub(super) struct ChainCurves<'a> {
    borders_m: &'a [f64],
    shear: &'a ShearFraction<'a>,
    /// The motion at every segment border.
    borders: Vec<[f64; 6]>,
    motions: Motions,
}

impl<'a> ChainCurves<'a> {
    /// The curves of an eigenvector over segments with these borders, m.
    pub(super) fn new<const D: usize>(
        borders_m: &'a [f64],
        shear: &'a ShearFraction<'a>,
        chain: &Chain<D>,
        coordinates: &Coordinates<D>,
        vector: &[f64],
    ) -> Self {
        Self {
            borders_m,
            shear,
            borders: border_motions(borders_m, chain, coordinates, vector),
            motions: coordinates.motions(),
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
                let shear = (self.shear)(plane, base_m, top_m);
                let (below, above) = (
                    [own(below, 0), own(below, 1)],
                    [own(above, 0), own(above, 1)],
                );
                Cubic::beam(below, above, length_m, shear)
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

/// The motion at every segment border, that of the body that contains the border.
fn border_motions<const D: usize>(
    borders_m: &[f64],
    chain: &Chain<D>,
    coordinates: &Coordinates<D>,
    vector: &[f64],
) -> Vec<[f64; 6]> {
    let mut bodies = Vec::with_capacity(chain.joints());
    motions(chain, vector, &mut bodies);
    let mut body = 0;
    let motion_at = |&border_m: &f64| {
        while body < chain.joints() && chain.joint_height_m(body) <= border_m {
            body += 1;
        }
        let Some(joint) = body.checked_sub(1) else {
            return coordinates.expand(&[0.0; D]);
        };
        let mut motion = bodies[joint];
        transform_motion(&mut motion, border_m - chain.joint_height_m(joint));
        coordinates.expand(&motion)
    };
    borders_m.iter().map(motion_at).collect()
}

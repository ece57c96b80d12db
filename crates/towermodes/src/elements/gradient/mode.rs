//! The gradient of one mode: a walk up the chain that turns motions and forces into derivatives.
//!
//! Π = xᵀKx − λ xᵀMx with the motions of the joints held; dλ = dΠ/xᵀMx. Every term of Π is that of
//! a joint, a body or an attachment:
//!
//! | | Π | its derivative |
//! |---|---|---|
//! | flexibility c | y², y = F √c | −F² |
//! | mass at a height z | −λ v², −g D(z) | its factor |
//! | soil, foundation, wires | k v² | v² |
//! | lever to what is above with the load L | | 2 θ L |
//!
//! D(z) is twice the descent of a mass at z by the rotations below it: Σ θ² dz + 2 δ θ in each
//! joint.

use super::numbers::{MassFactors, Numbers};
use super::segments::{Joint, MASS_POINTS, Segment, Segments};
use crate::elements::Mesh;
use crate::subsystem::JointState;
use crate::tower::{Attachment, Places, Plane, SectionMasses, SoilStiffness, Tower};

/// A walk up the chain in a mode.
pub(super) struct Walk<'a> {
    pub(super) tower: &'a Tower,
    pub(super) segments: &'a Segments,
    /// λ, rad²/s².
    pub(super) lambda: f64,
    pub(super) rotary_inertia: bool,
    pub(super) numbers: Numbers<'a>,
    /// The joints that are still above.
    pub(super) states: &'a [JointState],
    pub(super) body: Body,
    /// The load of everything that is still above.
    pub(super) load: [f64; 2],
}

/// The rigid body at the current height of the walk.
#[derive(Clone, Copy, Default)]
pub(super) struct Body {
    /// Height of its joint, m, and its motion at this height.
    height_m: f64,
    motion: [f64; 6],
    /// D at the current height of the walk.
    descent: f64,
}

impl Body {
    fn at(&self, height_m: f64) -> [f64; 6] {
        let mut motion = self.motion;
        let rise_m = height_m - self.height_m;
        motion[0] += rise_m * motion[4];
        motion[1] -= rise_m * motion[3];
        motion
    }

    /// θ² in both planes.
    fn turning(&self) -> f64 {
        self.motion[3].powi(2) + self.motion[4].powi(2)
    }

    /// 2 L · d(translation)/d(rise).
    fn lever(&self, load: [f64; 2]) -> f64 {
        2.0 * (load[0] * self.motion[4] - load[1] * self.motion[3])
    }
}

/// The state of a joint of a segment in the mode.
#[derive(Default)]
struct Passed {
    strain: [f64; 6],
    /// The derivative with respect to the height of the joint in the segment.
    by_height: f64,
}

impl Walk<'_> {
    /// Walks up the whole tower; false if the chain is not that of the segments.
    pub(super) fn run(mut self, mesh: &Mesh) -> bool {
        self.begin();
        let mut attachments = self.tower.attachments().iter().enumerate().peekable();
        let mut index = 0;
        for (span, borders) in mesh.spans_with_borders() {
            if self.tower.pieces()[span.piece].base_m == span.base_m {
                self.pass_border(span.piece, span.base_m);
            }
            while let Some((place, attached)) =
                attachments.next_if(|(_, a)| a.height_m <= span.base_m)
            {
                self.pass_attachment(place, attached);
            }
            for _ in 1..borders.len() {
                self.pass_segment(index);
                index += 1;
            }
        }
        for (place, attached) in attachments {
            self.pass_attachment(place, attached);
        }
        self.pass_border(self.tower.pieces().len(), self.tower.top_m());
        self.states.is_empty()
    }

    /// Passes the base.
    fn begin(&mut self) {
        let Some((state, above)) = self.states.split_first().filter(|(s, _)| s.is_base) else {
            return;
        };
        self.states = above;
        let base = self.tower.base();
        self.stand_on(state, 0.0);
        let motion = self.body.motion;
        let (lambda, turning) = (self.lambda, self.body.turning());
        self.numbers
            .add_square(Places::BASE_STIFFNESS, 1.0, &motion);
        self.numbers
            .add_square(Places::BASE_INERTIA, -lambda, &motion);
        self.pass_matrices(&base.stiffness, &base.inertia, &motion);
        self.pass_overturning(Places::BASE_OVERTURNING, base.overturning_kg_m, turning);
    }

    fn stand_on(&mut self, state: &JointState, descent: f64) {
        self.body = Body {
            height_m: state.height_m,
            motion: state.motion,
            descent,
        };
        self.load = [state.load[0], state.load[1]];
    }

    /// Subtracts the load of a stiffness and an inertia.
    fn pass_matrices(
        &mut self,
        stiffness: &[[f64; 6]; 6],
        inertia: &[[f64; 6]; 6],
        motion: &[f64; 6],
    ) {
        for (row, load) in self.load.iter_mut().enumerate() {
            let rows = stiffness[row].iter().zip(&inertia[row]).zip(motion);
            *load -= rows
                .map(|((k, m), v)| (k - self.lambda * m) * v)
                .sum::<f64>();
        }
    }

    fn pass_overturning(&mut self, place: usize, overturning_kg_m: f64, turning: f64) {
        let gravity = self.tower.gravity_m_per_s2();
        self.numbers.add(place, -gravity * turning);
        self.numbers
            .add(Places::GRAVITY, -overturning_kg_m * turning);
    }

    fn pass_attachment(&mut self, index: usize, attached: &Attachment) {
        let motion = self.body.at(attached.height_m);
        let first = self.numbers.places.attachment(index);
        let (gravity, descent) = (self.tower.gravity_m_per_s2(), self.body.descent);
        self.numbers.add(first + 1, -gravity * descent);
        self.numbers
            .add(Places::GRAVITY, -attached.mass_kg * descent);
        self.pass_overturning(first + 2, attached.overturning_kg_m, self.body.turning());
        self.numbers.add_square(first + 3, -self.lambda, &motion);
        self.numbers.add_square(first + 39, 1.0, &motion);
        self.pass_matrices(&attached.stiffness, &attached.inertia, &motion);
    }

    /// Passes a border between pieces, where soil and water may begin or end.
    fn pass_border(&mut self, border: usize, height_m: f64) {
        let factors = self.factors(&self.body.at(height_m));
        let first = self.numbers.places.sliver(border);
        for (spring, factor) in factors.soil.into_iter().enumerate() {
            self.numbers.add(first + spring, factor);
        }
        self.numbers
            .add(first + SoilStiffness::SPRINGS, factors.water);
    }

    fn pass_segment(&mut self, index: usize) {
        let segments = self.segments;
        let segment = &segments.segments[index];
        let mut by_length = 0.0;
        let (mut below_m, mut mass) = (segment.base_m, segment.first_mass);
        let mut passed = [Passed::default(), Passed::default()];
        let joints = &segments.joints[segment.joints.clone()];
        let is_single = joints.len() == 1;
        for (joint, passed) in joints.iter().zip(&mut passed) {
            let ends = (below_m, joint.height_m);
            by_length += self.pass_body(index, mass, ends, joint.compression_n);
            *passed = self.pass_joint(joint, is_single);
            (below_m, mass) = (joint.height_m, mass + MASS_POINTS);
        }
        by_length += self.pass_body(
            index,
            mass,
            (below_m, segment.top_m),
            segment.top_compression_n,
        );
        by_length += self.flexibilities(index, segment, &passed);
        let length_m = segment.top_m - segment.base_m;
        self.numbers.add_length(index, by_length / length_m);
    }

    /// Passes the part of a body between two heights (m), above which there is a compression;
    /// returns the derivative with respect to the logarithm of its length.
    fn pass_body(
        &mut self,
        index: usize,
        first: usize,
        (base_m, top_m): (f64, f64),
        compression_n: f64,
    ) -> f64 {
        let segments = self.segments;
        let segment = &segments.segments[index];
        let gravity = self.tower.gravity_m_per_s2();
        let (lambda, turning) = (self.lambda, self.body.turning());
        let mut by_length = 0.0;
        let mut moment = 0.0;
        for point in &segments.masses[first..first + MASS_POINTS] {
            let (height_m, weight) = (point.at.height_m, point.at.weight_m);
            let motion = self.body.at(height_m);
            let rise_m = height_m - base_m;
            let descent = self.body.descent + turning * rise_m;
            let mut factors = self.factors(&motion);
            factors.mass -= gravity * descent;
            let masses = &point.masses;
            let transverse = masses.mass_kg_per_m + masses.water_kg_per_m;
            let load = [0, 1].map(|i| (point.soil[i] - lambda * transverse) * motion[i]);
            let by_rise = self.body.lever(load) - gravity * masses.mass_kg_per_m * turning;
            by_length += weight * (sum_of(&factors, masses, &point.soil) + rise_m * by_rise);
            moment += weight * masses.mass_kg_per_m * descent;
            for (sum, load) in self.load.iter_mut().zip(load) {
                *sum -= weight * load;
            }
            self.numbers.add_masses(segment, index, point, &factors);
        }
        self.numbers.add(Places::GRAVITY, -moment);
        let length_m = top_m - base_m;
        self.body.descent += turning * length_m;
        by_length + length_m * (self.body.lever(self.load) - compression_n * turning)
    }

    /// The factors of masses and springs for this motion.
    fn factors(&self, motion: &[f64; 6]) -> MassFactors {
        let [x, y, z, rx, ry, rz] = motion.map(|v| v * v);
        let lambda = self.lambda;
        let of_rotary = if self.rotary_inertia { -lambda } else { 0.0 };
        MassFactors {
            mass: -lambda * (x + y + z),
            water: -lambda * (x + y),
            rotary: [of_rotary * ry, of_rotary * rx],
            polar: -lambda * rz,
            soil: [x, y, z, rz, rx, ry],
        }
    }

    /// Passes a joint of a segment.
    fn pass_joint(&mut self, joint: &Joint, is_single: bool) -> Passed {
        let below = self.body;
        let mut passed = Passed::default();
        let (mut turned, mut jump, mut is_there) = ([0.0; 2], 0.0, false);
        while let Some((state, above)) = self.states.split_first() {
            let is_own = is_single || is_of(joint.plane, state);
            if state.height_m != joint.height_m || !is_own {
                break;
            }
            self.states = above;
            is_there = true;
            for (sum, strain) in passed.strain.iter_mut().zip(state.strain) {
                *sum += strain;
            }
            let (own, motion) = (&state.own, &state.motion);
            turned[0] += own[3];
            turned[1] += own[4];
            jump += 2.0 * (own[0] * motion[4] - own[1] * motion[3]);
            self.stand_on(state, below.descent);
        }
        if !is_there {
            return passed;
        }
        self.body.descent += jump;
        let (masses, soil) = (&joint.section.masses, joint.section.soil.values());
        let energy = |body: &Body| {
            let factors = self.factors(&body.at(joint.height_m));
            sum_of(&factors, masses, &soil)
        };
        let lever = 2.0 * (self.load[0] * turned[1] - self.load[1] * turned[0]);
        let gravity = self.tower.gravity_m_per_s2();
        passed.by_height = energy(&below) - energy(&self.body) - lever
            + gravity * masses.mass_kg_per_m * jump
            - joint.compression_n * (below.turning() - self.body.turning());
        passed
    }

    /// Adds the derivatives with respect to the flexibilities of a segment; returns that with
    /// respect to the logarithm of its length.
    fn flexibilities(&mut self, index: usize, segment: &Segment, passed: &[Passed; 2]) -> f64 {
        let segments = self.segments;
        let [lower, upper] = passed;
        let strain: [f64; 6] = std::array::from_fn(|i| lower.strain[i] + upper.strain[i]);
        let compliance = &segment.compliance;
        let planes = [
            (compliance.bending.fore_aft, strain[0], strain[4], lower),
            (compliance.bending.side_side, strain[1], strain[3], upper),
        ];
        let mut by_length = -strain[2] - strain[5];
        for (plane, sliding, turning, _) in &planes {
            let (bent, sheared) = (plane.deflection_m_per_n, plane.shear_m_per_n);
            by_length -= turning + per(*sliding, bent + sheared) * (3.0 * bent + sheared);
        }
        let axial = -per(strain[2], compliance.axial_m_per_n);
        let torsion = -per(strain[5], compliance.torsion_per_n_m);
        let planes = planes.map(|(plane, sliding, turning, passed)| {
            let of_force = per(sliding, plane.deflection_m_per_n + plane.shear_m_per_n);
            let of_moment = per(turning, plane.bending_per_n_m);
            let of_centre = passed.by_height / plane.bending_per_n_m;
            (plane.elastic_centre_m, of_force, of_moment, of_centre)
        });
        for point in &segments.flexible[segment.flexible.clone()] {
            let bending = planes.map(|(centre_m, of_force, of_moment, of_centre)| {
                let arm_m = point.at.height_m - centre_m;
                of_centre * arm_m - of_moment - of_force * arm_m * arm_m
            });
            let [a, b] = bending;
            let factors = [a, b, axial, torsion, -planes[0].1, -planes[1].1];
            self.numbers.add_flexible(segment, index, point, &factors);
        }
        by_length
    }
}

/// Whether a joint belongs to a plane, if the planes have separate joints: axial and torsional
/// springs belong to fore-aft bending.
fn is_of(plane: Plane, state: &JointState) -> bool {
    let [x, y, z, rx, ry, rz] = state.moves;
    match plane {
        Plane::ForeAft => !(y || rx),
        Plane::SideSide => !(x || z || ry || rz),
    }
}

/// y²/c = F²; zero if the joint is rigid.
fn per(strain: f64, flexibility: f64) -> f64 {
    match flexibility == 0.0 {
        true => 0.0,
        false => strain / flexibility,
    }
}

/// The sum of the factors times their values.
fn sum_of(
    factors: &MassFactors,
    masses: &SectionMasses,
    soil: &[f64; SoilStiffness::SPRINGS],
) -> f64 {
    let rotary = masses.rotary_inertia_kg_m;
    let springs = factors.soil.iter().zip(soil).map(|(f, k)| f * k);
    factors.mass * masses.mass_kg_per_m
        + factors.water * masses.water_kg_per_m
        + factors.rotary[0] * rotary.fore_aft
        + factors.rotary[1] * rotary.side_side
        + factors.polar * masses.polar_inertia_kg_m
        + springs.sum::<f64>()
}

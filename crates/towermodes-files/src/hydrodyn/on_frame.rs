//! The water of strip members on the members of a frame.
//!
//! A circular strip member that lies on a beam gives coats of that beam. Any other one is divided
//! into pieces, each of which moves rigidly with the nearest point of the nearest beam, as
//! HydroDyn's nodes move with the nearest nodes of SubDyn. A rectangle has no coat, because its
//! added mass depends on the direction.

use towermodes::RigidBody;
use towermodes::frame::{FrameCoat, FrameDescription, FrameRider, JointKind};
use towermodes::space::SpatialMatrix;

use super::beams::{self, Beam, Lying};
use super::coats::reversed;
use super::ends::StripEnd;
use super::input::HydrodynInput;
use super::section::{Form, blend};
use super::spatial::{NONE, add, difference, norm, of_body, of_mass};
use super::strip::{Stretch, StripMember};
use super::strip_inertia::slices;
use crate::note::Note;

/// Length of the pieces that move with the nearest beam, m.
const PIECE_M: f64 = 1.0;
/// Largest number of pieces of a frame; if there would be more, the pieces are longer.
const MOST_PIECES: f64 = 10_000.0;
/// Parts shorter than this share of a member are rounding errors.
const NO_PART: f64 = 1e-9;
/// A joint belongs to the frame if its distance from a joint of the frame is smaller than this, m.
const SAME_JOINT_M: f64 = 1e-3;

impl HydrodynInput {
    /// Adds the water, growth and filling of the strip members to a frame: coats of beams on which
    /// they lie, riders of beams near them, masses of joints. The potential-flow body, AddCLin and
    /// AddF0 are not included. The notes state differences from the positions in the file.
    pub fn put_on_frame(&self, frame: &mut FrameDescription) -> Vec<Note> {
        let beams = beams::of(frame);
        let at_file = |note: Note| note.at(&self.sources[0], 0);
        let moving = self
            .members
            .iter()
            .any(|member| member.stretches.iter().any(Stretch::moves));
        if beams.is_empty() {
            let message = "the substructure has no beams: the water on its members is left out";
            return moving
                .then(|| at_file(Note::left_out(message)))
                .into_iter()
                .collect();
        }
        let mut carried = Carried {
            density_kg_per_m3: self.water.density_kg_per_m3,
            piece_m: self.piece_m(),
            beams: &beams,
            length_m: 0.0,
            rectangles_m: 0.0,
            solid_kg: 0.0,
            frame,
        };
        for member in &self.members {
            let lying = beams::lying(member, &beams);
            for stretch in member.stretches.iter().filter(|stretch| stretch.moves()) {
                match stretch.section.form() {
                    Form::Circle => carried.put(member, stretch, &lying),
                    Form::Rectangle => carried.put_rectangle(member, stretch),
                }
            }
        }
        for end in &self.ends {
            carried.put_end(end);
        }
        carried.notes().into_iter().map(at_file).collect()
    }

    fn piece_m(&self) -> f64 {
        let length_m: f64 = self.members.iter().map(StripMember::length_m).sum();
        PIECE_M.max(length_m / MOST_PIECES)
    }
}

/// A frame to which strip members are added.
struct Carried<'f> {
    frame: &'f mut FrameDescription,
    beams: &'f [Beam],
    density_kg_per_m3: f64,
    piece_m: f64,
    /// Length of strip members that lie on no beam, m.
    length_m: f64,
    /// Length of rectangular strip members, m.
    rectangles_m: f64,
    /// Mass of growth and filling of these strip members, kg.
    solid_kg: f64,
}

impl Carried<'_> {
    /// Adds a stretch to the frame.
    fn put(&mut self, member: &StripMember, stretch: &Stretch, lying: &[Lying]) {
        let [mut from, to] = stretch.range;
        for part in lying {
            let range = [part.range[0].max(from), part.range[1].min(to)];
            if range[1] - range[0] > NO_PART {
                self.ride(member, stretch, [from, range[0]]);
                self.coat(stretch, part, range);
                from = range[1];
            }
        }
        self.ride(member, stretch, [from, to]);
    }

    /// Adds a rectangular stretch to the frame.
    fn put_rectangle(&mut self, member: &StripMember, stretch: &Stretch) {
        let [from, to] = stretch.range;
        self.rectangles_m += (to - from) * member.length_m();
        self.ride_pieces(member, stretch, stretch.range);
    }

    /// Adds coats to the beam under the part of a stretch between two fractions of the strip
    /// member.
    fn coat(&mut self, stretch: &Stretch, lying: &Lying, range: [f64; 2]) {
        let coats = stretch.coats(range.map(|at| local(stretch, at)), self.density_kg_per_m3);
        let [first, last] = range.map(|at| lying.beam_fraction(at));
        let is_reversed = first > last;
        let range = [first.min(last), first.max(last)];
        if range[0] < range[1] {
            let coats = coats.into_iter().map(|kind| FrameCoat {
                range,
                kind: if is_reversed { reversed(kind) } else { kind },
            });
            self.frame.members[lying.member].coats.extend(coats);
        }
    }

    /// Adds the part of a stretch between two fractions of the strip member as riders of the
    /// nearest beams.
    fn ride(&mut self, member: &StripMember, stretch: &Stretch, range: [f64; 2]) {
        if range[1] - range[0] <= NO_PART {
            return;
        }
        self.length_m += (range[1] - range[0]) * member.length_m();
        self.ride_pieces(member, stretch, range);
    }

    fn ride_pieces(&mut self, member: &StripMember, stretch: &Stretch, range: [f64; 2]) {
        let length_m = (range[1] - range[0]) * member.length_m();
        let pieces = (length_m / self.piece_m).ceil().max(1.0);
        let [from, to] = range.map(|at| local(stretch, at));
        for piece in 0..pieces as usize {
            let at = |index: usize| from + (to - from) * index as f64 / pieces;
            self.ride_piece(member, stretch, [at(piece), at(piece + 1)]);
        }
    }

    fn ride_piece(&mut self, member: &StripMember, stretch: &Stretch, part: [f64; 2]) {
        let middle = blend(stretch.range, 0.5 * (part[0] + part[1]));
        let Some((beam, fraction, foot_m)) = beams::nearest(member.point_m(middle), self.beams)
        else {
            return;
        };
        let (axes, length_m) = (member.axes(), member.length_m());
        let stretch_m = length_m * (stretch.range[1] - stretch.range[0]);
        let mut inertia = NONE;
        for slice in slices(member, stretch, part) {
            let density = self.density_kg_per_m3;
            let masses = stretch.added_mass(slice.fraction, stretch_m, &axes, density);
            let arm_m = difference(slice.center_m, foot_m);
            add(&mut inertia, slice.length_m, &of_mass(&masses, arm_m));
            for ring in stretch.solids(slice.fraction) {
                let disc = ring.disc(&slice, &axes);
                self.solid_kg += disc.mass_kg;
                add(&mut inertia, 1.0, &of_body(&disc, foot_m));
            }
        }
        self.add_rider(beam, fraction, inertia);
    }

    fn add_rider(&mut self, member: usize, fraction: f64, inertia: SpatialMatrix) {
        self.frame.riders.push(FrameRider {
            member,
            fraction,
            inertia,
        });
    }

    /// Adds the end of strip members to a joint, or to the nearest beam.
    fn put_end(&mut self, end: &StripEnd) {
        let is_it =
            |position_m: [f64; 3]| norm(difference(position_m, end.position_m)) <= SAME_JOINT_M;
        let joint = self
            .frame
            .joints
            .iter()
            .position(|joint| is_it(joint.position_m));
        let growth = |i: usize, j: usize| if i == j { end.growth_kg } else { 0.0 };
        let masses = end.added_mass;
        let whole = std::array::from_fn(|i| std::array::from_fn(|j| masses[i][j] + growth(i, j)));
        match joint {
            Some(joint) if self.frame.joints[joint].kind == JointKind::Cantilever => {
                if masses != [[0.0; 3]; 3] {
                    let matrix = of_mass(&masses, [0.0; 3]);
                    self.frame.added_masses.push((joint, matrix));
                }
                if end.growth_kg > 0.0 {
                    let body = RigidBody::point(end.growth_kg, [0.0; 3]);
                    self.frame.masses.push((joint, body));
                }
            }
            Some(joint) => self
                .frame
                .added_masses
                .push((joint, of_mass(&whole, [0.0; 3]))),
            None => {
                if let Some((beam, fraction, foot_m)) = beams::nearest(end.position_m, self.beams) {
                    let arm_m = difference(end.position_m, foot_m);
                    self.add_rider(beam, fraction, of_mass(&whole, arm_m));
                }
            }
        }
    }

    fn notes(&self) -> Vec<Note> {
        let mut notes = Vec::new();
        // Joints of both modules may differ in their last digit.
        if self.length_m > self.piece_m {
            let message = format!(
                "members of HydroDyn with a total length of {:.0} m do not coincide with members of the substructure: the added mass of their water is attached rigidly to the nearest point of the nearest member, in pieces of {:.0} m",
                self.length_m, self.piece_m
            );
            notes.push(Note::approximation(message));
        }
        if self.rectangles_m > 0.0 {
            let message = format!(
                "{:.0} m of members are rectangular: their water, growth and filling move rigidly with the nearest point of the nearest member, in pieces of {:.0} m",
                self.rectangles_m, self.piece_m
            );
            notes.push(Note::approximation(message));
        }
        let rides = self.rectangles_m > 0.0 || self.length_m > self.piece_m;
        if self.solid_kg > 0.0 && rides {
            let message = format!(
                "the weight of {:.0} kg of growth and filling on these members is left out of the geometric stiffness",
                self.solid_kg
            );
            notes.push(Note::approximation(message));
        }
        notes
    }
}

/// The fraction of a stretch for a fraction of its member.
fn local(stretch: &Stretch, at: f64) -> f64 {
    let [from, to] = stretch.range;
    ((at - from) / (to - from)).clamp(0.0, 1.0)
}

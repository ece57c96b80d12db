//! The axial forces of members at rest under weight, for their geometric stiffness.
//!
//! K u = f with the weights f; the force in a beam follows from its elongation, less what its own
//! distributed weight and the friction of soil along it elongate.
//!
//! The water around a member carries the weight of what the member displaces, growth included. With
//! weights in water on all members the force is the effective tension T + pₑ Aₑ − pᵢ Aᵢ, with the
//! pressures and areas outside and inside of the wall. The transverse forces of the pressures on a
//! bent tube are those of such a tension, so it is what changes the stiffness, with ends that are
//! closed or open (Sparks 1984, *The influence of tension, pressure and weight on pipe and riser
//! deformations and stresses*, J. Energy Resour. Technol. 106; not checked against the original).

use super::assembly::{Assembled, Carrier, PlacedElement, Purpose};
use super::elimination::Factors;
use super::equations::{ELASTIC, Equations, GROUND, INERTIA, KINDS, motion_of};
use super::order::Order;
use super::rigid::{Motion, Vector};
use super::tension::{ForcesAtRest, Tension, tension_at};
use super::turning_over::of_rigid_links;
use crate::tower::frame::{CoatKind, Frame, FrameDescription, FrameFoundation};

/// Points of Gauss's rule on [0, 1] and their weights: exact for degree 7.
const GAUSS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// The loads of a frame at rest.
#[derive(Debug, Clone, Copy)]
pub(super) struct AtRest {
    /// Gravity, m/s².
    pub(super) gravity_m_per_s2: f64,
    /// Whether water carries the weight of the water displaced by members.
    pub(super) has_buoyancy: bool,
}

impl AtRest {
    /// For a frame under a tower, with gravity in m/s².
    pub(super) fn under_tower(foundation: &FrameFoundation, gravity_m_per_s2: f64) -> Self {
        Self {
            gravity_m_per_s2: foundation.gravity_on_members(gravity_m_per_s2),
            has_buoyancy: foundation.buoyancy_on_members,
        }
    }
}

/// A frame with only the masses that have weight, reduced by the displaced water.
fn weighed(frame: &Frame, has_buoyancy: bool) -> FrameDescription {
    let mut description = frame.description().clone();
    description.added_masses.clear();
    description.riders.clear();
    let members = description.members.iter_mut();
    for coat in members.flat_map(|member| &mut member.coats) {
        if let CoatKind::AddedMass {
            density_kg_per_m3,
            radius_m,
            ..
        } = coat.kind
        {
            let carried = match has_buoyancy {
                true => -density_kg_per_m3,
                false => 0.0,
            };
            coat.kind = CoatKind::Solid {
                density_kg_per_m3: [carried; 2],
                outer_radius_m: radius_m,
                inner_radius_m: [0.0; 2],
            };
        }
    }
    description
}

/// The forces in a frame at rest; none if the stiffness is not positive.
fn forces_at_rest(frame: &Frame, at_rest: &Assembled, gravity_m_per_s2: f64) -> ForcesAtRest {
    let (equations, elements) = (&at_rest.equations, &at_rest.elements);
    let order = Order::new(equations);
    let mut factors = Factors::default();
    let mut stiffness = [0.0; KINDS];
    (stiffness[GROUND], stiffness[ELASTIC]) = (1.0, 1.0);
    if equations.factorize(&order, (&stiffness, 1.0), &mut factors) != 0 {
        return ForcesAtRest::default();
    }
    let mut x = equations.weight(gravity_m_per_s2);
    equations.solve(&order, &mut factors, &mut x);
    let mut motions = Vec::new();
    equations.set_motions(&x, &mut motions);
    let tension = |element: &PlacedElement| {
        let moved = Moved {
            elongation_m: elongation_m(equations, &motions, &x, element, frame),
            from_m: from_m(equations, &motions, element, frame),
        };
        (
            element.edge,
            tension_of(frame, element, &moved, gravity_m_per_s2),
        )
    };
    ForcesAtRest {
        tensions: elements.iter().map(tension).collect(),
        turning: of_rigid_links(equations, &at_rest.rigid_links, &x, gravity_m_per_s2),
    }
}

impl Equations {
    /// Jᵀ f for the weights of everything.
    fn weight(&self, gravity_m_per_s2: f64) -> Vec<f64> {
        let mut out = vec![0.0; self.unknowns];
        let mut factors = [0.0; KINDS];
        factors[INERTIA] = -gravity_m_per_s2;
        self.loads_of_rigid_motion(&factors, [0.0, 0.0, 1.0, 0.0, 0.0, 0.0], &mut out);
        out
    }
}

/// The axis of the member of an element, from its first joint to its second.
fn axis(frame: &Frame, element: &PlacedElement) -> Vector {
    let [_, _, z] = frame.axes(&frame.description().members[element.member]);
    z
}

/// The elongation of an element, m.
fn elongation_m(
    equations: &Equations,
    motions: &[Motion],
    x: &[f64],
    element: &PlacedElement,
    frame: &Frame,
) -> f64 {
    let axis = axis(frame, element);
    let along = |motion: &Motion| axis.iter().zip(motion).map(|(a, m)| a * m).sum::<f64>();
    match element.carrier {
        Carrier::Link(index) => {
            let link = &equations.links[index];
            let own = &x[link.first..];
            let moved = link
                .tip
                .iter()
                .zip(own)
                .map(|(column, y)| along(column) * y);
            // From the second joint to the first the far end moves against the axis.
            let sign = if element.reversed { -1.0 } else { 1.0 };
            sign * moved.sum::<f64>()
        }
        Carrier::Chord(index) => {
            let [near, far] = equations.chords[index]
                .ends
                .map(|end| motion_of(motions, end));
            // A rigid motion does not elongate: the rotation moves the far end across the axis.
            along(&far) - along(&near)
        }
    }
}

/// The axial displacement of the lower end of an element, in the direction of the axis of its
/// member, m.
fn from_m(
    equations: &Equations,
    motions: &[Motion],
    element: &PlacedElement,
    frame: &Frame,
) -> f64 {
    let node = match element.carrier {
        Carrier::Link(index) => {
            let link = &equations.links[index];
            match element.reversed {
                true => Some(link.child),
                false => link.parent,
            }
        }
        Carrier::Chord(index) => equations.chords[index].ends[0],
    };
    let motion = motion_of(motions, node);
    axis(frame, element)
        .iter()
        .zip(motion)
        .map(|(a, m)| a * m)
        .sum()
}

/// The axial displacements of an element.
struct Moved {
    /// Elongation, m.
    elongation_m: f64,
    /// Displacement of its beginning on the member, m.
    from_m: f64,
}

fn tension_of(
    frame: &Frame,
    element: &PlacedElement,
    moved: &Moved,
    gravity_m_per_s2: f64,
) -> Tension {
    let member = &frame.description().members[element.member];
    let member_m = frame.length_m(member);
    let (from, to) = (element.from, element.to);
    let length_m = member_m * (to - from);
    let section = |s: f64| {
        let inside = s.clamp(1e-12, 1.0 - 1e-12);
        member.section_at(from + inside * (to - from), member_m)
    };
    let axial_n = |s: f64| section(s).map_or(f64::INFINITY, |section| section.axial_n);
    let mass = |s: f64| section(s).map_or(0.0, |section| section.masses.mass_kg_per_m);
    let [_, _, rise] = axis(frame, element);
    // The weight beyond a point, along the axis towards the second joint.
    let beyond_n = |s: f64| {
        let beyond = GAUSS.map(|(at, weight)| weight * mass(s + at * (1.0 - s)));
        -gravity_m_per_s2 * rise * (1.0 - s) * length_m * beyond.iter().sum::<f64>()
    };
    let flexibility: f64 = GAUSS.iter().map(|(s, weight)| weight / axial_n(*s)).sum();
    let by_weight: f64 = GAUSS
        .iter()
        .map(|(s, weight)| weight * beyond_n(*s) / axial_n(*s))
        .sum();
    let at_end_n =
        |by_soil: f64| (moved.elongation_m / length_m - by_weight - by_soil) / flexibility;
    let soil = |s: f64| -> f64 {
        let at = from + s.clamp(1e-12, 1.0 - 1e-12) * (to - from);
        member.soil.iter().map(|soil| soil.axial_n_per_m2(at)).sum()
    };
    let springs: Tension = at_points(soil);
    let no_soil: Tension = at_points(|s| at_end_n(0.0) + beyond_n(s));
    if springs == [0.0; 5] {
        return no_soil;
    }
    let mut tension_n = no_soil;
    for _ in 0..SOIL_STEPS {
        let strain = |s: f64| tension_at(&tension_n, s) / axial_n(s);
        let moved_m = |s: f64| moved.from_m + length_m * integral([0.0, s], strain);
        let friction_n_per_m: Tension = at_points(|s| -tension_at(&springs, s) * moved_m(s));
        let friction_n =
            |s: f64| length_m * integral([s, 1.0], |s| tension_at(&friction_n_per_m, s));
        let by_soil = integral([0.0, 1.0], |s| friction_n(s) / axial_n(s));
        tension_n = at_points(|s| at_end_n(by_soil) + beyond_n(s) + friction_n(s));
    }
    tension_n
}

/// Number of iterations: the friction of the soil depends on the displacement, which depends on the
/// forces. The corrections decrease by a factor of (length/√(EA/k))²/10 or faster.
const SOIL_STEPS: usize = 8;

fn at_points(value: impl Fn(f64) -> f64) -> Tension {
    std::array::from_fn(|k| value(k as f64 / 4.0))
}

fn integral([from, to]: [f64; 2], value: impl Fn(f64) -> f64) -> f64 {
    let points = GAUSS.iter();
    let sum: f64 = points
        .map(|(at, weight)| weight * value(from + at * (to - from)))
        .sum();
    (to - from) * sum
}

/// The equations of a frame and the parts on it, with the geometric stiffness of the forces at
/// rest.
pub(super) fn with_tensions<E>(
    frame: &Frame,
    at_rest: AtRest,
    assemble: impl Fn(&Frame, &ForcesAtRest, Purpose) -> Result<Assembled, E>,
    mut carry: impl FnMut(&mut Assembled),
) -> Result<Assembled, E> {
    let mut forces = ForcesAtRest::default();
    let AtRest {
        gravity_m_per_s2,
        has_buoyancy,
    } = at_rest;
    if gravity_m_per_s2 != 0.0 {
        let heavy = Frame::unchecked(weighed(frame, has_buoyancy));
        let mut at_rest = assemble(&heavy, &forces, Purpose::Rest)?;
        carry(&mut at_rest);
        forces = forces_at_rest(&heavy, &at_rest, gravity_m_per_s2);
    }
    let mut assembled = assemble(frame, &forces, Purpose::Shapes)?;
    carry(&mut assembled);
    Ok(assembled)
}

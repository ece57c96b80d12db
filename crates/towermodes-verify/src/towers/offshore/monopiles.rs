//! Monopiles of OC3 and of the IEA-15 turbine.

use towermodes::frame::{FrameDescription, FrameJoint, FrameMember, FrameSupport, Transition};
use towermodes::tower::Tube;
use towermodes::{Material, RigidBody};

use super::water::Sea;

/// The pile of OC3 from the mudline to the tower, in air or in water.
pub fn oc3_monopile(is_wet: bool) -> FrameDescription {
    let tube = Tube {
        outer_diameter_m: 6.0,
        wall_thickness_m: 0.06,
    };
    let steel = Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10);
    let heights = [-20.0001, -10.0, 0.0, 10.0];
    let mut pile = pile(&heights, |_| [tube; 2], steel);
    if is_wet {
        let sea = Sea {
            density_kg_per_m3: 1027.0,
            bed_m: -20.0,
            growth: None,
        };
        sea.add_to(&mut pile);
    }
    pile
}

/// Wall thicknesses of the pile of the IEA-15 turbine for lengths of 5 m from the mudline, m.
const WALLS: [f64; 9] = [
    0.055341, 0.053449, 0.051509, 0.049527, 0.047517, 0.045517, 0.043527, 0.042242, 0.041058,
];

/// The pile of the IEA-15 turbine in air, with members of a millimetre between its walls and a
/// body of 100 t at its top.
pub fn iea_15_monopile() -> FrameDescription {
    let steel = Material::from_shear_modulus(7800.0, 2e11, 7.93e10);
    // A wall changes in the lowest millimetre of its stretch.
    let stretch = |k: i32| [-29.999, -25.0].map(|z| z + 5.0 * f64::from(k));
    let mut heights = vec![-30.0];
    heights.extend((0..9).flat_map(stretch));
    let wall = |index: usize| WALLS[index / 2];
    let sections = |member: usize| {
        let tube = |wall_thickness_m| Tube {
            outer_diameter_m: 10.0,
            wall_thickness_m,
        };
        let below = if member.is_multiple_of(2) {
            member.saturating_sub(1)
        } else {
            member
        };
        [tube(wall(below)), tube(wall(member))]
    };
    let mut pile = pile(&heights, sections, steel);
    let inertia_kg_m2 = towermodes::Inertia::from([1.25e6, 1.25e6, 2.5e6, 0.0, 0.0, 0.0]);
    let body = RigidBody {
        mass_kg: 1e5,
        center_m: [0.0; 3],
        inertia_kg_m2,
    };
    pile.masses.push((heights.len() - 1, body));
    pile
}

/// A pile between heights (m), clamped at the lowest, with a tower on the highest.
fn pile(
    heights_m: &[f64],
    section: impl Fn(usize) -> [Tube; 2],
    material: Material,
) -> FrameDescription {
    let number = |index: usize| (index + 1).to_string();
    let joint = |(k, z): (usize, &f64)| FrameJoint::new(number(k), [0.0, 0.0, *z]);
    let member = |k: usize| FrameMember::tube(number(k), [k, k + 1], section(k), material);
    let top = heights_m.len() - 1;
    FrameDescription {
        joints: heights_m.iter().enumerate().map(joint).collect(),
        members: (0..top).map(member).collect(),
        supports: vec![FrameSupport::clamped(0)],
        transition: Some(Transition {
            position_m: [0.0, 0.0, heights_m[top]],
            joints: vec![top],
            is_held: false,
        }),
        ..FrameDescription::default()
    }
}

//! The jacket of OC4: four legs with braces, in water.

use towermodes::frame::{FrameDescription, FrameJoint, FrameMember, FrameSupport, Transition};
use towermodes::tower::Tube;
use towermodes::{Inertia, Material, RigidBody};

use super::water::{Growth, Sea};

/// Heights of the joints of a leg, m, with their distance from the planes x = 0 and y = 0, and the
/// section of the leg above each joint: the pile, the grouted pile, the leg with two wall
/// thicknesses, its head.
const LEG: [(f64, f64, Option<usize>); 12] = [
    (-50.001, 6.0, Some(5)),
    (-49.5, 6.0, Some(4)),
    (-45.5, 6.0, Some(1)),
    (-45.0, 6.0, Some(1)),
    (-44.001, 5.967, Some(1)),
    (-43.127, 5.939, Some(1)),
    (-24.614, 5.333, Some(2)),
    (-8.922, 4.82, Some(2)),
    (4.378, 4.385, Some(2)),
    (15.651, 4.016, Some(2)),
    (16.15, 4.0, Some(3)),
    (20.15, 4.0, None),
];
/// The legs: signs of x and y.
const LEGS: [[f64; 2]; 4] = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
/// Height and distance from the axis of the brace crossings, m. Crossing k is above the leg joint 5
/// + k, at which its braces begin.
const CROSSINGS: [[f64; 2]; 4] = [
    [-33.373, 5.62],
    [-16.371, 5.064],
    [-1.958, 4.592],
    [10.262, 4.193],
];
/// The index of the leg joint at which the lowest braces begin, and of the leg joint with the
/// horizontal braces.
const FIRST: usize = 5;
const HORIZONTAL: usize = 4;
/// Diameter and wall thickness, m: of the braces, then of the sections of the legs.
const SECTIONS: [[f64; 2]; 6] = [
    [0.8, 0.02],
    [1.2, 0.05],
    [1.2, 0.035],
    [1.2, 0.04],
    [2.082, 0.491],
    [2.082, 0.06],
];
/// Density of the grouted pile, kg/m³.
const GROUTED_KG_PER_M3: f64 = 3339.12;
/// Number of leg joints below the last flooded member, which extends above the water level.
const FLOODED: usize = 8;

/// The sea around the jacket: growth of 0.1 m, water in the legs.
pub(super) const SEA: Sea = Sea {
    density_kg_per_m3: 1025.0,
    bed_m: -50.0,
    growth: Some(Growth {
        range_m: [-40.0, -2.0],
        thickness_m: 0.1,
        density_kg_per_m3: 1100.0,
    }),
};

/// The jacket in air or in water, with its transition piece free, fixed or omitted.
pub fn jacket(is_wet: bool, is_held: bool) -> FrameDescription {
    let joint = |leg: usize, level: usize| leg * LEG.len() + level;
    let crossing = |level: usize, side: usize| LEGS.len() * LEG.len() + level * LEGS.len() + side;
    let mut frame = FrameDescription {
        joints: joints(),
        ..FrameDescription::default()
    };
    for leg in 0..LEGS.len() {
        for (level, (_, _, section)) in LEG.iter().enumerate() {
            if let Some(section) = section {
                let ends = [joint(leg, level), joint(leg, level + 1)];
                add(&mut frame, ends, *section, level < FLOODED && is_wet);
            }
        }
        // From this leg to the next one.
        let next = (leg + 1) % LEGS.len();
        add(
            &mut frame,
            [joint(leg, HORIZONTAL), joint(next, HORIZONTAL)],
            0,
            false,
        );
        for level in 0..CROSSINGS.len() {
            let centre = crossing(level, leg);
            for (leg, level) in [
                (leg, level),
                (next, level),
                (leg, level + 1),
                (next, level + 1),
            ] {
                add(&mut frame, [joint(leg, FIRST + level), centre], 0, false);
            }
        }
    }
    if is_wet {
        SEA.add_to(&mut frame);
    }
    frame.supports = (0..4)
        .map(|leg| FrameSupport::clamped(joint(leg, 0)))
        .collect();
    let carrying = (0..4).flat_map(|leg| [joint(leg, 10), joint(leg, 11)]);
    frame.transition = Some(Transition {
        position_m: [0.0, 0.0, TRANSITION_M],
        joints: carrying.collect(),
        is_held,
    });
    frame
}

/// Height of the reference point of the transition piece, m.
const TRANSITION_M: f64 = 18.15;

/// The transition piece of concrete.
pub fn transition_piece() -> RigidBody {
    RigidBody {
        mass_kg: 666e3,
        center_m: [0.0; 3],
        inertia_kg_m2: Inertia::from([6_002_880.0, 6_002_880.0, 10_229_800.0, 0.0, 0.0, 0.0]),
    }
}

fn joints() -> Vec<FrameJoint> {
    let mut joints = Vec::new();
    let mut add = |position_m: [f64; 3]| {
        joints.push(FrameJoint::new((joints.len() + 1).to_string(), position_m));
    };
    for [x, y] in LEGS {
        for (height_m, side_m, _) in LEG {
            add([x * side_m, y * side_m, height_m]);
        }
    }
    for [height_m, side_m] in CROSSINGS {
        for (leg, [x, y]) in LEGS.iter().enumerate() {
            let [other_x, other_y] = LEGS[(leg + 1) % LEGS.len()];
            let middle = |a: f64, b: f64| 0.5 * (a + b) * side_m;
            add([middle(*x, other_x), middle(*y, other_y), height_m]);
        }
    }
    joints
}

fn add(frame: &mut FrameDescription, ends: [usize; 2], section: usize, is_flooded: bool) {
    let [outer_diameter_m, wall_thickness_m] = SECTIONS[section];
    let density = if section == 4 {
        GROUTED_KG_PER_M3
    } else {
        7850.0
    };
    let steel = Material::from_shear_modulus(density, 2.1e11, 8.0769e10);
    let tube = Tube {
        outer_diameter_m,
        wall_thickness_m,
    };
    let name = (frame.members.len() + 1).to_string();
    let mut member = FrameMember::tube(name, ends, [tube; 2], steel);
    if is_flooded {
        // The grouted pile is flooded as wide as the leg in it.
        let inner_m = if section == 4 {
            0.55
        } else {
            0.5 * tube.inner_diameter_m()
        };
        member.coats.extend(SEA.filling(
            [
                frame.joints[ends[0]].position_m[2],
                frame.joints[ends[1]].position_m[2],
            ],
            inner_m,
        ));
    }
    frame.members.push(member);
}

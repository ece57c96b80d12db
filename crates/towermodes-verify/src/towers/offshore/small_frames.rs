//! Small frames, each with one feature of a frame: a tube on soil, joints that rotate, cables,
//! rigid links, a spring.

use towermodes::frame::{
    FrameDescription, FrameJoint, FrameMember, FrameSpring, FrameSupport, JointKind, MemberKind,
    Transition,
};
use towermodes::tower::Tube;
use towermodes::{Inertia, Material, RigidBody};

/// A tube of 20 m, from -20 m to the surface.
const ONE: [[f64; 3]; 2] = [[0.0, 0.0, -20.0], [0.0, 0.0, 0.0]];
/// The tube of 20 m in two halves.
const HALVES: [[f64; 3]; 3] = [[0.0, 0.0, -20.0], [0.0, 0.0, -10.0], [0.0, 0.0, 0.0]];
/// Two tubes at an angle, and the lower end of a third one.
const BENT: [[f64; 3]; 4] = [
    [-5.0, 0.0, -20.0],
    [0.0, 1.0, -10.0],
    [0.0, 0.0, 0.0],
    [4.0, 3.0, -20.0],
];
/// Two tubes, and two points beside them.
const BESIDE: [[f64; 3]; 5] = [
    [0.0, 0.0, -20.0],
    [0.0, 0.0, -8.0],
    [0.0, 0.0, 0.0],
    [3.0, 1.0, -7.0],
    [3.0, 5.0, -7.0],
];

fn steel(stiffer: f64) -> Material {
    Material::from_shear_modulus(7850.0, 2.1e11 * stiffer, 8.08e10 * stiffer)
}

/// Tubes of this diameter and wall thickness between points; the points with the indices `clamped`
/// are clamped.
fn tubes(
    points: &[[f64; 3]],
    ends: &[[usize; 2]],
    clamped: &[usize],
    [diameter_m, wall_m]: [f64; 2],
) -> FrameDescription {
    let section = Tube {
        outer_diameter_m: diameter_m,
        wall_thickness_m: wall_m,
    };
    let number = |index: usize| (index + 1).to_string();
    let joint = |(k, point): (usize, &[f64; 3])| FrameJoint::new(number(k), *point);
    let member = |(k, ends): (usize, &[usize; 2])| {
        FrameMember::tube(number(k), *ends, [section; 2], steel(1.0))
    };
    let supports = clamped.iter().map(|joint| FrameSupport::clamped(*joint));
    FrameDescription {
        joints: points.iter().enumerate().map(joint).collect(),
        members: ends.iter().enumerate().map(member).collect(),
        supports: supports.collect(),
        ..FrameDescription::default()
    }
}

const THICK: [f64; 2] = [2.0, 0.03];
const IN_LINE: [[usize; 2]; 2] = [[0, 1], [1, 2]];

/// The frame with this joint fixed.
pub fn with_top_held(mut frame: FrameDescription, joint: usize) -> FrameDescription {
    frame.transition = Some(Transition {
        position_m: frame.joints[joint].position_m,
        joints: vec![joint],
        is_held: true,
    });
    frame
}

/// A tube on soil in the motions that are not fixed, with Young's and shear modulus multiplied by
/// `stiffer`.
pub fn tube_on_soil(fixed: [bool; 6], stiffer: f64) -> FrameDescription {
    let mut frame = tubes(&ONE, &[[0, 1]], &[], THICK);
    if let MemberKind::Beam { material, .. } = &mut frame.members[0].kind {
        *material = steel(stiffer);
    }
    let mut support = FrameSupport {
        fixed,
        ..FrameSupport::clamped(0)
    };
    if fixed != [true; 6] {
        let stiffness = [
            (0, 0, 5.04e7),
            (0, 1, 3.1e5),
            (1, 1, 5.6e7),
            (2, 2, 2.54e8),
            (0, 4, -1.98e8),
            (1, 3, 2.0e8),
            (3, 3, 1.3e9),
            (4, 4, 1.35e9),
            (5, 5, 7.0e8),
        ];
        let inertia = [
            (0, 0, 4e3),
            (1, 1, 4e3),
            (2, 2, 3e3),
            (0, 4, -9e3),
            (1, 3, 9e3),
        ];
        for (i, j, value) in stiffness {
            (support.stiffness[i][j], support.stiffness[j][i]) = (value, value);
        }
        for (i, j, value) in inertia {
            (support.inertia[i][j], support.inertia[j][i]) = (value, value);
        }
    }
    frame.supports = vec![support];
    frame
}

/// Two tubes in line, clamped below, with this joint between them.
pub fn jointed(kind: JointKind) -> FrameDescription {
    let mut frame = tubes(&HALVES, &IN_LINE, &[0], THICK);
    frame.joints[1].kind = kind;
    frame
}

/// Two or three tubes at angles, with this joint between them.
pub fn bent(kind: JointKind, has_third: bool) -> FrameDescription {
    let mut frame = match has_third {
        false => tubes(&BENT[..3], &IN_LINE, &[0], THICK),
        true => tubes(&BENT, &[[0, 1], [1, 2], [3, 1]], &[0, 3], THICK),
    };
    frame.joints[1].kind = kind;
    frame
}

/// A mast with four cables, with or without their transverse stiffness from pretension (SubDyn 5.0
/// omits it).
pub fn guyed(has_tension: bool) -> FrameDescription {
    let points = [
        [0.0, 0.0, -20.0],
        [0.0, 0.0, -5.0],
        [0.0, 0.0, 0.0],
        [10.0, 0.0, -20.0],
        [-10.0, 0.0, -20.0],
        [0.0, 12.0, -20.0],
        [0.0, -12.0, -20.0],
    ];
    let mut mast = tubes(&points, &IN_LINE, &[0, 3, 4, 5, 6], [0.8, 0.02]);
    let kind = match has_tension {
        true => MemberKind::Cable {
            axial_n: 1e8,
            mass_kg_per_m: 20.0,
            pretension_n: 2e6,
        },
        // As long as without tension: L = 1.02 L₀.
        false => MemberKind::Cable {
            axial_n: 1.02e8,
            mass_kg_per_m: 20.0 / 1.02,
            pretension_n: 0.0,
        },
    };
    for anchor in 3..7 {
        let name = format!("cable {anchor}");
        let cable = FrameMember::new(name, [anchor, 1], kind.clone());
        mast.members.push(cable);
    }
    mast
}

fn body(center_m: [f64; 3]) -> RigidBody {
    RigidBody {
        mass_kg: 8000.0,
        center_m,
        inertia_kg_m2: Inertia::from([1e4, 2e4, 3e4, 0.0, 0.0, 0.0]),
    }
}

fn rigid(name: &str, ends: [usize; 2], mass_kg_per_m: f64) -> FrameMember {
    FrameMember::new(name, ends, MemberKind::Rigid { mass_kg_per_m })
}

/// A body next to two tubes: at the end of a rigid link, or with its centre of mass away from its
/// joint.
pub fn with_body(has_link: bool) -> FrameDescription {
    let mut frame = tubes(&BESIDE[..3], &IN_LINE, &[0], THICK);
    if has_link {
        frame.joints.push(FrameJoint::new("4", BESIDE[3]));
        frame.members.push(rigid("3", [1, 3], 0.0));
        frame.masses.push((3, body([0.0; 3])));
    } else {
        frame.masses.push((1, body([3.0, 1.0, 1.0])));
    }
    frame
}

/// Two rigid links with mass next to two tubes.
pub fn with_heavy_links() -> FrameDescription {
    let mut frame = tubes(&BESIDE, &IN_LINE, &[0], THICK);
    frame.members.push(rigid("3", [1, 3], 500.0));
    frame.members.push(rigid("4", [3, 4], 500.0));
    frame
}

/// Two tubes with a spring of 1 m between them.
pub fn with_spring() -> FrameDescription {
    let points = [
        [0.0, 0.0, -20.0],
        [0.0, 0.0, -10.0],
        [0.0, 0.0, -9.0],
        [0.0, 0.0, 0.0],
    ];
    let mut frame = tubes(&points, &[[0, 1], [2, 3]], &[0], THICK);
    let mut stiffness = [[0.0; 6]; 6];
    let diagonal = [3e7, 4e7, 5e7, 2e8, 1e8, 3e8];
    (0..6).for_each(|i| stiffness[i][i] = diagonal[i]);
    (stiffness[0][4], stiffness[4][0]) = (1e7, 1e7);
    let kind = MemberKind::Spring(Box::new(FrameSpring {
        stiffness,
        axes: None,
    }));
    frame.members.push(FrameMember::new("3", [1, 2], kind));
    frame
}

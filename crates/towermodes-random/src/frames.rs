//! Generated frames: a jacket, a lattice of any size, random frames.

use towermodes::frame::{
    CoatKind, Frame, FrameCoat, FrameDescription, FrameFoundation, FrameJoint, FrameMember,
    FrameSupport, JointKind, MemberKind, Transition,
};
use towermodes::tower::Tube;
use towermodes::{Foundation, Material, RigidBody, Rna, Station, Tower, TowerDescription};

use super::seed::Seed;

const WATER_KG_PER_M3: f64 = 1025.0;
const GROWTH_KG_PER_M3: f64 = 1100.0;

fn steel() -> Material {
    Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10)
}

fn tube(outer_diameter_m: f64, wall_thickness_m: f64) -> Tube {
    Tube {
        outer_diameter_m,
        wall_thickness_m,
    }
}

/// A lattice with four legs, bays with a cross of braces in each side, and a horizontal square at
/// the top of each bay.
#[derive(Debug, Clone, Copy)]
pub struct Lattice {
    /// Number of bays.
    pub bays: usize,
    /// Heights of its feet and of its top, m.
    pub heights_m: [f64; 2],
    /// Half of its width at the feet and at the top, m.
    pub half_widths_m: [f64; 2],
    /// Whether the members in water have added mass, and marine growth over a part of the depth.
    pub in_water: bool,
}

impl Lattice {
    /// A lattice like a jacket in 50 m of water.
    pub fn jacket() -> Self {
        Self {
            bays: 4,
            heights_m: [-50.0, 16.0],
            half_widths_m: [6.0, 4.0],
            in_water: true,
        }
    }

    /// A slender lattice with about this number of members.
    pub fn of_members(members: usize) -> Self {
        Self {
            // 4 legs, 16 halves of braces, 4 horizontals.
            bays: (members / 24).max(1),
            heights_m: [0.0, 120.0],
            half_widths_m: [12.0, 4.0],
            in_water: false,
        }
    }

    /// Its joints, members, supports and the transition piece.
    pub fn description(&self) -> FrameDescription {
        let mut frame = FrameDescription::default();
        let [foot_m, top_m] = self.heights_m;
        let corners = |level: usize| -> [[f64; 3]; 4] {
            let s = level as f64 / self.bays as f64;
            let w = self.half_widths_m[0] + s * (self.half_widths_m[1] - self.half_widths_m[0]);
            let z = foot_m + s * (top_m - foot_m);
            [[-w, -w, z], [w, -w, z], [w, w, z], [-w, w, z]]
        };
        let join = |frame: &mut FrameDescription, position_m: [f64; 3]| {
            let name = (frame.joints.len() + 1).to_string();
            frame.joints.push(FrameJoint::new(name, position_m));
            frame.joints.len() - 1
        };
        let leg = tube(1.2, 0.04);
        let (brace, level_tube) = (tube(0.7, 0.016), tube(0.6, 0.014));
        let mut below = corners(0).map(|corner| join(&mut frame, corner));
        frame.supports = below.map(FrameSupport::clamped).to_vec();
        for level in 1..=self.bays {
            let above = corners(level).map(|corner| join(&mut frame, corner));
            for side in 0..4 {
                let next = (side + 1) % 4;
                let at = |frame: &FrameDescription, joint: usize| frame.joints[joint].position_m;
                // Where the diagonals of a trapezium cross.
                let [a, b] = [at(&frame, below[side]), at(&frame, below[next])];
                let [c, d] = [at(&frame, above[side]), at(&frame, above[next])];
                let width = |p: [f64; 3], q: [f64; 3]| (p[0] - q[0]).hypot(p[1] - q[1]);
                let share = width(a, b) / (width(a, b) + width(c, d));
                let cross = std::array::from_fn(|i| a[i] + share * (d[i] - a[i]));
                let middle = join(&mut frame, cross);
                self.add(&mut frame, [below[side], above[side]], leg);
                for end in [below[side], below[next], above[side], above[next]] {
                    self.add(&mut frame, [end, middle], brace);
                }
                self.add(&mut frame, [above[side], above[next]], level_tube);
            }
            below = above;
        }
        frame.transition = Some(Transition {
            position_m: [0.0, 0.0, top_m + 4.0],
            joints: below.to_vec(),
            is_held: false,
        });
        frame
    }

    fn add(&self, frame: &mut FrameDescription, joints: [usize; 2], section: Tube) {
        let name = (frame.members.len() + 1).to_string();
        let mut member = FrameMember::tube(name, joints, [section; 2], steel());
        if self.in_water {
            let z = joints.map(|joint| frame.joints[joint].position_m[2]);
            let radius_m = 0.5 * section.outer_diameter_m;
            if let Some(range) = between(z, f64::NEG_INFINITY, 0.0) {
                let kind = CoatKind::AddedMass {
                    density_kg_per_m3: WATER_KG_PER_M3,
                    radius_m: [radius_m; 2],
                    across: [1.0; 2],
                    along: [0.0; 2],
                };
                member.coats.push(FrameCoat { range, kind });
            }
            if let Some(range) = between(z, -40.0, -2.0) {
                let kind = CoatKind::Solid {
                    density_kg_per_m3: [GROWTH_KG_PER_M3; 2],
                    outer_radius_m: [radius_m + 0.1; 2],
                    inner_radius_m: [radius_m; 2],
                };
                member.coats.push(FrameCoat { range, kind });
            }
        }
        frame.members.push(member);
    }

    /// A tower of 70 m with a nacelle on it.
    pub fn with_tower(&self) -> Tower {
        tower_on(
            self.description(),
            RigidBody {
                mass_kg: 3e5,
                ..RigidBody::default()
            },
        )
    }
}

/// The fractions of a member between two heights (m), if any; `z` are the heights of its ends.
fn between([from_m, to_m]: [f64; 2], low_m: f64, high_m: f64) -> Option<[f64; 2]> {
    if from_m == to_m {
        return (low_m <= from_m && from_m <= high_m).then_some([0.0, 1.0]);
    }
    let at = |z: f64| ((z - from_m) / (to_m - from_m)).clamp(0.0, 1.0);
    let (a, b) = (at(low_m), at(high_m));
    let range = [a.min(b), a.max(b)];
    (range[1] - range[0] > 1e-6).then_some(range)
}

/// A tower of 70 m with an eccentric nacelle, on a frame with a transition piece that can move.
///
/// # Panics
/// If the frame is not valid.
pub fn tower_on(frame: FrameDescription, platform: RigidBody) -> Tower {
    #[expect(clippy::unwrap_used, reason = "made in code for tests")]
    let frame = Frame::new(frame).unwrap();
    #[expect(clippy::unwrap_used, reason = "made in code for tests")]
    let foundation = FrameFoundation::new(frame, platform).unwrap();
    let base_m = foundation.reference_m()[2];
    #[expect(clippy::unwrap_used, reason = "made in code for tests")]
    let tower = Tower::new(TowerDescription {
        materials: vec![steel()],
        stations: vec![
            Station::new(base_m, 5.6, 0.032),
            Station::new(base_m + 68.0, 4.0, 0.03),
        ],
        rna: Rna {
            center_m: [-0.4, 0.0, 2.0],
            ..Rna::point(3.5e5)
        },
        foundation: Foundation::Frame(Box::new(foundation)),
        gravity_m_per_s2: 9.81,
        ..TowerDescription::default()
    })
    .unwrap();
    tower
}

/// A random frame of 3 to 7 joints: tubes, some of them tapered, rigid links, a cable, pins and
/// ball joints with springs, supports that are clamped or on soil, bodies on joints, water and
/// growth.
pub fn random_frame(seed: &mut Seed) -> FrameDescription {
    let count = seed.whole(3, 7);
    let mut frame = FrameDescription::default();
    for k in 0..count {
        // The first two are the feet.
        let z = if k < 2 {
            seed.between(-22.0, -18.0)
        } else {
            seed.between(-15.0, 15.0)
        };
        let position_m = [seed.between(-12.0, 12.0), seed.between(-12.0, 12.0), z];
        let mut joint = FrameJoint::new((k + 1).to_string(), position_m);
        joint.kind = match seed.whole(0, 9) {
            0 => JointKind::Ball {
                stiffness_n_m_per_rad: seed.log_between(1e6, 1e9),
            },
            1 => JointKind::Pin {
                axis: [1.0, seed.between(-1.0, 1.0), seed.between(-1.0, 1.0)],
                stiffness_n_m_per_rad: seed.log_between(1e6, 1e9),
            },
            _ => JointKind::Cantilever,
        };
        frame.joints.push(joint);
    }
    // Each joint hangs on one before it, and further members close loops.
    let mut pairs: Vec<[usize; 2]> = (1..count).map(|k| [seed.whole(0, k - 1), k]).collect();
    for _ in 0..seed.whole(0, count) {
        let (a, b) = (seed.whole(0, count - 1), seed.whole(0, count - 1));
        if a != b && !pairs.iter().any(|pair| *pair == [a, b] || *pair == [b, a]) {
            pairs.push(if seed.chance(0.5) { [a, b] } else { [b, a] });
        }
    }
    for (index, joints) in pairs.into_iter().enumerate() {
        frame
            .members
            .push(random_member(seed, index, joints, count));
    }
    let mut soil = FrameSupport {
        fixed: [false; 6],
        ..FrameSupport::clamped(1)
    };
    for (i, size) in [5e7, 5e7, 3e8, 1e9, 1e9, 5e8].into_iter().enumerate() {
        soil.stiffness[i][i] = size * seed.log_between(0.3, 3.0);
        soil.inertia[i][i] = if i < 3 { 4e3 } else { 2e4 };
    }
    let coupling = 0.3 * soil.stiffness[0][0].min(soil.stiffness[1][1]);
    (soil.stiffness[0][4], soil.stiffness[4][0]) = (-coupling, -coupling);
    (soil.stiffness[1][3], soil.stiffness[3][1]) = (coupling, coupling);
    if seed.chance(0.3) {
        soil.fixed[2] = true;
    }
    frame.supports = vec![FrameSupport::clamped(0), soil];
    for joint in 2..count {
        if seed.chance(0.4) {
            let body = RigidBody {
                mass_kg: seed.log_between(1e2, 1e5),
                center_m: [seed.between(-1.0, 1.0), 0.0, seed.between(-1.0, 1.0)],
                inertia_kg_m2: towermodes::Inertia::from_tensor([
                    [3e3, 0.0, 0.0],
                    [0.0, 4e3, 0.0],
                    [0.0, 0.0, 5e3],
                ]),
            };
            frame.masses.push((joint, body));
        }
    }
    frame
}

fn random_member(seed: &mut Seed, index: usize, joints: [usize; 2], count: usize) -> FrameMember {
    let name = (index + 1).to_string();
    // The first members are the tree that holds all joints.
    let closes = index + 1 >= count;
    if closes && seed.chance(0.2) {
        let kind = MemberKind::Cable {
            axial_n: seed.log_between(1e7, 1e9),
            mass_kg_per_m: seed.between(5.0, 50.0),
            pretension_n: seed.log_between(1e4, 1e6),
        };
        return FrameMember::new(name, joints, kind);
    }
    if !closes && seed.chance(0.1) {
        let mass_kg_per_m = seed.between(0.0, 200.0);
        return FrameMember::new(name, joints, MemberKind::Rigid { mass_kg_per_m });
    }
    let diameter_m = seed.log_between(0.4, 2.5);
    let wall_m = diameter_m * seed.between(0.01, 0.03);
    let taper = if seed.chance(0.5) {
        seed.between(0.6, 1.5)
    } else {
        1.0
    };
    let ends = [tube(diameter_m, wall_m), tube(diameter_m * taper, wall_m)];
    let mut member = FrameMember::tube(name, joints, ends, steel());
    if seed.chance(0.3) {
        let radius_m = ends.map(|tube| 0.5 * tube.outer_diameter_m);
        let (low, high) = (seed.between(0.0, 0.4), seed.between(0.5, 1.0));
        member.coats.push(FrameCoat {
            range: [low, high],
            kind: CoatKind::AddedMass {
                density_kg_per_m3: WATER_KG_PER_M3,
                radius_m,
                across: [1.0, seed.between(0.7, 1.2)],
                along: [0.0; 2],
            },
        });
    }
    member
}

//! The platform as a rigid body in its water: walls, bulkheads, stiffeners, ballast and, if the
//! file contains variable ballast, ballast water that balances weight, buoyancy and mooring force.

use towermodes::mooring::{Mooring, Pose};
use towermodes::{Buoyancy, FloatingPlatform, Inertia, MooringLines, ReferredMatrix, RigidBody};

use super::super::support::materials::Materials;
use super::super::text::outline::{Outline, Version};
use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use super::ballast::{Filled, ballasts};
use super::joints::{Joints, capped, vector};
use super::lines::{Sea, lines};
use super::members::{Member, Piece, members};
use super::steel::{bulkheads, walls};
use super::stiffeners::{longitudinal, note_angles, rings};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::hydrodyn::{SeaWater, StripMember, StripWater, strip_water};
use crate::input::MemberEnds;
use crate::mooring::MooringInput;
use crate::note::Note;
use crate::number::Rounded;

/// The turbine on a platform, and gravity.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Afloat {
    /// Mass of the tower and the rotor-nacelle assembly, kg.
    pub(crate) carried_kg: f64,
    pub(crate) gravity_m_per_s2: f64,
    /// Height of the tower's base, m.
    pub(crate) base_m: f64,
    pub(crate) member_ends: MemberEnds,
}

/// The platform of a file at its undisplaced position.
pub(crate) fn float(
    outline: &Outline,
    version: Version,
    afloat: &Afloat,
    reading: &mut Reading<'_>,
) -> Result<Option<FloatingPlatform>, Diagnostic> {
    let components = outline.components.as_ref();
    let Some(node) = components.and_then(|all| all.floating_platform.as_ref()) else {
        return Ok(None);
    };
    let mooring = components.and_then(|all| all.mooring.as_ref());
    let mut materials = Materials::new(outline.materials.as_ref());
    let mut joints = Joints::read(node, version, reading)?;
    let sea = sea(outline, &joints, afloat, reading)?;
    let axis_m = joints.transition.map_or([0.0; 2], |joint| {
        let [x, y, _] = joints.joints[joint].position_m;
        [x, y]
    });
    joints.shift(axis_m);
    let members = members(node, version, &mut joints, &mut materials, reading)?;
    note_angles(&members, version, &materials, reading)?;
    note_transition(node, &joints, afloat, reading);
    let moored = match mooring {
        Some(mooring) => Some(lines(mooring, &joints, axis_m, &sea, reading)?),
        None => None,
    };
    let pull_n = match &moored {
        Some(input) => pull(input, reading)?,
        None => 0.0,
    };
    let platform = Platform {
        node,
        version,
        joints: &joints,
        members: &members,
        materials: &materials,
        sea,
    };
    let others = platform.others(reading)?;
    let hulls = [
        platform.hull(true, reading)?,
        platform.hull(false, reading)?,
    ];
    let needed = hulls.each_ref().map(|hull| {
        let lift_kg = sea.density_kg_per_m3 * hull.water.volume_m3 + pull_n / sea.gravity_m_per_s2;
        lift_kg - hull.dry_kg() - others.mass_kg - afloat.carried_kg
    });
    let hull = match afloat.member_ends {
        MemberEnds::Balance => choose(&hulls, needed),
        MemberEnds::Cut => 0,
        MemberEnds::Whole => 1,
    };
    note_ends(node, &hulls, hull, afloat.member_ends, reading);
    let (hull, needed_kg) = (&hulls[hull], needed[hull]);
    let ballast = ballast_water(hull, needed_kg, node, reading);
    note_strips(node, reading);
    let whole = RigidBody::combined(&[hull.steel, hull.fixed, others, ballast]);
    let lift_n = sea.density_kg_per_m3 * sea.gravity_m_per_s2 * hull.water.volume_m3;
    Ok(Some(FloatingPlatform {
        added_mass_by_frequency: None,
        mass_kg: whole.mass_kg,
        center_m: whole.center_m,
        inertia_kg_m2: whole.inertia_kg_m2,
        added_mass: at_water(hull.water.added_mass),
        hydrostatic: at_water(
            hull.water
                .hydrostatic
                .map(|row| row.map(|entry| entry * sea.density_kg_per_m3 * sea.gravity_m_per_s2)),
        ),
        buoyancy: (lift_n > 0.0).then(|| Buoyancy {
            force_n: lift_n,
            center_m: [hull.water.center_m[0], hull.water.center_m[1]],
        }),
        mooring: ReferredMatrix::default(),
        at_equilibrium: false,
        mooring_lines: moored.map(|input| {
            Box::new(MooringLines {
                description: input.description,
                still_water_m: 0.0,
            })
        }),
    }))
}

fn at_water(matrix: towermodes::space::SpatialMatrix) -> ReferredMatrix {
    ReferredMatrix {
        matrix,
        height_m: 0.0,
    }
}

/// Depth and density of the water; without a depth the seabed is at the lowest joint, an anchor.
fn sea(
    outline: &Outline,
    joints: &Joints,
    afloat: &Afloat,
    reading: &mut Reading<'_>,
) -> Result<Sea, Diagnostic> {
    let heights = joints.joints.iter().map(|joint| joint.position_m[2]);
    let lowest_m = heights.fold(0.0_f64, f64::min);
    let environment = outline.environment.as_ref();
    let mut value = |key: &str, assumed: f64, unit: &str| -> Result<f64, Diagnostic> {
        let Some(node) = environment.and_then(|environment| environment.get(key)) else {
            let message =
                format!("the file has no {key} in its environment: {assumed} {unit} is assumed");
            reading.note(Note::assumption(message));
            return Ok(assumed);
        };
        let found = node.number(key)?;
        match found > 0.0 {
            true => Ok(found),
            false => {
                let kind = DiagnosticKind::out_of_range(key, found, "positive");
                Err(Diagnostic::new(node.span.clone(), kind))
            }
        }
    };
    Ok(Sea {
        depth_m: value(
            "water_depth",
            -lowest_m,
            "m (the depth of the lowest joint)",
        )?,
        density_kg_per_m3: value("water_density", 1025.0, "kg/m3")?,
        gravity_m_per_s2: afloat.gravity_m_per_s2,
    })
}

/// The vertical force of the lines on the platform, N. Errors of the lines are found by the tower's
/// checks at their place in the file.
fn pull(input: &MooringInput, reading: &mut Reading<'_>) -> Result<f64, Diagnostic> {
    let first = |error: ReadError| match error {
        ReadError::Mistakes { mut mistakes, .. } if !mistakes.is_empty() => mistakes.swap_remove(0),
        other => Diagnostic::new(0..0, DiagnosticKind::Contradiction(other.to_string())),
    };
    let mooring: Mooring = input.mooring().map_err(first)?;
    let state = mooring
        .at(&Pose::default())
        .map_err(|error| first(input.mistake(error)))?;
    for (place, span) in input.places() {
        reading.remember(place, &span);
    }
    Ok(state.load.force[2])
}

/// The parts of a platform.
struct Platform<'p> {
    node: &'p Node,
    version: Version,
    joints: &'p Joints,
    members: &'p [Member<'p>],
    materials: &'p Materials<'p>,
    sea: Sea,
}

/// All members, with ends cut at the surface of others, or with whole ends.
struct Hull {
    water: StripWater,
    steel: RigidBody,
    fixed: RigidBody,
    /// Water that fills all variable ballast.
    full: RigidBody,
}

impl Hull {
    fn dry_kg(&self) -> f64 {
        self.steel.mass_kg + self.fixed.mass_kg
    }
}

impl Platform<'_> {
    fn hull(&self, is_cut: bool, reading: &Reading<'_>) -> Result<Hull, Diagnostic> {
        let water = SeaWater {
            density_kg_per_m3: self.sea.density_kg_per_m3,
            depth_m: self.sea.depth_m,
            level_m: 0.0,
        };
        let (mut strips, mut joints_of) = (Vec::new(), Vec::new());
        let (mut steel, mut filled) = (Vec::new(), Filled::default());
        for member in self.members {
            let range = match is_cut {
                true => member.outside(self.joints, self.members),
                false => [0.0, 1.0],
            };
            if range[1] - range[0] < 1e-9 {
                continue;
            }
            let ballasts = ballasts(member, self.materials, reading)?;
            let limits: Vec<f64> = ballasts.iter().flat_map(|ballast| ballast.range).collect();
            let (strip, pieces) = member.pieces(self.joints, range, &limits, &water);
            let mut of_steel = self.steel(member, &strip, &pieces, range, reading)?;
            let mut of_ballast = Filled::default();
            for ballast in &ballasts {
                let density = self.sea.density_kg_per_m3;
                ballast.fill(&strip, &pieces, density, &mut of_ballast)?;
            }
            if let Some(given_kg) = member.given_kg {
                scale_to(given_kg, &mut of_steel, &mut of_ballast.fixed);
            }
            steel.append(&mut of_steel);
            filled.fixed.append(&mut of_ballast.fixed);
            filled.water.append(&mut of_ballast.water);
            strips.push(strip);
            joints_of.push(member.joints);
        }
        let joints = self.joints.joints.iter();
        let joints: Vec<_> = joints
            .map(|joint| (joint.position_m, joint.axial))
            .collect();
        Ok(Hull {
            water: strip_water(&strips, &joints, &joints_of, &water),
            steel: RigidBody::combined(&steel),
            fixed: RigidBody::combined(&filled.fixed),
            full: RigidBody::combined(&filled.water),
        })
    }

    fn steel(
        &self,
        member: &Member<'_>,
        strip: &StripMember,
        pieces: &[Piece],
        range: [f64; 2],
        reading: &Reading<'_>,
    ) -> Result<Vec<RigidBody>, Diagnostic> {
        let materials = self.materials;
        let mut bodies = walls(member, strip, pieces, materials)?;
        bodies.extend(bulkheads(member, strip, range, materials, reading)?);
        bodies.extend(rings(member, strip, range, materials, reading)?);
        let of = (materials, reading);
        bodies.extend(longitudinal(member, strip, pieces, self.version, of)?);
        Ok(bodies)
    }

    /// The transition piece and the rigid bodies on joints.
    fn others(&self, reading: &Reading<'_>) -> Result<RigidBody, Diagnostic> {
        let mut bodies = Vec::new();
        if let Some(node) = self.node.get("transition_piece_mass") {
            let mass_kg = node.mass_kg("mass of the transition piece")?;
            let joint = self
                .joints
                .transition
                .map(|joint| self.joints.joints[joint].position_m);
            bodies.push(RigidBody::point(mass_kg, joint.unwrap_or_default()));
        }
        let list = self.node.get("rigid_bodies");
        let list = list.map_or(Ok(&[][..]), |list| capped(list, "rigid bodies"))?;
        for node in list {
            let what = "a rigid body of the floating platform";
            let joint = self.joints.find(node.require("joint1", what)?, reading)?;
            let mass_kg = node
                .require("mass", what)?
                .mass_kg("mass of a rigid body")?;
            let three = |key: &str| node.get(key).map_or(Ok([0.0; 3]), |node| vector(node, key));
            let offset = three("cm_offset")?;
            let [xx, yy, zz] = three("moments_of_inertia")?;
            let at = self.joints.joints[joint].position_m;
            bodies.push(RigidBody {
                mass_kg,
                center_m: std::array::from_fn(|i| at[i] + offset[i]),
                inertia_kg_m2: Inertia {
                    xx,
                    yy,
                    zz,
                    ..Inertia::default()
                },
            });
        }
        Ok(RigidBody::combined(&bodies))
    }
}

/// Scales bodies so that their total mass has a given value.
fn scale_to(given_kg: f64, steel: &mut [RigidBody], ballast: &mut [RigidBody]) {
    let all = || steel.iter().chain(ballast.iter());
    let found_kg: f64 = all().map(|body| body.mass_kg).sum();
    if found_kg <= 0.0 {
        return;
    }
    for body in steel.iter_mut().chain(ballast) {
        *body = scaled(body, given_kg / found_kg);
    }
}

/// The body with its mass multiplied by a factor.
fn scaled(body: &RigidBody, share: f64) -> RigidBody {
    let tensor = body.inertia_kg_m2.tensor();
    RigidBody {
        mass_kg: share * body.mass_kg,
        center_m: body.center_m,
        inertia_kg_m2: Inertia::from_tensor(tensor.map(|row| row.map(|entry| share * entry))),
    }
}

/// The selected hull: the one that its ballast water can balance, the cut one if this is possible
/// for both; without ballast water the one that is closer to balance.
fn choose(hulls: &[Hull; 2], needed_kg: [f64; 2]) -> usize {
    let misses = |hull: usize| {
        let most_kg = hulls[hull].full.mass_kg;
        (needed_kg[hull] - needed_kg[hull].clamp(0.0, most_kg)).abs()
    };
    usize::from(misses(1) < misses(0))
}

fn note_ends(
    node: &Node,
    hulls: &[Hull; 2],
    chosen: usize,
    wanted: MemberEnds,
    reading: &mut Reading<'_>,
) {
    let [cut, whole] = hulls.each_ref().map(|hull| hull.water.volume_m3);
    if cut == whole {
        return;
    }
    let how = [
        "are cut at the surface of the members on which they begin",
        "reach to the axes of the members on which they begin",
    ];
    let why = match (wanted, chosen) {
        (MemberEnds::Cut | MemberEnds::Whole, _) => "by the option member-ends",
        (MemberEnds::Balance, 0) => "as in WISDEM",
        (MemberEnds::Balance, _) => "because the platform is then closer to balance",
    };
    let message = format!(
        "members of the floating platform {}, {why}: the members displace {cut:.1} m3 if they are cut (member-ends cut) and {whole:.1} m3 if they reach to the axes (member-ends whole); compare with the known displacement or mass of the platform, because frequencies differ by some percent",
        how[chosen]
    );
    reading.note_at(node.span.start, Note::assumption(message));
}

/// Ballast water with the same filling ratio in all compartments.
fn ballast_water(hull: &Hull, needed_kg: f64, node: &Node, reading: &mut Reading<'_>) -> RigidBody {
    let most_kg = hull.full.mass_kg;
    let used_kg = needed_kg.clamp(0.0, most_kg);
    let (needed_t, most_t) = (needed_kg / 1e3, most_kg / 1e3);
    let tolerance_kg = 1e-9 * hull.water.volume_m3 * 1e3;
    let note = if (needed_kg - used_kg).abs() > tolerance_kg {
        let comparison = if needed_kg < 0.0 { "less" } else { "more" };
        let holds = match most_kg > 0.0 {
            true => format!("of which there are at most {most_t:.1} t"),
            false => "which it does not have".to_owned(),
        };
        Note::suspicious(format!(
            "buoyancy and mooring lines carry {:.1} t {comparison} than the turbine without variable ballast, {holds}: the platform is out of balance by {:.1} t in its undisplaced position",
            needed_t.abs(),
            (needed_kg - used_kg) / 1e3
        ))
    } else if most_kg > 0.0 {
        Note::assumption(format!(
            "the variable ballast is {needed_t:.1} t of water, which balances the turbine, its buoyancy and the mooring lines: all compartments are filled to {:.2} %, and the water is distributed over their whole length",
            100.0 * used_kg / most_kg
        ))
    } else {
        return RigidBody::default();
    };
    reading.note_at(node.span.start, note);
    if most_kg == 0.0 {
        return RigidBody::default();
    }
    scaled(&hull.full, used_kg / most_kg)
}

fn note_strips(node: &Node, reading: &mut Reading<'_>) {
    let message = "the added mass of the platform follows from strips of its members (Ca) at all frequencies, without member ends except at joints with axial_coeffs: heave can be 20 % and the tower 5 % too high against potential flow";
    reading.note_at(node.span.start, Note::approximation(message));
}

fn note_transition(node: &Node, joints: &Joints, afloat: &Afloat, reading: &mut Reading<'_>) {
    let Some(joint) = joints.transition else {
        let message = "no joint of the floating platform is its transition: the tower stands on the axis x = y = 0";
        reading.note_at(node.span.start, Note::assumption(message));
        return;
    };
    let z_m = joints.joints[joint].position_m[2];
    if (z_m - afloat.base_m).abs() > 1e-3 {
        let message = format!(
            "the transition joint is at z = {} m, but the tower begins at z = {} m: the stretch between them is rigid",
            Rounded(z_m),
            Rounded(afloat.base_m)
        );
        reading.note_at(node.span.start, Note::suspicious(message));
    }
}

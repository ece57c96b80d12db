//! The water of strip members as that of one rigid body, and rings of material along them, for all
//! readers with strip members.

use towermodes::RigidBody;
use towermodes::space::SpatialMatrix;

use super::ends::{self, Joint};
use super::growth::Growth;
use super::section::{Outline, blend};
use super::strip::{Stretch, StripMember};
use super::strip_inertia::{Ring, added_mass, slices};
use super::water::SeaWater;
use super::water_plane;

/// Water for motions (x, y, z, rotation about x, y, z) of the origin.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct StripWater {
    /// Displaced volume, m³.
    pub(crate) volume_m3: f64,
    /// Centre of buoyancy, m.
    pub(crate) center_m: [f64; 3],
    /// Added mass: kg, kg m, kg m².
    pub(crate) added_mass: SpatialMatrix,
    /// Stiffness of water plane and buoyancy divided by ρ g: m², m³, m⁴.
    pub(crate) hydrostatic: SpatialMatrix,
}

/// The water of members; joints are given by position and coefficient of added mass of member ends,
/// `joints_of` contains the joints of each member.
pub(crate) fn strip_water(
    members: &[StripMember],
    joints: &[([f64; 3], f64)],
    joints_of: &[[usize; 2]],
    water: &SeaWater,
) -> StripWater {
    let joints = joints.iter().map(|(position_m, axial)| Joint {
        name: String::new(),
        position_m: *position_m,
        axial: *axial,
    });
    let joints: Vec<Joint> = joints.collect();
    let ends = ends::of(&joints, members, joints_of, &Growth::default(), water);
    let hydrostatics = water_plane::of(members, water);
    let volume_m3 = hydrostatics.load[2];
    let center = |moment: f64| {
        if volume_m3 > 0.0 {
            moment / volume_m3
        } else {
            0.0
        }
    };
    StripWater {
        volume_m3,
        center_m: [
            center(-hydrostatics.load[4]),
            center(hydrostatics.load[3]),
            center(moment_of_height(members)),
        ],
        added_mass: added_mass(members, &ends, water.density_kg_per_m3),
        hydrostatic: hydrostatics.stiffness,
    }
}

/// ∫ z dV of the displaced volume, m⁴.
fn moment_of_height(members: &[StripMember]) -> f64 {
    let mut moment = 0.0;
    for member in members {
        for stretch in member.stretches.iter().filter(|stretch| stretch.is_wet) {
            for slice in slices(member, stretch, [0.0, 1.0]) {
                let area_m2 = stretch.section.outer(slice.fraction).area_m2();
                moment += area_m2 * slice.length_m * slice.center_m[2];
            }
        }
    }
    moment
}

/// A ring of material along a stretch of a circular member: density, outer and inner radii at both
/// ends.
pub(crate) fn ring(
    member: &StripMember,
    stretch: &Stretch,
    density_kg_per_m3: f64,
    outer_radius_m: [f64; 2],
    inner_radius_m: [f64; 2],
) -> RigidBody {
    let axes = member.axes();
    let discs = slices(member, stretch, [0.0, 1.0]).map(|slice| {
        let at = |radius_m| Outline::Circle(blend(radius_m, slice.fraction));
        let ring = Ring {
            density_kg_per_m3,
            outer: at(outer_radius_m),
            inner: Some(at(inner_radius_m)),
        };
        ring.disc(&slice, &axes)
    });
    RigidBody::combined(&discs)
}

//! Buoyancy and water plane of strip members as one rigid body.

use towermodes::space::SpatialMatrix;

use super::section::Outline;
use super::spatial::{NONE, Vector, add, load_of, of_force};
use super::strip::{Stretch, StripMember};
use super::strip_inertia::slices;
use super::water::SeaWater;

/// Stiffness and load divided by ρ g, about the origin.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Hydrostatics {
    pub(super) stiffness: SpatialMatrix,
    /// Force (m³) and moment (m⁴) of the buoyancy.
    pub(super) load: [f64; 6],
}

/// The sum over members with hydrostatic loads.
pub(super) fn of(members: &[StripMember], water: &SeaWater) -> Hydrostatics {
    let mut sum = Hydrostatics {
        stiffness: NONE,
        load: [0.0; 6],
    };
    for member in members.iter().filter(|member| member.floats()) {
        for stretch in member.stretches.iter().filter(|stretch| stretch.is_wet) {
            sum.add_buoyancy(member, stretch);
        }
    }
    for (_, plane) in planes(members, water) {
        add(&mut sum.stiffness, 1.0, &plane);
    }
    sum
}

/// The point at which each member with hydrostatic loads intersects the water surface, and the
/// stiffness of its water plane divided by ρ g, about the origin.
pub(super) fn planes(
    members: &[StripMember],
    water: &SeaWater,
) -> impl Iterator<Item = (Vector, SpatialMatrix)> {
    let level_m = water.level_m;
    let floating = members.iter().filter(|member| member.floats());
    floating.filter_map(move |member| {
        let outline = outline_at_level(member, level_m)?;
        let [from_m, to_m] = member.ends_m.map(|end_m| end_m[2]);
        let center_m = member.point_m((level_m - from_m) / (to_m - from_m));
        Some((center_m, water_plane(member, outline, center_m)))
    })
}

impl StripMember {
    /// Whether its buoyancy and water plane are computed from its strips.
    fn floats(&self) -> bool {
        self.has_hydrostatics && !self.is_potential_flow
    }
}

impl Hydrostatics {
    fn add_buoyancy(&mut self, member: &StripMember, stretch: &Stretch) {
        for slice in slices(member, stretch, [0.0, 1.0]) {
            let area_m2 = stretch.grown(slice.fraction).area_m2();
            let volume = [0.0, 0.0, area_m2 * slice.length_m];
            add(&mut self.stiffness, 1.0, &of_force(volume, slice.center_m));
            let load = load_of(volume, slice.center_m);
            for (sum, load) in self.load.iter_mut().zip(load) {
                *sum += load;
            }
        }
    }
}

/// The section at which a member intersects the water surface, if it does.
fn outline_at_level(member: &StripMember, level_m: f64) -> Option<Outline> {
    let [from_m, to_m] = member.ends_m.map(|end_m| end_m[2]);
    if (from_m - level_m) * (to_m - level_m) >= 0.0 {
        return None;
    }
    let mut wet = member.stretches.iter().filter(|stretch| stretch.is_wet);
    // The wet stretch next to the surface is the highest one.
    let (last, end) = match to_m > from_m {
        true => (wet.next_back()?, 1.0),
        false => (member.stretches.iter().find(|stretch| stretch.is_wet)?, 0.0),
    };
    Some(last.grown(end))
}

/// Stiffness of the plane in which an inclined member intersects the surface, divided by ρ g: its
/// area is the area of the section divided by cos φ. A point of the section at u, v on the local
/// axes x, y is in the plane at u g + v h, where g and h are x and y moved along the axis of the
/// member to the surface.
fn water_plane(member: &StripMember, outline: Outline, [x, y, _]: Vector) -> SpatialMatrix {
    let [_, local_y, k] = member.axes();
    let cosine = k[2].abs();
    let area = outline.area_m2() / cosine;
    // ∫ v² and ∫ u² over the plane.
    let [across, along] = outline.second_moments_m4().map(|moment| moment / cosine);
    let h: [f64; 2] = std::array::from_fn(|i| local_y[i] - local_y[2] / k[2] * k[i]);
    // g gᵀ + h hᵀ = 1 + k kᵀ/cos² φ: an ellipse, where both second moments are equal.
    let second = |i: usize, j: usize| {
        let unit = if i == j { 1.0 } else { 0.0 };
        along * (unit + k[i] * k[j] / (cosine * cosine)) + (across - along) * h[i] * h[j]
    };
    let (xx, yy, xy) = (second(0, 0), second(1, 1), second(0, 1));
    let mut matrix = NONE;
    matrix[2][2] = area;
    (matrix[2][3], matrix[2][4]) = (area * y, -area * x);
    (matrix[3][3], matrix[4][4]) = (yy + area * y * y, xx + area * x * x);
    matrix[3][4] = -(xy + area * x * y);
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[i.min(j)][i.max(j)]))
}

//! Buoyancy and water plane of strip members as one rigid body.

use std::f64::consts::PI;

use towermodes::space::SpatialMatrix;

use super::spatial::{NONE, Vector, add, load_of, of_force};
use super::strip::{Stretch, StripMember, blend};
use super::strip_inertia::slices;
use super::water::SeaWater;

/// Stiffness and load divided by ρ g, for the origin.
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

/// Where each member with hydrostatic loads crosses the surface, and the stiffness of its water
/// plane divided by ρ g, for the origin.
pub(super) fn planes(
    members: &[StripMember],
    water: &SeaWater,
) -> impl Iterator<Item = (Vector, SpatialMatrix)> {
    let level_m = water.level_m;
    let floating = members.iter().filter(|member| member.floats());
    floating.filter_map(move |member| {
        let radius_m = radius_at_level(member, level_m)?;
        let [from_m, to_m] = member.ends_m.map(|end_m| end_m[2]);
        let center_m = member.point_m((level_m - from_m) / (to_m - from_m));
        Some((center_m, water_plane(member, radius_m, center_m)))
    })
}

impl StripMember {
    /// Whether buoyancy and water plane of its strips are its own.
    fn floats(&self) -> bool {
        self.has_hydrostatics && !self.is_potential_flow
    }
}

impl Hydrostatics {
    fn add_buoyancy(&mut self, member: &StripMember, stretch: &Stretch) {
        let ends_m = stretch.grown_radius_m();
        for slice in slices(member, stretch, [0.0, 1.0]) {
            let radius_m = blend(ends_m, slice.fraction);
            let volume = [0.0, 0.0, PI * radius_m * radius_m * slice.length_m];
            add(&mut self.stiffness, 1.0, &of_force(volume, slice.center_m));
            let load = load_of(volume, slice.center_m);
            for (sum, load) in self.load.iter_mut().zip(load) {
                *sum += load;
            }
        }
    }
}

/// The radius where a member crosses the water's surface, if it does.
fn radius_at_level(member: &StripMember, level_m: f64) -> Option<f64> {
    let [from_m, to_m] = member.ends_m.map(|end_m| end_m[2]);
    if (from_m - level_m) * (to_m - level_m) >= 0.0 {
        return None;
    }
    let mut wet = member.stretches.iter().filter(|stretch| stretch.is_wet);
    // The wet stretch next to the surface is the highest one.
    let (last, end) = match to_m > from_m {
        true => (wet.next_back()?, 1),
        false => (member.stretches.iter().find(|stretch| stretch.is_wet)?, 0),
    };
    Some(last.grown_radius_m()[end])
}

/// Stiffness of the ellipse in which an inclined circular cylinder crosses the surface, by ρ g:
/// area π R²/cos φ, second moments A (R/cos φ)²/4 along the tilt and A R²/4 across it.
fn water_plane(member: &StripMember, radius_m: f64, [x, y, _]: Vector) -> SpatialMatrix {
    let [kx, ky, kz] = member.axis();
    let cosine = kz.abs();
    let area = PI * radius_m * radius_m / cosine;
    let across = area * radius_m * radius_m / 4.0;
    // The tilt (kx, ky)/sin φ has the second moment A R²/4 (1 + tan² φ).
    let along = |a: f64, b: f64| across * a * b / (cosine * cosine);
    let (xx, yy, xy) = (
        across + along(kx, kx),
        across + along(ky, ky),
        along(kx, ky),
    );
    let mut matrix = NONE;
    matrix[2][2] = area;
    (matrix[2][3], matrix[2][4]) = (area * y, -area * x);
    (matrix[3][3], matrix[4][4]) = (yy + area * y * y, xx + area * x * x);
    matrix[3][4] = -(xy + area * x * y);
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[i.min(j)][i.max(j)]))
}

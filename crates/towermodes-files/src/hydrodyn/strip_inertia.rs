//! Added mass and rigid bodies of strip members: integrals over their stretches.

use std::f64::consts::PI;

use towermodes::space::SpatialMatrix;
use towermodes::{Inertia, RigidBody};

use super::ends::StripEnd;
use super::spatial::{NONE, Tensor, Vector, add, of_mass};
use super::strip::{Stretch, StripMember, blend};

/// Points and weights of Gauss's rule on 0 to 1; exact for polynomials of degree 7, where those of
/// the integrals have at most degree 5.
fn gauss() -> [(f64, f64); 4] {
    let root = |sign: f64| (3.0 / 7.0 + sign * 2.0 / 7.0 * 1.2_f64.sqrt()).sqrt();
    let weight = |sign: f64| (18.0 + sign * 30.0_f64.sqrt()) / 72.0;
    let (inner, outer) = (root(-1.0), root(1.0));
    let (of_inner, of_outer) = (weight(1.0), weight(-1.0));
    [
        (-outer, of_outer),
        (-inner, of_inner),
        (inner, of_inner),
        (outer, of_outer),
    ]
    .map(|(x, w)| (0.5 * (1.0 + x), w))
}

/// A slice of a stretch: its place as a fraction of the stretch, its centre and its length.
pub(super) struct Slice {
    pub(super) fraction: f64,
    pub(super) center_m: Vector,
    pub(super) length_m: f64,
}

/// The slices of a part of a stretch, given by fractions of the stretch.
pub(super) fn slices(member: &StripMember, stretch: &Stretch, part: [f64; 2]) -> [Slice; 4] {
    let share = part[1] - part[0];
    let [from, to] = stretch.range;
    let length_m = member.length_m() * (to - from) * share;
    gauss().map(|(x, weight)| {
        let fraction = part[0] + x * share;
        Slice {
            fraction,
            center_m: member.point_m(from + fraction * (to - from)),
            length_m: weight * length_m,
        }
    })
}

/// α 1 + β k kᵀ.
fn axial(across: f64, along: f64, axis: Vector) -> Tensor {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let diagonal = if i == j { across } else { 0.0 };
            diagonal + (along - across) * axis[i] * axis[j]
        })
    })
}

impl Stretch {
    /// Added mass per length (kg/m) at a fraction of the stretch, which has this length (m):
    /// ρ π R² [Cₐ (1 − k kᵀ) + 2 Cₓ |dR/ds| k kᵀ].
    pub(super) fn added_mass(
        &self,
        fraction: f64,
        length_m: f64,
        axis: Vector,
        density_kg_per_m3: f64,
    ) -> Tensor {
        let Some(coefficients) = self.added_mass else {
            return [[0.0; 3]; 3];
        };
        let ends_m = self.grown_radius_m();
        let radius_m = blend(ends_m, fraction);
        let displaced = density_kg_per_m3 * PI * radius_m * radius_m;
        let slope = (ends_m[1] - ends_m[0]).abs() / length_m;
        let across = displaced * blend(coefficients.across, fraction);
        let along = 2.0 * displaced * slope * blend(coefficients.along, fraction);
        axial(across, along, axis)
    }

    /// Density, outer and inner radius of the growth at a fraction.
    fn growth_ring(&self, fraction: f64) -> Option<[f64; 3]> {
        let growth = self.growth?;
        let inner_m = blend(self.outer_radius_m, fraction);
        let outer_m = inner_m + blend(growth.thickness_m, fraction);
        Some([blend(growth.density_kg_per_m3, fraction), outer_m, inner_m])
    }

    /// Density, outer and inner radius of the filling at a fraction.
    fn filling_ring(&self, fraction: f64) -> Option<[f64; 3]> {
        let density = self.fill_density_kg_per_m3;
        (density > 0.0).then(|| [density, blend(self.inner_radius_m, fraction), 0.0])
    }

    /// Growth and filling per length (kg/m) at a fraction.
    pub(super) fn solid_kg_per_m(&self, fraction: f64) -> f64 {
        let rings = [self.growth_ring(fraction), self.filling_ring(fraction)];
        let mass =
            |[density, outer, inner]: [f64; 3]| density * PI * (outer * outer - inner * inner);
        rings.into_iter().flatten().map(mass).sum()
    }
}

/// A disc with a hole, by its density, radii and thickness.
pub(super) fn disc([density, outer, inner]: [f64; 3], slice: &Slice, axis: Vector) -> RigidBody {
    let squares = outer * outer + inner * inner;
    let mass_kg = density * PI * (outer * outer - inner * inner) * slice.length_m;
    let tensor = axial(0.25 * mass_kg * squares, 0.5 * mass_kg * squares, axis);
    RigidBody {
        mass_kg,
        center_m: slice.center_m,
        inertia_kg_m2: Inertia::from_tensor(tensor),
    }
}

fn body_of(
    members: &[StripMember],
    ring: impl Fn(&Stretch, f64) -> Option<[f64; 3]>,
) -> Vec<RigidBody> {
    let mut bodies = Vec::new();
    for member in members {
        let axis = member.axis();
        for stretch in &member.stretches {
            for slice in slices(member, stretch, [0.0, 1.0]) {
                bodies.extend(ring(stretch, slice.fraction).map(|ring| disc(ring, &slice, axis)));
            }
        }
    }
    bodies
}

/// The filling of the members, as one rigid body.
pub(super) fn filling(members: &[StripMember]) -> RigidBody {
    RigidBody::combined(&body_of(members, Stretch::filling_ring))
}

/// The marine growth on members and their ends, as one rigid body.
pub(super) fn growth(members: &[StripMember], ends: &[StripEnd]) -> RigidBody {
    let mut bodies = body_of(members, Stretch::growth_ring);
    let of_ends = ends.iter().filter(|end| end.growth_kg > 0.0);
    bodies.extend(of_ends.map(|end| RigidBody::point(end.growth_kg, end.position_m)));
    RigidBody::combined(&bodies)
}

/// The added mass of members and their ends for the motion of the origin.
pub(super) fn added_mass(
    members: &[StripMember],
    ends: &[StripEnd],
    density_kg_per_m3: f64,
) -> SpatialMatrix {
    let mut sum = NONE;
    for member in members {
        let axis = member.axis();
        for stretch in &member.stretches {
            let length_m = member.length_m() * (stretch.range[1] - stretch.range[0]);
            for slice in slices(member, stretch, [0.0, 1.0]) {
                let density = density_kg_per_m3;
                let tensor = stretch.added_mass(slice.fraction, length_m, axis, density);
                add(&mut sum, slice.length_m, &of_mass(&tensor, slice.center_m));
            }
        }
    }
    for end in ends {
        add(&mut sum, 1.0, &of_mass(&end.added_mass, end.position_m));
    }
    sum
}

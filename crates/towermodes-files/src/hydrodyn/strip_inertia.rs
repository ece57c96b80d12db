//! Added mass and rigid bodies of strip members: integrals over their stretches.

use towermodes::space::SpatialMatrix;
use towermodes::{Inertia, RigidBody};

use super::ends::StripEnd;
use super::section::{Outline, blend};
use super::spatial::{NONE, Tensor, Vector, add, of_mass};
use super::strip::{Stretch, StripMember};

/// Points and weights of Gauss quadrature on 0 to 1; exact for polynomials of degree 7; the
/// integrands have at most degree 5.
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

/// A slice of a stretch: its position as a fraction of the stretch, its centre and its length.
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

/// The tensor with these values along the axes x, y, z of a member: α x xᵀ + β y yᵀ + γ z zᵀ. It
/// does not depend on x and y if α = β, as for a circle.
fn principal([alpha, beta, gamma]: [f64; 3], [_, y, z]: &Tensor) -> Tensor {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let diagonal = if i == j { alpha } else { 0.0 };
            diagonal + (beta - alpha) * y[i] * y[j] + (gamma - alpha) * z[i] * z[j]
        })
    })
}

/// A part of a section with mass: density (kg/m³), outer and inner outline.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ring {
    pub(super) density_kg_per_m3: f64,
    pub(super) outer: Outline,
    pub(super) inner: Option<Outline>,
}

impl Ring {
    fn kg_per_m(&self) -> f64 {
        let hole_m2 = self.inner.map_or(0.0, Outline::area_m2);
        self.density_kg_per_m3 * (self.outer.area_m2() - hole_m2)
    }

    /// Its inertia per length about x, y and z.
    fn rotary_kg_m(&self) -> [f64; 3] {
        let hole_m4 = self.inner.map_or([0.0; 2], Outline::second_moments_m4);
        let whole_m4 = self.outer.second_moments_m4();
        let [x, y] = [0, 1].map(|i| self.density_kg_per_m3 * (whole_m4[i] - hole_m4[i]));
        [x, y, x + y]
    }

    /// The rigid body of a slice of a member with these axes.
    pub(super) fn disc(&self, slice: &Slice, axes: &Tensor) -> RigidBody {
        let rotary = self.rotary_kg_m().map(|per_m| per_m * slice.length_m);
        RigidBody {
            mass_kg: self.kg_per_m() * slice.length_m,
            center_m: slice.center_m,
            inertia_kg_m2: Inertia::from_tensor(principal(rotary, axes)),
        }
    }
}

impl Stretch {
    /// Added mass per length (kg/m) at a fraction of a stretch of this length (m), for a member
    /// with these axes.
    pub(super) fn added_mass(
        &self,
        fraction: f64,
        length_m: f64,
        axes: &Tensor,
        density_kg_per_m3: f64,
    ) -> Tensor {
        let Some(coefficients) = self.added_mass else {
            return [[0.0; 3]; 3];
        };
        let outline = self.grown(fraction);
        let areas_m2 = outline.reference_areas_m2();
        let [from, to] = coefficients.across;
        let [x, y] = [0, 1].map(|i| areas_m2[i] * blend([from[i], to[i]], fraction));
        let along_m2 = self
            .section
            .axial_reference_m2(fraction, self.growth_m(), length_m);
        let z = along_m2 * blend(coefficients.along, fraction);
        principal([x, y, z].map(|area| density_kg_per_m3 * area), axes)
    }

    /// The growth at a fraction of the stretch.
    fn growth_ring(&self, fraction: f64) -> Option<Ring> {
        let growth = self.growth?;
        Some(Ring {
            density_kg_per_m3: blend(growth.density_kg_per_m3, fraction),
            outer: self.grown(fraction),
            inner: Some(self.section.outer(fraction)),
        })
    }

    /// The filling at a fraction of the stretch.
    fn filling_ring(&self, fraction: f64) -> Option<Ring> {
        let density_kg_per_m3 = self.fill_density_kg_per_m3;
        (density_kg_per_m3 > 0.0).then(|| Ring {
            density_kg_per_m3,
            outer: self.section.inner(fraction),
            inner: None,
        })
    }

    /// Growth and filling at a fraction of the stretch.
    pub(super) fn solids(&self, fraction: f64) -> impl Iterator<Item = Ring> {
        let rings = [self.growth_ring(fraction), self.filling_ring(fraction)];
        rings.into_iter().flatten()
    }
}

fn body_of(
    members: &[StripMember],
    ring: impl Fn(&Stretch, f64) -> Option<Ring>,
) -> Vec<RigidBody> {
    let mut bodies = Vec::new();
    for member in members {
        let axes = member.axes();
        for stretch in &member.stretches {
            for slice in slices(member, stretch, [0.0, 1.0]) {
                bodies.extend(ring(stretch, slice.fraction).map(|ring| ring.disc(&slice, &axes)));
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

/// The added mass of members and their ends for motions of the origin.
pub(super) fn added_mass(
    members: &[StripMember],
    ends: &[StripEnd],
    density_kg_per_m3: f64,
) -> SpatialMatrix {
    let mut sum = NONE;
    for member in members {
        let axes = member.axes();
        for stretch in &member.stretches {
            let length_m = member.length_m() * (stretch.range[1] - stretch.range[0]);
            for slice in slices(member, stretch, [0.0, 1.0]) {
                let density = density_kg_per_m3;
                let tensor = stretch.added_mass(slice.fraction, length_m, &axes, density);
                add(&mut sum, slice.length_m, &of_mass(&tensor, slice.center_m));
            }
        }
    }
    for end in ends {
        add(&mut sum, 1.0, &of_mass(&end.added_mass, end.position_m));
    }
    sum
}

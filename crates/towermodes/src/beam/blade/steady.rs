//! The steady forces in a rotating blade: the internal forces due to the centrifugal force.

use super::super::element::Stencil;
use super::tensor::{Tensor, Vector, across, cross, times};
use crate::blade::{Blade, BladeSection};
use crate::space::SpatialMatrix;
use crate::tower::RigidBody;

/// Mass with its moments about the blade's axis: of a section per length, or of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mass {
    /// kg/m, or kg.
    pub(crate) mass: f64,
    /// First moment ∫ r dm, kg, or kg m.
    pub(super) moment: Vector,
    /// Second moments ∫ r rᵀ dm, kg m, or kg m².
    pub(crate) second: Tensor,
}

impl Mass {
    /// The mass of a section that is rotated by an angle, given by its sin and cos, from X towards
    /// Y.
    pub(super) fn of_section(section: &BladeSection, (sin, cos): (f64, f64)) -> Self {
        let (x, y) = ([cos, sin, 0.0], [-sin, cos, 0.0]);
        let (m, offset_m) = (section.mass_kg_per_m, section.center_of_mass_m);
        let (along, over) = (section.edge_inertia_kg_m, section.flap_inertia_kg_m);
        Self {
            mass: m,
            moment: x.map(|x| m * offset_m * x),
            second: std::array::from_fn(|i| {
                std::array::from_fn(|j| along * x[i] * x[j] + over * y[i] * y[j])
            }),
        }
    }

    /// The mass of a body about the tip: second moments are ½ tr(J) 1 − J.
    pub(super) fn of_body(body: &RigidBody) -> Self {
        let about_tip = body.tensor_about([0.0; 3]);
        let half_trace = 0.5 * (about_tip[0][0] + about_tip[1][1] + about_tip[2][2]);
        Self {
            mass: body.mass_kg,
            moment: body.center_m.map(|c| body.mass_kg * c),
            second: std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    let diagonal = if i == j { half_trace } else { 0.0 };
                    diagonal - about_tip[i][j]
                })
            }),
        }
    }

    /// of the mass at a radius (m)
    fn centrifugal(&self, axis: Vector, radius_m: f64) -> SteadyForces {
        let across = across(axis);
        let outwards = times(&across, [0.0, 0.0, radius_m]);
        let from_moment = times(&across, self.moment);
        let own = cross(axis, times(&self.second, axis));
        let offset = cross(self.moment, outwards);
        SteadyForces {
            force: std::array::from_fn(|i| self.mass * outwards[i] + from_moment[i]),
            moment: std::array::from_fn(|i| offset[i] + own[i]),
        }
    }
}

/// Force F and moment Q in a section due to the part of the blade outside it, per Ω²: kg m and kg
/// m².
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct SteadyForces {
    pub(crate) force: Vector,
    pub(super) moment: Vector,
}

impl SteadyForces {
    /// Adds forces that act `lever_m` (m) further out: their moment is t × F times this distance.
    fn add(&mut self, factor: f64, forces: &Self, lever_m: f64) {
        let turned = along_cross(forces.force);
        for (i, turned) in turned.into_iter().enumerate() {
            self.force[i] += factor * forces.force[i];
            self.moment[i] += factor * (forces.moment[i] + lever_m * turned);
        }
    }
}

/// The steady forces of a whole blade.
pub(super) struct Steady {
    /// Forces at the points of each element, from the root.
    pub(crate) elements: Vec<Vec<SteadyForces>>,
    /// Forces at the root.
    root: SteadyForces,
}

impl Steady {
    /// K_g of the rigid and massless stretch of this length (m) inside the root: −R F·Θ×(Θ×t).
    pub(crate) fn stretch(&self, length_m: f64) -> SpatialMatrix {
        let turned = twice_second_order(self.root.force);
        let mut matrix = [[0.0; 6]; 6];
        for i in 0..3 {
            for j in 0..3 {
                matrix[3 + i][3 + j] = length_m * turned[i][j];
            }
        }
        matrix
    }
}

/// The steady forces at the points of elements between these fractions of the span.
pub(super) fn steady_forces(
    blade: &Blade,
    axis: Vector,
    borders: &[f64],
    stencil: &Stencil,
) -> Steady {
    let description = blade.description();
    let tip = Mass::of_body(&description.tip);
    let mut outside = tip.centrifugal(axis, description.tip_radius_m);
    let mut elements = Vec::with_capacity(borders.len());
    for border in borders.windows(2).rev() {
        let (from_m, to_m) = (blade.radius_m(border[0]), blade.radius_m(border[1]));
        let inside = |radius_m| between(blade, axis, (radius_m, to_m), &outside, stencil);
        let radii_m = stencil.heights_m(from_m, to_m - from_m);
        elements.push(radii_m.map(inside).collect());
        outside = inside(from_m);
    }
    elements.reverse();
    Steady {
        elements,
        root: outside,
    }
}

/// The forces at the inner of two radii (m) of an element, from the forces at the outer one.
fn between(
    blade: &Blade,
    axis: Vector,
    (inner_m, outer_m): (f64, f64),
    outside: &SteadyForces,
    stencil: &Stencil,
) -> SteadyForces {
    let length_m = outer_m - inner_m;
    let mut sum = SteadyForces::default();
    sum.add(1.0, outside, length_m);
    let radii_m = stencil.heights_m(inner_m, length_m);
    for (radius_m, (_, weight)) in radii_m.zip(&stencil.points) {
        let (section, turn) = section_at(blade, radius_m);
        let own = Mass::of_section(&section, turn).centrifugal(axis, radius_m);
        sum.add(0.5 * length_m * weight, &own, radius_m - inner_m);
    }
    sum
}

/// The matrix of −F·Θ×(Θ×t) = (F·t) Θ² − (F·Θ)(t·Θ) with t along the span.
pub(super) fn twice_second_order(force: Vector) -> Tensor {
    let mut matrix = [[0.0; 3]; 3];
    for i in 0..3 {
        matrix[i][i] += force[2];
        matrix[i][2] -= 0.5 * force[i];
        matrix[2][i] -= 0.5 * force[i];
    }
    matrix
}

/// t × F with t along the span.
fn along_cross([x, y, _]: Vector) -> Vector {
    [-y, x, 0.0]
}

/// The section at a radius (m), and sin and cos of its angle from X towards Y: twist and pitch
/// towards feather turn it from X away from Y.
pub(crate) fn section_at(blade: &Blade, radius_m: f64) -> (BladeSection, (f64, f64)) {
    let description = blade.description();
    let span = (radius_m - description.hub_radius_m) / blade.length_m();
    let section = blade.section_at(span);
    let (sin, cos) = (section.twist_rad + description.pitch_rad).sin_cos();
    (section, (-sin, cos))
}

//! The floating platform above a tower that hangs, mirrored with its tower in the plane z = 0.

use std::sync::Arc;

use towermodes::space::SpatialMatrix;
use towermodes::{FloatingPlatform, ReferredMatrix, RigidBody};

use super::tower_input::description::upside_down;
use crate::note::Note;

/// The sign of each component in the mirrored axes: translation along z and rotations about x and y
/// are reversed.
const SIGNS: [f64; 6] = [1.0, 1.0, -1.0, -1.0, -1.0, 1.0];

/// A platform whose moorings are a matrix, mirrored in the plane z = 0.
///
/// A hanging tower is solved without gravity, so here the weight of the platform is included in its
/// hydrostatic stiffness.
pub(super) fn mirrored(platform: &FloatingPlatform, gravity_m_per_s2: f64) -> FloatingPlatform {
    let body = upside_down(&RigidBody {
        mass_kg: platform.mass_kg,
        center_m: platform.center_m,
        inertia_kg_m2: platform.inertia_kg_m2,
    });
    let mut hydrostatic = platform.hydrostatic;
    let weight_n = platform.mass_kg * gravity_m_per_s2;
    let above_m = platform.center_m[2] - hydrostatic.height_m;
    // As under a tower that stands, the effect of the lateral offset is neglected.
    for i in [3, 4] {
        hydrostatic.matrix[i][i] -= weight_n * above_m;
    }
    let table = platform.added_mass_by_frequency.as_deref();
    FloatingPlatform {
        mass_kg: body.mass_kg,
        center_m: body.center_m,
        inertia_kg_m2: body.inertia_kg_m2,
        added_mass: referred(&platform.added_mass),
        added_mass_by_frequency: table.map(|table| Arc::new(table.clone().map(matrix))),
        hydrostatic: referred(&hydrostatic),
        mooring: referred(&platform.mooring),
        ..FloatingPlatform::default()
    }
}

fn referred(given: &ReferredMatrix) -> ReferredMatrix {
    ReferredMatrix {
        matrix: matrix(&given.matrix),
        height_m: 0.0 - given.height_m,
    }
}

fn matrix(given: &SpatialMatrix) -> SpatialMatrix {
    std::array::from_fn(|i| std::array::from_fn(|j| SIGNS[i] * given[i][j] * SIGNS[j]))
}

/// The note on the content of the mirrored platform.
pub(super) fn note() -> Note {
    Note::approximation(
        "the platform above a hanging tower has the stiffness of its weight, its hydrostatics and its mooring lines at the reference position; the weights of tower and rotor-nacelle assembly minus their buoyancy are neglected in this stiffness",
    )
}

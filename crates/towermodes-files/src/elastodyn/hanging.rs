//! Towers that hang: those of floating turbines in a current (MHK), whose top is the lower end.
//!
//! The library's towers stand. A hanging one is solved upside down: heights become depths, and what
//! is below the top becomes what is above it. Without weights its frequencies are the same.

use towermodes::{Inertia, RigidBody};

use super::description::Ends;
use crate::input::Note;

/// A body mirrored in the plane z = 0.
pub(super) fn upside_down(body: &RigidBody) -> RigidBody {
    let [x, y, z] = body.center_m;
    let own = body.inertia_kg_m2;
    RigidBody {
        mass_kg: body.mass_kg,
        center_m: [x, y, 0.0 - z],
        inertia_kg_m2: Inertia {
            xz: 0.0 - own.xz,
            yz: 0.0 - own.yz,
            ..own
        },
    }
}

/// That a tower is solved upside down.
pub(super) fn note(ends: Ends) -> Note {
    Note::new(format!(
        "the tower hangs from z = {} m down to {} m: it is solved upside down, its heights are depths, and weights and buoyancy, which act against each other, are left out",
        0.0 - ends.base_m,
        0.0 - ends.top_m
    ))
}

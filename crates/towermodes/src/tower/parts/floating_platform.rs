//! A rigid floating platform.

use std::sync::Arc;

use super::added_mass::AddedMassTable;
use super::inertia::Inertia;
use super::mooring_lines::MooringLines;
use crate::space::{SpatialMatrix, add_scaled};

/// A matrix for the motion (x, y, z, rotation about x, y, z) of a point on the tower's axis.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ReferredMatrix {
    /// The matrix.
    pub matrix: SpatialMatrix,
    /// Height of the point in the datum of the stations, m.
    pub height_m: f64,
}

/// A rigid platform that floats and carries the tower's base.
///
/// Slightly asymmetric matrices are symmetrized, with a warning.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FloatingPlatform {
    /// Mass with ballast, kg.
    pub mass_kg: f64,
    /// Centre of mass, m: x and y from the tower's axis, z in the datum of the stations.
    pub center_m: [f64; 3],
    /// Inertia about the centre of mass, kg m².
    pub inertia_kg_m2: Inertia,
    /// Hydrodynamic added mass: kg, kg m, kg m².
    pub added_mass: ReferredMatrix,
    /// Added mass that depends on frequency, beside the constant one and about the same point.
    pub added_mass_by_frequency: Option<Arc<AddedMassTable>>,
    /// Hydrostatic stiffness of water plane and buoyancy: N/m, N, N m. The gravity part
    /// is that of gravity.
    pub hydrostatic: ReferredMatrix,
    /// The buoyancy at the reference position, for the
    /// [static balance](crate::tower::Tower::static_balance); no frequency at the reference
    /// position depends on it.
    pub buoyancy: Option<Buoyancy>,
    /// Stiffness of the moorings that is given as a matrix: N/m, N, N m.
    pub mooring: ReferredMatrix,
    /// Mooring lines, whose stiffness is added to the matrix.
    pub mooring_lines: Option<Box<MooringLines>>,
    /// Whether the lines have their stiffness at the position in which weights, buoyancy and lines
    /// are in balance, instead of the reference position. It needs the buoyancy.
    pub at_equilibrium: bool,
}

/// The upward force of the water on a floating platform at its reference position.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Buoyancy {
    /// Force ρ g V, N. The vertical force of moorings that are given as a matrix belongs to it too.
    pub force_n: f64,
    /// Where it acts, m: x and y from the tower's axis. Its height is part of the
    /// [hydrostatic stiffness](FloatingPlatform::hydrostatic).
    pub center_m: [f64; 2],
}

impl FloatingPlatform {
    /// The added mass at an angular frequency (rad/s), constant or not.
    pub fn added_mass_at(&self, frequency: f64) -> ReferredMatrix {
        let mut added = self.added_mass;
        if let Some(table) = &self.added_mass_by_frequency {
            add_scaled(&mut added.matrix, 1.0, &table.at(frequency));
        }
        added
    }

    /// Its added mass alone, about the height of its hydrostatic stiffness, which is zero.
    pub(in crate::tower) fn added_mass_alone(&self) -> Self {
        Self {
            added_mass: self.added_mass,
            added_mass_by_frequency: self.added_mass_by_frequency.clone(),
            hydrostatic: ReferredMatrix {
                height_m: self.hydrostatic.height_m,
                ..ReferredMatrix::default()
            },
            ..Self::default()
        }
    }

    /// The same platform with the constant added mass that it has at an angular frequency (rad/s).
    #[must_use]
    pub fn with_added_mass_at(&self, frequency: f64) -> Self {
        Self {
            added_mass: self.added_mass_at(frequency),
            added_mass_by_frequency: None,
            ..self.clone()
        }
    }
}

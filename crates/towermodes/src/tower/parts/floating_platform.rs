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
    /// Added mass that depends on frequency, in addition to the constant added mass and about the
    /// same point.
    pub added_mass_by_frequency: Option<Arc<AddedMassTable>>,
    /// Hydrostatic stiffness of water plane and buoyancy: N/m, N, N m. It does not contain the
    /// gravity terms of the masses, which are added if there is gravity.
    pub hydrostatic: ReferredMatrix,
    /// The buoyancy at the reference position, for the [static
    /// balance](crate::tower::Tower::static_balance); it has no effect on frequencies at the
    /// reference position.
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
    /// Force ρ g V, N; with the vertical force of moorings that are given as a matrix added.
    pub force_n: f64,
    /// Centre of buoyancy, m: x and y from the tower's axis. Its height is part of the [hydrostatic
    /// stiffness](FloatingPlatform::hydrostatic).
    pub center_m: [f64; 2],
}

impl FloatingPlatform {
    /// The added mass at an angular frequency (rad/s): the constant part and the part that depends
    /// on frequency.
    pub fn added_mass_at(&self, frequency: f64) -> ReferredMatrix {
        let mut added = self.added_mass;
        if let Some(table) = &self.added_mass_by_frequency {
            add_scaled(&mut added.matrix, 1.0, &table.at(frequency));
        }
        added
    }

    /// The platform with only its added mass, about the height of its hydrostatic stiffness;
    /// everything else is zero.
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

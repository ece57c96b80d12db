//! The stiffness of a platform's mooring lines, added to that of its matrix.

use super::super::parts::floating_platform::{FloatingPlatform, ReferredMatrix};
use crate::mooring::{MooringError, Pose};
use crate::space::{SpatialMatrix, add_scaled, transform_matrix};

impl FloatingPlatform {
    /// The platform whose lines are replaced by their stiffness at its reference position and by
    /// the mass of what they have on the platform.
    ///
    /// # Errors
    /// [`MooringError`] of the lines.
    pub fn with_linear_moorings(&self) -> Result<Self, MooringError> {
        let lines = self.mooring_lines.as_ref();
        let height_m = lines.map_or(0.0, |lines| lines.reference_height_m());
        self.with_moorings_at(&Pose::default(), height_m)
    }

    /// The platform with the stiffness of its lines at any pose of the point at a height on the
    /// tower's axis, m.
    pub(in crate::tower) fn with_moorings_at(
        &self,
        pose: &Pose,
        height_m: f64,
    ) -> Result<Self, MooringError> {
        let mut platform = self.clone();
        let Some(lines) = platform.mooring_lines.take() else {
            return Ok(platform);
        };
        let mooring = lines.mooring_about(height_m)?;
        let state = mooring.at(pose)?;
        platform.mooring.add(&state.load.stiffness, height_m);
        let carried = mooring.platform_mass();
        match &platform.added_mass_by_frequency {
            None => platform.added_mass.add(&carried, height_m),
            // The table is about the height of the matrix, even of one of zeros.
            Some(_) => platform.added_mass.add_moved(&carried, height_m),
        }
        Ok(platform)
    }
}

impl ReferredMatrix {
    /// Adds a matrix about another height, m. A matrix of zeros has no height of its own.
    fn add(&mut self, matrix: &SpatialMatrix, height_m: f64) {
        if *matrix == [[0.0; 6]; 6] {
            return;
        }
        if self.matrix == [[0.0; 6]; 6] {
            self.height_m = height_m;
        }
        self.add_moved(matrix, height_m);
    }

    /// Adds a matrix about another height, m, and keeps the height of this matrix.
    fn add_moved(&mut self, matrix: &SpatialMatrix, height_m: f64) {
        let mut moved = *matrix;
        if height_m != self.height_m {
            transform_matrix(&mut moved, height_m - self.height_m);
        }
        add_scaled(&mut self.matrix, 1.0, &moved);
    }
}

//! The mooring lines of a floating platform.

use crate::mooring::{Fairlead, Mooring, MooringDescription, MooringError, MooringLoad, Pose};

/// Mooring lines that hold a platform. Their force on the platform at its reference position and
/// their stiffness are about a point on the tower's axis.
#[derive(Debug, Clone, PartialEq)]
pub struct MooringLines {
    /// The lines. Their positions are from the tower's axis and from still water.
    pub description: MooringDescription,
    /// Height of still water in the datum of the stations, m.
    pub still_water_m: f64,
}

impl MooringLines {
    /// The checked lines, about a point of the tower's axis at the height of their reference point.
    ///
    /// # Errors
    /// [`MooringError`] for the first invalid value.
    pub fn mooring(&self) -> Result<Mooring, MooringError> {
        self.about(self.description.reference_m[2])
    }

    /// The mooring system about the point of the tower's axis at a height in the datum of the
    /// stations, m.
    pub(in crate::tower) fn mooring_about(&self, height_m: f64) -> Result<Mooring, MooringError> {
        self.about(height_m - self.still_water_m)
    }

    fn about(&self, z_m: f64) -> Result<Mooring, MooringError> {
        Mooring::with_anchors_on_seabed(self.described_about(z_m))
    }

    fn described_about(&self, z_m: f64) -> MooringDescription {
        MooringDescription {
            reference_m: [0.0, 0.0, z_m],
            ..self.description.clone()
        }
    }

    /// The fairleads of lines that hold the platform each by itself, at a pose of the point of the
    /// tower's axis at a height; positions and height in the datum of the stations, m.
    ///
    /// # Errors
    /// [`MooringError`] of a line.
    pub(in crate::tower) fn fairleads(
        &self,
        height_m: f64,
        pose: &Pose,
    ) -> Result<Vec<Fairlead>, MooringError> {
        let described = self.described_about(height_m - self.still_water_m);
        let mut fairleads = described.fairleads(pose)?;
        for fairlead in &mut fairleads {
            fairlead.position_m[2] += self.still_water_m;
        }
        Ok(fairleads)
    }

    /// Their force on the platform at its reference position, and their stiffness, about the
    /// height [`reference_height_m`](Self::reference_height_m) on the tower's axis.
    ///
    /// # Errors
    /// [`MooringError`]: impossible lines, lines that cannot reach, free parts without equilibrium.
    pub fn at_rest(&self) -> Result<MooringLoad, MooringError> {
        Ok(self.mooring()?.at(&Pose::default())?.load)
    }

    /// The height of the reference point in the datum of the stations, m.
    pub fn reference_height_m(&self) -> f64 {
        self.still_water_m + self.description.reference_m[2]
    }
}

//! The stiffness of each line of a mooring system at its fairlead.

use super::description::{Attachment, MooringDescription, MooringLine};
use super::error::MooringError;
use super::pose::Pose;
use super::system::Mooring;
use super::vector::{Matrix3, Vector, difference, sum, times};

/// A line between an anchor and the platform, at its fairlead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fairlead {
    /// The fairlead at the reference pose, m.
    pub(crate) position_m: Vector,
    /// Stiffness of the line against translations of the fairlead, N/m.
    pub(crate) stiffness: Matrix3,
}

impl MooringDescription {
    /// The fairleads of lines between an anchor and the platform at a pose of the platform; empty
    /// where free points, bodies or rods couple lines, or where a line has other ends.
    ///
    /// # Errors
    /// [`MooringError`] of a line.
    pub(crate) fn fairleads(&self, pose: &Pose) -> Result<Vec<Fairlead>, MooringError> {
        if !(self.bodies.is_empty() && self.rods.is_empty()) {
            return Ok(Vec::new());
        }
        let mut found = Vec::with_capacity(self.lines.len());
        for line in &self.lines {
            let Some(alone) = self.alone(line) else {
                return Ok(Vec::new());
            };
            let position_m = alone.reference_m;
            let arm_m = difference(position_m, self.reference_m);
            let turned_m = difference(times(&pose.rotation, arm_m), arm_m);
            let moved = Pose {
                displacement_m: sum(pose.displacement_m, turned_m),
                ..Pose::default()
            };
            let stiffness = Mooring::new(alone)?.at(&moved)?.load.stiffness;
            let entry = |i: usize, j: usize| 0.5 * (stiffness[i][j] + stiffness[j][i]);
            found.push(Fairlead {
                position_m,
                stiffness: std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))),
            });
        }
        Ok(found)
    }

    /// A single line, about its fairlead.
    fn alone(&self, line: &MooringLine) -> Option<Self> {
        let points = line.points.map(|point| self.points[point]);
        let position_m = match points.each_ref().map(|point| point.attachment) {
            [Attachment::Fixed, Attachment::Platform] => points[1].position_m,
            [Attachment::Platform, Attachment::Fixed] => points[0].position_m,
            _ => return None,
        };
        Some(Self {
            reference_m: position_m,
            points: points.into(),
            lines: vec![MooringLine {
                points: [0, 1],
                ..*line
            }],
            ..self.clone()
        })
    }
}

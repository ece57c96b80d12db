//! What is possible in a mooring system but probably a mistake.

use thiserror::Error;

use super::description::Attachment;
use super::state::MooringState;
use super::system::Mooring;
use crate::number::Plain;

/// Anchors higher than this fraction of the depth are above the seabed.
const ROUNDED: f64 = 1e-6;

/// A fact that a user should check, with its numbers; indices count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum MooringWarning {
    /// An anchor above the seabed.
    #[error(
        "the anchor point {} is at z = {} m, {} m above the seabed; its lines hang from it as from a pole. If it is on the seabed, the depth must be {} m instead of {} m",
        .point + 1, Plain(*.z_m), Plain(z_m + depth_m), Plain(-*.z_m), Plain(*.depth_m)
    )]
    AnchorAboveSeabed {
        /// The point.
        point: usize,
        /// Its height, m.
        z_m: f64,
        /// The depth, m.
        depth_m: f64,
    },
    /// A line without horizontal tension.
    #[error(
        "line {} is slack: its length of {} m is more than the way along the seabed and up to its end, so that it does not hold the platform; shorten it, or correct the \
         positions of its ends",
        .line + 1, Plain(*.length_m)
    )]
    Slack {
        /// The line.
        line: usize,
        /// Its length without tension, m.
        length_m: f64,
    },
    /// A line that leaves the water.
    #[error(
        "line {} reaches up to z = {} m, above still water; its buoyancy is that of a line under water over its whole length",
        .line + 1, Plain(*.z_m)
    )]
    AboveWater {
        /// The line.
        line: usize,
        /// Its greatest height, m.
        z_m: f64,
    },
}

impl Mooring {
    /// What is possible but probably a mistake, at a state of this mooring system.
    pub fn warnings(&self, state: &MooringState) -> Vec<MooringWarning> {
        let mut warnings = Vec::new();
        let mooring = &self.description;
        let depth_m = mooring.depth_m;
        for (index, point) in mooring.points.iter().enumerate() {
            let z_m = point.position_m[2];
            if point.attachment == Attachment::Fixed && z_m + depth_m > ROUNDED * depth_m {
                warnings.push(MooringWarning::AnchorAboveSeabed {
                    point: index,
                    z_m,
                    depth_m,
                });
            }
        }
        for (line, (given, found)) in mooring.lines.iter().zip(&state.lines).enumerate() {
            let length_m = given.length_m;
            if found.is_slack {
                warnings.push(MooringWarning::Slack { line, length_m });
            }
            let ends_m = given.points.map(|point| state.points_m[point][2]);
            let z_m = ends_m[0].max(ends_m[1]).max(found.extreme_z_m);
            if z_m > 0.0 {
                warnings.push(MooringWarning::AboveWater { line, z_m });
            }
        }
        warnings
    }
}

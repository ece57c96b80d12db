//! Names of modes: a part of the turbine, and the order among the modes with that part.

use std::fmt;

use super::energy::{BladeMotion, Harmonic, Nodding, TurbinePart};
use crate::modes::Ordinal;

/// The name of a mode of a turbine. Its text is the usual term for wind turbines: "1st tower
/// fore-aft", "1st flapwise backward whirl", "2nd edgewise collective", "1st drivetrain torsion".
///
/// # Example
/// ```
/// use towermodes::turbine::{BladeMotion, Harmonic, TurbineModeName, TurbinePart};
///
/// let part = TurbinePart::Blades(BladeMotion::Flap, Harmonic::Backward);
/// let name = TurbineModeName { part, order: 1 };
/// assert_eq!(name.to_string(), "1st flapwise backward whirl");
/// assert_eq!(name.column(), "flapwise_backward_whirl_1");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TurbineModeName {
    /// The part of the turbine that names the mode.
    pub part: TurbinePart,
    /// Order by frequency among the modes with this part, from 1.
    pub order: usize,
}

impl TurbineModeName {
    /// The name, followed by the motion of the nacelle in parentheses if it is given: "1st flapwise
    /// backward whirl (yaw)".
    pub fn with(&self, nodding: Option<Nodding>) -> String {
        match nodding {
            None => self.to_string(),
            Some(nodding) => format!("{self} ({nodding})"),
        }
    }

    /// The name as the beginning of a column's name: `flapwise_backward_whirl_1`.
    pub fn column(&self) -> String {
        let part = self.part.to_string().replace([' ', '-'], "_");
        format!("{part}_{}", self.order)
    }
}

impl fmt::Display for TurbineModeName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", Ordinal(self.order), self.part)
    }
}

/// "tilt", "yaw".
impl fmt::Display for Nodding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Tilt => "tilt",
            Self::Yaw => "yaw",
        })
    }
}

impl fmt::Display for TurbinePart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Platform(motion) => return write!(f, "platform {}", motion.name()),
            Self::Substructure => "substructure",
            Self::TowerForeAft => "tower fore-aft",
            Self::TowerSideSide => "tower side-side",
            Self::TowerTorsion => "tower torsion",
            Self::TowerAxial => "tower axial",
            Self::YawDrive => "yaw drive",
            Self::Shaft => "drivetrain torsion",
            Self::Blades(motion, harmonic) => return blades(*motion, *harmonic, f),
        })
    }
}

fn blades(motion: BladeMotion, harmonic: Harmonic, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let motion = motion.name();
    match harmonic {
        Harmonic::Collective => write!(f, "{motion} collective"),
        Harmonic::Forward => write!(f, "{motion} forward whirl"),
        Harmonic::Backward => write!(f, "{motion} backward whirl"),
        Harmonic::ForwardOf(waves) => write!(f, "{motion} forward, {waves} waves"),
        Harmonic::BackwardOf(waves) => write!(f, "{motion} backward, {waves} waves"),
        Harmonic::Alternating => write!(f, "{motion} alternating"),
    }
}

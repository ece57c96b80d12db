//! Names of modes: the part with most of the energy, and the order among the modes with that.

use std::collections::HashMap;
use std::fmt;

use super::energy::{BladeMotion, Harmonic, TurbinePart};
use crate::modes::Ordinal;

/// The name of a mode of a turbine. Its text is that of the field: "1st tower fore-aft", "1st
/// flapwise backward whirl", "2nd edgewise collective", "1st drivetrain torsion".
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
    /// The part.
    pub part: TurbinePart,
    /// Order by frequency among the modes with this part, from 1. A pair of tilt and yaw counts as
    /// one of forward and backward whirl.
    pub order: usize,
}

impl TurbineModeName {
    /// The name as the beginning of a column's name: `flapwise_backward_whirl_1`.
    pub fn column(&self) -> String {
        let part = self.part.to_string().replace([' ', '-'], "_");
        format!("{part}_{}", self.order)
    }
}

impl TurbineModeName {
    /// The names of modes with these parts by rising frequency.
    ///
    /// Tilt and yaw are mixtures of the two whirls, so that a pair of the one counts as a pair of
    /// the other: after the first whirls in flap the next tilt in flap is the 2nd.
    ///
    /// # Example
    /// ```
    /// use towermodes::turbine::{BladeMotion, Harmonic, TurbineModeName, TurbinePart};
    ///
    /// let flap = |harmonic| TurbinePart::Blades(BladeMotion::Flap, harmonic);
    /// let parts = [Harmonic::Backward, Harmonic::Forward, Harmonic::Tilt, Harmonic::Forward];
    /// let names = TurbineModeName::numbered(parts.map(flap));
    /// assert_eq!(names[2].to_string(), "2nd flapwise tilt");
    /// assert_eq!(names[3].to_string(), "2nd flapwise forward whirl");
    /// ```
    pub fn numbered(parts: impl IntoIterator<Item = TurbinePart>) -> Vec<Self> {
        let mut below: HashMap<TurbinePart, usize> = HashMap::new();
        let name = |part| {
            let order = 1 + before(part, |part| below.get(&part).copied().unwrap_or_default());
            *below.entry(part).or_default() += 1;
            Self { part, order }
        };
        parts.into_iter().map(name).collect()
    }
}

/// How many modes of the same kind as a part are below, by the number of modes of each part there.
fn before(part: TurbinePart, count: impl Fn(TurbinePart) -> usize) -> usize {
    let TurbinePart::Blades(motion, harmonic) = part else {
        return count(part);
    };
    let of = |harmonic| count(TurbinePart::Blades(motion, harmonic));
    let mixed = of(Harmonic::Tilt) + of(Harmonic::Yaw);
    match harmonic {
        Harmonic::Forward | Harmonic::Backward => of(harmonic) + mixed / 2,
        Harmonic::Tilt | Harmonic::Yaw => {
            (of(Harmonic::Forward) + of(Harmonic::Backward) + mixed) / 2
        }
        _ => of(harmonic),
    }
}

impl fmt::Display for TurbineModeName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", Ordinal(self.order), self.part)
    }
}

impl fmt::Display for TurbinePart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Platform(motion) => return write!(f, "platform {}", motion.name()),
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
        Harmonic::Tilt => write!(f, "{motion} tilt"),
        Harmonic::Yaw => write!(f, "{motion} yaw"),
        Harmonic::ForwardOf(waves) => write!(f, "{motion} forward, {waves} waves"),
        Harmonic::BackwardOf(waves) => write!(f, "{motion} backward, {waves} waves"),
        Harmonic::Alternating => write!(f, "{motion} alternating"),
    }
}

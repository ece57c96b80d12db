//! The stiffness class: where the first bending frequency lies relative to 1P and the blade passing
//! frequency.

use std::fmt;

use super::campbell::StiffnessClass;
use towermodes::tower::Rotor;

impl StiffnessClass {
    /// Its name in results: `soft-soft`, `soft-stiff`, `stiff-stiff`, or `met` if 1P or the blade
    /// passing frequency crosses the mode in operation.
    pub fn name(self) -> &'static str {
        match self {
            Self::SoftSoft => "soft-soft",
            Self::SoftStiff => "soft-stiff",
            Self::StiffStiff => "stiff-stiff",
            Self::Coincident { .. } => "met",
        }
    }
}

/// The name, or "crossed by 3P in operation".
impl fmt::Display for StiffnessClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Coincident { multiple } => write!(f, "crossed by {multiple}P in operation"),
            _ => f.write_str(self.name()),
        }
    }
}

/// The stiffness class of a frequency, Hz. Where the ranges of 1P and of the blade passing
/// frequency overlap, a frequency in both counts as crossed by 1P. A rotor of one blade has
/// one range.
pub(super) fn class(frequency_hz: f64, rotor: &Rotor) -> StiffnessClass {
    let range_hz = |multiple: usize| {
        let speeds = [rotor.lowest_rpm, rotor.highest_rpm];
        speeds.map(|rpm| multiple as f64 * rpm / 60.0)
    };
    let [lowest_hz, highest_hz] = range_hz(1);
    let [first_pass_hz, last_pass_hz] = range_hz(rotor.blades);
    if frequency_hz < lowest_hz {
        StiffnessClass::SoftSoft
    } else if frequency_hz <= highest_hz {
        StiffnessClass::Coincident { multiple: 1 }
    } else if frequency_hz > last_pass_hz {
        StiffnessClass::StiffStiff
    } else if frequency_hz < first_pass_hz {
        StiffnessClass::SoftStiff
    } else {
        StiffnessClass::Coincident {
            multiple: rotor.blades,
        }
    }
}

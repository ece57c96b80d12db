//! Where a tower's first bending frequency lies among the excitations.

use std::fmt;

use super::campbell::StiffnessClass;
use towermodes::tower::Rotor;

impl StiffnessClass {
    /// What it is called: "soft-stiff"; "met" where an excitation meets the mode.
    pub fn name(self) -> &'static str {
        match self {
            Self::SoftSoft => "soft-soft",
            Self::SoftStiff => "soft-stiff",
            Self::StiffStiff => "stiff-stiff",
            Self::Met { .. } => "met",
        }
    }
}

/// The name; of a mode that is met with the multiple: "met by 3P in operation".
impl fmt::Display for StiffnessClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Met { multiple } => write!(f, "met by {multiple}P in operation"),
            _ => f.write_str(self.name()),
        }
    }
}

/// The class of a frequency, Hz. Where the ranges of the rotor's speed and of the blades' passing
/// overlap, what both meet counts as met by the rotor's speed; a rotor of one blade has one range.
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
        StiffnessClass::Met { multiple: 1 }
    } else if frequency_hz > last_pass_hz {
        StiffnessClass::StiffStiff
    } else if frequency_hz < first_pass_hz {
        StiffnessClass::SoftStiff
    } else {
        StiffnessClass::Met {
            multiple: rotor.blades,
        }
    }
}

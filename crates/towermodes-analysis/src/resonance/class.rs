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

/// The stiffness class of a frequency, Hz. If the ranges of 1P and of the blade passing frequency
/// overlap, a frequency in both counts as crossed by 1P. A rotor of one blade has one range.
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

/// The stiffness class of a mode whose frequency depends on the rotor speed: rotor speeds (rpm) and
/// frequencies (Hz), including the lowest and the highest operating speed. None without operating
/// speeds.
pub(crate) fn class_along(points: &[[f64; 2]], rotor: &Rotor) -> Option<StiffnessClass> {
    let operates = |rpm: f64| (rotor.lowest_rpm..=rotor.highest_rpm).contains(&rpm);
    let in_operation: Vec<&[f64; 2]> = points.iter().filter(|[rpm, _]| operates(*rpm)).collect();
    // Whether all frequencies are above the multiple, or all below.
    let side = |multiple: usize| {
        let above = |point: &&[f64; 2]| multiple as f64 * point[0] / 60.0 < point[1];
        let count = in_operation.iter().copied().filter(above).count();
        match count {
            0 => Some(false),
            all if all == in_operation.len() => Some(true),
            _ => None,
        }
    };
    in_operation.first()?;
    Some(match (side(1), side(rotor.blades)) {
        (None, _) => StiffnessClass::Coincident { multiple: 1 },
        (Some(false), _) => StiffnessClass::SoftSoft,
        (_, Some(true)) => StiffnessClass::StiffStiff,
        (_, None) => StiffnessClass::Coincident {
            multiple: rotor.blades,
        },
        (_, Some(false)) => StiffnessClass::SoftStiff,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1P from 0.1 to 0.2 Hz, 3P from 0.3 to 0.6 Hz.
    #[test]
    fn a_changing_frequency_has_a_class() {
        let rotor = Rotor {
            blades: 3,
            lowest_rpm: 6.0,
            highest_rpm: 12.0,
        };
        let of = |lowest_hz: f64, highest_hz: f64| {
            let points = [
                [0.0, 0.01],
                [6.0, lowest_hz],
                [12.0, highest_hz],
                [14.0, 9.0],
            ];
            class_along(&points, &rotor)
        };
        assert_eq!(of(0.09, 0.05), Some(StiffnessClass::SoftSoft));
        assert_eq!(of(0.29, 0.25), Some(StiffnessClass::SoftStiff));
        assert_eq!(of(0.7, 0.65), Some(StiffnessClass::StiffStiff));
        assert_eq!(
            of(0.15, 0.15),
            Some(StiffnessClass::Coincident { multiple: 1 })
        );
        assert_eq!(
            of(0.4, 0.35),
            Some(StiffnessClass::Coincident { multiple: 3 })
        );
        // It stays below 3P although it is above the lowest 3P.
        assert_eq!(of(0.25, 0.5), Some(StiffnessClass::SoftStiff));
        assert_eq!(class_along(&[[0.0, 0.4]], &rotor), None);
    }
}

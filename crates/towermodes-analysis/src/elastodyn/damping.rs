//! The damping ratio in the tower file for a required damping ratio of the tower.
//!
//! From a ratio ζ in its file ElastoDyn computes the damping C = 2 ζ K/ω₁, where ω₁ is the
//! frequency of the tower without its rotor-nacelle assembly. With the assembly the frequency ω is
//! lower, and the damping ratio is C ω/(2 K) = ζ ω/ω₁, if the geometric stiffness of gravity is
//! neglected.

use thiserror::Error;

use towermodes::Plain;

/// Why a damping ratio cannot be written.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum DampingError {
    /// The required damping ratio is out of range.
    #[error("the damping is {} % of critical, but it must be 0 to 100 %", Plain(*.percent))]
    Wanted {
        /// The ratio, percent.
        percent: f64,
    },
    /// A frequency is not positive.
    #[error("the frequency of a damped mode is {} Hz, but it must be above 0", Plain(*.frequency_hz))]
    Frequency {
        /// The frequency, Hz.
        frequency_hz: f64,
    },
    /// The ratio to write is larger than OpenFAST accepts.
    #[error(
        "a damping ratio of {wanted_percent:.4} % of the tower with RNA requires {:.4} % in the file, but OpenFAST allows at most 100 %",
        Plain(*.percent)
    )]
    TooMuch {
        /// The required ratio, percent.
        wanted_percent: f64,
        /// The ratio to write, percent.
        percent: f64,
    },
}

/// The damping ratio to write into a tower file, percent of critical, for a required ratio ζ of the
/// tower with its rotor-nacelle assembly: ζ f(uncoupled)/f(coupled).
///
/// The uncoupled frequency is
/// [`Generalized::frequency_alone_hz`](super::Generalized::frequency_alone_hz), the coupled one
/// that of the tower with its rotor-nacelle assembly.
///
/// # Errors
/// [`DampingError`]: a ratio or a frequency is out of its range.
pub fn damping_to_write_percent(
    wanted_percent: f64,
    uncoupled_hz: f64,
    coupled_hz: f64,
) -> Result<f64, DampingError> {
    check(wanted_percent, &[uncoupled_hz, coupled_hz])?;
    let percent = wanted_percent * (uncoupled_hz / coupled_hz);
    if percent <= 100.0 {
        return Ok(percent);
    }
    Err(DampingError::TooMuch {
        wanted_percent,
        percent,
    })
}

/// The damping ratio of the tower with its rotor-nacelle assembly, percent of critical, for a ratio
/// in a tower file.
///
/// # Errors
/// [`DampingError`]: a ratio or a frequency is out of its range.
pub fn damping_of_system_percent(
    written_percent: f64,
    uncoupled_hz: f64,
    coupled_hz: f64,
) -> Result<f64, DampingError> {
    check(written_percent, &[uncoupled_hz, coupled_hz])?;
    Ok(written_percent * (coupled_hz / uncoupled_hz))
}

fn check(percent: f64, frequencies_hz: &[f64]) -> Result<(), DampingError> {
    if !(0.0..=100.0).contains(&percent) {
        return Err(DampingError::Wanted { percent });
    }
    let mut frequencies = frequencies_hz.iter();
    match frequencies.find(|hz| !(hz.is_finite() && **hz > 0.0)) {
        Some(&frequency_hz) => Err(DampingError::Frequency { frequency_hz }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::{DampingError, damping_of_system_percent, damping_to_write_percent};

    #[test]
    fn the_tower_alone_is_faster_and_needs_more() {
        let written = damping_to_write_percent(0.5, 0.9, 0.3).expect("damping");
        assert!((written - 1.5).abs() < 1e-15);
        let system = damping_of_system_percent(written, 0.9, 0.3).expect("damping");
        assert!((system - 0.5).abs() < 1e-15);
    }

    #[test]
    fn what_openfast_refuses_is_not_written() {
        let too_much = damping_to_write_percent(50.0, 0.9, 0.3).expect_err("150 %");
        assert!(too_much.to_string().contains("150.0000 %"), "{too_much}");
        for percent in [-1.0, 101.0, f64::NAN] {
            assert!(damping_to_write_percent(percent, 0.9, 0.3).is_err());
        }
        for hz in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(damping_to_write_percent(1.0, 0.9, hz).is_err());
            let refused = damping_to_write_percent(1.0, hz, 0.3);
            assert!(matches!(refused, Err(DampingError::Frequency { .. })));
        }
    }
}

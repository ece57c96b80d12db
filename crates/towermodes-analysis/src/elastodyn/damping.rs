//! The damping to write for the damping that is wanted.
//!
//! ElastoDyn makes of a ratio ζ in its file the damping C = 2 ζ K/ω₁, where ω₁ is the frequency of
//! the tower without its rotor-nacelle assembly. With it the tower swings at a lower ω and is
//! damped at the ratio C ω/(2 K) = ζ ω/ω₁, gravity's part of the stiffness aside.

use thiserror::Error;

use towermodes::Plain;

/// Why no damping can be written.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum DampingError {
    /// A ratio of damping that cannot be.
    #[error("a damping of {} % of critical cannot be wanted; it must be from 0 to 100", Plain(*.percent))]
    Wanted {
        /// The ratio, percent.
        percent: f64,
    },
    /// A frequency that is none.
    #[error("a frequency of {} Hz has no damping; it must be above 0", Plain(*.frequency_hz))]
    Frequency {
        /// The frequency, Hz.
        frequency_hz: f64,
    },
    /// More than OpenFAST takes.
    #[error(
        "for {wanted_percent:.4} % of the tower with what it carries, {:.4} % would have to be written, and OpenFAST takes no more than 100",
        Plain(*.percent)
    )]
    TooMuch {
        /// The ratio wanted, percent.
        wanted_percent: f64,
        /// What would have to be written, percent.
        percent: f64,
    },
}

/// The damping to write into a tower file, percent of critical, for the damping wanted of the tower
/// with its rotor-nacelle assembly: ζ f(uncoupled)/f(coupled).
///
/// The uncoupled frequency is
/// [`Generalized::frequency_alone_hz`](super::Generalized::frequency_alone_hz), the coupled one
/// that of the tower with what it carries.
///
/// # Errors
/// [`DampingError`].
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

/// The damping of the tower with its rotor-nacelle assembly, percent of critical, that one in a
/// tower file makes.
///
/// # Errors
/// [`DampingError`].
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

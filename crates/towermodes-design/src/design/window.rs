//! The band of frequencies between two multiples of the rotor speed.

use thiserror::Error;
use towermodes::Rotor;

/// Why there is no band of frequencies between two multiples.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum WindowError {
    /// The lower multiple is not below the upper one.
    #[error("{lower}P-{upper}P is not a window: the first multiple must be lower")]
    Order {
        /// The lower multiple.
        lower: usize,
        /// The upper multiple.
        upper: usize,
    },
    /// The margin is not between 0 and 1.
    #[error("the margin is {margin}, but must be at least 0 and below 1")]
    Margin {
        /// The margin, as a fraction.
        margin: f64,
    },
    /// The operating speeds differ so much that the band between the excitations is empty.
    #[error(
        "the window {lower}P-{upper}P is empty: with the margin, {lower}P requires at least {min_hz:.4} Hz and {upper}P at most {max_hz:.4} Hz"
    )]
    Empty {
        /// The lower multiple.
        lower: usize,
        /// The upper one.
        upper: usize,
        /// The lowest frequency above the lower multiple, Hz.
        min_hz: f64,
        /// The highest frequency below the upper multiple, Hz.
        max_hz: f64,
    },
}

/// The frequencies between two multiples of the rotor speed, Hz: at every operating speed Ω the
/// distance |n Ω/f − 1| of both is at least `margin`, as
/// [`campbell`](towermodes_analysis::resonance::campbell()) defines it. The lower multiple may be
/// 0.
///
/// # Errors
/// [`WindowError`].
///
/// # Example
/// ```
/// use towermodes::Rotor;
/// use towermodes_design::design::window_hz;
///
/// let rotor = Rotor { blades: 3, lowest_rpm: 6.9, highest_rpm: 12.1 };
/// let [low, high] = window_hz(&rotor, [1, 3], 0.05)?;
/// assert!((low - 12.1 / 60.0 / 0.95).abs() < 1e-15);
/// assert!((high - 3.0 * 6.9 / 60.0 / 1.05).abs() < 1e-15);
/// # Ok::<(), towermodes_design::design::WindowError>(())
/// ```
pub fn window_hz(
    rotor: &Rotor,
    [lower, upper]: [usize; 2],
    margin: f64,
) -> Result<[f64; 2], WindowError> {
    if !(0.0..1.0).contains(&margin) {
        return Err(WindowError::Margin { margin });
    }
    if lower >= upper {
        return Err(WindowError::Order { lower, upper });
    }
    let min_hz = lower as f64 * rotor.highest_rpm / 60.0 / (1.0 - margin);
    let max_hz = upper as f64 * rotor.lowest_rpm / 60.0 / (1.0 + margin);
    match min_hz < max_hz {
        true => Ok([min_hz, max_hz]),
        false => Err(WindowError::Empty {
            lower,
            upper,
            min_hz,
            max_hz,
        }),
    }
}

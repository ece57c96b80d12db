//! The discretization error of a frequency, by Richardson's extrapolation.
//!
//! A method of order p has f(n) = f* + C n⁻ᵖ + …, so two meshes, one with every segment halved, give C and with it both the error and
//! a better value (Richardson 1911).

/// What a second mesh says about a frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Richardson {
    /// Estimate of |f* − f(n)|, Hz.
    pub error_hz: f64,
    /// Estimate of f*, Hz.
    pub extrapolated_hz: f64,
}

/// Whether the second mesh is coarser or finer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Companion {
    /// Half as many segments.
    Halved,
    /// Twice as many segments.
    Doubled,
}

/// Error and extrapolated value of `frequency_hz` from the same mode on the companion mesh, for a method of the given order.
///
/// Halved: f* − f(n) = (f(n) − f(n/2))/(2ᵖ − 1).  Doubled: f* − f(n) = (f(2n) − f(n))·2ᵖ/(2ᵖ − 1).
pub fn richardson(
    frequency_hz: f64,
    companion_hz: f64,
    companion: Companion,
    order: i32,
) -> Richardson {
    let power = 2.0_f64.powi(order);
    let correction = match companion {
        Companion::Halved => (frequency_hz - companion_hz) / (power - 1.0),
        Companion::Doubled => (companion_hz - frequency_hz) * power / (power - 1.0),
    };
    Richardson {
        error_hz: correction.abs(),
        extrapolated_hz: frequency_hz + correction,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pure_power_law_is_extrapolated_exactly() {
        let f = |n: f64, p: i32| 3.0 - 0.5 * n.powi(-p);
        for p in [1, 2, 4] {
            let truth = 0.5 * 8.0_f64.powi(-p);
            for (companion, n) in [(Companion::Halved, 4.0), (Companion::Doubled, 16.0)] {
                let r = richardson(f(8.0, p), f(n, p), companion, p);
                assert!((r.extrapolated_hz - 3.0).abs() < 1e-15);
                assert!((r.error_hz - truth).abs() < 1e-15);
            }
        }
    }
}

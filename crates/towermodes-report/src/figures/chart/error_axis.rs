//! A logarithmic axis of relative errors; rounding errors are drawn at its lower end.

use super::Axis;
use crate::svg::{Numbers, Scale, power_of_ten};

/// Errors below this are rounding errors and are drawn at the lower end.
pub(crate) const ROUNDING: f64 = 1e-12;

/// The approximate number of numbers along the axis.
const TICKS: usize = 9;

/// An axis of errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::figures) struct ErrorAxis {
    /// The lowest and the highest error, powers of ten.
    pub(in crate::figures) range: [f64; 2],
    /// Whether its lower end shows everything below [`ROUNDING`].
    has_foot: bool,
}

impl ErrorAxis {
    /// An axis for these errors.
    pub(in crate::figures) fn of(errors: impl Iterator<Item = f64>) -> Self {
        let (mut lowest, mut highest, mut has_foot) = (f64::INFINITY, 0.0_f64, false);
        for error in errors.map(f64::abs).filter(|error| error.is_finite()) {
            has_foot |= error < ROUNDING;
            if error >= ROUNDING {
                (lowest, highest) = (lowest.min(error), highest.max(error));
            }
        }
        let low = if has_foot || highest == 0.0 {
            ROUNDING
        } else {
            10.0_f64.powf((lowest.log10() + 1e-9).floor())
        };
        let above = 10.0_f64.powf((highest.max(ROUNDING).log10() - 1e-9).ceil());
        let high = above.clamp(10.0 * low, f64::MAX);
        Self {
            range: [low, high],
            has_foot,
        }
    }

    /// The value of an error on the axis: itself, or the lower end.
    pub(in crate::figures) fn value(&self, error: f64) -> f64 {
        error.abs().max(self.range[0])
    }

    /// The axis with its name.
    pub(in crate::figures) fn axis(&self, name: &str) -> Axis {
        Axis {
            is_logarithmic: true,
            numbers: Numbers::At(self.ticks()),
            ..Axis::linear(name, self.range)
        }
    }

    /// Powers of ten with their labels.
    pub(in crate::figures) fn ticks(&self) -> Vec<(f64, String)> {
        let ticks = Scale::logarithmic(self.range, [0.0, 1.0]).ticks(TICKS);
        let text = |(index, value): (usize, f64)| {
            let below = if index == 0 && self.has_foot {
                "< "
            } else {
                ""
            };
            // Not 10⁰.
            let is_one = value.log10().abs() < 1e-9;
            let text = if is_one {
                "1".to_owned()
            } else {
                power_of_ten(value)
            };
            (value, below.to_owned() + &text)
        };
        ticks.into_iter().enumerate().map(text).collect()
    }
}

/// An error in the format of the tables: "+1.2e-4".
pub(in crate::figures) fn signed(error: f64) -> String {
    if error == 0.0 {
        "0".to_owned()
    } else {
        format!("{error:+.1e}")
    }
}

#[cfg(test)]
mod tests {
    use super::ErrorAxis;

    #[test]
    fn an_axis_is_whole_decades() {
        let axis = ErrorAxis::of([3e-4, -2e-2].into_iter());
        assert!((axis.range[0] / 1e-4 - 1.0).abs() < 1e-12);
        assert!((axis.range[1] / 1e-1 - 1.0).abs() < 1e-12);
        let texts: Vec<String> = axis.ticks().into_iter().map(|(_, text)| text).collect();
        assert_eq!(texts, ["10⁻⁴", "10⁻³", "10⁻²", "10⁻¹"]);
        assert_eq!(axis.value(-2e-2), 2e-2);
        assert_eq!(ErrorAxis::of([0.5].into_iter()).ticks()[1].1, "1");
    }

    #[test]
    fn rounding_stands_at_the_foot() {
        let axis = ErrorAxis::of([0.0, 1e-15, 5e-12].into_iter());
        assert_eq!(axis.ticks()[0].1, "< 10⁻¹²");
        assert_eq!(axis.value(0.0), axis.range[0]);
    }

    #[test]
    fn an_axis_of_nothing_is_one() {
        let axis = ErrorAxis::of([f64::NAN].into_iter());
        assert!(axis.range[0] > 0.0 && axis.range[1] > axis.range[0]);
    }
}

//! Linear and logarithmic scales from values to positions on a sheet.

use crate::number::superscript;

/// The scale of an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// The value at the beginning.
    pub low: f64,
    /// The value at the end.
    pub high: f64,
    /// The position of the beginning.
    pub from: f64,
    /// The position of the end.
    pub to: f64,
    /// Whether the scale is logarithmic.
    pub is_logarithmic: bool,
}

impl Scale {
    /// A linear scale.
    pub fn linear([low, high]: [f64; 2], [from, to]: [f64; 2]) -> Self {
        Self {
            low,
            high,
            from,
            to,
            is_logarithmic: false,
        }
    }

    /// A logarithmic scale; both values must be positive.
    pub fn logarithmic([low, high]: [f64; 2], [from, to]: [f64; 2]) -> Self {
        Self {
            is_logarithmic: true,
            ..Self::linear([low, high], [from, to])
        }
    }

    /// The position of a value.
    pub fn at(&self, value: f64) -> f64 {
        let (a, b, v) = if self.is_logarithmic {
            (self.low.ln(), self.high.ln(), value.ln())
        } else {
            (self.low, self.high, value)
        };
        let share = if b == a { 0.5 } else { (v - a) / (b - a) };
        self.from + share * (self.to - self.from)
    }

    /// Round values within the axis, about `count` of them; on a logarithmic axis powers of ten.
    pub fn ticks(&self, count: usize) -> Vec<f64> {
        if self.is_logarithmic {
            return decades(self.low, self.high, count);
        }
        let step = round_step((self.high - self.low) / count.max(1) as f64);
        if !(step.is_finite() && step > 0.0) {
            return vec![self.low];
        }
        let first = (self.low / step - 1e-9).ceil();
        let last = (self.high / step + 1e-9).floor();
        let steps = (last - first).clamp(0.0, 1000.0) as usize;
        (0..=steps).map(|k| (first + k as f64) * step).collect()
    }
}

fn decades(low: f64, high: f64, count: usize) -> Vec<f64> {
    let (first, last) = ((low.log10() - 1e-9).ceil(), (high.log10() + 1e-9).floor());
    if !(first.is_finite() && last.is_finite()) || last < first {
        return vec![low, high];
    }
    let decades = (last - first) as usize;
    let every = decades.div_ceil(count.max(1)).max(1);
    (0..=decades)
        .step_by(every)
        .map(|k| 10.0_f64.powf(first + k as f64))
        .collect()
}

/// The smallest and the largest value; none if there are no values. NaN is ignored.
pub(crate) fn extent(values: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    let ends = values
        .into_iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(value), high.max(value)]
        });
    (ends[0] <= ends[1]).then_some(ends)
}

/// The nearest of 1, 2, 5 times a power of ten.
fn round_step(step: f64) -> f64 {
    let power = 10.0_f64.powf(step.log10().floor());
    let distance = |digit: &f64| (digit * power / step).ln().abs();
    let digits = [1.0, 2.0, 5.0, 10.0].into_iter();
    let nearest = digits.min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.unwrap_or(10.0) * power
}

/// Whether a number is shorter as a power of ten than in decimal notation.
pub(super) fn is_far_from_one(value: f64) -> bool {
    !(-3.5..6.5).contains(&value.abs().log10())
}

/// A number with as many decimals as the step between neighbours requires, `10⁻⁴` for powers of ten
/// that are far from one.
pub fn number(value: f64, step: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if is_far_from_one(value) {
        return power_of_ten(value);
    }
    plain(value, step)
}

/// A number in decimal notation with as many decimals as the step between neighbours requires.
pub(super) fn plain(value: f64, step: f64) -> String {
    let decimals = (-(step.abs().log10() + 1e-9).floor()).clamp(0.0, 9.0) as usize;
    let text = format!("{value:.decimals$}");
    text.replace('-', "\u{2212}")
}

/// A positive number as its power of ten: "10⁻⁴", "2.5·10⁹".
pub fn power_of_ten(value: f64) -> String {
    let exponent = (value.abs().log10() + 1e-9).floor();
    let mantissa = value / 10.0_f64.powf(exponent);
    let digits = superscript(&format!("{exponent:.0}"));
    if (mantissa - 1.0).abs() < 1e-6 {
        return format!("10{digits}");
    }
    let text = format!("{mantissa:.1}");
    let text = text
        .trim_end_matches('0')
        .trim_end_matches('.')
        .replace('-', "\u{2212}");
    format!("{text}\u{b7}10{digits}")
}

#[cfg(test)]
mod tests {
    use super::{Scale, number};

    #[test]
    fn ticks_are_round_and_within() {
        let scale = Scale::linear([0.0, 87.6], [0.0, 100.0]);
        assert_eq!(scale.ticks(5), [0.0, 20.0, 40.0, 60.0, 80.0]);
        let scale = Scale::linear([-0.3, 0.31], [0.0, 100.0]);
        assert_eq!(scale.ticks(6).len(), 7);
        let scale = Scale::logarithmic([1e-9, 1e-2], [0.0, 100.0]);
        let ticks = scale.ticks(4);
        assert_eq!(ticks.len(), 4);
        assert!((ticks[1] / 1e-7 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn places_are_between_the_ends() {
        assert_eq!(Scale::linear([0.0, 10.0], [100.0, 0.0]).at(2.5), 75.0);
        assert!((Scale::logarithmic([1.0, 100.0], [0.0, 10.0]).at(10.0) - 5.0).abs() < 1e-12);
    }

    #[test]
    fn numbers_have_the_decimals_of_their_step() {
        assert_eq!(number(20.0, 20.0), "20");
        assert_eq!(number(0.25, 0.05), "0.25");
        assert_eq!(number(-0.5, 0.5), "\u{2212}0.5");
        assert_eq!(number(1e-7, 1.0), "10\u{207b}\u{2077}");
        assert_eq!(number(2.5e9, 1.0), "2.5\u{b7}10\u{2079}");
    }
}

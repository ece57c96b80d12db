//! Rows whose value does not fit those of the adjacent rows: a digit or the exponent is wrong.

/// In built towers no row differs from both adjacent rows by this factor in stiffness or width.
const SPIKE: f64 = 4.0;
/// Largest deviation of a ratio from a power of ten, in powers of ten, for a wrong exponent: the
/// true values vary too.
const NEAR_A_POWER: f64 = 0.12;
/// If the values of two rows differ by more than this factor, no value is extrapolated from them.
const SMOOTH: f64 = 2.0;

/// The criterion for a value that does not fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Spike {
    /// Any value far from those of the neighbours: no real tower has it.
    Any,
    /// A value that is wrong by a power of ten: a real feature, such as a mass distributed over a
    /// short length, can cause any other value.
    PowerOfTen,
}

impl Spike {
    /// Whether the ratio to the expected value is too large or too small.
    fn is(self, ratio: f64) -> bool {
        let powers = ratio.log10();
        let is_near_a_power = (powers - powers.round()).abs() < NEAR_A_POWER;
        !between(ratio, SPIKE) && (self == Self::Any || is_near_a_power)
    }
}

/// The positive value that deviates most from its neighbours at heights (m): its index, and the
/// value expected from the neighbours.
pub(super) fn worst(heights_m: &[f64], values: &[f64], spike: Spike) -> Option<(usize, f64)> {
    let out_of_line = (0..values.len()).filter_map(|index| {
        let expected = expected(heights_m, values, index, spike)?;
        Some((index, expected))
    });
    let powers = |(index, expected): &(usize, f64)| (values[*index] / expected).log10().abs();
    out_of_line.max_by(|a, b| powers(a).total_cmp(&powers(b)))
}

/// The value expected from the adjacent ones, if this one does not fit.
fn expected(heights_m: &[f64], values: &[f64], index: usize, spike: Spike) -> Option<f64> {
    let value = values[index];
    let last = values.len() - 1;
    if index == 0 || index == last {
        // An end has one neighbour: its expected value is extrapolated from this neighbour and the
        // next one.
        let [near, far] = if index == 0 {
            [1, 2]
        } else {
            [last.checked_sub(1)?, last.checked_sub(2)?]
        };
        let (near, far) = (*values.get(near)?, *values.get(far)?);
        let expected = near * near / far;
        let is_foretold = between(near / far, SMOOTH);
        let is_off = Spike::PowerOfTen.is(value / expected) && !between(value / near, SPIKE);
        return (is_foretold && is_off).then_some(expected);
    }
    let (below, above) = (values[index - 1], values[index + 1]);
    let [low_m, here_m, high_m] = [index - 1, index, index + 1].map(|i| heights_m[i]);
    // Rows at one height are a step; the values on both sides are independent.
    if low_m == here_m || here_m == high_m {
        return None;
    }
    let is_beyond_both = (value > below) == (value > above);
    let is_far = !between(value / below, SPIKE) && !between(value / above, SPIKE);
    if !(is_beyond_both && is_far) {
        return None;
    }
    let share = (here_m - low_m) / (high_m - low_m);
    let expected = below.powf(1.0 - share) * above.powf(share);
    spike.is(value / expected).then_some(expected)
}

/// Whether a ratio is within a factor of one.
fn between(ratio: f64, factor: f64) -> bool {
    (1.0 / factor..=factor).contains(&ratio)
}

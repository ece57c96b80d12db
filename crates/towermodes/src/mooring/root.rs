//! The root of an increasing function of a positive number.

/// Iterations of Newton's method, after which the bracket is halved.
const NEWTON_STEPS: usize = 60;
/// Halvings after which even the widest bracket contains only two adjacent floating-point numbers.
const HALVINGS: usize = 80;
/// Largest change of ln u in one step.
const LONGEST_STEP: f64 = 30.0;
/// Relative step at which the search ends.
const CLOSE: f64 = 4.0 * f64::EPSILON;

/// The root u > 0 of an increasing function, which is given with its derivative; none where the
/// function has no root between the smallest and the largest number.
///
/// Newton's method for the logarithm of u. A step that leaves the bracket halves it, so that the
/// search always ends.
pub(super) fn increasing_root(start: f64, function: impl Fn(f64) -> (f64, f64)) -> Option<f64> {
    let [mut low, mut high] = [f64::MIN_POSITIVE, f64::MAX].map(f64::ln);
    let mut u = start.clamp(f64::MIN_POSITIVE, 1e300);
    for step in 0..NEWTON_STEPS + HALVINGS {
        let (value, derivative) = function(u);
        let at = u.ln();
        if value > 0.0 {
            high = at;
        } else if value < 0.0 {
            low = at;
        } else {
            return (value == 0.0).then_some(u);
        }
        let change = -value / (u * derivative);
        if change.abs() <= CLOSE {
            return Some(u * (1.0 + change));
        }
        let next = at + change.clamp(-LONGEST_STEP, LONGEST_STEP);
        let is_inside = next > low && next < high && step < NEWTON_STEPS;
        u = match is_inside {
            // For the last digits u itself is used: its logarithm has fewer digits.
            true if change.abs() < 1e-3 => u * (1.0 + change + 0.5 * change * change),
            true => next.exp(),
            false => (0.5 * (low + high)).exp(),
        };
        if high - low <= 2.0 * f64::EPSILON * high.abs().max(low.abs()) {
            break;
        }
    }
    let is_found = low > f64::MIN_POSITIVE.ln() && high < f64::MAX.ln();
    is_found.then_some(u)
}

#[cfg(test)]
mod tests {
    use super::increasing_root;

    #[test]
    fn roots_far_from_the_start_are_found() {
        for exact in [1e-200, 3e-7, 1.0, 4e12, 1e150] {
            let root = increasing_root(1.0, |u: f64| (u * u - exact * exact, 2.0 * u));
            // exact² underflows or overflows at the ends.
            if (1e-100..1e100).contains(&exact) {
                let root = root.expect("a root");
                assert!((root / exact - 1.0).abs() < 1e-15, "{root} {exact}");
            }
            let root = increasing_root(1.0, |u: f64| ((u / exact).ln(), 1.0 / u));
            let root = root.expect("a root");
            // The bracket is one of logarithms, which have fewer digits far from 1.
            let tolerance = 1e-15 + f64::EPSILON * exact.ln().abs();
            assert!((root / exact - 1.0).abs() < tolerance, "{root} {exact}");
        }
    }

    #[test]
    fn a_function_without_a_root_has_none() {
        assert_eq!(increasing_root(1.0, |u| (u + 1.0, 1.0)), None);
        assert_eq!(increasing_root(1.0, |u| (-1.0 / u, 1.0 / (u * u))), None);
        assert_eq!(increasing_root(1.0, |_| (f64::NAN, 1.0)), None);
    }
}

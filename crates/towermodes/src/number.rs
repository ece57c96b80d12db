//! Numbers as people write them.

use std::fmt;

/// Shows a number plainly where that is short, with an exponent where it is not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Plain(pub(crate) f64);

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size == 0.0 || (1e-4..1e7).contains(&size) || !size.is_finite() {
            write!(f, "{}", self.0)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Plain;

    #[test]
    fn short_numbers_stay_plain() {
        let shown = [87.6, 0.027, -1.0, 0.0, 2.1e11, 1e-9, f64::NAN].map(|x| Plain(x).to_string());
        assert_eq!(shown, ["87.6", "0.027", "-1", "0", "2.1e11", "1e-9", "NaN"]);
    }
}

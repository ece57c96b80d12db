//! A natural frequency between two counts that differ by one: where the determinant changes sign.

/// Half the width of the bracket that a frequency ends in, relative to it.
pub(super) const TOLERANCE: f64 = 4e-12;
/// Steps after which halving alone has reached any tolerance.
const STEPS: usize = 200;

/// H at a frequency: what its elimination gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sample {
    /// Frequency, rad/s.
    pub(super) w: f64,
    /// Number of negative eigenvalues.
    pub(super) negative: usize,
    /// ln |det H|.
    pub(super) log_determinant: f64,
}

impl Sample {
    /// The determinant over e^`log_scale`; its sign is that of the parity of the count.
    fn determinant(&self, log_scale: f64) -> f64 {
        let size = (self.log_determinant - log_scale)
            .clamp(-700.0, 700.0)
            .exp();
        if self.negative.is_multiple_of(2) {
            size
        } else {
            -size
        }
    }
}

/// A frequency between two samples whose counts differ by an odd number: both ends of a bracket as
/// narrow as [`TOLERANCE`], which the counts at its ends prove.
///
/// Regula falsi with the weights of Anderson & Björck (1973) for the end that stays; a step that
/// does not reach half of what two steps before left is replaced by a halving. The last step looks
/// just beyond the root, so that both ends are near.
pub(super) fn bracket(
    mut low: Sample,
    mut high: Sample,
    mut sample: impl FnMut(f64) -> Sample,
) -> (Sample, Sample) {
    let scale = low.log_determinant.max(high.log_determinant);
    let (mut at_low, mut at_high) = (low.determinant(scale), high.determinant(scale));
    let mut widths = [f64::INFINITY; 2];
    for _ in 0..STEPS {
        let width = high.w - low.w;
        let least = TOLERANCE * high.w;
        if width <= 2.0 * least {
            break;
        }
        let is_slow = width > 0.5 * widths[0];
        widths = [widths[1], width];
        let secant = low.w + width * at_low / (at_low - at_high);
        let w = match is_slow || !secant.is_finite() {
            true => low.w + 0.5 * width,
            // A root next to an end is looked for just beyond it.
            false => secant.clamp(low.w + least, high.w - least),
        };
        let middle = sample(w);
        let at_middle = middle.determinant(scale);
        if (at_middle < 0.0) == (at_low < 0.0) {
            at_high *= weight(at_middle, at_low);
            (low, at_low) = (middle, at_middle);
        } else {
            at_low *= weight(at_middle, at_high);
            (high, at_high) = (middle, at_middle);
        }
    }
    (low, high)
}

/// The weight of the end that stays, when the value at the other end changed.
fn weight(now: f64, before: f64) -> f64 {
    let weight = 1.0 - now / before;
    if weight > 0.0 { weight } else { 0.5 }
}

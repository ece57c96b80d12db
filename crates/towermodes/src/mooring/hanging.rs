//! An elastic line between two points without contact with the seabed.
//!
//! With tensions T and T_A at the upper and lower end, s = T + T_A, weight W = wL, axial stiffness
//! EA and relative rise ζ = z/L, the elastic catenary (Irvine 1981, ch. 2) is one equation for s:
//!
//! - σ = ζ/(1 + s/2EA) is the sine of the mean slope, (V + V_A)/s;
//! - H = ½ √((1 − σ²)(s² − W²)) follows from T² = H² + V² at both ends;
//! - x = H L [ln((s + W)/(s − W))/W + 1/EA].
//!
//! x increases with s, and no difference of nearly equal numbers occurs, for taut lines, slack
//! lines, vertical ones and lines without weight.

use super::cable::{Cable, Profile};
use super::root::increasing_root;

/// Spans below this fraction of the length are treated as zero: their tensions are below the
/// smallest number.
const NO_SPAN: f64 = 1e-100;

/// The line for one value of s.
struct Shape {
    /// s, N.
    tensions_n: f64,
    /// σ.
    sine: f64,
    /// 1 − σ².
    cosine_squared: f64,
    /// ln((s + W)/(s − W))/W, 1/N.
    arc_per_n: f64,
    /// H, N.
    horizontal_n: f64,
    /// x, m.
    span_m: f64,
    /// d ln x/ds, 1/N.
    slope: f64,
}

/// The constants of the equation.
struct Equation {
    weight_n: f64,
    length_m: f64,
    rise: f64,
    twice_stiffness_n: f64,
    /// The smallest s, N: the value for a span of zero.
    least_n: f64,
}

impl Equation {
    fn new(cable: &Cable, rise_m: f64) -> Self {
        let (rise, twice_stiffness_n) = (rise_m / cable.length_m, 2.0 * cable.axial_stiffness_n);
        let weight_n = cable.weight_n_per_m * cable.length_m;
        Self {
            weight_n,
            length_m: cable.length_m,
            rise,
            twice_stiffness_n,
            least_n: weight_n.max(twice_stiffness_n * (rise - 1.0)),
        }
    }

    /// The line with this difference between s and its smallest value.
    fn shape(&self, above_n: f64) -> Shape {
        let (weight_n, stiffness_n) = (self.weight_n, self.twice_stiffness_n);
        let tensions_n = self.least_n + above_n;
        let excess_n = (self.least_n - weight_n) + above_n;
        let stretch = 1.0 + tensions_n / stiffness_n;
        let sine = self.rise / stretch;
        let is_taut = self.least_n > weight_n;
        let slack = if is_taut {
            0.0
        } else {
            1.0 + weight_n / stiffness_n - self.rise
        };
        let cosine_squared = (slack + above_n / stiffness_n) / stretch * (1.0 + sine);
        let squares_n2 = excess_n * (tensions_n + weight_n);
        let arc_per_n = if weight_n > 0.0 {
            (2.0 * weight_n / excess_n).ln_1p() / weight_n
        } else {
            2.0 / tensions_n
        };
        let reach_per_n = arc_per_n + 2.0 / stiffness_n;
        let horizontal_n = 0.5 * (cosine_squared * squares_n2).sqrt();
        Shape {
            tensions_n,
            sine,
            cosine_squared,
            arc_per_n,
            horizontal_n,
            span_m: horizontal_n * self.length_m * reach_per_n,
            slope: sine * sine / (stiffness_n * stretch * cosine_squared)
                + (tensions_n - 2.0 / reach_per_n) / squares_n2,
        }
    }

    /// A starting value of s minus its smallest value: from the inextensible catenary, where sinh
    /// λ/λ is known and s = W coth λ, or from the straight line.
    fn start_n(&self, span_m: f64) -> f64 {
        let (span, rise) = (span_m / self.length_m, self.rise);
        let ratio = (1.0 - rise * rise).sqrt() / span;
        let lambda = if ratio > 1.0 {
            let steep = (2.0 * ratio * (2.0 * ratio).ln()).ln();
            (6.0 * (ratio - 1.0)).sqrt().min(steep)
        } else {
            0.2
        };
        let catenary_n = 2.0 * self.weight_n / (2.0 * lambda).exp_m1();
        let straight_n = self.twice_stiffness_n * (span.hypot(rise) - 1.0) - self.least_n;
        catenary_n.max(straight_n)
    }
}

/// The line of this span and rise; none if there is no tension in double precision.
pub(super) fn hanging(cable: &Cable, span_m: f64, rise_m: f64) -> Option<Profile> {
    let equation = Equation::new(cable, rise_m);
    let is_loose = span_m.hypot(rise_m) <= cable.length_m;
    if equation.weight_n == 0.0 && is_loose {
        return Some(Profile::without_force());
    }
    let above_n = if span_m > NO_SPAN * cable.length_m {
        increasing_root(equation.start_n(span_m), |above_n| {
            let shape = equation.shape(above_n);
            ((shape.span_m / span_m).ln(), shape.slope)
        })?
    } else {
        0.0
    };
    Some(profile(cable, &equation, &equation.shape(above_n)))
}

fn profile(cable: &Cable, equation: &Equation, shape: &Shape) -> Profile {
    let mean_n = 0.5 * shape.sine * shape.tensions_n;
    let upper_n = mean_n + 0.5 * equation.weight_n;
    let lower_n = 0.5 * equation.weight_n - mean_n;
    let length_m = cable.length_m;
    let per_n = length_m / cable.axial_stiffness_n;
    let both = shape.horizontal_n.hypot(upper_n) * shape.horizontal_n.hypot(lower_n);
    // (V/T − V_A/T_A)/w and (H/w)(1/T − 1/T_A).
    let (sines, inverses) = if both > 0.0 {
        let cosines = 0.5 * shape.tensions_n * shape.cosine_squared;
        (cosines / both, -shape.horizontal_n * shape.sine / both)
    } else {
        (0.0, 0.0)
    };
    let x_by_h = length_m * (shape.arc_per_n - sines) + per_n;
    let (x_by_v, z_by_v) = (length_m * inverses, length_m * sines + per_n);
    let ratio = x_by_v / z_by_v;
    let k_xx = 1.0 / (x_by_h - x_by_v * ratio);
    let (k_xz, k_zz) = (-ratio * k_xx, 1.0 / z_by_v + ratio * ratio * k_xx);
    Profile {
        horizontal_n: shape.horizontal_n,
        lower_horizontal_n: shape.horizontal_n,
        lower_n,
        upper_n,
        sag_m: sag_m(cable, shape.horizontal_n, lower_n),
        on_seabed_m: 0.0,
        is_slack: false,
        transverse_n_per_m: 1.0 / (length_m * (shape.arc_per_n + 1.0 / cable.axial_stiffness_n)),
        stiffness: [
            [k_xx, -k_xz, k_xz],
            [-k_xz, k_zz, -k_zz],
            [k_xz, -k_zz, k_zz],
        ],
    }
}

/// Depth of the lowest point of a line with these tensions at its lower end below this end, m.
fn sag_m(cable: &Cable, horizontal_n: f64, lower_n: f64) -> f64 {
    if lower_n <= 0.0 {
        return 0.0;
    }
    let square = lower_n * lower_n / cable.weight_n_per_m;
    square / (horizontal_n.hypot(lower_n) + horizontal_n) + 0.5 * square / cable.axial_stiffness_n
}

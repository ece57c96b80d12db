//! An elastic line, a part of which lies on the seabed.
//!
//! With the horizontal tension H and the height a of an end above the seabed, the tension there
//! follows from a quadratic equation, T − H + (T² − H²)/2EA = wa, and V² = T² − H². The length
//! V/w hangs, L_B = L − ΣV/w lies, and the span increases with H:
//!
//! x = L_B + Σ (H/w) asinh(V/H) + HL/EA − friction.
//!
//! Source: Jonkman 2007, *Dynamics Modeling and Loads Analysis of an Offshore Floating Wind
//! Turbine* (NREL/TP-500-41958), quasi-static mooring lines; here with the quadratic equation in
//! place of the second unknown, and for ends of any height.

use super::cable::{Cable, Profile};
use super::root::increasing_root;

/// The part of a line between the seabed and one of its ends.
struct Riser {
    /// T at the end, N.
    tension_n: f64,
    /// V at the end, N.
    vertical_n: f64,
    /// ∂V/∂H.
    by_horizontal: f64,
    /// ∂V/∂a, N/m.
    by_height_n_per_m: f64,
}

impl Riser {
    fn new(cable: &Cable, height_m: f64, horizontal_n: f64) -> Self {
        let (w, stiffness_n) = (cable.weight_n_per_m, cable.axial_stiffness_n);
        let stretch = 1.0 + horizontal_n / stiffness_n;
        let root = (stretch * stretch + 2.0 * w * height_m / stiffness_n).sqrt();
        // T − H.
        let rise_n = 2.0 * w * height_m / (stretch + root);
        let tension_n = horizontal_n + rise_n;
        let vertical_n = (rise_n * (rise_n + 2.0 * horizontal_n)).sqrt();
        let soft = 1.0 + tension_n / stiffness_n;
        // An end on the seabed is supported by the seabed.
        let (by_horizontal, by_height_n_per_m) = if vertical_n > 0.0 {
            (
                rise_n / (vertical_n * soft),
                w * tension_n / (vertical_n * soft),
            )
        } else {
            (0.0, 0.0)
        };
        Self {
            tension_n,
            vertical_n,
            by_horizontal,
            by_height_n_per_m,
        }
    }

    /// Its span (H/w) asinh(V/H), of which V/w would be on the seabed, and the derivative of the
    /// difference by H; for H > 0.
    fn reach(&self, w: f64, horizontal_n: f64) -> (f64, f64) {
        let arc = (self.vertical_n / horizontal_n).asinh();
        let cosine = horizontal_n / self.tension_n;
        let change = arc - self.vertical_n / self.tension_n - self.by_horizontal * (1.0 - cosine);
        ((horizontal_n * arc - self.vertical_n) / w, change / w)
    }
}

/// The line between ends at these heights above the seabed; none if there is no tension in double
/// precision.
pub(super) fn grounded(cable: &Cable, span_m: f64, heights_m: [f64; 2]) -> Option<Profile> {
    let (w, length_m) = (cable.weight_n_per_m, cable.length_m);
    let risers = |horizontal_n| heights_m.map(|a| Riser::new(cable, a, horizontal_n));
    let hangs_n = |risers: &[Riser; 2]| risers[0].vertical_n + risers[1].vertical_n;
    let loose_m = length_m - hangs_n(&risers(0.0)) / w;
    if span_m <= loose_m {
        return Some(profile(heights_m[0], 0.0, 0.0, &risers(0.0), loose_m));
    }
    // Span less the loose span, and its derivative without friction and with it.
    let reach = |horizontal_n: f64| {
        let risers = risers(horizontal_n);
        let [lower, upper] = [0, 1].map(|i| risers[i].reach(w, horizontal_n));
        let on_seabed_m = (length_m - hangs_n(&risers) / w).max(0.0);
        let shortened = friction(cable, &risers, heights_m[0], horizontal_n, on_seabed_m);
        let span_m = (length_m - loose_m)
            + lower.0
            + upper.0
            + horizontal_n * length_m / cable.axial_stiffness_n;
        let slope = lower.1 + upper.1 + length_m / cable.axial_stiffness_n;
        (span_m - shortened.0, slope, slope - shortened.1)
    };
    let beyond_m = span_m - loose_m;
    let start_n = w * length_m;
    let horizontal_n = increasing_root(start_n, |horizontal_n| {
        let (reach_m, _, slope) = reach(horizontal_n);
        // Because of rounding the shortest span cannot be computed exactly.
        if reach_m <= 0.0 {
            return (f64::NEG_INFINITY, slope);
        }
        ((reach_m / beyond_m).ln(), slope / reach_m)
    })?;
    let risers = risers(horizontal_n);
    let on_seabed_m = (length_m - hangs_n(&risers) / w).max(0.0);
    let k = 1.0 / reach(horizontal_n).1;
    let mut profile = profile(heights_m[0], horizontal_n, k, &risers, on_seabed_m);
    profile.transverse_n_per_m = horizontal_n / span_m;
    if heights_m[0] == 0.0 {
        let lost_n = cable.seabed_friction * w * on_seabed_m;
        profile.lower_horizontal_n = (horizontal_n - lost_n).max(0.0);
    }
    Some(profile)
}

/// By how much friction shortens the part on the seabed, m, and the derivative of that by H.
///
/// It acts towards the anchor, where the tension is the least; on a line that both of its ends lift
/// it has no direction, and none is assumed.
fn friction(
    cable: &Cable,
    risers: &[Riser; 2],
    lower_m: f64,
    horizontal_n: f64,
    on_seabed_m: f64,
) -> (f64, f64) {
    let friction_n_per_m = cable.seabed_friction * cable.weight_n_per_m;
    if friction_n_per_m == 0.0 || lower_m > 0.0 {
        return (0.0, 0.0);
    }
    // The part of the line next to the anchor without tension.
    let idle_m = (on_seabed_m - horizontal_n / friction_n_per_m).max(0.0);
    let stiffness_n = cable.axial_stiffness_n;
    let squares_m2 = on_seabed_m * on_seabed_m - idle_m * idle_m;
    let by_length = friction_n_per_m * (on_seabed_m - idle_m) / stiffness_n;
    let length_by_h = -risers[1].by_horizontal / cable.weight_n_per_m;
    (
        0.5 * friction_n_per_m * squares_m2 / stiffness_n,
        idle_m / stiffness_n + by_length * length_by_h,
    )
}

/// With k = ∂H/∂x. The span that a horizontal tension needs falls by ∂V/∂H with the height of an
/// end (Maxwell), so that H rises by k ∂V/∂H.
fn profile(
    sag_m: f64,
    horizontal_n: f64,
    k: f64,
    [lower, upper]: &[Riser; 2],
    on_seabed_m: f64,
) -> Profile {
    let (a, b) = (lower.by_horizontal, upper.by_horizontal);
    let (lower_k, upper_k) = (lower.by_height_n_per_m, upper.by_height_n_per_m);
    let is_slack = horizontal_n == 0.0;
    Profile {
        horizontal_n,
        lower_horizontal_n: horizontal_n,
        lower_n: lower.vertical_n,
        upper_n: upper.vertical_n,
        sag_m,
        on_seabed_m,
        is_slack,
        transverse_n_per_m: 0.0,
        stiffness: [
            [k, a * k, b * k],
            [a * k, lower_k + a * a * k, a * b * k],
            [b * k, a * b * k, upper_k + b * b * k],
        ],
    }
}

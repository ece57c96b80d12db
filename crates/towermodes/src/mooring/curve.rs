//! Points of a line in its vertical plane.
//!
//! At a distance s along the line from an end that it pulls down by V₀, V = V₀ − ws and
//! T² = H² + V²; the point is (H/w)(asinh V₀/H − asinh V/H) + Hs/EA beside the end and
//! (T₀ − T)/w + (V₀² − V²)/2wEA below it (Irvine 1981, ch. 2).

use super::cable::{Cable, Profile};

/// Horizontal and vertical distance from the lower end, m.
type Place = (f64, f64);

impl Cable {
    /// At least `count` points of a line with this profile, whose upper end is `span_m` beside and
    /// `rise_m` above the lower one; from the lower to the upper end.
    pub(super) fn curve(
        &self,
        profile: &Profile,
        (span_m, rise_m): Place,
        count: usize,
    ) -> Vec<Place> {
        let w = self.weight_n_per_m;
        let from_upper = |(beside, below): Place| (span_m - beside, rise_m - below);
        let mut places = vec![(0.0, 0.0)];
        if w * self.length_m > 0.0 && profile.on_seabed_m > 0.0 {
            let [lower, upper] = [profile.lower_n, profile.upper_n].map(|pull_n| pull_n.max(0.0));
            places.extend(
                self.hanging_part(profile, (lower, lower / w), count)
                    .into_iter()
                    .map(|(beside, below)| (beside, -below)),
            );
            let rising = self.hanging_part(profile, (upper, upper / w), count);
            places.extend(rising.into_iter().rev().map(from_upper));
        } else if w * self.length_m > 0.0 {
            let hanging = self.hanging_part(profile, (profile.upper_n, self.length_m), count);
            places.extend(hanging.into_iter().rev().skip(1).map(from_upper));
        }
        places.push((span_m, rise_m));
        places
    }

    /// Points along a part of a line, from an end with this downward force (N) over a length (m):
    /// their distance beside and below this end. Without the end.
    fn hanging_part(
        &self,
        profile: &Profile,
        (pull_n, length_m): (f64, f64),
        count: usize,
    ) -> Vec<Place> {
        let (w, stiffness_n) = (self.weight_n_per_m, self.axial_stiffness_n);
        let horizontal_n = profile.horizontal_n;
        let tension_n = pull_n.hypot(horizontal_n);
        let at = |k: usize| {
            let s = length_m * k as f64 / count as f64;
            let v = pull_n - w * s;
            let beside = match horizontal_n > 0.0 {
                true => {
                    let arc = (pull_n / horizontal_n).asinh() - (v / horizontal_n).asinh();
                    horizontal_n * (arc / w + s / stiffness_n)
                }
                false => 0.0,
            };
            let squares = (pull_n - v) * (pull_n + v);
            let t = v.hypot(horizontal_n);
            (
                beside,
                (tension_n - t) / w + 0.5 * squares / (w * stiffness_n),
            )
        };
        match length_m > 0.0 {
            true => (1..=count).map(at).collect(),
            false => Vec::new(),
        }
    }
}

//! A cubic polynomial over a segment.

/// A curve over a segment of the tower: a polynomial of degree ≤ 3 in s = (z − base)/length.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cubic {
    /// Coefficients of 1, s, s², s³.
    c: [f64; 4],
    /// Part of the slope with respect to s that is shear and does not rotate the section.
    shear: f64,
    length_m: f64,
}

impl Cubic {
    /// The deflection of a beam whose ends move by (w, θ): Hermite's cubic, plus the part of the
    /// deflection that is shear as a straight line. These are the exact static deflections of a
    /// prismatic Timoshenko beam.
    ///
    /// Sliding is w₂ − w₁ − L(θ₁+θ₂)/2, what the segment's transverse spring takes.
    pub(super) fn beam(
        below: [f64; 2],
        above: [f64; 2],
        length_m: f64,
        shear_fraction: f64,
    ) -> Self {
        let (turn_1, turn_2) = (length_m * below[1], length_m * above[1]);
        let rise = above[0] - below[0];
        let shear = shear_fraction * (rise - 0.5 * (turn_1 + turn_2));
        let bent = rise - shear;
        Self {
            c: [
                below[0],
                turn_1 + shear,
                3.0 * bent - 2.0 * turn_1 - turn_2,
                turn_1 + turn_2 - 2.0 * bent,
            ],
            shear,
            length_m,
        }
    }

    /// A straight line between the values at the ends.
    pub(super) fn line(below: f64, above: f64, length_m: f64) -> Self {
        Self {
            c: [below, above - below, 0.0, 0.0],
            shear: 0.0,
            length_m,
        }
    }

    /// The value at s.
    pub(super) fn value(&self, s: f64) -> f64 {
        let c = &self.c;
        c[0] + s * (c[1] + s * (c[2] + s * c[3]))
    }

    /// Rotation of the section at s: the slope without its shear part.
    pub(super) fn rotation(&self, s: f64) -> f64 {
        let c = &self.c;
        (c[1] - self.shear + s * (2.0 * c[2] + s * 3.0 * c[3])) / self.length_m
    }

    /// The value of largest magnitude on 0 ≤ s ≤ 1.
    pub(super) fn extreme(&self) -> f64 {
        let mut extreme = self.value(1.0);
        for s in self.turning_points() {
            if s > 0.0 && s < 1.0 && self.value(s).abs() > extreme.abs() {
                extreme = self.value(s);
            }
        }
        if self.c[0].abs() > extreme.abs() {
            self.c[0]
        } else {
            extreme
        }
    }

    /// The zeros of c₁ + 2c₂s + 3c₃s²; NaN if there are none.
    fn turning_points(&self) -> [f64; 2] {
        let [_, c1, c2, c3] = self.c;
        let q = -(c2 + (c2 * c2 - 3.0 * c1 * c3).sqrt().copysign(c2));
        [q / (3.0 * c3), c1 / q]
    }
}

#[cfg(test)]
mod tests {
    use super::Cubic;

    #[test]
    fn the_beam_curve_is_the_cantilever_under_a_tip_load() {
        // w = z²(3 − z)/6, θ = z − z²/2 for L = EI = P = 1.
        let beam = Cubic::beam([0.0, 0.0], [1.0 / 3.0, 0.5], 1.0, 0.0);
        for s in [0.1, 0.5, 0.9] {
            assert!((beam.value(s) - s * s * (3.0 - s) / 6.0).abs() < 1e-15);
            assert!((beam.rotation(s) - (s - s * s / 2.0)).abs() < 1e-15);
        }
    }

    #[test]
    fn shear_adds_a_straight_line_that_does_not_rotate_sections() {
        // The same with 1/(κGA) = γ: w gains γ z, θ nothing. Sliding: 1/12 from bending, γ from
        // shear.
        let gamma = 0.2;
        let share = gamma / (gamma + 1.0 / 12.0);
        let beam = Cubic::beam([0.0, 0.0], [1.0 / 3.0 + gamma, 0.5], 1.0, share);
        for s in [0.1, 0.5, 0.9] {
            assert!((beam.value(s) - s * s * (3.0 - s) / 6.0 - gamma * s).abs() < 1e-15);
            assert!((beam.rotation(s) - (s - s * s / 2.0)).abs() < 1e-15);
        }
    }

    #[test]
    fn the_extreme_is_found_inside() {
        // w = s(1−s)(1−2s): extremes ±1/(6√3) inside, zero at both ends.
        let slope = 1.0;
        let beam = Cubic::beam([0.0, slope], [0.0, slope], 1.0, 0.0);
        let exact = 1.0 / (6.0 * 3.0_f64.sqrt());
        assert!((beam.extreme().abs() - exact).abs() < 1e-15);
        assert_eq!(Cubic::line(-2.0, 1.0, 3.0).extreme(), -2.0);
    }
}

//! Linear springs in place of a curved spring profile, with the same work.
//!
//! Springs k(z) do the work ½ ∫ k v² dz on a deflection v. A part of the pile is cut in the middle,
//! and a straight line takes the place of the springs in each half. The four values of both lines
//! follow from the four moments ∫ k zⁿ dz, n = 0 … 3, so the work is exact for every cubic v², and
//! its error falls with the sixth power of the length of the part.

use super::super::parts::surroundings::{SoilRow, SoilStiffness};
use super::super::pieces::integrals::GAUSS_5;
use super::reaction::Reactions;

const SPRINGS: usize = SoilStiffness::SPRINGS;

/// ½ ∫ k sⁿ ds over s from −1 to 1, n = 0 … 4, of each spring of a part or of half a part.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Moments([[f64; SPRINGS]; 5]);

/// The points at which the integrals of the uppermost part are divided, as fractions of a half: its
/// springs can begin with a power of the depth.
const GRADED: [f64; 4] = [0.75, 0.9375, 0.984_375, 1.0];

/// A part of a pile in one layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Part {
    pub(super) layer: usize,
    pub(super) lower_m: f64,
    pub(super) upper_m: f64,
}

impl Part {
    /// One line with the sum and the first moment of the springs: exact for linear springs.
    pub(super) fn line(&self, reactions: &Reactions<'_>) -> [SoilRow; 2] {
        self.line_of(&self.moments(reactions, [-1.0, 1.0]), [-1.0, 1.0])
    }

    /// Two lines with the first four moments of the springs.
    pub(super) fn pair(&self, reactions: &Reactions<'_>) -> [SoilRow; 4] {
        self.pair_of(&self.halves(reactions))
    }

    fn halves(&self, reactions: &Reactions<'_>) -> [Moments; 2] {
        [[-1.0, 0.0], [0.0, 1.0]].map(|ends| self.moments(reactions, ends))
    }

    fn pair_of(&self, halves: &[Moments; 2]) -> [SoilRow; 4] {
        let whole = halves[0].and(&halves[1]);
        // The same halves with two moments each, which is possible for every spring.
        let [low, below] = self.line_of(&halves[0], [-1.0, 0.0]);
        let [above, high] = self.line_of(&halves[1], [0.0, 1.0]);
        let mut rows = [low, below, above, high];
        let mut values = rows.map(|row| row.stiffness.values());
        for spring in 0..SPRINGS {
            let fitted = whole.pair_of(spring);
            // Springs are not negative.
            if fitted.iter().all(|value| *value >= 0.0) {
                for (of_end, fitted) in values.iter_mut().zip(fitted) {
                    of_end[spring] = fitted;
                }
            }
        }
        for (row, values) in rows.iter_mut().zip(values) {
            row.stiffness = SoilStiffness::from_values(values);
        }
        rows
    }

    /// The sum ∫ k dz of each spring.
    pub(super) fn sum(&self, reactions: &Reactions<'_>) -> [f64; SPRINGS] {
        let length_m = self.upper_m - self.lower_m;
        self.moments(reactions, [-1.0, 1.0]).0[0].map(|mean| mean * length_m)
    }

    /// Twice the difference of the work of each spring and its lines, for a deflection that varies
    /// over a length (m) like that of a pile.
    ///
    /// With v² = Σ v_n P_n the lines miss Σ v_n ∫ δ P_n dz, δ their difference from the springs.
    /// Of v = e^(−z/l) cos(z/l) the n-th derivative of v² is at most ½ (2ⁿ + 8^(n/2)) v²/lⁿ.
    pub(super) fn missed(&self, reactions: &Reactions<'_>, length_m: f64) -> [f64; SPRINGS] {
        let own_m = self.upper_m - self.lower_m;
        let halves = self.halves(reactions);
        let moments = halves[0].and(&halves[1]);
        let [low, below, above, high] = self.pair_of(&halves).map(|row| row.stiffness.values());
        let mut of_lines = Moments::default();
        let line = |from: [f64; SPRINGS], to: [f64; SPRINGS], share: f64| {
            let value = |spring: usize| from[spring] + share * (to[spring] - from[spring]);
            SoilStiffness::from_values(std::array::from_fn(value))
        };
        of_lines.add(-1.0, 0.0, |s| line(low, below, 1.0 + s));
        of_lines.add(0.0, 1.0, |s| line(above, high, s));
        let x = 0.5 * own_m / length_m;
        std::array::from_fn(|spring| {
            let of = |moments: &Moments| moments.0.map(|moment| moment[spring]);
            let (a, b) = (of(&moments), of(&of_lines));
            let d: [f64; 5] = std::array::from_fn(|n| a[n] - b[n]);
            let second = (0.5 * (3.0 * d[2] - d[0])).abs() * 6.0 / 2.0 * 2.0 / 3.0;
            let third = (0.5 * (5.0 * d[3] - 3.0 * d[1])).abs() * 15.3 / 6.0 * 2.0 / 5.0;
            let fourth =
                (35.0 * d[4] - 30.0 * d[2] + 3.0 * d[0]).abs() / 8.0 * 40.0 / 24.0 * 8.0 / 35.0;
            own_m * x * x * (second + x * (third + x * fourth))
        })
    }

    fn height_m(&self, s: f64) -> f64 {
        0.5 * (self.lower_m + self.upper_m) + 0.5 * s * (self.upper_m - self.lower_m)
    }

    /// The moments of the springs between two values of s.
    fn moments(&self, reactions: &Reactions<'_>, [low, high]: [f64; 2]) -> Moments {
        let mut sum = Moments::default();
        let is_uppermost = self.upper_m >= reactions.pile.hole_m && high == 1.0;
        let mut from = low;
        for cut in GRADED {
            let to = low + cut * (high - low);
            if is_uppermost || cut == 1.0 {
                sum.add(from, to, |s| {
                    reactions.springs(self.layer, self.height_m(s))
                });
                from = to;
            }
        }
        sum
    }

    /// The line between two values of s with the sum and the first moment there.
    fn line_of(&self, moments: &Moments, [low, high]: [f64; 2]) -> [SoilRow; 2] {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let (mut ends, [sums, firsts, ..]) = ([[0.0; SPRINGS]; 2], moments.0);
        for spring in 0..SPRINGS {
            let mean = sums[spring] / half;
            let slope = 3.0 * (firsts[spring] / half - middle * mean) / half;
            // Springs are not negative: the sum is more important than the moment.
            let slope = match slope.abs() > mean {
                true => mean.copysign(slope),
                false => slope,
            };
            [ends[0][spring], ends[1][spring]] = [mean - slope, mean + slope];
        }
        let row = |s: f64, values| SoilRow {
            height_m: self.end_m(s),
            stiffness: SoilStiffness::from_values(values),
        };
        [row(low, ends[0]), row(high, ends[1])]
    }

    /// At the ends the height is exact.
    fn end_m(&self, s: f64) -> f64 {
        match s {
            -1.0 => self.lower_m,
            1.0 => self.upper_m,
            s => self.height_m(s),
        }
    }
}

impl Moments {
    fn add(&mut self, low: f64, high: f64, springs: impl Fn(f64) -> SoilStiffness) {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        for (node, weight) in GAUSS_5 {
            let s = middle + half * node;
            let values = springs(s).values();
            let mut power = 0.5 * half * weight;
            for moment in &mut self.0 {
                for (moment, value) in moment.iter_mut().zip(values) {
                    *moment += power * value;
                }
                power *= s;
            }
        }
    }

    fn and(&self, other: &Self) -> Self {
        let mut sum = *self;
        for (own, other) in sum.0.iter_mut().zip(&other.0) {
            own.iter_mut()
                .zip(other)
                .for_each(|(own, other)| *own += other);
        }
        sum
    }

    /// The values a + b |s| + c s + d sign(s) at s = −1, −0, +0, 1 with the moments 0 to 3 of a
    /// spring.
    fn pair_of(&self, spring: usize) -> [f64; 4] {
        let [mean, first, second, third, _] = self.0.map(|moment| moment[spring]);
        let b = 12.0 * (second - mean / 3.0);
        let a = mean - 0.5 * b;
        let c = 30.0 * third - 15.0 * first;
        let d = 12.0 * first - 20.0 * third;
        [a + b - c - d, a - d, a + d, a + b + c + d]
    }
}

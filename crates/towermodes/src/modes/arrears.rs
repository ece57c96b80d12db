//! The rule that names modes: each mode gets the name of the family whose energy in the modes so
//! far exceeds the number of its names by most.

/// A mode is not named after a family with less than this fraction of its largest share. On 200
/// random paths of towers this changes no name; on a turbine, or a tower with its mass far from its
/// axis, a mode could otherwise get a name of whose motion it has almost no energy.
const LEAST: f64 = 0.25;

/// Gives each mode of a list, by rising frequency, the family that is most in arrears: the one
/// whose energy so far exceeds the number of its names by most.
///
/// With p(n, f) the share of family f in the energy of mode n, and the arrears r(f), at first zero:
///
/// ```text
/// s(f) = r(f) + p(n, f);   f* = the first family with s(f) ≥ max s − tie
/// r(f) ← s(f) for all f, then r(f*) ← r(f*) − 1
/// ```
///
/// Families with less than a quarter of the mode's largest share are not considered.
///
/// Each family counts its names from 1, so no name is given twice and none is left out. A name
/// depends only on its own mode and the modes below it, so a longer list changes no name. For K
/// families and shares ≥ 0 that sum to 1 the energy of a family in the first n modes, C(n, f) = Σ
/// p(m, f), differs little from the number of its names c(n, f): −(1 − 1/K) ≤ C − c ≤ 1/2 + … +
/// 1/K, as long as the quarter excludes no family that is most in arrears. The energies C(n, f) are
/// continuous in every number of the structure where the next frequency is apart. So a name changes
/// its place only among the neighbouring modes that share its motion. [`Arrears::fade`] gives up
/// these bounds.
///
/// # Example
/// Two modes that share two motions nearly equally, between two that do not:
/// ```
/// use towermodes::modes::Arrears;
///
/// let mut arrears = Arrears::new([false; 2], 1e-6);
/// let modes = [[0.0, 1.0], [0.51, 0.49], [0.49, 0.51], [0.0, 1.0]];
/// let names = modes.map(|shares| arrears.name(&shares, |_| true));
/// assert_eq!(names, [(1, 1), (0, 1), (1, 2), (1, 3)]);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Arrears<const K: usize> {
    /// Whether a family has at most one mode.
    once: [bool; K],
    tie: f64,
    least: f64,
    /// Energy in the modes so far minus the number of names, reduced by [`fade`](Self::fade).
    arrears: [f64; K],
    named: [usize; K],
}

impl<const K: usize> Arrears<K> {
    /// No mode is named yet. A family with `once` = true names at most one mode. If the sums s of
    /// several families differ by no more than `tie`, the first of them names the mode.
    pub fn new(once: [bool; K], tie: f64) -> Self {
        Self {
            once,
            tie,
            least: LEAST,
            arrears: [0.0; K],
            named: [0; K],
        }
    }

    /// Multiplies the arrears by a factor from 0 to 1 before the next mode is named: 1 keeps the
    /// bounds above, 0 gives each mode its largest share.
    pub fn fade(&mut self, factor: f64) {
        for arrears in &mut self.arrears {
            *arrears *= factor;
        }
    }

    /// The same rule with another limit than a quarter: only families with at least the fraction
    /// `least` of the largest share of a mode are considered. With 0 the bounds above hold for all
    /// shares.
    pub fn with_least(self, least: f64) -> Self {
        Self { least, ..self }
    }

    /// The family of the next mode and its order in it, from 1. Only families for which `may` is
    /// true are considered, for example those of the motions that the structure couples in this
    /// mode.
    pub fn name(&mut self, shares: &[f64; K], may: impl Fn(usize) -> bool) -> (usize, usize) {
        let is_left =
            |family: usize| (!self.once[family] || self.named[family] == 0) && may(family);
        let left = (0..K).filter(|family| is_left(*family));
        let largest = left.fold(0.0, |largest, family| shares[family].max(largest));
        let sums: [f64; K] = std::array::from_fn(|family| {
            match is_left(family) && shares[family] >= self.least * largest {
                true => self.arrears[family] + shares[family],
                false => f64::NEG_INFINITY,
            }
        });
        let most = sums.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let is_most = |sum: &f64| *sum >= most - self.tie;
        let family = sums.iter().position(is_most).unwrap_or(0);
        for (arrears, share) in self.arrears.iter_mut().zip(shares) {
            *arrears += share;
        }
        self.arrears[family] -= 1.0;
        self.named[family] += 1;
        (family, self.named[family])
    }

    /// The order of the next mode of a family, if its modes have no energy in other families and
    /// other modes have no energy in it: its arrears stay zero.
    pub fn name_alone(&mut self, family: usize) -> usize {
        self.named[family] += 1;
        self.named[family]
    }

    /// The arrears r of each family: its energy in the modes so far less the number of its names,
    /// reduced by [`fade`](Self::fade).
    pub fn left(&self) -> &[f64; K] {
        &self.arrears
    }
}

#[cfg(test)]
mod tests {
    use super::Arrears;

    /// Names of modes with shares of fore-aft, side-side, torsion and axial motion.
    fn names(modes: &[[f64; 4]]) -> (String, [f64; 4]) {
        let mut arrears = Arrears::new([false; 4], 1e-6);
        let name = |shares: &[f64; 4]| {
            let (family, order) = arrears.name(shares, |_| true);
            format!("{}{order}", ["FA", "SS", "T", "A"][family])
        };
        let names: Vec<String> = modes.iter().map(name).collect();
        (names.join(" "), *arrears.left())
    }

    #[test]
    fn names_follow_by_hand() {
        let pure = [0.0, 1.0, 0.0, 0.0];
        let half = [0.5, 0.5, 0.0, 0.0];
        let twist = [0.0, 0.0, 1.0, 0.0];
        let ss_t = |side_side: f64| [0.0, side_side, 1.0 - side_side, 0.0];
        let others = [
            [0.25, 0.62, 0.0, 0.13],
            [0.52, 0.02, 0.0, 0.46],
            [0.01, 0.98, 0.0, 0.01],
        ];
        let three = |first: [f64; 4]| [&[first][..], &others].concat();
        // Shares, names, arrears that are left: an avoided crossing before and after; two
        // majorities of one family; another motion between; diagonal planes; three motions.
        type Case = (Vec<[f64; 4]>, &'static str, [f64; 4]);
        let cases: [Case; 8] = [
            (
                vec![pure, ss_t(0.49), ss_t(0.51), pure],
                "SS1 T1 SS2 SS3",
                [0.0; 4],
            ),
            (
                vec![pure, ss_t(0.51), ss_t(0.49), pure],
                "SS1 SS2 T1 SS3",
                [0.0; 4],
            ),
            (
                vec![ss_t(0.55), ss_t(0.53), ss_t(0.92)],
                "SS1 T1 SS2",
                [0.0; 4],
            ),
            (
                vec![
                    [0.0, 0.52, 0.48, 0.0],
                    [0.97, 0.02, 0.01, 0.0],
                    [0.0, 0.46, 0.51, 0.03],
                ],
                "SS1 FA1 T1",
                [-0.03, 0.0, 0.0, 0.03],
            ),
            (
                vec![half, half, twist, half, half],
                "FA1 SS1 T1 FA2 SS2",
                [0.0; 4],
            ),
            (
                three([0.27, 0.37, 0.0, 0.36]),
                "SS1 FA1 A1 SS2",
                [0.05, -0.01, 0.0, -0.04],
            ),
            (
                three([0.27, 0.36, 0.0, 0.37]),
                "A1 SS1 FA1 SS2",
                [0.05, -0.02, 0.0, -0.03],
            ),
            (
                vec![ss_t(0.8), ss_t(0.8), ss_t(0.55), ss_t(0.85)],
                "SS1 SS2 T1 SS3",
                [0.0; 4],
            ),
        ];
        for (modes, expected, left) in cases {
            let (names, arrears) = names(&modes);
            assert_eq!(names, expected, "{modes:?}");
            for (got, expected) in arrears.iter().zip(left) {
                assert!((got - expected).abs() < 1e-12, "{modes:?}: {arrears:?}");
            }
        }
    }

    #[test]
    fn a_family_that_is_there_once_names_one_mode() {
        let mut arrears = Arrears::new([true, false], 1e-6);
        let modes = [[0.6, 0.4], [0.9, 0.1], [0.0, 1.0]];
        let names = modes.map(|shares| arrears.name(&shares, |_| true));
        assert_eq!(names, [(0, 1), (1, 1), (1, 2)]);
    }

    #[test]
    fn a_family_that_may_not_name_a_mode_does_not() {
        let mut arrears = Arrears::new([false; 2], 1e-6);
        assert_eq!(arrears.name(&[1.0, 0.0], |family| family == 1), (1, 1));
    }

    /// Torsion has 31 % of the first mode and nothing of the third. It is most in arrears there, by
    /// 0.31 to 0.30, and does not name the mode.
    #[test]
    fn a_family_without_a_share_does_not_name_a_mode() {
        let first = [0.34, 0.35, 0.31, 0.0];
        let modes = [first, [0.56, 0.44, 0.0, 0.0], [0.40, 0.50, 0.0, 0.10]];
        let last = |least: f64| {
            let mut arrears = Arrears::new([false; 4], 1e-6).with_least(least);
            modes.map(|shares| arrears.name(&shares, |_| true))[2]
        };
        assert_eq!((last(0.0), last(0.25)), ((2, 1), (0, 2)));
    }

    /// The largest share of the second mode is of a family that has its one name.
    #[test]
    fn the_largest_share_is_that_of_the_families_left() {
        let mut arrears = Arrears::new([true, false, false], 1e-6);
        let modes = [[0.9, 0.1, 0.0], [0.9, 0.01, 0.09]];
        let names = modes.map(|shares| arrears.name(&shares, |_| true));
        assert_eq!(names, [(0, 1), (2, 1)]);
    }

    /// Two modes that share two motions: with all arrears each motion names one, without any the
    /// larger share names both.
    #[test]
    fn arrears_fade() {
        let shares = [[0.55, 0.45], [0.52, 0.48]];
        for (factor, expected) in [(1.0, [(0, 1), (1, 1)]), (0.0, [(0, 1), (0, 2)])] {
            let mut arrears = Arrears::new([false; 2], 1e-6);
            let names = shares.map(|shares| {
                arrears.fade(factor);
                arrears.name(&shares, |_| true)
            });
            assert_eq!(names, expected);
        }
    }

    /// The proved bounds of C − c, on random shares of four families: −3/4 and 13/12.
    #[test]
    fn energies_and_names_differ_by_no_more_than_the_bounds() {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1);
            (state >> 40) as f64 / (1_u64 << 24) as f64
        };
        let mut arrears = Arrears::new([false; 4], 1e-6).with_least(0.0);
        let (mut least, mut most) = (0.0_f64, 0.0_f64);
        for _ in 0..20_000 {
            // Cubes make shares of all sizes.
            let parts: [f64; 4] = std::array::from_fn(|_| random().powi(3));
            let sum: f64 = parts.iter().sum();
            arrears.name(&parts.map(|part| part / sum), |_| true);
            least = arrears.left().iter().copied().fold(least, f64::min);
            most = arrears.left().iter().copied().fold(most, f64::max);
        }
        assert!(least >= -0.75 - 1e-6 && most <= 13.0 / 12.0 + 1e-6);
        // The list comes close enough to both that a wrong sign would be seen.
        assert!(least < -0.6 && most > 0.6, "{least} {most}");
    }
}

//! Heights at which the springs of a layer change their formula.

use super::layer_springs::KINKS;
use super::reaction::Reactions;

/// The cause of a change of formula inside a layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kink {
    /// End of the depth over which the hole of local scour reduces the effective stress.
    Overburden,
    /// A change in the lateral model, by its index.
    Across(usize),
    /// A change in the axial springs.
    Axial,
}

/// Number of intervals of a section in the search for a kink.
const INTERVALS: usize = 8;
/// How far inside a section its ends are looked at.
const INSIDE: f64 = 1e-9;
/// Limit of the number of steps to a zero.
const STEPS: usize = 60;

impl Kink {
    /// All kinks. Springs may depend on the effective stress, so its kink is first.
    pub(super) fn all() -> impl Iterator<Item = Self> {
        let across = (0..KINKS).map(Self::Across);
        [Self::Overburden]
            .into_iter()
            .chain(across)
            .chain([Self::Axial])
    }

    /// A number that changes its sign at the kink; none if the springs of the layer have no such
    /// kink.
    fn value(self, reactions: &Reactions<'_>, layer: usize, height_m: f64) -> Option<f64> {
        match self {
            Self::Overburden => reactions.pile.overburden_excess_pa(height_m),
            Self::Across(number) => reactions.kink(layer, number, height_m),
            Self::Axial => reactions.axial_kink(layer, height_m),
        }
    }

    /// The first height of this kink above the lower one of two heights between which the tower has
    /// no row, as a fraction of their distance.
    pub(super) fn share(
        self,
        reactions: &Reactions<'_>,
        layer: usize,
        [lower_m, upper_m]: [f64; 2],
    ) -> Option<f64> {
        let value =
            |share: f64| self.value(reactions, layer, lower_m + share * (upper_m - lower_m));
        // At the ends of the section the tube could be that of the adjacent section.
        let border = |i: usize| (i as f64 / INTERVALS as f64).clamp(INSIDE, 1.0 - INSIDE);
        let first = value(border(0))?;
        let mut low = (border(0), first);
        for i in 1..=INTERVALS {
            let high = (border(i), value(border(i))?);
            if (high.1 < 0.0) != (first < 0.0) {
                return Some(zero(low, high, value));
            }
            low = high;
        }
        None
    }
}

/// A zero between two points with values of different sign, by the Illinois method: for smooth
/// functions it needs a few steps to the last digit.
fn zero(
    (mut low, mut of_low): (f64, f64),
    (mut high, mut of_high): (f64, f64),
    value: impl Fn(f64) -> Option<f64>,
) -> f64 {
    let (mut middle, mut last_was_high) = (f64::NAN, None);
    for _ in 0..STEPS {
        let before = middle;
        middle = (low * of_high - high * of_low) / (of_high - of_low);
        let Some(of_middle) = value(middle).filter(|_| middle != before) else {
            break;
        };
        let is_high = (of_middle < 0.0) == (of_high < 0.0);
        let is_again = last_was_high == Some(is_high);
        // The value at an end that stays for a second step is halved.
        match (is_high, is_again) {
            (true, true) => of_low *= 0.5,
            (false, true) => of_high *= 0.5,
            (_, false) => {}
        }
        match is_high {
            true => (high, of_high) = (middle, of_middle),
            false => (low, of_low) = (middle, of_middle),
        }
        last_was_high = Some(is_high);
    }
    middle
}

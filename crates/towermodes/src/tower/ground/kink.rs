//! Heights at which the springs of a layer change their formula.

use super::axial::randolph_wroth_zone;
use super::clay::Resistance;
use super::description::AxialModel;
use super::layer::LayerSoil;
use super::pile::Pile;
use super::pisa::Pisa;
use super::reaction::resistance;
use super::rock::GROWS_DIAMETERS;

/// What changes the formula of the springs inside a layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kink {
    /// The hole of local scour no longer reduces the effective stress.
    Overburden,
    /// The resistance of clay is that of a flow around the pile.
    DeepResistance,
    /// The lateral springs of PISA end.
    PisaLateral,
    /// The springs of PISA against rotation end.
    PisaRotation,
    /// Weak rock does not get stiffer.
    FullRock,
    /// The logarithm of Randolph & Wroth is as small as it is taken.
    AxialZone,
}

/// Into how many intervals a section is divided in the search for a kink.
const INTERVALS: usize = 8;
/// How far inside a section its ends are looked at.
const INSIDE: f64 = 1e-9;
/// The most steps to a zero.
const STEPS: usize = 60;

impl Kink {
    /// All of them. The resistance of clay depends on the effective stress, which comes before it.
    pub(super) const ALL: [Self; 6] = [
        Self::Overburden,
        Self::DeepResistance,
        Self::PisaLateral,
        Self::PisaRotation,
        Self::FullRock,
        Self::AxialZone,
    ];

    /// A number that changes its sign at the kink; none if the springs of the layer have no such
    /// kink.
    fn value(self, pile: &Pile<'_>, index: usize, height_m: f64) -> Option<f64> {
        let layer = &pile.ground.layers[index];
        let (depth_m, diameter_m) = (pile.depth_m(height_m), pile.diameter_m(height_m));
        match self {
            Self::Overburden => pile.overburden_excess_pa(height_m),
            Self::DeepResistance => {
                let Resistance { shallow, deep } = resistance(pile, index, height_m)?;
                Some(shallow - deep)
            }
            Self::PisaLateral => Some(Pisa::of(layer)?.lateral.at(depth_m / diameter_m)),
            Self::PisaRotation => Some(Pisa::of(layer)?.rotation.at(depth_m / diameter_m)),
            Self::FullRock => {
                let in_rock_m = pile.rock_surface_m(index) - height_m;
                let is_rock = matches!(layer.soil, LayerSoil::Rock(_));
                is_rock.then_some(in_rock_m - GROWS_DIAMETERS * diameter_m)
            }
            Self::AxialZone => {
                let is_used = pile.ground.axial == Some(AxialModel::RandolphWroth);
                let zone = || randolph_wroth_zone(layer, pile.length_m(), 0.5 * diameter_m);
                is_used.then(|| zone() - 1.0)
            }
        }
    }

    /// The first height of this kink above the lower one of two heights between which the tower has
    /// no row, as a fraction of the way.
    pub(super) fn share(
        self,
        pile: &Pile<'_>,
        layer: usize,
        [lower_m, upper_m]: [f64; 2],
    ) -> Option<f64> {
        let value = |share: f64| self.value(pile, layer, lower_m + share * (upper_m - lower_m));
        // At the ends themselves the tube may be the neighbour.
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

/// A zero between two points with values of different sign, by the rule of Illinois: of smooth
/// functions in a few steps to the last digit.
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
        // An end that stays twice counts half.
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

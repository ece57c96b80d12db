//! Remarks on the result of a fit, in words.

use towermodes::ModeName;
use towermodes::modes::SharedMotion;

use super::determined::NO_EFFECT;
use super::pairing::Ambiguity;
use super::point::{AtBound, LARGE_RESIDUAL};
use super::result::{Calibration, Direction, Explained};

/// If the correlation of two unknowns is larger, only a combination of them is known.
const HIGH_CORRELATION: f64 = 0.95;
/// A combination is not determined by the measurements if it changes them by less than this many
/// standard deviations when each unknown changes by its own size.
const WEAK: f64 = 1.0;
/// Components of a combination that are smaller than this are omitted from the sentence.
const SMALL_PART: f64 = 0.2;
/// A component that changes the measurements by more than this many standard deviations is never
/// omitted.
const SMALL_EFFECT: f64 = 0.02;
/// The largest component of a combination in its sentence: a factor of 1.2, for which the change of
/// the frequencies is nearly linear.
const LARGEST_MOVE: f64 = 0.18;
/// The normal deviate that is exceeded with a probability of 1 %.
const ONE_PERCENT: f64 = 2.326;

/// A sentence about a fit.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Remark {
    /// The measurements do not distinguish several unknowns: this change of them, by names and
    /// relative or absolute amounts, changes the measured frequencies by only `deviations` standard
    /// deviations.
    NotToldApart {
        /// The unknowns and their changes: a factor for positive input values, an addition in their
        /// unit for others.
        changes: Vec<UnknownChange>,
        /// The change of all measurements together, standard deviations.
        deviations: f64,
    },
    /// Two unknowns are highly correlated.
    Correlated {
        /// The first unknown.
        first: String,
        /// The second unknown.
        second: String,
        /// The correlation.
        correlation: f64,
    },
    /// An unknown has reached its bound.
    Bound {
        /// The unknown.
        name: String,
        /// The bound.
        bound: AtBound,
        /// Its value.
        value: f64,
    },
    /// An unknown is known mainly from its prior.
    FromPrior {
        /// The unknown.
        name: String,
        /// The share of its variance that comes from its prior.
        share: f64,
    },
    /// Most of the variance of an unknown comes from the priors of other unknowns.
    FromOtherPriors {
        /// The unknown.
        name: String,
        /// The other unknown whose prior has the largest share.
        other: String,
        /// The share of its variance that comes from priors.
        share: f64,
        /// Whether its own prior is among them.
        has_prior: bool,
    },
    /// No measured frequency changes with an unknown to first order at the fitted values.
    NoEffect {
        /// The unknown.
        name: String,
        /// Its value, if a larger change of it changes a measured frequency.
        stationary_at: Option<f64>,
        /// Whether it has a prior.
        has_prior: bool,
    },
    /// A measurement could be of another mode.
    Pairing {
        /// The measurement, from 0.
        index: usize,
        /// The selected mode.
        mode: ModeName,
        /// The other mode.
        ambiguity: Ambiguity,
    },
    /// Several modes of the fitted tower share the type of motion of a measured name.
    Shared(SharedMotion),
    /// The modes of the fitted tower are paired differently.
    UnstablePairing,
    /// The certificate of the fitted tower is incomplete.
    Uncertified,
    /// The fit does not reproduce a frequency.
    LargeResidual {
        /// The mode.
        mode: ModeName,
        /// (fitted − measured)/deviation.
        residual: f64,
    },
    /// The fit does not reproduce a frequency, because unknowns are at their bounds.
    OutsideBounds {
        /// The mode.
        mode: ModeName,
        /// The measured frequency, Hz.
        measured_hz: f64,
        /// The fitted frequency, Hz.
        fitted_hz: f64,
        /// (fitted − measured)/deviation.
        residual: f64,
        /// The unknowns at bounds that prevent a nearer frequency, and these bounds.
        bounds: Vec<(String, AtBound, f64)>,
    },
    /// The sum of all squared residuals is larger than the standard deviations allow.
    PoorFit {
        /// Sum of squares.
        chi_square: f64,
        /// Degrees of freedom.
        degrees_of_freedom: usize,
    },
    /// There are as many unknowns as measurements: every fit reproduces the measurements, so it
    /// does not test the model.
    NoDegreesOfFreedom,
}

/// The change of an unknown in a combination.
#[derive(Debug, Clone, PartialEq)]
pub struct UnknownChange {
    /// The unknown.
    pub name: String,
    /// The factor for a positive input value; the addition for any other.
    pub amount: f64,
    /// Whether it is a factor.
    pub is_factor: bool,
}

impl Calibration {
    /// The remarks on the result, the most important first.
    pub fn remarks(&self) -> Vec<Remark> {
        let mut remarks = Vec::new();
        remarks.extend(self.of_pairing());
        remarks.extend(self.of_residuals());
        remarks.extend(self.of_bounds());
        remarks.extend(self.without_effect());
        remarks.extend(self.not_told_apart());
        remarks.extend(self.of_correlations());
        remarks.extend(self.of_priors());
        remarks
    }

    fn of_pairing(&self) -> impl Iterator<Item = Remark> {
        let all = self.measured.iter().enumerate();
        let ambiguous = all.filter_map(|(index, one)| {
            Some(Remark::Pairing {
                index,
                mode: one.mode,
                ambiguity: one.ambiguity?,
            })
        });
        let unstable = (!self.is_pairing_stable).then_some(Remark::UnstablePairing);
        let uncertified = (!self.is_certified).then_some(Remark::Uncertified);
        let shared = self.shared.iter().cloned().map(Remark::Shared);
        let of_all = uncertified.into_iter().chain(unstable);
        of_all.chain(ambiguous).chain(shared)
    }

    fn of_residuals(&self) -> impl Iterator<Item = Remark> {
        let large = self
            .measured
            .iter()
            .filter(|one| one.residual.abs() > LARGE_RESIDUAL);
        let large = large.map(|one| match one.held_by.is_empty() {
            true => Remark::LargeResidual {
                mode: one.mode,
                residual: one.residual,
            },
            false => self.outside_bounds(one),
        });
        let (chi_square, degrees_of_freedom) = (self.chi_square, self.degrees_of_freedom);
        let of_all = match degrees_of_freedom {
            0 => Some(Remark::NoDegreesOfFreedom),
            k if deviate(chi_square, k) > ONE_PERCENT => Some(Remark::PoorFit {
                chi_square,
                degrees_of_freedom,
            }),
            _ => None,
        };
        of_all.into_iter().chain(large)
    }

    fn outside_bounds(&self, one: &Explained) -> Remark {
        let bounds = one.held_by.iter().map(|&(j, bound)| {
            let unknown = &self.unknowns[j];
            (unknown.name.clone(), bound, unknown.value)
        });
        Remark::OutsideBounds {
            mode: one.mode,
            measured_hz: one.measured_hz,
            fitted_hz: one.fitted_hz,
            residual: one.residual,
            bounds: bounds.collect(),
        }
    }

    /// Whether at least one measured frequency changes with an unknown to first order by more than
    /// the errors of derivatives.
    fn has_effect(&self, j: usize) -> bool {
        let mut alone = vec![0.0; self.unknowns.len()];
        alone[j] = 1.0;
        self.effect(&alone) > NO_EFFECT
    }

    fn without_effect(&self) -> impl Iterator<Item = Remark> {
        let all = self.unknowns.iter().enumerate();
        let without = all.filter(|(j, _)| !self.has_effect(*j));
        without.map(|(_, one)| Remark::NoEffect {
            name: one.name.clone(),
            stationary_at: one.has_effect.then_some(one.value),
            has_prior: one.prior.is_some(),
        })
    }

    fn of_bounds(&self) -> impl Iterator<Item = Remark> {
        let all = self.unknowns.iter().enumerate();
        let moving = all.filter(|(j, _)| self.has_effect(*j));
        moving.filter_map(|(_, one)| {
            Some(Remark::Bound {
                name: one.name.clone(),
                bound: one.at_bound?,
                value: one.value,
            })
        })
    }

    fn not_told_apart(&self) -> impl Iterator<Item = Remark> {
        let weak = self
            .directions
            .iter()
            .filter(|one| one.singular_value < WEAK);
        let all = weak.map(|direction| self.combination(direction));
        // Of a number without any effect it is said alone.
        all.filter(|remark| match remark {
            Remark::NotToldApart { changes, .. } => changes.iter().any(|one| {
                let mut all = self.unknowns.iter();
                let place = all.position(|unknown| unknown.name == one.name);
                place.is_some_and(|j| self.has_effect(j))
            }),
            _ => true,
        })
    }

    /// A combination, scaled so that factors stay near 1 and the linear prediction holds. Only
    /// unknowns with small components and small effects on the measurements are omitted.
    fn combination(&self, direction: &Direction) -> Remark {
        let largest = direction
            .parts
            .iter()
            .fold(0.0_f64, |most, p| most.max(p.abs()));
        let sign = direction.parts.iter().find(|part| part.abs() == largest);
        let length = sign.map_or(1.0, |part| LARGEST_MOVE / part);
        let moves: Vec<f64> = direction.parts.iter().map(|part| length * part).collect();
        let is_named = |j: usize| {
            let mut alone = vec![0.0; moves.len()];
            alone[j] = moves[j];
            moves[j].abs() > SMALL_PART * LARGEST_MOVE || self.effect(&alone) > SMALL_EFFECT
        };
        let named = (0..moves.len()).map(|j| if is_named(j) { moves[j] } else { 0.0 });
        let named: Vec<f64> = named.collect();
        let all = named.iter().zip(&direction.scales).zip(&self.unknowns);
        let changes = all.filter(|((part, _), _)| **part != 0.0);
        let changes = changes.map(|((part, scale), unknown)| UnknownChange {
            name: unknown.name.clone(),
            amount: if unknown.is_logarithm {
                part.exp()
            } else {
                part * scale
            },
            is_factor: unknown.is_logarithm,
        });
        Remark::NotToldApart {
            changes: changes.collect(),
            deviations: self.effect(&named),
        }
    }

    /// The change of the measurements by these moves, to first order, in standard deviations: the
    /// length of J·moves, with J = U·S·Vᵀ.
    fn effect(&self, moves: &[f64]) -> f64 {
        let along = self.directions.iter().map(|direction| {
            let parts = direction.parts.iter().zip(moves);
            direction.singular_value * parts.map(|(part, x)| part * x).sum::<f64>()
        });
        along.map(|change| change * change).sum::<f64>().sqrt()
    }

    fn of_correlations(&self) -> Vec<Remark> {
        let mut remarks = Vec::new();
        for (i, row) in self.correlations.iter().enumerate() {
            for (j, correlation) in row.iter().enumerate().skip(i + 1) {
                if correlation.abs() > HIGH_CORRELATION {
                    remarks.push(Remark::Correlated {
                        first: self.unknowns[i].name.clone(),
                        second: self.unknowns[j].name.clone(),
                        correlation: *correlation,
                    });
                }
            }
        }
        remarks
    }

    fn of_priors(&self) -> impl Iterator<Item = Remark> {
        let all = self.unknowns.iter().zip(&self.shares).enumerate();
        let moving = all.filter(|(j, _)| self.has_effect(*j));
        moving.filter_map(|(_, (unknown, shares))| {
            let share: f64 = shares.iter().skip(self.measured.len()).sum();
            let name = unknown.name.clone();
            let own = self.prior_share(&unknown.name, shares);
            match share > 0.5 {
                false => None,
                true if own > 0.5 => Some(Remark::FromPrior { name, share: own }),
                true => Some(Remark::FromOtherPriors {
                    other: self.largest_prior(&unknown.name, shares)?,
                    name,
                    share,
                    has_prior: unknown.prior.is_some(),
                }),
            }
        })
    }

    /// The unknowns with priors, and the share of each prior in a variance.
    fn prior_shares<'a>(
        &'a self,
        shares: &'a [f64],
    ) -> impl Iterator<Item = (&'a str, f64)> + use<'a> {
        let with_prior = self.unknowns.iter().filter(|one| one.prior.is_some());
        let shares = shares.iter().skip(self.measured.len());
        with_prior
            .zip(shares)
            .map(|(one, share)| (&*one.name, *share))
    }

    /// The share of an unknown's own prior.
    fn prior_share(&self, name: &str, shares: &[f64]) -> f64 {
        let own = self.prior_shares(shares).find(|(of, _)| *of == name);
        own.map_or(0.0, |(_, share)| share)
    }

    /// The other unknown whose prior has the largest share.
    fn largest_prior(&self, name: &str, shares: &[f64]) -> Option<String> {
        let others = self.prior_shares(shares).filter(|(of, _)| *of != name);
        let largest = others.max_by(|a, b| a.1.total_cmp(&b.1));
        largest.map(|(of, _)| of.to_owned())
    }
}

/// The normal deviate of a sum of squares by the cube root of Wilson & Hilferty (1931).
fn deviate(chi_square: f64, degrees_of_freedom: usize) -> f64 {
    let k = degrees_of_freedom as f64;
    let spread = 2.0 / (9.0 * k);
    ((chi_square / k).cbrt() - (1.0 - spread)) / spread.sqrt()
}

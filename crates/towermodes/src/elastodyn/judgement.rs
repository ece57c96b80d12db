//! How far the shapes of a tower file are from the tower's own.

use super::mac::mac;
use super::model::{ModelError, PlaneModes, TowerModel};
use super::decimal::SUM_TOLERANCE;
use super::polynomial::TowerPolynomial;
use super::shapes::{TowerShape, TowerShapes};
use crate::verdict::Verdict;
use crate::tower::{Plane, Planes};

/// How large a difference passes, and how large a one is only warned of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JudgementLimits {
    /// Root of the mean square of the difference, as a share of the shape's largest deflection.
    pub rms: [f64; 2],
    /// 1 − MAC.
    pub mac: [f64; 2],
    /// Relative difference of the frequencies that ElastoDyn makes of the shapes.
    pub frequency: [f64; 2],
}

impl Default for JudgementLimits {
    fn default() -> Self {
        Self {
            rms: [0.01, 0.05],
            mac: [0.001, 0.01],
            frequency: [0.01, 0.05],
        }
    }
}

/// A shape of a tower file beside the tower's own.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// The plane it bends in.
    pub plane: Plane,
    /// 1 or 2.
    pub number: usize,
    /// Frequency of the tower's own mode, with all that it carries and stands on, Hz.
    pub mode_hz: f64,
    /// What the coefficients add up to; OpenFAST refuses what is farther than 0.0015 from 1.
    pub sum: f64,
    /// Root of the mean square over the height of the difference to the mode, as a share of its largest deflection.
    pub rms: f64,
    /// The same of the best polynomial.
    pub best_rms: f64,
    /// Modal assurance criterion (Σab)²/(Σa² Σb²) with the mode.
    pub mac: f64,
    /// Frequency that ElastoDyn makes of the shape, of the tower without what it carries, Hz.
    pub implied_hz: f64,
    /// The same of the best polynomial.
    pub best_implied_hz: f64,
    /// Whether it passes.
    pub verdict: Verdict,
}

impl Judgement {
    /// How many times as far off as the best polynomial.
    pub fn rms_ratio(&self) -> f64 {
        self.rms / self.best_rms
    }
}

/// Judges the shapes of a tower file by the tower's own. `shipped` has what the file says of each plane.
///
/// # Errors
/// [`ModelError`] for what ElastoDyn cannot take.
pub fn judge(
    model: &TowerModel,
    shipped: &Planes<PlaneModes>,
    own: &TowerShapes,
    limits: &JudgementLimits,
) -> Result<[Judgement; 4], ModelError> {
    let implied = |plane: Plane| -> Result<_, ModelError> {
        let modes = shipped.of(plane);
        let best = PlaneModes {
            shapes: own.polynomials(plane),
            ..modes
        };
        let frequencies = |modes: &PlaneModes| {
            let of_modes = model.generalized(plane, modes);
            of_modes.map(|quantities| quantities.frequency_alone_hz)
        };
        Ok((frequencies(&modes)?, frequencies(&best)?))
    };
    let implied = [implied(Plane::ForeAft)?, implied(Plane::SideSide)?];
    Ok(std::array::from_fn(|i| {
        let (shape, (shipped_hz, best_hz)) = (&own.shapes[i], implied[i / 2]);
        let polynomial = shipped.of(shape.plane).shapes[i % 2];
        let mut judgement = compared(shape, &polynomial);
        judgement.implied_hz = shipped_hz[i % 2];
        judgement.best_implied_hz = best_hz[i % 2];
        judgement.verdict = judgement.by(limits);
        judgement
    }))
}

fn compared(shape: &TowerShape, polynomial: &TowerPolynomial) -> Judgement {
    let tip = shape.fit.tip_deflection;
    let points: Vec<(f64, f64)> = shape.samples.bent().map(|(x, w)| (x, w / tip)).collect();
    let values: Vec<f64> = points.iter().map(|(_, w)| *w).collect();
    let shipped: Vec<f64> = points.iter().map(|(x, _)| polynomial.value(*x)).collect();
    let largest = shape.fit.largest_deflection;
    let squares = points.windows(2).zip(shipped.windows(2));
    let mean_square: f64 = squares
        .map(|(mode, file)| {
            let off = |k: usize| (file[k] - mode[k].1).powi(2);
            0.5 * (mode[1].0 - mode[0].0) * (off(0) + off(1))
        })
        .sum();
    Judgement {
        plane: shape.plane,
        number: shape.number,
        mode_hz: shape.frequency_hz,
        sum: polynomial.sum(),
        rms: mean_square.sqrt() / largest,
        best_rms: shape.fit.rms_residual / largest,
        mac: mac(&values, &shipped, None).unwrap_or(0.0),
        implied_hz: f64::NAN,
        best_implied_hz: f64::NAN,
        verdict: Verdict::Fail,
    }
}

impl Judgement {
    /// The worst of what its numbers say.
    fn by(&self, limits: &JudgementLimits) -> Verdict {
        if (self.sum - 1.0).abs() > SUM_TOLERANCE {
            return Verdict::Fail;
        }
        let frequency = (self.implied_hz / self.best_implied_hz - 1.0).abs();
        let measured = [
            (self.rms, limits.rms),
            (1.0 - self.mac, limits.mac),
            (frequency, limits.frequency),
        ];
        let within = |which: usize| measured.iter().all(|(value, limit)| *value <= limit[which]);
        if within(0) {
            Verdict::Pass
        } else if within(1) {
            Verdict::Warn
        } else {
            Verdict::Fail
        }
    }
}

//! Derivatives at the mean values, and the scatter computed from them.

use towermodes::{Change, ModeName, Operation, Sensitivities, Solver, TowerDescription};
use towermodes_files::{Sampling, SamplingKind};

use super::normal::inside;
use super::{FirstOrder, FirstOrderError, InputScatter, ModeScatter, NoScatter, Scatter};
use crate::rows::row::{Cells, RowSolver};
use crate::sampling::{Draw, Joint};
use crate::summary::MarginCheck;
use crate::sweep::Sweep;

impl Sweep {
    /// The scatter of each frequency, to first order, due to the distributions of the varied
    /// inputs: mean, standard deviation, the share of each input, and the probability that a
    /// resonance margin is violated. It takes one solve with derivatives, and two solves per input
    /// to estimate the accuracy of the first order. An observer of the solver is called for every
    /// solve; the options are those of the sweep.
    ///
    /// # Errors
    /// [`FirstOrderError`]. If only a single mode has no derivative, its result contains the
    /// reason.
    pub fn first_order(
        &self,
        sampling: &Sampling,
        check: Option<&MarginCheck>,
        solver: Solver,
    ) -> Result<FirstOrder, FirstOrderError> {
        if sampling.kind == SamplingKind::Grid {
            return Err(FirstOrderError::Grid);
        }
        // Also the correlations that only drawing refuses.
        Draw::new(sampling)?;
        let joint = Joint::of(sampling)?;
        self.check_changes(sampling, &joint)?;
        let means: Vec<f64> = joint.moments.iter().map(|[mean, _]| *mean).collect();
        let mut solver = RowSolver::within(self, solver);
        let middle = self.at(&means, &mut solver)?;
        let found = self.derivatives(&means, &mut solver.solver)?;
        let shifts = self.mean_shifts_hz(&means, &joint, &middle, &mut solver);
        let scatter = |(index, name): (usize, &ModeName)| ModeScatter {
            name: *name,
            scatter: self
                .scatter(index, &middle, &found, &joint, check)
                .map(|scatter| Scatter {
                    mean_shift_hz: Some(shifts[index]).filter(|shift| shift.is_finite()),
                    ..scatter
                }),
        };
        let modes = self.modes().iter().enumerate().map(scatter).collect();
        let inputs = self.changes().iter().zip(&joint.moments);
        let input = |(change, [mean, deviation]): (&Change, &[f64; 2])| InputScatter {
            name: change.name().to_owned(),
            unit: change.unit(),
            mean: *mean,
            deviation: *deviation,
        };
        Ok(FirstOrder {
            inputs: inputs.map(input).collect(),
            modes,
        })
    }

    /// Refuses changes whose derivatives at the means are not those of a tower: input values that
    /// are both set and multiplied, or multiplied and added to; factors whose mean is 0.
    fn check_changes(&self, sampling: &Sampling, joint: &Joint) -> Result<(), FirstOrderError> {
        let changes = self.changes();
        let names = changes.iter().map(Change::name);
        if !names.eq(sampling.vary.iter().map(|varied| varied.name.trim())) {
            return Err(FirstOrderError::OtherChanges);
        }
        for (place, (second, [mean, _])) in changes.iter().zip(&joint.moments).enumerate() {
            if second.operation() == Operation::Scale && *mean == 0.0 {
                let change = second.name().to_owned();
                return Err(FirstOrderError::ZeroFactor { change });
            }
            let shares = |first: &&Change| {
                let numbers = second.parameters();
                first.operation() != second.operation()
                    && first.parameters().iter().any(|one| numbers.contains(one))
            };
            if let Some(first) = changes[..place].iter().find(shares) {
                return Err(FirstOrderError::Overlap {
                    first: first.name().to_owned(),
                    second: second.name().to_owned(),
                });
            }
        }
        Ok(())
    }

    /// The frequencies of the row with the mean values.
    fn at(&self, means: &[f64], solver: &mut RowSolver<'_>) -> Result<Row, FirstOrderError> {
        let row = Row::solved(solver, means, self.modes().len());
        match (row.frequency_hz.iter().all(|hz| hz.is_nan()), &row.sentence) {
            (true, Some(sentence)) => {
                let sentence = sentence.clone();
                Err(FirstOrderError::Means { sentence })
            }
            _ => Ok(row),
        }
    }

    /// The derivatives at the means, with as many modes as the requested names need there.
    fn derivatives(
        &self,
        means: &[f64],
        solver: &mut Solver,
    ) -> Result<Sensitivities, FirstOrderError> {
        let mut description: TowerDescription = self.base().clone();
        for (change, mean) in self.changes().iter().zip(means) {
            change.apply(&mut description, *mean);
        }
        Ok(solver.sensitivities(&description, self.changes())?)
    }

    /// ½ tr(H C) of each mode, by differences along the independent directions; NaN if a tower
    /// cannot be solved.
    fn mean_shifts_hz(
        &self,
        means: &[f64],
        joint: &Joint,
        middle: &Row,
        solver: &mut RowSolver<'_>,
    ) -> Vec<f64> {
        let modes = self.modes().len();
        let mut shifts = vec![0.0; modes];
        for direction in &joint.directions {
            let mut along = |sign: f64| {
                let mut values = means.to_vec();
                for (place, amount) in direction {
                    values[*place] += sign * amount;
                }
                Row::solved(solver, &values, modes).frequency_hz
            };
            let (above, below) = (along(1.0), along(-1.0));
            for (mode, shift) in shifts.iter_mut().enumerate() {
                *shift += 0.5 * (above[mode] + below[mode]) - middle.frequency_hz[mode];
            }
        }
        shifts
    }

    /// The scatter of a mode by its index, without the shift of its mean.
    fn scatter(
        &self,
        index: usize,
        middle: &Row,
        found: &Sensitivities,
        joint: &Joint,
        check: Option<&MarginCheck>,
    ) -> Result<Scatter, NoScatter> {
        let no_mode = || NoScatter::NoMode {
            sentence: middle.sentence.clone().unwrap_or_default(),
        };
        let mean_hz = middle.frequency_hz[index];
        if mean_hz.is_nan() {
            return Err(no_mode());
        }
        let place = place(found, &self.modes()[index]).ok_or_else(no_mode)?;
        let derivatives = found.changes.iter().zip(&joint.moments);
        let derivatives = derivatives.map(|(of_change, [mean, _])| {
            let change = &of_change.change;
            match of_change.modes[place] {
                Ok(derivative) => Ok(per_value(change, derivative.hz_per_unit, *mean)),
                Err(reason) => Err(NoScatter::NoDerivative {
                    change: change.name().to_owned(),
                    reason,
                }),
            }
        });
        let hz_per_unit: Vec<f64> = derivatives.collect::<Result<_, _>>()?;
        let parts: Vec<f64> = parts(&hz_per_unit, joint);
        let variance = parts.iter().sum::<f64>().max(0.0);
        let share = |part: f64| if variance > 0.0 { part / variance } else { 0.0 };
        let error_hz = middle.error_hz[index];
        let deviation_hz = variance.sqrt();
        let violated = check.map_or(Vec::new(), |check| {
            let of = |multiple: &usize| check.range_hz(*multiple);
            let around = |range: [f64; 2]| inside(range, mean_hz, deviation_hz);
            check.multiples.iter().map(of).map(around).collect()
        });
        Ok(Scatter {
            mean_hz,
            error_hz,
            deviation_hz,
            mean_shift_hz: None,
            hz_per_unit,
            shares: parts.into_iter().map(share).collect(),
            violated,
        })
    }
}

/// Frequencies of a row.
struct Row {
    frequency_hz: Vec<f64>,
    error_hz: Vec<f64>,
    sentence: Option<String>,
}

impl Row {
    fn solved(solver: &mut RowSolver<'_>, values: &[f64], modes: usize) -> Self {
        let cells = || vec![f64::NAN; modes];
        let [mut frequency_hz, mut error_hz, mut share] = [(); 3].map(|()| cells());
        let cells = Cells {
            mass_kg: &mut 0.0,
            certified: &mut false,
            frequency_hz: &mut frequency_hz,
            error_hz: &mut error_hz,
            share: &mut share,
        };
        let sentence = solver.solve(values, cells);
        Self {
            frequency_hz,
            error_hz,
            sentence,
        }
    }
}

/// The index of a mode in a list of derivatives.
fn place(found: &Sensitivities, name: &ModeName) -> Option<usize> {
    let mut modes = found.modes.iter();
    modes.position(|mode| (mode.family, mode.order) == (name.family, name.order))
}

/// The derivative with respect to the value of a change, from the derivative on the tower at the
/// means, where all factors are 1.
fn per_value(change: &Change, hz_per_unit: f64, mean: f64) -> f64 {
    match change.operation() {
        Operation::Scale => hz_per_unit / mean,
        Operation::Set | Operation::Add => hz_per_unit,
    }
}

/// The part of each input in the variance, gᵢ (C g)ᵢ.
fn parts(hz_per_unit: &[f64], joint: &Joint) -> Vec<f64> {
    let scaled = hz_per_unit.iter().zip(&joint.moments);
    let scaled: Vec<f64> = scaled.map(|(g, [_, deviation])| g * deviation).collect();
    let mut parts: Vec<f64> = scaled.iter().map(|part| part * part).collect();
    for ([first, second], coefficient) in &joint.correlations {
        let both = coefficient * scaled[*first] * scaled[*second];
        parts[*first] += both;
        parts[*second] += both;
    }
    parts
}

//! Derivatives from new solves, for changes that change the structure of the tower: if a row of the
//! soil leaves the height of a station, it divides a linear piece in two.

use super::slope::Derivatives;
use super::step::step;
use super::{Derivative, NoDerivative};
use crate::Method;
use crate::parameter::Change;
use crate::solve::{ModeFrequency, Options, Solver};
use crate::tower::{Neighbours, Tower};

/// Differences of solved frequencies need larger steps than those of quotients, by this factor.
const LARGER: f64 = 2.0;

/// The frequencies of the modes and the mass (kg) of a tower near another one.
type Solved = (Vec<Option<f64>>, f64);

/// The derivatives from frequencies of the spectral method, which do not depend on a mesh.
pub(super) fn derivatives(
    neighbours: &Neighbours,
    (change, value): (&Change, f64),
    modes: &[ModeFrequency],
    solver: &mut Solver,
) -> Derivatives {
    let spectral = Options {
        method: Method::Spectral,
        segments: None,
        borders_m: None,
        ..solver.options.clone()
    };
    let mut solve = |value: f64| -> Option<Solved> {
        let mut description = neighbours.description().clone();
        change.apply(&mut description, value);
        let tower = Tower::new(description).ok()?;
        solver.with(spectral.clone(), |solver| {
            let solved = solver.frequencies(&tower).ok()?;
            let frequency = |(place, mode): (usize, &ModeFrequency)| {
                // Modes that share a motion may exchange names, but not their order.
                let same = match mode.shares.is_coupled(mode.family) {
                    true => solved.modes.get(place)?,
                    false => solved.mode(mode.family, mode.order)?,
                };
                Some(same.extrapolated_hz)
            };
            let frequencies = modes.iter().enumerate().map(frequency);
            Some((frequencies.collect(), tower.structure_mass_kg()))
        })
    };
    let h = LARGER * step(change, value, neighbours);
    let steps = [h, -h, 0.5 * h, -0.5 * h, 0.0];
    let at = steps.map(|step| solve(value + step));
    let [Some(a), Some(b), Some(c), Some(d), Some(e)] = at else {
        let none = modes.iter().map(|_| Err(NoDerivative::OneSided));
        return (none.collect(), f64::NAN);
    };
    let of_mode = |mode: usize| {
        let value = |solved: &Solved| solved.0[mode].ok_or(NoDerivative::OneSided);
        let [a, b, c, d, e] = [value(&a)?, value(&b)?, value(&c)?, value(&d)?, value(&e)?];
        let (whole, half) = ((a - b) / (2.0 * h), (c - d) / h);
        let better = half + (half - whole) / 3.0;
        let rounding = 1e-10 * modes[mode].frequency_hz / h;
        // The slopes of both sides differ by the curvature times the step; at a kink by as much
        // over half the step.
        let [whole_bend, half_bend] = [(a - e) - (e - b), 2.0 * ((c - e) - (e - d))];
        if half_bend.abs() > 0.75 * whole_bend.abs() && half_bend.abs() > 4.0 * rounding * h {
            return Err(NoDerivative::OneSided);
        }
        Ok(Derivative {
            hz_per_unit: better,
            error_hz_per_unit: (better - half).abs().max(rounding),
            mesh_hz_per_unit: better,
        })
    };
    let derivatives = (0..modes.len()).map(of_mode).collect();
    (derivatives, (c.1 - d.1) / h)
}

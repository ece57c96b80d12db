//! The modes of a random turbine: their estimated errors and their true errors.

use towermodes::turbine::{
    Harmonic, Turbine, TurbineError, TurbineMesh, TurbineMode, TurbineModel, TurbineModes,
    TurbinePart,
};

use super::rotors::{RandomTurbine, TurbineClass};
use super::sample::Sample;

/// The polynomial degrees of the reference, on elements of half the length.
const REFERENCE: (usize, usize) = (14, 8);
/// The relative accuracy of frequencies, which eigenvalue counts bound.
const KNOWN: f64 = 1e-9;
/// The highest frequency limit, Hz, and the number of bisections to find the limit.
const MOST_HZ: f64 = 100.0;
const HALVINGS: usize = 30;

/// The modes of a random turbine with their estimated errors and their differences from a
/// reference: elements of half the length with higher degrees.
///
/// Modes are compared in their order; the modes that do not move the hub are compared separately.
///
/// # Errors
/// [`TurbineError`] if its tower is not stable.
pub fn turbine_samples(class: TurbineClass, number: u64) -> Result<Vec<Sample>, TurbineError> {
    let random = class.turbine(number);
    let turbine = random.build()?;
    let mut model = TurbineModel::new(&turbine, &turbine.mesh())?;
    let limit_hz = limit_hz(&mut model, random.modes);
    let modes = turbine.modes(limit_hz, random.speed_rpm)?;
    let truth = reference(&random, limit_hz)?;
    Ok(compared(number, &modes, &truth))
}

/// A frequency limit below which the turbine at rest has this number of modes, Hz.
fn limit_hz(model: &mut TurbineModel, modes: usize) -> f64 {
    let (mut low_hz, mut high_hz) = (0.0, MOST_HZ);
    for _ in 0..HALVINGS {
        let middle_hz = 0.5 * (low_hz + high_hz);
        match model.count(middle_hz, 0.0) > modes {
            true => high_hz = middle_hz,
            false => low_hz = middle_hz,
        }
    }
    high_hz
}

/// The modes on elements of half the length with higher degrees.
fn reference(random: &RandomTurbine, limit_hz: f64) -> Result<TurbineModes, TurbineError> {
    let mut halved = random.clone();
    let borders = &mut halved.machine.blade.borders;
    let middles: Vec<f64> = borders
        .windows(2)
        .map(|ends| 0.5 * (ends[0] + ends[1]))
        .collect();
    borders.extend(middles);
    borders.sort_by(f64::total_cmp);
    let turbine: Turbine = halved.build()?;
    let own = turbine.mesh();
    let mesh = TurbineMesh {
        tower_elements: 2 * own.tower_elements,
        tower_degree: REFERENCE.0,
        blade_degree: REFERENCE.1,
    };
    TurbineModel::new(&turbine, &mesh)?.modes(limit_hz, random.speed_rpm)
}

/// The multiblade harmonic of a mode, if it does not move the hub.
fn wave(mode: &TurbineMode) -> Option<Harmonic> {
    match mode.name.part {
        TurbinePart::Blades(
            _,
            harmonic @ (Harmonic::ForwardOf(_) | Harmonic::BackwardOf(_) | Harmonic::Alternating),
        ) => Some(harmonic),
        _ => None,
    }
}

fn compared(number: u64, modes: &TurbineModes, truth: &TurbineModes) -> Vec<Sample> {
    let mut rest: Vec<&TurbineMode> = truth.modes.iter().collect();
    let all = modes.modes.iter().enumerate();
    let sample = |(index, mode): (usize, &TurbineMode)| {
        let frequency_hz = mode.frequency.frequency_hz;
        let same = rest.iter().position(|other| wave(other) == wave(mode));
        let same = same.map(|place| rest.remove(place).frequency.frequency_hz);
        let difference_hz = same.map(|hz| ((frequency_hz - hz).abs() - KNOWN * hz).max(0.0));
        Sample {
            tower: number,
            mode: index + 1,
            segments: 0,
            frequency_hz,
            claimed_hz: mode.discretization_error_hz.unwrap_or(0.0) + KNOWN * frequency_hz,
            true_hz: difference_hz.unwrap_or(frequency_hz),
            is_warned: !modes.is_complete,
        }
    };
    all.map(sample).collect()
}

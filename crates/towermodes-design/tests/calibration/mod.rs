//! Calibration: twin experiments, a measured turbine, pairing, identifiability, refusals.

mod identifiability;
mod pairing;
mod refusals;
mod swift;
mod symmetry;
mod twins;

use towermodes::{Change, Foundation, Options, Rna, Solver, TowerDescription};
use towermodes_design::calibration::{
    Calibration, CalibrationError, Measured, Prior, Problem, Unknown, calibrate,
};
use towermodes_testing::{parts, tube, with};

/// A tube on springs with an eccentric RNA, so that the two planes differ.
fn tower() -> TowerDescription {
    TowerDescription {
        rna: Rna {
            mass_kg: 350e3,
            center_m: [-0.41, 0.0, 1.97],
            inertia_kg_m2: [4.37e7, 2.353e7, 2.542e7, 0.0, 0.0, 0.0].into(),
        },
        foundation: springs(2e9, 1e11),
        ..tube(&[(0.0, 6.0, 0.027), (87.6, 3.87, 0.019)])
    }
}

fn springs(lateral: f64, rocking: f64) -> Foundation {
    Foundation::Springs(parts::springs(lateral, rocking, 0.0, 1e10, 1e11))
}

fn unknown(base: &TowerDescription, name: &str) -> Unknown {
    Unknown::new(Change::parse(name, base).expect("a change"))
}

fn with_prior(base: &TowerDescription, name: &str, mean: f64, deviation: f64) -> Unknown {
    Unknown {
        prior: Some(Prior { mean, deviation }),
        ..unknown(base, name)
    }
}

fn measured(mode: &str, frequency_hz: f64, deviation_hz: f64) -> Measured {
    Measured::of(mode.parse().expect("a mode"), frequency_hz, deviation_hz)
}

fn options() -> Options {
    with!(Options, segments = Some(20))
}

fn fitted(problem: &Problem) -> Result<Calibration, CalibrationError> {
    calibrate(problem, &mut Solver::new(options()))
}

/// The frequencies of some modes of a tower, Hz.
fn frequencies(description: &TowerDescription, names: &[&str]) -> Vec<f64> {
    let found = Solver::new(options()).sensitivities(description, &[]);
    let modes = found.expect("solved").modes;
    let of = |name: &&str| {
        let name: towermodes::ModeName = name.parse().expect("a mode");
        let is_it = |mode: &&towermodes::ModeFrequency| {
            (mode.family, mode.order) == (name.family, name.order)
        };
        modes.iter().find(is_it).expect("the mode").extrapolated_hz
    };
    names.iter().map(of).collect()
}

fn remarks(result: &Calibration) -> Vec<String> {
    result.remarks().iter().map(ToString::to_string).collect()
}

//! Assignment of the measurements to the modes of the tower.

use towermodes::modes::SharedMotion;
use towermodes::{Mode, ModeName, Options, Solution, Solver, Tower, TowerDescription};
use towermodes_analysis::mac;

use super::error::CalibrationError;
use super::problem::{Measured, MeasuredShape, Problem};

/// Largest number of computed modes.
pub(super) const MOST_MODES: usize = 60;
/// Among the modes whose MAC is above this fraction of the highest MAC, the mode with the nearest
/// frequency is selected.
const NEAR_MAC: f64 = 0.8;
/// The assignment is ambiguous if the distance of another mode from the measured frequency is
/// larger than that of the nearest mode by at most this many standard deviations.
const NEAR_DEVIATIONS: f64 = 2.0;

/// The mode of each measurement.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pairing {
    pub(super) names: Vec<ModeName>,
    pub(super) ambiguities: Vec<Option<Ambiguity>>,
    /// Number of modes that must be computed.
    pub(super) modes: usize,
    /// Whether the modes of the fitted tower are paired in the same way.
    pub(super) is_stable: bool,
    /// Whether the certificate of the tower proves that no mode is missing.
    pub(super) is_certified: bool,
    /// For each name, the share of its type of motion in the energy of the mode.
    pub(super) shares: Vec<f64>,
    /// The names whose type of motion is shared by several modes.
    pub(super) shared: Vec<SharedMotion>,
}

/// Another mode that a measurement may be of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ambiguity {
    /// The frequencies of the two modes differ too little for the measurement.
    Frequency {
        /// The mode that was not selected.
        other: ModeName,
        /// The distance of its frequency from the measured one, Hz.
        distance_hz: f64,
    },
    /// The shapes of the two modes are too similar.
    Shape {
        /// The mode that was not selected.
        other: ModeName,
        /// The MAC of the selected mode.
        mac: f64,
        /// The MAC of the other mode.
        other_mac: f64,
    },
}

impl Ambiguity {
    /// The mode that was not selected.
    pub fn other(&self) -> ModeName {
        match self {
            Self::Frequency { other, .. } | Self::Shape { other, .. } => *other,
        }
    }
}

/// Assigns each measurement to a mode of a tower: by name, otherwise by shape, otherwise by
/// frequency.
pub(super) fn pair(
    problem: &Problem,
    description: &TowerDescription,
    options: &Options,
    solver: &mut Solver,
) -> Result<Pairing, CalibrationError> {
    let tower = Tower::new(description.clone())?;
    check_sensors(problem, &tower)?;
    let options = Options {
        points: 2,
        modes: options.modes.max(problem.measured.len() + 2),
        heights_m: heights(problem),
        ..options.clone()
    };
    let reaches = |solution: &Solution| {
        let highest = solution.modes.last();
        let highest_hz = highest.map_or(0.0, |mode| mode.extrapolated_hz);
        let mut unnamed = problem.measured.iter().filter(|one| one.mode.is_none());
        first_missing(problem, &solution.modes).is_none()
            && unnamed.all(|one| highest_hz >= 1.5 * one.frequency_hz)
    };
    let solution = solver.with(options, |solver| {
        solver.until(MOST_MODES, |solver| solver.solve(&tower), reaches)
    })?;
    if let Some((index, mode)) = first_missing(problem, &solution.modes) {
        return Err(no_mode(index, mode, &solution.modes));
    }
    Ok(Pairing {
        is_certified: solution.certificate.complete,
        ..pairing(problem, &solution.modes)
    })
}

fn check_sensors(problem: &Problem, tower: &Tower) -> Result<(), CalibrationError> {
    let (base_m, top_m) = (tower.base_m(), tower.base_m() + tower.height_m());
    for (index, measured) in problem.measured.iter().enumerate() {
        let heights = measured.shape.iter().flat_map(|shape| &shape.heights_m);
        let outside = heights.copied().find(|z| *z < base_m || *z > top_m);
        if let Some(height_m) = outside {
            return Err(CalibrationError::SensorOutside {
                index,
                height_m,
                base_m,
                top_m,
            });
        }
    }
    Ok(())
}

/// The heights of all sensors, in increasing order.
fn heights(problem: &Problem) -> Vec<f64> {
    let shapes = problem.measured.iter().filter_map(|one| one.shape.as_ref());
    let mut heights: Vec<f64> = shapes.flat_map(|shape| shape.heights_m.clone()).collect();
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    heights
}

fn first_missing(problem: &Problem, modes: &[Mode]) -> Option<(usize, ModeName)> {
    let mut named = problem.measured.iter().enumerate();
    named.find_map(|(index, one)| {
        let name = one.mode?;
        let is_there = modes.iter().any(|mode| mode.name() == name);
        (!is_there).then_some((index, name))
    })
}

fn no_mode(index: usize, mode: ModeName, modes: &[Mode]) -> CalibrationError {
    const LISTED: usize = 8;
    let names = modes
        .iter()
        .take(LISTED)
        .map(|mode| mode.name().to_string());
    CalibrationError::NoMode {
        index,
        mode,
        computed: modes.len(),
        there: names.collect::<Vec<_>>().join(", "),
    }
}

fn pairing(problem: &Problem, modes: &[Mode]) -> Pairing {
    let mut names: Vec<Option<ModeName>> = problem.measured.iter().map(|one| one.mode).collect();
    let mut ambiguities = vec![None; names.len()];
    // Those with a shape first: what they take, a frequency alone cannot be.
    for has_shape in [true, false] {
        for (index, measured) in problem.measured.iter().enumerate() {
            if names[index].is_some() || measured.shape.is_some() != has_shape {
                continue;
            }
            let is_free = |mode: &&Mode| !names.contains(&Some(mode.name()));
            let free: Vec<&Mode> = modes.iter().filter(is_free).collect();
            let found = match &measured.shape {
                Some(shape) => by_shape(shape, measured, &free),
                None => by_frequency(measured, &free),
            };
            if let Some((name, ambiguity)) = found {
                names[index] = Some(name);
                ambiguities[index] = ambiguity;
            }
        }
    }
    let highest = |name: &ModeName| modes.iter().position(|mode| mode.name() == *name);
    let fallback = modes.first().map(Mode::name);
    let names: Vec<ModeName> = names
        .into_iter()
        .filter_map(|name| name.or(fallback))
        .collect();
    let last = names.iter().filter_map(highest).max().unwrap_or(0);
    let share = |name: &ModeName| highest(name).map_or(f64::NAN, |place| modes[place].share());
    let all = modes.iter();
    let all = all.map(|mode| (mode.name(), &mode.shares, mode.extrapolated_hz));
    let shared = names.iter();
    let shared = shared.filter_map(|name| SharedMotion::of(*name, all.clone()));
    Pairing {
        shares: names.iter().map(share).collect(),
        shared: shared.collect(),
        modes: (last + 3).min(modes.len()),
        names,
        ambiguities,
        is_stable: true,
        is_certified: false,
    }
}

/// The mode with the highest MAC; if several have nearly the highest MAC, the one with the nearest
/// frequency.
fn by_shape(
    shape: &MeasuredShape,
    given: &Measured,
    modes: &[&Mode],
) -> Option<(ModeName, Option<Ambiguity>)> {
    let measured: Vec<f64> = shape.displacements.iter().flatten().copied().collect();
    let mac_with = |mode: &Mode| {
        let at = |height: &f64| {
            let there = mode.shape_there.iter().find(|p| p.height_m == *height);
            there.map_or([0.0; 2], |p| [p.translation[0], p.translation[1]])
        };
        let computed: Vec<f64> = shape.heights_m.iter().flat_map(at).collect();
        mac(&measured, &computed, None).unwrap_or(0.0)
    };
    let pairs = modes.iter().map(|mode| (mac_with(mode), *mode));
    let mut all: Vec<(f64, &Mode)> = pairs.collect();
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let (best, _) = *all.first()?;
    let is_near = |(mac, _): &&(f64, &Mode)| *mac > NEAR_MAC * best;
    let near: Vec<&Mode> = all.iter().filter(is_near).map(|(_, mode)| *mode).collect();
    let (name, by_frequency) = by_frequency(given, &near)?;
    let mac_of = |name: ModeName| {
        let mut own = all.iter().filter(|(_, mode)| mode.name() == name);
        own.next().map_or(0.0, |(mac, _)| *mac)
    };
    let ambiguity = by_frequency.map(|ambiguity| Ambiguity::Shape {
        other: ambiguity.other(),
        mac: mac_of(name),
        other_mac: mac_of(ambiguity.other()),
    });
    Some((name, ambiguity))
}

/// The mode with the nearest frequency.
fn by_frequency(measured: &Measured, modes: &[&Mode]) -> Option<(ModeName, Option<Ambiguity>)> {
    let distance = |mode: &Mode| (mode.extrapolated_hz - measured.frequency_hz).abs();
    let mut all: Vec<(f64, ModeName)> = modes.iter().map(|m| (distance(m), m.name())).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (nearest, name) = *all.first()?;
    let near = nearest + NEAR_DEVIATIONS * measured.deviation_hz;
    let second = all.get(1).filter(|(other, _)| *other <= near);
    let ambiguity = second.map(|&(distance_hz, other)| Ambiguity::Frequency { other, distance_hz });
    Some((name, ambiguity))
}

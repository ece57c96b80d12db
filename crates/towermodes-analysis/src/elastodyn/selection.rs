//! Selection of the modes for ElastoDyn: the first two bending modes of each plane.

use thiserror::Error;

use super::shape_samples::ShapeSamples;
use towermodes::modes::Family;
use towermodes::tower::{Plane, Planes};
use towermodes::{Mode, Solution};

/// The default limit of the fraction of torsion in the energy of a bending mode: towers in
/// ElastoDyn have no torsion.
pub const DEFAULT_TORSION_LIMIT: f64 = 0.5;
/// Number of heights at which shapes are sampled for a fit: many more than a polynomial of degree 6
/// needs.
const SAMPLES: usize = 201;

/// The bending modes for ElastoDyn.
#[derive(Debug, Clone, PartialEq)]
pub struct BendingModes<'a> {
    /// The first and second mode of each plane.
    pub modes: Planes<[&'a Mode; 2]>,
    /// The bending modes that were skipped because of their torsion, by frequency.
    pub passed_over: Vec<PassedOver>,
}

/// A mode that was skipped.
#[derive(Debug, Clone, PartialEq)]
pub struct PassedOver {
    /// Its number in the list, from 1.
    pub number: usize,
    /// Its name: "2nd fore-aft bending".
    pub label: String,
    /// Its frequency, Hz.
    pub frequency_hz: f64,
    /// The plane in which it bends most.
    pub plane: Plane,
    /// The fraction of its energy in torsion.
    pub torsion_share: f64,
}

/// Why the modes for ElastoDyn cannot be selected.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SelectionError {
    /// The solution has too few bending modes.
    #[error(
        "ElastoDyn needs two {} modes, but only {found} of the {} computed modes can be used{}; request {ask_for} modes",
        plane_name(*.plane), .solved, and_passed_over(*.passed_over)
    )]
    TooFewModes {
        /// The plane.
        plane: Plane,
        /// The number of its bending modes in the solution.
        found: usize,
        /// The number of bending modes skipped because of their torsion.
        passed_over: usize,
        /// The number of modes in the solution.
        solved: usize,
        /// The number of modes to request.
        ask_for: usize,
    },
    /// The limit of the torsion fraction is not between 0 and 1.
    #[error("the limit of the torsion fraction is {limit}, but it must be 0 to 1")]
    Limit {
        /// The limit.
        limit: f64,
    },
}

/// Selects the first and second bending mode of each plane.
///
/// A bending mode of a plane is a mode of the bending type in this plane. Modes with a larger
/// fraction of their energy in torsion than `torsion_limit` are skipped. Rigid-body modes of a
/// floating platform do not count.
///
/// # Errors
/// [`SelectionError`]: too few bending modes, or a limit that is not 0 to 1.
pub fn select_bending_modes(
    solution: &Solution,
    torsion_limit: f64,
) -> Result<BendingModes<'_>, SelectionError> {
    if !(0.0..=1.0).contains(&torsion_limit) {
        let limit = torsion_limit;
        return Err(SelectionError::Limit { limit });
    }
    let (fore_aft, mut passed_over) = first_two(solution, Plane::ForeAft, torsion_limit)?;
    let (side_side, others) = first_two(solution, Plane::SideSide, torsion_limit)?;
    passed_over.extend(others);
    passed_over.sort_by_key(|mode| mode.number);
    let modes = Planes {
        fore_aft,
        side_side,
    };
    Ok(BendingModes { modes, passed_over })
}

/// The first two modes of a plane, and the modes below the second that were skipped.
fn first_two(
    solution: &Solution,
    plane: Plane,
    torsion_limit: f64,
) -> Result<([&Mode; 2], Vec<PassedOver>), SelectionError> {
    let mut passed_over = Vec::new();
    let mut taken = Vec::new();
    let bending = solution.modes.iter();
    for mode in bending.filter(|mode| plane_of(mode) == Some(plane)) {
        if mode.energy.mean().torsion > torsion_limit {
            passed_over.push(left_out(mode, plane));
            continue;
        }
        taken.push(mode);
        if let [first, second] = taken[..] {
            return Ok(([first, second], passed_over));
        }
    }
    let solved = solution.modes.len();
    Err(SelectionError::TooFewModes {
        plane,
        found: taken.len(),
        passed_over: passed_over.len(),
        solved,
        // 12: two modes in each plane, torsion, axial motion, and six rigid-body modes of a
        // floating platform.
        ask_for: (2 * solved).max(12),
    })
}

/// The heights at which shapes are to be sampled for a fit, for
/// [`Options::heights_m`](towermodes::Options::heights_m): from the base to the top of the flexible
/// tower (m), both exactly.
pub fn sample_heights_m(base_m: f64, top_m: f64) -> Vec<f64> {
    let height = |k: usize| {
        let s = k as f64 / (SAMPLES - 1) as f64;
        base_m * (1.0 - s) + top_m * s
    };
    (0..SAMPLES).map(height).collect()
}

impl BendingModes<'_> {
    /// The samples of one of the modes (0 or 1) of a plane at the heights of
    /// [`Options::heights_m`](towermodes::Options::heights_m), which must go from the base to the
    /// top of the flexible tower.
    pub fn samples(&self, plane: Plane, mode: usize) -> ShapeSamples {
        let modes = self.modes.of(plane);
        ShapeSamples::of(&modes[mode.min(1)].shape_there, plane)
    }
}

/// The plane of a bending mode.
fn plane_of(mode: &Mode) -> Option<Plane> {
    match mode.family {
        Family::ForeAft => Some(Plane::ForeAft),
        Family::SideSide => Some(Plane::SideSide),
        _ => None,
    }
}

fn left_out(mode: &Mode, plane: Plane) -> PassedOver {
    PassedOver {
        number: mode.number,
        label: mode.label(),
        frequency_hz: mode.frequency_hz,
        plane,
        torsion_share: mode.energy.mean().torsion,
    }
}

fn plane_name(plane: Plane) -> &'static str {
    match plane {
        Plane::ForeAft => Family::ForeAft.noun(),
        Plane::SideSide => Family::SideSide.noun(),
    }
}

fn and_passed_over(count: usize) -> String {
    match count {
        0 => String::new(),
        _ => format!(" ({count} more have too much torsion)"),
    }
}

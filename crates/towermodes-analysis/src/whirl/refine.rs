//! Rotor speeds added where modes cannot be followed in one step.

use crate::assignment::Assignment;

use super::follow::{is_clear, is_of_pair, macs};
use super::solved::{Solved, SolvedSpeed};

/// A step is divided down to this fraction of the mean step: curves that exchange their shapes
/// within a smaller step count as crossing.
const FINEST: f64 = 1.0 / 32.0;
/// Largest number of divisions of a step.
const ROUNDS: usize = 8;

/// Solves at rotor speeds, and at speeds between them if the modes at neighbouring speeds are
/// ambiguous or exchange their order, at most `most_added`. Only modes up to `shown_hz` are
/// considered.
pub(super) fn solved_speeds<S: Solved, E>(
    speeds_rpm: &[f64],
    shown_hz: f64,
    most_added: usize,
    mut solve: impl FnMut(f64, Option<&S>) -> Result<S, E>,
) -> Result<Vec<SolvedSpeed<S>>, E> {
    let mut speeds: Vec<SolvedSpeed<S>> = Vec::new();
    for &rotor_speed_rpm in speeds_rpm {
        let last = speeds.last().map(|speed| &speed.modes);
        let modes = solve(rotor_speed_rpm, last)?;
        speeds.push(SolvedSpeed {
            rotor_speed_rpm,
            is_added: false,
            modes,
        });
    }
    let finest_rpm = finest_rpm(speeds_rpm);
    let mut room = most_added;
    // Intervals between neighbours that need no further look, by their lower end.
    let mut is_settled = vec![false; speeds.len()];
    for _ in 0..ROUNDS {
        let mut divided = Vec::with_capacity(speeds.len());
        let mut settled = Vec::with_capacity(speeds.len());
        let mut rest = speeds.into_iter().zip(is_settled).peekable();
        while let Some((low, low_is_settled)) = rest.next() {
            let split = match rest.peek() {
                Some((high, _)) if !low_is_settled && room > 0 => {
                    division_rpm(&low, high, shown_hz, finest_rpm)
                }
                _ => None,
            };
            let added = split.map(|rotor_speed_rpm| {
                let modes = solve(rotor_speed_rpm, Some(&low.modes))?;
                let is_added = true;
                Ok(SolvedSpeed {
                    rotor_speed_rpm,
                    is_added,
                    modes,
                })
            });
            let added = added.transpose()?;
            room -= usize::from(added.is_some());
            settled.push(added.is_none());
            divided.push(low);
            if let Some(added) = added {
                settled.push(false);
                divided.push(added);
            }
        }
        (speeds, is_settled) = (divided, settled);
        if room == 0 || is_settled.iter().all(|is| *is) {
            break;
        }
    }
    Ok(speeds)
}

/// The shortest step that is considered, rpm.
fn finest_rpm(speeds_rpm: &[f64]) -> f64 {
    match speeds_rpm {
        [first, .., last] => FINEST * (last - first) / (speeds_rpm.len() - 1) as f64,
        _ => f64::INFINITY,
    }
}

/// The speed at which a step is divided: the middle if modes are ambiguous; if modes change their
/// order, the speed where two frequencies are expected to be equal.
fn division_rpm<S: Solved>(
    low: &SolvedSpeed<S>,
    high: &SolvedSpeed<S>,
    shown_hz: f64,
    finest_rpm: f64,
) -> Option<f64> {
    let width = high.rotor_speed_rpm - low.rotor_speed_rpm;
    if width <= 1.001 * finest_rpm {
        return None;
    }
    let (from, to) = (&low.modes, &high.modes);
    // A missing mode cannot be followed.
    if !(from.is_complete() && to.is_complete()) {
        return None;
    }
    let rows: Vec<(&S, usize)> = (0..from.count()).map(|mode| (from, mode)).collect();
    let assignment = Assignment::greedy(macs(&rows, to), |_| true);
    let is_shown = |modes: &S, mode: usize| modes.frequency_hz(mode) <= shown_hz;
    let next: Vec<Option<usize>> = (0..from.count())
        .map(|row| assignment.found(row).ok())
        .collect();
    // The shapes of a pair are any two of its plane: they cannot be clear.
    let is_mixed = |row: usize| {
        is_of_pair(from, row) || next[row].is_some_and(|column| is_of_pair(to, column))
    };
    let is_followed =
        |row: usize| is_clear(&assignment, row) || is_mixed(row) || !is_shown(from, row);
    let is_reached = |column: usize| next.contains(&Some(column)) || !is_shown(to, column);
    let all_clear = (0..from.count()).all(is_followed) && (0..to.count()).all(is_reached);
    if !all_clear {
        return Some(low.rotor_speed_rpm + 0.5 * width);
    }
    let share = swap(from, to, &next, shown_hz, finest_rpm / width)?;
    // A round number of rpm, as the resolution allows.
    let digit = 10.0_f64.powf((0.1 * finest_rpm).log10().floor());
    let rpm = ((low.rotor_speed_rpm + share * width) / digit).round() * digit;
    (low.rotor_speed_rpm < rpm && rpm < high.rotor_speed_rpm).then_some(rpm)
}

/// The fraction of a step after which the first two modes that exchange their order are expected to
/// have equal frequencies; none if all such exchanges are within `finest` of an end.
fn swap<S: Solved>(
    from: &S,
    to: &S,
    next: &[Option<usize>],
    shown_hz: f64,
    finest: f64,
) -> Option<f64> {
    let ends_hz = |row: usize| {
        let start_hz = from.frequency_hz(row);
        let end_hz = to.frequency_hz(next[row]?);
        (start_hz <= shown_hz).then_some([start_hz, end_hz])
    };
    let lines: Vec<[f64; 2]> = (0..from.count()).filter_map(ends_hz).collect();
    let pairs = (0..lines.len()).flat_map(|a| (0..a).map(move |b| (a, b)));
    let shares = pairs.filter_map(|(a, b)| {
        let [start, end] = [0, 1].map(|k| lines[a][k] - lines[b][k]);
        (start * end < 0.0).then(|| start / (start - end))
    });
    let inside = shares.filter(|share| (finest..=1.0 - finest).contains(share));
    inside.min_by(f64::total_cmp)
}

//! Crossings and veerings of curves.

use super::follow::Track;
use super::solved::{Solved, SolvedSpeed};

/// The shapes next to a veering are compared where the distance of the curves is this many times
/// the smallest distance.
const APART: f64 = 2.0;
/// Two curves veer if their modes have exchanged at least this share of their shapes.
const EXCHANGED: f64 = 0.5;

/// A crossing or veering of two curves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting {
    /// The kind of meeting.
    pub kind: MeetingKind,
    /// The indices of the curves, from 0.
    pub curves: [usize; 2],
    /// The rotor speed where they are closest, rpm.
    pub rotor_speed_rpm: f64,
    /// The mean of their frequencies at this speed, Hz.
    pub frequency_hz: f64,
    /// Their smallest distance, Hz: 0 for curves that cross.
    pub least_distance_hz: f64,
}

/// The kind of meeting of two curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MeetingKind {
    /// They exchange their order, and each mode keeps its shape: they are hardly coupled.
    Crossing,
    /// They approach each other, diverge again, and exchange their shapes: the modes are coupled.
    Veering,
}

impl MeetingKind {
    /// Its name: `crossing`, `veering`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Crossing => "crossing",
            Self::Veering => "veering",
        }
    }
}

/// A speed at which two tracks are both found.
#[derive(Debug, Clone, Copy)]
struct Beside {
    speed: usize,
    rpm: f64,
    modes: [usize; 2],
    mean_hz: f64,
    /// The frequency of the first minus that of the second, Hz.
    distance_hz: f64,
}

/// All crossings and veerings below a frequency, by rotor speed. Tracks belong to the curves.
pub(super) fn meetings<S: Solved>(
    speeds: &[SolvedSpeed<S>],
    tracks: &[Track],
    shown_hz: f64,
) -> Vec<Meeting> {
    let pairs = (0..tracks.len()).flat_map(|a| (a + 1..tracks.len()).map(move |b| [a, b]));
    let mut all: Vec<Meeting> = pairs
        .flat_map(|curves| {
            let both = beside(speeds, curves.map(|curve| &tracks[curve]));
            let crossings = crossings(curves, &both);
            let veerings = veerings(curves, &both, speeds);
            [crossings, veerings].concat()
        })
        .filter(|meeting| meeting.frequency_hz <= shown_hz)
        .collect();
    all.sort_by(|a, b| a.rotor_speed_rpm.total_cmp(&b.rotor_speed_rpm));
    all
}

/// The speeds at which two tracks are both found.
fn beside<S: Solved>(speeds: &[SolvedSpeed<S>], [a, b]: [&Track; 2]) -> Vec<Beside> {
    let end = |track: &Track| track.first + track.modes.len();
    let both = a.first.max(b.first)..end(a).min(end(b));
    let at = |speed: usize| {
        let solved = &speeds[speed];
        let modes = [a, b].map(|track| track.modes[speed - track.first]);
        let [a_hz, b_hz] = modes.map(|mode| solved.modes.frequency_hz(mode));
        Beside {
            speed,
            rpm: solved.rotor_speed_rpm,
            modes,
            mean_hz: 0.5 * (a_hz + b_hz),
            distance_hz: a_hz - b_hz,
        }
    };
    both.map(at).collect()
}

/// Speeds where the order changes, by linear interpolation.
fn crossings(curves: [usize; 2], both: &[Beside]) -> Vec<Meeting> {
    let apart: Vec<&Beside> = both.iter().filter(|at| at.distance_hz != 0.0).collect();
    let steps = apart.windows(2);
    let swaps = steps.filter(|step| step[0].distance_hz * step[1].distance_hz < 0.0);
    let crossing = |step: &[&Beside]| {
        let [low, high] = [step[0], step[1]];
        let share = low.distance_hz / (low.distance_hz - high.distance_hz);
        let between = |from: f64, to: f64| from + share * (to - from);
        Meeting {
            kind: MeetingKind::Crossing,
            curves,
            rotor_speed_rpm: between(low.rpm, high.rpm),
            frequency_hz: between(low.mean_hz, high.mean_hz),
            least_distance_hz: 0.0,
        }
    };
    swaps.map(crossing).collect()
}

/// Speeds at which two curves are closest without a change of their order, if they exchange their
/// shapes.
fn veerings<S: Solved>(
    curves: [usize; 2],
    both: &[Beside],
    speeds: &[SolvedSpeed<S>],
) -> Vec<Meeting> {
    let far = |index: usize| both[index].distance_hz.abs();
    let mut found = Vec::new();
    let mut next = 1;
    for index in 1..both.len().saturating_sub(1) {
        let is_least = far(index) <= far(index - 1) && far(index) < far(index + 1);
        if index < next || !is_least {
            continue;
        }
        let is_apart = |at: &usize| far(*at) >= APART * far(index);
        let before = (0..index).rev().find(is_apart).unwrap_or(0);
        let last = both.len() - 1;
        let after = (index + 1..=last).find(is_apart).unwrap_or(last);
        let region = &both[before..=after];
        let same = |at: &Beside| at.distance_hz * both[index].distance_hz > 0.0;
        let is_lowest = (before..=after).all(|at| far(index) <= far(at));
        if !is_lowest || !region.iter().all(same) {
            continue;
        }
        if exchanged(&both[before], &both[after], speeds) >= EXCHANGED {
            found.push(closest(curves, &both[index - 1..=index + 1]));
            next = after;
        }
    }
    found
}

/// The mean share of each mode's shape after the veering in the other mode's shape before it.
fn exchanged<S: Solved>(before: &Beside, after: &Beside, speeds: &[SolvedSpeed<S>]) -> f64 {
    let (from, to) = (&speeds[before.speed].modes, &speeds[after.speed].modes);
    let [a, b] = before.modes;
    let [a_after, b_after] = after.modes;
    0.5 * (from.mac(a, to, b_after) + from.mac(b, to, a_after))
}

/// The smallest distance between three speeds: for two coupled modes its square is quadratic in the
/// speed (von Neumann & Wigner 1929).
fn closest(curves: [usize; 2], three: &[Beside]) -> Meeting {
    let [low, middle, high] = [three[0], three[1], three[2]];
    let square = |at: Beside| at.distance_hz * at.distance_hz;
    let slope = |a: Beside, b: Beside| (square(b) - square(a)) / (b.rpm - a.rpm);
    let (first, second) = (slope(low, middle), slope(middle, high));
    let bend = (second - first) / (high.rpm - low.rpm);
    // The slope of the parabola in the middle, and where it vanishes.
    let slope_there = first + bend * (middle.rpm - low.rpm);
    let step = -slope_there / (2.0 * bend);
    let is_inside = step.is_finite() && (low.rpm..=high.rpm).contains(&(middle.rpm + step));
    let step = if is_inside { step } else { 0.0 };
    let least = square(middle) + step * (slope_there + bend * step);
    let toward = if step < 0.0 { low } else { high };
    let share = step / (toward.rpm - middle.rpm);
    Meeting {
        kind: MeetingKind::Veering,
        curves,
        rotor_speed_rpm: middle.rpm + step,
        frequency_hz: middle.mean_hz + share * (toward.mean_hz - middle.mean_hz),
        least_distance_hz: least.max(0.0).sqrt(),
    }
}

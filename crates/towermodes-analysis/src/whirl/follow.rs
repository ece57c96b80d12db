//! Modes followed from speed to speed by their shapes.

use crate::assignment::Assignment;
use crate::resonance::LineEnd;

use super::solved::{Solved, SolvedSpeed};

/// The continuation of a mode is certain if its modal assurance criterion exceeds that with any
/// other mode by this amount.
const CLEAR: f64 = 0.4;

/// Two modes are equally possible continuations if their modal assurance criteria differ by less
/// than this.
const OPEN: f64 = 0.2;

/// Modes whose frequencies are closer than this are a pair; a computation may give any combination
/// of their shapes.
const REPEATED: f64 = 1e-9;

/// A mode that is followed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Track {
    /// The index of the first speed at which it is found.
    pub(super) first: usize,
    /// Its index among the modes at this speed and the next ones.
    pub(super) modes: Vec<usize>,
    /// The end, if it was lost.
    pub(super) lost: Option<LineEnd>,
    /// Speed and mode at the last speed at which the continuation was certain: the reference shape.
    reference: (usize, usize),
}

impl Track {
    fn begin(speed: usize, mode: usize) -> Self {
        Self {
            first: speed,
            modes: vec![mode],
            lost: None,
            reference: (speed, mode),
        }
    }

    /// Speed and mode at the last speed at which it was found.
    fn last(&self) -> (usize, usize) {
        let last = self.modes.len() - 1;
        (self.first + last, self.modes[last])
    }

    /// Its frequency at this speed, Hz.
    fn last_hz<S: Solved>(&self, speeds: &[SolvedSpeed<S>]) -> f64 {
        let (speed, mode) = self.last();
        speeds[speed].modes.frequency_hz(mode)
    }
}

/// Follows all modes at the solved speeds; the track of a mode that continues no other begins at
/// this speed.
pub(super) fn tracks<S: Solved>(speeds: &[SolvedSpeed<S>]) -> Vec<Track> {
    let mut tracks: Vec<Track> = Vec::new();
    for (speed, solved) in speeds.iter().enumerate() {
        let assignment = continued(&tracks, speeds, speed);
        let mut is_new = vec![true; solved.modes.count()];
        for (index, track) in tracks.iter_mut().enumerate() {
            if track.lost.is_some() {
                continue;
            }
            match assignment.found(index) {
                Ok(mode) => {
                    is_new[mode] = false;
                    track.modes.push(mode);
                    if is_clear(&assignment, index) {
                        track.reference = (speed, mode);
                    }
                }
                Err(mac) => {
                    let rotor_speed_rpm = solved.rotor_speed_rpm;
                    track.lost = Some(LineEnd {
                        rotor_speed_rpm,
                        mac,
                    });
                }
            }
        }
        let new = (0..is_new.len()).filter(|mode| is_new[*mode]);
        tracks.extend(new.map(|mode| Track::begin(speed, mode)));
    }
    tracks
}

/// The assignment of the modes at a speed to the tracks.
///
/// A track is compared by its reference shape, at the last speed at which the continuation was
/// certain. Thus at a veering within one step the track keeps its shape. However, two modes that
/// are close at standstill, tilt and yaw, become whirls permanently within one step, and the whirl
/// shapes are similar to neither. Therefore a track whose continuation is uncertain with the
/// reference shape, but certain with the shape at the last speed, is compared by the latter. Two
/// tracks that are uncertain between the same two modes keep their order.
fn continued<S: Solved>(tracks: &[Track], speeds: &[SolvedSpeed<S>], speed: usize) -> Assignment {
    let modes = &speeds[speed].modes;
    let is_followed = |track: usize| tracks[track].lost.is_none();
    let macs_from = |places: Vec<(usize, usize)>| {
        let rows: Vec<(&S, usize)> = places
            .into_iter()
            .map(|(speed, mode)| (&speeds[speed].modes, mode))
            .collect();
        macs(&rows, modes)
    };
    let mut by_reference = macs_from(tracks.iter().map(|track| track.reference).collect());
    let by_last = macs_from(tracks.iter().map(Track::last).collect());
    let old = Assignment::greedy(by_reference.clone(), is_followed);
    let near = Assignment::greedy(by_last.clone(), is_followed);
    for (row, last) in by_last.into_iter().enumerate() {
        if !is_clear(&old, row) && is_clear(&near, row) {
            by_reference[row] = last;
        }
    }
    let mut assignment = Assignment::greedy(by_reference, is_followed);
    for a in 0..tracks.len() {
        for b in 0..tracks.len() {
            let last_hz = |track: usize| tracks[track].last_hz(speeds);
            let are_followed = is_followed(a) && is_followed(b);
            if a != b && are_followed && last_hz(a) < last_hz(b) {
                keep_order(&mut assignment, [a, b]);
            }
        }
    }
    assignment
}

/// Assigns two tracks, the lower one first, to two modes in this order if both tracks are uncertain
/// between these modes.
fn keep_order(assignment: &mut Assignment, [lower, upper]: [usize; 2]) {
    let (Ok(of_lower), Ok(of_upper)) = (assignment.found(lower), assignment.found(upper)) else {
        return;
    };
    let is_open = |row: usize| assignment.lead_over(row, of_lower, of_upper).abs() < OPEN;
    if of_lower > of_upper && is_open(lower) && is_open(upper) {
        assignment.exchange(lower, upper);
    }
}

/// Whether the continuation of a mode is certain.
pub(super) fn is_clear(assignment: &Assignment, row: usize) -> bool {
    let found = assignment.found(row);
    found.is_ok_and(|column| assignment.lead(row, column) >= CLEAR)
}

/// The modal assurance criteria of modes with the modes at a speed; for repeated pairs those of the
/// plane that both modes span.
pub(super) fn macs<S: Solved>(rows: &[(&S, usize)], modes: &S) -> Vec<Vec<f64>> {
    let all = 0..modes.count();
    let of_row = |(from, mode): &(&S, usize)| {
        let twins = (0..from.count()).filter(|other| are_pair(*from, *other, *mode));
        let twins: Vec<usize> = twins.collect();
        let of_twins = |i: usize| {
            twins
                .iter()
                .map(|own| from.mac(*own, modes, i))
                .sum::<f64>()
        };
        let single: Vec<f64> = all.clone().map(of_twins).collect();
        let of_plane = |i: usize| {
            let own = all.clone().filter(|other| are_pair(modes, *other, i));
            own.map(|other| single[other]).sum::<f64>().min(1.0)
        };
        all.clone().map(of_plane).collect()
    };
    rows.iter().map(of_row).collect()
}

/// Whether a mode is one of a repeated pair.
pub(super) fn is_of_pair<S: Solved>(modes: &S, mode: usize) -> bool {
    let mut others = (0..modes.count()).filter(|other| *other != mode);
    others.any(|other| are_pair(modes, other, mode))
}

fn are_pair<S: Solved>(modes: &S, a: usize, b: usize) -> bool {
    let [a_hz, b_hz] = [a, b].map(|mode| modes.frequency_hz(mode));
    (a_hz - b_hz).abs() <= REPEATED * a_hz.max(b_hz)
}

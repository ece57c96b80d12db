//! Modes followed from speed to speed by their shapes.

use crate::assignment::Assignment;
use crate::resonance::LineEnd;

use super::solved::{Solved, SolvedSpeed};

/// A mode is continued without doubt if its modal assurance criterion with its continuation is so
/// much larger than with any other mode.
const CLEAR: f64 = 0.4;

/// Frequencies closer than this are a pair whose shapes any computation may mix.
const REPEATED: f64 = 1e-9;

/// A mode followed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Track {
    /// The index of the first speed at which it is seen.
    pub(super) first: usize,
    /// Its index among the modes at this speed and the next ones.
    pub(super) modes: Vec<usize>,
    /// The end, if it was lost.
    pub(super) lost: Option<LineEnd>,
    /// Speed and mode at the last speed where it was continued without doubt: its shape.
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
}

/// Follows all modes at solved speeds; modes that continue no other begin where they are first
/// seen.
pub(super) fn tracks<S: Solved>(speeds: &[SolvedSpeed<S>]) -> Vec<Track> {
    let mut tracks: Vec<Track> = Vec::new();
    for (speed, solved) in speeds.iter().enumerate() {
        let rows: Vec<(&S, usize)> = tracks
            .iter()
            .map(|track| (&speeds[track.reference.0].modes, track.reference.1))
            .collect();
        let macs = macs(&rows, &solved.modes);
        let assignment = Assignment::greedy(macs, |track| tracks[track].lost.is_none());
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

/// Whether a mode is continued without doubt.
pub(super) fn is_clear(assignment: &Assignment, row: usize) -> bool {
    let found = assignment.found(row);
    found.is_ok_and(|column| assignment.lead(row, column) >= CLEAR)
}

/// The modal assurance criteria of modes with those at a speed; those of a repeated pair there have
/// that with the plane that both span.
pub(super) fn macs<S: Solved>(rows: &[(&S, usize)], modes: &S) -> Vec<Vec<f64>> {
    let all = 0..modes.count();
    let of_row = |(from, mode): &(&S, usize)| {
        let single: Vec<f64> = all.clone().map(|i| from.mac(*mode, modes, i)).collect();
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

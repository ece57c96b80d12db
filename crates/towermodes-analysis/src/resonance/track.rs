//! Blade modes followed from speed to speed by the modal assurance criterion (MAC) of their shapes.

use crate::assignment::Assignment;
use crate::mac::mac;
use towermodes::BladeFamily;

/// Modes whose frequencies are closer than this are a pair; a computation may give any combination
/// of their shapes.
const REPEATED: f64 = 1e-6;

/// Two modes whose MACs with a followed mode differ by less than this are ambiguous: the modes
/// veer, or the computation mixed a repeated pair.
const AMBIGUOUS: f64 = 0.4;

/// A mode of a blade at a speed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Seen {
    /// Frequency, Hz.
    pub(super) frequency_hz: f64,
    pub(super) family: BladeFamily,
    /// Motions at the samples, each multiplied by the square root of its mass.
    pub(super) shape: Vec<f64>,
    /// Error of the frequency, Hz; none if it is not known at this speed.
    pub(super) error_hz: Option<f64>,
}

/// A mode that is followed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Followed {
    /// Its family at standstill, or at the first speed at which it is not one of a pair.
    pub(super) family: Option<BladeFamily>,
    /// Frequency at each speed so far, Hz.
    pub(super) frequencies_hz: Vec<f64>,
    /// The largest known error, Hz.
    pub(super) error_hz: f64,
    /// The MAC of the mode assigned to it at the first speed at which it is not found; its line
    /// ends before that speed.
    pub(super) lost: Option<f64>,
    /// Its shape at the last speed at which the assignment was unambiguous.
    shape: Vec<f64>,
}

impl Followed {
    fn new(seen: &Seen) -> Self {
        Self {
            family: None,
            frequencies_hz: Vec::new(),
            error_hz: 0.0,
            lost: None,
            shape: seen.shape.clone(),
        }
    }

    fn see(&mut self, seen: &Seen) {
        self.frequencies_hz.push(seen.frequency_hz);
        self.error_hz = self.error_hz.max(seen.error_hz.unwrap_or(0.0));
    }
}

/// Modes that are followed, by frequency at standstill.
#[derive(Debug, Clone, Default)]
pub(super) struct Tracks {
    pub(super) modes: Vec<Followed>,
}

impl Tracks {
    /// Begins with the modes at standstill.
    pub(super) fn begin(seen: &[Seen]) -> Self {
        let mut tracks = Self {
            modes: seen.iter().map(Followed::new).collect(),
        };
        let assignment = Assignment::in_order(tracks.macs(seen));
        tracks.take(seen, &assignment);
        tracks
    }

    /// Whether one of the first modes, if it has been followed so far, is missing in the
    /// assignment.
    pub(super) fn has_lost(&self, assignment: &Assignment, first: usize) -> bool {
        let mut modes = self.modes.iter().take(first).enumerate();
        modes.any(|(index, mode)| mode.lost.is_none() && assignment.found(index).is_err())
    }

    /// The assignment of the modes at this speed to the followed modes.
    pub(super) fn assign(&self, seen: &[Seen]) -> Assignment {
        let is_followed = |mode: usize| self.modes[mode].lost.is_none();
        Assignment::greedy(self.macs(seen), is_followed)
    }

    /// Continues with the assigned modes; lines without an assigned mode end before this speed.
    pub(super) fn take(&mut self, seen: &[Seen], assignment: &Assignment) {
        for (index, mode) in self.modes.iter_mut().enumerate() {
            if mode.lost.is_some() {
                continue;
            }
            let other = match assignment.found(index) {
                Ok(other) => other,
                Err(mac) => {
                    mode.lost = Some(mac);
                    continue;
                }
            };
            let found = &seen[other];
            mode.see(found);
            if is_repeated(seen, other) {
                continue;
            }
            let is_new = mode.family.is_none();
            mode.family.get_or_insert(found.family);
            // An ambiguous shape could be followed to either mode.
            if is_new || assignment.lead(index, other) >= AMBIGUOUS {
                mode.shape.clone_from(&found.shape);
            }
        }
    }

    /// The MAC of each followed mode with each mode at this speed. For the modes of a repeated pair
    /// it is the MAC with the plane that both span.
    fn macs(&self, seen: &[Seen]) -> Vec<Vec<f64>> {
        let rows = self.modes.iter().map(|mode| {
            let single = seen.iter().map(|s| mac(&mode.shape, &s.shape, None));
            let single: Vec<f64> = single.map(|mac| mac.unwrap_or(0.0)).collect();
            let of_plane = |i: usize| {
                let all = seen.iter().zip(&single);
                let own = all.filter(|(other, _)| repeats(other, &seen[i]));
                own.map(|(_, mac)| mac).sum::<f64>().min(1.0)
            };
            (0..seen.len()).map(of_plane).collect()
        });
        rows.collect()
    }
}

fn repeats(a: &Seen, b: &Seen) -> bool {
    (a.frequency_hz - b.frequency_hz).abs() <= REPEATED * a.frequency_hz.max(b.frequency_hz)
}

fn is_repeated(seen: &[Seen], index: usize) -> bool {
    let others = seen.iter().enumerate().filter(|(i, _)| *i != index);
    others
        .into_iter()
        .any(|(_, other)| repeats(other, &seen[index]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(frequency_hz: f64, shape: [f64; 3]) -> Seen {
        Seen {
            frequency_hz,
            family: BladeFamily::Flap,
            shape: shape.to_vec(),
            error_hz: None,
        }
    }

    fn turned(angle: f64) -> [[f64; 3]; 2] {
        let (sin, cos) = angle.sin_cos();
        [[cos, sin, 0.0], [-sin, cos, 0.0]]
    }

    /// Follows two modes, 0.1 Hz apart, over speeds at which their shapes are rotated into each
    /// other by these angles.
    fn followed(angles: &[f64]) -> Vec<Vec<f64>> {
        let at = |angle: f64| {
            let [first, second] = turned(angle);
            [seen(1.0, first), seen(1.1, second)]
        };
        let mut tracks = Tracks::begin(&at(0.0));
        for angle in angles {
            let seen = at(*angle);
            let assignment = tracks.assign(&seen);
            tracks.take(&seen, &assignment);
        }
        let modes = tracks.modes.into_iter();
        modes.map(|mode| mode.frequencies_hz).collect()
    }

    /// Large steps through a veering: at 40 degrees (MACs 0.59 and 0.41) the assignment is
    /// ambiguous and the reference shapes are kept, so at 80 degrees each mode belongs to the other
    /// line.
    #[test]
    fn modes_go_through_a_veering() {
        let angles = [40.0_f64, 80.0].map(f64::to_radians);
        let expected = [vec![1.0, 1.0, 1.1], vec![1.1, 1.1, 1.0]];
        assert_eq!(followed(&angles), expected);
    }

    /// A shape that changes permanently but slowly belongs to one line.
    #[test]
    fn slow_changes_are_followed() {
        let angles: Vec<f64> = (1..=9).map(|k| f64::from(10 * k).to_radians()).collect();
        assert_eq!(followed(&angles), [[1.0; 10], [1.1; 10]]);
    }

    /// A computation may give any combination of a pair of modes; the plane that both span remains
    /// the same.
    #[test]
    fn pairs_may_be_mixed() {
        let [first, second] = turned(0.0);
        let mut tracks = Tracks::begin(&[seen(1.0, first), seen(1.1, second)]);
        let [first, second] = turned(0.8);
        let pair = [seen(1.05, first), seen(1.05, second)];
        let assignment = tracks.assign(&pair);
        assert!(!tracks.has_lost(&assignment, 2));
        tracks.take(&pair, &assignment);
        let [first, second] = turned(0.0);
        let apart = [seen(1.1, second), seen(1.2, first)];
        let assignment = tracks.assign(&apart);
        tracks.take(&apart, &assignment);
        let frequencies: Vec<_> = tracks.modes.iter().map(|m| &m.frequencies_hz[..]).collect();
        assert_eq!(frequencies, [[1.0, 1.05, 1.2], [1.1, 1.05, 1.1]]);
    }

    #[test]
    fn a_mode_that_is_not_seen_is_lost() {
        let [first, second] = turned(0.0);
        let mut tracks = Tracks::begin(&[seen(1.0, first), seen(1.1, second)]);
        let others = [seen(1.0, first), seen(1.05, [0.0, 0.0, 1.0])];
        let assignment = tracks.assign(&others);
        assert!(!tracks.has_lost(&assignment, 1));
        assert!(tracks.has_lost(&assignment, 2));
        // It ends before that speed, and does not come back.
        tracks.take(&others, &assignment);
        assert_eq!(tracks.modes[1].lost, Some(0.0));
        let again = [seen(1.2, first), seen(1.3, second)];
        let assignment = tracks.assign(&again);
        assert!(!tracks.has_lost(&assignment, 2));
        tracks.take(&again, &assignment);
        assert_eq!(tracks.modes[0].frequencies_hz, [1.0, 1.0, 1.2]);
        assert_eq!(tracks.modes[1].frequencies_hz, [1.1]);
    }

    /// Fewer modes are found than are followed: each found mode continues the line with a similar
    /// shape.
    #[test]
    fn a_mode_too_few_shifts_no_other() {
        let [first, second] = turned(0.0);
        let mut tracks = Tracks::begin(&[seen(1.0, first), seen(1.1, second)]);
        let one = [seen(1.2, second)];
        let assignment = tracks.assign(&one);
        tracks.take(&one, &assignment);
        assert_eq!(tracks.modes[0].frequencies_hz, [1.0]);
        assert_eq!(tracks.modes[0].lost, Some(0.0));
        assert_eq!(tracks.modes[1].frequencies_hz, [1.1, 1.2]);
        assert_eq!(tracks.modes[1].lost, None);
    }

    /// A shape with MACs of 0.4, 0.3 and 0.3 with three modes is not lost; without the last two
    /// modes it is lost.
    #[test]
    fn a_mode_between_three_is_not_lost() {
        let shape = [0.4_f64, 0.3, 0.3].map(f64::sqrt);
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let tracks = Tracks::begin(&[seen(1.0, shape)]);
        let three = axes.map(|axis| seen(1.0 + axis[1] + 2.0 * axis[2], axis));
        assert!(!tracks.has_lost(&tracks.assign(&three), 1));
        assert!(tracks.has_lost(&tracks.assign(&three[..1]), 1));
    }
}

//! Derivatives on a finer mesh. A frequency depends little on the soil, so a mesh that is fine
//! enough for it may be far too coarse for its derivative.

use super::step::size_of;
use super::{Derivative, Sensitivities};
use crate::solve::{ModeFrequency, Options};
use crate::tower::Neighbours;

/// Required relative error of a derivative.
const WANTED: f64 = 1e-3;
/// A relative error of the frequency below this, for a change of the input value by its own size,
/// is negligible.
const NEGLIGIBLE: f64 = 1e-5;
/// From this number of segments on a mesh is fine enough: the errors of its derivatives are below
/// the required one, although the estimates may be larger.
const FINE: usize = 60;

/// The options of a finer mesh, if the derivatives on a mesh with this number of segments need one.
pub(super) fn options(
    found: &Sensitivities,
    neighbours: &Neighbours,
    (options, segments): (&Options, usize),
) -> Option<Options> {
    let asked = options.segments.filter(|asked| *asked < FINE)?;
    let is_coarse = found.changes.iter().any(|of| {
        let size = size_of(&of.change, of.value, neighbours);
        let of_modes = found.modes.iter().zip(&of.modes);
        let known =
            of_modes.filter_map(|(mode, derivative)| Some((mode, derivative.as_ref().ok()?)));
        known
            .into_iter()
            .any(|(mode, derivative)| derivative.is_coarse(mode, size))
    });
    // Every row of the tower and of its soil is the end of a segment.
    let segments = segments.max(asked);
    is_coarse.then(|| Options {
        segments: Some(FINE.max(2 * segments)),
        ..options.clone()
    })
}

impl Derivative {
    /// Whether its error is larger than required, for an input value of this size.
    fn is_coarse(&self, mode: &ModeFrequency, size: f64) -> bool {
        let error = self.error_hz_per_unit;
        error > WANTED * self.hz_per_unit.abs() && error * size > NEGLIGIBLE * mode.extrapolated_hz
    }
}

impl Sensitivities {
    /// Takes the derivatives of a finer mesh, by the names of the modes: on a coarse mesh an
    /// estimated error can be small by chance.
    pub(super) fn take_finer(&mut self, finer: &Self) {
        let place = |mode: &ModeFrequency| {
            let mut modes = finer.modes.iter();
            modes.position(|other| other.name() == mode.name())
        };
        let places: Vec<Option<usize>> = self.modes.iter().map(place).collect();
        for (own, finer) in self.changes.iter_mut().zip(&finer.changes) {
            for (own, place) in own.modes.iter_mut().zip(&places) {
                let finer = place.and_then(|place| finer.modes[place].as_ref().ok());
                let (Ok(own), Some(finer)) = (own, finer) else {
                    continue;
                };
                own.hz_per_unit = finer.hz_per_unit;
                own.error_hz_per_unit = finer.error_hz_per_unit;
            }
        }
    }
}

//! The same modes on other meshes.

use std::f64::consts::TAU;

use super::super::error::SolveError;
use super::super::on_mesh::guesses::{Guesses, followed};
use super::super::on_mesh::model::Model;
use super::super::on_mesh::spectrum::{ModeKey, Spectrum};
use crate::eigen::EigenError;
use crate::modes::{Estimate, extrapolate};

/// The frequencies of modes on a mesh, Hz; none for modes of a subsystem that self-weight makes
/// unstable there.
pub(super) type Level = Vec<Option<f64>>;

/// One mesh more than the number of powers of the error reveals an agreement by chance.
pub(crate) const MORE: usize = 1;

/// Limit of the number of meshes of a ladder.
const MOST_MESHES: usize = 8;

/// Meshes with halved numbers of segments, finest first.
#[derive(Debug, Default)]
pub(crate) struct Ladder<M> {
    pub(crate) meshes: Vec<M>,
    /// Index of the mesh on which the modes were found, if it is in the ladder.
    pub(crate) own: Option<usize>,
}

/// The frequencies of the same modes on each mesh of a ladder.
#[derive(Debug, Default)]
pub(crate) struct Levels {
    levels: Vec<Level>,
    own: usize,
}

impl<M> Ladder<M> {
    /// Solves for the modes on each other mesh; on their own mesh they have the frequencies
    /// `own_hz`.
    pub(crate) fn solve(
        &self,
        mut own_hz: impl Iterator<Item = f64>,
        levels: &mut Levels,
        mut solve: impl FnMut(usize, &M, &mut Level) -> Result<(), SolveError>,
    ) -> Result<(), SolveError> {
        let Levels { levels, own } = levels;
        levels.resize_with(self.meshes.len(), Vec::new);
        *own = self.own.unwrap_or(0);
        for (index, (mesh, level)) in self.meshes.iter().zip(levels).enumerate() {
            if self.own == Some(index) {
                level.clear();
                level.extend(own_hz.by_ref().map(Some));
            } else {
                solve(index, mesh, level)?;
            }
        }
        Ok(())
    }
}

impl Levels {
    /// The error of a mode, by its index and frequency (Hz), from as many meshes as the powers of
    /// its error need and one more, coarser ones before finer ones.
    pub(crate) fn extrapolate(&self, index: usize, frequency_hz: f64, powers: &[i32]) -> Estimate {
        let needed = (powers.len() + MORE).min(self.levels.len() - 1);
        let finest = self.own.min(self.levels.len() - 1 - needed);
        let mut meshes_hz = [0.0; MOST_MESHES];
        let meshes_hz = &mut meshes_hz[..=needed];
        let levels = self.levels[finest..=finest + needed].iter();
        let mut known = meshes_hz.iter_mut().zip(levels);
        let all_are_known = known.all(|(hz, level)| {
            *hz = level[index].unwrap_or_default();
            level[index].is_some()
        });
        match all_are_known {
            true => extrapolate(frequency_hz, meshes_hz, powers),
            // If a finer chain buckles, the error of the mode is unknown.
            false => Estimate {
                error_hz: frequency_hz,
                extrapolated_hz: frequency_hz,
                spread_hz: frequency_hz,
                is_regular: false,
            },
        }
    }

    /// Whether a mode has no frequency on the modes' own mesh or a coarser one.
    pub(super) fn lacks_coarse(&self) -> bool {
        self.levels[self.own..]
            .iter()
            .flatten()
            .any(Option::is_none)
    }
}

/// The frequencies of modes on the mesh that the model is assembled on: from guesses where these
/// lead to a complete list, by the Lanczos process otherwise.
pub(crate) fn frequencies(
    keys: &[ModeKey],
    model: &mut Model,
    spectrum: &mut Spectrum,
    mut guesses: Option<&mut Guesses>,
    level: &mut Level,
) -> Result<(), SolveError> {
    level.clear();
    level.resize(keys.len(), None);
    for index in 0..model.count() {
        let wanted = followed(keys, index);
        if wanted == 0 {
            continue;
        }
        let own = || {
            let keys = keys.iter().enumerate();
            keys.filter(|(_, key)| key.subsystem == index)
        };
        let guessed = guesses.as_mut();
        if let Some(lambdas) = guessed.and_then(|guesses| guesses.refine(model, index, wanted)) {
            let frequency_hz = |key: &ModeKey| lambdas[key.order - 1].sqrt() / TAU;
            own().for_each(|(place, key)| level[place] = Some(frequency_hz(key)));
            continue;
        }
        match spectrum.solve_subsystem(model, index, wanted, None) {
            Err(EigenError::Unstable { .. }) => continue,
            // Near buckling another mesh can be beyond the origin, or its lowest modes below the
            // rounding of the others.
            Err(_) if model.origin < 0.0 => continue,
            result => result?,
        }
        let frequency_hz = |key: &ModeKey| spectrum.eigenvalue(model, *key).frequency_hz();
        own().for_each(|(place, key)| level[place] = Some(frequency_hz(key)));
    }
    Ok(())
}

//! The same modes on other meshes.

use super::error::SolveError;
use super::model::Model;
use super::spectrum::{ModeKey, Spectrum};
use crate::eigen::EigenError;
use crate::modes::{Estimate, richardson};

/// The frequencies of modes on a mesh, Hz; none for modes of a subsystem that self-weight makes
/// unstable there.
pub(super) type Level = Vec<Option<f64>>;

/// A mesh more than the powers of the error need reveals meshes that agree by chance.
pub(super) const MORE: usize = 1;

/// Meshes that halve each other's segments, finest first.
pub(super) struct Ladder<M> {
    pub(super) meshes: Vec<M>,
    /// Which of them the modes were found on, if it is among them.
    pub(super) own: Option<usize>,
}

/// The frequencies of the same modes on each mesh of a ladder.
pub(super) struct Levels {
    pub(super) levels: Vec<Level>,
    own: usize,
}

impl<M> Ladder<M> {
    /// Solves for the modes on each mesh but their own, where they have the frequencies `own_hz`.
    pub(super) fn solve(
        &self,
        own_hz: &[f64],
        mut solve: impl FnMut(usize, &M) -> Result<Level, SolveError>,
    ) -> Result<Levels, SolveError> {
        let mut levels = Vec::with_capacity(self.meshes.len());
        for (index, mesh) in self.meshes.iter().enumerate() {
            levels.push(match self.own == Some(index) {
                true => own_hz.iter().copied().map(Some).collect(),
                false => solve(index, mesh)?,
            });
        }
        let own = self.own.unwrap_or(0);
        Ok(Levels { levels, own })
    }
}

impl Levels {
    /// The error of a mode, by its index and frequency (Hz), from as many meshes as the powers of
    /// its error need and one more, coarser ones before finer ones.
    pub(super) fn extrapolate(&self, index: usize, frequency_hz: f64, powers: &[i32]) -> Estimate {
        let needed = (powers.len() + MORE).min(self.levels.len() - 1);
        let finest = self.own.min(self.levels.len() - 1 - needed);
        let levels = self.levels[finest..=finest + needed].iter();
        match levels
            .map(|level| level[index])
            .collect::<Option<Vec<f64>>>()
        {
            Some(meshes_hz) => richardson(frequency_hz, meshes_hz, powers),
            // A finer chain that buckles leaves nothing certain about the mode.
            None => Estimate {
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

/// The frequencies of modes on the mesh that the model is assembled on.
pub(super) fn frequencies(
    keys: &[ModeKey],
    model: &mut Model,
    spectrum: &mut Spectrum,
) -> Result<Level, SolveError> {
    let mut is_stable = vec![true; model.count()];
    for (index, is_stable) in is_stable.iter_mut().enumerate() {
        let own = keys.iter().filter(|key| key.subsystem == index);
        let Some(wanted) = own.map(|key| key.order).max() else {
            continue;
        };
        match spectrum.solve_subsystem(model, index, wanted) {
            Err(EigenError::Unstable { .. }) => *is_stable = false,
            // Near buckling another mesh can be beyond the origin, or its lowest modes below the
            // rounding of the others.
            Err(_) if model.origin < 0.0 => *is_stable = false,
            result => result?,
        }
    }
    let frequency = |key: &ModeKey| {
        let eigenvalue = || spectrum.eigenvalue(model, *key);
        is_stable[key.subsystem].then(|| eigenvalue().frequency_hz())
    };
    Ok(keys.iter().map(frequency).collect())
}

//! Guesses of modes from those of the same tower on another mesh, or of a similar tower.

use super::model::Model;
use super::spectrum::{Found, ModeKey, SimilarModes, Spectrum};
use crate::eigen::{
    EigenWorkspace, Eigenvalue, OF_ESTIMATES, Refinement, Sought, Statistics, lowest_near, refine,
};
use crate::subsystem::InternalForces;
use crate::tower::{Motions, Tower};

/// A guess of a mode is used if its eigenvalue is this many times its error.
const CERTAIN: f64 = 1e6;

/// The ratio of the end of the gap above a list to its last eigenvalue, if the next one is unknown.
const GAP_ABOVE: f64 = 1.1;

/// The internal forces of modes, which hardly depend on the mesh and little on the dimensions of
/// the tower, and the eigenvalues that were found from them.
#[derive(Debug, Default)]
pub(crate) struct Guesses {
    subsystems: Vec<OfSubsystem>,
    /// How many modes of each subsystem are listed.
    listed: Vec<usize>,
    /// The highest eigenvalue of the list, rad²/s².
    listed_to: f64,
    /// Heights where forces may jump, m.
    jumps_m: Vec<f64>,
    refinement: Refinement,
}

/// The guesses for one subsystem.
#[derive(Debug, Default)]
struct OfSubsystem {
    /// Number of modes with guesses: all that are followed, or none.
    count: usize,
    motions: Motions,
    forces: Vec<InternalForces>,
    /// The eigenvalues of the modes where they were taken, rad²/s².
    known: Vec<f64>,
}

impl Guesses {
    /// Takes the modes with these keys from the mesh that they were found on.
    pub(crate) fn take(
        &mut self,
        keys: &[ModeKey],
        tower: &Tower,
        model: &Model,
        spectrum: &Spectrum,
    ) {
        self.jumps_m.clear();
        let attached = tower.attachments().iter();
        self.jumps_m
            .extend(attached.map(|attachment| attachment.height_m));
        let most = self.subsystems.len().max(model.count());
        self.subsystems.resize_with(most, OfSubsystem::default);
        for (index, guesses) in self.subsystems.iter_mut().take(model.count()).enumerate() {
            let eigenvalues = spectrum.eigenvalues_of(index);
            guesses.known.clear();
            guesses.known.extend(eigenvalues.iter().map(|e| e.lambda));
            guesses.count = 0;
            guesses.motions = model.motions(index);
            let count = followed(keys, index);
            // Near zero an eigenvalue has few correct digits, and its guess has none.
            let is_certain = |e: &Eigenvalue| e.lambda > CERTAIN * e.error;
            if model.origin != 0.0 || !eigenvalues[..count].iter().all(is_certain) {
                continue;
            }
            let most = guesses.forces.len().max(count);
            guesses.forces.resize_with(most, InternalForces::default);
            let subsystem = model.subsystem(index);
            let mut forces = guesses.forces[..count].iter_mut().enumerate();
            let mut take = |(place, forces): (usize, &mut InternalForces)| {
                let vector = spectrum.vector_of(index, place);
                subsystem.internal_forces(vector, forces)
            };
            if forces.all(&mut take) {
                guesses.count = count;
            }
        }
    }

    /// Notes which modes are listed, lowest first.
    pub(crate) fn set_listed(&mut self, found: &[Found]) {
        let keys: Vec<ModeKey> = found.iter().map(|found| found.key).collect();
        let listed = (0..self.subsystems.len()).map(|index| followed(&keys, index));
        self.listed = listed.collect();
        self.listed_to = found.last().map_or(0.0, |last| last.eigenvalue.lambda);
    }

    /// The `wanted` lowest eigenvalues of a subsystem on the present mesh, if the guesses lead to
    /// them.
    pub(crate) fn refine(
        &mut self,
        model: &mut Model,
        index: usize,
        wanted: usize,
    ) -> Option<&[f64]> {
        let Self {
            subsystems,
            refinement,
            ..
        } = self.guess(model, index, wanted)?;
        let mut pencil = model.vibration(index);
        let sought = subsystems[index].sought(wanted, 0.0);
        refine(&mut pencil, sought, OF_ESTIMATES, refinement)?;
        Some(&refinement.lambdas[..])
    }

    /// Guesses the vectors of the `wanted` lowest modes of a subsystem on the present mesh; none if
    /// there are not as many guesses, or if they are of other motions.
    fn guess(&mut self, model: &Model, index: usize, wanted: usize) -> Option<&mut Self> {
        let Self {
            subsystems,
            jumps_m,
            refinement,
            ..
        } = self;
        let guesses = subsystems.get(index)?;
        let subsystem = model.subsystem(index);
        let is_same = guesses.motions == subsystem.motions() && model.origin == 0.0;
        if guesses.count < wanted || !is_same {
            return None;
        }
        let size = subsystem.degrees_of_freedom();
        let vectors = &mut refinement.vectors;
        vectors.resize_with(vectors.len().max(wanted), Vec::new);
        for (vector, forces) in vectors.iter_mut().zip(&guesses.forces[..wanted]) {
            vector.resize(size, 0.0);
            subsystem.with_internal_forces(forces, jumps_m, vector);
        }
        Some(self)
    }

    /// A vector of the last [`refine`](Self::refine) that succeeded, by its place from 0.
    pub(crate) fn vector(&self, place: usize) -> &[f64] {
        &self.refinement.vectors[place]
    }
}

impl OfSubsystem {
    /// The search for the `wanted` lowest eigenvalues, with a limit above the last one of a list,
    /// `listed_to` (rad²/s²; 0 without a list), if it is below the next eigenvalue.
    fn sought(&self, wanted: usize, listed_to: f64) -> Sought<'_> {
        let known = &self.known;
        let last = wanted.checked_sub(1).map_or(0.0, |last| known[last]);
        let next = known.get(wanted).copied();
        let from = match next {
            Some(next) if next < listed_to => last,
            _ => last.max(listed_to),
        };
        let gap_end = next.map_or(from * GAP_ABOVE, |next| from.sqrt() * next.sqrt());
        Sought {
            wanted,
            known,
            gap_ratio: gap_end / last,
        }
    }
}

impl SimilarModes for Guesses {
    fn listed(&self) -> &[usize] {
        &self.listed
    }

    fn lowest(
        &mut self,
        model: &mut Model,
        subsystem: usize,
        wanted: usize,
        workspace: &mut EigenWorkspace,
    ) -> Option<Statistics> {
        let Self {
            subsystems,
            refinement,
            listed_to,
            ..
        } = self.guess(model, subsystem, wanted)?;
        let mut pencil = model.vibration(subsystem);
        let sought = subsystems[subsystem].sought(wanted, *listed_to);
        lowest_near(&mut pencil, sought, refinement, workspace)
    }
}

/// Number of modes of a subsystem that are followed: up to the highest of the keys.
pub(crate) fn followed(keys: &[ModeKey], subsystem: usize) -> usize {
    let own = keys.iter().filter(|key| key.subsystem == subsystem);
    own.map(|key| key.order).max().unwrap_or(0)
}

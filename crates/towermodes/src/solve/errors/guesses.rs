//! Guesses of the modes of a tower on other meshes, from those on its own.

use super::super::on_mesh::model::Model;
use super::super::on_mesh::spectrum::{ModeKey, Spectrum};
use crate::eigen::{Eigenvalue, Refinement, refine};
use crate::subsystem::InternalForces;
use crate::tower::Tower;

/// A mode is guessed if its eigenvalue is so many times its error.
const CERTAIN: f64 = 1e6;

/// The internal forces of modes, which hardly depend on the mesh, and the eigenvalues on another
/// mesh that were found from them.
#[derive(Debug, Default)]
pub(crate) struct Guesses {
    subsystems: Vec<OfSubsystem>,
    /// Heights where forces may jump, m.
    jumps_m: Vec<f64>,
    refinement: Refinement,
}

/// The guesses for one subsystem.
#[derive(Debug, Default)]
struct OfSubsystem {
    /// How many modes can be guessed: all that are followed, or none.
    count: usize,
    forces: Vec<InternalForces>,
    /// The eigenvalues on the modes' own mesh, rad²/s².
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
            let count = followed(keys, index);
            // Near zero the digits of a mode are few, and those of its guess are none.
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

    /// The `wanted` lowest eigenvalues of a subsystem on the present mesh, if the guesses lead to
    /// them.
    pub(crate) fn refine(
        &mut self,
        model: &mut Model,
        index: usize,
        wanted: usize,
    ) -> Option<&[f64]> {
        let guesses = self.subsystems.get(index)?;
        if guesses.count < wanted || model.origin != 0.0 {
            return None;
        }
        let subsystem = model.subsystem(index);
        let size = subsystem.degrees_of_freedom();
        let vectors = &mut self.refinement.vectors;
        vectors.resize_with(vectors.len().max(wanted), Vec::new);
        for (vector, forces) in vectors.iter_mut().zip(&guesses.forces[..wanted]) {
            vector.resize(size, 0.0);
            subsystem.with_internal_forces(forces, &self.jumps_m, vector);
        }
        let mut pencil = model.vibration(index);
        let is_found = refine(&mut pencil, &guesses.known, wanted, &mut self.refinement);
        is_found.then_some(&self.refinement.lambdas[..])
    }
}

impl Guesses {
    /// A vector of the last [`refine`](Self::refine) that succeeded, by its place from 0.
    pub(crate) fn vector(&self, place: usize) -> &[f64] {
        &self.refinement.vectors[place]
    }
}

/// How many modes of a subsystem are followed: up to the highest of the keys.
pub(crate) fn followed(keys: &[ModeKey], subsystem: usize) -> usize {
    let own = keys.iter().filter(|key| key.subsystem == subsystem);
    own.map(|key| key.order).max().unwrap_or(0)
}

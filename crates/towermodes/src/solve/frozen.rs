//! Modes of a tower that are held while the tower changes a little.
//!
//! The Rayleigh quotient ρ = xᵀKx/xᵀMx is stationary at an eigenvector x, so its derivative with
//! the vector held is that of the eigenvalue (Hellmann 1937, Feynman 1939; Fox & Kapoor 1968). The
//! scaled coordinates of a vector are held: they are the same on every tower of one structure.

use super::cut::Cut;
use super::error::SolveError;
use super::estimate::powers;
use super::frequencies::{ModeFrequency, solve_frequencies};
use super::guesses::followed;
use super::model::Model;
use super::options::Options;
use super::spectrum::ModeKey;
use super::stability::find_origin_again;
use super::workspace::Workspace;
use crate::Method;
use crate::eigen::{EigenError, ShiftInvert};
use crate::elements::Mesh;
use crate::subsystem::Eigenproblem;
use crate::tower::{Motions, Neighbour, Neighbours, Tower};

/// The lowest modes of a tower on its meshes.
pub(crate) struct FrozenModes {
    options: Options,
    /// The modes, as [`solve_frequencies`] lists them.
    pub(crate) modes: Vec<ModeFrequency>,
    keys: Vec<ModeKey>,
    /// The powers of 1/n in the error of each mode; none for the spectral method.
    pub(crate) powers: Vec<&'static [i32]>,
    /// The motions of each mode's subsystem.
    pub(crate) motions: Vec<Motions>,
    /// The mesh of the modes and those below it, each with half the segments of the one before.
    pub(crate) meshes: Vec<FrozenMesh>,
    model: Model,
}

/// The modes on one mesh.
pub(crate) struct FrozenMesh {
    cut: Cut,
    vectors: Vec<Vec<f64>>,
    /// The eigenvalue λ of each mode, rad²/s².
    pub(crate) lambdas: Vec<f64>,
}

impl FrozenModes {
    /// Solves a tower for its modes.
    ///
    /// # Errors
    /// [`SolveError`], as [`solve_frequencies`].
    pub(crate) fn of(
        neighbours: &Neighbours,
        options: &Options,
        workspace: &mut Workspace,
    ) -> Result<Self, SolveError> {
        let tower = neighbours.tower();
        let modes = solve_frequencies(tower, options, workspace)?.modes.clone();
        let keys: Vec<ModeKey> = workspace.errors.modes.iter().map(|mode| mode.key).collect();
        let origin = workspace.model.origin;
        let mut frozen = Self {
            options: options.without_shapes(),
            modes,
            keys,
            powers: Vec::new(),
            motions: Vec::new(),
            meshes: Vec::new(),
            model: Model::default(),
        };
        for cut in cuts(tower, options, workspace)? {
            match frozen.solve(tower, cut, origin, workspace) {
                Ok(mesh) => frozen.meshes.push(mesh),
                // The coarser meshes only tell how the derivative converges.
                Err(_) if !frozen.meshes.is_empty() => break,
                Err(error) => return Err(error),
            }
        }
        let model = &workspace.model;
        let subsystems = frozen.keys.iter().map(|key| key.subsystem);
        frozen.motions = subsystems.map(|index| model.motions(index)).collect();
        let of_mode = |key: &ModeKey| match options.method {
            Method::Spectral => &[][..],
            _ => powers(tower, options, model, *key),
        };
        frozen.powers = frozen.keys.iter().map(of_mode).collect();
        Ok(frozen)
    }

    fn solve(
        &self,
        tower: &Tower,
        cut: Cut,
        origin: f64,
        workspace: &mut Workspace,
    ) -> Result<FrozenMesh, SolveError> {
        let Workspace {
            model, spectrum, ..
        } = workspace;
        model.assemble(tower, &cut.mesh, cut.degree, &self.options);
        find_origin_again(tower, model, origin)?;
        for index in 0..model.count() {
            let wanted = followed(&self.keys, index);
            if wanted > 0 {
                spectrum.solve_subsystem(model, index, wanted)?;
            }
        }
        let vector = |key: &ModeKey| spectrum.vector(*key).to_vec();
        let vectors: Vec<Vec<f64>> = self.keys.iter().map(vector).collect();
        let keys = self.keys.iter().zip(&vectors);
        let quotients = keys.map(|(key, vector)| quotient(model, key.subsystem, vector));
        let lambdas: Vec<f64> = quotients.collect();
        match lambdas.iter().all(|lambda| lambda.is_finite()) {
            true => Ok(FrozenMesh {
                cut,
                vectors,
                lambdas,
            }),
            false => Err(EigenError::NotFinite.into()),
        }
    }

    /// The Rayleigh quotients of the held modes on a neighbour of the tower, for each mesh and
    /// mode, rad²/s²; false if the neighbour has other unknowns.
    pub(crate) fn quotients(
        &mut self,
        neighbours: &Neighbours,
        neighbour: &Neighbour,
        quotients: &mut Vec<Vec<f64>>,
    ) -> bool {
        quotients.resize_with(self.meshes.len(), Vec::new);
        let tower = &neighbour.tower;
        let model = &mut self.model;
        for (mesh, quotients) in self.meshes.iter().zip(quotients) {
            let moved = moved(neighbours, tower, &mesh.cut.mesh);
            model.assemble(tower, &moved, mesh.cut.degree, &self.options);
            quotients.clear();
            for (key, vector) in self.keys.iter().zip(&mesh.vectors) {
                let is_same = key.subsystem < model.count()
                    && model.subsystem(key.subsystem).degrees_of_freedom() == vector.len();
                if !is_same {
                    return false;
                }
                quotients.push(quotient(model, key.subsystem, vector));
            }
        }
        true
    }
}

/// The mesh of a neighbour.
fn moved(neighbours: &Neighbours, tower: &Tower, mesh: &Mesh) -> Mesh {
    mesh.moved(|height_m| neighbours.moved_m(tower, height_m))
}

/// ρ of a vector of a subsystem.
fn quotient(model: &mut Model, index: usize, vector: &[f64]) -> f64 {
    let problem = Eigenproblem::Vibration { origin: 0.0 };
    let [stiffness, mass] = model.pencil(index, problem).energies(vector);
    stiffness / mass
}

/// The cuts of the last [`solve_frequencies`]: that of the modes, and meshes with half as many
/// segments while there are some.
fn cuts(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Vec<Cut>, SolveError> {
    if options.method == Method::Spectral {
        return Ok(workspace.spectral_cut.clone().into_iter().collect());
    }
    let own = Cut::new(tower, options)?;
    let halvings = match options.borders_m {
        Some(_) => 0,
        None => own.mesh.halvings().min(MOST_HALVINGS),
    };
    let halved = |halvings| {
        let mut cut = Cut::default();
        own.mesh.write_halved(halvings, &mut cut.mesh);
        cut
    };
    Ok((0..=halvings).map(halved).collect())
}

/// Meshes below that of the modes: one for each power of the errors, and one more.
const MOST_HALVINGS: u32 = 3;

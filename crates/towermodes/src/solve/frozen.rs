//! Modes with fixed shapes for small changes of the tower.
//!
//! The Rayleigh quotient ρ = xᵀKx/xᵀMx is stationary at an eigenvector x, so its derivative with
//! the vector held is that of the eigenvalue (Hellmann 1937, Feynman 1939; Fox & Kapoor 1968). The
//! scaled coordinates of a vector are held: they are the same on every tower of one structure.

use super::attached::{AttachedEnds, AttachedForces};
use super::error::SolveError;
use super::errors::estimate::powers;
use super::on_mesh::cut::Cut;
use super::on_mesh::guesses::{Guesses, followed};
use super::on_mesh::model::Model;
use super::on_mesh::spectrum::{ModeKey, Spectrum};
use super::on_mesh::stability::find_origin_again;
use super::request::options::Options;
use super::results::frequencies::ModeFrequency;
use super::without_shapes::solve_keeping_vectors;
use super::workspace::Workspace;
use crate::Method;
use crate::eigen::{EigenError, ShiftInvert};
use crate::elements::{GradientMesh, Mesh, shear_fraction};
use crate::subsystem::Eigenproblem;
use crate::tower::{Motions, Neighbour, Neighbours, Plane, Tower};

/// The lowest modes of a tower on its meshes.
pub(crate) struct FrozenModes {
    options: Options,
    /// The modes, as [`Frequencies`](super::Frequencies) lists them.
    pub(crate) modes: Vec<ModeFrequency>,
    keys: Vec<ModeKey>,
    /// The powers of 1/n in the error of each mode; none for the spectral method.
    pub(crate) powers: Vec<&'static [i32]>,
    /// The coupled motions of each mode's subsystem.
    pub(crate) motions: Vec<Motions>,
    /// Indices of the modes whose frequencies do not converge with these powers.
    pub(crate) irregular: Vec<usize>,
    /// The mesh of the modes and others, each with half the segments of the one before.
    pub(crate) meshes: Vec<FrozenMesh>,
    /// Index of the mesh of the modes.
    pub(crate) own: usize,
    /// For each number of the tower the derivatives of the eigenvalues with respect to it, mesh by
    /// mesh; none if the method has no sweep that gives them.
    pub(crate) gradients: Option<Vec<f64>>,
    model: Model,
}

/// The modes on one mesh.
pub(crate) struct FrozenMesh {
    cut: Cut,
    vectors: Vec<Vec<f64>>,
    /// The eigenvalue λ of each mode, rad²/s².
    pub(crate) lambdas: Vec<f64>,
    /// Data of each mode at attachments that can move away from the end of a piece; empty if none
    /// can.
    attached: Vec<AttachedEnds>,
}

impl FrozenMesh {
    /// The change of the eigenvalue (rad²/s²) of a mode if attachments are at these distances (m)
    /// above the ends of pieces that carry them.
    pub(crate) fn change_by_arms(&self, mode: usize, arms_m: &[f64]) -> f64 {
        match (self.attached.get(mode), arms_m) {
            (None, _) | (_, []) => 0.0,
            (Some(ends), arms_m) => ends.change(arms_m),
        }
    }
}

impl FrozenModes {
    /// Solves a tower for its modes.
    ///
    /// # Errors
    /// [`SolveError`], as [`Solver::frequencies`](super::Solver::frequencies).
    pub(crate) fn of(
        neighbours: &Neighbours,
        options: &Options,
        workspace: &mut Workspace,
    ) -> Result<Self, SolveError> {
        let tower = neighbours.tower();
        let mut own = Some(Vec::new());
        solve_keeping_vectors(tower, options, workspace, &mut own)?;
        let mut own = own.filter(|vectors| !vectors.is_empty());
        let modes = workspace.frequencies.modes.clone();
        let keys: Vec<ModeKey> = workspace.errors.modes.iter().map(|mode| mode.key).collect();
        let origin = workspace.model.origin;
        let mut frozen = Self {
            options: options.without_shapes(),
            modes,
            keys,
            powers: Vec::new(),
            motions: Vec::new(),
            irregular: workspace.errors.irregular.clone(),
            meshes: Vec::new(),
            own: 0,
            gradients: None,
            model: Model::default(),
        };
        let mut gradients = frozen.begin_gradients();
        frozen.set_powers(tower, options, &workspace.model);
        let powers = frozen.powers.iter().map(|powers| powers.len());
        let most = 1 + powers.max().unwrap_or(0) as u32;
        let (cuts, finer) = cuts(tower, options, workspace, most)?;
        frozen.own = finer;
        for (index, cut) in cuts.into_iter().enumerate() {
            let known = if index == finer { own.take() } else { None };
            match frozen.solve(tower, cut, (origin, known), workspace) {
                Ok(mesh) => {
                    gradients = gradients.and_then(|mut all| {
                        let is_whole = frozen.add_gradients(tower, &mesh, workspace, &mut all);
                        is_whole.then_some(all)
                    });
                    frozen.meshes.push(mesh);
                }
                // The other meshes are used only for the convergence of the derivative.
                Err(_) if index < finer => {
                    frozen.meshes.clear();
                    gradients = frozen.begin_gradients();
                    frozen.own = finer - index - 1;
                }
                Err(_) if index > finer => break,
                Err(error) => return Err(error),
            }
        }
        frozen.gradients = gradients.map(|all| by_number(&all));
        Ok(frozen)
    }

    /// The number of segments of the mesh of the modes.
    pub(crate) fn segments(&self) -> usize {
        let own = self.meshes.get(self.own);
        own.map_or(0, |own| own.cut.mesh.segments())
    }

    /// Sets how the errors of the modes decrease, and their motions.
    fn set_powers(&mut self, tower: &Tower, options: &Options, model: &Model) {
        let subsystems = self.keys.iter().map(|key| key.subsystem);
        self.motions = subsystems.map(|index| model.motions(index)).collect();
        let of_mode = |key: &ModeKey| match options.method.converges_by_degree() {
            true => &[][..],
            false => powers(tower, options, model, *key),
        };
        self.powers = self.keys.iter().map(of_mode).collect();
    }

    /// Memory for the gradients, if there are any.
    fn begin_gradients(&self) -> Option<Vec<Vec<f64>>> {
        let is_swept = self.options.method == Method::RmjeExact && self.options.borders_m.is_none();
        is_swept.then(Vec::new)
    }

    /// Adds the gradient of each mode on a mesh; false if the chain has none.
    fn add_gradients(
        &self,
        tower: &Tower,
        mesh: &FrozenMesh,
        workspace: &mut Workspace,
        gradients: &mut Vec<Vec<f64>>,
    ) -> bool {
        let model = &mut workspace.model;
        let rotary_inertia = self.options.rotary_inertia;
        let mut on_mesh = GradientMesh::new(tower, &mesh.cut.mesh, rotary_inertia);
        let mut states = Vec::new();
        let modes = self.keys.iter().zip(&mesh.vectors).zip(&mesh.lambdas);
        for ((key, vector), &lambda) in modes {
            let [_, mass] = energies(model, key.subsystem, vector);
            let mut gradient = Vec::new();
            let is_whole = model
                .subsystem(key.subsystem)
                .joint_states(lambda, vector, &mut states)
                && on_mesh.write(lambda, &states, &mut gradient);
            if !is_whole {
                return false;
            }
            gradient.iter_mut().for_each(|value| *value /= mass);
            gradients.push(gradient);
        }
        true
    }

    fn solve(
        &self,
        tower: &Tower,
        cut: Cut,
        (origin, known): (f64, Option<Vec<Vec<f64>>>),
        workspace: &mut Workspace,
    ) -> Result<FrozenMesh, SolveError> {
        let Workspace {
            model,
            spectrum,
            errors,
            ..
        } = workspace;
        model.assemble(tower, &cut.mesh, cut.degree, &self.options);
        find_origin_again(tower, model, origin)?;
        let vectors = match known {
            Some(vectors) => vectors,
            None => self.vectors(model, spectrum, &mut errors.guesses)?,
        };
        let keys = self.keys.iter().zip(&vectors);
        let quotients = keys.map(|(key, vector)| quotient(model, key.subsystem, vector));
        let lambdas: Vec<f64> = quotients.collect();
        if !lambdas.iter().all(|lambda| lambda.is_finite()) {
            return Err(EigenError::NotFinite.into());
        }
        let mut mesh = FrozenMesh {
            cut,
            vectors,
            lambdas,
            attached: Vec::new(),
        };
        self.add_attached(tower, model, &mut mesh);
        Ok(mesh)
    }

    /// Adds the data of the modes at attachments that can move away from the end of a piece, for
    /// the model on this mesh.
    fn add_attached(&self, tower: &Tower, model: &mut Model, mesh: &mut FrozenMesh) {
        let options = &self.options;
        let included = (options.method.has_shear(), options.rotary_inertia);
        let Some(forces) = AttachedForces::of(tower, &mesh.cut.mesh, included) else {
            return;
        };
        let shear = |plane: Plane, base_m, top_m| shear_fraction(tower, plane, base_m, top_m);
        let modes = self.keys.iter().zip(&mesh.vectors).zip(&mesh.lambdas);
        let attached = modes.map(|((key, vector), &lambda)| {
            let [_, mass] = energies(model, key.subsystem, vector);
            let subsystem = model.subsystem(key.subsystem);
            let curves = subsystem.curves(mesh.cut.mesh.borders_m(), &shear, vector);
            forces.in_mode(lambda, &*curves, mass)
        });
        mesh.attached = attached.collect();
    }

    /// The vectors of the modes on the present mesh, from guesses or from the Lanczos process.
    fn vectors(
        &self,
        model: &mut Model,
        spectrum: &mut Spectrum,
        guesses: &mut Guesses,
    ) -> Result<Vec<Vec<f64>>, SolveError> {
        let mut vectors = vec![Vec::new(); self.keys.len()];
        for index in 0..model.count() {
            let wanted = followed(&self.keys, index);
            if wanted == 0 {
                continue;
            }
            let is_guessed = guesses.refine(model, index, wanted).is_some();
            if !is_guessed {
                spectrum.solve_subsystem(model, index, wanted, None)?;
            }
            let own = self.keys.iter().zip(&mut vectors);
            for (key, vector) in own.filter(|(key, _)| key.subsystem == index) {
                *vector = match is_guessed {
                    true => guesses.vector(key.order - 1).to_vec(),
                    false => spectrum.vector(*key).to_vec(),
                };
            }
        }
        Ok(vectors)
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
        let moves = neighbours.moves(tower);
        let model = &mut self.model;
        for (mesh, quotients) in self.meshes.iter().zip(quotients) {
            let moved = mesh.cut.mesh.moved(&moves);
            model.assemble(tower, &moved, mesh.cut.degree, &self.options);
            quotients.clear();
            for (mode, (key, vector)) in self.keys.iter().zip(&mesh.vectors).enumerate() {
                let is_same = key.subsystem < model.count()
                    && model.subsystem(key.subsystem).degrees_of_freedom() == vector.len();
                if !is_same {
                    return false;
                }
                let carried = quotient(model, key.subsystem, vector);
                quotients.push(carried + mesh.change_by_arms(mode, &neighbour.arms_m));
            }
        }
        true
    }
}

/// Gradients of modes as a list by number, each with the derivatives of all modes.
fn by_number(gradients: &[Vec<f64>]) -> Vec<f64> {
    let count = gradients.first().map_or(0, Vec::len);
    let numbers = 0..count;
    numbers
        .flat_map(|number| gradients.iter().map(move |gradient| gradient[number]))
        .collect()
}

/// ρ of a vector of a subsystem.
fn quotient(model: &mut Model, index: usize, vector: &[f64]) -> f64 {
    let [stiffness, mass] = energies(model, index, vector);
    stiffness / mass
}

/// xᵀKx and xᵀMx of a vector of a subsystem.
fn energies(model: &mut Model, index: usize, vector: &[f64]) -> [f64; 2] {
    let problem = Eigenproblem::Vibration { origin: 0.0 };
    model.pencil(index, problem).energies(vector)
}

/// The cuts of the last solve: that of the modes, and meshes with half as many segments while there
/// are some: one for each power of the errors, and one more. Where there are fewer than the powers
/// need, finer meshes come before: the second result is how many.
fn cuts(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
    most_halvings: u32,
) -> Result<(Vec<Cut>, usize), SolveError> {
    if options.method == Method::Spectral {
        let cut = workspace.spectral_cut.clone();
        return Ok((cut.into_iter().collect(), 0));
    }
    let own = Cut::new(tower, options)?;
    let (halvings, doublings) = match options.borders_m {
        Some(_) => (0, 0),
        None => {
            let halvings = own.mesh.halvings().min(most_halvings);
            (halvings, (most_halvings - 1).saturating_sub(halvings))
        }
    };
    let made = |write: &dyn Fn(&mut Mesh)| {
        let mut cut = Cut::default();
        write(&mut cut.mesh);
        cut
    };
    let finer = (1..=doublings).rev();
    let mut cuts: Vec<Cut> = finer
        .map(|doublings| made(&|mesh| own.mesh.write_doubled(doublings, mesh)))
        .collect();
    let coarser = 0..=halvings;
    cuts.extend(coarser.map(|halvings| made(&|mesh| own.mesh.write_halved(halvings, mesh))));
    Ok((cuts, doublings as usize))
}

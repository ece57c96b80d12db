//! A tower or a blade as uncoupled subsystems, for all methods.

use super::super::progress::Monitor;
use super::super::request::options::Options;
use crate::beam::{BeamRecipe, BeamWorkspace, Beams, assemble_beams, assemble_blade};
use crate::blade::Blade;
use crate::chain::Chains;
use crate::elements::{Element, Mesh, assemble_chains};
use crate::frame::{BareFrame, FrameShape, FrameSolveError, OnFrame};
use crate::modes::ByMotion;
use crate::space::{SpatialMatrix, add_scaled};
use crate::subsystem::{
    Coefficients, Eigenproblem, Energies, Resultant, Subsystem, SubsystemPencil,
};
use crate::tower::{Motions, Tower};

/// Degree of the members of a frame if the elements of the tower have none: exact to ten digits for
/// any member of a jacket in the lowest modes.
const FRAME_DEGREE: usize = 8;

/// The subsystems of a tower or a blade, with work arrays.
///
/// They are chains or beams, whichever was assembled last: one of the two lists is empty.
#[derive(Default)]
pub(crate) struct Model {
    chains: Chains,
    beams: Beams,
    beam_memory: BeamWorkspace,
    /// A tower on a frame; then both lists are empty.
    on_frame: Option<OnFrame>,
    /// The frame of the tower that was assembled last.
    bare_frame: Option<BareFrame>,
    /// The error of the frame, if it has no equations.
    frame_error: Option<FrameSolveError>,
    /// Height of the base, or radius of the blade's root, m.
    base_m: f64,
    /// The origin of the spectrum, rad²/s²: 0, or negative if a floating tower has a motion without
    /// stiffness.
    pub(crate) origin: f64,
    /// The progress observer.
    pub(crate) monitor: Monitor,
}

impl std::fmt::Debug for Model {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Model").finish_non_exhaustive()
    }
}

/// The forces and the energy of a mode.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct ModalForces {
    /// Products of the inertia forces with rigid-body motions (x, y, z, rotation about x, y, z)
    /// about the base.
    pub(super) force: [f64; 6],
    /// Kinetic energy, times 2/ω².
    pub(crate) kinetic: ByMotion,
    /// Strain energy, times 2; none for a subsystem of one motion, which has all of it.
    pub(crate) strain: Option<ByMotion>,
    /// The shares of kinetic and strain energy in local motions of the members of a frame; none
    /// without a frame that has local modes.
    pub(super) local: Option<[f64; 2]>,
}

impl Model {
    /// Assembles a tower on a mesh, with elements of this degree if they have one.
    pub(crate) fn assemble(
        &mut self,
        tower: &Tower,
        mesh: &Mesh,
        degree: usize,
        options: &Options,
    ) {
        let Some(element) = Element::of(options.method) else {
            return self.assemble_beams(tower, mesh, options.beam_recipe(degree));
        };
        self.restart(tower.base_m());
        let recipe = options.recipe(element);
        assemble_chains(tower, mesh, &recipe, &mut self.chains);
        self.put_on_frame(tower, FRAME_DEGREE);
    }

    /// Connects the assembled tower with its frame, if it has one.
    fn put_on_frame(&mut self, tower: &Tower, degree: usize) {
        let Some(frame) = tower.frame() else {
            return;
        };
        let chain = self
            .chains
            .take_only()
            .map(|chain| chain as Box<dyn Subsystem>);
        let own = chain.or_else(|| {
            self.beams
                .take_only()
                .map(|beam| beam as Box<dyn Subsystem>)
        });
        let Some(own) = own else {
            return;
        };
        match OnFrame::new(tower, own, frame, degree, self.bare_frame.take()) {
            Ok(on_frame) => self.on_frame = Some(on_frame),
            Err(error) => self.frame_error = Some(error),
        }
    }

    /// Removes the frame of the last tower, so that a result does not depend on the tower before.
    pub(crate) fn forget_frame(&mut self) {
        (self.on_frame, self.bare_frame) = (None, None);
    }

    /// The change of the eigenvalue λ (rad²/s²) of a vector by finer elements of the frame under
    /// the tower; 0 without a frame.
    pub(crate) fn change_on_finer_frame(&mut self, lambda: f64, vector: &[f64]) -> f64 {
        match &mut self.on_frame {
            Some(on_frame) => on_frame.change_on_finer(lambda, vector),
            None => 0.0,
        }
    }

    /// The inertia of the whole tower as a rigid body about its base, with the frame below it: kg,
    /// kg m, kg m².
    pub(crate) fn rigid_inertia(&self, tower: &Tower, rotary_inertia: bool) -> SpatialMatrix {
        let mut sum = tower.rigid_inertia(rotary_inertia);
        if let Some(on_frame) = &self.on_frame {
            add_scaled(&mut sum, 1.0, &on_frame.rigid_inertia_of_frame());
        }
        sum
    }

    /// The motions for which the frame under the tower is a mechanism, if it is one.
    pub(crate) fn frame_mechanism(&self) -> Option<FrameSolveError> {
        self.on_frame.as_ref().and_then(OnFrame::mechanism)
    }

    /// The shape of the frame under the tower in a vector, divided by a size; none without one.
    pub(crate) fn frame_shape(&self, vector: &[f64], size: f64) -> Option<FrameShape> {
        self.on_frame.as_ref()?.shape(vector, size)
    }

    /// The error of the frame under the tower, if it has no equations.
    pub(crate) fn take_frame_error(&mut self) -> Option<FrameSolveError> {
        self.frame_error.take()
    }

    /// Assembles a tower as beams.
    pub(crate) fn assemble_beams(&mut self, tower: &Tower, mesh: &Mesh, recipe: BeamRecipe) {
        self.restart(tower.base_m());
        let Self {
            beam_memory, beams, ..
        } = self;
        assemble_beams(tower, mesh, recipe, beam_memory, beams);
        self.put_on_frame(
            tower,
            recipe.degree().map_or(FRAME_DEGREE, |degree| degree.max(4)),
        );
    }

    /// Assembles a rotating blade with elements between these fractions of its span.
    pub(crate) fn assemble_blade(&mut self, blade: &Blade, borders: &[f64]) {
        self.restart(blade.description().hub_radius_m);
        assemble_blade(blade, borders, &mut self.beams);
    }

    fn restart(&mut self, base_m: f64) {
        self.chains.release();
        self.beams.release();
        if let Some(on_frame) = self.on_frame.take() {
            self.bare_frame = Some(on_frame.into_bare());
        }
        self.frame_error = None;
        self.base_m = base_m;
        self.origin = 0.0;
    }

    /// Number of subsystems; two equal bending planes are one subsystem.
    pub(crate) fn count(&self) -> usize {
        let parts = self.chains.members().len() + self.beams.members().len();
        parts + usize::from(self.on_frame.is_some())
    }

    /// A subsystem; the first one has the bending in the fore-aft plane.
    pub(crate) fn subsystem(&self, index: usize) -> &dyn Subsystem {
        if let Some(on_frame) = &self.on_frame {
            return on_frame;
        }
        let (chains, beams) = (self.chains.members(), self.beams.members());
        match index.checked_sub(chains.len()) {
            None => &*chains[index],
            Some(index) => &*beams[index],
        }
    }

    /// As above, mutable.
    fn subsystem_mut(&mut self, index: usize) -> &mut dyn Subsystem {
        subsystem_mut(&mut self.chains, &mut self.beams, &mut self.on_frame, index)
    }

    /// The eigenvalue problem of a subsystem.
    pub(crate) fn pencil(&mut self, index: usize, problem: Eigenproblem) -> SubsystemPencil<'_> {
        let subsystem = subsystem_mut(&mut self.chains, &mut self.beams, &mut self.on_frame, index);
        SubsystemPencil::new(subsystem, problem).observed_by(self.monitor.observer())
    }

    /// The free vibration of a subsystem, from the [origin](Self::origin) of the spectrum.
    pub(crate) fn vibration(&mut self, index: usize) -> SubsystemPencil<'_> {
        let origin = self.origin;
        self.pencil(index, Eigenproblem::Vibration { origin })
    }

    /// How many times each mode of a subsystem is in the spectrum.
    pub(crate) fn multiplicity(&self, index: usize) -> usize {
        match self.chains.members().is_empty() {
            _ if self.on_frame.is_some() => 1,
            true => self.beams.multiplicity(index),
            false => self.chains.multiplicity(index),
        }
    }

    /// The motions of a subsystem.
    pub(crate) fn motions(&self, index: usize) -> Motions {
        self.subsystem(index).motions()
    }

    /// Whether a subsystem has a single motion, which then has all the energy.
    pub(crate) fn has_single_motion(&self, index: usize) -> bool {
        self.motions(index).only_one().is_some()
    }

    /// Unknowns of the whole model; an equal plane is counted twice.
    pub(crate) fn degrees_of_freedom(&self) -> usize {
        (0..self.count())
            .map(|index| self.multiplicity(index) * self.subsystem(index).degrees_of_freedom())
            .sum()
    }

    /// Whether no number overflowed.
    pub(crate) fn is_finite(&self) -> bool {
        (0..self.count()).all(|index| self.subsystem(index).is_finite())
    }

    /// The resultant and the energy of a matrix A and an eigenvector of a subsystem.
    pub(crate) fn resultant(
        &mut self,
        index: usize,
        a: &Coefficients,
        vector: &[f64],
    ) -> Resultant {
        let base_m = self.base_m;
        self.subsystem_mut(index).resultant(a, vector, base_m)
    }

    /// xᵀ A x of a vector of a subsystem for each of its matrices.
    pub(crate) fn energies(&mut self, index: usize, vector: &[f64]) -> Energies {
        self.subsystem_mut(index).energies(vector)
    }

    /// The forces and the energy of an eigenvector of a subsystem.
    pub(super) fn modal_forces(&mut self, index: usize, vector: &[f64]) -> ModalForces {
        // A single motion has all the energy, whatever its amount.
        let (resultant, strain) = if self.has_single_motion(index) {
            (self.resultant(index, &Coefficients::MASS, vector), None)
        } else {
            let base_m = self.base_m;
            let subsystem = self.subsystem_mut(index);
            let (resultant, strain) = subsystem.modal_resultant(vector, base_m);
            (resultant, Some(strain))
        };
        let on_frame = self.on_frame.as_mut();
        ModalForces {
            local: on_frame.and_then(|on_frame| on_frame.local_shares(vector)),
            force: resultant.force,
            kinetic: ByMotion::sums(resultant.energy),
            strain: strain.map(ByMotion::sums),
        }
    }
}

fn subsystem_mut<'a>(
    chains: &'a mut Chains,
    beams: &'a mut Beams,
    on_frame: &'a mut Option<OnFrame>,
    index: usize,
) -> &'a mut dyn Subsystem {
    if let Some(on_frame) = on_frame {
        return on_frame;
    }
    match index.checked_sub(chains.members().len()) {
        None => &mut *chains.members_mut()[index],
        Some(index) => &mut *beams.members_mut()[index],
    }
}

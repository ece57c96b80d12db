//! A tower as eigenvalue problems of independent parts, whatever the method.

use super::options::Options;
use super::watch::Watch;
use crate::beam::{BeamRecipe, BeamWorkspace, Beams, assemble_beams};
use crate::chain::Chains;
use crate::eigen::Pencil;
use crate::elements::{Mesh, assemble};
use crate::modes::{BeamCurves, ByMotion, ChainCurves, SegmentCurves};
use crate::parts::{
    Balance, Combination, Kind, Part, Parts, Problem, Structure, embedded, on_components,
};
use crate::tower::{Motions, Tower};

/// Where a tower is cut, and how finely each part is represented.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cut {
    pub(super) mesh: Mesh,
    /// Polynomial degree of the spectral beam; the other methods have their own.
    pub(super) degree: usize,
}

/// The eigenvalue problems of a tower, with the memory to work on them.
#[derive(Default)]
pub(super) struct Model {
    is_chain: bool,
    chains: Parts<Chains>,
    beams: Parts<Beams>,
    assembly: BeamWorkspace,
    /// Where the spectrum begins, rad²/s²: 0, or below where nothing holds a floating tower in some
    /// direction.
    pub(super) origin: f64,
    /// Who is told what is done with it.
    pub(super) watch: Watch,
}

impl std::fmt::Debug for Model {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Model").finish_non_exhaustive()
    }
}

/// Runs the same code on the parts, whatever they are made of.
macro_rules! on_parts {
    ($model:expr, $parts:ident => $act:expr) => {
        if $model.is_chain {
            let $parts = &$model.chains;
            $act
        } else {
            let $parts = &$model.beams;
            $act
        }
    };
}

/// The forces and the energy of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Resultants {
    /// Products of the inertia forces with rigid motions (x, y, z, rotation about x, y, z) about
    /// the base.
    pub(super) force: [f64; 6],
    /// Kinetic energy, times 2/ω².
    pub(super) kinetic: ByMotion,
    /// Strain energy, times 2; none for a part of one motion, which has all of it.
    pub(super) strain: Option<ByMotion>,
}

impl Model {
    /// Makes the problems of a tower cut as told.
    pub(super) fn assemble(&mut self, tower: &Tower, cut: &Cut, options: &Options) {
        match options.method.element() {
            Some(element) => {
                self.is_chain = true;
                self.origin = 0.0;
                assemble(tower, &cut.mesh, &options.recipe(element), &mut self.chains);
            }
            None => self.assemble_beams(tower, &cut.mesh, options.beam_recipe(cut.degree)),
        }
    }

    /// Makes the problems of a tower as beams.
    pub(super) fn assemble_beams(&mut self, tower: &Tower, mesh: &Mesh, recipe: BeamRecipe) {
        self.is_chain = false;
        self.origin = 0.0;
        let Self {
            assembly, beams, ..
        } = self;
        assemble_beams(tower, mesh, recipe, assembly, beams);
    }

    pub(super) fn degrees_of_freedom(&self) -> usize {
        on_parts!(self, parts => parts.degrees_of_freedom())
    }

    /// Whether no number overflowed.
    pub(super) fn is_finite(&self) -> bool {
        on_parts!(self, parts => parts.is_finite())
    }

    /// Number of parts: those that are solved, an equal plane once.
    pub(super) fn parts(&self) -> usize {
        on_parts!(self, parts => parts.count())
    }

    /// How many times the modes of a part are there.
    pub(super) fn multiplicity(&self, part: usize) -> usize {
        on_parts!(self, parts => parts.multiplicity(part))
    }

    /// The motions of a part.
    pub(super) fn motions(&self, part: usize) -> Motions {
        on_parts!(self, parts => parts.part(part).motions())
    }

    /// Lets `act` work on the vibration problem of a part.
    pub(super) fn with_pencil<R>(
        &mut self,
        part: usize,
        act: impl FnOnce(&mut dyn Pencil) -> R,
    ) -> R {
        let origin = self.origin;
        self.with_problem(part, Problem::Vibration { origin }, None, act)
    }

    /// Lets `act` work on any problem of a part, iterations beginning with a vector if one is
    /// known.
    pub(super) fn with_problem<R>(
        &mut self,
        part: usize,
        problem: Problem,
        first: Option<&[f64]>,
        act: impl FnOnce(&mut dyn Pencil) -> R,
    ) -> R {
        let watch = &mut self.watch;
        let watched = |pencil: &mut dyn Pencil| watch.over(pencil, act);
        if self.is_chain {
            let part = self.chains.part_mut(part);
            part.with_pencil_beginning(problem, first, watched)
        } else {
            let part = self.beams.part_mut(part);
            part.with_pencil_beginning(problem, first, watched)
        }
    }

    /// An eigenvector of a part as curves over the segments.
    pub(super) fn curves<'a>(
        &self,
        tower: &'a Tower,
        mesh: &'a Mesh,
        part: usize,
        vector: &[f64],
    ) -> Box<dyn SegmentCurves + 'a> {
        if self.is_chain {
            Box::new(ChainCurves::new(
                tower,
                mesh,
                self.chains.part(part),
                vector,
            ))
        } else {
            Box::new(BeamCurves::new(self.beams.part(part), vector))
        }
    }

    /// The forces and the energy of an eigenvector of a part.
    pub(super) fn resultants(&mut self, tower: &Tower, part: usize, vector: &[f64]) -> Resultants {
        let base_m = tower.base_m();
        if self.is_chain {
            resultants(self.chains.part_mut(part), vector, base_m)
        } else {
            resultants(self.beams.part_mut(part), vector, base_m)
        }
    }
}

fn resultants<K: Kind>(part: &mut Part<K>, vector: &[f64], base_m: f64) -> Resultants {
    let is_single = part.motions().iter().nth(1).is_none();
    on_components!(part, member, components => {
        let (structure, work) = (&member.structure, &mut member.work);
        let mut balance = |combination| structure.balance(&combination, work, vector, base_m);
        let Balance { force, energy } = balance(Combination::MASS);
        // Where there is but one motion all energy is its own, whatever its size.
        let strain = if is_single {
            None
        } else {
            Some(balance(Combination::STIFFNESS).energy)
        };
        // Energies have no sign of a direction.
        let unsigned = components.map(|(i, _)| (i, 1.0));
        Resultants {
            force: embedded(&force, &components),
            kinetic: ByMotion::sums(embedded(&energy, &unsigned)),
            strain: strain.map(|energy| ByMotion::sums(embedded(&energy, &unsigned))),
        }
    })
}

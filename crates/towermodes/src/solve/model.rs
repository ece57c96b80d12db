//! A tower as one eigenvalue problem a family, whatever the method.

use super::options::Options;
use crate::beam::{BeamPencil, BeamPencilWorkspace, BeamWorkspace, DecoupledBeams, assemble_beams};
use crate::chain::{ChainPencil, ChainWorkspace, DecoupledChains};
use crate::eigen::Pencil;
use crate::elements::{Mesh, assemble};
use crate::modes::{BeamCurves, ChainCurves, ChainCurvesWorkspace, Family, SegmentCurves};
use crate::tower::{Plane, Tower};

/// All families, in the order in which modes of one frequency are listed.
pub(super) const FAMILIES: [Family; 4] = [
    Family::ForeAft,
    Family::SideSide,
    Family::Torsion,
    Family::Axial,
];

/// Where a tower is cut, and how finely each part is represented.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cut {
    pub(super) mesh: Mesh,
    /// Polynomial degree of the spectral beam; the other methods have their own.
    pub(super) degree: usize,
}

/// The eigenvalue problems of a tower, with the memory to work on them.
#[derive(Debug, Default)]
pub(super) struct Model {
    is_chain: bool,
    chains: DecoupledChains,
    planar: ChainWorkspace<2>,
    linear: ChainWorkspace<1>,
    chain_curves: ChainCurvesWorkspace,
    beams: DecoupledBeams,
    assembly: BeamWorkspace,
    beam: BeamPencilWorkspace,
}

impl Model {
    /// Makes the problems of a tower cut as told.
    pub(super) fn assemble(&mut self, tower: &Tower, cut: &Cut, options: &Options) {
        self.is_chain = options.method.element().is_some();
        match options.method.element() {
            Some(element) => {
                assemble(tower, &cut.mesh, &options.recipe(element), &mut self.chains);
            }
            None => {
                let recipe = options.beam_recipe(cut.degree);
                let Self {
                    assembly, beams, ..
                } = self;
                assemble_beams(tower, &cut.mesh, recipe, assembly, beams);
            }
        }
    }

    pub(super) fn planes_are_equal(&self) -> bool {
        if self.is_chain {
            self.chains.planes_are_equal()
        } else {
            self.beams.planes_are_equal()
        }
    }

    pub(super) fn degrees_of_freedom(&self) -> usize {
        if self.is_chain {
            self.chains.degrees_of_freedom()
        } else {
            self.beams.degrees_of_freedom()
        }
    }

    /// Whether no number overflowed.
    pub(super) fn is_finite(&self) -> bool {
        if self.is_chain {
            self.chains.is_finite()
        } else {
            self.beams.is_finite()
        }
    }

    /// The families that are solved: an equal plane once.
    pub(super) fn families(&self) -> &'static [Family] {
        if self.planes_are_equal() {
            &[Family::ForeAft, Family::Torsion, Family::Axial]
        } else {
            &FAMILIES
        }
    }

    /// How many times the modes of a family are there.
    pub(super) fn multiplicity(&self, family: Family) -> usize {
        1 + usize::from(family == Family::ForeAft && self.planes_are_equal())
    }

    /// Lets `act` work on the eigenvalue problem of a family.
    pub(super) fn with_pencil<R>(
        &mut self,
        family: Family,
        act: impl FnOnce(&mut dyn Pencil) -> R,
    ) -> R {
        if self.is_chain {
            let (chains, planar, linear) = (&self.chains, &mut self.planar, &mut self.linear);
            match family {
                Family::ForeAft => act(&mut ChainPencil::new(&chains.fore_aft, planar)),
                Family::SideSide => act(&mut ChainPencil::new(&chains.side_side, planar)),
                Family::Torsion => act(&mut ChainPencil::new(&chains.torsion, linear)),
                Family::Axial => act(&mut ChainPencil::new(&chains.axial, linear)),
            }
        } else {
            let (beams, work) = (&self.beams, &mut self.beam);
            match family {
                Family::ForeAft => act(&mut BeamPencil::new(&beams.fore_aft, work)),
                Family::SideSide => act(&mut BeamPencil::new(&beams.side_side, work)),
                Family::Torsion => act(&mut BeamPencil::new(&beams.torsion, work)),
                Family::Axial => act(&mut BeamPencil::new(&beams.axial, work)),
            }
        }
    }

    /// An eigenvector of a family as curves over the segments.
    pub(super) fn curves<'a>(
        &'a mut self,
        tower: &'a Tower,
        mesh: &'a Mesh,
        family: Family,
        vector: &[f64],
    ) -> Box<dyn SegmentCurves + 'a> {
        let (chains, work, beams) = (&self.chains, &mut self.chain_curves, &self.beams);
        let bent = |plane, chain, work| {
            Box::new(ChainCurves::bending(
                tower, plane, mesh, chain, vector, work,
            ))
        };
        match (family, self.is_chain) {
            (Family::ForeAft, true) => bent(Plane::ForeAft, &chains.fore_aft, work),
            (Family::SideSide, true) => bent(Plane::SideSide, &chains.side_side, work),
            (Family::Torsion, true) => {
                Box::new(ChainCurves::axial(mesh, &chains.torsion, vector, work))
            }
            (Family::Axial, true) => {
                Box::new(ChainCurves::axial(mesh, &chains.axial, vector, work))
            }
            (Family::ForeAft, false) => Box::new(BeamCurves::new(&beams.fore_aft, vector)),
            (Family::SideSide, false) => Box::new(BeamCurves::new(&beams.side_side, vector)),
            (Family::Torsion, false) => Box::new(BeamCurves::new(&beams.torsion, vector)),
            (Family::Axial, false) => Box::new(BeamCurves::new(&beams.axial, vector)),
        }
    }
}

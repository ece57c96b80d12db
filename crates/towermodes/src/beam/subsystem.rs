//! A beam as a subsystem, and the beams of a tower.

use super::curves::BeamCurves;
use super::element::{Slice, Stencil};
use super::elimination::{self, Factors};
use super::general::GeneralElement;
use super::model::Beam;
use super::product;
use super::strain::{Strain, deformations};
use super::substitution;
use crate::space::SpatialMatrix;
use crate::subsystem::{
    Branch, Coefficients, Coordinates, MatrixKind, Resultant, SegmentCurves, ShearFraction,
    Subsystem, Subsystems, dimension,
};
use crate::tower::{Motion, Motions, Tower};

/// A subsystem that is a beam of flexible elements in D components.
#[derive(Debug)]
pub struct BeamSubsystem<const D: usize> {
    coordinates: Coordinates<D>,
    beam: Beam<D>,
    loads: Vec<f64>,
    factors: Factors,
}

impl<const D: usize> BeamSubsystem<D> {
    /// An empty beam for motions whose [`dimension`] is D.
    pub fn new(motions: Motions) -> Self {
        Self {
            coordinates: Coordinates::new(motions),
            beam: Beam::default(),
            loads: Vec::new(),
            factors: Factors::default(),
        }
    }

    /// The beam.
    pub(super) fn beam(&self) -> &Beam<D> {
        &self.beam
    }
}

/// The beam of a tower in which all motions are coupled.
pub(crate) type SpaceBeam = Subsystems<BeamSubsystem<6>>;

impl<const D: usize> Subsystem for BeamSubsystem<D> {
    fn motions(&self) -> Motions {
        self.coordinates.motions()
    }

    fn degrees_of_freedom(&self) -> usize {
        self.beam.degrees_of_freedom()
    }

    fn is_finite(&self) -> bool {
        self.beam.is_finite()
    }

    fn clear(&mut self) {
        self.beam.clear();
    }

    fn add_base(&mut self, height_m: f64, unit: &[f64; 6]) {
        let unit = self.coordinates.restrict_moving(unit);
        self.beam.add_base(height_m, unit);
    }

    fn add(&mut self, kind: MatrixKind, reference_m: f64, matrix: &SpatialMatrix) {
        let matrix = self.coordinates.restrict(matrix);
        self.beam.add(kind, reference_m, matrix);
    }

    fn add_geometric_stiffness(&mut self, moment_n_m: f64) {
        self.beam.add_geometric_stiffness(moment_n_m);
    }

    fn is_identity(&self, a: &Coefficients) -> bool {
        self.beam.is_identity(a)
    }

    fn product(&mut self, a: &Coefficients, x: &[f64], out: &mut [f64]) {
        product::product(&self.beam, a, &mut self.loads, x, out);
    }

    fn count_negative(&mut self, a: &Coefficients) -> usize {
        elimination::count_negative(&self.beam, a, &mut self.factors)
    }

    fn factorize(&mut self, a: &Coefficients) -> usize {
        elimination::factorize(&self.beam, a, &mut self.factors)
    }

    fn solve(&mut self, x: &mut [f64]) {
        substitution::solve(&self.beam, &mut self.factors, x);
    }

    fn energy(&mut self, a: &Coefficients, x: &[f64]) -> f64 {
        let (_, energy) = product::resultant(&self.beam, a, &mut self.loads, x);
        energy.iter().sum()
    }

    fn strain_energies(&self, x: &[f64], part: &mut dyn FnMut(f64, f64)) {
        let own = &x[self.beam.base_coordinates()..];
        let of_elements = own.chunks_exact(self.beam.coordinates().max(1));
        for (element, own) in of_elements.enumerate() {
            let energy = own.iter().map(|x| x * x).sum();
            part(self.beam.middle_m(element), energy);
        }
    }

    fn resultant(&mut self, a: &Coefficients, x: &[f64], _: f64) -> Resultant {
        let (force, energy) = product::resultant(&self.beam, a, &mut self.loads, x);
        Resultant {
            force: self.coordinates.expand(&force),
            energy: self.coordinates.expand_unsigned(&energy),
        }
    }

    fn start(&mut self, out: &mut [f64]) {
        product::base_excitation(&self.beam, &mut self.loads, out);
    }

    fn branch(&self) -> Option<Branch> {
        (D == 6).then(|| self.beam.branch())
    }

    fn curves<'a>(
        &self,
        _: &'a [f64],
        _: &'a ShearFraction<'a>,
        vector: &[f64],
    ) -> Box<dyn SegmentCurves + 'a> {
        Box::new(BeamCurves::new(&self.beam, &self.coordinates, vector))
    }
}

/// How a subsystem is made of flexible elements.
pub trait BeamAssembly: Subsystem {
    /// Sets, for the following elements, the number of coordinates of each strain.
    fn set_strains(&mut self, count: &dyn Fn(Strain) -> usize);

    /// Adds an element with these sections.
    fn add_element(&mut self, stencil: &mut Stencil, slice: &Slice<'_>);

    /// Adds an element whose strains are coupled.
    fn add_general_element(&mut self, stencil: &mut Stencil, element: &GeneralElement<'_>);
}

impl<const D: usize> BeamAssembly for BeamSubsystem<D> {
    fn set_strains(&mut self, count: &dyn Fn(Strain) -> usize) {
        let (motions, components) = (self.coordinates.motions(), self.coordinates.components());
        let own = deformations(motions, components, count);
        self.beam.set_deformations(own);
    }

    fn add_element(&mut self, stencil: &mut Stencil, slice: &Slice<'_>) {
        stencil.add_element(&mut self.beam, self.coordinates.components(), slice);
    }

    fn add_general_element(&mut self, stencil: &mut Stencil, element: &GeneralElement<'_>) {
        stencil.add_general_element(&mut self.beam, &self.coordinates, element);
    }
}

/// The beams of a tower or of a blade.
pub type Beams = Subsystems<dyn BeamAssembly>;

fn new_beam(motions: Motions) -> Box<dyn BeamAssembly> {
    match dimension(motions) {
        1 => Box::new(BeamSubsystem::<1>::new(motions)),
        2 => Box::new(BeamSubsystem::<2>::new(motions)),
        3 => Box::new(BeamSubsystem::<3>::new(motions)),
        _ => Box::new(BeamSubsystem::<6>::new(motions)),
    }
}

impl Beams {
    /// Begins with the base of a tower.
    pub(crate) fn begin(&mut self, tower: &Tower) {
        self.restart(tower, new_beam);
    }

    /// Begins with one clamped beam in which all motions are coupled.
    pub(crate) fn begin_coupled(&mut self) {
        let all = Motion::ALL.into_iter().map(Motions::only);
        let all = all.fold(Motions::default(), Motions::and);
        self.restart_with(std::iter::once(all), new_beam);
    }
}

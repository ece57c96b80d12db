//! A chain as a subsystem, and the chains of a tower.

use super::articulated;
use super::curves::ChainCurves;
use super::energies;
use super::inverse_step::{LanesWorkspace, StepWorkspace, inverse_step, inverse_steps};
use super::joint::JointFlexibility;
use super::model::Chain;
use super::product;
use super::transfer;
use crate::lanes::LANES;
use crate::space::SpatialMatrix;
use crate::subsystem::{
    Branch, Coefficients, Coordinates, Energies, InternalForces, JointState, MatrixKind, Resultant,
    SegmentCurves, ShearFraction, Subsystem, Subsystems, dimension,
};
use crate::tower::{Axisymmetric, Motions, Tower};

/// A subsystem that is a chain of rigid bodies and elastic joints in D components.
#[derive(Debug)]
pub struct ChainSubsystem<const D: usize> {
    coordinates: Coordinates<D>,
    chain: Chain<D>,
    work: StepWorkspace<D, f64>,
    work_of_lanes: LanesWorkspace<D>,
}

impl<const D: usize> ChainSubsystem<D> {
    /// A chain for motions whose number of components is D.
    pub fn new(motions: Motions, chain: Chain<D>) -> Self {
        Self {
            coordinates: Coordinates::new(motions),
            chain,
            work: StepWorkspace::default(),
            work_of_lanes: LanesWorkspace::default(),
        }
    }
}

impl<const D: usize> Subsystem for ChainSubsystem<D> {
    fn motions(&self) -> Motions {
        self.coordinates.motions()
    }

    fn degrees_of_freedom(&self) -> usize {
        self.chain.degrees_of_freedom()
    }

    fn is_finite(&self) -> bool {
        self.chain.is_finite()
    }

    fn clear(&mut self) {
        self.chain.clear();
    }

    fn add_base(&mut self, height_m: f64, unit: &[f64; 6]) {
        let unit = self.coordinates.restrict_moving(unit);
        self.chain.add_base(height_m, unit);
    }

    fn add(&mut self, kind: MatrixKind, reference_m: f64, matrix: &SpatialMatrix) {
        let matrix = self.coordinates.restrict(matrix);
        self.chain.add(kind, reference_m, matrix);
    }

    fn add_geometric_stiffness(&mut self, moment_n_m: f64) {
        self.chain.add_geometric_stiffness(moment_n_m);
    }

    fn branch(&self) -> Option<Branch> {
        (D == 6).then(|| self.chain.branch())
    }

    fn is_identity(&self, a: &Coefficients) -> bool {
        self.chain.is_identity(a)
    }

    fn product(&mut self, a: &Coefficients, x: &[f64], out: &mut [f64]) {
        product::product(&self.chain, a, &mut self.work.loads, x, out);
    }

    fn count_negative(&mut self, a: &Coefficients) -> usize {
        articulated::count_negative(&self.chain, a)
    }

    fn factorize(&mut self, a: &Coefficients) -> usize {
        articulated::factorize(&self.chain, a, &mut self.work.factors)
    }

    fn solve(&mut self, x: &mut [f64]) {
        articulated::solve(&self.chain, &self.work.factors, x);
    }

    fn inverse_step(
        &mut self,
        a: Option<&Coefficients>,
        x: &mut [f64],
    ) -> Option<(usize, Energies)> {
        Some(inverse_step(&self.chain, a, &mut self.work, x))
    }

    fn inverse_steps(
        &mut self,
        a: &[Coefficients; LANES],
        x: [Option<&mut [f64]>; LANES],
    ) -> Option<[(usize, Energies); LANES]> {
        inverse_steps(&self.chain, a, &mut self.work_of_lanes, x)
    }

    fn energy(&mut self, a: &Coefficients, x: &[f64]) -> f64 {
        energies::energy(&self.chain, a, x)
    }

    fn energies(&mut self, x: &[f64]) -> Energies {
        energies::energies(&self.chain, x)
    }

    fn strain_energies(&self, x: &[f64], part: &mut dyn FnMut(f64, f64)) {
        energies::strain_energies(&self.chain, x, part);
    }

    fn internal_forces(&self, x: &[f64], forces: &mut InternalForces) -> bool {
        transfer::internal_forces(&self.chain, x, forces);
        true
    }

    fn with_internal_forces(&self, forces: &InternalForces, jumps_m: &[f64], out: &mut [f64]) {
        transfer::with_internal_forces(&self.chain, forces, jumps_m, out);
    }

    fn joint_states(&self, lambda: f64, x: &[f64], states: &mut Vec<JointState>) -> bool {
        super::states::joint_states(&self.chain, &self.coordinates, lambda, x, states);
        true
    }

    fn resultant(&mut self, a: &Coefficients, x: &[f64], base_m: f64) -> Resultant {
        let (force, energy) = energies::resultant(&self.chain, a, x, base_m);
        Resultant {
            force: self.coordinates.expand(&force),
            energy: self.coordinates.expand_unsigned(&energy),
        }
    }

    fn modal_resultant(&mut self, x: &[f64], base_m: f64) -> (Resultant, [f64; 6]) {
        let (force, kinetic, strain) = energies::modal_resultant(&self.chain, x, base_m);
        let kinetic = Resultant {
            force: self.coordinates.expand(&force),
            energy: self.coordinates.expand_unsigned(&kinetic),
        };
        (kinetic, self.coordinates.expand_unsigned(&strain))
    }

    fn start(&mut self, out: &mut [f64]) {
        product::base_excitation(&self.chain, out);
    }

    fn curves<'a>(
        &self,
        borders_m: &'a [f64],
        shear: &'a ShearFraction<'a>,
        vector: &[f64],
    ) -> Box<dyn SegmentCurves + 'a> {
        let Self {
            chain, coordinates, ..
        } = self;
        Box::new(ChainCurves::new(
            borders_m,
            shear,
            chain,
            coordinates,
            vector,
        ))
    }
}

/// How a subsystem is made of rigid bodies and joints.
pub trait ChainAssembly: Subsystem {
    /// Reserves memory for `joints` joints.
    fn reserve(&mut self, joints: usize);

    /// Adds the matrix of a piece of tower, given for the motion of the point at `reference_m` (m),
    /// to what was added last.
    fn add_axisymmetric(&mut self, kind: MatrixKind, reference_m: f64, matrix: &Axisymmetric);

    /// Adds a joint at a height (m) under a compression (N), with the flexibility of each component
    /// (x, y, z, rotation about x, y, z); see [`Chain::add_joint`].
    fn add_joint(&mut self, height_m: f64, flexibility: &[f64; 6], compression_n: f64);
}

impl<const D: usize> ChainAssembly for ChainSubsystem<D> {
    fn reserve(&mut self, joints: usize) {
        self.chain.reserve(joints);
    }

    fn add_axisymmetric(&mut self, kind: MatrixKind, reference_m: f64, matrix: &Axisymmetric) {
        let matrix = self.coordinates.restrict_axisymmetric(matrix);
        self.chain.add(kind, reference_m, matrix);
    }

    fn add_joint(&mut self, height_m: f64, flexibility: &[f64; 6], compression_n: f64) {
        let flexibility = self.coordinates.restrict_moving(flexibility);
        self.chain.add_joint(height_m, flexibility, compression_n);
    }
}

/// The chains of a tower.
pub type Chains = Subsystems<dyn ChainAssembly>;

impl Chains {
    /// Begins with the base of a tower, and with memory for `joints` joints.
    pub(crate) fn begin(&mut self, tower: &Tower, joints: usize) {
        self.restart(tower, |motions| match dimension(motions) {
            1 => Box::new(ChainSubsystem::<1>::new(motions, Chain::default())),
            2 => Box::new(ChainSubsystem::<2>::new(motions, Chain::default())),
            3 => Box::new(ChainSubsystem::<3>::new(motions, Chain::default())),
            _ => Box::new(ChainSubsystem::<6>::new(motions, Chain::default())),
        });
        for chain in self.members_mut() {
            chain.reserve(joints);
        }
    }

    /// Adds the matrix of a piece of tower, given for the motion of the point at `reference_m` (m),
    /// to what was added last.
    pub(crate) fn add_axisymmetric(
        &mut self,
        kind: MatrixKind,
        reference_m: f64,
        matrix: &Axisymmetric,
    ) {
        for chain in self.members_mut() {
            chain.add_axisymmetric(kind, reference_m, matrix);
        }
    }

    /// Adds a joint at a height (m) under a compression (N); see [`Chain::add_joint`].
    pub(crate) fn add_joint(
        &mut self,
        height_m: f64,
        joint: &JointFlexibility,
        compression_n: f64,
    ) {
        let flexibility = joint.spatial();
        for chain in self.members_mut() {
            chain.add_joint(height_m, &flexibility, compression_n);
        }
    }
}

//! A beam in space with a complex matrix at its top: eigenvalue count, solution, products, and the
//! curve of its axis in phasors.

use super::blade::phasors::{InertiaMatrix, Loads, inertia_loads, motions_along};
use super::elimination::{Factors, count_negative_between, factorize_between};
use super::model::GEOMETRIC;
use super::product::{base_motion, sweep_down};
use super::strain::Strain;
use super::substitution::solve_under;
use super::subsystem::BeamSubsystem;
use crate::scalar::{Complex, Number, Scalar};
use crate::space::{SpatialMatrix, SquareMatrix};
use crate::subsystem::Coefficients;
use crate::tower::Plane;

/// Factors of a beam with the matrix at its top, and working memory.
#[derive(Debug, Clone, Default)]
pub(crate) struct TopWorkspace {
    factors: Factors<Complex>,
    loads: Loads,
}

/// Twice the energies of a motion of a beam with its support.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SpaceEnergies {
    /// Strain energies of fore-aft bending, side-side bending, torsion and axial deformation.
    pub(crate) strain: [f64; 4],
    /// Energies of the support of the base, and of gravity in the rigid motion of the base, by
    /// component.
    pub(crate) base: [f64; 6],
    /// Energies of the soil along the beam, and of gravity in the rest of the motion, by component.
    pub(crate) others: [f64; 6],
}

fn add_all(sum: &mut [f64; 6], addend: &[f64; 6], factor: f64) {
    for (sum, addend) in sum.iter_mut().zip(addend) {
        *sum += factor * addend;
    }
}

/// A force or a motion at the top in phasors.
type Phasors = [Complex; 6];

impl BeamSubsystem<6> {
    /// The number of negative eigenvalues of A with a matrix `above` added for the motion of the
    /// top, and one `below` for that of the base.
    pub(crate) fn count_negative_between(
        &self,
        a: &Coefficients,
        (above, below): (SquareMatrix<Complex, 6>, Option<SpatialMatrix>),
        work: &mut TopWorkspace,
    ) -> usize {
        let ends = (above, below.as_ref());
        count_negative_between(self.beam(), a, ends, &mut work.factors)
    }

    /// As above, with the factors that [`solve_under`](Self::solve_under) needs.
    pub(crate) fn factorize_between(
        &self,
        a: &Coefficients,
        (above, below): (SquareMatrix<Complex, 6>, Option<SpatialMatrix>),
        work: &mut TopWorkspace,
    ) -> usize {
        let ends = (above, below.as_ref());
        factorize_between(self.beam(), a, ends, &mut work.factors)
    }

    /// Solves with the last factors and a force at the top; returns the motion of the top.
    pub(crate) fn solve_under(
        &self,
        work: &mut TopWorkspace,
        at_top: Phasors,
        x: &mut [Complex],
    ) -> Phasors {
        solve_under(self.beam(), &mut work.factors, at_top, x)
    }

    /// Begins the product of −2 w M with x: returns the motion of the top and xᴴ M x.
    pub(crate) fn begin_derivative(
        &self,
        frequency: f64,
        x: &[Complex],
        work: &mut TopWorkspace,
    ) -> (Phasors, f64) {
        let a = InertiaMatrix {
            inertia: -2.0 * frequency,
            skew: 0.0,
            coriolis: &[],
        };
        let (of_base, own) = x.split_at(self.beam().base_coordinates());
        let base = base_motion(self.beam(), of_base);
        let (top, mass) = inertia_loads(self.beam(), &a, (base, own), &mut work.loads);
        (top, mass + dot(&base, &self.base_force(&base, 0)))
    }

    /// Ends this product with a force at the top; the product is in `out`.
    pub(crate) fn end_derivative(
        &self,
        frequency: f64,
        at_top: Phasors,
        (x, out): (&[Complex], &mut [Complex]),
        work: &mut TopWorkspace,
    ) {
        let base = base_motion(self.beam(), &x[..self.beam().base_coordinates()]);
        let at_base = self.base_force(&base, 0).map(|f| f.times(-2.0 * frequency));
        sweep_down(self.beam(), (at_base, at_top), &work.loads.loads, out);
    }

    /// The force of one of the matrices of the base for its motion.
    fn base_force(&self, motion: &Phasors, place: usize) -> Phasors {
        let Some(base) = &self.beam().base else {
            return Phasors::default();
        };
        base.matrices[place].map(|row| row.iter().zip(motion).map(|(a, x)| x.times(*a)).sum())
    }

    /// Heights (m) and motions along the beam, this many per element.
    pub(crate) fn motions_along(&self, x: &[Complex], steps: usize) -> Vec<(f64, Phasors)> {
        let (of_base, own) = x.split_at(self.beam().base_coordinates());
        let base = base_motion(self.beam(), of_base);
        motions_along(self.beam(), (base, own), steps)
    }

    /// Twice the energies of a motion.
    pub(crate) fn energies(&self, x: &[Complex]) -> SpaceEnergies {
        let rigid = self.rigid(x);
        let mut base = self.of_matrix(1, &rigid, true);
        add_all(&mut base, &self.of_matrix(GEOMETRIC, &rigid, false), 1.0);
        let mut others = self.of_matrix(1, x, false);
        add_all(&mut others, &self.of_matrix(1, &rigid, true), -1.0);
        add_all(&mut others, &self.of_matrix(GEOMETRIC, x, false), 1.0);
        add_all(&mut others, &self.of_matrix(GEOMETRIC, &rigid, false), -1.0);
        SpaceEnergies {
            strain: self.strain_energies_of(x),
            base,
            others,
        }
    }

    /// Energies of strains in fore-aft bending, side-side bending, torsion and stretch.
    fn strain_energies_of(&self, x: &[Complex]) -> [f64; 4] {
        let beam = self.beam();
        let mut sum = [0.0; 4];
        let own = &x[beam.base_coordinates()..];
        for own in own.chunks_exact(beam.coordinates().max(1)) {
            let mut own = own.iter();
            for deformation in beam.deformations() {
                let strains = own.by_ref().take(deformation.count);
                let energy: f64 = strains.map(|y| y.norm_squared()).sum();
                sum[group(deformation.strain)] += energy;
            }
        }
        sum
    }

    /// The vector with the motion of the base and without deformations.
    fn rigid(&self, x: &[Complex]) -> Vec<Complex> {
        let moving = self.beam().base_coordinates();
        let still = x[moving..].iter().map(|_| Complex::default());
        x[..moving].iter().copied().chain(still).collect()
    }

    /// Adds a force on the base to a right side or a product.
    pub(crate) fn add_to_base(&self, force: &Phasors, x: &mut [Complex]) {
        let Some(base) = &self.beam().base else {
            return;
        };
        for (x, component) in x.iter_mut().zip(base.moving()) {
            *x += force[component].times(base.unit[component]);
        }
    }

    /// The motion of the base.
    pub(crate) fn base_motion(&self, x: &[Complex]) -> Phasors {
        base_motion(self.beam(), &x[..self.beam().base_coordinates()])
    }

    /// The number of negative eigenvalues of the stiffness of the beam without its surroundings,
    /// with a small multiple of its inertia (1/s²), so that motions without stiffness do not count,
    /// and with a matrix `below` for the motion of the base.
    pub(crate) fn negative_stiffness(&self, inertia: f64, below: Option<SpatialMatrix>) -> usize {
        let a = Coefficients::STIFFNESS.minus(-inertia, Coefficients::MASS);
        let mut work = Factors::<f64>::default();
        let ends = ([[0.0; 6]; 6], below.as_ref());
        count_negative_between(self.beam(), &a, ends, &mut work)
    }

    /// Number of elements.
    pub(crate) fn elements(&self) -> usize {
        self.beam().elements()
    }

    /// Number of coordinates of a base that moves.
    pub(crate) fn base_coordinates(&self) -> usize {
        self.beam().base_coordinates()
    }

    /// xᴴ A x by component, for the base and one of the matrices of the elements, or the base
    /// alone.
    fn of_matrix(&self, place: usize, x: &[Complex], base_alone: bool) -> [f64; 6] {
        let base = self.base_motion(x);
        let force = self.base_force(&base, place);
        let mut sum: [f64; 6] = std::array::from_fn(|c| (base[c].conj() * force[c]).re);
        if !base_alone {
            self.element_energies(place, x, |component, x, force| {
                sum[component] += (x.conj() * force).re;
            });
        }
        sum
    }

    /// Passes the motions of the elements and the forces of one of their matrices, by component.
    fn element_energies(
        &self,
        place: usize,
        x: &[Complex],
        mut add: impl FnMut(usize, Complex, Complex),
    ) {
        let beam = self.beam();
        let (rows, matrices) = (beam.rows(), &beam.matrices[place]);
        if matrices.is_empty() {
            return;
        }
        let (of_base, own) = x.split_at(beam.base_coordinates());
        let base = base_motion(beam, of_base);
        super::product::sweep_up(beam, base, own, |element, motion, own| {
            let from = element * rows * rows;
            let Some(matrix) = matrices.get(from..from + rows * rows) else {
                return;
            };
            let all = || motion.iter().chain(own);
            let components = self.components_of_rows();
            for (row, (component, x)) in matrix.chunks_exact(rows).zip(components.zip(all())) {
                let force = row.iter().zip(all()).map(|(a, x)| x.times(*a)).sum();
                add(component, *x, force);
            }
        });
    }

    /// The component of the motion of each row of an element's matrices.
    fn components_of_rows(&self) -> impl Iterator<Item = usize> {
        let own = self.beam().deformations().iter().flat_map(|deformation| {
            let component = [4, 3, 5, 2][group(deformation.strain)];
            std::iter::repeat_n(component, deformation.count)
        });
        (0..6).chain(own)
    }
}

/// The place of a strain among fore-aft, side-side, torsion and stretch.
fn group(strain: Strain) -> usize {
    match strain {
        Strain::Curvature(Plane::ForeAft) | Strain::Shear(Plane::ForeAft) => 0,
        Strain::Curvature(Plane::SideSide) | Strain::Shear(Plane::SideSide) => 1,
        Strain::Twist => 2,
        Strain::Stretch => 3,
    }
}

fn dot(a: &Phasors, b: &Phasors) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a.conj() * *b).re).sum()
}

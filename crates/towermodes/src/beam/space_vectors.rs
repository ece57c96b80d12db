//! A beam in space with something complex on its top: count, solution, products and the curve of
//! its axis in phasors.

use super::elimination::{Factors, count_negative_under, factorize_under};
use super::phasors::{InertiaMatrix, Loads, inertia_loads, motions_along};
use super::product::{base_motion, sweep_down};
use super::strain::Strain;
use super::substitution::solve_under;
use super::subsystem::BeamSubsystem;
use crate::scalar::{Complex, Scalar};
use crate::space::SquareMatrix;
use crate::subsystem::Coefficients;
use crate::tower::Plane;

/// Factors of a beam with what is on its top, and working memory.
#[derive(Debug, Clone, Default)]
pub(crate) struct TopWorkspace {
    factors: Factors<Complex>,
    loads: Loads,
}

/// A force or a motion at the top in phasors.
type Phasors = [Complex; 6];

impl BeamSubsystem<6> {
    /// The number of negative eigenvalues of A with a matrix `above` added for the motion of the
    /// top.
    pub(crate) fn count_negative_under(
        &self,
        a: &Coefficients,
        above: SquareMatrix<Complex, 6>,
        work: &mut TopWorkspace,
    ) -> usize {
        count_negative_under(self.beam(), a, above, &mut work.factors)
    }

    /// The same, with the factors that [`solve_under`](Self::solve_under) needs.
    pub(crate) fn factorize_under(
        &self,
        a: &Coefficients,
        above: SquareMatrix<Complex, 6>,
        work: &mut TopWorkspace,
    ) -> usize {
        factorize_under(self.beam(), a, above, &mut work.factors)
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

    /// Ends it, with a force at the top: the product is in `out`.
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

    /// Twice the elastic energy in fore-aft bending, side-side bending, torsion and stretch, with
    /// that of what holds the beam: soil along it and springs at its base.
    pub(crate) fn elastic_energies(&self, x: &[Complex]) -> [f64; 4] {
        let beam = self.beam();
        let (of_base, own) = x.split_at(beam.base_coordinates());
        let mut sum = [0.0; 4];
        for own in own.chunks_exact(beam.coordinates().max(1)) {
            let mut own = own.iter();
            for deformation in beam.deformations() {
                let energy = own.by_ref().take(deformation.count);
                sum[group(deformation.strain)] +=
                    energy.map(|y| y.re * y.re + y.im * y.im).sum::<f64>();
            }
        }
        let base = base_motion(beam, of_base);
        let force = self.base_force(&base, 1);
        let mut add = |component: usize, x: Complex, force: Complex| {
            sum[[0, 1, 3, 1, 0, 2][component]] += (x.conj() * force).re;
        };
        (0..6).for_each(|c| add(c, base[c], force[c]));
        self.element_energies(1, x, add);
        sum
    }

    /// Number of elements.
    pub(crate) fn elements(&self) -> usize {
        self.beam().elements()
    }

    /// Number of coordinates of a base that moves.
    pub(crate) fn base_coordinates(&self) -> usize {
        self.beam().base_coordinates()
    }

    /// Twice the kinetic energy over the square of the frequency, as
    /// [`elastic_energies`](Self::elastic_energies).
    pub(crate) fn inertia_energies(&self, x: &[Complex]) -> [f64; 4] {
        let base = base_motion(self.beam(), &x[..self.beam().base_coordinates()]);
        let force = self.base_force(&base, 0);
        let mut sum = [0.0; 4];
        let mut add = |component: usize, x: Complex, force: Complex| {
            sum[[0, 1, 3, 1, 0, 2][component]] += (x.conj() * force).re;
        };
        (0..6).for_each(|c| add(c, base[c], force[c]));
        self.element_energies(0, x, add);
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

    /// The component of the motion that each row of an element's matrices belongs to.
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

//! One step of inverse iteration in two passes over the joints, for one vector or for several
//! vectors side by side.

use super::articulated::{Elimination, Eliminations, bias_down, eliminate, motion_up};
use super::energies::EnergySums;
use super::model::{Chain, Link};
use super::product::{Loads, coordinates_of_forces, inertia_forces};
use crate::lanes::{LANES, Lanes, Row};
use crate::space::{add, transform_force};
use crate::subsystem::{Coefficients, Energies};

/// The most rows of numbers in the work arrays of steps in lanes, 512 KiB. Larger arrays leave the
/// cache, and single steps take less time.
const MOST_ROWS: usize = 1 << 14;

/// Work arrays of a step with numbers T.
#[derive(Debug)]
pub struct StepWorkspace<const D: usize, T> {
    pub(super) loads: Loads<D, T>,
    pub(super) factors: Vec<Elimination<D, T>>,
}

impl<const D: usize, T> Default for StepWorkspace<D, T> {
    fn default() -> Self {
        Self {
            loads: Loads::default(),
            factors: Vec::new(),
        }
    }
}

/// Work arrays of steps in lanes.
#[derive(Debug, Default)]
pub struct LanesWorkspace<const D: usize> {
    step: StepWorkspace<D, Row>,
    x: Vec<Row>,
}

/// x ← A⁻¹ M x, with A factored first if it is given, else with the factors of the last A. The
/// number of negative eigenvalues of A (0 if it is not factored), and the energies of the new x.
pub fn inverse_step<const D: usize>(
    chain: &Chain<D>,
    a: Option<&Coefficients>,
    workspace: &mut StepWorkspace<D, f64>,
    x: &mut [f64],
) -> (usize, Energies) {
    let StepWorkspace { loads, factors } = workspace;
    let forces = inertia_forces(chain, loads, x);
    let negative = match a {
        Some(a) => eliminate(chain, a, a.mass, &mut ForcesDown::new(forces, factors, x)) as usize,
        None => {
            coordinates_of_forces(chain, forces, x);
            bias_down(chain, factors, x);
            0
        }
    };
    let [energies] = release(chain, factors, x);
    (negative, energies)
}

/// The same for several matrices A that differ in the coefficient of the inertia, each with a
/// vector, or without one if only the eigenvalues are counted; none, and no effect, for a chain
/// whose single steps take less time.
pub fn inverse_steps<const D: usize>(
    chain: &Chain<D>,
    a: &[Coefficients; LANES],
    workspace: &mut LanesWorkspace<D>,
    vectors: [Option<&mut [f64]>; LANES],
) -> Option<[(usize, Energies); LANES]> {
    let size = chain.degrees_of_freedom();
    if size * (D + 1) > MOST_ROWS {
        return None;
    }
    let LanesWorkspace { step, x } = workspace;
    let StepWorkspace { loads, factors } = step;
    x.clear();
    x.resize(size, Row::default());
    for (lane, vector) in vectors.iter().enumerate() {
        for (row, entry) in x.iter_mut().zip(vector.iter().flat_map(|x| x.iter())) {
            row.set(lane, *entry);
        }
    }
    let forces = inertia_forces(chain, loads, x);
    let mass = Row::new(a.map(|a| a.mass));
    let counts = eliminate(chain, &a[0], mass, &mut ForcesDown::new(forces, factors, x));
    let energies: [Energies; LANES] = release(chain, factors, x);
    for (lane, vector) in vectors.into_iter().enumerate() {
        for (entry, row) in vector.into_iter().flatten().zip(&*x) {
            *entry = row.lane(lane);
        }
    }
    Some(std::array::from_fn(|lane| {
        (counts.lane(lane) as usize, energies[lane])
    }))
}

/// The pass up: the motions, and the energies with them, of each of the N lanes of T. The processor
/// overlaps the operations that do not depend on each other.
fn release<const D: usize, T: Lanes, const N: usize>(
    chain: &Chain<D>,
    factors: &[Elimination<D, T>],
    x: &mut [T],
) -> [Energies; N] {
    let mut sums = EnergySums::default();
    motion_up(chain, factors, x, |joint, link, motion, own| {
        sums.add(chain, joint, link, motion, || link.scaled(own));
    });
    sums.of(chain, x)
}

/// The pass down: the forces on the bodies and the bias of the right-hand side go with the
/// elimination.
struct ForcesDown<'a, const D: usize, T> {
    forces: &'a [[T; D]],
    factors: &'a mut Vec<Elimination<D, T>>,
    /// The right-hand side, and in it the first and the next entry of the present joint.
    x: &'a mut [T],
    begin: usize,
    next: usize,
    force: [T; D],
    bias: [T; D],
}

impl<'a, const D: usize, T: Lanes> ForcesDown<'a, D, T> {
    fn new(forces: &'a [[T; D]], factors: &'a mut Vec<Elimination<D, T>>, x: &'a mut [T]) -> Self {
        factors.clear();
        Self {
            forces,
            factors,
            begin: x.len(),
            next: x.len(),
            x,
            force: [T::default(); D],
            bias: [T::default(); D],
        }
    }
}

impl<const D: usize, T: Lanes> Eliminations<D, T> for ForcesDown<'_, D, T> {
    #[inline(always)]
    fn begin(&mut self, joint: usize, link: &Link<D>, rise_m: f64) {
        transform_force(&mut self.force, rise_m);
        transform_force(&mut self.bias, rise_m);
        add(&mut self.force, &self.forces[joint]);
        self.begin -= link.moving;
        self.next = self.begin;
    }

    #[inline(always)]
    fn take(&mut self, component: usize, root: f64, elimination: Elimination<D, T>) {
        let x = &mut self.x[self.next];
        *x = self.force[component].times(root);
        elimination.bias(component, root, x, &mut self.bias);
        self.next += 1;
        self.factors.push(elimination);
    }
}

#[cfg(test)]
mod tests {
    use super::super::articulated::{factorize, solve};
    use super::super::energies::energies;
    use super::super::product::product;
    use super::*;
    use crate::subsystem::MatrixKind;

    /// A chain on springs with joints that are rigid in some components, under gravity.
    fn chain<const D: usize>() -> Chain<D> {
        let diagonal = |value: f64| {
            let entry = |i: usize, j: usize| if i == j { value + i as f64 } else { 0.1 };
            std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
        };
        let mut chain = Chain::default();
        chain.add_base(0.0, [0.5; D]);
        chain.add(MatrixKind::Foundation, 0.3, diagonal(3.0));
        for joint in 0..9 {
            let is_rigid = |component: usize| joint % 4 == 1 && component == joint % D;
            let flexibility = |component: usize| match is_rigid(component) {
                true => 0.0,
                false => 1.0 / (2.0 + ((7 * joint + component) % 5) as f64),
            };
            let height_m = 0.7 * joint as f64;
            chain.add_joint(height_m, std::array::from_fn(flexibility), 0.05);
            chain.add(
                MatrixKind::Inertia,
                height_m + 0.3,
                diagonal(1.0 + joint as f64),
            );
            chain.add_geometric_stiffness(0.02);
        }
        chain
    }

    /// The step by separate operations.
    fn by_parts<const D: usize>(
        chain: &Chain<D>,
        a: &Coefficients,
        x: &mut [f64],
    ) -> (usize, Energies) {
        let (mut loads, mut factors) = (Loads::default(), Vec::new());
        let mut load = x.to_vec();
        product(chain, &Coefficients::MASS, &mut loads, x, &mut load);
        let negative = factorize(chain, a, &mut factors);
        solve(chain, &factors, &mut load);
        x.copy_from_slice(&load);
        (negative, energies(chain, x))
    }

    fn steps_have_the_bits_of_their_parts<const D: usize>() {
        let chain = chain::<D>();
        let shifted = |shift: f64| Coefficients::STIFFNESS.minus(shift, Coefficients::MASS);
        let a = [0.003, 0.02, 0.1, 0.4].map(shifted);
        let size = chain.degrees_of_freedom();
        let vector = |lane: usize| (0..size).map(move |i| ((5 * i + 3 * lane) as f64).sin());
        let vectors: [Vec<f64>; LANES] = std::array::from_fn(|lane| vector(lane).collect());
        let mut by_lanes = vectors.clone();
        let mut moved = by_lanes.iter_mut();
        // The last lane only counts.
        let moved = std::array::from_fn(|lane| {
            let x = moved.next().filter(|_| lane + 1 < LANES)?;
            Some(&mut x[..])
        });
        let steps = inverse_steps(&chain, &a, &mut LanesWorkspace::default(), moved);
        let steps = steps.expect("a short chain");
        let mut counts = Vec::new();
        for lane in 0..LANES {
            let mut expected = vectors[lane].clone();
            let (negative, energies) = by_parts(&chain, &a[lane], &mut expected);
            assert_eq!(steps[lane].0, negative, "D = {D}, lane {lane}");
            counts.push(negative);
            if lane + 1 == LANES {
                assert_eq!(by_lanes[lane], vectors[lane]);
                continue;
            }
            assert_eq!(by_lanes[lane], expected, "D = {D}, lane {lane}");
            assert_eq!(steps[lane].1, energies, "D = {D}, lane {lane}");
            let mut alone = vectors[lane].clone();
            let work = &mut StepWorkspace::default();
            let step = inverse_step(&chain, Some(&a[lane]), work, &mut alone);
            assert_eq!(
                (step, alone),
                (steps[lane], expected),
                "D = {D}, lane {lane}"
            );
        }
        // The lanes are different, and the shifts are among the eigenvalues.
        assert!(
            counts[0] < counts[LANES - 1] && counts[LANES - 1] < size,
            "{counts:?}"
        );
    }

    #[test]
    fn steps_in_lanes_have_the_bits_of_single_steps() {
        steps_have_the_bits_of_their_parts::<1>();
        steps_have_the_bits_of_their_parts::<2>();
        steps_have_the_bits_of_their_parts::<3>();
        steps_have_the_bits_of_their_parts::<6>();
    }
}

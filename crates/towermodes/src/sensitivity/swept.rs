//! Derivatives from the gradient with respect to all numbers of a tower: only the derivatives of
//! these numbers with respect to the input values are needed, without an assembly.

use super::slope::{Bends, Derivatives, Slope};
use super::step::{RELATIVE, SHORTER, is_quadratic, size_of};
use super::{Derivative, NoDerivative};
use crate::parameter::Change;
use crate::solve::FrozenModes;
use crate::tower::{Motions, Neighbours, TowerDescription};

/// Relative error of the gradient, from the vectors and from the sums.
const OF_GRADIENT: f64 = 1e-12;

/// The gradients of held modes with the memory to use them.
pub(super) struct Swept<'a> {
    neighbours: &'a Neighbours,
    /// The description that is changed.
    description: TowerDescription,
    /// The numbers of the tower, and of the towers with increased and decreased value.
    numbers: [Vec<f64>; 3],
    /// For each mesh and mode the differences over the last step and over its half.
    differences: [Vec<Difference>; 2],
}

/// Differences of the numbers of a tower, times a gradient.
#[derive(Debug, Clone, Copy, Default)]
struct Difference {
    slope: f64,
    /// The difference between the changes in both directions.
    bend: f64,
    /// The sum of the absolute values of all terms of the slope, and their rounding error.
    gross: f64,
    rounding: f64,
}

/// Other effects of a step, besides the numbers.
struct Around {
    mass_kg_per_unit: f64,
    /// The sets of motions that are coupled in the slightly changed towers.
    coupled: Vec<Motions>,
}

impl<'a> Swept<'a> {
    pub(super) fn new(neighbours: &'a Neighbours) -> Self {
        let mut own = Vec::new();
        neighbours.tower().write_numbers(&mut own);
        Self {
            description: neighbours.description().clone(),
            neighbours,
            numbers: [own, Vec::new(), Vec::new()],
            differences: [Vec::new(), Vec::new()],
        }
    }

    /// The derivatives with respect to a change; none if it changes the structure of the tower, or
    /// there are no gradients.
    pub(super) fn derivatives(
        &mut self,
        frozen: &FrozenModes,
        change: &Change,
        value: f64,
    ) -> Option<Derivatives> {
        let gradients = frozen.gradients.as_ref()?;
        let size = size_of(change, value, self.neighbours);
        let h = SHORTER * RELATIVE * size;
        let around = self.difference(frozen, gradients, (0, change, value, h))?;
        if is_quadratic(change) {
            let [whole, half] = &mut self.differences;
            whole.iter_mut().for_each(|sum| sum.bend = 0.0);
            half.clone_from(whole);
        } else {
            self.difference(frozen, gradients, (1, change, value, 0.5 * h))?;
        }
        let derivatives = (0..frozen.modes.len()).map(|mode| {
            frozen.check(mode, &around.coupled)?;
            self.derivative(frozen, mode, (size, h))
        });
        Some((derivatives.collect(), around.mass_kg_per_unit))
    }

    fn derivative(
        &self,
        frozen: &FrozenModes,
        mode: usize,
        (size, h): (f64, f64),
    ) -> Result<Derivative, NoDerivative> {
        let modes = frozen.modes.len();
        let [whole, half] = [&self.differences[0], &self.differences[1]];
        let (whole_own, half_own) = (&whole[mode], &half[mode]);
        let lambda = frozen.meshes[0].lambdas[mode];
        let bends = Bends {
            whole: whole_own.bend,
            half: half_own.bend,
        };
        if bends.are_of_kink(half_own.gross * h, lambda) {
            return Err(NoDerivative::OneSided);
        }
        Ok(frozen.derivative(mode, size, |mesh| {
            let (whole, half) = (&whole[mesh * modes + mode], &half[mesh * modes + mode]);
            let mut slope = Slope::extrapolated(whole.slope, half.slope);
            slope.error += half.rounding + OF_GRADIENT * half.gross;
            slope
        }))
    }

    /// Computes the differences over a step, as the first or the second.
    fn difference(
        &mut self,
        frozen: &FrozenModes,
        gradients: &[f64],
        (which, change, value, h): (usize, &Change, f64, f64),
    ) -> Option<Around> {
        let [own, upper, lower] = &mut self.numbers;
        let mut write = |value: f64, numbers: &mut Vec<f64>| {
            self.description.clone_from(self.neighbours.description());
            change.apply(&mut self.description, value);
            let neighbour = self.neighbours.near(&self.description)?;
            neighbour.write_numbers(numbers);
            Some(neighbour)
        };
        let above = write(value + h, upper)?;
        let below = write(value - h, lower)?;
        let sums = frozen.meshes.len() * frozen.modes.len();
        let differences = &mut self.differences[which];
        differences.clear();
        differences.resize(sums, Difference::default());
        let numbers = own.iter().zip(&*upper).zip(&*lower);
        for (((own, upper), lower), gradients) in numbers.zip(gradients.chunks_exact(sums)) {
            if upper == lower && upper == own {
                continue;
            }
            let slope = (upper - lower) / (2.0 * h);
            let bend = (upper - own) - (own - lower);
            let rounding = f64::EPSILON * own.abs() / h;
            for (sum, gradient) in differences.iter_mut().zip(gradients) {
                sum.slope += gradient * slope;
                sum.bend += gradient * bend;
                sum.gross += (gradient * slope).abs();
                sum.rounding += (gradient * rounding).abs();
            }
        }
        add_arms(frozen, [&above.arms_m, &below.arms_m], h, differences);
        let is_finite = differences.iter().all(|sum| sum.slope.is_finite());
        let [above_kg, below_kg] = [&above, &below].map(|at| at.tower.structure_mass_kg());
        is_finite.then_some(Around {
            mass_kg_per_unit: (above_kg - below_kg) / (2.0 * h),
            coupled: above.coupled,
        })
    }
}

/// Adds the effect of attachments that move away from the ends that carry them, in the two changed
/// towers.
fn add_arms(frozen: &FrozenModes, arms_m: [&[f64]; 2], h: f64, differences: &mut [Difference]) {
    if arms_m.iter().all(|arms_m| arms_m.is_empty()) {
        return;
    }
    let modes = frozen.modes.len();
    let of_meshes = frozen
        .meshes
        .iter()
        .zip(differences.chunks_exact_mut(modes));
    for (mesh, differences) in of_meshes {
        for (mode, sum) in differences.iter_mut().enumerate() {
            let [upper, lower] = arms_m.map(|arms_m| mesh.change_by_arms(mode, arms_m));
            let slope = (upper - lower) / (2.0 * h);
            sum.slope += slope;
            sum.bend += upper + lower;
            sum.gross += slope.abs();
        }
    }
}

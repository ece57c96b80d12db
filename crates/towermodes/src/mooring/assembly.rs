//! The forces on the free parts and the platform, and their stiffness matrix.

use super::carrier::{Owner, Reached};
use super::elimination::Elimination;
use super::error::MooringError;
use super::line::Hung;
use super::pose::Placement;
use super::system::Mooring;
use super::vector::{Matrix3, Vector, cross, difference, dot, length, product, skew};

/// The lines at given positions of platform and free parts. The unknowns are the motions of the
/// free parts, then the six of the platform: displacement (m) and rotation vector (rad) of the
/// origin in fixed axes.
#[derive(Debug, Clone, Default)]
pub(super) struct Assembly {
    /// The lines.
    pub(super) hung: Vec<Hung>,
    /// The net force and moment for each unknown, N and N m.
    pub(super) force: Vec<f64>,
    /// The stiffness matrix.
    pub(super) stiffness: Elimination,
    /// For each unknown of the free parts, the largest stiffness of its kind.
    pub(super) scales: Vec<f64>,
    ends: Vec<[Reached; 2]>,
}

/// The unknowns of an owner: index of the first, and their number.
type Unknowns = Option<(usize, usize)>;

impl Assembly {
    /// Computes the lines at these positions, and sums their forces, the weights and the
    /// buoyancies.
    pub(super) fn hang(
        &mut self,
        mooring: &Mooring,
        platform: &Placement,
        free: &[Placement],
    ) -> Result<(), MooringError> {
        self.hung.clear();
        self.ends.clear();
        self.force.clear();
        self.force.resize(mooring.unknowns + 6, 0.0);
        for (index, (rope, arms)) in mooring.ropes.iter().zip(&mooring.ends).enumerate() {
            let ends = arms.map(|arm| arm.reached(platform, free));
            let positions = ends.map(|end| end.position_m);
            let hung = rope
                .between(positions)
                .ok_or_else(|| MooringError::NoTension {
                    line: index,
                    length_m: mooring.description.lines[index].length_m,
                    distance_m: length(difference(positions[1], positions[0])),
                })?;
            for ((arm, end), force_n) in arms.iter().zip(ends).zip(hung.forces_n) {
                self.push(unknowns(mooring, arm.owner), end.arm_m, force_n);
            }
            self.hung.push(hung);
            self.ends.push(ends);
        }
        for load in &mooring.loads {
            let arm_m = load.arm.reached(platform, free).arm_m;
            self.push(
                unknowns(mooring, load.arm.owner),
                arm_m,
                [0.0, 0.0, load.up_n],
            );
        }
        Ok(())
    }

    /// Computes the stiffness at the positions of the last computation of the lines.
    pub(super) fn stiffen(&mut self, mooring: &Mooring, platform: &Placement, free: &[Placement]) {
        let size = mooring.unknowns + 6;
        (self.stiffness.size, self.stiffness.eliminated) = (size, mooring.unknowns);
        self.stiffness.matrix.clear();
        self.stiffness.matrix.resize(size * size, 0.0);
        for (line, arms) in mooring.ends.iter().enumerate() {
            let owners = arms.map(|arm| unknowns(mooring, arm.owner));
            let (hung, ends) = (self.hung[line], self.ends[line]);
            for i in 0..2 {
                self.turn(owners[i], ends[i].arm_m, hung.forces_n[i]);
                for j in 0..2 {
                    let block = &hung.stiffness[i][j];
                    self.couple(
                        [owners[i], owners[j]],
                        [ends[i].arm_m, ends[j].arm_m],
                        block,
                    );
                }
            }
        }
        for load in &mooring.loads {
            let arm_m = load.arm.reached(platform, free).arm_m;
            self.turn(
                unknowns(mooring, load.arm.owner),
                arm_m,
                [0.0, 0.0, load.up_n],
            );
        }
        self.measure(mooring);
    }

    /// Adds a force at a point of an owner, and its moment.
    fn push(&mut self, owner: Unknowns, arm_m: Vector, force_n: Vector) {
        let Some((first, count)) = owner else {
            return;
        };
        let moment = cross(arm_m, force_n);
        let both = force_n.into_iter().chain(moment).take(count);
        for (sum, value) in self.force[first..].iter_mut().zip(both) {
            *sum += value;
        }
    }

    /// Adds the stiffness of a force of constant direction on a rotating body, (F·r) 1 − ½ (r Fᵀ +
    /// F rᵀ): the Hessian of −F·R(θ)r.
    fn turn(&mut self, owner: Unknowns, r: Vector, f: Vector) {
        if let Some((first, 6)) = owner {
            let along = dot(f, r);
            for i in 0..3 {
                for j in 0..3 {
                    let diagonal = if i == j { along } else { 0.0 };
                    let entry = diagonal - 0.5 * (r[i] * f[j] + f[i] * r[j]);
                    *self.entry(first + 3 + i, first + 3 + j) += entry;
                }
            }
        }
    }

    /// Adds T_iᵀ K T_j for the ends of a line, with T = (1, −\[r\]).
    fn couple(&mut self, owners: [Unknowns; 2], [r_i, r_j]: [Vector; 2], k: &Matrix3) {
        let [Some((row, rows)), Some((column, columns))] = owners else {
            return;
        };
        let left = product(&skew(r_i), k);
        // K T_j = (K, −K [r_j]).
        let (right, both) = (product(k, &skew(r_j)), product(&left, &skew(r_j)));
        for i in 0..rows {
            for j in 0..columns {
                *self.entry(row + i, column + j) += match (i / 3, j / 3) {
                    (0, 0) => k[i][j],
                    (0, _) => -right[i][j - 3],
                    (_, 0) => left[i - 3][j],
                    (_, _) => -both[i - 3][j - 3],
                };
            }
        }
    }

    fn entry(&mut self, row: usize, column: usize) -> &mut f64 {
        &mut self.stiffness.matrix[row * self.stiffness.size + column]
    }

    fn measure(&mut self, mooring: &Mooring) {
        self.scales.clear();
        for part in &mooring.free {
            let kinds = if part.turns { 2 } else { 1 };
            for first in (0..kinds).map(|kind| part.first + 3 * kind) {
                let diagonal = (first..first + 3).map(|i| self.entry(i, i).abs());
                let scale = diagonal.fold(0.0, f64::max);
                self.scales.extend([scale; 3]);
            }
        }
    }
}

fn unknowns(mooring: &Mooring, owner: Owner) -> Unknowns {
    match owner {
        Owner::Ground => None,
        Owner::Platform => Some((mooring.unknowns, 6)),
        Owner::Free(index) => {
            let part = &mooring.free[index];
            Some((part.first, if part.turns { 6 } else { 3 }))
        }
    }
}

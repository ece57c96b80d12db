//! The section of a blade, or a rigid body at its tip, in the rotating frame.

use super::super::strain::Strain;
use super::steady::{Mass, SteadyForces, section_at, twice_second_order};
use super::tensor::{
    Tensor, Vector, across, cross_matrix, identity, minus, product, scaled, symmetric, times,
    trace, transposed,
};
use crate::blade::{Blade, BladeSection};
use crate::space::SpatialMatrix;
use crate::tower::Plane;

/// Components of the motion of a section and of its strains: translation u, rotation Θ, strains γ
/// (shear, shear, stretch) and κ (curvatures, twist), three each.
pub(super) const COMPONENTS: usize = 12;

/// The matrices of a section per length, or of a body.
#[derive(Debug, Clone)]
pub(super) struct TurningSection {
    /// Stiffness against the strains in the order of [`Strain::ALL`].
    pub(crate) strain_stiffness: SpatialMatrix,
    /// Inertia M.
    pub(crate) inertia: SpatialMatrix,
    /// C, skew.
    pub(crate) coriolis: SpatialMatrix,
    /// K_g − S for the motion and the strains, per Ω².
    pub(crate) spin: [[f64; COMPONENTS]; COMPONENTS],
}

impl TurningSection {
    /// The matrices of the section at a radius (m), under the steady forces there.
    pub(crate) fn at(blade: &Blade, axis: Vector, radius_m: f64, forces: &SteadyForces) -> Self {
        let (section, turn) = section_at(blade, radius_m);
        let mass = Mass::of_section(&section, turn);
        let mut own = Self::of_mass(&mass, axis, radius_m);
        own.strain_stiffness = strain_stiffness(&section, turn);
        own.add_steady(forces);
        own
    }

    /// The matrices of the body at the tip.
    pub(super) fn of_tip(blade: &Blade, axis: Vector) -> Self {
        let description = blade.description();
        let mass = Mass::of_body(&description.tip);
        Self::of_mass(&mass, axis, description.tip_radius_m)
    }

    /// M, C, −S and the contribution of the extent of the mass to K_g: Θᵀ (tr(A) 1 − A) Θ with A
    /// the symmetric part of s (P x₀)ᵀ + J P.
    fn of_mass(mass: &Mass, axis: Vector, radius_m: f64) -> Self {
        let Mass {
            mass: m,
            moment,
            second,
        } = mass;
        let across = across(axis);
        let (cross_s, cross_n) = (cross_matrix(*moment), cross_matrix(axis));
        let identity = identity();
        let mut own = Self {
            strain_stiffness: [[0.0; 6]; 6],
            inertia: [[0.0; 6]; 6],
            coriolis: [[0.0; 6]; 6],
            spin: [[0.0; COMPONENTS]; COMPONENTS],
        };
        let about = minus(&scaled(&identity, trace(second)), second);
        set(&mut own.inertia, (0, 0), &scaled(&identity, *m));
        set_symmetric(&mut own.inertia, (0, 3), &scaled(&cross_s, -1.0));
        set(&mut own.inertia, (3, 3), &about);
        set(&mut own.coriolis, (0, 0), &scaled(&cross_n, *m));
        set(
            &mut own.coriolis,
            (0, 3),
            &scaled(&product(&cross_n, &cross_s), -1.0),
        );
        set(&mut own.coriolis, (3, 0), &product(&cross_s, &cross_n));
        set(
            &mut own.coriolis,
            (3, 3),
            &cross_matrix(times(second, axis)),
        );
        let along = product(&product(&cross_n, second), &transposed(&cross_n));
        let outwards = times(&across, [0.0, 0.0, radius_m]);
        let mut a = product(second, &across);
        for i in 0..3 {
            for j in 0..3 {
                a[i][j] += moment[i] * outwards[j];
            }
        }
        let turned = minus(&scaled(&identity, trace(&a)), &symmetric(&a));
        set(&mut own.spin, (0, 0), &scaled(&across, -m));
        set_symmetric(&mut own.spin, (0, 3), &product(&across, &cross_s));
        set(
            &mut own.spin,
            (3, 3),
            &minus(&turned, &minus(&about, &along)),
        );
        own
    }

    /// Adds the stiffness due to the steady force F and moment Q in the section: −F·Θ×(Θ×t) − 2
    /// F·(Θ×γ) − Q·(Θ×κ) with t along the span.
    fn add_steady(&mut self, forces: &SteadyForces) {
        let turned = twice_second_order(forces.force);
        for (i, row) in turned.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                self.spin[3 + i][3 + j] += entry;
            }
        }
        let strained = scaled(&cross_matrix(forces.force), -1.0);
        set_symmetric(&mut self.spin, (6, 3), &strained);
        let bent = scaled(&cross_matrix(forces.moment), -0.5);
        set_symmetric(&mut self.spin, (9, 3), &bent);
    }
}

/// Section stiffness against curvatures, twist and stretch, per length, in the order of
/// [`Strain::ALL`].
pub(crate) fn strain_stiffness(section: &BladeSection, (sin, cos): (f64, f64)) -> SpatialMatrix {
    let (edge, flap) = (section.edge_n_m2, section.flap_n_m2);
    let [v, w] = [Plane::ForeAft, Plane::SideSide].map(|plane| Strain::Curvature(plane).index());
    let (twist, stretch) = (Strain::Twist.index(), Strain::Stretch.index());
    // A blade without axial deformation has no tension centre.
    let offset = match section.tension_center_m {
        0.0 => 0.0,
        center_m => section.axial_n * center_m,
    };
    let mut matrix = [[0.0; 6]; 6];
    matrix[v][v] = edge * cos * cos + flap * sin * sin;
    matrix[w][w] = edge * sin * sin + flap * cos * cos;
    matrix[twist][twist] = section.torsion_n_m2;
    matrix[stretch][stretch] = section.axial_n;
    let mut couple = |i: usize, j: usize, value: f64| {
        (matrix[i][j], matrix[j][i]) = (value, value);
    };
    couple(v, w, (edge - flap) * cos * sin);
    couple(stretch, v, -offset * cos);
    couple(stretch, w, -offset * sin);
    // Strains that the element does not have.
    for shear in [1, 3] {
        matrix[shear][shear] = 1.0;
    }
    matrix
}

/// Writes a block.
fn set<const D: usize>(matrix: &mut [[f64; D]; D], (row, column): (usize, usize), block: &Tensor) {
    for i in 0..3 {
        matrix[row + i][column..column + 3].copy_from_slice(&block[i]);
    }
}

/// Writes a block and its transpose on the other side of the diagonal.
fn set_symmetric<const D: usize>(
    matrix: &mut [[f64; D]; D],
    (row, column): (usize, usize),
    block: &Tensor,
) {
    set(matrix, (row, column), block);
    set(matrix, (column, row), &transposed(block));
}

//! The lowest section of a tower: its free motions, its support, and the inertia of the support.

use super::super::attachment::spatial_inertia;
use super::super::foundation::{Foundation, StiffnessFoundation, Support};
use super::super::frame::FrameFoundation;
use super::super::parts::floating_platform::{FloatingPlatform, ReferredMatrix};
use crate::space::{SpatialMatrix, add_scaled, transform_matrix};

/// The base of a tower, for its motion (x, y, z, rotation about x, y, z).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Base {
    /// Which motions are possible; the others are rigidly held.
    pub moves: [bool; 6],
    /// The motion that is 1 for each coordinate of the base, m or rad; 0 where it is rigidly held.
    pub units: [f64; 6],
    /// Stiffness to the ground: N/m, N, N m; zero for motions that are rigidly held.
    pub stiffness: SpatialMatrix,
    /// What the moorings of a platform have of this stiffness.
    pub mooring_stiffness: SpatialMatrix,
    /// Inertia that moves with it: kg, kg m, kg m²; with the added mass at infinite frequency where
    /// that depends on frequency.
    pub inertia: SpatialMatrix,
    /// This inertia without the water around a platform.
    pub dry_inertia: SpatialMatrix,
    /// Moment of the platform's and the tower's mass about the point that the hydrostatic stiffness
    /// is about, kg m: times g the negative geometric stiffness against rotation about x and y;
    /// zero for a fixed base.
    pub overturning_kg_m: f64,
    /// Whether it floats: rigid-body modes are modes of their own.
    pub floats: bool,
    /// Whether it rides on a frame, which holds it.
    pub on_frame: bool,
}

impl Base {
    /// The base for a foundation under a tower with its base at `base_m` and the mass `mass_kg`.
    pub(crate) fn new(foundation: &Foundation, base_m: f64, mass_kg: f64) -> Self {
        match foundation.support() {
            Support::Clamped => Self::default(),
            Support::Stiffness(foundation) => Self::on(foundation),
            Support::Springs(springs) => Self::on(&on_springs(springs.matrix())),
            Support::Form(form) => Self::on(&on_springs(form.stiffness())),
            Support::Floating(platform) => {
                // The lines were checked already; a neighbour in which they cannot reach their ends
                // has no stiffness.
                let linear = platform.with_linear_moorings();
                let platform = linear.unwrap_or_else(|_| platform.clone());
                Self::afloat(&platform, base_m, mass_kg)
            }
            Support::Frame(foundation) => Self::on_frame(foundation, base_m, mass_kg),
        }
    }

    /// Whether it does not move at all.
    pub fn is_clamped(&self) -> bool {
        self.moves == [false; 6]
    }

    fn on(foundation: &StiffnessFoundation) -> Self {
        let (moves, stiffness) = foundation.moving();
        Self {
            moves,
            stiffness: symmetrized(&stiffness),
            inertia: symmetrized(&foundation.inertia),
            dry_inertia: symmetrized(&foundation.inertia),
            ..Self::default()
        }
    }

    /// The base on a transition piece, which is supported by the frame or floats. The reference
    /// point of the gravity stiffness of the tower is that of the transition piece, or that of the
    /// hydrostatic stiffness.
    fn on_frame(foundation: &FrameFoundation, base_m: f64, mass_kg: f64) -> Self {
        Self {
            moves: [true; 6],
            overturning_kg_m: mass_kg * (base_m - foundation.pivot_m()),
            floats: foundation.restoring.is_some(),
            on_frame: true,
            ..Self::default()
        }
    }

    /// The weights turn over about the point that the hydrostatic stiffness is about: only about
    /// that point, where buoyancy and weights are in balance, do its entries and theirs add up.
    /// Lines of the platform are left out: their stiffness has to be in its matrix.
    pub(in crate::tower) fn afloat(platform: &FloatingPlatform, base_m: f64, mass_kg: f64) -> Self {
        let water = &platform.added_mass;
        let [x, y, z] = platform.center_m;
        let centre = [x, y, z - base_m];
        let mut base = Self {
            moves: [true; 6],
            inertia: spatial_inertia(platform.mass_kg, centre, &platform.inertia_kg_m2),
            floats: true,
            ..Self::default()
        };
        let add = |sum: &mut SpatialMatrix, referred: &ReferredMatrix| {
            let mut matrix = symmetrized(&referred.matrix);
            transform_matrix(&mut matrix, referred.height_m - base_m);
            add_scaled(sum, 1.0, &matrix);
        };
        add(&mut base.inertia, &platform.added_mass);
        base.dry_inertia = base.inertia;
        let mut moved = symmetrized(&water.matrix);
        transform_matrix(&mut moved, water.height_m - base_m);
        add_scaled(&mut base.dry_inertia, -1.0, &moved);
        if let Some(table) = &platform.added_mass_by_frequency {
            let infinite = ReferredMatrix {
                matrix: table.infinite,
                height_m: platform.added_mass.height_m,
            };
            add(&mut base.inertia, &infinite);
        }
        add(&mut base.stiffness, &platform.hydrostatic);
        add(&mut base.mooring_stiffness, &platform.mooring);
        add_scaled(&mut base.stiffness, 1.0, &base.mooring_stiffness);
        let pivot_m = platform.hydrostatic.height_m;
        base.overturning_kg_m = platform.mass_kg * (z - pivot_m) + mass_kg * (base_m - pivot_m);
        base
    }
}

/// A stiffness with infinite values in place of values that are not finite, such as a rigid spring
/// after a step to a changed tower.
fn on_springs(mut stiffness: SpatialMatrix) -> StiffnessFoundation {
    for (motion, row) in stiffness.iter_mut().enumerate() {
        if !row[motion].is_finite() {
            row[motion] = f64::INFINITY;
        }
    }
    stiffness.into()
}

/// (A + Aᵀ)/2.
pub(in crate::tower) fn symmetrized(matrix: &SpatialMatrix) -> SpatialMatrix {
    std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (matrix[i][j] + matrix[j][i])))
}

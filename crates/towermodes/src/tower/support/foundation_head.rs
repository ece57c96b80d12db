//! The static stiffness of pile and foundation at the surface of the soil.

use super::super::closed_form::HeadStiffness;
use super::super::model::Tower;
use super::super::pieces::planes::Plane;
use super::super::pieces::section::Section;
use super::base::Base;
use std::array::from_fn;

/// Lowest number of steps of the integration over the embedded length.
const STEPS: f64 = 1000.0;

/// The static stiffness of pile and foundation at a height.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FoundationHead {
    /// The height, m.
    pub height_m: f64,
    /// In the fore-aft plane: K_L, K_LR and K_R.
    pub fore_aft: HeadStiffness,
    /// In the side-side plane, for the displacement y and the rotation about −x; none if the base
    /// holds a motion in this plane rigidly.
    pub side_side: Option<HeadStiffness>,
    /// Force per displacement z, N/m; none if the motion is rigidly held.
    pub vertical_n_per_m: Option<f64>,
    /// Moment per rotation about z, N m; none if the motion is rigidly held.
    pub torsion_n_m: Option<f64>,
}

impl Tower {
    /// The static stiffness of pile and foundation, without water and weight, at the height of the
    /// uppermost soil around or under the tower: at the surface of the
    /// [ground](crate::TowerDescription::ground), at the highest of the rows of
    /// [`soil`](crate::TowerDescription::soil), or at the base. None where the base is held by more
    /// than springs in the fore-aft plane, on a frame, and for a tower that floats.
    ///
    /// The stiffness K at the upper end of a part of the pile grows by the springs of the soil,
    /// loses the flexibility of the pile and moves with its point of reference:
    ///
    /// - dK_L/dz = k − K_L²/κGA − K_LR²/EI,
    /// - dK_LR/dz = −K_L K_LR/κGA − K_LR K_R/EI − K_L,
    /// - dK_R/dz = k_θ − K_LR²/κGA − K_R²/EI − 2 K_LR,
    /// - dK/dz = k − K²/EA along the axis, with GJ in place of EA about it; if the base holds this
    ///   motion rigidly, d(1/K)/dz = 1/EA − k/K².
    ///
    /// It is integrated from the base up.
    pub fn foundation_head(&self) -> Option<FoundationHead> {
        let base = self.base();
        if base.floats || base.on_frame || !is_elastic(base, Plane::ForeAft) {
            return None;
        }
        let height_m = self.uppermost_soil_m();
        let is_held = [2, 5].map(|motion| !base.moves[motion]);
        let at_base = Values {
            planes: [Plane::ForeAft, Plane::SideSide].map(|plane| at_base(base, plane)),
            axial: [2, 5].map(|motion| base.stiffness[motion][motion]),
        };
        let values = self.integrated_to(height_m, at_base, is_held);
        let [fore_aft, side_side] = values.planes.map(|[k_l, k_lr, k_r]| HeadStiffness {
            lateral_n_per_m: k_l,
            coupling_n: k_lr,
            rocking_n_m: k_r,
        });
        let axial = |i: usize| match is_held[i] {
            true => Some(1.0 / values.axial[i]).filter(|stiffness| stiffness.is_finite()),
            false => Some(values.axial[i]),
        };
        Some(FoundationHead {
            height_m,
            fore_aft,
            side_side: is_elastic(base, Plane::SideSide).then_some(side_side),
            vertical_n_per_m: axial(0),
            torsion_n_m: axial(1),
        })
    }

    fn uppermost_soil_m(&self) -> f64 {
        let pieces = self.pieces().iter().rev();
        let mut in_soil = pieces.filter(|piece| piece.environment.soil.is_some());
        let rows_m = || in_soil.next().map(|piece| piece.top_m);
        let surface_m = self.ground_surface_m().or_else(rows_m);
        surface_m.unwrap_or(self.base_m())
    }

    /// Values at the base, integrated up to a height (m). The sections at the ends of a step serve
    /// its neighbours too.
    fn integrated_to(&self, surface_m: f64, at_base: Values, is_held: [bool; 2]) -> Values {
        let step_m = (surface_m - self.base_m()) / STEPS;
        let mut values = at_base;
        for piece in self.pieces() {
            let length_m = piece.top_m.min(surface_m) - piece.base_m;
            if length_m <= 0.0 {
                break;
            }
            let steps = (length_m / step_m).ceil().max(4.0);
            let own_m = length_m / steps;
            let section = |step: f64| piece.section_at(piece.base_m + step * own_m);
            let mut low = section(0.0);
            for step in 0..steps as usize {
                let [middle, high] = [0.5, 1.0].map(|share| section(step as f64 + share));
                values = values.after([&low, &middle, &high], own_m, is_held);
                low = high;
            }
        }
        values
    }
}

/// Whether the base holds no motion in a plane rigidly.
fn is_elastic(base: &Base, plane: Plane) -> bool {
    let [translation, rotation] = motions(plane);
    base.moves[translation] && base.moves[rotation]
}

fn motions(plane: Plane) -> [usize; 2] {
    match plane {
        Plane::ForeAft => [0, 4],
        Plane::SideSide => [1, 3],
    }
}

/// K_L, K_LR and K_R of the base in a plane; the rotation is about y or −x.
fn at_base(base: &Base, plane: Plane) -> [f64; 3] {
    let [translation, rotation] = motions(plane);
    let k = &base.stiffness;
    let sign = match plane {
        Plane::ForeAft => 1.0,
        Plane::SideSide => -1.0,
    };
    [
        k[translation][translation],
        sign * k[translation][rotation],
        k[rotation][rotation],
    ]
}

/// What is integrated.
#[derive(Clone, Copy)]
struct Values {
    /// K_L, K_LR and K_R in the fore-aft and the side-side plane.
    planes: [[f64; 3]; 2],
    /// K along and about the axis; 1/K where the base holds this motion.
    axial: [f64; 2],
}

impl Values {
    /// One step of the classical method of Runge and Kutta, with the sections at its lower end, in
    /// its middle and at its upper end.
    fn after(self, [low, middle, high]: [&Section; 3], step_m: f64, is_held: [bool; 2]) -> Self {
        let slope = |section: &Section, values: Self| values.slope(section, is_held);
        let a = slope(low, self);
        let b = slope(middle, self.plus(0.5 * step_m, a));
        let c = slope(middle, self.plus(0.5 * step_m, b));
        let d = slope(high, self.plus(step_m, c));
        let next = |k: f64, [a, b, c, d]: [f64; 4]| k + step_m * (a + 2.0 * b + 2.0 * c + d) / 6.0;
        let of = |i: usize, j: usize| [a, b, c, d].map(|slope| slope.planes[i][j]);
        let axial = |i: usize| [a, b, c, d].map(|slope| slope.axial[i]);
        Self {
            planes: from_fn(|i| from_fn(|j| next(self.planes[i][j], of(i, j)))),
            axial: from_fn(|i| next(self.axial[i], axial(i))),
        }
    }

    fn plus(self, by: f64, slope: Self) -> Self {
        Self {
            planes: from_fn(|i| from_fn(|j| self.planes[i][j] + by * slope.planes[i][j])),
            axial: from_fn(|i| self.axial[i] + by * slope.axial[i]),
        }
    }

    /// The derivatives of [`foundation_head`](Tower::foundation_head).
    fn slope(self, section: &Section, is_held: [bool; 2]) -> Self {
        let [fore_aft, side_side] = self.planes;
        let springs = [section.soil.z_n_per_m2, section.soil.torsion_n];
        let flexibilities =
            [section.axial_n, section.torsion_n_m2].map(|stiffness| 1.0 / stiffness);
        Self {
            planes: [
                slope_in(section, Plane::ForeAft, fore_aft),
                slope_in(section, Plane::SideSide, side_side),
            ],
            axial: from_fn(|i| {
                let [k, flexibility, value] = [springs[i], flexibilities[i], self.axial[i]];
                match is_held[i] {
                    true => flexibility - k * value * value,
                    false => k - flexibility * value * value,
                }
            }),
        }
    }
}

fn slope_in(section: &Section, plane: Plane, [k_l, k_lr, k_r]: [f64; 3]) -> [f64; 3] {
    let bending = 1.0 / section.bending_n_m2.of(plane);
    let shear = section.shear_flexibility_per_n.of(plane);
    [
        section.soil.transverse().of(plane) - shear * k_l * k_l - bending * k_lr * k_lr,
        -shear * k_l * k_lr - bending * k_lr * k_r - k_l,
        section.soil.rotation().of(plane) - shear * k_lr * k_lr - bending * k_r * k_r - 2.0 * k_lr,
    ]
}

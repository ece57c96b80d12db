//! The springs of the soil of a tower, and the stiffness of its pile at the surface of the ground.

use super::super::closed_form::HeadStiffness;
use super::super::model::Tower;
use super::super::parts::surroundings::SoilStiffness;
use super::super::pieces::piece::Piece;
use super::super::pieces::planes::Plane;

/// Lowest number of steps of the integration over the embedded length.
const STEPS: f64 = 1000.0;

/// Springs of the soil at a height of a tower.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SpringsAt {
    /// The height, m.
    pub height_m: f64,
    /// Against translation x and y, N/m².
    pub lateral_n_per_m2: f64,
    /// Against translation z, N/m².
    pub vertical_n_per_m2: f64,
    /// Against rotation of the section about x and y, N m per radian and metre.
    pub rotation_n: f64,
    /// Against rotation about the axis, N m per radian and metre.
    pub torsion_n: f64,
}

/// Springs of the soil under the tip of a pile.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TipSprings {
    /// Height of the tip, m.
    pub height_m: f64,
    /// Against translation x and y, N/m.
    pub lateral_n_per_m: f64,
    /// Against rotation about x and y, N m.
    pub rocking_n_m: f64,
    /// Against translation z, N/m.
    pub vertical_n_per_m: f64,
    /// Against rotation about the axis, N m.
    pub torsion_n_m: f64,
}

/// The static stiffness of a pile and its soil along and about its axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxialHead {
    /// Force per displacement z, N/m; infinite if the motion is rigidly held.
    pub vertical_n_per_m: f64,
    /// Moment per rotation about the axis, N m; infinite if the motion is rigidly held.
    pub torsion_n_m: f64,
}

impl Tower {
    /// The springs of the soil in layers under the tip of the pile, with the motions that the base
    /// is free in; none if a model of the layer at the tip gives no springs there, without
    /// [ground](crate::TowerDescription::ground), and on a frame. The stiffness of the
    /// [base](Self::base) contains them.
    pub fn springs_at_tip(&self) -> Option<TipSprings> {
        let at_tip = self.ground.as_ref()?.at_tip;
        let moves = self.base().moves;
        let acting = |i: usize| if moves[i] { at_tip[i] } else { 0.0 };
        let springs = TipSprings {
            height_m: self.base_m(),
            lateral_n_per_m: acting(0),
            rocking_n_m: acting(4),
            vertical_n_per_m: acting(2),
            torsion_n_m: acting(5),
        };
        (0..6).any(|i| acting(i) > 0.0).then_some(springs)
    }

    /// The static stiffness of the embedded pile at [`ground_surface_m`](Self::ground_surface_m),
    /// the surface of the [ground](crate::TowerDescription::ground) in the fore-aft plane; none
    /// without ground, with a tip that is not held by springs alone, and with piles of a frame.
    ///
    /// The stiffness K at the upper end of a part of the pile grows by the springs of the soil,
    /// loses the flexibility of the pile and moves with its point of reference:
    ///
    /// - dK_L/dz = k − K_L²/κGA − K_LR²/EI,
    /// - dK_LR/dz = −K_L K_LR/κGA − K_LR K_R/EI − K_L,
    /// - dK_R/dz = k_θ − K_LR²/κGA − K_R²/EI − 2 K_LR.
    ///
    /// It is integrated from the tip up.
    pub fn pile_head(&self) -> Option<HeadStiffness> {
        self.stiffness_at(self.ground_surface_m()?, Plane::ForeAft)
    }

    /// The height (m) of the uppermost soil around or under the tower, and the static stiffness of
    /// pile and foundation there in the fore-aft plane: at the surface of the ground, at the
    /// highest of the rows of [`soil`](crate::TowerDescription::soil), or at the base. None where
    /// the base is held by more than springs, on a frame, and for a tower that floats.
    pub fn foundation_head(&self) -> Option<(f64, HeadStiffness)> {
        let height_m = self.foundation_head_m()?;
        Some((height_m, self.stiffness_at(height_m, Plane::ForeAft)?))
    }

    /// The stiffness of [`foundation_head`](Self::foundation_head) in the side-side plane: force
    /// and moment for the displacement y and the rotation about −x.
    pub fn foundation_head_side_side(&self) -> Option<HeadStiffness> {
        self.stiffness_at(self.foundation_head_m()?, Plane::SideSide)
    }

    /// The axial stiffness at the height of [`foundation_head`](Self::foundation_head); none on a
    /// frame and for a tower that floats.
    pub fn foundation_head_axial(&self) -> Option<AxialHead> {
        let height_m = self.foundation_head_m()?;
        Some(AxialHead {
            vertical_n_per_m: self.axial_stiffness_at(height_m, 2),
            torsion_n_m: self.axial_stiffness_at(height_m, 5),
        })
    }

    fn foundation_head_m(&self) -> Option<f64> {
        if self.base().floats || self.base().on_frame {
            return None;
        }
        let pieces = self.pieces().iter().rev();
        let mut in_soil = pieces.filter(|piece| piece.environment.soil.is_some());
        let rows_m = || in_soil.next().map(|piece| piece.top_m);
        let surface_m = self.ground_surface_m().or_else(rows_m);
        Some(surface_m.unwrap_or(self.base_m()))
    }

    /// The static stiffness at a height (m) of the pile and soil below, without water and weight.
    fn stiffness_at(&self, surface_m: f64, plane: Plane) -> Option<HeadStiffness> {
        let base = self.base();
        let (translation, rotation, sign) = match plane {
            Plane::ForeAft => (0, 4, 1.0),
            Plane::SideSide => (1, 3, -1.0),
        };
        if base.on_frame || !(base.moves[translation] && base.moves[rotation]) {
            return None;
        }
        let k = &base.stiffness;
        let at_tip = [
            k[translation][translation],
            sign * k[translation][rotation],
            k[rotation][rotation],
        ];
        let slope = |piece: &Piece, height_m: f64, k| slope(piece, (height_m, plane), k);
        let [lateral_n_per_m, coupling_n, rocking_n_m] =
            self.integrated_to(surface_m, at_tip, slope);
        Some(HeadStiffness {
            lateral_n_per_m,
            coupling_n,
            rocking_n_m,
        })
    }

    /// The static stiffness at a height (m) against translation along the axis (2) or rotation
    /// about it (5).
    ///
    /// - dK/dz = k − K²/EA with the springs k of the soil; GJ in place of EA for the rotation.
    /// - If the motion is rigidly held at the base, 1/K is integrated: d(1/K)/dz = 1/EA − k/K².
    fn axial_stiffness_at(&self, surface_m: f64, motion: usize) -> f64 {
        let base = self.base();
        let values = |piece: &Piece, height_m: f64| {
            let section = piece.section_at(height_m);
            let soil = &section.soil;
            match motion {
                2 => (soil.z_n_per_m2, section.axial_n),
                _ => (soil.torsion_n, section.torsion_n_m2),
            }
        };
        let is_held = !base.moves[motion];
        let slope = |piece: &Piece, height_m: f64, [k]: [f64; 1]| {
            let (spring, section) = values(piece, height_m);
            match is_held {
                true => [1.0 / section - spring * k * k],
                false => [spring - k * k / section],
            }
        };
        let at_tip = if is_held {
            0.0
        } else {
            base.stiffness[motion][motion]
        };
        let [value] = self.integrated_to(surface_m, [at_tip], slope);
        if is_held { 1.0 / value } else { value }
    }

    /// Values at the base, integrated up to a height (m) with their slope along the pile.
    fn integrated_to<const N: usize>(
        &self,
        surface_m: f64,
        mut values: [f64; N],
        slope: impl Fn(&Piece, f64, [f64; N]) -> [f64; N],
    ) -> [f64; N] {
        let step_m = (surface_m - self.base_m()) / STEPS;
        for piece in self.pieces() {
            let length_m = piece.top_m.min(surface_m) - piece.base_m;
            if length_m <= 0.0 {
                break;
            }
            let steps = (length_m / step_m).ceil().max(4.0);
            let own_m = length_m / steps;
            for step in 0..steps as usize {
                let slope = |share: f64, k: [f64; N]| {
                    slope(piece, piece.base_m + (step as f64 + share) * own_m, k)
                };
                values = runge_kutta(values, own_m, slope);
            }
        }
        values
    }

    /// The springs of the soil along a tower in [ground](crate::TowerDescription::ground) by rising
    /// height: at both ends of each piece of the tower that is in soil, so twice at a step, with
    /// rows of [`soil`](crate::TowerDescription::soil) there. Empty without ground.
    pub fn springs_of_soil(&self) -> Vec<SpringsAt> {
        let mut springs: Vec<SpringsAt> = Vec::new();
        if self.ground.is_none() {
            return springs;
        }
        for piece in self.pieces() {
            if let Some([low, high]) = &piece.environment.soil {
                springs.push(SpringsAt::new(piece.base_m, low));
                springs.push(SpringsAt::new(piece.top_m, high));
            }
        }
        springs.dedup();
        springs
    }
}

/// Springs of the soil along a member of the frame below a tower.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SpringsOfMember {
    /// Name of the member.
    pub member: String,
    /// By rising height, twice where they jump: lateral across the member, vertical along it, per
    /// length of the member.
    pub springs: Vec<SpringsAt>,
}

impl Tower {
    /// The springs of the soil along the piles of the frame below a tower in
    /// [ground](crate::TowerDescription::ground), member by member. Empty without both.
    pub fn springs_of_members(&self) -> Vec<SpringsOfMember> {
        let frame = self.frame.as_ref().filter(|_| self.ground.is_some());
        let Some(frame) = frame.map(|foundation| foundation.frame.description()) else {
            return Vec::new();
        };
        let members = frame
            .members
            .iter()
            .filter(|member| !member.soil.is_empty());
        let of_member = members.map(|member| {
            let [from_m, to_m] = member.joints.map(|joint| frame.joints[joint].position_m[2]);
            let rows = member.soil.iter().flat_map(|soil| &soil.rows);
            let mut springs: Vec<SpringsAt> = rows
                .map(|row| SpringsAt::new(from_m + row.fraction * (to_m - from_m), &row.stiffness))
                .collect();
            if to_m < from_m {
                springs.reverse();
            }
            springs.sort_by(|a, b| a.height_m.total_cmp(&b.height_m));
            springs.dedup();
            SpringsOfMember {
                member: member.name.clone(),
                springs,
            }
        });
        of_member.collect()
    }
}

impl SpringsAt {
    fn new(height_m: f64, soil: &SoilStiffness) -> Self {
        Self {
            height_m,
            lateral_n_per_m2: soil.x_n_per_m2,
            vertical_n_per_m2: soil.z_n_per_m2,
            rotation_n: soil.rotation_y_n,
            torsion_n: soil.torsion_n,
        }
    }
}

fn slope(piece: &Piece, (height_m, plane): (f64, Plane), [l, c, r]: [f64; 3]) -> [f64; 3] {
    let section = piece.section_at(height_m);
    let bending = 1.0 / section.bending_n_m2.of(plane);
    let shear = section.shear_flexibility_per_n.of(plane);
    [
        section.soil.transverse().of(plane) - shear * l * l - bending * c * c,
        -shear * l * c - bending * c * r - l,
        section.soil.rotation().of(plane) - shear * c * c - bending * r * r - 2.0 * c,
    ]
}

/// One step of the classical method of Runge and Kutta.
fn runge_kutta<const N: usize>(
    k: [f64; N],
    step: f64,
    slope: impl Fn(f64, [f64; N]) -> [f64; N],
) -> [f64; N] {
    let ahead = |slope: [f64; N], by: f64| std::array::from_fn(|i| k[i] + by * slope[i]);
    let a = slope(0.0, k);
    let b = slope(0.5, ahead(a, 0.5 * step));
    let c = slope(0.5, ahead(b, 0.5 * step));
    let d = slope(1.0, ahead(c, step));
    std::array::from_fn(|i| k[i] + step * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0)
}

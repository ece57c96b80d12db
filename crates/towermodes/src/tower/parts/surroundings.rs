//! The surroundings of a tower as given by the user: soil, water, guy wires.

use super::super::pieces::planes::Planes;
use crate::inputs::{Input, Inputs, Limit};

/// One row of soil springs along the tower; springs are linear in the height between rows, and zero
/// outside them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SoilRow {
    /// Height z in the datum of the stations, m.
    pub height_m: f64,
    /// The springs there.
    pub stiffness: SoilStiffness,
}

/// Springs to the ground per length of tower.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SoilStiffness {
    /// Spring per length against translation in x, N/m².
    pub x_n_per_m2: f64,
    /// Spring per length against translation in y, N/m².
    pub y_n_per_m2: f64,
    /// Spring per length against translation in z, N/m².
    pub z_n_per_m2: f64,
    /// Spring per length against rotation about the axis, N m per radian and metre.
    pub torsion_n: f64,
    /// Spring per length against rotation of the section about x (in the side-side plane), N m per
    /// radian and metre.
    ///
    /// Friction along the wall of a wide pile resists its rotation: the m-ψ springs of PISA (Byrne
    /// et al. 2020). With shear deformation the rotation of a section differs from the slope of the
    /// axis.
    pub rotation_x_n: f64,
    /// Spring per length against rotation of the section about y (in the fore-aft plane), N m per
    /// radian and metre.
    pub rotation_y_n: f64,
}

impl SoilStiffness {
    /// Number of springs.
    pub(crate) const SPRINGS: usize = 6;

    /// Spring per length against deflection in each plane, N/m².
    #[inline]
    pub fn transverse(&self) -> Planes<f64> {
        Planes {
            fore_aft: self.x_n_per_m2,
            side_side: self.y_n_per_m2,
        }
    }

    /// Spring per length against rotation of the section in each plane, N m per radian and metre.
    #[inline]
    pub fn rotation(&self) -> Planes<f64> {
        Planes {
            fore_aft: self.rotation_y_n,
            side_side: self.rotation_x_n,
        }
    }

    /// All its values.
    pub(crate) fn values(&self) -> [f64; Self::SPRINGS] {
        [
            self.x_n_per_m2,
            self.y_n_per_m2,
            self.z_n_per_m2,
            self.torsion_n,
            self.rotation_x_n,
            self.rotation_y_n,
        ]
    }

    pub(crate) fn from_values(
        [
            x_n_per_m2,
            y_n_per_m2,
            z_n_per_m2,
            torsion_n,
            rotation_x_n,
            rotation_y_n,
        ]: [f64; Self::SPRINGS],
    ) -> Self {
        Self {
            x_n_per_m2,
            y_n_per_m2,
            z_n_per_m2,
            torsion_n,
            rotation_x_n,
            rotation_y_n,
        }
    }

    /// The springs at the fraction `s` of the way from these to `top`.
    #[inline]
    pub(crate) fn blend(&self, top: &Self, s: f64) -> Self {
        let (a, b) = (self.values(), top.values());
        Self::from_values(std::array::from_fn(|i| a[i] + s * (b[i] - a[i])))
    }

    /// The springs multiplied by a factor.
    pub(crate) fn times(&self, factor: f64) -> Self {
        Self::from_values(self.values().map(|spring| factor * spring))
    }

    /// The sum of these springs and others.
    pub(crate) fn and(&self, other: &Self) -> Self {
        let (a, b) = (self.values(), other.values());
        Self::from_values(std::array::from_fn(|i| a[i] + b[i]))
    }
}

/// One row of a table of added mass, which moves with the tower transversely but is not part of
/// it; linear in height between rows, zero outside them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AddedMassRow {
    /// Height z in the datum of the stations, m.
    pub height_m: f64,
    /// Mass per length, kg/m, for motion in x and y.
    pub mass_kg_per_m: f64,
}

/// Still water around the tower, and in it if it is flooded: mass for transverse motion.
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
pub struct Water {
    /// Height of the surface in the datum of the stations, m.
    #[input(Input::height("level", "the water level")
        .hint("height of the surface in m, in the datum of the stations")
        .also("water_level sea_level msl swl surface waterline"))]
    pub level_m: f64,
    /// Height of the seabed, m; `None` stands for the lowest station, the lowest joint of a
    /// substructure, or the surface of
    /// [`TowerDescription::ground`](crate::TowerDescription::ground), which scour lowers.
    #[input(Input::height("bed", "the height of the seabed")
        .otherwise("the lowest station, or the lowest joint of a substructure")
        .also("mudline seabed ground sea_bed depth water_depth"))]
    pub bed_m: Option<f64>,
    /// Density ρ, kg/m³.
    #[input(Input::new("density", " kg/m3", Limit::Positive, "the density of the water")
        .or(Water::SEA_KG_PER_M3)
        .usual([900.0, 1100.0], "sea water has 1025; the unit is kg/m3"))]
    pub density_kg_per_m3: f64,
    /// Added mass coefficient C_a: the water outside moves with the mass ρ C_a π D²/4 per length,
    /// between bed and level.
    #[input(Input::new("added_mass_coefficient", "", Limit::NotNegative, "the added mass coefficient")
        .or(Water::CYLINDER)
        .usual([0.0, 2.0], "a cylinder has about 1")
        .also("ca c_a cm_coefficient added_mass_coeff"))]
    pub added_mass_coefficient: f64,
    /// Whether there is water inside too: ρ π (D − 2t)²/4 per length, from the lowest station to
    /// the level.
    #[input(Input::flag("flooded", "the water inside")
        .note("whether there is water inside")
        .also("inside_water flood internal_water"))]
    pub flooded: bool,
}

impl Water {
    /// Density of sea water, kg/m³.
    pub const SEA_KG_PER_M3: f64 = 1025.0;
    /// Added mass coefficient of a cylinder in potential flow.
    pub const CYLINDER: f64 = 1.0;

    /// The height of the seabed, m: without a given one that of the lowest station.
    pub(crate) fn bed_above_m(&self, lowest_station_m: f64) -> f64 {
        self.bed_m.unwrap_or(lowest_station_m)
    }
}

/// Taut wires from one height of the tower to the ground, equally spaced around it.
///
/// n ≥ 3 wires of stiffness k each at an angle α from the horizontal hold the tower's axis with n/2
/// k cos²α in every horizontal direction and with n k sin²α vertically. Their tension, and that
/// they are fixed to the shell and not to the axis, is neglected.
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
pub struct Wires {
    /// Height of their upper ends in the datum of the stations, m.
    #[input(Input::height("height", "the height of the upper ends")
        .note("of their upper ends")
        .hint("height of their upper ends in m, in the datum of the stations"))]
    pub height_m: f64,
    /// Number n of wires, at least three.
    #[input(Input::new("count", "", Limit::AtLeast(3), "the number of guy wires in the set")
        .note("number of wires, equally spaced")
        .hint("number of equally spaced wires")
        .remedy("count is the number of equally spaced guy wires")
        .usual([f64::NEG_INFINITY, 24.0], "typical: 3 to 12")
        .also("n number number_of_wires n_wires wires"))]
    pub count: usize,
    /// Axial stiffness k = EA/L of each wire, N/m.
    #[input(Input::new("stiffness", " N/m", Limit::Spring, "the stiffness EA/L of each wire")
        .note("EA/L of each wire")
        .hint("EA/L of each wire in N/m")
        .also("ea_l wire_stiffness"))]
    pub stiffness_n_per_m: f64,
    /// Angle α of the wires from the horizontal, degrees.
    #[input(Input::new("angle_deg", " degrees", Limit::Slope, "the angle of the guy wires from the horizontal")
        .note("from the horizontal")
        .hint("angle from the horizontal in degrees")
        .also("angle inclination slope"))]
    pub angle_deg: f64,
}

impl Wires {
    /// Stiffness n/2 k cos²α in every horizontal direction, N/m.
    pub fn horizontal_n_per_m(&self) -> f64 {
        let cosine = self.angle_deg.to_radians().cos();
        0.5 * self.count as f64 * self.stiffness_n_per_m * cosine * cosine
    }

    /// Stiffness n k sin²α vertically, N/m.
    pub fn vertical_n_per_m(&self) -> f64 {
        let sine = self.angle_deg.to_radians().sin();
        self.count as f64 * self.stiffness_n_per_m * sine * sine
    }
}

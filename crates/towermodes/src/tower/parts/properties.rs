//! Section properties per length for towers that are not tubes, and their variation between rows.

use super::super::pieces::planes::Planes;
use super::super::pieces::section::{Section, SectionMasses};
use super::surroundings::SoilStiffness;

/// The section properties in a row of a property table.
///
/// Between two rows mass, stiffnesses and squared radii of gyration (inertia over mass) are linear
/// in height, as BModes interpolates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Properties {
    /// Mass per length, kg/m.
    pub mass_kg_per_m: f64,
    /// Rotary inertia per length that resists bending in each plane, kg m; may be zero.
    pub rotary_inertia_kg_m: Planes<f64>,
    /// Inertia per length about the tower's axis, kg m; may be zero if the tower does not twist.
    pub polar_inertia_kg_m: f64,
    /// Bending stiffness EI in each plane, N m².
    pub bending_n_m2: Planes<f64>,
    /// Torsional stiffness GJ, N m²; infinite, in all rows of a table, for a tower that does not
    /// twist.
    pub torsion_n_m2: f64,
    /// Axial stiffness EA, N; infinite, in all rows of a table, for a tower that does not stretch.
    pub axial_n: f64,
    /// Shear stiffness κGA in each plane, N; none for a tower without shear deformation.
    pub shear_n: Option<Planes<f64>>,
}

impl Properties {
    /// The section at the fraction `s` of the way from this row to `top`.
    #[inline]
    pub(crate) fn blend(&self, top: &Self, s: f64) -> Section {
        // An infinite stiffness is infinite in all rows.
        let blend = |a: f64, b: f64| if a == b { a } else { a + s * (b - a) };
        let mass_kg_per_m = blend(self.mass_kg_per_m, top.mass_kg_per_m);
        let inertia =
            |a: f64, b: f64| mass_kg_per_m * blend(a / self.mass_kg_per_m, b / top.mass_kg_per_m);
        let shear_flexibility =
            |(a, b): (Planes<f64>, Planes<f64>)| a.zip(b, |a, b| 1.0 / blend(a, b));
        Section {
            masses: SectionMasses {
                mass_kg_per_m,
                water_kg_per_m: 0.0,
                rotary_inertia_kg_m: self
                    .rotary_inertia_kg_m
                    .zip(top.rotary_inertia_kg_m, inertia),
                polar_inertia_kg_m: inertia(self.polar_inertia_kg_m, top.polar_inertia_kg_m),
            },
            bending_n_m2: self.bending_n_m2.zip(top.bending_n_m2, blend),
            torsion_n_m2: blend(self.torsion_n_m2, top.torsion_n_m2),
            axial_n: blend(self.axial_n, top.axial_n),
            shear_flexibility_per_n: self
                .shear_n
                .zip(top.shear_n)
                .map_or(Planes::both(0.0), shear_flexibility),
            soil: SoilStiffness::default(),
        }
    }

    /// The row at the fraction `s` of the way from this row to `top`.
    pub(crate) fn row_at(&self, top: &Self, s: f64) -> Self {
        let section = self.blend(top, s);
        Self {
            mass_kg_per_m: section.masses.mass_kg_per_m,
            rotary_inertia_kg_m: section.masses.rotary_inertia_kg_m,
            polar_inertia_kg_m: section.masses.polar_inertia_kg_m,
            bending_n_m2: section.bending_n_m2,
            torsion_n_m2: section.torsion_n_m2,
            axial_n: section.axial_n,
            shear_n: self
                .shear_n
                .map(|_| section.shear_flexibility_per_n.map(f64::recip)),
        }
    }

    /// The stiffnesses, all linear between rows; zero for a missing shear stiffness.
    pub(crate) fn stiffnesses(&self) -> [f64; 6] {
        let (bending, shear) = (self.bending_n_m2, self.shear_n.unwrap_or_default());
        [
            bending.fore_aft,
            bending.side_side,
            self.torsion_n_m2,
            self.axial_n,
            shear.fore_aft,
            shear.side_side,
        ]
    }

    /// The properties with mass and inertias multiplied by `factor`.
    pub(crate) fn heavier(&self, factor: f64) -> Self {
        Self {
            mass_kg_per_m: factor * self.mass_kg_per_m,
            rotary_inertia_kg_m: self.rotary_inertia_kg_m.map(|inertia| factor * inertia),
            polar_inertia_kg_m: factor * self.polar_inertia_kg_m,
            ..*self
        }
    }

    /// Whether both bending planes are equal.
    pub(crate) fn planes_are_equal(&self) -> bool {
        self.bending_n_m2.are_equal()
            && self.rotary_inertia_kg_m.are_equal()
            && self.shear_n.is_none_or(|shear| shear.are_equal())
    }
}

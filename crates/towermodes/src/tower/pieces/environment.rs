//! The soil and the water around a piece of a tower.

use super::super::parts::surroundings::SoilStiffness;
use super::section::Tube;

/// The soil and the water around a piece: soil springs, water on either side of the wall.
///
/// Soil springs and the added mass of tables are linear between the ends of the piece.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Environment {
    /// Soil springs per length at the lower and the upper end; `None` without soil.
    pub soil: Option<[SoilStiffness; 2]>,
    /// Added mass of tables at the lower and the upper end, kg/m, which moves with the tower
    /// transversely only; `None` without a table.
    pub added_kg_per_m: Option<[f64; 2]>,
    /// ρ C_a π/4 where there is water outside, kg/m³: times D² the added mass per length.
    pub outside_kg_per_m3: f64,
    /// ρ π/4 where there is water inside, kg/m³: times (D − 2t)² its mass per length.
    pub inside_kg_per_m3: f64,
}

impl Environment {
    /// Mass of the water that moves transversely with a tube, kg/m.
    #[inline]
    pub(crate) fn water_kg_per_m(&self, tube: &Tube) -> f64 {
        let (d, inner) = (tube.outer_diameter_m, tube.inner_diameter_m());
        self.outside_kg_per_m3 * d * d + self.inside_kg_per_m3 * inner * inner
    }

    /// Added mass of tables at the fraction `s` of the piece's length, kg/m.
    #[inline]
    pub(super) fn added_kg_per_m_at(&self, s: f64) -> f64 {
        self.added_kg_per_m
            .map_or(0.0, |[base, top]| base + s * (top - base))
    }

    /// Soil springs at the fraction `s` of the piece's length.
    #[inline]
    pub(super) fn soil_at(&self, s: f64) -> SoilStiffness {
        self.soil
            .map_or_else(SoilStiffness::default, |[base, top]| base.blend(&top, s))
    }
}

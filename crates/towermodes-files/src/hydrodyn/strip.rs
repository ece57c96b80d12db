//! Members whose water is that of strips of a cylinder (Morison), in stretches in which all values
//! are linear.

use super::spatial::Vector;

/// A straight circular member.
#[derive(Debug, Clone, PartialEq)]
pub struct StripMember {
    /// Its number in the file.
    pub name: String,
    /// Its ends, m.
    pub ends_m: [[f64; 3]; 2],
    /// Whether the water around it is that of the potential-flow body (PropPot): then only its
    /// filling is its own.
    pub is_potential_flow: bool,
    /// Whether its buoyancy and water plane are included (MHstLMod).
    pub has_hydrostatics: bool,
    /// Its stretches, from the first end on.
    pub stretches: Vec<Stretch>,
}

/// A stretch of a member; values at both ends, linear between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Its ends, as fractions of the member's length from its first end.
    pub range: [f64; 2],
    /// Outer radius without growth, m.
    pub outer_radius_m: [f64; 2],
    /// Inner radius, m.
    pub inner_radius_m: [f64; 2],
    /// Whether it is between the seabed and the still water.
    pub is_wet: bool,
    /// Marine growth, if there is some.
    pub growth: Option<MarineGrowth>,
    /// Coefficients of added mass, where the water around it is its own.
    pub added_mass: Option<StripAddedMass>,
    /// Density of what fills it, kg/m³; 0 where it is empty.
    pub fill_density_kg_per_m3: f64,
}

/// Marine growth at both ends of a stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarineGrowth {
    /// Thickness, m.
    pub thickness_m: [f64; 2],
    /// Density, kg/m³.
    pub density_kg_per_m3: [f64; 2],
}

/// Coefficients of added mass at both ends of a stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripAddedMass {
    /// Across the axis: the added mass per length is ρ π R² Cₐ.
    pub across: [f64; 2],
    /// Along the axis: the added mass per length is 2 ρ π R² Cₓ |dR/ds|.
    pub along: [f64; 2],
}

/// A value of a stretch at a fraction of it.
pub(super) fn blend([from, to]: [f64; 2], fraction: f64) -> f64 {
    from + fraction * (to - from)
}

impl Stretch {
    /// Radius with growth at both ends, m.
    pub fn grown_radius_m(&self) -> [f64; 2] {
        let thickness_m = self.growth.map_or([0.0; 2], |growth| growth.thickness_m);
        std::array::from_fn(|end| self.outer_radius_m[end] + thickness_m[end])
    }
}

impl StripMember {
    /// Length, m.
    pub fn length_m(&self) -> f64 {
        super::spatial::norm(super::spatial::difference(self.ends_m[1], self.ends_m[0]))
    }

    /// The point at a fraction of its length.
    pub(super) fn point_m(&self, fraction: f64) -> Vector {
        super::spatial::between(self.ends_m[0], self.ends_m[1], fraction)
    }

    /// The direction of its axis.
    pub(super) fn axis(&self) -> Vector {
        let length = self.length_m();
        super::spatial::difference(self.ends_m[1], self.ends_m[0]).map(|x| x / length)
    }
}

//! Members with water by strip theory for cylinders or prisms (Morison), in stretches in which all
//! values are linear.

use towermodes::frame::member_axes;

use super::section::{Outline, StripSection, blend};
use super::spatial::{Tensor, Vector};

/// A straight member.
#[derive(Debug, Clone, PartialEq)]
pub struct StripMember {
    /// Its number in the file.
    pub name: String,
    /// Its ends, m.
    pub ends_m: [[f64; 3]; 2],
    /// Rotation of its section about its axis, degrees (MSpinOrient); without it the axes are those
    /// of the members of a frame.
    pub spin_deg: f64,
    /// Whether the water around it belongs to the potential-flow body (PropPot): then only its
    /// filling is used.
    pub is_potential_flow: bool,
    /// Whether its buoyancy and water plane are included (MHstLMod).
    pub has_hydrostatics: bool,
    /// Its stretches, from the first end on.
    pub stretches: Vec<Stretch>,
}

/// A stretch of a member; values are given at both ends and linear between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Its ends, as fractions of the member's length from its first end.
    pub range: [f64; 2],
    /// Its section.
    pub section: StripSection,
    /// Whether it is between the seabed and the still water level.
    pub is_wet: bool,
    /// Marine growth, if there is any.
    pub growth: Option<MarineGrowth>,
    /// Coefficients of added mass, if the water around it does not belong to the potential-flow
    /// body.
    pub added_mass: Option<StripAddedMass>,
    /// Density of the filling, kg/m³; 0 if it is empty.
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
    /// At each end, for motions along the local axes x and y: the added mass per length is ρ π R²
    /// Cₐ for a circle, where both are equal. For a rectangle with sides a along x and b along y it
    /// is ρ π b²/4 Cₐ along x (CaB of the file) and ρ π a²/4 Cₐ along y (CaA).
    pub across: [[f64; 2]; 2],
    /// Along the axis: the added mass per length is 2 ρ π R² Cₓ |dR/ds| for a circle and ½ ρ Cₓ (a
    /// |db/ds| + b |da/ds|) √(a b) for a rectangle.
    pub along: [f64; 2],
}

impl Stretch {
    /// The outer outline with growth at a fraction of the stretch.
    pub(super) fn grown(&self, fraction: f64) -> Outline {
        let outer = self.section.outer(fraction);
        outer.grown(blend(self.growth_m(), fraction))
    }

    /// The thickness of the growth at both ends, m.
    pub(super) fn growth_m(&self) -> [f64; 2] {
        self.growth.map_or([0.0; 2], |growth| growth.thickness_m)
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

    /// Its local axes x, y, z as rows; z is along the member.
    pub(super) fn axes(&self) -> Tensor {
        let [x, y, _] = member_axes(self.ends_m[0], self.ends_m[1], self.spin_deg);
        [x, y, self.axis()]
    }
}

//! Mass that moves with a stretch of a member: water around it, water in it, marine growth.

use std::f64::consts::PI;

use super::super::pieces::section::SectionMasses;

/// Mass that moves with a stretch of a member, between circles about its axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameCoat {
    /// Where it begins and ends, as fractions of the length from the first joint.
    pub range: [f64; 2],
    /// What it is, with its values at both ends; linear between them.
    pub kind: CoatKind,
}

/// A kind of mass that moves with a member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CoatKind {
    /// Mass that moves with the member in all directions and rotations, such as marine growth or
    /// water inside: ρ π (R² − r²) per length, with the rotary inertia ρ π (R⁴ − r⁴)/4. HydroDyn
    /// takes water inside a member as rigid too.
    Solid {
        /// Density ρ, kg/m³.
        density_kg_per_m3: [f64; 2],
        /// Outer radius R, m.
        outer_radius_m: [f64; 2],
        /// Inner radius r, m; 0 for a filling.
        inner_radius_m: [f64; 2],
    },
    /// Water around the member, which moves with it across its axis: ρ π R² Cₐ per length. Along
    /// the axis it has 2 ρ π R² Cₓ |dR/ds|.
    ///
    /// Source: Morison et al. (1950); HydroDyn Theory Manual (2024) along the axis.
    AddedMass {
        /// Density ρ of the water, kg/m³.
        density_kg_per_m3: f64,
        /// Radius R with growth, m.
        radius_m: [f64; 2],
        /// Coefficient Cₐ across the axis.
        across: [f64; 2],
        /// Coefficient Cₓ along the axis.
        along: [f64; 2],
    },
}

/// What the mass of a coat is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::tower) enum Substance {
    /// Marine growth around the member.
    Growth,
    /// Water, or another filling, in the member.
    Filling,
    /// Water around the member.
    Water,
}

impl CoatKind {
    /// The substance of its mass: a solid without a hole is a filling.
    pub(super) fn substance(&self) -> Substance {
        match self {
            Self::Solid { inner_radius_m, .. } if *inner_radius_m == [0.0; 2] => Substance::Filling,
            Self::Solid { .. } => Substance::Growth,
            Self::AddedMass { .. } => Substance::Water,
        }
    }
}

impl FrameCoat {
    /// Adds its masses at a fraction of a member of this length (m), if it is there. At its ends
    /// the values inside count: elements begin and end there.
    pub(super) fn add(&self, at: f64, length_m: f64, masses: &mut SectionMasses) {
        let [from, to] = self.range;
        if at < from || at > to {
            return;
        }
        let s = (at - from) / (to - from);
        let blend = |[a, b]: [f64; 2]| a + s * (b - a);
        match self.kind {
            CoatKind::Solid {
                density_kg_per_m3,
                outer_radius_m,
                inner_radius_m,
            } => {
                let (outer, inner) = (blend(outer_radius_m), blend(inner_radius_m));
                let squares = (outer - inner) * (outer + inner);
                let per_m = blend(density_kg_per_m3) * PI * squares;
                let rotary = 0.25 * per_m * (outer * outer + inner * inner);
                masses.mass_kg_per_m += per_m;
                masses.rotary_inertia_kg_m.fore_aft += rotary;
                masses.rotary_inertia_kg_m.side_side += rotary;
                masses.polar_inertia_kg_m += 2.0 * rotary;
            }
            CoatKind::AddedMass {
                density_kg_per_m3,
                radius_m,
                across,
                along,
            } => {
                let radius = blend(radius_m);
                let displaced = density_kg_per_m3 * PI * radius * radius;
                let slope = (radius_m[1] - radius_m[0]) / ((to - from) * length_m);
                let along = 2.0 * displaced * blend(along) * slope.abs();
                masses.water_kg_per_m += displaced * blend(across) - along;
                // The part that moves in all directions, subtracted across the axis.
                masses.mass_kg_per_m += along;
            }
        }
    }

    /// Sets its mass to zero and keeps its range.
    pub(super) fn remove_mass(&mut self) {
        match &mut self.kind {
            CoatKind::Solid {
                density_kg_per_m3, ..
            } => *density_kg_per_m3 = [0.0; 2],
            CoatKind::AddedMass {
                density_kg_per_m3, ..
            } => *density_kg_per_m3 = 0.0,
        }
    }

    /// Mass of a solid on a member of this length (m), kg; 0 for added mass.
    pub fn mass_kg(&self, length_m: f64) -> f64 {
        let CoatKind::Solid { .. } = self.kind else {
            return 0.0;
        };
        let [from, to] = self.range;
        let at = |s: f64| {
            let mut masses = SectionMasses::NONE;
            self.add(from + s * (to - from), length_m, &mut masses);
            masses.mass_kg_per_m
        };
        // The density times the square of the radius is cubic: Simpson's rule is exact.
        (to - from) * length_m * (at(0.0) + 4.0 * at(0.5) + at(1.0)) / 6.0
    }
}

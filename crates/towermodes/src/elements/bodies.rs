//! Pieces of tower as rigid bodies, prismatic or exact.

use super::Assembly;
use crate::chain::RigidBody;
use crate::tower::{Piece, Section, mass_integrals};

impl Assembly<'_> {
    /// Adds a rigid prismatic rod between two heights (m), about its middle.
    #[inline]
    pub(super) fn add_prismatic_body(&mut self, section: &Section, base_m: f64, top_m: f64) {
        let length = top_m - base_m;
        let mass_kg = section.mass_kg_per_m * length;
        let rotary = section.rotary_inertia_kg_m * length;
        let transverse = mass_kg * length * length / 12.0 + self.rotary_share() * rotary;
        let body = RigidBody {
            mass_kg,
            first_moment_kg_m: 0.0,
            inertia_xx_kg_m2: transverse,
            inertia_yy_kg_m2: transverse,
            inertia_zz_kg_m2: 2.0 * rotary,
        };
        self.chains.add_body(0.5 * (base_m + top_m), &body);
    }

    /// Adds the tower between two heights (m) as a rigid body with its exact mass, centre and inertia, about its middle.
    #[inline]
    pub(super) fn add_exact_body(&mut self, piece: &Piece, base_m: f64, top_m: f64) {
        let reference_m = 0.5 * (base_m + top_m);
        let mass = mass_integrals(piece, base_m, top_m, reference_m);
        let transverse = mass.second_moment_kg_m2 + self.rotary_share() * mass.rotary_inertia_kg_m2;
        let body = RigidBody {
            mass_kg: mass.mass_kg,
            first_moment_kg_m: mass.first_moment_kg_m,
            inertia_xx_kg_m2: transverse,
            inertia_yy_kg_m2: transverse,
            inertia_zz_kg_m2: 2.0 * mass.rotary_inertia_kg_m2,
        };
        self.chains.add_body(reference_m, &body);
    }

    /// The share of the sections' own rotary inertia in bending: 1, or 0 for an Euler-Bernoulli beam.
    fn rotary_share(&self) -> f64 {
        f64::from(u8::from(self.recipe.rotary_inertia))
    }
}

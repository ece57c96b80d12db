//! Pieces of tower as rigid bodies, prismatic or exact.

use super::Assembly;
use crate::chain::{JointFlexibility, RigidBody};
use crate::tower::{Piece, Planes, Section, mass_integrals};

impl Assembly<'_> {
    /// Adds a rigid prismatic rod between two heights (m), about its middle.
    #[inline]
    pub(super) fn add_prismatic_body(&mut self, section: &Section, base_m: f64, top_m: f64) {
        let length = top_m - base_m;
        let mass_kg = section.masses.mass_kg_per_m * length;
        let rotary = section.masses.rotary_inertia_kg_m.map(|i| i * length);
        let (second, polar) = (
            mass_kg * length * length / 12.0,
            section.masses.polar_inertia_kg_m * length,
        );
        let body = self.body(mass_kg, 0.0, second, rotary, polar);
        self.chains.add_body(0.5 * (base_m + top_m), &body);
    }

    /// Adds the tower between two heights (m) as a rigid body with its exact mass, centre and inertia, about its middle.
    #[inline]
    pub(super) fn add_exact_body(&mut self, piece: &Piece, base_m: f64, top_m: f64) {
        let reference_m = 0.5 * (base_m + top_m);
        let mass = mass_integrals(piece, base_m, top_m, reference_m);
        let body = self.body(
            mass.mass_kg,
            mass.first_moment_kg_m,
            mass.second_moment_kg_m2,
            mass.rotary_inertia_kg_m2,
            mass.polar_inertia_kg_m2,
        );
        self.chains.add_body(reference_m, &body);
    }

    /// A body whose sections have rotary inertia in bending only if the recipe says so.
    #[inline]
    fn body(
        &self,
        mass_kg: f64,
        first_moment_kg_m: f64,
        second_moment_kg_m2: f64,
        rotary_kg_m2: Planes<f64>,
        polar_kg_m2: f64,
    ) -> RigidBody {
        let rotary_share = f64::from(u8::from(self.recipe.rotary_inertia));
        let transverse = rotary_kg_m2.map(|rotary| second_moment_kg_m2 + rotary_share * rotary);
        RigidBody {
            mass_kg,
            first_moment_kg_m,
            inertia_xx_kg_m2: transverse.side_side,
            inertia_yy_kg_m2: transverse.fore_aft,
            inertia_zz_kg_m2: polar_kg_m2,
        }
    }

    /// Adds exact bodies between two heights (m), joined where `joints` say, with their heights (m).
    pub(super) fn add_exact_bodies<const N: usize>(
        &mut self,
        piece: &Piece,
        base_m: f64,
        top_m: f64,
        mut joints: [(f64, JointFlexibility); N],
    ) {
        joints.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut below_m = base_m;
        for (height_m, flexibility) in &joints {
            self.add_exact_body(piece, below_m, *height_m);
            self.chains.add_joint(*height_m, flexibility);
            below_m = *height_m;
        }
        self.add_exact_body(piece, below_m, top_m);
    }
}

//! Rigid bodies of segments with their soil and geometric stiffness, prismatic or exact, and the
//! joints between them.

use super::{Assembly, springs};
use crate::chain::JointFlexibility;
use crate::subsystem::MatrixKind;
use crate::tower::{
    Axisymmetric, Piece, Planes, Section, SoilStiffness, mass_integrals, soil_integrals,
};

impl Assembly<'_> {
    /// Adds a rigid prismatic rod between two heights (m), about its middle.
    #[inline]
    pub(super) fn add_prismatic_body(&mut self, section: &Section, base_m: f64, top_m: f64) {
        let (length, middle_m) = (top_m - base_m, 0.5 * (base_m + top_m));
        let masses = &section.masses;
        let transverse_kg = (masses.mass_kg_per_m + masses.water_kg_per_m) * length;
        let second = transverse_kg * length * length / 12.0;
        let inertia = Axisymmetric {
            bending: masses.rotary_inertia_kg_m.map(|rotary| {
                // Only some element types include the rotary inertia of sections in bending.
                let rotary = if self.recipe.rotary_inertia {
                    rotary * length
                } else {
                    0.0
                };
                [transverse_kg, 0.0, second + rotary]
            }),
            torsion: masses.polar_inertia_kg_m * length,
            axial: masses.mass_kg_per_m * length,
        };
        self.chains
            .add_axisymmetric(MatrixKind::Inertia, middle_m, &inertia);
        if section.soil != SoilStiffness::default() {
            let soil = prismatic_soil(&section.soil, length);
            self.chains
                .add_axisymmetric(MatrixKind::Foundation, middle_m, &soil);
        }
        if self.tower.gravity_m_per_s2() != 0.0 {
            let moment_n_m = self.tower.compression_integral_n_m(base_m, top_m);
            self.chains.add_geometric_stiffness(moment_n_m);
        }
    }

    /// Adds the tower between two heights (m) as a rigid body with its exact mass, centre and
    /// inertia, about its middle.
    #[inline]
    pub(super) fn add_exact_body(&mut self, piece: &Piece, base_m: f64, top_m: f64) {
        let reference_m = 0.5 * (base_m + top_m);
        let mass = mass_integrals(piece, base_m, top_m, reference_m);
        let inertia = mass.axisymmetric(self.recipe.rotary_inertia);
        self.chains
            .add_axisymmetric(MatrixKind::Inertia, reference_m, &inertia);
        if let Some(soil) = soil_integrals(piece, base_m, top_m, reference_m) {
            self.chains
                .add_axisymmetric(MatrixKind::Foundation, reference_m, &soil);
        }
        let gravity = self.tower.gravity_m_per_s2();
        if gravity != 0.0 {
            // A body that rotates by θ lowers everything above it, and itself: −½ θ² ∫ N dz, as
            // `Tower::compression_integral_n_m`.
            let above_n_m = self.compression_n(top_m) * (top_m - base_m);
            let moment_n_m = above_n_m + gravity * mass.moment_about_base_kg_m;
            self.chains.add_geometric_stiffness(moment_n_m);
        }
    }

    /// The axial compression at a height (m), N. The last value is kept, because the next joint is
    /// at the end of a body.
    #[inline]
    fn compression_n(&mut self, height_m: f64) -> f64 {
        if self.last_compression.0 != height_m {
            self.last_compression = (height_m, self.tower.compression_n(height_m));
        }
        self.last_compression.1
    }

    /// Adds a joint at a height (m).
    ///
    /// The work of a compression is the shear deflection times the rotation at the joint, which is
    /// between the rotations below and above it. So if the shear is large, the hinge is divided
    /// into two halves, below and above the shear deflection; with only one of these rotations the
    /// order of convergence would be lower by one.
    pub(super) fn add_joint(&mut self, height_m: f64, joint: &JointFlexibility) {
        if self.tower.gravity_m_per_s2() == 0.0 {
            self.chains.add_joint(height_m, joint, 0.0);
            return;
        }
        let compression_n = self.compression_n(height_m);
        if !(self.tower.shears() && joint.turns() && joint.slides()) {
            self.chains.add_joint(height_m, joint, compression_n);
            return;
        }
        let half = springs::hinge(joint.bending_per_n_m.map(|whole| 0.5 * whole));
        let shear = JointFlexibility {
            bending_per_n_m: Planes::default(),
            ..*joint
        };
        for joint in [&half, &shear, &half] {
            self.chains.add_joint(height_m, joint, compression_n);
        }
    }

    /// Adds exact bodies between two heights (m), connected by `joints` at these heights (m).
    pub(super) fn add_exact_bodies<const N: usize>(
        &mut self,
        piece: &Piece,
        base_m: f64,
        top_m: f64,
        mut joints: [(f64, JointFlexibility); N],
    ) {
        // In slightly changed towers the order of the joints stays the same. If two joints exchange
        // their heights, the body between them has negative mass, which compensates for the overlap
        // of its neighbours.
        if !self.tower.planes_are_apart() {
            joints.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        let mut below_m = base_m;
        for (height_m, flexibility) in &joints {
            self.add_exact_body(piece, below_m, *height_m);
            self.add_joint(*height_m, flexibility);
            below_m = *height_m;
        }
        self.add_exact_body(piece, below_m, top_m);
    }
}

/// Constant springs along a rod of a length (m), about its middle: k l against moving, k l³/12 and
/// k_r l against rotation.
fn prismatic_soil(soil: &SoilStiffness, length: f64) -> Axisymmetric {
    Axisymmetric {
        bending: soil.transverse().zip(soil.rotation(), |k, rotation| {
            let of_arms = k * length.powi(3) / 12.0;
            [k * length, 0.0, of_arms + rotation * length]
        }),
        torsion: soil.torsion_n * length,
        axial: soil.z_n_per_m2 * length,
    }
}

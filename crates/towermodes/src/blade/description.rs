//! The description of a rotating blade, as in BModes.

use crate::tower::RigidBody;

/// A blade that turns with a rotor at constant speed, clamped to the hub: an Euler-Bernoulli beam
/// with pretwist and offsets.
///
/// Axes: Z along the span outwards; at zero twist and pitch X is the lag direction (in the rotor's
/// plane) and Y the flap direction (out of it). The section's own axes are turned from X and Y by
/// twist + pitch, positive from X towards Y.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BladeDescription {
    /// Name given by the user.
    pub name: String,
    /// Radius of the hub, where the blade begins, m.
    pub hub_radius_m: f64,
    /// Radius of the tip, m.
    pub tip_radius_m: f64,
    /// Sections by increasing span; their values are linear in the span between them.
    pub sections: Vec<BladeSection>,
    /// Boundaries of the elements from the root to the tip, as fractions of the span, 0 to 1.
    pub borders: Vec<f64>,
    /// Speed of the rotor Ω, rad/s.
    pub rotor_speed_rad_per_s: f64,
    /// Pitch, rad; adds to the twist.
    pub pitch_rad: f64,
    /// Rigid body at the tip; its centre of mass, measured from the tip, and its inertia are given
    /// in the axes (X, Y, Z).
    pub tip: RigidBody,
    /// Whether the centrifugal force of the body at the tip is included; BModes 3.00 omits it.
    pub tip_is_pulled: bool,
}

/// A section of a blade.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BladeSection {
    /// Position as a fraction of the span: 0 at the root, 1 at the tip.
    pub span: f64,
    /// Structural twist, rad.
    pub twist_rad: f64,
    /// Mass per length, kg/m.
    pub mass_kg_per_m: f64,
    /// Inertia per length ∫ y² dm for turning in flap, kg m, with y along the section's own Y from
    /// the blade's axis (not from the centre of mass).
    ///
    /// In a blade that is solved alone, as in BModes, both inertias act in torsion alone; in a
    /// [turbine](crate::turbine::TurbineDescription::blade) they act in all rotations.
    pub flap_inertia_kg_m: f64,
    /// Inertia per length ∫ x² dm for turning in lag, kg m, with x along the section's own X from
    /// the blade's axis. It includes the inertia m x̄² of the mass per length m at its centre x̄,
    /// which is [`center_of_mass_m`](Self::center_of_mass_m), so it is at least m x̄².
    pub edge_inertia_kg_m: f64,
    /// Bending stiffness in flap, N m².
    pub flap_n_m2: f64,
    /// Bending stiffness in lag, N m².
    pub edge_n_m2: f64,
    /// Torsional stiffness GJ, N m²; infinite, in all sections, for a blade that does not twist.
    pub torsion_n_m2: f64,
    /// Axial stiffness EA, N; infinite, in all sections and without a tension centre off the axis,
    /// for a blade that does not stretch.
    pub axial_n: f64,
    /// Offset of the centre of mass from the axis along the section's own X, m.
    pub center_of_mass_m: f64,
    /// Offset of the tension centre from the axis along the section's own X, m.
    pub tension_center_m: f64,
}

/// Because of decimal rounding in the input, inertias may be too small by this fraction.
const ROUNDED: f64 = 1e-9;

impl BladeSection {
    /// The least edgewise inertia that a section with this mass and this centre of mass can have, m
    /// x̄², kg m: the inertia of a section whose whole mass is at x̄.
    pub fn least_edge_inertia_kg_m(&self) -> f64 {
        self.mass_kg_per_m * self.center_of_mass_m * self.center_of_mass_m
    }

    /// Whether the edgewise inertia is at least
    /// [`least_edge_inertia_kg_m`](Self::least_edge_inertia_kg_m), apart from rounding.
    pub fn inertia_suits_center_of_mass(&self) -> bool {
        self.edge_inertia_kg_m >= (1.0 - ROUNDED) * self.least_edge_inertia_kg_m()
    }
}

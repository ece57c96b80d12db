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
    /// Sections by increasing span; linear between them.
    pub sections: Vec<BladeSection>,
    /// Borders of the elements from the root to the tip, as shares of the span, 0 to 1.
    pub borders: Vec<f64>,
    /// Speed of the rotor Ω, rad/s.
    pub rotor_speed_rad_per_s: f64,
    /// Pitch, rad; adds to the twist.
    pub pitch_rad: f64,
    /// The body at the tip, its centre from the tip and all in (X, Y, Z).
    pub tip: RigidBody,
    /// Whether the rotation pulls the body at the tip too; BModes 3.00 leaves that out.
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
    /// Inertia per length for turning in flap, about the section's lag axis, kg m; acts in torsion
    /// alone.
    pub flap_inertia_kg_m: f64,
    /// Inertia per length for turning in lag, about the section's flap axis, kg m; acts in torsion
    /// alone.
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

//! Shear deformation of tubes.

/// Shear deformation of a tower made of tubes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Shear {
    /// No shear deformation: a Rayleigh beam (Euler-Bernoulli bending with rotary inertia).
    #[default]
    Rigid,
    /// Timoshenko beam, Cowper's (1966) coefficient of each section's tube.
    Cowper,
    /// Timoshenko beam with this coefficient κ everywhere (0 < κ ≤ 1).
    Coefficient(f64),
}

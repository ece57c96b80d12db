//! The rotor that turns freely about its shaft, geared to the generator.

use crate::inputs::{Input, Inputs, Limit};

/// Inertias about the shaft, for a rotor that turns freely. The inertia xx of the rotor-nacelle
/// assembly contains them as if the rotor was locked; the tilt of the shaft is neglected.
///
/// # Example
/// The Vestas V27 of the SWiFT site: the inertia about the wind direction is less than half when
/// the rotor is free.
/// ```
/// use towermodes::Drivetrain;
///
/// let v27 = Drivetrain {
///     rotor_inertia_kg_m2: 61_610.0,
///     generator_inertia_kg_m2: 50.0,
///     gear_ratio: 27.5647,
/// };
/// let nacelle = 70_660.0 - v27.locked_kg_m2();
/// assert!((nacelle + v27.free_kg_m2() - 30_826.0).abs() < 1.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
pub struct Drivetrain {
    /// Inertia of rotor and hub about the shaft, kg m².
    #[input(Input::new("rotor_inertia", " kg m2", Limit::Positive, "the inertia of the rotor")
        .note("of rotor and hub about the shaft")
        .hint("rotor and hub about the shaft, kg m2"))]
    pub rotor_inertia_kg_m2: f64,
    /// Inertia of the generator about its own shaft, kg m², not referred to the rotor shaft.
    #[input(Input::new("generator_inertia", " kg m2", Limit::NotNegative, "the inertia of the generator")
        .or(0.0)
        .quiet()
        .note("about its own shaft"))]
    pub generator_inertia_kg_m2: f64,
    /// Gear ratio q: turns of the generator per turn of the rotor relative to the nacelle; 1
    /// without a gearbox, negative if the generator turns in the opposite direction.
    #[input(Input::new("gear_ratio", "", Limit::Finite, "the gear ratio")
        .or(1.0)
        .quiet()
        .note("generator speed divided by rotor speed; 1 by default"))]
    pub gear_ratio: f64,
}

impl Drivetrain {
    /// Contribution of rotor and generator to the roll inertia of the nacelle if they are locked:
    /// J_r + J_g, kg m².
    pub fn locked_kg_m2(&self) -> f64 {
        self.rotor_inertia_kg_m2 + self.generator_inertia_kg_m2
    }

    /// Their contribution if no torque acts on the shaft: J_r J_g (1 − q)²/(J_r + J_g q²), kg m².
    ///
    /// When the nacelle rolls by θ and the rotor turns by φ, the generator turns by
    /// θ + q (φ − θ). The kinetic energy (J_r φ′² + J_g (θ′ + q (φ′ − θ′))²)/2 is smallest for the
    /// free φ, and then it is half of this inertia times θ′².
    pub fn free_kg_m2(&self) -> f64 {
        let (rotor, generator) = (self.rotor_inertia_kg_m2, self.generator_inertia_kg_m2);
        let q = self.gear_ratio;
        rotor * generator * (1.0 - q) * (1.0 - q) / (rotor + generator * q * q)
    }
}

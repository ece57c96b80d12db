//! The shape of a mode of a turbine, for pictures.

use crate::scalar::Complex;

/// The motion in a mode with the angular frequency w: complex amplitudes a of the motions Re(a e^(i
/// w t)).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TurbineShape {
    /// The tower, from its base to its top.
    pub tower: Vec<TowerMotion>,
    /// The apex of the rotor, where the axes of the blades meet: translation and rotation in the
    /// axes of the tower, with the yaw of the nacelle but without the rotation of the shaft
    /// relative to the nacelle.
    pub apex: [Complex; 6],
    /// The blades, from the apex to the tip.
    pub blades: Vec<BladeDeflection>,
}

/// The motion of a section of the tower.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TowerMotion {
    /// Height, m.
    pub height_m: f64,
    /// Translation and rotation in the axes x downwind, y left, z up.
    pub motion: [Complex; 6],
}

/// The motion of the same section of all blades, in the frame that turns with the rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BladeDeflection {
    /// Distance from the apex along the blade's axis, m.
    pub radius_m: f64,
    /// Amplitudes d of the translation, with the motion of the hub, by harmonic: collective,
    /// forward, backward, and the harmonic that does not move the hub. Each is in (along the shaft
    /// downwind, against the rotation, radial) at the azimuth of the blade.
    pub harmonics: [[Complex; 3]; 4],
    /// Number of periods of the fourth harmonic around the rotor; positive if the wave runs with
    /// the rotation.
    pub waves: isize,
}

impl BladeDeflection {
    /// The translation of the section of the blade at an azimuth ψ (rad; 0 is up), in (along the
    /// shaft, against the rotation, radial): d₀ + d₊ e^(−iψ) + d₋ e^(iψ) + dₙ e^(−inψ). Times e^(i
    /// w t) its real part is the motion at the time t.
    pub fn at(&self, azimuth_rad: f64) -> [Complex; 3] {
        let waves = [0.0, 1.0, -1.0, self.waves as f64];
        let turned = waves.map(|waves| {
            let (sin, cos) = (-waves * azimuth_rad).sin_cos();
            Complex::new(cos, sin)
        });
        std::array::from_fn(|i| {
            let all = self.harmonics.iter().zip(&turned);
            all.map(|(motion, turned)| motion[i] * *turned).sum()
        })
    }
}

//! The positions of the points of a turbine with rotating rotor, at rest and in a mode.

use towermodes::turbine::Complex;
use towermodes::turbine::{BladeDeflection, TowerMotion, Turbine};

/// A point in the axes of the tower: x downwind, y left, z up, m.
pub(super) type Place = [f64; 3];

/// A moment of a mode: the phase w t, the azimuth of the rotor, and the factor on deflections.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moment {
    /// Phase of the mode, rad.
    pub phase_rad: f64,
    /// Azimuth of the first blade, rad.
    pub turned_rad: f64,
    /// Metres for a deflection of 1.
    pub scale_m: f64,
}

/// The rotor of a turbine at rest.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Geometry {
    /// Its apex.
    pub apex_m: Place,
    /// The axes of the shaft: along it downwind, to the left, upwards.
    pub axes: [Place; 3],
    /// The cone angle, rad.
    pub cone_rad: f64,
    /// Number of blades.
    pub blades: usize,
}

impl Geometry {
    /// The geometry of a turbine.
    pub fn new(turbine: &Turbine) -> Self {
        let machine = turbine.machine();
        let (sin, cos) = machine.tilt_rad.sin_cos();
        let shaft_m = turbine.tower().top_m() + machine.tower_to_shaft_m;
        let overhang_m = machine.overhang_m;
        Self {
            apex_m: [overhang_m * cos, 0.0, shaft_m + overhang_m * sin],
            axes: [[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]],
            cone_rad: machine.cone_rad,
            blades: machine.blades,
        }
    }

    /// The azimuths of all blades for an azimuth of the first; 0 is up.
    pub fn azimuths(&self, first_rad: f64) -> Vec<f64> {
        let step = std::f64::consts::TAU / self.blades as f64;
        (0..self.blades)
            .map(|k| first_rad + step * k as f64)
            .collect()
    }

    /// The axes of a blade at an azimuth: along the shaft, against the rotation, radial.
    fn turned(&self, azimuth_rad: f64) -> [Place; 3] {
        let (sin, cos) = azimuth_rad.sin_cos();
        let [along, left, up] = self.axes;
        let mix = |a: f64, b: f64| std::array::from_fn(|i| a * left[i] + b * up[i]);
        [along, mix(cos, sin), mix(-sin, cos)]
    }

    /// A point of a blade at rest.
    pub fn at_rest(&self, radius_m: f64, azimuth_rad: f64) -> Place {
        let (sin, cos) = self.cone_rad.sin_cos();
        let [along, _, radial] = self.turned(azimuth_rad);
        let at = |i: usize| self.apex_m[i] + radius_m * (sin * along[i] + cos * radial[i]);
        std::array::from_fn(at)
    }

    /// A point of a blade in a mode. Its deflection includes the motion of the hub.
    pub fn deflected(&self, section: &BladeDeflection, azimuth_rad: f64, moment: &Moment) -> Place {
        let rest = self.at_rest(section.radius_m, azimuth_rad);
        let motion = section.at(azimuth_rad).map(|a| moment.real(a));
        let axes = self.turned(azimuth_rad);
        std::array::from_fn(|i| rest[i] + (0..3).map(|k| motion[k] * axes[k][i]).sum::<f64>())
    }
}

impl Moment {
    /// The real part of an amplitude at this moment, m.
    fn real(&self, amplitude: Complex) -> f64 {
        let (sin, cos) = self.phase_rad.sin_cos();
        self.scale_m * (amplitude.re * cos - amplitude.im * sin)
    }

    /// The position of a section of the tower.
    pub fn of_tower(&self, section: &TowerMotion) -> Place {
        let [x, y, z, ..] = section.motion.map(|a| self.real(a));
        [x, y, section.height_m + z]
    }
}

#[cfg(test)]
mod tests {
    use towermodes::turbine::BladeDeflection;
    use towermodes::turbine::Complex;

    use super::{Geometry, Moment};

    /// The hub moves to the left by Re(e^(i w t)): in the axes of a blade this is (0, cos ψ, −sin
    /// ψ), as waves e^(−iψ) and e^(iψ) it is (0, 1/2, −i/2) and (0, 1/2, i/2).
    #[test]
    fn blades_of_a_hub_that_moves_to_the_left_do_so_at_every_azimuth() {
        let (sin, cos) = 0.1_f64.sin_cos();
        let geometry = Geometry {
            apex_m: [-5.0, 0.0, 90.0],
            axes: [[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]],
            cone_rad: -0.05,
            blades: 3,
        };
        let none = [Complex::default(); 3];
        let wave = |side: f64| {
            [
                Complex::default(),
                Complex::new(0.5, 0.0),
                Complex::new(0.0, 0.5 * side),
            ]
        };
        let tip = BladeDeflection {
            radius_m: 60.0,
            harmonics: [none, wave(-1.0), wave(1.0), none],
            waves: 0,
        };
        let moment = Moment {
            phase_rad: 0.4,
            turned_rad: 0.7,
            scale_m: 3.0,
        };
        for azimuth in geometry.azimuths(moment.turned_rad) {
            let rest = geometry.at_rest(60.0, azimuth);
            let moved = geometry.deflected(&tip, azimuth, &moment);
            let shift = [0, 1, 2].map(|i| moved[i] - rest[i]);
            for (value, right) in shift.iter().zip([0.0, 3.0 * 0.4_f64.cos(), 0.0]) {
                assert!((value - right).abs() < 1e-13, "{shift:?}");
            }
        }
    }
}

//! The data of a script that animates the modes of a turbine with rotating rotor.

use serde::Serialize;
use towermodes::turbine::Complex;
use towermodes::turbine::{BladeDeflection, Turbine, TurbineMode, TurbineModes};

use super::geometry::{Geometry, Place};
use super::{MOST_SECTIONS, few, tower_heights};
use crate::figures::outline::outer_diameter_m;
use crate::figures::parts::RnaForm;
use crate::number::five_digits;

/// Half of the drawn width of a blade, at fractions of its length, as fractions of its length.
const HALF_WIDTHS: [(f64, f64); 4] = [(0.0, 0.013), (0.2, 0.024), (0.6, 0.016), (1.0, 0.004)];
/// Amplitudes are rounded to multiples of this; smaller ones are not visible.
const FINEST: f64 = 1e-4;

/// A turbine and its modes at a rotor speed, as the motion of a few sections. Amplitudes are
/// complex, given as real and imaginary part; a motion is the real part of a·e^(i w t). The largest
/// amplitude is 1.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WhirlAnimation {
    /// The rotor speed, rpm.
    pub rotor_speed_rpm: f64,
    /// Number of blades.
    pub blades: usize,
    /// Cone angle, rad; positive downwind.
    pub cone_rad: f64,
    /// The axes of the shaft: along it downwind, to the left, upwards.
    pub shaft_axes: [Place; 3],
    /// The apex of the rotor at rest, m.
    pub apex_m: Place,
    /// The corners of a nominal nacelle at rest, m.
    pub nacelle_m: Vec<Place>,
    /// Heights of the sections of the tower, m.
    pub height_m: Vec<f64>,
    /// Their radii, m.
    pub radius_m: Vec<f64>,
    /// Distances of the sections of a blade from the apex along the blade, m.
    pub span_m: Vec<f64>,
    /// Half their nominal widths, m.
    pub half_width_m: Vec<f64>,
    /// The modes by frequency.
    pub modes: Vec<AnimatedWhirl>,
}

/// A mode of an animated turbine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnimatedWhirl {
    /// Number in the list of modes, from 1.
    pub number: usize,
    /// Its name, at standstill with the motion of the nacelle: "1st flapwise backward whirl (yaw)".
    pub label: String,
    /// Natural frequency in the fixed frame, Hz.
    pub frequency_hz: f64,
    /// Translation of each section of the tower: x, y, z.
    pub tower: Vec<Vec<f64>>,
    /// Translation of the nacelle at the apex, and its rotation about x, y, z.
    pub nacelle: Vec<f64>,
    /// The motions of the blades that are not zero.
    pub harmonics: Vec<AnimatedHarmonic>,
}

/// A motion of the blades a·e^(−i n ψ), with the azimuth ψ of the blade.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnimatedHarmonic {
    /// The number n of waves around the rotor: 0 if all blades move in phase, positive for a wave
    /// that travels with the rotation.
    pub waves: isize,
    /// Translation of each section including that of the hub: along the shaft, against the
    /// rotation, radial.
    pub motion: Vec<Vec<f64>>,
}

/// The data of an animation of the modes of a turbine at a speed.
pub fn whirl_animation(turbine: &Turbine, modes: &TurbineModes) -> WhirlAnimation {
    let geometry = Geometry::new(turbine);
    let tower = turbine.tower();
    let heights_m = few(&tower_heights(turbine, modes), MOST_SECTIONS);
    let radius_m = |height: &f64| five_digits(0.5 * outer_diameter_m(tower, *height));
    let blade = modes.modes.first().map_or(&[][..], |m| &m.shape.blades);
    let span_m: Vec<f64> = few(blade, MOST_SECTIONS)
        .iter()
        .map(|s| s.radius_m)
        .collect();
    let animated = |(index, mode)| animated(index + 1, mode, heights_m.len());
    WhirlAnimation {
        rotor_speed_rpm: modes.rotor_speed_rpm,
        blades: geometry.blades,
        cone_rad: five_digits(geometry.cone_rad),
        shaft_axes: geometry.axes.map(|axis| axis.map(five_digits)),
        apex_m: geometry.apex_m.map(five_digits),
        nacelle_m: nacelle(turbine),
        radius_m: heights_m.iter().map(radius_m).collect(),
        height_m: heights_m.iter().copied().map(five_digits).collect(),
        half_width_m: half_widths_m(&span_m),
        span_m: span_m.into_iter().map(five_digits).collect(),
        modes: modes.modes.iter().enumerate().map(animated).collect(),
    }
}

fn animated(number: usize, mode: &TurbineMode, heights: usize) -> AnimatedWhirl {
    let shape = &mode.shape;
    // Blades that do not move the hub leave the tower at rest.
    let mut tower: Vec<Vec<f64>> = few(&shape.tower, MOST_SECTIONS)
        .iter()
        .map(|section| parts(&section.motion[..3], short))
        .collect();
    tower.resize(heights, vec![0.0; 6]);
    AnimatedWhirl {
        number,
        label: mode.label(),
        frequency_hz: five_digits(mode.frequency.frequency_hz),
        tower,
        // Rotations are per metre.
        nacelle: parts(&shape.apex, five_digits),
        harmonics: harmonics(&few(&shape.blades, MOST_SECTIONS)),
    }
}

/// The motions of the blades that are not zero.
fn harmonics(sections: &[BladeDeflection]) -> Vec<AnimatedHarmonic> {
    let waves = sections.first().map_or(0, |section| section.waves);
    let all = [0, 1, -1, waves].into_iter().enumerate();
    let of = |(index, waves): (usize, isize)| AnimatedHarmonic {
        waves,
        motion: sections
            .iter()
            .map(|section| parts(&section.harmonics[index], short))
            .collect(),
    };
    let moves = |harmonic: &AnimatedHarmonic| harmonic.motion.iter().flatten().any(|a| *a != 0.0);
    all.map(of).filter(moves).collect()
}

/// Real and imaginary parts alternating.
fn parts(amplitudes: &[Complex], digits: impl Fn(f64) -> f64) -> Vec<f64> {
    let parts = amplitudes.iter().flat_map(|a| [a.re, a.im]);
    parts.map(digits).collect()
}

/// An amplitude rounded to [`FINEST`].
fn short(amplitude: f64) -> f64 {
    five_digits((amplitude / FINEST).round() * FINEST)
}

/// The corners of a box around the tower top that extends to the hub.
fn nacelle(turbine: &Turbine) -> Vec<Place> {
    let (tower, machine) = (turbine.tower(), turbine.machine());
    let top_m = tower.top_m();
    let unit_m = RnaForm::UNITS * 0.5 * outer_diameter_m(tower, top_m);
    let half_m = machine.tower_to_shaft_m.abs().max(0.65 * unit_m);
    let downwind = if machine.overhang_m > 0.0 { 1.0 } else { -1.0 };
    let ends_m = [0.8 * machine.overhang_m, -2.1 * downwind * unit_m];
    let corners = ends_m.into_iter().flat_map(|x| {
        let edge = |y: f64| [[x, y, top_m], [x, y, top_m + 2.0 * half_m]];
        [edge(-half_m), edge(half_m)].into_iter().flatten()
    });
    corners.map(|corner| corner.map(five_digits)).collect()
}

fn half_widths_m(span_m: &[f64]) -> Vec<f64> {
    let length_m = span_m.last().copied().unwrap_or(1.0);
    let width = |radius_m: &f64| {
        let place = radius_m / length_m;
        let piece = HALF_WIDTHS.windows(2).find(|piece| place <= piece[1].0);
        let piece = piece.unwrap_or(&HALF_WIDTHS[2..]);
        let [(from, first), (to, last)] = [piece[0], piece[1]];
        five_digits(length_m * (first + (place - from) / (to - from) * (last - first)))
    };
    span_m.iter().map(width).collect()
}

//! The curve of a mode over the rotor speed, and the names along it.

use towermodes::turbine::{CoupledFrequency, Nodding, TurbineEnergy, TurbineModeName, TurbinePart};

use crate::resonance::{LineEnd, ModeClass};

/// If a mode has less than this share of its energy in the part that its name states, another part
/// shares it; …
pub const SHARED: f64 = 0.6;
/// … if the tower has at least this share, the mode also counts as a tower mode.
const GOOD_PART: f64 = 0.25;

/// A mode of a turbine followed over the rotor speed by its shape. Its name at each speed is that
/// of the mode there: after a veering, where the shape changes, the name changes too.
#[derive(Debug, Clone, PartialEq)]
pub struct CoupledCurve {
    /// The name that it has over most of the operating speeds.
    pub name: TurbineModeName,
    /// Its title: this name; with rotor speeds if another curve has the same name over a larger
    /// range.
    pub title: String,
    /// Its points by increasing rotor speed. There are no points where the mode is outside the
    /// frequency range of the diagram.
    pub points: Vec<CurvePoint>,
    /// For a backward whirl the index of the curve of the forward whirl with the same motion and
    /// order, and vice versa; none if there is no such curve.
    pub partner: Option<usize>,
    /// The end of a curve that was lost: no mode at the next speed has a similar shape.
    pub lost: Option<LineEnd>,
}

/// A mode of a curve at a rotor speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// Rotor speed, rpm.
    pub rotor_speed_rpm: f64,
    /// Its index in the list of modes at this speed, from 0.
    pub mode: usize,
    /// The frequency, with bounds from eigenvalue counts.
    pub frequency: CoupledFrequency,
    /// The estimated error of the mesh, Hz; known at the ends of the diagram and of the operating
    /// range.
    pub error_hz: Option<f64>,
    /// Its name at this speed.
    pub name: TurbineModeName,
    /// The fraction of its elastic energy in the part that its name states.
    pub share: f64,
    /// The other part with the most energy, with its fraction.
    pub second: Option<(TurbinePart, f64)>,
    /// Fractions of its elastic energy.
    pub energy: TurbineEnergy,
}

/// Neighbouring points of a curve at which it has one name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NameRange {
    /// The name.
    pub name: TurbineModeName,
    /// The lowest speed, rpm, at which the turbine was solved and the curve has the name.
    pub from_rpm: f64,
    /// The highest such speed, rpm.
    pub to_rpm: f64,
}

/// A place where a curve changes its name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NameChange {
    /// The name at lower speeds.
    pub before: TurbineModeName,
    /// The name at higher speeds.
    pub after: TurbineModeName,
    /// The middle between the last speed with one name and the first with the other, rpm.
    pub rotor_speed_rpm: f64,
    /// The frequency at this speed, Hz.
    pub frequency_hz: f64,
}

impl CurvePoint {
    /// Rotor speed (rpm) and frequency (Hz).
    pub fn place(&self) -> [f64; 2] {
        [self.rotor_speed_rpm, self.frequency.frequency_hz]
    }

    /// The motion of the nacelle (tilt or yaw) in a mode whose forward and backward waves are
    /// nearly equal.
    pub fn nodding(&self) -> Option<Nodding> {
        self.energy.nodding_of(self.name.part)
    }

    /// Whether another part shares it: less than 60 % of its elastic energy is in the part that its
    /// name states, or, if its forward and backward waves are nearly equal, in both waves together.
    pub fn is_shared(&self) -> bool {
        let other_wave = self.second.filter(|_| self.nodding().is_some());
        let other_wave = other_wave.filter(|(part, _)| is_other_wave(self.name.part, *part));
        self.share + other_wave.map_or(0.0, |(_, share)| share) < SHARED
    }

    /// Class of the mode: the blades if its name states a blade motion, unless less than 60 % of
    /// its energy is in the part of the name and at least 25 % is in the tower. Thus if two modes
    /// share a tower motion, both have verdicts like modes of the tower. For all other modes the
    /// shares of the energy determine the class.
    pub fn class(&self) -> ModeClass {
        let energy = &self.energy;
        let is_of_blades = matches!(self.name.part, TurbinePart::Blades(..));
        if is_of_blades && (self.share >= SHARED || energy.of_tower() < GOOD_PART) {
            return ModeClass::Blades;
        }
        let platform: f64 = energy.platform.iter().sum();
        let drives = energy.yaw_drive + energy.shaft;
        // What the blades have moves with the largest of the others.
        let others = energy.of_tower() + drives;
        ModeClass::by_shares(energy.substructure, platform / others, drives / others)
    }
}

/// Whether two parts are the forward and backward waves of one blade motion.
fn is_other_wave(part: TurbinePart, other: TurbinePart) -> bool {
    match (part, other) {
        (TurbinePart::Blades(motion, _), TurbinePart::Blades(other, _)) => motion == other,
        _ => false,
    }
}

/// The point in the middle of two neighbours.
pub(super) fn middle(a: &CurvePoint, b: &CurvePoint) -> [f64; 2] {
    let ([a_rpm, a_hz], [b_rpm, b_hz]) = (a.place(), b.place());
    [0.5 * (a_rpm + b_rpm), 0.5 * (a_hz + b_hz)]
}

impl CoupledCurve {
    /// Rotor speeds (rpm) and frequencies (Hz).
    pub fn places(&self) -> Vec<[f64; 2]> {
        self.points.iter().map(CurvePoint::place).collect()
    }

    /// The point at a rotor speed at which the turbine was solved, rpm.
    pub fn at_rpm(&self, rpm: f64) -> Option<&CurvePoint> {
        self.points.iter().find(|point| {
            (point.rotor_speed_rpm - rpm).abs() <= 1e-9 * rpm.abs().max(f64::MIN_POSITIVE)
        })
    }

    /// Its names by increasing rotor speed.
    pub fn names(&self) -> Vec<NameRange> {
        let runs = self.points.chunk_by(|a, b| a.name == b.name);
        let range = |run: &[CurvePoint]| NameRange {
            name: run[0].name,
            from_rpm: run[0].rotor_speed_rpm,
            to_rpm: run[run.len() - 1].rotor_speed_rpm,
        };
        runs.map(range).collect()
    }

    /// The places where its name changes.
    pub fn changes(&self) -> Vec<NameChange> {
        let steps = self.points.windows(2);
        let changes = steps.filter(|step| step[0].name != step[1].name);
        let change = |step: &[CurvePoint]| {
            let [rotor_speed_rpm, frequency_hz] = middle(&step[0], &step[1]);
            NameChange {
                before: step[0].name,
                after: step[1].name,
                rotor_speed_rpm,
                frequency_hz,
            }
        };
        changes.map(change).collect()
    }

    /// Its name at a rotor speed (rpm): the name at the nearest lower solved speed, or at its first
    /// speed.
    pub fn name_at(&self, rpm: f64) -> TurbineModeName {
        let below = self.points.partition_point(|p| p.rotor_speed_rpm <= rpm);
        let point = self.points.get(below.saturating_sub(1));
        point.map_or(self.name, |point| point.name)
    }

    /// The largest known error of its frequencies, Hz: the error of the mesh plus half the width of
    /// the bounds.
    pub fn error_hz(&self) -> f64 {
        let errors = self.points.iter().map(|point| {
            let frequency = &point.frequency;
            point.error_hz.unwrap_or_default() + 0.5 * (frequency.upper_hz - frequency.lower_hz)
        });
        errors.fold(0.0, f64::max)
    }

    /// Whether the mode has negative energy at some speed.
    pub fn has_negative_energy(&self) -> bool {
        let mut points = self.points.iter();
        points.any(|point| point.frequency.has_negative_energy)
    }
}

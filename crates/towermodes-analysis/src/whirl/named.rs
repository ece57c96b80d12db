//! The names of curves, and the whirl modes that belong together.

use towermodes::tower::Rotor;
use towermodes::turbine::{Harmonic, TurbineModeName, TurbinePart};

use super::curve::{CoupledCurve, CurvePoint};

/// Points of a curve with their weight in its name: the operating speeds that each stands for, rpm;
/// without operating speeds all alike.
fn weighted<'a>(points: &'a [CurvePoint], rotor: &Rotor) -> Vec<(&'a CurvePoint, f64)> {
    let operates = |point: &&CurvePoint| {
        (rotor.lowest_rpm..=rotor.highest_rpm).contains(&point.rotor_speed_rpm)
    };
    let own: Vec<&CurvePoint> = points.iter().filter(operates).collect();
    let rpm = |index: usize| own[index.min(own.len() - 1)].rotor_speed_rpm;
    match own.len() {
        0 => points.iter().map(|point| (point, 1.0)).collect(),
        1 => vec![(own[0], 1.0)],
        _ => (0..own.len())
            .map(|k| (own[k], 0.5 * (rpm(k + 1) - rpm(k.saturating_sub(1)))))
            .collect(),
    }
}

/// The part that names a curve over most of the operating speeds; of two that do so equally the one
/// at the lower speed.
pub(super) fn part(points: &[CurvePoint], rotor: &Rotor) -> TurbinePart {
    let mut parts: Vec<(TurbinePart, f64)> = Vec::new();
    for (point, weight) in weighted(points, rotor) {
        let part = point.name.part;
        match parts.iter_mut().find(|(other, _)| *other == part) {
            Some((_, sum)) => *sum += weight,
            None => parts.push((part, weight)),
        }
    }
    let none = (TurbinePart::TowerForeAft, f64::NEG_INFINITY);
    let most = parts
        .into_iter()
        .fold(none, |most, part| match part.1 > most.1 {
            true => part,
            false => most,
        });
    most.0
}

/// The mean frequency of a curve over the operating speeds, Hz.
pub(super) fn mean_hz(points: &[CurvePoint], rotor: &Rotor) -> f64 {
    let weighted = weighted(points, rotor);
    let sum = |of: fn(&CurvePoint) -> f64| {
        let parts = weighted.iter().map(|(point, weight)| of(point) * weight);
        parts.sum::<f64>()
    };
    sum(|point| point.frequency.frequency_hz) / sum(|_| 1.0)
}

/// Orders curves, those of tower and drivetrain before those of the blades and each by mean
/// frequency, and gives the order of the curves: the indices before.
pub(super) fn in_order(curves: &[(TurbinePart, f64)]) -> Vec<usize> {
    let is_blade = |index: usize| matches!(curves[index].0, TurbinePart::Blades(..));
    let mut order: Vec<usize> = (0..curves.len()).collect();
    order.sort_by(|a, b| curves[*a].1.total_cmp(&curves[*b].1));
    order.sort_by_key(|index| is_blade(*index));
    order
}

/// Pairs the curves of backward and forward whirl of one motion and order.
pub(super) fn pair(curves: &mut [CoupledCurve]) {
    let names: Vec<TurbineModeName> = curves.iter().map(|curve| curve.name).collect();
    for curve in curves {
        let other = opposite(curve.name);
        curve.partner = other.and_then(|other| names.iter().position(|name| *name == other));
    }
}

/// The name of the mode that whirls the other way.
fn opposite(name: TurbineModeName) -> Option<TurbineModeName> {
    let TurbinePart::Blades(motion, harmonic) = name.part else {
        return None;
    };
    let harmonic = match harmonic {
        Harmonic::Forward => Harmonic::Backward,
        Harmonic::Backward => Harmonic::Forward,
        Harmonic::Tilt => Harmonic::Yaw,
        Harmonic::Yaw => Harmonic::Tilt,
        Harmonic::ForwardOf(waves) => Harmonic::BackwardOf(waves),
        Harmonic::BackwardOf(waves) => Harmonic::ForwardOf(waves),
        Harmonic::Collective | Harmonic::Alternating => return None,
    };
    let part = TurbinePart::Blades(motion, harmonic);
    Some(TurbineModeName { part, ..name })
}

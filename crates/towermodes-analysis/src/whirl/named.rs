//! The titles of curves, and the pairs of whirl modes.

use towermodes::tower::{Rotor, Rpm};
use towermodes::turbine::{Harmonic, TurbineModeName, TurbinePart};

use super::curve::{CoupledCurve, CurvePoint};

/// Points of a curve, each with the range of operating speeds that it represents, rpm.
fn in_operation<'a>(points: &'a [CurvePoint], rotor: &Rotor) -> Vec<(&'a CurvePoint, f64)> {
    let operates = |point: &&CurvePoint| {
        (rotor.lowest_rpm..=rotor.highest_rpm).contains(&point.rotor_speed_rpm)
    };
    let own: Vec<&CurvePoint> = points.iter().filter(operates).collect();
    let rpm = |index: usize| own[index.min(own.len() - 1)].rotor_speed_rpm;
    match own.len() {
        0 => Vec::new(),
        1 => vec![(own[0], 1.0)],
        _ => (0..own.len())
            .map(|k| (own[k], 0.5 * (rpm(k + 1) - rpm(k.saturating_sub(1)))))
            .collect(),
    }
}

/// The mean frequency of points over the operating speeds, Hz; over all points if none is in the
/// operating range.
pub(super) fn mean_hz(points: &[CurvePoint], rotor: &Rotor) -> f64 {
    let mut weighted = in_operation(points, rotor);
    if weighted.is_empty() {
        weighted = points.iter().map(|point| (point, 1.0)).collect();
    }
    let sum = |of: fn(&CurvePoint) -> f64| {
        let parts = weighted.iter().map(|(point, weight)| of(point) * weight);
        parts.sum::<f64>()
    };
    sum(|point| point.frequency.frequency_hz) / sum(|_| 1.0)
}

/// The names of all points: modes of tower and drivetrain before those of the blades, each group by
/// mean frequency.
pub(super) fn all_names(curves: &[CoupledCurve], rotor: &Rotor) -> Vec<TurbineModeName> {
    let mut points: Vec<CurvePoint> = Vec::new();
    points.extend(curves.iter().flat_map(|curve| &curve.points));
    points.sort_by(|a, b| a.rotor_speed_rpm.total_cmp(&b.rotor_speed_rpm));
    // A stable sort: the points of a name stay in the order of the speeds.
    points.sort_by_key(|point| point.name);
    let names = points.chunk_by(|a, b| a.name == b.name);
    let mut names: Vec<(TurbineModeName, f64)> = names
        .map(|own| (own[0].name, mean_hz(own, rotor)))
        .collect();
    names.sort_by(|a, b| a.1.total_cmp(&b.1));
    names.sort_by_key(|(name, _)| is_of_blades(*name));
    names.into_iter().map(|(name, _)| name).collect()
}

pub(super) fn is_of_blades(name: TurbineModeName) -> bool {
    matches!(name.part, TurbinePart::Blades(..))
}

/// Gives each curve the name that it has over most of the operating speeds, and each name to only
/// one curve: to the curve that has it over the largest range of operating speeds, then of all
/// speeds, then to the lower frequency.
pub(super) fn name(curves: &mut [CoupledCurve], rotor: &Rotor) {
    let mut claims: Vec<(usize, TurbineModeName, [f64; 3])> = Vec::new();
    for (index, curve) in curves.iter().enumerate() {
        let operating = in_operation(&curve.points, rotor);
        let mean = mean_hz(&curve.points, rotor);
        let mut names: Vec<TurbineModeName> = curve.points.iter().map(|p| p.name).collect();
        names.sort();
        names.dedup();
        for name in names {
            let own = operating.iter().filter(|(point, _)| point.name == name);
            let operating: f64 = own.map(|(_, rpm)| rpm).sum();
            let all = curve.points.iter().filter(|point| point.name == name);
            let all = all.count() as f64 / curve.points.len() as f64;
            claims.push((index, name, [-operating, -all, mean]));
        }
    }
    claims.sort_by(|a, b| {
        let orders = a.2.iter().zip(&b.2).map(|(a, b)| a.total_cmp(b));
        orders.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
    });
    let mut has_name = vec![false; curves.len()];
    let mut given: Vec<TurbineModeName> = Vec::new();
    for (index, name, _) in &claims {
        if !has_name[*index] && !given.contains(name) {
            has_name[*index] = true;
            given.push(*name);
            curves[*index].name = *name;
            curves[*index].title = name.to_string();
        }
    }
    // All names of the others are names of curves that have them over more speeds.
    for (index, name, _) in claims {
        if !has_name[index] {
            has_name[index] = true;
            curves[index].name = name;
            curves[index].title = with_speeds(&curves[index], name);
        }
    }
}

/// "1st flapwise collective (12 to 14.5 rpm)". At each speed only one curve has a name.
fn with_speeds(curve: &CoupledCurve, name: TurbineModeName) -> String {
    let mut ranges = curve.names().into_iter().filter(|own| own.name == name);
    let range = ranges
        .next()
        .map_or([0.0; 2], |own| [own.from_rpm, own.to_rpm]);
    format!("{name} ({} to {} rpm)", Rpm(range[0]), Rpm(range[1]))
}

/// Pairs the curves of backward and forward whirl of one motion and order.
pub(super) fn pair(curves: &mut [CoupledCurve]) {
    let names: Vec<TurbineModeName> = curves.iter().map(|curve| curve.name).collect();
    for curve in curves {
        let other = opposite(curve.name);
        curve.partner = other.and_then(|other| names.iter().position(|name| *name == other));
    }
}

/// The name of the mode with the opposite whirl direction.
pub(super) fn opposite(name: TurbineModeName) -> Option<TurbineModeName> {
    let TurbinePart::Blades(motion, harmonic) = name.part else {
        return None;
    };
    let harmonic = match harmonic {
        Harmonic::Forward => Harmonic::Backward,
        Harmonic::Backward => Harmonic::Forward,
        Harmonic::ForwardOf(waves) => Harmonic::BackwardOf(waves),
        Harmonic::BackwardOf(waves) => Harmonic::ForwardOf(waves),
        Harmonic::Collective | Harmonic::Alternating => return None,
    };
    let part = TurbinePart::Blades(motion, harmonic);
    Some(TurbineModeName { part, ..name })
}

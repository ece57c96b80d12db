//! The modes that are compared with the excitations: each name, along all curves that have it.

use towermodes::modes::{Family, Holders};
use towermodes::tower::Rotor;
use towermodes::turbine::{TurbineModeName, TurbinePart};

use super::curve::{CoupledCurve, CurvePoint, SHARED, middle};
use crate::resonance::{
    CampbellOptions, Excited, FrequencyLine, Margin, SharedFirst, StiffnessClass, class_along,
    margins,
};

/// Another mode shares the motion of a name if it has at least this share of its energy in it.
const GOOD_PART: f64 = 0.25;

/// The planes of bending.
const PLANES: [(Family, TurbinePart); 2] = [
    (Family::ForeAft, TurbinePart::TowerForeAft),
    (Family::SideSide, TurbinePart::TowerSideSide),
];

/// Pieces of curves with one name and one class each, in the order of these names and then by rotor
/// speed. Where name or class changes, one piece ends and the next begins in the middle of the
/// step: a distance has the name that its mode has at the speed where it is least.
pub(super) fn lines(curves: &[CoupledCurve], names: &[TurbineModeName]) -> Vec<FrequencyLine> {
    let mut all: Vec<(usize, FrequencyLine)> = Vec::new();
    for (index, curve) in curves.iter().enumerate() {
        for (name, line) in pieces(index, curve) {
            let place = names.iter().position(|own| *own == name);
            all.push((place.unwrap_or(names.len()), line));
        }
    }
    let first_rpm = |line: &FrequencyLine| line.points.first().map_or(0.0, |[rpm, _]| *rpm);
    all.sort_by(|a, b| first_rpm(&a.1).total_cmp(&first_rpm(&b.1)));
    all.sort_by_key(|(place, _)| *place);
    all.into_iter().map(|(_, line)| line).collect()
}

/// The pieces of a curve with their names.
fn pieces(index: usize, curve: &CoupledCurve) -> Vec<(TurbineModeName, FrequencyLine)> {
    let alike = |a: &CurvePoint, b: &CurvePoint| a.name == b.name && a.class() == b.class();
    let mut first = 0_usize;
    let parts = curve.points.chunk_by(alike);
    let piece = |part: &[CurvePoint]| {
        let before = first.checked_sub(1).map(|k| &curve.points[k]);
        first += part.len();
        let after = curve.points.get(first);
        let name = part[0].name;
        (name, line(index, curve, name, [before, after], part))
    };
    parts.map(piece).collect()
}

/// A piece of a curve, from the middle of the step before to the middle of the step after.
fn line(
    index: usize,
    curve: &CoupledCurve,
    name: TurbineModeName,
    [before, after]: [Option<&CurvePoint>; 2],
    part: &[CurvePoint],
) -> FrequencyLine {
    let begin = before.map(|before| middle(before, &part[0]));
    let end = after.map(|after| middle(&part[part.len() - 1], after));
    FrequencyLine {
        of: Excited::Turbine {
            name,
            curve: index,
            class: part[0].class(),
        },
        label: name.to_string(),
        points: begin
            .into_iter()
            .chain(part.iter().map(CurvePoint::place))
            .chain(end)
            .collect(),
        error_hz: curve.error_hz(),
        lost: curve.lost.filter(|_| after.is_none()),
    }
}

/// The distance of every name from every multiple: the worst of its pieces, and of these the
/// nearest.
pub(super) fn worst(
    lines: &[FrequencyLine],
    rotor: &Rotor,
    options: &CampbellOptions,
) -> Vec<Margin> {
    let mut all: Vec<Margin> = Vec::new();
    for margin in margins(lines, rotor, options) {
        let is_same = |other: &&mut Margin| {
            other.multiple == margin.multiple
                && lines[other.line].is_of_same_mode(&lines[margin.line])
        };
        let rank = |of: &Margin| (of.verdict, -of.distance.abs());
        match all.iter_mut().find(is_same) {
            Some(other) if rank(other) >= rank(&margin) => {}
            Some(other) => *other = margin,
            None => all.push(margin),
        }
    }
    all.sort_by_key(|margin| first_of(lines, margin));
    all
}

/// The sort key of a distance: the first piece of its mode, then its multiple.
fn first_of(lines: &[FrequencyLine], margin: &Margin) -> (usize, usize) {
    let own = &lines[margin.line];
    let first = lines.iter().position(|line| line.is_of_same_mode(own));
    (first.unwrap_or(margin.line), margin.multiple)
}

/// The first bending modes of the tower with their classes, and the piece of each at the highest
/// operating speed.
pub(super) fn first_bending(
    curves: &[CoupledCurve],
    lines: &[FrequencyLine],
    rotor: &Rotor,
) -> Vec<(Family, StiffnessClass, usize)> {
    let first = PLANES.into_iter().filter_map(|(family, part)| {
        let name = TurbineModeName { part, order: 1 };
        let class = class_along(&places(curves, name), rotor)?;
        let is_first =
            |line: &FrequencyLine| matches!(line.of, Excited::Turbine { name: own, .. } if own == name);
        let apart = |line: &FrequencyLine| {
            let distances = line.points.iter().map(|[rpm, _]| (rpm - rotor.highest_rpm).abs());
            distances.fold(f64::INFINITY, f64::min)
        };
        let own = (0..lines.len()).filter(|line| is_first(&lines[*line]));
        let line = own.min_by(|a, b| apart(&lines[*a]).total_cmp(&apart(&lines[*b])))?;
        Some((family, class, line))
    });
    first.collect()
}

/// Rotor speeds (rpm) and frequencies (Hz) of a name; at speeds where its mode has less than 60 %
/// of its energy in it, also those of the mode that shares it.
fn places(curves: &[CoupledCurve], name: TurbineModeName) -> Vec<[f64; 2]> {
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let mut places = Vec::new();
    for point in points().filter(|point| point.name == name) {
        places.push(point.place());
        if point.share >= SHARED {
            continue;
        }
        let of_part = |other: &CurvePoint| {
            let (part, share) = other.second?;
            let is_there = other.rotor_speed_rpm == point.rotor_speed_rpm;
            (is_there && part == name.part && share >= GOOD_PART).then_some((share, other.place()))
        };
        let others = points().filter_map(of_part);
        let other = others.reduce(|most, other| if other.0 > most.0 { other } else { most });
        places.extend(other.map(|(_, place)| place));
    }
    places.sort_by(|a, b| a[0].total_cmp(&b[0]));
    places
}

/// The first bending modes with less than 60 % of their energy in their plane at the highest
/// operating speed, and the other [holders](Holders) of the first unit of this energy.
pub(super) fn shared_first(curves: &[CoupledCurve], rotor: &Rotor) -> Vec<SharedFirst> {
    let points = curves.iter();
    let points = points.filter_map(|curve| curve.at_rpm(rotor.highest_rpm));
    let mut points: Vec<&CurvePoint> = points.collect();
    points.sort_by(|a, b| a.place()[1].total_cmp(&b.place()[1]));
    let of_plane = |(family, part): (Family, TurbinePart)| {
        let name = TurbineModeName { part, order: 1 };
        let named = *points.iter().find(|point| point.name == name)?;
        if named.share >= SHARED {
            return None;
        }
        let shares = points.iter();
        let shares = shares.map(|point| (point.name == name, point.energy.of(part)));
        let others = Holders::of_unit(name.order, shares)?
            .others()
            .collect::<Vec<_>>();
        let holder = |point: &CurvePoint| {
            let [_, hz] = point.place();
            (point.name.to_string(), hz, point.energy.of(part))
        };
        Some(SharedFirst {
            family,
            named: holder(named),
            others: others
                .into_iter()
                .map(|place| holder(points[place]))
                .collect(),
        })
    };
    PLANES.into_iter().filter_map(of_plane).collect()
}

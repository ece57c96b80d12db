//! The modes that are compared with the excitations: each name, along all curves that have it.

use towermodes::modes::Family;
use towermodes::tower::Rotor;
use towermodes::turbine::{TurbineModeName, TurbinePart};

use super::curve::{CoupledCurve, CurvePoint, SHARED, middle};
use crate::resonance::{
    CampbellOptions, Excited, FrequencyLine, Margin, StiffnessClass, class_along, margins,
};

/// Another mode shares the motion of a name if it has at least this share of its energy in it.
const GOOD_PART: f64 = 0.25;

/// Pieces of curves with one name each, in the order of these names and then by rotor speed. Where
/// a curve passes its name to another curve or takes the name of another, one piece ends and the
/// next begins in the middle of the step. Where it changes its name alone, because two parts have
/// nearly equal energy, the piece continues: it is one mode, which is assessed once.
pub(super) fn lines(curves: &[CoupledCurve], names: &[TurbineModeName]) -> Vec<FrequencyLine> {
    let mut all: Vec<(usize, FrequencyLine)> = Vec::new();
    for index in 0..curves.len() {
        for (name, line) in pieces(index, curves) {
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
fn pieces(index: usize, curves: &[CoupledCurve]) -> Vec<(TurbineModeName, FrequencyLine)> {
    let curve = &curves[index];
    let goes_on = |a: &CurvePoint, b: &CurvePoint| !hands_over(index, curves, [a, b]);
    let mut first = 0;
    let runs = curve.points.chunk_by(goes_on);
    let of_run = |run: &[CurvePoint]| {
        let begin = first;
        first += run.len();
        let name = title(run);
        let alike = |a: &CurvePoint, b: &CurvePoint| a.class() == b.class();
        let mut own = begin;
        let parts = run.chunk_by(alike);
        let piece = |part: &[CurvePoint]| {
            let last = own + part.len() - 1;
            let before = own.checked_sub(1).map(|k| &curve.points[k]);
            let after = curve.points.get(last + 1);
            own = last + 1;
            (name, line(index, curve, name, [before, after], part))
        };
        parts.map(piece).collect::<Vec<_>>()
    };
    runs.flat_map(of_run).collect()
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

/// Whether a curve passes its name to another curve in a step, or takes its next name from another.
fn hands_over(index: usize, curves: &[CoupledCurve], [a, b]: [&CurvePoint; 2]) -> bool {
    let has_elsewhere = |name: TurbineModeName, rpm: f64| {
        let others = curves
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != index);
        let mut points = others.filter_map(|(_, other)| other.at_rpm(rpm));
        points.any(|point| point.name == name)
    };
    a.name != b.name
        && (has_elsewhere(a.name, b.rotor_speed_rpm) || has_elsewhere(b.name, a.rotor_speed_rpm))
}

/// The name of the points of one mode: the name of a tower bending mode, which has the classes, if
/// some points have one; otherwise the name of most points, of equally frequent names the first.
fn title(points: &[CurvePoint]) -> TurbineModeName {
    let bends = |name: &TurbineModeName| {
        matches!(
            name.part,
            TurbinePart::TowerForeAft | TurbinePart::TowerSideSide
        )
    };
    let rank = |name: &TurbineModeName| {
        let own = points.iter().filter(|point| point.name == *name);
        (bends(name), own.count())
    };
    let names = points.iter().map(|point| point.name);
    let best = names.reduce(|best, name| {
        if rank(&name) > rank(&best) {
            name
        } else {
            best
        }
    });
    best.unwrap_or(points[0].name)
}

/// The distance of every name from every multiple: that of the piece with the worst verdict, and
/// among equal verdicts the smallest.
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
    let planes = [
        (Family::ForeAft, TurbinePart::TowerForeAft),
        (Family::SideSide, TurbinePart::TowerSideSide),
    ];
    let first = planes.into_iter().filter_map(|(family, part)| {
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

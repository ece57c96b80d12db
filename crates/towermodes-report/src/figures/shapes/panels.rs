//! The panels of the figure and the curves in each.

use towermodes::{Family, Mode, ShapePoint, Solution};

use super::curves::{Part, coupled_parts, is_turned, order, short_name};
use crate::figures::enlargement::round_factor;
use crate::number::four_digits;

/// The start of the heading of every panel of coupled modes.
pub(super) const COUPLED: &str = "coupled: ";
/// The largest number of curves in a panel.
const MOST_CURVES: usize = 6;
/// A panel extends below zero if a curve is more than this below zero.
const BELOW_ZERO: f64 = 0.02;
/// Curves that differ by less than this share of the largest motion are drawn as one.
const ONE_LINE: f64 = 0.02;

/// A field with curves over the height.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Panel {
    /// The heading above it.
    pub heading: &'static str,
    /// The second line of the heading.
    pub note: Option<&'static str>,
    /// Names of the axis below, the longest first.
    pub axis: [&'static str; 2],
    /// The values at its left and right edge.
    pub range: [f64; 2],
    /// Approximate number of numbers along its axis in a narrow panel and in a wide one.
    pub ticks: [usize; 2],
    /// The curves.
    pub curves: Vec<Curve>,
    /// The number of modes that are not drawn.
    pub more: usize,
}

/// One component of a mode over the height.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curve {
    /// "1st 0.3221 Hz"; if several modes coincide, a label for each.
    pub labels: Vec<String>,
    /// Heights, m, and values.
    pub points: Vec<(f64, f64)>,
}

/// Number of labels on an axis from 0 or −1 to 1, in a narrow and in a wide panel.
const SHARES: [usize; 2] = [2, 4];
const DEFLECTION: [&str; 2] = [
    "deflection / largest (\u{2212})",
    "defl. / largest (\u{2212})",
];
const ROTATION: [&str; 2] = ["rotation / largest (\u{2212})", "rot. / largest (\u{2212})"];

/// The panels of a solution's modes: by family, and those of coupled modes by component.
pub(super) fn panels(solution: &Solution) -> Vec<Panel> {
    let of = |family: Family| -> Vec<&Mode> {
        let modes = solution.modes.iter();
        let clear = modes.filter(|mode| !mode.is_coupled());
        clear.filter(|mode| mode.family == family).collect()
    };
    let (fore_aft, side_side) = (of(Family::ForeAft), of(Family::SideSide));
    let turned = are_turned(&fore_aft, &side_side);
    let note = turned.then_some("side-side: as fore-aft");
    let side_side = if turned { Vec::new() } else { side_side };
    let mut panels = vec![
        panel("fore-aft", DEFLECTION, &fore_aft, note),
        panel("side-side", DEFLECTION, &side_side, None),
        panel("torsion", ROTATION, &of(Family::Torsion), None),
        panel("axial", DEFLECTION, &of(Family::Axial), None),
    ];
    let is_coupled = |mode: &&Mode| mode.is_coupled() && !mode.family.is_rigid();
    panels.extend(coupled(solution.modes.iter().filter(is_coupled)));
    panels.push(rigid(solution));
    panels.retain(|panel| !panel.curves.is_empty());
    panels
}

/// Whether every side-side mode equals the fore-aft mode of its order.
fn are_turned(fore_aft: &[&Mode], side_side: &[&Mode]) -> bool {
    let twin = |mode: &&Mode| {
        let same_order = fore_aft.iter().find(|other| other.order == mode.order);
        same_order.is_some_and(|other| is_turned(other, mode))
    };
    !side_side.is_empty() && side_side.iter().all(twin)
}

fn panel(
    heading: &'static str,
    axis: [&'static str; 2],
    modes: &[&Mode],
    note: Option<&'static str>,
) -> Panel {
    let curve = |mode: &&Mode| curve(mode, Part::main(mode.family), &order(mode));
    let curves: Vec<Curve> = modes.iter().take(MOST_CURVES).map(curve).collect();
    Panel {
        heading,
        note,
        axis,
        range: share_range(&curves),
        ticks: SHARES,
        curves,
        more: modes.len().saturating_sub(MOST_CURVES),
    }
}

/// A panel for each component that takes part in a coupled mode.
fn coupled<'a>(modes: impl Iterator<Item = &'a Mode> + Clone) -> Vec<Panel> {
    let shown: Vec<&Mode> = modes.clone().take(MOST_CURVES).collect();
    let more = modes.count().saturating_sub(MOST_CURVES);
    let parts: Vec<Part> = shown.iter().flat_map(|mode| coupled_parts(mode)).collect();
    let of = |part: Part, heading, axis: [&'static str; 2]| {
        let curves = shown
            .iter()
            .map(|mode| curve(mode, part, &short_name(mode)));
        let curves: Vec<Curve> = curves.collect();
        let is_rotation = part == Part::RotationZ;
        let panel = Panel {
            heading,
            note: None,
            axis,
            range: match is_rotation {
                true => own_range(&curves),
                false => share_range(&curves),
            },
            ticks: if is_rotation { [2, 2] } else { SHARES },
            curves,
            more,
        };
        parts.contains(&part).then_some(panel)
    };
    let panels = [
        of(Part::X, "coupled: x", DEFLECTION),
        of(Part::Y, "coupled: y", DEFLECTION),
        of(Part::Z, "coupled: z", DEFLECTION),
        of(
            Part::RotationZ,
            "coupled: rotation z",
            ["rotation / largest deflection (rad/m)", "rotation (rad/m)"],
        ),
    ];
    panels.into_iter().flatten().collect()
}

/// The rigid-body modes of a floating tower; equal modes in the two planes are one curve.
fn rigid(solution: &Solution) -> Panel {
    let modes: Vec<&Mode> = solution
        .modes
        .iter()
        .filter(|m| m.family.is_rigid())
        .collect();
    let pairs = [(Family::Surge, Family::Sway), (Family::Pitch, Family::Roll)];
    let twin = |mode: &Mode, of_first: bool| {
        let pair = pairs.iter().find(|(first, second)| {
            let own = if of_first { first } else { second };
            *own == mode.family
        })?;
        let other = if of_first { pair.1 } else { pair.0 };
        let other = *modes.iter().find(|mode| mode.family == other)?;
        let (first, second) = if of_first {
            (mode, other)
        } else {
            (other, mode)
        };
        is_turned(first, second).then_some(other)
    };
    let alone = modes.iter().filter(|mode| twin(mode, false).is_none());
    let curves = alone.map(|mode| {
        let name = match twin(mode, true) {
            Some(other) => format!("{}, {}", order(mode), order(other)),
            None => order(mode),
        };
        curve(mode, Part::main(mode.family), &name)
    });
    let curves = on_one_line(curves.collect());
    Panel {
        heading: "rigid body",
        note: None,
        axis: ["motion / largest (\u{2212})"; 2],
        range: share_range(&curves),
        ticks: SHARES,
        curves,
        more: 0,
    }
}

/// Combines curves that would coincide into one curve with all labels.
fn on_one_line(curves: Vec<Curve>) -> Vec<Curve> {
    let mut lines: Vec<Curve> = Vec::new();
    for curve in curves {
        match lines.iter_mut().find(|line| line.covers(&curve)) {
            Some(line) => line.labels.extend(curve.labels),
            None => lines.push(curve),
        }
    }
    lines
}

impl Curve {
    /// Whether another curve differs from this one by less than the width of a line everywhere.
    fn covers(&self, other: &Self) -> bool {
        let mut pairs = self.points.iter().zip(&other.points);
        pairs.all(|(own, other)| (own.1 - other.1).abs() <= ONE_LINE)
    }
}

fn curve(mode: &Mode, part: Part, name: &str) -> Curve {
    let points = mode.shape.iter();
    let point = |point: &ShapePoint| (point.height_m, part.of(point));
    Curve {
        labels: vec![format!("{name} {} Hz", four_digits(mode.frequency_hz))],
        points: points.map(point).collect(),
    }
}

/// The range from 0 or −1 to 1.
fn share_range(curves: &[Curve]) -> [f64; 2] {
    let lowest = values(curves).fold(0.0, f64::min);
    [if lowest < -BELOW_ZERO { -1.0 } else { 0.0 }, 1.0]
}

/// A symmetric range, to a round number that no curve exceeds.
fn own_range(curves: &[Curve]) -> [f64; 2] {
    let most = values(curves).map(f64::abs).fold(0.0, f64::max);
    let most = round_factor(most, true);
    [-most, most]
}

fn values(curves: &[Curve]) -> impl Iterator<Item = f64> {
    curves
        .iter()
        .flat_map(|curve| curve.points.iter().map(|point| point.1))
}

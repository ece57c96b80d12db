//! Mode shapes side by side, in braille dots.

use towermodes::{
    Blade, BladeFamily, BladeMode, BladeSolution, Family, Mode, ShapePoint, Solution, Tower,
    tower::Motion,
};

use super::panel::{Curve, Line, Panel, side_by_side};
use crate::figures::shapes::Part;
use crate::number::four_digits;

impl Curve {
    /// A rotation normalised to its largest value, because a shape normalised by a deflection gives
    /// it no scale. Deflections are unchanged.
    fn with_scale_of(mut self, part: Part) -> Self {
        let sizes = self.points.iter().map(|(_, value)| value.abs());
        let largest = sizes.fold(0.0, f64::max);
        if part == Part::RotationZ && largest > 0.0 {
            for (_, value) in &mut self.points {
                *value /= largest;
            }
        }
        self
    }
}

/// The mode shapes of a solution, as wide as a terminal of `width` columns permits: heights
/// upwards, and to the right the fore-aft or side-side deflection, the rotation of torsion modes,
/// or the axial motion, each normalised to its maximum. Coupled modes show the two motions with the
/// most energy, one as a line and one as dots. Equal modes of two equal planes are drawn once.
/// Empty if no shape fits.
pub fn shapes(tower: &Tower, solution: &Solution, width: usize) -> String {
    let panels: Vec<Panel> = drawn_once(tower, solution)
        .into_iter()
        .map(|(mode, twin)| tower_panel(mode, twin))
        .collect();
    side_by_side(&panels, [tower.base_m(), tower.top_m()], width)
}

/// The mode shapes of a rotating blade, like [`shapes`]: radii upwards, to the right the flapwise
/// or edgewise deflection, or the rotation of torsion modes.
pub fn blade_shapes(blade: &Blade, solution: &BladeSolution, width: usize) -> String {
    let description = blade.description();
    let radii_m = [description.hub_radius_m, description.tip_radius_m];
    let panels: Vec<Panel> = solution.modes.iter().map(blade_panel).collect();
    side_by_side(&panels, radii_m, width)
}

/// The modes, each with the equal mode in the other plane if both planes are equal.
fn drawn_once<'a>(tower: &Tower, solution: &'a Solution) -> Vec<(&'a Mode, Option<&'a Mode>)> {
    let mut drawn: Vec<(&Mode, Option<&Mode>)> = Vec::new();
    for mode in &solution.modes {
        match drawn.last_mut() {
            Some((first, twin)) if twin.is_none() && are_a_pair(tower, first, mode) => {
                *twin = Some(mode);
            }
            _ => drawn.push((mode, None)),
        }
    }
    drawn
}

fn are_a_pair(tower: &Tower, first: &Mode, second: &Mode) -> bool {
    let families = matches!(
        (first.family, second.family),
        (Family::ForeAft, Family::SideSide)
            | (Family::Surge, Family::Sway)
            | (Family::Pitch, Family::Roll)
    );
    let is_the_same = first.order == second.order && first.frequency_hz == second.frequency_hz;
    tower.planes_are_equal() && families && is_the_same
}

fn tower_panel(mode: &Mode, twin: Option<&Mode>) -> Panel {
    let curve = |part: Part, line: Line| {
        let points = mode.shape.iter().chain(&mode.station_shape);
        curve(points, part, line)
    };
    let [first, second] = coupled_parts(mode);
    let curves = match mode.is_coupled() {
        true => vec![
            curve(first, Line::Whole).with_scale_of(first),
            curve(second, Line::Dots).with_scale_of(second),
        ],
        false => vec![curve(Part::main(mode.family), Line::Whole)],
    };
    let mut captions = vec![label(mode, twin), four_digits(mode.frequency_hz) + " Hz"];
    captions.extend(match mode.is_coupled() {
        true => Some(format!("{} line, {} dots", first.name(), second.name())),
        false => to_the_right(mode.family).map(str::to_owned),
    });
    Panel { curves, captions }
}

/// The two components of a coupled mode with the most energy.
fn coupled_parts(mode: &Mode) -> [Part; 2] {
    let mean = mode.energy.mean();
    let mut all = [
        (mean.fore_aft, Part::X),
        (mean.side_side, Part::Y),
        (mean.torsion, Part::RotationZ),
        (mean.axial, Part::Z),
    ];
    // Of equal ones the order stays.
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let [(_, first), (_, second), ..] = all;
    // The translation is the line.
    match (first, second) {
        (Part::RotationZ, _) | (Part::Y, Part::X) => [second, first],
        _ => [first, second],
    }
}

/// The drawn quantity, if the name of the mode does not give it.
fn to_the_right(family: Family) -> Option<&'static str> {
    match family.motion() {
        Some(Motion::Torsion) => Some("rotation about z"),
        Some(Motion::Axial) => Some("axial motion"),
        Some(Motion::Bending(_)) | None => None,
    }
}

/// "1st fore-aft and side-side bending" for two equal modes.
fn label(mode: &Mode, twin: Option<&Mode>) -> String {
    match (twin, mode.family) {
        (None, _) => mode.label(),
        (Some(_), Family::ForeAft) => mode.label().replace("fore-aft", "fore-aft and side-side"),
        (Some(twin), _) => format!("{} and {}", mode.label(), twin.label()),
    }
}

fn blade_panel(mode: &BladeMode) -> Panel {
    let (part, quantity) = match mode.family {
        BladeFamily::Lag => (Part::X, None),
        BladeFamily::Flap => (Part::Y, None),
        BladeFamily::Torsion => (Part::RotationZ, Some("rotation")),
        BladeFamily::Axial => (Part::Z, Some("axial motion")),
    };
    let name = mode.family.label(mode.order);
    let mut captions = vec![name, four_digits(mode.frequency_hz) + " Hz"];
    captions.extend(quantity.map(str::to_owned));
    Panel {
        curves: vec![curve(mode.shape.iter(), part, Line::Whole)],
        captions,
    }
}

/// A component over the heights of points in any order; of points at equal heights only one is
/// used.
fn curve<'a>(points: impl Iterator<Item = &'a ShapePoint>, part: Part, line: Line) -> Curve {
    let mut points: Vec<(f64, f64)> = points
        .map(|point| (point.height_m, part.of(point)))
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points.dedup_by(|b, a| b.0 == a.0);
    Curve { points, line }
}

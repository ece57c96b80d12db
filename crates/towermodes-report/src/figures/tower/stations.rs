//! The labels of stations and point masses.

use towermodes::{PointMass, PropertyStation, Station};

use super::callouts::{Callout, Subject};
use super::view::View;
use crate::number::{length, mass, short, wall};

/// Stations whose distance is at most this are the sides of a step, m: some file formats do not
/// allow two stations at one height, so they are put a millimetre apart.
const STEP_M: f64 = 0.002;

/// The tube, or the stiffness, at each station; at a step on both sides.
pub(super) fn station_callouts(view: &View<'_>) -> Vec<Callout> {
    let tower = view.parts.tower;
    let is_step = |a: f64, b: f64| b - a <= STEP_M;
    let tubes = tower
        .stations()
        .chunk_by(|a, b| is_step(a.height_m, b.height_m));
    let tubes = tubes.map(|there| (there[0].height_m, tube_text(there)));
    let rows = tower
        .properties()
        .chunk_by(|a, b| is_step(a.height_m, b.height_m));
    let rows = rows.map(|there| (there[0].height_m, row_text(there)));
    let callout = |(height_m, text): (f64, String)| Callout {
        at: view.on_shell(height_m),
        lines: vec![format!("z = {} m: {text}", length(height_m))],
        subject: Subject::Station,
    };
    tubes.chain(rows).map(callout).collect()
}

fn tube_text(there: &[Station]) -> String {
    let diameters = there.iter().map(|station| length(station.outer_diameter_m));
    let walls = there.iter().map(|station| wall(station.wall_thickness_m));
    format!(
        "Ø {} m, wall {}",
        steps(&diameters.collect::<Vec<_>>()),
        steps(&walls.collect::<Vec<_>>())
    )
}

fn row_text(there: &[PropertyStation]) -> String {
    let bending = there.iter().map(|row| row.properties.bending_n_m2);
    let texts = bending.map(|bending| {
        if bending.are_equal() {
            return short(bending.fore_aft, 3);
        }
        let of = |stiffness| short(stiffness, 3);
        format!(
            "{} (x), {} (y)",
            of(bending.fore_aft),
            of(bending.side_side)
        )
    });
    format!("EI {} N m²", steps(&texts.collect::<Vec<_>>()))
}

/// The values below and above a step, or one value if there is no step.
fn steps(values: &[String]) -> String {
    match values {
        [first, .., last] if first != last => format!("{first} → {last}"),
        [first, ..] => first.clone(),
        [] => String::new(),
    }
}

/// The point masses with their heights; masses at one height share a callout.
pub(super) fn mass_callouts(view: &View<'_>) -> Vec<Callout> {
    let mut masses = view.parts.tower.point_masses().to_vec();
    masses.sort_by(|a, b| a.height_m.total_cmp(&b.height_m));
    let callout = |there: &[PointMass]| {
        let height_m = there[0].height_m;
        let sum_kg: f64 = there.iter().map(|mass| mass.mass_kg).sum();
        let count = match there.len() {
            1 => "mass".to_owned(),
            count => format!("{count} masses,"),
        };
        let text = format!("z = {} m: {count} {}", length(height_m), mass(sum_kg));
        Callout {
            at: (view.axis_x + 6.0, view.y(height_m)),
            lines: vec![text],
            subject: Subject::Mass,
        }
    };
    let there = masses.chunk_by(|a, b| a.height_m == b.height_m);
    there.map(callout).collect()
}

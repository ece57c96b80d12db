//! The extent of soil and water along a tower.

use super::super::description::TowerDescription;
use super::super::parts::surroundings::{AddedMassRow, SoilRow, SoilStiffness, Water};
use super::environment::Environment;
use super::piece::Piece;
use super::section::Tube;

/// Divides pieces where soil and water begin, end or change slope, and gives each part its
/// environment.
pub(crate) fn in_environment(pieces: Vec<Piece>, description: &TowerDescription) -> Vec<Piece> {
    let base_m = pieces.first().map_or(0.0, |piece| piece.base_m);
    let mut cuts_m = fronts_m(description, base_m);
    if cuts_m.is_empty() {
        return pieces;
    }
    cuts_m.sort_by(f64::total_cmp);
    cuts_m.dedup();
    cut_in_environment(pieces, description, &cuts_m)
}

/// The heights (m) at which soil and water begin, end or change slope: of every row of the soil and
/// of the tables of added mass, of the surface and of the ground.
pub(super) fn fronts_m(description: &TowerDescription, base_m: f64) -> Vec<f64> {
    let soil = description.soil.iter().flatten().map(|row| row.height_m);
    let added = description.added_mass.iter().flatten();
    let mut fronts_m: Vec<f64> = soil.chain(added.map(|row| row.height_m)).collect();
    if let Some(water) = &description.water {
        fronts_m.extend([water.level_m, water.bed_above_m(base_m)]);
    }
    fronts_m
}

/// Soil springs (N/m², N), then the mass of water (kg/m) around a tube.
pub(super) type SpringsAndMass = [f64; SoilStiffness::SPRINGS + 1];

/// By how much the soil springs and the water at each of the [`fronts_m`] are larger below than
/// above.
pub(super) fn jumps_at_fronts(
    description: &TowerDescription,
    tube: Option<&Tube>,
) -> Vec<SpringsAndMass> {
    let mut jumps = Vec::new();
    for rows in &description.soil {
        let values = |row: &SoilRow| {
            let mut values = mass(0.0);
            values[..SoilStiffness::SPRINGS].copy_from_slice(&row.stiffness.values());
            values
        };
        add_jumps(rows, |row| row.height_m, values, &mut jumps);
    }
    for rows in &description.added_mass {
        let values = |row: &AddedMassRow| mass(row.mass_kg_per_m);
        add_jumps(rows, |row| row.height_m, values, &mut jumps);
    }
    if let Some(water) = &description.water {
        let quarter = water.density_kg_per_m3 * std::f64::consts::FRAC_PI_4;
        let square = |d: f64| quarter * d * d;
        let outside = tube.map_or(0.0, |tube| square(tube.outer_diameter_m));
        let inside = tube.map_or(0.0, |tube| square(tube.inner_diameter_m()));
        let outside = outside * water.added_mass_coefficient;
        let inside = if water.flooded { inside } else { 0.0 };
        jumps.push(mass(outside + inside));
        jumps.push(mass(-outside));
    }
    jumps
}

fn mass(kg_per_m: f64) -> SpringsAndMass {
    let mut values = [0.0; SoilStiffness::SPRINGS + 1];
    values[SoilStiffness::SPRINGS] = kg_per_m;
    values
}

/// A table begins and ends at its first and last row, and at two rows of one height.
fn add_jumps<R>(
    rows: &[R],
    height_m: impl Fn(&R) -> f64,
    values: impl Fn(&R) -> SpringsAndMass,
    jumps: &mut Vec<SpringsAndMass>,
) {
    let is_joined = |below: usize| {
        let pair = rows.get(below).zip(rows.get(below + 1));
        pair.is_some_and(|(below, above)| height_m(below) != height_m(above))
    };
    for (index, row) in rows.iter().enumerate() {
        let of_below = f64::from(u8::from(index > 0 && is_joined(index - 1)));
        let of_above = f64::from(u8::from(is_joined(index)));
        jumps.push(values(row).map(|value| (of_below - of_above) * value));
    }
}

/// Divides pieces at heights (m, increasing), and gives each part its environment.
pub(crate) fn cut_in_environment(
    pieces: Vec<Piece>,
    description: &TowerDescription,
    cuts_m: &[f64],
) -> Vec<Piece> {
    let base_m = pieces.first().map_or(0.0, |piece| piece.base_m);
    let mut parts = Vec::with_capacity(pieces.len() + cuts_m.len());
    for piece in pieces {
        let mut below_m = piece.base_m;
        let first = cuts_m.partition_point(|cut| *cut <= piece.base_m);
        let last = cuts_m.partition_point(|cut| *cut < piece.top_m);
        let inside = cuts_m[first..last.max(first)].iter();
        for &end_m in inside.chain([&piece.top_m]) {
            let mut part = piece.part(below_m, end_m);
            part.environment = environment(description, base_m, &part);
            parts.push(part);
            below_m = end_m;
        }
    }
    parts
}

/// The environment of a piece in which soil and water neither begin nor end.
fn environment(description: &TowerDescription, base_m: f64, piece: &Piece) -> Environment {
    let soil = description
        .soil
        .iter()
        .filter_map(|rows| soil_of(rows, piece));
    let tables = description.added_mass.iter();
    let added = tables.filter_map(|rows| added_mass_of(rows, piece));
    let mut environment = Environment {
        soil: soil.reduce(|a, b| [a[0].and(&b[0]), a[1].and(&b[1])]),
        added_kg_per_m: added.reduce(|a, b| [a[0] + b[0], a[1] + b[1]]),
        ..Environment::default()
    };
    if let Some(water) = &description.water {
        let quarter = water.density_kg_per_m3 * std::f64::consts::FRAC_PI_4;
        let middle_m = 0.5 * (piece.base_m + piece.top_m);
        let is_under = |bed_m: f64| bed_m <= middle_m && middle_m <= water.level_m;
        if is_under(water.bed_above_m(base_m)) {
            environment.outside_kg_per_m3 = quarter * water.added_mass_coefficient;
        }
        if water.flooded && is_under(base_m) {
            environment.inside_kg_per_m3 = quarter;
        }
    }
    environment
}

/// The springs of one layer at both ends of a piece; `None` if the layer does not cover the piece.
fn soil_of(rows: &[SoilRow], piece: &Piece) -> Option<[SoilStiffness; 2]> {
    let (pair, shares) = around(rows, |row| row.height_m, piece)?;
    Some(shares.map(|s| pair[0].stiffness.blend(&pair[1].stiffness, s)))
}

/// The mass of one table at both ends of a piece, kg/m; `None` if the table does not cover the
/// piece.
fn added_mass_of(rows: &[AddedMassRow], piece: &Piece) -> Option<[f64; 2]> {
    let (pair, shares) = around(rows, |row| row.height_m, piece)?;
    let (below, above) = (pair[0].mass_kg_per_m, pair[1].mass_kg_per_m);
    Some(shares.map(|s| below + s * (above - below)))
}

/// The two rows around a piece, and the positions of its ends between them, as fractions; two
/// rows at one height are a step.
fn around<'a, R>(
    rows: &'a [R],
    height_m: impl Fn(&R) -> f64,
    piece: &Piece,
) -> Option<(&'a [R], [f64; 2])> {
    let middle_m = 0.5 * (piece.base_m + piece.top_m);
    let above = rows.partition_point(|row| height_m(row) < middle_m);
    let pair = rows.get(above.checked_sub(1)?..=above)?;
    let (below_m, above_m) = (height_m(&pair[0]), height_m(&pair[1]));
    let share = |z_m: f64| (z_m - below_m) / (above_m - below_m);
    Some((pair, [share(piece.base_m), share(piece.top_m)]))
}

/// Whether any part of the tower is below the water level and above the bed.
pub(crate) fn reaches(water: &Water, base_m: f64, top_m: f64) -> bool {
    water.level_m > base_m && water.bed_above_m(base_m) < top_m
}

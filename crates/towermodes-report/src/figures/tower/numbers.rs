//! The picture of a tower as text and as a table.

use towermodes::{Support, Tower, TowerDescription};

use crate::figures::parts::Parts;
use crate::number::{length, mass, short, stiffness};
use crate::svg::DataTable;

/// The figure in words.
pub(super) fn description(of: &Parts<'_>) -> String {
    let mut parts = dimensions(of.tower);
    parts.extend(bodies(of.tower));
    parts.extend(surroundings(of.description));
    parts.push(foundation(of).to_owned());
    let at_tip = "soil springs at the pile tip".to_owned();
    parts.extend(of.tower.springs_at_tip().map(|_| at_tip));
    format!("{}.", parts.join("; "))
}

fn dimensions(tower: &Tower) -> Vec<String> {
    let heights = format!(
        "Structure of {} m height, from z = {} m to z = {} m",
        length(tower.height_m()),
        length(tower.base_m()),
        length(tower.top_m())
    );
    let sections = match (tower.stations().first(), tower.stations().last()) {
        (Some(base), Some(top)) => format!(
            "outer diameter {} m at the base and {} m at the top",
            length(base.outer_diameter_m),
            length(top.outer_diameter_m)
        ),
        _ => format!("{} rows of section properties", tower.properties().len()),
    };
    vec![heights, sections]
}

/// Point masses and RNA.
fn bodies(tower: &Tower) -> Vec<String> {
    let mut parts = Vec::new();
    let masses = tower.point_masses();
    let sum_kg = masses.iter().map(|mass| mass.mass_kg).sum();
    match masses.len() {
        0 => {}
        1 => parts.push(format!("1 point mass of {}", mass(sum_kg))),
        count => parts.push(format!("{count} point masses, {} in total", mass(sum_kg))),
    }
    let rna = tower.rna();
    if !rna.is_absent() {
        parts.push(format!("rotor-nacelle assembly of {}", mass(rna.mass_kg)));
    }
    parts
}

/// Guy wires, water, added mass and soil.
fn surroundings(description: &TowerDescription) -> Vec<String> {
    let wires = description.wires.iter().map(|wires| {
        let (count, height_m) = (wires.count, wires.height_m);
        format!("{count} guy wires at z = {} m", length(height_m))
    });
    let mut parts: Vec<String> = wires.collect();
    let water = description.water.as_ref();
    parts.extend(water.map(|water| format!("water level at z = {} m", length(water.level_m))));
    if !description.added_mass.is_empty() {
        parts.push("added mass along the tower".to_owned());
    }
    parts.extend(soil(description));
    parts
}

/// "soil springs from z = −45 m to z = −20 m".
fn soil(description: &TowerDescription) -> Option<String> {
    let heights = description.soil.iter().flatten().map(|row| row.height_m);
    let (lowest_m, highest_m) = heights.fold(None, |range, z| match range {
        None => Some((z, z)),
        Some((low, high)) => Some((z.min(low), z.max(high))),
    })?;
    let (lowest, highest) = (length(lowest_m), length(highest_m));
    Some(format!(
        "soil springs from z = {lowest} m to z = {highest} m"
    ))
}

fn foundation(parts: &Parts<'_>) -> &'static str {
    match parts.given.foundation.support() {
        _ if parts.tower.base().is_clamped() => "clamped at the base",
        Support::Clamped => "clamped at the base",
        Support::Stiffness(_) => "foundation with a stiffness matrix",
        Support::Springs(_) => "springs at the base",
        Support::Floating(_) => "floating platform",
        Support::Frame(_) => "space frame",
        Support::Form(form) => form.kind().in_words,
    }
}

/// Stations or rows, point masses, RNA and surroundings as a table.
pub(super) fn table(parts: &Parts<'_>) -> DataTable {
    let tower = parts.tower;
    let header = [
        "part",
        "z (m)",
        "outer diameter (m)",
        "wall thickness (mm)",
        "EI (N m²)",
        "mass (t)",
    ];
    let rows = [
        stations(tower),
        sections(tower),
        masses(tower),
        around(parts),
    ];
    DataTable::new(header, rows.into_iter().flatten())
}

/// A row of the table: the part, its height in m, and values in the other four columns.
fn row(what: String, height_m: f64, values: [Option<String>; 4]) -> Vec<String> {
    let values = values.into_iter().map(Option::unwrap_or_default);
    [what, length(height_m)].into_iter().chain(values).collect()
}

fn stations(tower: &Tower) -> Vec<Vec<String>> {
    let stations = tower.stations().iter();
    let tube = stations.map(|station| {
        let diameter = length(station.outer_diameter_m);
        let wall = short(1e3 * station.wall_thickness_m, 4);
        let values = [Some(diameter), Some(wall), None, None];
        row("tube".to_owned(), station.height_m, values)
    });
    tube.collect()
}

fn sections(tower: &Tower) -> Vec<Vec<String>> {
    let stations = tower.properties().iter();
    let section = stations.map(|station| {
        let bending = station.properties.bending_n_m2;
        let of = |stiffness| short(stiffness, 4);
        let text = if bending.are_equal() {
            of(bending.fore_aft)
        } else {
            let (x, y) = (of(bending.fore_aft), of(bending.side_side));
            format!("{x} in x, {y} in y")
        };
        let values = [None, None, Some(text), None];
        row("section".to_owned(), station.height_m, values)
    });
    section.collect()
}

fn masses(tower: &Tower) -> Vec<Vec<String>> {
    let tonnes = |mass_kg: f64| [None, None, None, Some(short(1e-3 * mass_kg, 4))];
    let masses = tower.point_masses().iter();
    let masses = masses.map(|mass| {
        let what = "point mass".to_owned();
        row(what, mass.height_m, tonnes(mass.mass_kg))
    });
    let rna = Some(tower.rna()).filter(|rna| !rna.is_absent());
    let rna = rna.map(|rna| {
        let height_m = tower.top_m() + rna.center_m[2];
        let what = "RNA (centre of mass)".to_owned();
        row(what, height_m, tonnes(rna.mass_kg))
    });
    masses.chain(rna).collect()
}

/// The rows of guy wires, water and soil.
fn around(parts: &Parts<'_>) -> Vec<Vec<String>> {
    let description = parts.description;
    let none = || [None, None, None, None];
    let wires = description.wires.iter().map(|wires| {
        let (angle, each) = (
            short(wires.angle_deg, 3),
            stiffness(wires.stiffness_n_per_m, "N/m"),
        );
        let what = format!("{} guy wires, {angle}°, {each} each", wires.count);
        row(what, wires.height_m, none())
    });
    let level = |(height_m, what): (f64, String)| row(what, height_m, none());
    let scoured = parts.scoured_levels();
    let water = description.water.iter().flat_map(|water| {
        let bed_m = parts.bed_m(water);
        let bed = scoured.is_empty().then(|| (bed_m, "seabed".to_owned()));
        let levels = [(water.level_m, "water level".to_owned())];
        levels.into_iter().chain(bed).map(level)
    });
    let soil = description.soil.iter().flatten().map(|soil| {
        let (x, y) = (soil.stiffness.x_n_per_m2, soil.stiffness.y_n_per_m2);
        let (x, y) = (short(x, 3), short(y, 3));
        let what = format!("soil springs {x} N/m² in x, {y} N/m² in y");
        row(what, soil.height_m, none())
    });
    let scoured = scoured.iter().cloned().map(level);
    wires.chain(water).chain(scoured).chain(soil).collect()
}

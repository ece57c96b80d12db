//! What the computation takes for granted and leaves out, as the tower and its solution have it.

mod base;
mod beam;

use towermodes::{Properties, Rna, Station, TowerDescription};

use super::super::content::ReportContent;
use super::super::document::Block;
use crate::number::{given, mass};

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let description = &content.description;
    let mut points = vec![
        beam::beam(content),
        sections(description),
        "Vibrations are small, about the straight tower, and undamped: neither structural, aerodynamic nor soil damping, all of which change \
         frequencies little."
            .to_owned(),
        gravity(content),
        machine(content),
        base::foundation(content),
    ];
    points.extend(surroundings(description));
    points.push(left_out(description));
    vec![Block::List(points)]
}

fn sections(description: &TowerDescription) -> String {
    let outfitting = if description.outfitting_factor == 1.0 {
        "no factor of outfitting".to_owned()
    } else {
        format!(
            "a factor of {} for outfitting (paint, bolts, platforms)",
            given(description.outfitting_factor)
        )
    };
    if description.stations.is_empty() {
        let mut rows = description.properties.iter().map(|row| &row.properties);
        let has_inertia = |row: &Properties| {
            let bending = row.rotary_inertia_kg_m;
            [bending.fore_aft, bending.side_side, row.polar_inertia_kg_m] != [0.0; 3]
        };
        let linear = if rows.any(has_inertia) {
            "mass, stiffnesses and squared radii of gyration"
        } else {
            "mass and stiffnesses"
        };
        return format!(
            "Sections are those of a table: {linear} are linear in height between its rows. The masses have {outfitting}."
        );
    }
    format!(
        "Sections are {} of isotropic, linearly elastic material that keep their shape; diameter and wall are linear in height \
         between stations. The density has {outfitting}. Doors, flanges and ladders count only as far as masses say so.",
        shape(&description.stations)
    )
}

/// What sections are; of a rod the wall is half the diameter.
fn shape(stations: &[Station]) -> &'static str {
    let is_solid = |station: &Station| {
        let hole_m = station.outer_diameter_m - 2.0 * station.wall_thickness_m;
        hole_m.abs() <= 1e-9 * station.outer_diameter_m
    };
    let solid = stations.iter().filter(|station| is_solid(station)).count();
    match solid {
        0 => "circular tubes",
        all if all == stations.len() => "solid circular rods",
        _ => "circular tubes, solid where the wall is half the diameter,",
    }
}

/// What weights do: of a floating tower they decide what is upright, of others they soften.
fn gravity(content: &ReportContent) -> String {
    let base = content.tower.base();
    let g = content.tower.gravity_m_per_s2();
    match (g == 0.0, base.floats) {
        (true, true) => {
            "Weights are left out of the stiffness: g is 0. They decide roll and pitch of a floating tower, which are right only if the \
             hydrostatic stiffness as given has the weights' part in it."
                .to_owned()
        }
        (true, false) if base.is_clamped() => {
            "Weights are left out of the stiffness: g is 0. They would lower the first bending frequencies, roughly by half the ratio of the \
             weights to those under which the tower buckles: by 5 % where it bears ten times its weights."
                .to_owned()
        }
        (true, false) => {
            "Weights are left out of the stiffness: g is 0. They would lower the first bending frequencies, the more the softer the base."
                .to_owned()
        }
        (false, true) => format!(
            "Weights act with g = {} m/s² (the geometric stiffness of first order): they soften the tower, and with the platform's weight and \
             the hydrostatic stiffness they decide roll and pitch.",
            given(g)
        ),
        (false, false) => format!(
            "Weights press on the tower with g = {} m/s² and make it softer (the geometric stiffness of first order).",
            given(g)
        ),
    }
}

/// The rotor-nacelle assembly, or what is in its place.
fn machine(content: &ReportContent) -> String {
    let tower = &content.tower;
    if *tower.rna() != Rna::default() {
        return "The rotor-nacelle assembly is one rigid body fixed to the tower's top. Its blades do not bend, and a turning rotor adds \
                neither gyroscopic moments nor aerodynamic stiffness."
            .to_owned();
    }
    let mut options = content.reading.split_whitespace();
    let why = if options.any(|option| option == "--no-rna") {
        ": --no-rna leaves it out"
    } else {
        ""
    };
    let masses = tower.point_masses().iter();
    let at_top = masses.filter(|mass| mass.height_m == tower.top_m());
    let kg: Vec<f64> = at_top.map(|mass| mass.mass_kg).collect();
    let masses = match kg.len() {
        0 => String::new(),
        1 => format!(" A mass of {} is at the tower's top.", mass(kg[0])),
        count => format!(
            " {count} masses, {} together, are at the tower's top.",
            mass(kg.iter().sum())
        ),
    };
    format!("There is no rotor-nacelle assembly{why}.{masses}")
}

fn surroundings(description: &TowerDescription) -> Vec<String> {
    let mut points = Vec::new();
    if !description.soil.is_empty() {
        points
            .push("Soil is a bed of linear springs (Winkler) without mass or damping.".to_owned());
    }
    if description.water.is_some() {
        points.push(
            "Water is still and moves with the tower as a constant mass per length; drag, waves and buoyancy are left out."
                .to_owned(),
        );
    }
    if !description.added_mass.is_empty() {
        points.push(
            "Tables of added mass move with the tower transversely and weigh nothing.".to_owned(),
        );
    }
    if !description.wires.is_empty() {
        points.push(
            "Wires are linear springs that stay taut; their tension and mass are left out."
                .to_owned(),
        );
    }
    points
}

/// What no input of this kind has, and this one has not either; the water and the moorings of a
/// platform are not along the tower.
fn left_out(description: &TowerDescription) -> String {
    let has_water = description.water.is_some() || !description.added_mass.is_empty();
    let kinds = [
        (description.soil.is_empty(), "soil along the tower"),
        (!has_water, "water along the tower"),
        (description.wires.is_empty(), "wires on the tower"),
        (
            description.point_masses.is_empty(),
            "masses on the tower's axis",
        ),
    ];
    let absent = kinds.into_iter().filter(|(is_absent, _)| *is_absent);
    let absent: Vec<&str> = absent.map(|(_, name)| name).collect();
    let input = match absent.len() {
        0 => String::new(),
        _ => format!("The input has no {}. ", absent.join(", no ")),
    };
    format!(
        "{input}Local modes of the shell, of blades and of internals are not those of a beam and are not here."
    )
}

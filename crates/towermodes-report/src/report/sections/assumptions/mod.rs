//! The assumptions of the computation for this tower and this solution.

mod base;
mod beam;

use towermodes::{Properties, Station, TowerDescription};

use super::super::content::ReportContent;
use super::super::document::Block;
use crate::number::{given, mass};

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let description = &content.description;
    let mut points = vec![
        beam::beam(content),
        sections(description),
        "Displacements are small, about the undeformed position. The frequencies and mode shapes are those of the undamped structure; the effect of \
         damping on the natural frequencies is small. The command damping computes damping ratios."
            .to_owned(),
        gravity(content),
        rna(content),
        base::foundation(content),
    ];
    points.extend(surroundings(description));
    points.push(left_out(description));
    vec![Block::List(points)]
}

fn sections(description: &TowerDescription) -> String {
    let outfitting = if description.outfitting_factor == 1.0 {
        "The outfitting factor is 1: no secondary mass is added.".to_owned()
    } else {
        format!(
            "The mass is multiplied by the outfitting factor {} for secondary mass such as paint, bolts and platforms.",
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
            "mass, stiffness and squared radii of gyration"
        } else {
            "mass and stiffness"
        };
        return format!(
            "Cross-sections are given by a table: {linear} vary linearly between its rows. {outfitting}"
        );
    }
    format!(
        "Cross-sections are {} of isotropic, linearly elastic material and do not deform (no ovalization); diameter and wall thickness vary \
         linearly between stations. {outfitting} Flanges, doors and ladders are included only as far as the density, the outfitting factor or point masses account for them.",
        shape(&description.stations)
    )
}

/// The form of the cross-sections; a solid rod has a wall thickness of half its diameter.
fn shape(stations: &[Station]) -> &'static str {
    let is_solid = |station: &Station| {
        let hole_m = station.outer_diameter_m - 2.0 * station.wall_thickness_m;
        hole_m.abs() <= 1e-9 * station.outer_diameter_m
    };
    let solid = stations.iter().filter(|station| is_solid(station)).count();
    match solid {
        0 => "circular tubes",
        all if all == stations.len() => "solid circular rods",
        _ => "circular tubes, solid where the wall thickness is half the diameter,",
    }
}

/// The effect of gravity: on a fixed tower it lowers the stiffness, on a floating one it also
/// determines roll and pitch.
fn gravity(content: &ReportContent) -> String {
    let base = content.tower.base();
    let g = content.tower.gravity_m_per_s2();
    match (g == 0.0, base.floats) {
        (true, true) => {
            "Gravity is not included in the stiffness (g = 0). It determines roll and pitch of a floating tower, so these are correct only if the \
             hydrostatic stiffness in the input includes the gravity terms."
                .to_owned()
        }
        (true, false) if base.is_clamped() => {
            "Gravity is not included in the stiffness (g = 0). It would lower the first bending frequencies by roughly half the reciprocal of the \
             buckling load factor: by 5 % at a load factor of 10."
                .to_owned()
        }
        (true, false) => {
            "Gravity is not included in the stiffness (g = 0). It would lower the first bending frequencies, more so on a softer foundation."
                .to_owned()
        }
        (false, true) => format!(
            "Gravity is included as linear geometric stiffness, g = {} m/s²; it lowers the bending stiffness. With the platform weight and the \
             hydrostatic stiffness, gravity determines roll and pitch.",
            given(g)
        ),
        (false, false) => format!(
            "Gravity is included as linear geometric stiffness, g = {} m/s²; it lowers the bending frequencies.",
            given(g)
        ),
    }
}

/// The rotor-nacelle assembly, or the mass that replaces it.
fn rna(content: &ReportContent) -> String {
    let tower = &content.tower;
    if !tower.rna().is_absent() {
        let body = "rotor-nacelle assembly is one rigid body fixed to the tower top. Blade flexibility, gyroscopic moments and aerodynamic stiffness of the rotating rotor are neglected";
        return match content.turbine {
            Some(Ok(_)) => format!(
                "With a rigid rotor the {body}. The coupled turbine has flexible blades, the gyroscopic moments of the rotating rotor, and no aerodynamic stiffness."
            ),
            Some(Err(_)) | None => format!("The {body}."),
        };
    }
    let mut options = content.circumstances.reading.split_whitespace();
    let why = if options.any(|option| option == "--no-rna") {
        " (--no-rna)"
    } else {
        ""
    };
    let masses = tower.point_masses().iter();
    let at_top = masses.filter(|mass| mass.height_m == tower.top_m());
    let kg: Vec<f64> = at_top.map(|mass| mass.mass_kg).collect();
    let masses = match kg.len() {
        0 => String::new(),
        1 => format!(" A mass of {} is at the tower top.", mass(kg[0])),
        count => format!(
            " {count} masses, {} in total, are at the tower top.",
            mass(kg.iter().sum())
        ),
    };
    format!("There is no rotor-nacelle assembly{why}.{masses}")
}

fn surroundings(description: &TowerDescription) -> Vec<String> {
    let mut points = Vec::new();
    if description.has_soil() {
        points.push(
            "Soil is modelled by distributed linear springs (Winkler) without mass or damping."
                .to_owned(),
        );
    }
    if description.water.is_some() {
        points.push(
            "Still water is modelled as frequency-independent added mass per unit length; drag, waves and buoyancy are neglected."
                .to_owned(),
        );
    }
    if !description.added_mass.is_empty() {
        points.push(
            "Tabulated added mass moves with the tower in x and y and has no weight.".to_owned(),
        );
    }
    if !description.wires.is_empty() {
        points.push(
            "Guy wires are linear springs that stay taut; their pretension and mass are neglected."
                .to_owned(),
        );
    }
    points
}

/// Effects that this input does not contain, and effects that no beam model includes.
fn left_out(description: &TowerDescription) -> String {
    let has_water = description.water.is_some() || !description.added_mass.is_empty();
    let kinds = [
        (!description.has_soil(), "soil along the tower"),
        (!has_water, "water along the tower"),
        (description.wires.is_empty(), "guy wires"),
        (description.point_masses.is_empty(), "point masses"),
    ];
    let absent = kinds.into_iter().filter(|(is_absent, _)| *is_absent);
    let absent: Vec<&str> = absent.map(|(_, name)| name).collect();
    let input = match absent.len() {
        0 => String::new(),
        _ => format!("The input has no {}. ", absent.join(", no ")),
    };
    format!(
        "{input}The list of modes does not contain local modes of the shell and of internals or modes of the blades: the beam model of the tower does not \
         represent them."
    )
}

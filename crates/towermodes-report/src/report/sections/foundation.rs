//! The foundation in tables.

use towermodes::frame::FrameFoundation;
use towermodes::{
    ClosedForm, FloatingPlatform, FoundationSprings, ReferredMatrix, StiffnessFoundation, Support,
    TowerDescription,
};

use super::super::document::Block;
use super::super::table::Table;
use super::bodies::inertia;
use super::inputs::of_inputs;
use super::{paragraph, table};
use crate::number::{digits, given, length};

/// The degrees of freedom of the rows and columns of a matrix.
const MOTIONS: [&str; 6] = ["x", "y", "z", "about x", "about y", "about z"];

pub(super) fn foundation(description: &TowerDescription) -> Vec<Block> {
    match description.foundation.support() {
        Support::Clamped => vec![paragraph("The base is clamped.")],
        Support::Stiffness(foundation) => of_stiffness(foundation),
        Support::Springs(springs) => {
            let caption = "Foundation springs at the base";
            vec![table(of_springs(caption, springs, given))]
        }
        Support::Floating(platform) => floating(platform, description.gravity_m_per_s2),
        Support::Form(form) => of_form(form),
        Support::Frame(foundation) => vec![table(of_frame(foundation))],
    }
}

fn of_frame(foundation: &FrameFoundation) -> Table {
    let frame = &foundation.frame;
    let description = frame.description();
    let [x, y, z] = foundation.reference_m().map(given);
    Table::of_facts(
        "Space frame under the tower",
        [
            ("joints", description.joints.len().to_string()),
            ("members", description.members.len().to_string()),
            ("supports", description.supports.len().to_string()),
            ("mass of the frame (kg)", digits(frame.mass_kg(), 6)),
            (
                "mass of the transition piece (kg)",
                given(foundation.platform.mass_kg),
            ),
            (
                "reference point of the transition piece, x, y, z (m)",
                format!("{x}, {y}, {z}"),
            ),
        ],
    )
}

/// The values of a foundation by closed form, what follows from them, and its stiffness: as springs
/// if it is the same in both planes.
fn of_form(form: &dyn ClosedForm) -> Vec<Block> {
    let derived = form.derived().into_iter();
    let derived = derived.map(|(name, value, places)| (name.to_owned(), digits(value, places)));
    let values = of_inputs(&form.caption(), form, derived);
    let stiffness = form.stiffness();
    let number = |value| digits(value, 5);
    let result = match FoundationSprings::of_matrix(&stiffness) {
        Some(springs) => of_springs("Springs at the base", &springs, number),
        None => matrix("Stiffness about the base (N/m, N, N m)", &stiffness, number),
    };
    vec![table(values), table(result)]
}

fn of_stiffness(foundation: &StiffnessFoundation) -> Vec<Block> {
    let stiffness = "Stiffness about the base (N/m, N, N m)";
    let mut blocks = vec![table(matrix(stiffness, &foundation.stiffness, given))];
    if foundation.inertia != [[0.0; 6]; 6] {
        let inertia = "Inertia about the base (kg, kg m, kg m²)";
        blocks.push(table(matrix(inertia, &foundation.inertia, given)));
    }
    blocks
}

fn of_springs(caption: &str, springs: &FoundationSprings, number: impl Fn(f64) -> String) -> Table {
    Table::of_facts(
        caption,
        [
            ("lateral, x and y (N/m)", number(springs.lateral_n_per_m)),
            ("rocking, about x and y (N m)", number(springs.rocking_n_m)),
            (
                "coupling k(x, ry) = −k(y, rx) (N)",
                number(springs.coupling_n),
            ),
            ("vertical (N/m)", number(springs.vertical_n_per_m)),
            ("torsion (N m)", number(springs.torsion_n_m)),
        ],
    )
}

fn floating(platform: &FloatingPlatform, gravity_m_per_s2: f64) -> Vec<Block> {
    // The lines of a tower were checked.
    let linear = platform.with_linear_moorings();
    let platform = &linear.unwrap_or_else(|_| platform.clone());
    let [x, y, z] = platform.center_m;
    let mut facts = vec![
        ("mass including ballast (kg)", given(platform.mass_kg)),
        ("centre of mass from the axis, x (m)", length(x)),
        ("centre of mass from the axis, y (m)", length(y)),
        ("centre of mass, height z (m)", length(z)),
    ];
    facts.extend(inertia(&platform.inertia_kg_m2));
    let body = "Floating platform; moments of inertia about its centre of mass, Ixz = −∫ x z dm";
    let mut blocks = vec![table(Table::of_facts(body, facts))];
    let hydrostatic = if gravity_m_per_s2 == 0.0 {
        "Hydrostatic stiffness as given, without gravity terms (N/m, N, N m)"
    } else {
        "Hydrostatic stiffness as given; the gravity terms of all masses are added to it (N/m, N, N m)"
    };
    let matrices = [
        ("Added mass (kg, kg m, kg m²)", &platform.added_mass),
        (hydrostatic, &platform.hydrostatic),
        ("Mooring stiffness (N/m, N, N m)", &platform.mooring),
    ];
    for (name, referred) in matrices {
        blocks.extend(referred_matrix(name, referred));
    }
    blocks
}

fn referred_matrix(name: &str, referred: &ReferredMatrix) -> Option<Block> {
    if referred.matrix == [[0.0; 6]; 6] {
        return None;
    }
    let caption = format!(
        "{name} about the axis at z = {} m",
        length(referred.height_m)
    );
    Some(table(matrix(&caption, &referred.matrix, given)))
}

fn matrix(caption: &str, matrix: &[[f64; 6]; 6], number: impl Fn(f64) -> String) -> Table {
    let names = MOTIONS.map(|motion| format!("#{motion}"));
    let header = ["motion"].into_iter();
    let mut table = Table::new(caption, header.chain(names.iter().map(String::as_str)));
    for (motion, row) in MOTIONS.into_iter().zip(matrix) {
        let mut cells = vec![motion.to_owned()];
        cells.extend(row.iter().map(|value| number(*value)));
        table.push(cells);
    }
    table
}

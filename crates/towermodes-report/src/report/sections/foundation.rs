//! The foundation in tables.

use towermodes::{
    ClosedForm, FloatingPlatform, FoundationSprings, ReferredMatrix, StiffnessFoundation, Support,
    TowerDescription,
};

use super::super::document::Block;
use super::super::table::Table;
use super::bodies::inertia;
use super::inputs::of_inputs;
use super::substructure::substructure;
use super::{paragraph, table};
use crate::figures::{LinesAtRest, lines_at_rest};
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
        Support::Frame(foundation) => substructure(foundation),
    }
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

fn floating(given_platform: &FloatingPlatform, gravity_m_per_s2: f64) -> Vec<Block> {
    // The lines of a tower were checked.
    let linear = given_platform.with_linear_moorings();
    let platform = &linear.unwrap_or_else(|_| given_platform.clone());
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
    blocks.extend(lines_at_rest(given_platform).iter().flat_map(mooring));
    blocks
}

/// The lines at rest, and their stiffness.
fn mooring(at_rest: &LinesAtRest<'_>) -> Vec<Block> {
    let description = &at_rest.of.description;
    let caption = format!(
        "Mooring lines at rest in {} m of water",
        length(description.depth_m)
    );
    let header = [
        "line",
        "#length (m)",
        "#EA (N)",
        "#mass in air (kg/m)",
        "#diameter (m)",
        "#tension at the upper end (N)",
        "#horizontal tension (N)",
        "#on the seabed (m)",
    ];
    let mut lines = Table::new(&caption, header);
    for (number, (line, state)) in (1..).zip(description.lines.iter().zip(&at_rest.state.lines)) {
        let kind = &description.line_types[line.line_type];
        let [a, b] = state.tensions_n;
        lines.push([
            format!("{number}"),
            length(line.length_m),
            given(kind.axial_stiffness_n),
            given(kind.mass_kg_per_m),
            given(kind.diameter_m),
            digits(a.max(b), 5),
            digits(state.horizontal_n, 5),
            length(state.on_seabed_m),
        ]);
    }
    let height = length(at_rest.of.reference_height_m());
    let load = &at_rest.state.load;
    let stiffness = format!("Stiffness of the mooring lines (N/m, N, N m) about z = {height} m");
    let [x, y, z, rx, ry, rz] = load.force.map(|value| digits(value, 5));
    let force = format!("Force of the mooring lines on the platform about z = {height} m");
    let force = Table::of_facts(
        &force,
        [
            ("force x, y, z (N)", format!("{x}, {y}, {z}")),
            ("moment about x, y, z (N m)", format!("{rx}, {ry}, {rz}")),
        ],
    );
    let number = |value| digits(value, 5);
    vec![
        table(lines.shortened()),
        table(force),
        table(matrix(&stiffness, &load.stiffness, number)),
    ]
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

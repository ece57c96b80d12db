//! The foundation in tables.

use towermodes::{
    ClosedForm, FloatingPlatform, FoundationSprings, ReferredMatrix, StiffnessFoundation, Support,
    Tower, TowerDescription,
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

pub(super) fn foundation(description: &TowerDescription, tower: &Tower) -> Vec<Block> {
    match description.foundation.support() {
        Support::Clamped => vec![paragraph("The base is clamped.")],
        Support::Stiffness(foundation) => of_stiffness(foundation),
        Support::Springs(springs) => {
            let caption = "Foundation springs at the base";
            vec![table(of_springs(caption, springs, given))]
        }
        Support::Floating(platform) => floating(platform, tower),
        Support::Form(form) => of_form(form),
        Support::Frame(foundation) => substructure(foundation),
    }
}

/// The values of a foundation by closed form, the derived values, and its stiffness: as springs if
/// it is the same in both planes.
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

fn floating(given_platform: &FloatingPlatform, tower: &Tower) -> Vec<Block> {
    let linear = tower.linear_platform();
    let platform = &linear.unwrap_or_else(|| given_platform.clone());
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
    let hydrostatic = if tower.gravity_m_per_s2() == 0.0 {
        "Hydrostatic stiffness as given, without gravity terms (N/m, N, N m)"
    } else {
        "Hydrostatic stiffness as given; the gravity terms of all masses are added to it (N/m, N, N m)"
    };
    let matrices = [
        ("Added mass (kg, kg m, kg m²)", &platform.added_mass),
        (hydrostatic, &platform.hydrostatic),
    ];
    for (name, referred) in matrices {
        blocks.extend(referred_matrix(name, referred));
    }
    let lines = lines_at_rest(given_platform);
    // The table of the lines has the same matrix if they are all that holds the platform.
    let is_of_lines = |lines: &LinesAtRest<'_>| {
        let moored = &platform.mooring;
        lines.state.load.stiffness == moored.matrix
            && lines.of.reference_height_m() == moored.height_m
    };
    if !lines.as_ref().is_some_and(is_of_lines) {
        let name = "Mooring stiffness (N/m, N, N m)";
        blocks.extend(referred_matrix(name, &platform.mooring));
    }
    blocks.extend(lines.iter().flat_map(mooring));
    blocks.extend(static_balance(tower));
    blocks
}

/// Weights, buoyancy and lines, the residual, and the position in equilibrium.
fn static_balance(tower: &Tower) -> Vec<Block> {
    let Some(balance) = tower.static_balance() else {
        return vec![paragraph(
            "The static balance is not known: it needs gravity and the buoyancy of the platform.",
        )];
    };
    let force = |value: f64| digits(value, 8);
    let height = length(balance.reference_height_m);
    let caption = format!("Static balance at the reference position; moments about z = {height} m");
    let [x, y, z] = balance.residual_force_n.map(|value| digits(value, 5));
    let [rx, ry, rz] = balance.residual_moment_n_m.map(|value| digits(value, 5));
    let share = format!("{:.3} %", 100.0 * balance.residual_share());
    let mut facts = vec![
        (
            "weight of the platform (N)",
            force(balance.platform_weight_n),
        ),
        ("weight of the tower (N)", force(balance.tower_weight_n)),
        ("weight of the RNA (N)", force(balance.rna_weight_n)),
        ("buoyancy (N)", force(balance.buoyancy_n)),
        (
            "vertical force of the mooring lines (N)",
            force(balance.lines_n),
        ),
        ("residual force in x, y, z (N)", format!("{x}, {y}, {z}")),
        ("residual vertical force, fraction of the weight", share),
        (
            "residual moment about x, y, z (N m)",
            format!("{rx}, {ry}, {rz}"),
        ),
    ];
    match &balance.equilibrium {
        Ok(pose) => {
            let list = |values: [f64; 3]| values.map(|value| digits(value, 4)).join(", ");
            let moved = list([pose.surge_m, pose.sway_m, pose.heave_m]);
            let turned = list([pose.roll_deg, pose.pitch_deg, pose.yaw_deg]);
            facts.push(("equilibrium: surge, sway, heave (m)", moved));
            facts.push(("equilibrium: roll, pitch, yaw (degrees)", turned));
        }
        Err(error) => facts.push(("equilibrium", error.to_string())),
    }
    let at = match balance.linearized_at_equilibrium {
        true => "equilibrium",
        false => "reference position",
    };
    facts.push((
        "stiffness of the mooring lines applies to the",
        at.to_owned(),
    ));
    vec![table(Table::of_facts(&caption, facts))]
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
    // What is left by rounding is shown as zero.
    let shown = |row: usize, column: usize| {
        let least = f64::EPSILON * (matrix[row][row] * matrix[column][column]).abs().sqrt();
        let value = matrix[row][column];
        if value.abs() < least { 0.0 } else { value }
    };
    for (row, motion) in MOTIONS.into_iter().enumerate() {
        let mut cells = vec![motion.to_owned()];
        cells.extend((0..6).map(|column| number(shown(row, column))));
        table.push(cells);
    }
    table
}

//! The modes of a tower as text.

use towermodes::number::{four_digits, with_error};
use towermodes::tower::{Environment, Piece};
use towermodes::{Mode, Solution, Tower};
use towermodes_report::wording::{
    buckling_load_factor, completeness, mesh, mode_shape, static_balance,
};

use super::text::{aligned, rna, text_table, title, tonnes, wrapped};

/// The modes as a table, and lines with masses, method and certificate.
pub fn solution(tower: &Tower, solution: &Solution) -> String {
    let table = text_table(MODE_HEADER, mode_rows(solution), [0, 2, 3, 4]);
    let (title, below) = (title(tower), below_modes(tower, solution));
    format!("{title}{table}\n\n{below}")
}

/// The lines below the table of modes: masses, method, certificate, effective masses.
pub fn below_modes(tower: &Tower, solution: &Solution) -> String {
    let mut text = summary(tower, solution);
    text.push('\n');
    text.push_str(&effective_masses(solution));
    if let Some(factor) = solution.buckling_load_factor {
        let factor = buckling_load_factor(factor);
        text.push_str(&format!(" | buckling load factor {factor}"));
    }
    text.push_str(
        match (tower.gravity_m_per_s2(), solution.buckling_load_factor) {
            (0.0, _) => " | without gravity",
            (_, None) => " | with gravity",
            _ => "",
        },
    );
    text.push('\n');
    if let Some(balance) = tower.static_balance() {
        text.push_str(&(wrapped(&static_balance(&balance)) + "\n"));
    }
    if let Some(missing) = tower.missing_parts() {
        text.push_str(&(wrapped(&missing.to_string()) + "\n"));
    }
    if solution.modes.iter().any(names_other_motions) {
        text.push_str(
            "in parentheses: percent of the energy in the type of motion that the name states; then in other motions\n",
        );
    }
    text
}

/// Whether the table gives the energy in parentheses.
fn names_other_motions(mode: &Mode) -> bool {
    mode_shape(mode) != mode.label()
}

/// The structure that the mass of the tower belongs to.
fn structure(tower: &Tower) -> &'static str {
    let is_surrounded = |piece: &Piece| piece.environment != Environment::default();
    let has_substructure = tower.pieces().iter().any(is_surrounded);
    match (has_substructure, tower.point_masses().is_empty()) {
        (false, true) => "tower",
        (false, false) => "tower with point masses",
        (true, true) => "tower and substructure",
        (true, false) => "tower and substructure with point masses",
    }
}

/// The names of the columns of [`mode_rows`].
pub const MODE_HEADER: [&str; 5] = ["mode", "mode shape", "frequency Hz", "± error", "period s"];

/// The cells of the table of modes, numbers aligned at their decimal points.
pub fn mode_rows(solution: &Solution) -> Vec<[String; 5]> {
    let modes = || solution.modes.iter();
    let frequencies =
        aligned(modes().map(|m| with_error(m.frequency_hz, m.frequency_hz, m.error_hz())));
    let errors = aligned(modes().map(|m| with_error(m.error_hz(), m.frequency_hz, m.error_hz())));
    let rows = modes().zip(frequencies.into_iter().zip(errors));
    let row = |(mode, (frequency, error)): (&Mode, (String, String))| {
        [
            mode.number.to_string(),
            match mode.is_resolved() {
                true => mode_shape(mode),
                false => format!("{}, not resolved", mode_shape(mode)),
            },
            frequency,
            error,
            period(mode),
        ]
    };
    rows.map(row).collect()
}

/// The period, if the mode has one.
fn period(mode: &Mode) -> String {
    if mode.frequency_hz > 0.0 {
        four_digits(mode.period_s())
    } else {
        "none".to_owned()
    }
}

/// The mass of the members of a substructure.
fn below(tower: &Tower) -> String {
    let members_kg = tower.frame().map(|below| below.frame.masses().members_kg);
    let text = members_kg.map(|kg| format!(", substructure {}", tonnes(kg)));
    text.unwrap_or_default()
}

/// Masses of tower, substructure and RNA, method, certificate.
fn summary(tower: &Tower, solution: &Solution) -> String {
    // The error of a method does not include the effect of rotary inertia.
    let physics = match solution.method.has_rotary_inertia() {
        true => "",
        false => " without rotary inertia",
    };
    format!(
        "{} {}{}, {} | {}, {}{physics} | {}",
        structure(tower),
        tonnes(tower.mass_kg()),
        below(tower),
        rna(tower),
        solution.method.name(),
        mesh(solution.method, solution.segments, solution.degree),
        completeness(solution),
    )
}

/// The sum of the effective modal masses as a percentage of the total mass.
fn effective_masses(solution: &Solution) -> String {
    let Some(shares) = solution.effective_mass_shares() else {
        return "effective modal masses do not add up, as each mode has its own added mass".into();
    };
    let [x, y, z, ..] = shares.map(|share| format!("{:.0} %", 100.0 * share));
    format!("effective modal mass of these modes: {x} in x, {y} in y, {z} in z")
}

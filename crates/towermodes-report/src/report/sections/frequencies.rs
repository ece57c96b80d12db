//! Frequencies with their errors, the proof of completeness, energies and effective masses.

use towermodes::GAUSS_HINGE_POSITION;
use towermodes::{ByMotion, Foundation, Method, Mode, Options, Solution};

use super::super::content::ReportContent;
use super::super::document::Block;
use super::super::table::Table;
use super::{paragraph, table};
use crate::number::{NOTHING, digits, frequency, given, percent};
use crate::wording::{
    buckling_load_factor, counted, listed, mesh, mode_shape, proof_of_completeness,
};

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let solution = &content.solution;
    let mut blocks = vec![
        paragraph(how(content)),
        table(of_modes(solution)),
        paragraph(format!(
            "Frequencies are rounded to the second significant digit of their error. The error is the sum of the discretization error and \
                 the algebraic error.{}",
            parentheses(solution)
        )),
        Block::Heading("Errors".to_owned()),
        paragraph(errors(solution)),
        table(of_errors(solution)),
        Block::Heading("Completeness".to_owned()),
        paragraph(proof_of_completeness(solution)),
        Block::Heading("Energy".to_owned()),
        paragraph(names(content)),
        table(energy(solution)),
        Block::Heading("Effective modal masses".to_owned()),
        paragraph(format!(
            "Effective modal mass for base excitation along an axis, or effective moment of inertia about the axis through the base: (uᵀMr)²/(uᵀMu) with the mode \
             shape u and the rigid-body motion r, as a fraction of the total rᵀMr. {}{}",
            total(content),
            no_sum(solution)
        )),
        table(effective_masses(solution)),
    ];
    blocks.extend(buckling(content));
    blocks
}

/// Why the effective masses have no sum, if so.
fn no_sum(solution: &Solution) -> &'static str {
    match solution.effective_mass_shares() {
        Some(_) => "",
        None => {
            " The fractions of several modes do not add up: each mode has its own total, with the added mass at its own frequency."
        }
    }
}

/// The meaning of the parentheses after the mode shapes, if there are any.
fn parentheses(solution: &Solution) -> &'static str {
    let has_others = |mode: &Mode| mode_shape(mode) != mode.label();
    match solution.modes.iter().any(has_others) {
        true => {
            " Percentages in parentheses are the fractions of the energy in the type of motion that the name states, if below 90 %, and in other motions, if at \
             least 5 %."
        }
        false => "",
    }
}

/// The buckling load factor, or why a floating structure has none; nothing without gravity.
fn buckling(content: &ReportContent) -> Vec<Block> {
    let text = if let Some(factor) = content.solution.buckling_load_factor {
        format!(
            "The linear buckling load factor for gravity (self-weight and all masses on the tower) is {}.",
            buckling_load_factor(factor)
        )
    } else if content.tower.base().floats && content.tower.gravity_m_per_s2() != 0.0 {
        "No buckling load factor is given for a floating structure: a larger weight would also change its draught and its hydrostatic \
         stiffness."
            .to_owned()
    } else {
        return Vec::new();
    };
    vec![Block::Heading("Buckling".to_owned()), paragraph(text)]
}

/// The masses that the total includes.
fn total(content: &ReportContent) -> String {
    let d = &content.description;
    let platform_water = match &d.foundation {
        Foundation::Floating(platform) => platform.added_mass.matrix != [[0.0; 6]; 6],
        _ => false,
    };
    let foundation = match &d.foundation {
        Foundation::Stiffness(foundation) => foundation.inertia != [[0.0; 6]; 6],
        _ => false,
    };
    let parts = [
        (!d.point_masses.is_empty(), "its point masses"),
        (
            !content.tower.rna().is_absent(),
            "the rotor-nacelle assembly",
        ),
        (content.tower.base().floats, "the platform"),
        (foundation, "the inertia of the foundation"),
        (platform_water, "the added mass of the platform"),
        (
            d.water.is_some() || !d.added_mass.is_empty(),
            "the added mass of the water in x and y",
        ),
    ];
    let there = parts.into_iter().filter(|(is_there, _)| *is_there);
    let there = ["the tower"].into_iter().chain(there.map(|(_, name)| name));
    let there: Vec<String> = there.map(str::to_owned).collect();
    let soil = match d.has_soil() {
        false => "",
        true => " The soil has no mass.",
    };
    format!("The total includes {}.{soil}", listed(&there))
}

fn how(content: &ReportContent) -> String {
    let solution = &content.solution;
    format!(
        "Computed by the method {} with {}, {} of freedom{}.",
        solution.method.name(),
        mesh(solution.method, solution.segments, solution.degree),
        counted(solution.degrees_of_freedom, "degree"),
        hinges(solution.method, &content.options)
    )
}

/// The hinge position, if the user changed it from that of the method.
pub(super) fn hinges(method: Method, options: &Options) -> String {
    let position = options.hinge_position;
    if method != Method::Cardanic || position == GAUSS_HINGE_POSITION {
        return String::new();
    }
    format!(
        ", hinges at {} of the segment length from its ends (--hinges) instead of at the Gauss points",
        given(position)
    )
}

/// The estimates and bounds of the errors, and their limits.
fn errors(solution: &Solution) -> String {
    let source = match solution.method {
        Method::Spectral => {
            "The discretization error is estimated from the change of the frequency from one polynomial degree, or from one element \
             length, to the next. The frequency is not extrapolated: in the column of the extrapolated frequency the table repeats the frequency itself."
                .to_owned()
        }
        _ => discretization(solution),
    };
    format!(
        "{source} The algebraic error is an estimate of the error of the eigenvalue solver. These errors do not include the \
         uncertainty of the input data and of the model."
    )
}

/// How the discretization errors of a method with segments or elements were estimated.
fn discretization(solution: &Solution) -> String {
    let parts = [from_meshes(solution), from_reference(solution)];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    match parts.is_empty() {
        true => "The discretization error could not be estimated; the column of the extrapolated frequency gives the frequency itself."
            .to_owned(),
        false => parts.join(" "),
    }
}

/// The errors that were estimated from other meshes, if there are any.
fn from_meshes(solution: &Solution) -> Option<String> {
    let others = &solution.error_basis.segments;
    if others.is_empty() || solution.error_basis.compared.len() == solution.modes.len() {
        return None;
    }
    let others: Vec<String> = others.iter().map(usize::to_string).collect();
    let (own, unit) = (solution.segments, solution.method.unit());
    Some(format!(
        "The listed frequencies are computed with {own} {unit}s. Their discretization error is estimated by comparison with the frequencies \
         for {} {unit}s. The extrapolated frequency is the Richardson extrapolation of these frequencies to zero {unit} length.",
        listed(&others),
    ))
}

/// The errors that are differences from the reference solution, if there are any.
fn from_reference(solution: &Solution) -> Option<String> {
    let compared = &solution.error_basis.compared;
    let numbers: Vec<String> = compared.iter().map(usize::to_string).collect();
    let of = match numbers.len() {
        0 => return None,
        count if count == solution.modes.len() => String::new(),
        1 => format!(" of mode {}", listed(&numbers)),
        _ => format!(" of modes {}", listed(&numbers)),
    };
    Some(format!(
        "The discretization error{of} is the difference from the reference solution (method spectral), plus the error of the reference solution. The \
         extrapolated frequency{of} is the frequency of the reference solution."
    ))
}

/// The rule that names a mode.
fn names(content: &ReportContent) -> String {
    let shares = match content.tower.base().floats {
        true => {
            " Surge, sway, heave, roll, pitch and yaw are motions of the whole tower as one rigid body. The shares of a mode are fractions of its kinetic energy: \
             those of the rigid-body motions, and those of the other motions in the rest."
        }
        false => " The share of a motion in a mode is the mean of both fractions.",
    };
    format!(
        "Fractions of the kinetic and of the strain energy of a mode in each motion.{shares} A mode is named after the motion with the largest arrears: the sum of \
         its shares in this mode and in all lower ones, minus the number of lower modes that are named after it. A motion with less than a quarter of the largest \
         share in the mode gives no name."
    )
}

fn of_modes(solution: &Solution) -> Table {
    let mut table = Table::new(
        "Natural frequencies",
        [
            "#mode",
            "mode shape",
            "#frequency (Hz)",
            "#error (Hz)",
            "#period (s)",
        ],
    );
    for mode in &solution.modes {
        table.push([
            mode.number.to_string(),
            mode_shape(mode),
            frequency(mode.frequency_hz, mode.error_hz()),
            digits(mode.error_hz(), 2),
            period(mode),
        ]);
    }
    table.shortened()
}

/// The components of the errors, and the modal masses.
fn of_errors(solution: &Solution) -> Table {
    let mut table = Table::new(
        "Error components and modal masses",
        [
            "#mode",
            "#discretization error (Hz)",
            "#algebraic error (Hz)",
            "#extrapolated frequency (Hz)",
            "#modal mass (kg) or inertia (kg m²)",
        ],
    );
    for mode in &solution.modes {
        table.push([
            mode.number.to_string(),
            digits(mode.discretization_error_hz, 2),
            digits(mode.algebraic_error_hz, 2),
            frequency(mode.extrapolated_hz, mode.error_hz()),
            digits(mode.modal_mass, 4),
        ]);
    }
    table.shortened()
}

fn period(mode: &Mode) -> String {
    if mode.frequency_hz > 0.0 {
        digits(mode.period_s(), 4)
    } else {
        NOTHING.to_owned()
    }
}

fn energy(solution: &Solution) -> Table {
    let mut table = Table::new(
        "Energy fractions, kinetic (k) and strain (s), in percent",
        [
            "#mode",
            "mode shape",
            "#k fore-aft",
            "#k side-side",
            "#k torsion",
            "#k axial",
            "#s fore-aft",
            "#s side-side",
            "#s torsion",
            "#s axial",
        ],
    );
    for mode in &solution.modes {
        let parts = |of: &ByMotion| of.values().map(percent);
        let mut row = vec![mode.number.to_string(), mode.label()];
        row.extend(parts(&mode.energy.kinetic));
        row.extend(parts(&mode.energy.strain));
        table.push(row);
    }
    table.without_empty_columns().shortened()
}

fn effective_masses(solution: &Solution) -> Table {
    let mut table = Table::new(
        "Effective modal masses in percent of the total",
        [
            "#mode",
            "mode shape",
            "#x",
            "#y",
            "#z",
            "#about x",
            "#about y",
            "#about z",
        ],
    );
    for mode in &solution.modes {
        let mut row = vec![mode.number.to_string(), mode.label()];
        row.extend(mode.effective_mass_shares().map(percent_or_dash));
        table.push(row);
    }
    let mut table = table.shortened();
    let Some(shares) = solution.effective_mass_shares() else {
        return table;
    };
    let mut sum = vec!["sum".to_owned(), "listed modes".to_owned()];
    sum.extend(shares.map(percent_or_dash));
    table.push(sum);
    if let Some(brief) = &mut table.brief {
        brief.shown.push(table.rows.len() - 1);
    }
    table
}

/// A fraction in percent; a dash where the total is zero.
fn percent_or_dash(fraction: f64) -> String {
    if fraction.is_finite() {
        percent(fraction)
    } else {
        NOTHING.to_owned()
    }
}

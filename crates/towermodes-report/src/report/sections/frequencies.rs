//! Frequencies with their errors, where their energy is, and the proof that they are all.

use towermodes::elements::GAUSS_HINGE_POSITION;
use towermodes::{ByMotion, Foundation, Method, Mode, Options, Rna, Solution};

use super::super::content::ReportContent;
use super::super::document::Block;
use super::super::table::Table;
use super::{paragraph, table};
use crate::number::{NOTHING, digits, frequency, given, percent};
use crate::wording::{buckling_load_factor, counted, mesh, mode_shape, proof_of_completeness};

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let solution = &content.solution;
    let mut blocks = vec![
        paragraph(how(content)),
        table(of_modes(solution)),
        paragraph(
            "A frequency ends with the first digit that its error reaches; the error is the sum of a discretization error and an algebraic one.",
        ),
        Block::Heading("Errors".to_owned()),
        paragraph(errors(solution)),
        table(of_errors(solution)),
        Block::Heading("Completeness".to_owned()),
        paragraph(proof_of_completeness(
            &solution.certificate,
            solution.modes.len(),
        )),
        Block::Heading("Energy".to_owned()),
        paragraph(names(content)),
        table(energy(solution)),
        Block::Heading("Effective masses".to_owned()),
        paragraph(format!(
            "How much of the whole mass, or of its inertia about the base, a mode moves as the base is shaken along or about an axis: \
             (uᵀMr)²/(uᵀMu) with the shape u and the rigid motion r, as shares of rᵀMr. The whole is {}.",
            whole(content)
        )),
        table(effective_masses(solution)),
    ];
    if let Some(factor) = solution.buckling_load_factor {
        blocks.push(Block::Heading("Buckling".to_owned()));
        blocks.push(paragraph(format!(
            "The linear buckling load factor for gravity (self-weight and rotor-nacelle assembly) is {}.",
            buckling_load_factor(factor)
        )));
    } else if content.tower.base().floats && content.tower.gravity_m_per_s2() != 0.0 {
        blocks.push(Block::Heading("Buckling".to_owned()));
        blocks.push(paragraph(
            "No factor of buckling is given: the tower floats, and more weight would change how deep it floats and what holds it upright, not \
             only what presses on it.",
        ));
    }
    blocks
}

/// What moves as the base is shaken.
fn whole(content: &ReportContent) -> String {
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
            *content.tower.rna() != Rna::default(),
            "the rotor-nacelle assembly",
        ),
        (content.tower.base().floats, "the platform"),
        (foundation, "the inertia of the foundation"),
        (platform_water, "the platform's added mass"),
        (
            d.water.is_some() || !d.added_mass.is_empty(),
            "the water that moves with the tower in x and y",
        ),
    ];
    let there = parts.into_iter().filter(|(is_there, _)| *is_there);
    let there: Vec<&str> = there.map(|(_, name)| name).collect();
    let soil = match d.soil.is_empty() {
        true => "",
        false => "; soil has no mass here",
    };
    match there.len() {
        0 => format!("the tower's own{soil}"),
        _ => format!("the tower with {}{soil}", there.join(", ")),
    }
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

/// Where the hinges of a segment are, if the user put them elsewhere than the method has them.
pub(super) fn hinges(method: Method, options: &Options) -> String {
    let position = options.hinge_position;
    if method != Method::Cardanic || position == GAUSS_HINGE_POSITION {
        return String::new();
    }
    format!(
        ", hinges at {} of a segment's length from its ends (--hinges) instead of the Gauss points'",
        given(position)
    )
}

/// What the errors are of, and where they are from.
fn errors(solution: &Solution) -> String {
    let discretization = if solution.method == Method::Spectral {
        "The discretization error is an estimate of what the polynomials leave out: how far a frequency changes from one degree, or from one \
         length of the elements, to the next. Nothing is extrapolated: the extrapolated frequency is the frequency itself."
    } else {
        "The discretization error is an estimate of what the finite number of segments or elements leaves out, from meshes of other \
         finenesses; the extrapolated frequency is the limit of ever finer meshes as far as these tell."
    };
    format!(
        "{discretization} The algebraic error is a bound on that of the eigenvalue computation. None of them knows how well the input \
         describes the tower."
    )
}

/// What a mode's name says.
fn names(content: &ReportContent) -> String {
    let text =
        "The shares of each motion in the kinetic energy and in the strain energy of a mode.";
    if content.tower.base().floats {
        return format!(
            "{text} Surge, sway, heave, roll, pitch and yaw are modes in which the whole tower moves as one body, each named after the rigid \
             motion that it has most of; any other mode is named after the motion with most of both energies."
        );
    }
    format!("{text} A mode is named after the motion with most of both.")
}

fn of_modes(solution: &Solution) -> Table {
    let mut table = Table::new(
        "Natural frequencies",
        [
            "#mode",
            "what it is",
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

/// The parts of the errors, and what belongs to a mode without being a frequency.
fn of_errors(solution: &Solution) -> Table {
    let mut table = Table::new(
        "What the errors are made of; modal masses",
        [
            "#mode",
            "#discretization (Hz)",
            "#algebraic (Hz)",
            "#extrapolated (Hz)",
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
        "Parts of the energy, kinetic (k) and strain (s), in percent",
        [
            "#mode",
            "what it is",
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
        "Effective masses in percent of the whole",
        [
            "#mode",
            "what it is",
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
        let shares = mode.effective_mass.iter().enumerate();
        row.extend(shares.map(|(i, mass)| share(mass / solution.rigid_inertia[i][i])));
        table.push(row);
    }
    let mut table = table.shortened();
    let mut sum = vec!["sum".to_owned(), "the modes above".to_owned()];
    sum.extend(solution.effective_mass_shares().map(share));
    table.push(sum);
    if let Some(brief) = &mut table.brief {
        brief.shown.push(table.rows.len() - 1);
    }
    table
}

/// In percent; nothing of nothing is no share.
fn share(share: f64) -> String {
    if share.is_finite() {
        percent(share)
    } else {
        NOTHING.to_owned()
    }
}

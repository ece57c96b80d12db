//! `towermodes design`.

use towermodes::{Options, Rotor, Workspace};
use towermodes_analysis::resonance::DEFAULT_MARGIN;
use towermodes_design::design::{
    Design, DesignError, DesignProblem, Goal, Variable, design, window_hz,
};
use towermodes_files::{
    DesignBand, DesignDocument, DesignFrequency, DesignStudy, DesignedFrequency, DesignedLimit,
    DesignedVariable, TowerInput, read_design_study, write_design_json,
};

use crate::args::{DesignArguments, FoundFormat};
use crate::failure::{Failure, note, note_texts, warn};
use crate::found::{check_output, study_source, write_tower};
use crate::input::tower_input;
use crate::output::{check_not_inputs, deliver};
use crate::table;

/// Finds the lightest tower of a study, and writes it.
pub(crate) fn run(arguments: &DesignArguments) -> Result<(), Failure> {
    check_output(&arguments.found, &arguments.input, &arguments.study)?;
    let output = arguments.found.output();
    let study = study_source(&arguments.study, &arguments.input)?;
    let study = read_design_study(&study).map_err(Failure::Input)?;
    let input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let tower = input.tower().map_err(Failure::Input)?;
    note(&input.notes);
    warn(tower.warnings(), &input);
    let problem = problem(&study, &input)?;
    let options = Options {
        method: study.method.or(input.method).unwrap_or_default(),
        segments: study.segments,
        rotary_inertia: study.rotary_inertia,
        ..Options::default()
    };
    let mut workspace = Workspace::default();
    let found = design(&input.description, &problem, &options, &mut workspace);
    let found = found.map_err(|error| failure(error, &study))?;
    let warnings = warnings(&found);
    let mut result = Vec::new();
    match arguments.found.format {
        FoundFormat::Json => {
            let document = document(&input, &problem, &found, &warnings);
            write_design_json(&document, &mut result)?;
        }
        FoundFormat::Table => {
            let text = table::design(&input.description.name, &problem, &found);
            result.extend(text.into_bytes());
        }
    }
    note_texts(&warnings);
    if let Some(output) = output {
        write_tower(&input, &found.tower, output)?;
    }
    deliver(&result, None)
}

/// The problem of a study for its tower.
fn problem(study: &DesignStudy, input: &TowerInput) -> Result<DesignProblem, Failure> {
    let choices = study.choices(&input.description).map_err(Failure::Input)?;
    let variables = choices.variables.into_iter().map(|choice| {
        let [low, high] = choice.between;
        Variable {
            change: choice.change,
            low,
            high,
            step: choice.step,
        }
    });
    let goals: Result<Vec<Goal>, Failure> = study
        .frequencies
        .iter()
        .map(|frequency| goal(frequency, study, input))
        .collect();
    Ok(DesignProblem {
        variables: variables.collect(),
        goals: goals?,
        falling: choices.falling,
        diameter_to_wall: study.diameter_to_wall,
        cone_angle_deg: study.cone_angle_deg,
    })
}

/// The band of a frequency in Hz.
fn goal(
    frequency: &DesignFrequency,
    study: &DesignStudy,
    input: &TowerInput,
) -> Result<Goal, Failure> {
    let [min_hz, max_hz] = match frequency.band {
        DesignBand::Hz(band) => band,
        DesignBand::Multiples(multiples, margin) => {
            let rotor: Option<&Rotor> = input.description.rotor.as_ref();
            let rotor = rotor.ok_or(Failure::NoRotorSpeeds)?;
            let window = window_hz(rotor, multiples, margin.unwrap_or(DEFAULT_MARGIN));
            window.map_err(|error| {
                let place = study.source.place(frequency.span.start);
                Failure::WrongStudy(format!("{place}: {error}"))
            })?
        }
    };
    Ok(Goal {
        mode: frequency.mode,
        min_hz,
        max_hz,
    })
}

/// Errors that a line of the study explains name it.
fn failure(error: DesignError, study: &DesignStudy) -> Failure {
    let of_mode = match &error {
        DesignError::NoMode { mode, .. } => {
            let mut all = study.frequencies.iter();
            all.find(|frequency| frequency.mode == *mode)
        }
        _ => None,
    };
    match of_mode {
        Some(frequency) => {
            let place = study.source.place(frequency.span.start);
            Failure::WrongStudy(format!("{place}: {error}"))
        }
        None => Failure::Design(error),
    }
}

/// What a user must know about a result.
fn warnings(found: &Design) -> Vec<String> {
    let mut warnings = Vec::new();
    if !found.is_proved() {
        warnings.push(format!(
            "the KKT residual is {:.1e}: the tower meets all limits, but a lighter one may exist",
            found.kkt_residual
        ));
    }
    if !found.certificate.complete {
        warnings.push(
            "the certificate of the tower found is incomplete: a mode may be missing".to_owned(),
        );
    }
    for reached in found.reached.iter().filter(|one| !one.is_met()) {
        warnings.push(format!(
            "{} of the tower found is {} Hz, outside its band by more than its error",
            reached.goal.mode, reached.after_hz
        ));
    }
    warnings
}

fn document(
    input: &TowerInput,
    problem: &DesignProblem,
    found: &Design,
    warnings: &[String],
) -> DesignDocument {
    let pairs = found.before.iter().zip(&found.values);
    let variables = problem.variables.iter().zip(pairs);
    let variables = variables.map(|(of, (before, after))| DesignedVariable {
        name: of.change.name().to_owned(),
        unit: of.change.unit(),
        before: *before,
        after: *after,
        lowest: of.low,
        highest: of.high,
    });
    let frequencies = found.reached.iter().map(|of| DesignedFrequency {
        mode: of.goal.mode.to_string(),
        min_hz: Some(of.goal.min_hz).filter(|hz| *hz > 0.0),
        max_hz: Some(of.goal.max_hz).filter(|hz| hz.is_finite()),
        before_hz: of.before_hz,
        after_hz: of.after_hz,
        error_hz: of.error_hz,
    });
    let active = found.active.iter().map(|of| DesignedLimit {
        limit: problem.words(&of.limit),
        kg_per_unit: of.kg_per_unit,
        kg_per_percent: of.kg_per_percent,
    });
    let notes = input.notes.iter().map(ToString::to_string);
    DesignDocument {
        tower: input.description.name.clone(),
        variables: variables.collect(),
        mass_before_kg: found.mass_kg[0],
        mass_kg: found.mass_kg[1],
        mass_without_steps_kg: found.without_steps_kg,
        frequencies: frequencies.collect(),
        active: active.collect(),
        kkt_residual: found.kkt_residual,
        is_proved: found.is_proved(),
        certified: found.certificate.complete,
        solves: found.solves,
        warnings: notes.chain(warnings.iter().cloned()).collect(),
    }
}

//! The design problem of a file and a tower, and its result as a document.

use std::ops::Range;

use thiserror::Error;
use towermodes::{Options, Rotor, TowerDescription};
use towermodes_analysis::resonance::DEFAULT_MARGIN;
use towermodes_design::design::{
    Design, DesignError, DesignProblem, Goal, OtherHolder, Variable, window_hz,
};
use towermodes_files::{
    DesignBand, DesignDocument, DesignFrequency, DesignStudy, DesignedFrequency, DesignedLimit,
    DesignedOther, DesignedVariable, Diagnostic, DiagnosticKind, ReadError, TowerInput,
};

/// Why a design file does not define a problem for a tower.
#[derive(Debug, Error)]
pub enum StudyError {
    /// Names in the design file are not input values or modes of the tower.
    #[error("{0}")]
    Input(ReadError),
    /// The design file uses multiples of the rotor speed, which is unknown.
    #[error(
        "the design file uses multiples of the rotor speed, but the tower file has no [rotor] rpm"
    )]
    NoRotorSpeeds,
    /// The band between multiples of the rotor speed is empty.
    #[error("{0}")]
    Window(ReadError),
}

/// The options for the towers of a design file.
pub fn options(study: &DesignStudy, input: &TowerInput) -> Options {
    Options {
        method: study.method.or(input.prescribed.method).unwrap_or_default(),
        segments: study.segments,
        rotary_inertia: study.rotary_inertia,
        ..Options::default()
    }
}

/// The problem of a design file for its tower.
///
/// # Errors
/// [`StudyError`].
pub fn problem(study: &DesignStudy, input: &TowerInput) -> Result<DesignProblem, StudyError> {
    let choices = study
        .choices(&input.description)
        .map_err(StudyError::Input)?;
    let variables = choices.variables.into_iter().map(|choice| {
        let [low, high] = choice.between;
        Variable {
            change: choice.change,
            low,
            high,
            step: choice.step,
        }
    });
    let goals: Result<Vec<Goal>, StudyError> = study
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
) -> Result<Goal, StudyError> {
    let [min_hz, max_hz] = match frequency.band {
        DesignBand::Hz(band) => band,
        DesignBand::Multiples(multiples, margin) => {
            let rotor: Option<&Rotor> = input.description.rotor.as_ref();
            let rotor = rotor.ok_or(StudyError::NoRotorSpeeds)?;
            let window = window_hz(rotor, multiples, margin.unwrap_or(DEFAULT_MARGIN));
            window.map_err(|error| {
                let span = frequency.span.clone();
                StudyError::Window(mistake(span, error.to_string(), study))
            })?
        }
    };
    Ok(Goal {
        mode: frequency.mode,
        min_hz,
        max_hz,
    })
}

/// An error at the line of the design file that explains it; none for others.
pub fn located(
    error: &DesignError,
    study: &DesignStudy,
    tower: &TowerDescription,
) -> Option<ReadError> {
    let of_variable = |name: &str| {
        let choices = study.choices(tower).ok()?.variables;
        let choice = choices.iter().find(|choice| choice.change.name() == name)?;
        Some(study.variables.get(choice.entry)?.name.span.clone())
    };
    let of_mode = |mode| {
        let mut all = study.frequencies.iter();
        let frequency = all.find(|frequency| frequency.mode == mode)?;
        Some(frequency.span.clone())
    };
    let variable = error.variable().and_then(of_variable);
    let span = variable.or(error.mode().and_then(of_mode))?;
    Some(mistake(span, error.to_string(), study))
}

fn mistake(span: Range<usize>, sentence: String, study: &DesignStudy) -> ReadError {
    let mistake = Diagnostic::new(span, DiagnosticKind::Contradiction(sentence));
    ReadError::mistakes(&study.source, vec![mistake])
}

/// Warnings about a result.
pub fn warnings(found: &Design) -> Vec<String> {
    let mut warnings = Vec::new();
    if !found.is_stationary() {
        warnings.push(format!(
            "the KKT residual is {:.1e}: the tower meets all limits, but a lighter one may exist",
            found.kkt_residual
        ));
    }
    if found.steps.is_some_and(|steps| !steps.is_searched) {
        warnings.push(
            "the search of steps ended at its limit of solves: a change of a step may be lighter"
                .to_owned(),
        );
    }
    if !found.certificate.complete {
        warnings.push(
            "the list of modes of the final tower is not proved complete: a mode may be missing"
                .to_owned(),
        );
    }
    for reached in &found.reached {
        let own = (reached.goal.mode, reached.after_hz);
        let others = reached.others.iter().map(|other| (other.mode, other.hz));
        let all = std::iter::once(own).chain(others);
        for (mode, hz) in all.filter(|(_, hz)| !reached.goal.allows(*hz)) {
            let goal = reached.goal.mode;
            warnings.push(format!(
                "{mode} of the tower found is {hz} Hz, outside the band of {goal}"
            ));
        }
    }
    warnings
}

fn other(of: &OtherHolder) -> DesignedOther {
    DesignedOther {
        mode: of.mode.to_string(),
        hz: of.hz,
        share: of.share,
    }
}

/// The result with the names of the design file.
pub fn document(
    input: &TowerInput,
    problem: &DesignProblem,
    found: &Design,
    warnings: &[String],
) -> DesignDocument {
    let means = found.before_is_mean.iter();
    let pairs = found.before.iter().zip(means).zip(&found.values);
    let variables = problem.variables.iter().zip(pairs);
    let variables = variables.map(|(of, ((before, is_mean), after))| DesignedVariable {
        before_is_mean: *is_mean,
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
        share: of.share,
        others: of.others.iter().map(other).collect(),
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
        mass_without_steps_kg: found.steps.map(|steps| steps.without_steps_kg),
        frequencies: frequencies.collect(),
        active: active.collect(),
        kkt_residual: found.kkt_residual,
        is_stationary: found.is_stationary(),
        steps_are_searched: found.steps.map(|steps| steps.is_searched),
        certified: found.certificate.complete,
        solves: found.solves,
        warnings: notes.chain(warnings.iter().cloned()).collect(),
    }
}

//! The calibration problem of a file and a tower, and its result as a document.

use towermodes::{Change, TowerDescription};
use towermodes_design::calibration::{
    AtBound, Calibration, CalibrationError, Fitted, Measured, MeasuredShape, Prior, Problem,
    Unknown,
};
use towermodes_files::{
    CalibrationDocument, Diagnostic, DiagnosticKind, FittedDirection, FittedFrequency,
    FittedNumber, FittedShare, MeasuredFile, MeasuredMode, NamedUnknown, ReadError, TowerInput,
};

/// Suggestion if there are too few measurements.
const NO_PRIOR: &str = "give it { prior = [mean, standard deviation] }, or fit fewer inputs";

/// The problem of a file for its tower: with the unknowns of the file, or with those in `free` and
/// the priors and bounds that the file has for them.
///
/// # Errors
/// [`ReadError::Mistakes`] at names in the file that are not names of input values.
pub fn problem(
    base: &TowerDescription,
    file: &MeasuredFile,
    free: Vec<Change>,
) -> Result<Problem, ReadError> {
    let of_file = file.unknowns.iter().zip(file.changes(base)?);
    let of_file: Vec<Unknown> = of_file
        .map(|(named, change)| unknown(named, change))
        .collect();
    let chosen = |change: Change| {
        let mut known = of_file.iter();
        let known = known.find(|one| one.change.name() == change.name());
        known.cloned().unwrap_or_else(|| Unknown::new(change))
    };
    let unknowns = match free.is_empty() {
        true => of_file,
        false => free.into_iter().map(chosen).collect(),
    };
    Ok(Problem {
        base: base.clone(),
        unknowns,
        measured: file.measured.iter().map(measured).collect(),
    })
}

/// An error at the place in the file that explains it; none for others.
pub fn located(error: &CalibrationError, file: &MeasuredFile) -> Option<ReadError> {
    let of_mode = error
        .measurement()
        .and_then(|index| file.measured.get(index));
    let of_unknown = error.unknown().and_then(|name| {
        let mut all = file.unknowns.iter();
        all.find(|one| one.name.value.trim() == name)
    });
    let span = of_mode.map(|one| one.span.clone());
    let span = span.or(of_unknown.map(|one| one.name.span.clone()))?;
    let mistake = Diagnostic::new(span, DiagnosticKind::Contradiction(error.to_string()));
    let mistake = match error {
        CalibrationError::TooFewMeasurements { .. } => mistake.with_hint(NO_PRIOR),
        _ => mistake,
    };
    Some(ReadError::mistakes(&file.source, vec![mistake]))
}

fn unknown(named: &NamedUnknown, change: Change) -> Unknown {
    let prior = named.prior;
    Unknown {
        change,
        prior: prior.map(|[mean, deviation]| Prior { mean, deviation }),
        bounds: named.bounds,
    }
}

fn measured(one: &MeasuredMode) -> Measured {
    let shape = MeasuredShape {
        heights_m: one.shape.iter().map(|row| row[0]).collect(),
        displacements: one.shape.iter().map(|row| [row[1], row[2]]).collect(),
    };
    Measured {
        frequency_hz: one.frequency_hz,
        deviation_hz: one.deviation_hz,
        mode: one.mode,
        shape: (!one.shape.is_empty()).then_some(shape),
    }
}

/// The result with the name of the tower.
pub fn document(input: &TowerInput, fit: &Calibration) -> CalibrationDocument {
    let correlation = |value: &f64| Some(*value).filter(|value| !value.is_nan());
    let correlations = fit.correlations.iter();
    let numbers = fit.unknowns.iter().enumerate();
    let remarks = fit.remarks();
    CalibrationDocument {
        tower: input.description.name.clone(),
        numbers: numbers
            .map(|(index, one)| number(fit, index, one))
            .collect(),
        correlations: correlations
            .map(|row| row.iter().map(correlation).collect())
            .collect(),
        measured: frequencies(fit),
        directions: directions(fit),
        chi_square: fit.chi_square,
        degrees_of_freedom: fit.degrees_of_freedom,
        iterations: fit.iterations,
        is_pairing_stable: fit.is_pairing_stable,
        certified: fit.is_certified,
        remarks: remarks.iter().map(ToString::to_string).collect(),
        warnings: input.notes.iter().map(ToString::to_string).collect(),
    }
}

fn number(fit: &Calibration, index: usize, one: &Fitted) -> FittedNumber {
    let modes = fit.measured.iter().map(|one| (one.mode.to_string(), false));
    let priors = fit.unknowns.iter().filter(|one| one.prior.is_some());
    let sources = modes.chain(priors.map(|one| (one.name.clone(), true)));
    let shares = sources.zip(&fit.shares[index]);
    FittedNumber {
        name: one.name.clone(),
        unit: one.unit,
        before: one.before,
        value: one.value,
        deviation: one.deviation,
        interval: one.interval,
        is_logarithm: one.is_logarithm,
        prior: one.prior.map(|prior| [prior.mean, prior.deviation]),
        prior_residual: one.prior_residual,
        at_bound: one.at_bound.map(|bound| match bound {
            AtBound::Lower => "lower",
            AtBound::Upper => "upper",
        }),
        decided_by: shares
            .map(|((name, is_prior), &share)| FittedShare {
                name,
                is_prior,
                share,
            })
            .collect(),
    }
}

fn frequencies(fit: &Calibration) -> Vec<FittedFrequency> {
    let of = fit.measured.iter().map(|one| FittedFrequency {
        mode: one.mode.to_string(),
        or_mode: one.ambiguity.map(|doubt| doubt.other().to_string()),
        measured_hz: one.measured_hz,
        deviation_hz: one.deviation_hz,
        before_hz: one.before_hz,
        fitted_hz: one.fitted_hz,
        residual: one.residual,
        share: one.share,
    });
    of.collect()
}

fn directions(fit: &Calibration) -> Vec<FittedDirection> {
    let of = fit.directions.iter().map(|one| FittedDirection {
        singular_value: one.singular_value,
        parts: one.parts.clone(),
        scales: one.scales.clone(),
    });
    of.collect()
}

//! `towermodes calibrate`.

use towermodes::{Change, TowerDescription};
use towermodes_design::calibration::{
    AtBound, Calibration, CalibrationError, Fitted, Measured, MeasuredShape, Prior, Problem,
    Unknown, calibrate,
};
use towermodes_files::{
    CalibrationDocument, FittedDirection, FittedFrequency, FittedNumber, FittedShare, MeasuredFile,
    MeasuredMode, NamedUnknown, TowerInput, read_measured, write_calibration_json,
};

use crate::args::{CalibrateArguments, FoundFormat, Prescribed};
use crate::failure::{Failure, note, warn};
use crate::found::{check_output, study_source, write_tower};
use crate::input::tower_input;
use crate::output::{check_not_inputs, deliver};
use crate::progress::Progress;
use crate::table;

/// Fits numbers of a tower to measured frequencies, and writes the fitted tower.
pub(crate) fn run(arguments: &CalibrateArguments) -> Result<(), Failure> {
    check_output(&arguments.found, &arguments.input, &arguments.measured)?;
    let output = arguments.found.output();
    let file = study_source(&arguments.measured, &arguments.input)?;
    let file = read_measured(&file).map_err(Failure::Input)?;
    let mut input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let tower = input.tower().map_err(Failure::Input)?;
    let options = arguments.options(Prescribed::of(&mut input));
    let options = options.map_err(Failure::Usage)?;
    note(&input.notes);
    warn(tower.warnings(), &input);
    let problem = problem(&input.description, &file, &arguments.free())?;
    let progress = Progress::of_one();
    let mut workspace = progress.workspace();
    let done = calibrate(&problem, &options, &mut workspace);
    drop((workspace, progress));
    let fit = done.map_err(|error| failure(error, &file))?;
    let mut result = Vec::new();
    match arguments.found.format {
        FoundFormat::Json => write_calibration_json(&document(&input, &fit), &mut result)?,
        FoundFormat::Table => {
            let text = table::calibration(&input.description.name, &fit);
            result.extend(text.into_bytes());
        }
    }
    if let Some(output) = output {
        write_tower(&input, &fit.description, output)?;
    }
    deliver(&result, None)
}

/// The unknowns of the file, or those of `--free` with what the file knows of them.
fn problem(
    base: &TowerDescription,
    file: &MeasuredFile,
    free: &[&str],
) -> Result<Problem, Failure> {
    let changes = file.changes(base).map_err(Failure::Input)?;
    let of_file = file.unknowns.iter().zip(changes);
    let of_file: Vec<Unknown> = of_file
        .map(|(named, change)| unknown(named, change))
        .collect();
    let chosen = |name: &&str| {
        let change = Change::parse(name, base).map_err(Failure::NoChange)?;
        let mut known = of_file.iter();
        let known = known.find(|one| one.change.name() == change.name());
        Ok(known.cloned().unwrap_or_else(|| Unknown::new(change)))
    };
    let unknowns = match free.is_empty() {
        true => of_file,
        false => free.iter().map(chosen).collect::<Result<_, Failure>>()?,
    };
    if unknowns.is_empty() {
        return Err(Failure::WrongStudy(format!(
            "{}: no number is to be fitted; add for example \"foundation.rocking\" = {{}} to [calibrate.unknowns], or give --free NAME",
            file.source.name
        )));
    }
    Ok(Problem {
        base: base.clone(),
        unknowns,
        measured: file.measured.iter().map(measured).collect(),
    })
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

/// Errors that the file explains name it, with the line.
fn failure(error: CalibrationError, file: &MeasuredFile) -> Failure {
    let error = match error {
        CalibrationError::Tower(error) => return Failure::Tower(error),
        CalibrationError::Solve(error) => return Failure::Unsolved(error),
        error => error,
    };
    let of_mode = error
        .measurement()
        .and_then(|index| file.measured.get(index));
    let of_unknown = error.unknown().and_then(|name| {
        let mut all = file.unknowns.iter();
        all.find(|one| one.name.value.trim() == name)
    });
    let byte = of_mode.map(|one| one.span.start);
    let byte = byte.or(of_unknown.map(|one| one.name.span.start));
    let place = match byte {
        Some(byte) => file.source.place(byte),
        None if error.is_usage() => file.source.name.clone(),
        None => return Failure::Calibration(error.to_string()),
    };
    let text = format!("{place}: {error}");
    match error.is_usage() {
        true => Failure::WrongStudy(text),
        false => Failure::Calibration(text),
    }
}

fn document(input: &TowerInput, fit: &Calibration) -> CalibrationDocument {
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

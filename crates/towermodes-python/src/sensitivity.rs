//! Derivatives of frequencies and mass with respect to the input values of a tower.

use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use towermodes::{Change, ModeName, Sensitivities, SensitivityError, Solver};
use towermodes_files::SweepResults;
use towermodes_sweep::{Base, MORE_MODES, Sweep};

use crate::error::{of_solve, of_tower, usage};
use crate::interrupt::interruptible;
use crate::sweep::{Names, SweepOptions, mode_names, refused};
use crate::tower::Tower;

/// Name, unit and value of each change.
type Varied = Vec<(String, &'static str, f64)>;

/// The changes; the modes and their frequencies; the derivatives, their errors and the elasticities
/// (changes, modes); the derivatives of the mass; the reasons for missing derivatives (change,
/// mode, sentence).
type Derived<'py> = (
    Varied,
    Names,
    Bound<'py, PyArray1<f64>>,
    [Bound<'py, PyArray2<f64>>; 3],
    Bound<'py, PyArray1<f64>>,
    Vec<(usize, usize, String)>,
);

/// The derivatives with respect to named changes, or to each input value of the tower.
#[pyfunction]
#[pyo3(signature = (tower, names: "list[str] | None", options: "dict[str, object]") -> "tuple[Incomplete, ...]")]
pub fn sensitivities<'py>(
    py: Python<'py>,
    tower: &Tower,
    names: Option<Vec<String>>,
    options: SweepOptions,
) -> PyResult<Derived<'py>> {
    let input = &tower.model.input;
    let changes = match names {
        Some(names) => {
            let parse = |name: &String| Change::parse(name, &input.description);
            let changes: Result<Vec<Change>, _> = names.iter().map(parse).collect();
            changes.map_err(|error| usage(error.to_string()))?
        }
        None => Change::every(&input.description),
    };
    let results = options.over(SweepResults::default())?;
    let sweep = Sweep::new(Base::from(input), changes, &results).map_err(refused)?;
    let (solved, columns) = derived(py, &sweep)?;
    arrays(py, &solved, sweep.modes(), &columns)
}

/// The derivatives, and the index of each mode of the sweep in their list.
fn derived(py: Python<'_>, sweep: &Sweep) -> PyResult<(Sensitivities, Vec<usize>)> {
    let columns = |solved: &Sensitivities| -> Option<Vec<usize>> {
        let place = |name: &ModeName| solved.modes.iter().position(|mode| mode.name() == *name);
        sweep.modes().iter().map(place).collect()
    };
    // On the mesh with borders at all rows, a mode may have another place than in the sweep.
    let most = sweep.options().modes + MORE_MODES;
    let solved = interruptible(py, sweep.options().clone(), |solver| {
        let solve = |solver: &mut Solver| solver.sensitivities(sweep.base(), sweep.changes());
        solver.until(most, solve, |solved| columns(solved).is_some())
    })?;
    let solved = solved.map_err(|error| failed(&error))?;
    match columns(&solved) {
        Some(columns) => Ok((solved, columns)),
        None => Err(usage(
            "a mode of the tower has another name with borders of segments at all stations; increase segments",
        )),
    }
}

fn failed(error: &SensitivityError) -> PyErr {
    match error {
        SensitivityError::Tower(error) => of_tower(error),
        SensitivityError::Solve(error) => of_solve(error),
        error => usage(error.to_string()),
    }
}

fn arrays<'py>(
    py: Python<'py>,
    solved: &Sensitivities,
    modes: &[ModeName],
    columns: &[usize],
) -> PyResult<Derived<'py>> {
    let mut numbers: [Vec<f64>; 3] = Default::default();
    let mut reasons = Vec::new();
    for (row, change) in solved.changes.iter().enumerate() {
        for (column, &mode) in columns.iter().enumerate() {
            let derivative = &change.modes[mode];
            let elasticity = change.elasticity(&solved.modes, mode);
            let [hz, error] = match derivative {
                Ok(derivative) => [derivative.hz_per_unit, derivative.error_hz_per_unit],
                Err(reason) => {
                    reasons.push((row, column, reason.to_string()));
                    [f64::NAN; 2]
                }
            };
            let row = [hz, error, elasticity.unwrap_or(f64::NAN)];
            for (list, number) in numbers.iter_mut().zip(row) {
                list.push(number);
            }
        }
    }
    let shape = [solved.changes.len(), columns.len()];
    let [hz, error, elasticity] =
        numbers.map(|numbers| PyArray1::from_vec(py, numbers).reshape(shape));
    let varied = solved.changes.iter();
    let varied = varied.map(|one| {
        let (name, unit) = (one.change.name().to_owned(), one.change.unit());
        (name, unit, one.value)
    });
    let frequency = |&mode: &usize| solved.modes[mode].extrapolated_hz;
    let masses = solved.changes.iter().map(|one| one.mass_kg_per_unit);
    Ok((
        varied.collect(),
        mode_names(modes),
        PyArray1::from_vec(py, columns.iter().map(frequency).collect()),
        [hz?, error?, elasticity?],
        PyArray1::from_vec(py, masses.collect()),
        reasons,
    ))
}

//! Standard deviations of frequencies to first order in the varied input values.

use pyo3::prelude::*;
use towermodes::{Options, Solver};
use towermodes_cli::{studies, table};
use towermodes_files::{
    ResultError, Sampling, Source, SweepRows, read_sweep_study, write_first_order_json,
};
use towermodes_sweep::{Base, FirstOrder as Scatter, FirstOrderError, MarginCheck, Sweep};

use crate::answer::{Answer, Shown};
use crate::error::{of_read, of_result, unsolved, usage};
use crate::found::no_derivatives;
use crate::interrupt::reported;
use crate::sweep::{SweepOptions, refused};
use crate::tower::Tower;

/// Mean and standard deviation of frequencies from derivatives.
struct FirstOrder {
    json: Vec<u8>,
    table: String,
}

/// Frequencies to first order for the distributions of a study, with this tower as its base.
#[pyfunction]
#[pyo3(signature = (tower, text, name, options: "dict[str, object]", *, progress = None))]
pub fn first_order(
    py: Python<'_>,
    tower: &Tower,
    text: String,
    name: String,
    options: SweepOptions,
    progress: Option<Py<PyAny>>,
) -> PyResult<Answer> {
    let input = &tower.model.input;
    let study = read_sweep_study(&Source { name, text }).map_err(of_read)?;
    let SweepRows::Sampled { sampling, .. } = &study.rows else {
        return Err(usage(
            "the study has a table of values; the first order needs distributions in [sweep.vary]",
        ));
    };
    let changes = study.changes(&input.description).map_err(of_read)?;
    let results = options.over(study.results.clone())?;
    let (found, check) = reported(py, progress, Options::default(), |solver| {
        let sweep = Sweep::new(Base::from(input), changes, &results).map_err(refused)?;
        scatter(&sweep, sampling, std::mem::take(solver))
    })??;
    let document = studies::first_order::document(input, sampling, &found, check.as_ref());
    let mut json = Vec::new();
    write_first_order_json(&document, &mut json).map_err(|error| of_result(&error))?;
    let is_correlated = !sampling.correlations.is_empty();
    let table = table::first_order(&tower.model.tower, &found, check.as_ref(), is_correlated);
    Ok(Answer::of(FirstOrder { json, table }))
}

impl Shown for FirstOrder {
    fn table(&self) -> String {
        self.table.clone()
    }

    fn json(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        out.extend(&self.json);
        Ok(())
    }
}

fn scatter(
    sweep: &Sweep,
    sampling: &Sampling,
    solver: Solver,
) -> PyResult<(Scatter, Option<MarginCheck>)> {
    let check = sweep.margin_check();
    let found = sweep.first_order(sampling, check.as_ref(), solver);
    let found = found.map_err(|error| match error {
        FirstOrderError::Sensitivity(error) => no_derivatives(&error),
        error @ FirstOrderError::Means { .. } => unsolved(&error.to_string(), None),
        error => usage(error.to_string()),
    })?;
    Ok((found, check))
}

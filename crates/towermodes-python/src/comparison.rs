//! Comparison of methods on one tower.

use std::sync::Arc;
use std::time::{Duration, Instant};

use pyo3::prelude::*;
use towermodes::{Method, Options, Solver, Tower as CheckedTower};
use towermodes_analysis::study::{ColumnSpec, Comparison as Compared, compare as compared_by};
use towermodes_cli::table;
use towermodes_files::{ResultError, write_comparison_csv, write_result_json};
use towermodes_report::figures;
use towermodes_report::wording::compared_segments;

use crate::answer::{Answer, Shown};
use crate::interrupt::interruptible;
use crate::model::Model;
use crate::options::method_named;
use crate::tower::Tower;

/// A method is repeated until the total time exceeds this duration; the shortest time of a
/// repetition counts.
const TIMING: Duration = Duration::from_millis(20);

/// The comparison of several methods on one tower.
struct Comparison {
    model: Arc<Model>,
    comparison: Compared,
}

/// The shortest time of several repetitions.
fn time_of(tower: &CheckedTower, options: &Options) -> Duration {
    let mut solver = Solver::new(options.clone());
    let started = Instant::now();
    let mut fastest = Duration::MAX;
    loop {
        let start = Instant::now();
        // The same solve has succeeded before.
        let _ = solver.solve(tower);
        fastest = fastest.min(start.elapsed());
        if started.elapsed() > TIMING {
            return fastest;
        }
    }
}

/// Solves a tower by each method with each number of segments (at least one).
#[pyfunction]
pub fn compare(
    py: Python<'_>,
    tower: &Tower,
    methods: Vec<String>,
    segments: Vec<usize>,
    modes: usize,
    rotary_inertia: bool,
) -> PyResult<Answer> {
    let model = Arc::clone(&tower.model);
    let methods: Vec<Method> = match &methods[..] {
        [] => Method::ALL.to_vec(),
        names => names
            .iter()
            .map(|name| method_named(name))
            .collect::<PyResult<_>>()?,
    };
    let columns = ColumnSpec::each(&methods, &segments);
    let options = Options {
        modes,
        rotary_inertia,
        ..Options::default()
    };
    let tower = &model.tower;
    let compared = interruptible(py, options, |solver| {
        compared_by(tower, &columns, solver, |column, options| {
            column.seconds_per_solve = Some(time_of(tower, options).as_secs_f64());
        })
    })?;
    let comparison = compared.map_err(|error| model.unsolved(&error))?;
    Ok(Answer::of(Comparison { model, comparison }))
}

impl Shown for Comparison {
    fn table(&self) -> String {
        table::comparison(&self.model.tower, &self.comparison)
    }

    fn json(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        write_result_json(&self.comparison, out)
    }

    fn csv(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        write_comparison_csv(&self.comparison, out)
    }

    fn svg(&self) -> String {
        let computed = compared_segments(&self.comparison);
        self.model
            .titled(figures::error(&self.comparison), Some(&computed), &[])
    }

    fn notes(&self) -> Vec<String> {
        self.model.notes()
    }

    /// Warnings of the reference solution, and warnings on methods with missing modes.
    fn warnings(&self) -> Vec<String> {
        self.model.located(&self.comparison.warnings)
    }
}

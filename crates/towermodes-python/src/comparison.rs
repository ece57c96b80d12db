//! Methods compared on one tower.

use std::sync::Arc;
use std::time::{Duration, Instant};

use pyo3::prelude::*;
use towermodes::{Method, Options, Solver, Tower as CheckedTower};
use towermodes_analysis::study::{ColumnSpec, Comparison as Compared, compare};
use towermodes_cli::table;
use towermodes_files::{write_comparison_csv, write_result_json};
use towermodes_report::figures::{self, TitleWords, titled};
use towermodes_report::svg::Look;
use towermodes_report::wording::compared_segments;

use crate::error::of_result;
use crate::interrupt::interruptible;
use crate::options::method_named;
use crate::tower::{Model, Tower};

/// The shortest of several solves is taken as the time of one, as long as they take less than this.
const TIMING: Duration = Duration::from_millis(20);

/// Several methods compared on one tower.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct Comparison {
    model: Arc<Model>,
    comparison: Compared,
}

/// A column for each method and number of segments; the spectral method chooses its own.
fn columns(methods: &[Method], segments: &[usize]) -> Vec<ColumnSpec> {
    let of_method = |&method: &Method| {
        let is_spectral = method == Method::Spectral;
        let segments = if is_spectral {
            &segments[..1]
        } else {
            segments
        };
        segments.iter().map(move |&segments| ColumnSpec {
            method,
            segments: (!is_spectral).then_some(segments),
        })
    };
    methods.iter().flat_map(of_method).collect()
}

/// The time of the fastest of several solves.
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

#[pymethods]
impl Comparison {
    /// Solves a tower by each method with each number of segments (at least one).
    #[new]
    fn new(
        py: Python<'_>,
        tower: &Tower,
        methods: Vec<String>,
        segments: Vec<usize>,
        modes: usize,
        rotary_inertia: bool,
    ) -> PyResult<Self> {
        let model = Arc::clone(&tower.model);
        let methods: Vec<Method> = match &methods[..] {
            [] => Method::ALL.to_vec(),
            names => names
                .iter()
                .map(|name| method_named(name))
                .collect::<PyResult<_>>()?,
        };
        let columns = columns(&methods, &segments);
        let options = Options {
            modes,
            rotary_inertia,
            ..Options::default()
        };
        let tower = &model.tower;
        let compared = interruptible(py, options, |solver| {
            compare(tower, &columns, solver, |column, options| {
                column.seconds_per_solve = Some(time_of(tower, options).as_secs_f64());
            })
        })?;
        let comparison = compared.map_err(|error| model.unsolved(&error))?;
        Ok(Self { model, comparison })
    }

    /// The warnings of the reference solution, and of methods that lack modes.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.model.located(&self.comparison.warnings)
    }

    /// The table of the program.
    fn table(&self) -> String {
        table::comparison(&self.model.tower, &self.comparison)
    }

    /// The JSON of the program.
    fn json(&self) -> PyResult<String> {
        let mut json = Vec::new();
        let done = write_result_json(&self.comparison, &mut json);
        done.map_err(|error| of_result(&error))?;
        Ok(String::from_utf8_lossy(&json).into_owned())
    }

    /// The CSV of the program.
    fn csv(&self) -> PyResult<String> {
        let mut csv = Vec::new();
        let done = write_comparison_csv(&self.comparison, &mut csv);
        done.map_err(|error| of_result(&error))?;
        Ok(String::from_utf8_lossy(&csv).into_owned())
    }

    /// The errors of the methods as SVG.
    fn svg(&self) -> String {
        let computed = compared_segments(&self.comparison);
        let words = TitleWords {
            title: None,
            computed: Some(&computed),
            conclusion: &[],
        };
        let figure = figures::error(&self.comparison);
        titled(figure, &self.model.tower, &words).to_svg(Look::Standalone)
    }
}

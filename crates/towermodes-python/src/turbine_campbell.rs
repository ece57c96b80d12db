//! The coupled Campbell diagram of a turbine.

use std::sync::Arc;

use numpy::{PyArray1, PyArray2, PyArray3};
use pyo3::prelude::*;
use towermodes::{Options, SolveError};
use towermodes_analysis::resonance::{reach_hz, solve_to_reach};
use towermodes_analysis::whirl::{
    AgainstRigid, CoupledCampbell, CoupledOptions, CurvePoint, RotorSpeeds, coupled_campbell,
    coupled_limit_hz,
};
use towermodes_cli::table;
use towermodes_files::{TowerInput, write_coupled_campbell_csv, write_coupled_campbell_json};
use towermodes_report::figures::{self, TitleWords, titled};
use towermodes_report::svg::Look;

use crate::array;
use crate::campbell::RotorOptions;
use crate::error::{of_coupled, of_result};
use crate::interrupt::{interruptible, looking};
use crate::tower::{Model, Tower};
use crate::turbine::{PARTS, energy_parts, fractions, notes, turbine_of};

/// A coupled Campbell diagram.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct TurbineCampbell {
    model: Arc<Model>,
    diagram: CoupledCampbell,
    against: Vec<AgainstRigid>,
    remarks: Vec<String>,
}

/// The rotor; its operating speeds are the ends of the given ones if nothing else gives them.
fn rotor_of(
    mut options: RotorOptions,
    input: &TowerInput,
    blades: usize,
    rpm: &[f64],
) -> RotorOptions {
    options.blades.get_or_insert(blades);
    let turning = rpm.iter().copied().filter(|rpm| *rpm > 0.0);
    let lowest = turning.clone().fold(f64::INFINITY, f64::min);
    let highest = turning.fold(0.0, f64::max);
    if options.rpm.is_none() && input.description.rotor.is_none() && highest > 0.0 {
        options.rpm = Some((lowest, highest));
    }
    options
}

#[pymethods]
impl TurbineCampbell {
    /// The diagram of the turbine on a tower; no speeds are the usual ones.
    #[new]
    #[pyo3(signature = (tower, rpm, limit_hz, rotor: "dict[str, object]"))]
    fn new(
        py: Python<'_>,
        tower: &Tower,
        rpm: Vec<f64>,
        limit_hz: Option<f64>,
        rotor: RotorOptions,
    ) -> PyResult<Self> {
        let model = Arc::clone(&tower.model);
        let turbine = turbine_of(&model)?;
        let blades = turbine.machine().blades;
        let given = rotor_of(rotor, &model.input, blades, &rpm);
        let limits = given.of_library();
        let solved = interruptible(py, Options::default(), |solver| {
            let chosen = given.rotor(&model.input, || solver.solve_certain(&model.tower))?;
            let reach_hz = reach_hz(&chosen.rotor, &limits);
            let rigid = solve_to_reach(solver, &model.tower, reach_hz)?;
            Ok::<_, SolveError>((rigid, chosen))
        })?;
        let (rigid, chosen) = solved.map_err(|error| model.unsolved(&error))?;
        let rotor = chosen.rotor;
        let usual_hz = coupled_limit_hz(&rotor, &limits, &rigid, &turbine);
        let speeds = match rpm.is_empty() {
            true => RotorSpeeds::Equal(limits.speeds),
            false => RotorSpeeds::Given(rpm),
        };
        let options = CoupledOptions {
            margin: limits.margin,
            multiples: limits.multiples,
            speeds,
            speeds_are_known: chosen.speeds_are_known,
            ..CoupledOptions::up_to(limit_hz.unwrap_or(usual_hz))
        };
        let diagram = looking(py, |mut look| {
            coupled_campbell(&turbine, &rotor, &options, |_| look())
        })?;
        let diagram = diagram.map_err(|error| of_coupled(&error))?;
        let remarks = diagram.remarks(&turbine);
        Ok(Self {
            against: diagram.against(&rigid),
            remarks: remarks.iter().map(ToString::to_string).collect(),
            model,
            diagram,
        })
    }

    /// The worst verdict: `pass`, `warn`, `fail`, or `undecided` where nothing is checked.
    #[getter]
    fn verdict(&self) -> &'static str {
        self.diagram.verdict().name()
    }

    /// Why nothing is checked; empty if it is.
    #[getter]
    fn not_checked(&self) -> Vec<String> {
        let reasons = self.diagram.campbell.not_checked.iter();
        reasons.map(ToString::to_string).collect()
    }

    /// The conclusion in sentences.
    #[getter]
    fn conclusion(&self) -> Vec<String> {
        self.diagram.campbell.conclusion()
    }

    /// Whether all lists are complete and the turbine is stable.
    #[getter]
    fn certified(&self) -> bool {
        self.diagram.is_certified()
    }

    /// The same for each speed.
    #[getter]
    fn certified_at(&self) -> Vec<bool> {
        let speeds = self.diagram.speeds.iter();
        speeds.map(|speed| speed.modes.is_complete).collect()
    }

    /// Up to which frequency, Hz.
    #[getter]
    fn limit_hz(&self) -> f64 {
        self.diagram.limit_hz
    }

    /// The rotor speeds, rpm.
    #[getter]
    fn rpm<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let speeds = self.diagram.speeds.iter();
        array::vector(py, speeds.map(|speed| speed.rotor_speed_rpm))
    }

    /// The titles of the curves.
    #[getter]
    fn names(&self) -> Vec<String> {
        let curves = self.diagram.curves.iter();
        curves.map(|curve| curve.title.clone()).collect()
    }

    /// The names of the modes of each curve at each speed; none where it has none.
    #[getter]
    fn names_at(&self) -> Vec<Vec<Option<String>>> {
        let points = self.points();
        let name = |point: &Option<&CurvePoint>| point.map(|point| point.name.to_string());
        let of_curve = |points: &[Option<&CurvePoint>]| points.iter().map(name).collect();
        points
            .chunks(self.shape()[1].max(1))
            .map(of_curve)
            .collect()
    }

    /// The fractions of the elastic energy in the parts that name the modes.
    #[getter]
    fn share<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.of_each(py, |point| point.share)
    }

    /// The index of the other curve of each whirl pair.
    #[getter]
    fn partners(&self) -> Vec<Option<usize>> {
        let curves = self.diagram.curves.iter();
        curves.map(|curve| curve.partner).collect()
    }

    /// Frequencies, Hz: (curves, speeds).
    #[getter]
    fn frequency_hz<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.of_each(py, |point| point.frequency.frequency_hz)
    }

    /// Their lower bounds, Hz.
    #[getter]
    fn lower_hz<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.of_each(py, |point| point.frequency.lower_hz)
    }

    /// Their upper bounds, Hz.
    #[getter]
    fn upper_hz<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.of_each(py, |point| point.frequency.upper_hz)
    }

    /// Errors of the mesh, Hz, where they are known.
    #[getter]
    fn error_hz<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.of_each(py, |point| point.error_hz.unwrap_or(f64::NAN))
    }

    /// The names of the parts of `energy`.
    #[getter]
    fn energy_parts(&self) -> Vec<String> {
        energy_parts()
    }

    /// Fractions of the elastic energy: (curves, speeds, parts).
    #[getter]
    fn energy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let points = self.points().into_iter();
        let shares =
            points.map(|point| point.map_or([f64::NAN; PARTS], |of| fractions(&of.energy)));
        array::sheets(py, shares, self.shape())
    }

    /// The notes of the reader.
    #[getter]
    fn notes(&self) -> Vec<String> {
        notes(&self.model)
    }

    /// Limits of the diagram.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.remarks.clone()
    }

    /// The table of the program.
    fn table(&self) -> String {
        table::coupled_campbell(&self.model.tower, &self.diagram, &self.against, false)
    }

    /// The JSON of the program.
    fn json(&self) -> PyResult<String> {
        let mut json = Vec::new();
        let warnings = [self.notes(), self.warnings()].concat();
        let (tower, against) = (&self.model.tower, &self.against);
        let done = write_coupled_campbell_json(tower, &self.diagram, against, &warnings, &mut json);
        done.map_err(|error| of_result(&error))?;
        Ok(String::from_utf8_lossy(&json).into_owned())
    }

    /// The CSV of the program.
    fn csv(&self) -> PyResult<String> {
        let mut csv = Vec::new();
        let done = write_coupled_campbell_csv(&self.diagram, &mut csv);
        done.map_err(|error| of_result(&error))?;
        Ok(String::from_utf8_lossy(&csv).into_owned())
    }

    /// The diagram as SVG.
    fn svg(&self) -> String {
        let computed = format!(
            "coupled modes at {} rotor speeds",
            self.diagram.speeds.len()
        );
        let conclusion = self.diagram.campbell.conclusion();
        let words = TitleWords {
            title: None,
            computed: Some(&computed),
            conclusion: &conclusion,
        };
        let figure = figures::coupled_campbell(&self.diagram);
        titled(figure, &self.model.tower, &words).to_svg(Look::Standalone)
    }
}

impl TurbineCampbell {
    /// Number of curves and of speeds.
    fn shape(&self) -> [usize; 2] {
        [self.diagram.curves.len(), self.diagram.speeds.len()]
    }

    /// The points of each curve at all speeds; none where it has none.
    fn points(&self) -> Vec<Option<&CurvePoint>> {
        let speeds = &self.diagram.speeds;
        let curves = self.diagram.curves.iter();
        let of = curves.flat_map(|curve| {
            let mut points = curve.points.iter().peekable();
            speeds.iter().map(move |speed| {
                points.next_if(|point| point.rotor_speed_rpm == speed.rotor_speed_rpm)
            })
        });
        of.collect()
    }

    /// A number of each point: (curves, speeds).
    fn of_each<'py>(
        &self,
        py: Python<'py>,
        number: impl Fn(&CurvePoint) -> f64,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let points = self.points().into_iter();
        let numbers = points.map(|point| point.map_or(f64::NAN, &number));
        array::matrix(py, numbers.collect(), self.shape())
    }
}

//! A validated tower that cannot be changed.

use std::sync::Arc;

use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use towermodes::{Change, DEFAULT_SEGMENTS, Operation, Parameter, Solver, Tower as CheckedTower};
use towermodes_files::{Setting, TowerInput, write_result_json};
use towermodes_report::figures::{self};
use towermodes_report::svg::Look;

use crate::answer::text;
use crate::array;
use crate::error::{of_numbers, of_read, usage};
use crate::interrupt::interruptible;
use crate::lock::released;
use crate::model::Model;
use crate::options::SolveOptions;
use crate::pickle::{restored, state};
use crate::solution::Solution;

/// Computations with a smaller product of the number of segments and modes take less than a tenth
/// of a second, so they need no interruption; the checks for signals would take some microseconds.
const SOON: usize = 20_000;

/// Operation, input values and unit of a change.
type ChangeParts = (&'static str, Vec<(String, f64)>, &'static str);

/// A tower.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct Tower {
    /// Its model, shared with its solutions.
    pub model: Arc<Model>,
}

impl Tower {
    /// The tower of an input.
    ///
    /// # Errors
    /// `TowerError` with the place of an invalid value.
    pub fn of_input(input: TowerInput) -> PyResult<Self> {
        let tower = input.tower().map_err(of_read)?;
        let model = Arc::new(Model { tower, input });
        Ok(Self { model })
    }

    /// A copy with changed input values; mistakes in these have no place in a file.
    ///
    /// # Errors
    /// `TowerError`.
    pub fn of_changed(input: TowerInput) -> PyResult<Self> {
        let tower = CheckedTower::new(input.description.clone());
        let tower = tower.map_err(|error| of_numbers(&error, &input))?;
        let model = Arc::new(Model { tower, input });
        Ok(Self { model })
    }
}

#[pymethods]
impl Tower {
    /// Its name; may be empty.
    #[getter]
    fn name(&self) -> &str {
        self.model.tower.name()
    }

    /// Height from the base to the top, m.
    #[getter]
    fn height_m(&self) -> f64 {
        self.model.tower.height_m()
    }

    /// The height of the base, m.
    #[getter]
    fn base_m(&self) -> f64 {
        self.model.tower.base_m()
    }

    /// The height of the top, m.
    #[getter]
    fn top_m(&self) -> f64 {
        self.model.tower.top_m()
    }

    /// Mass without the rotor-nacelle assembly, kg.
    #[getter]
    fn mass_kg(&self) -> f64 {
        self.model.tower.mass_kg()
    }

    /// Mass of the tower and of the members of a substructure, kg.
    #[getter]
    fn structure_mass_kg(&self) -> f64 {
        self.model.tower.structure_mass_kg()
    }

    /// Mass of the rotor-nacelle assembly, kg.
    #[getter]
    fn rna_mass_kg(&self) -> f64 {
        self.model.tower.rna().mass_kg
    }

    /// Acceleration of gravity, m/s².
    #[getter]
    fn gravity_m_per_s2(&self) -> f64 {
        self.model.tower.gravity_m_per_s2()
    }

    /// Weight, buoyancy and mooring forces of a floating tower as JSON.
    fn static_balance(&self) -> PyResult<String> {
        text(|out| write_result_json(&self.model.tower.static_balance(), out))
    }

    /// Number of blades of its turbine; none without a turbine.
    #[getter]
    fn turbine_blades(&self) -> Option<usize> {
        let turbine = self.model.input.turbine.as_ref();
        turbine.map(|turbine| turbine.blades)
    }

    /// Why it has no turbine.
    #[getter]
    fn turbine_missing(&self) -> String {
        self.model.missing_turbine()
    }

    /// The notes on the tower and on its turbine.
    #[getter]
    fn turbine_notes(&self) -> Vec<String> {
        self.model.notes_with_turbine()
    }

    /// The format of its file.
    #[getter]
    fn format(&self) -> &'static str {
        self.model.input.format.name()
    }

    /// The files it was read from.
    #[getter]
    fn files(&self) -> Vec<String> {
        let files = self.model.input.files();
        let files = files.filter(|name| !name.starts_with('<'));
        files.map(str::to_owned).collect()
    }

    /// Height, outer diameter and wall thickness of the stations, m.
    #[getter]
    fn stations<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let stations = self.model.input.description.stations.iter();
        let row = |s: &towermodes::Station| [s.height_m, s.outer_diameter_m, s.wall_thickness_m];
        array::rows(py, stations.map(row))
    }

    /// Names and positions of the joints of the substructure, m.
    #[getter]
    fn joints(&self) -> Vec<(String, [f64; 3])> {
        let frame = self.model.tower.frame();
        let joints = frame
            .iter()
            .flat_map(|frame| &frame.frame.description().joints);
        let joint = joints.map(|joint| (joint.name.clone(), joint.position_m));
        joint.collect()
    }

    /// Names of the members of the substructure, and of their first and second joint.
    #[getter]
    fn members(&self) -> Vec<(String, [String; 2])> {
        let Some(frame) = self.model.tower.frame() else {
            return Vec::new();
        };
        let description = frame.frame.description();
        let name = |joint: usize| description.joints[joint].name.clone();
        let members = description.members.iter();
        let member = members.map(|member| (member.name.clone(), member.joints.map(name)));
        member.collect()
    }

    /// The mass of the substructure by kind, kg; nothing without a substructure.
    #[getter]
    fn substructure_masses_kg(&self) -> Vec<(&'static str, f64)> {
        let Some(frame) = self.model.tower.frame() else {
            return Vec::new();
        };
        let masses = frame.frame.masses();
        vec![
            ("members", masses.members_kg),
            ("growth", masses.growth_kg),
            ("filling", masses.filling_kg),
            ("joints", masses.joints_kg),
            ("soil", masses.soil_kg),
            ("transition_piece", frame.platform.mass_kg),
            ("added", masses.added_kg),
        ]
    }

    /// The notes of the reader.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.model.notes()
    }

    /// Input that is possible but probably a mistake.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.model.located(self.model.tower.warnings())
    }

    /// Name, value, unit and meaning of each input value.
    fn parameters(&self) -> Vec<(String, f64, &'static str, &'static str)> {
        let description = &self.model.input.description;
        let row = |parameter: Parameter| {
            let value = parameter.value(description);
            let (unit, meaning) = (parameter.unit(), parameter.meaning());
            (parameter.to_string(), value, unit, meaning)
        };
        Parameter::all(description).into_iter().map(row).collect()
    }

    /// The operation of a change (`set`, `scale` or `add`), its input values, and its unit.
    fn change(&self, name: &str) -> PyResult<ChangeParts> {
        let description = &self.model.input.description;
        let change = Change::parse(name, description);
        let change = change.map_err(|error| usage(error.to_string()))?;
        let operation = match change.operation() {
            Operation::Set => "set",
            Operation::Scale => "scale",
            Operation::Add => "add",
        };
        let number = |parameter: &Parameter| (parameter.to_string(), parameter.value(description));
        let numbers = change.parameters().iter().map(number).collect();
        Ok((operation, numbers, change.unit()))
    }

    /// The tower with changed input values: names of changes and their values.
    fn changed(&self, changes: Vec<(String, f64)>) -> PyResult<Self> {
        let mut input = self.model.input.clone();
        let setting = |(name, value)| Setting::new(name, value);
        let settings: Vec<Setting> = changes.into_iter().map(setting).collect();
        let done = input.set(&settings, "with_");
        done.map_err(|error| usage(error.to_string()))?;
        Self::of_changed(input)
    }

    /// The lowest modes.
    #[pyo3(signature = (options: "dict[str, object]"))]
    fn solve(&self, py: Python<'_>, options: SolveOptions) -> PyResult<Solution> {
        let options = options.of(&self.model.input)?;
        let tower = &self.model.tower;
        let segments = options.segments.unwrap_or(DEFAULT_SEGMENTS);
        let is_short = segments.saturating_mul(options.modes) < SOON;
        let solution = match is_short {
            true => released(py, || Solver::new(options).solve_certain(tower)),
            false => interruptible(py, options, |solver| solver.solve_certain(tower))?,
        };
        let solution = solution.map_err(|error| self.model.unsolved(&error))?;
        Ok(Solution {
            model: Arc::clone(&self.model),
            solution,
        })
    }

    /// The picture of the tower as SVG.
    fn svg(&self) -> String {
        let Model { tower, input } = &*self.model;
        figures::tower(&input.description, tower).to_svg(Look::Standalone)
    }

    /// Whether both towers have the same description and the same options of the solution.
    fn is_equal(&self, other: &Self) -> bool {
        let (own, other) = (&self.model.input, &other.model.input);
        own.description == other.description
            && own.blade == other.blade
            && own.turbine == other.turbine
            && own.prescribed == other.prescribed
    }

    /// The data that [`restore`](Self::restore) needs.
    #[pyo3(signature = () -> "tuple[object, ...]")]
    fn state<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        state(py, &self.model.input)
    }

    /// The tower with this state.
    #[staticmethod]
    #[pyo3(signature = (state: "tuple[object, ...]"))]
    fn restore(state: &Bound<'_, PyTuple>) -> PyResult<Self> {
        Self::of_changed(restored(state)?)
    }
}

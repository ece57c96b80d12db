//! The modes of a tower.

use std::sync::Arc;

use numpy::{PyArray1, PyArray2, PyArray3};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use towermodes::modes::ShapePoint;
use towermodes::{Mode, Solution as Solved};
use towermodes_cli::table;
use towermodes_files::{Cell, Column, MODE_COLUMNS, write_csv, write_json};
use towermodes_report::figures;
use towermodes_report::wording::computed_by;

use crate::answer::text;
use crate::array;
use crate::model::Model;

/// The lowest modes of a tower.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct Solution {
    /// The tower.
    pub model: Arc<Model>,
    /// Its modes.
    pub solution: Solved,
}

impl Solution {
    fn modes(&self) -> impl ExactSizeIterator<Item = &Mode> {
        self.solution.modes.iter()
    }

    /// A quantity of each mode.
    fn of_each<'py>(
        &self,
        py: Python<'py>,
        number: impl Fn(&Mode) -> f64,
    ) -> Bound<'py, PyArray1<f64>> {
        array::vector(py, self.modes().map(number))
    }

    /// A column: numbers as an array, texts as a list.
    fn values<'py>(&self, py: Python<'py>, column: &Column<Mode>) -> PyResult<Bound<'py, PyAny>> {
        let cells = self.modes().map(column.value);
        let (mut texts, mut numbers) = (Vec::new(), Vec::new());
        for cell in cells {
            match cell {
                Cell::Text(text) => texts.push(text),
                Cell::Count(count) => numbers.push(count as f64),
                Cell::Number(number) | Cell::Small(number) => numbers.push(number),
            }
        }
        match texts.is_empty() {
            true => Ok(array::vector(py, numbers).into_any()),
            false => Ok(PyList::new(py, texts)?.into_any()),
        }
    }

    /// One of the three shapes of each mode: (modes, heights, 6).
    fn shapes<'py>(
        &self,
        py: Python<'py>,
        shape: impl Fn(&Mode) -> &[ShapePoint],
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let heights = self
            .solution
            .modes
            .first()
            .map_or(0, |mode| shape(mode).len());
        let points = self.modes().flat_map(|mode| shape(mode).iter());
        array::sheets(py, points.map(motion), [self.solution.modes.len(), heights])
    }

    /// The heights of one of the three shapes.
    fn heights<'py>(
        &self,
        py: Python<'py>,
        shape: impl Fn(&Mode) -> &[ShapePoint],
    ) -> Bound<'py, PyArray1<f64>> {
        let points = self.solution.modes.first().map_or(&[][..], shape);
        array::vector(py, points.iter().map(|point| point.height_m))
    }
}

/// Translation and rotation.
fn motion(point: &ShapePoint) -> [f64; 6] {
    let ([x, y, z], [rx, ry, rz]) = (point.translation, point.rotation);
    [x, y, z, rx, ry, rz]
}

#[pymethods]
impl Solution {
    /// The values of a column of the CSV, one for each mode: numbers as an array, texts as a list.
    #[pyo3(signature = (key) -> "Incomplete")]
    fn column<'py>(&self, py: Python<'py>, key: &str) -> PyResult<Bound<'py, PyAny>> {
        let column = MODE_COLUMNS.iter().find(|column| column.key == key);
        let column = column.ok_or_else(|| PyKeyError::new_err(key.to_owned()))?;
        self.values(py, column)
    }

    /// All columns by their keys.
    #[getter]
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let columns = PyDict::new(py);
        for column in MODE_COLUMNS {
            columns.set_item(column.key, self.values(py, column)?)?;
        }
        Ok(columns.into_any())
    }

    /// Total errors, Hz.
    #[getter]
    fn error_hz<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.of_each(py, Mode::error_hz)
    }

    /// Modal masses, kg; kg m² for torsion and yaw.
    #[getter]
    fn modal_mass<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.of_each(py, |mode| mode.modal_mass)
    }

    /// Effective modal masses: shape (modes, 6).
    #[getter]
    fn effective_mass<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        array::rows(py, self.modes().map(|mode| mode.effective_mass))
    }

    /// Sums of the effective masses as fractions of the totals: shape (6). None if there is no such
    /// sum.
    #[getter]
    fn effective_mass_shares<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        let shares = self.solution.effective_mass_shares()?;
        Some(array::vector(py, shares))
    }

    /// Rigid-body inertia matrix of the whole tower about its base: shape (6, 6).
    #[getter]
    fn rigid_inertia<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        array::rows(py, self.solution.rigid_inertia.into_iter())
    }

    /// The shapes at equal heights: (modes, heights, 6).
    #[getter]
    fn shape<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        self.shapes(py, |mode| &mode.shape)
    }

    /// The heights of `shape`, m.
    #[getter]
    fn height_m<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.heights(py, |mode| &mode.shape)
    }

    /// The shapes at the stations: (modes, stations, 6).
    #[getter]
    fn station_shape<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        self.shapes(py, |mode| &mode.station_shape)
    }

    /// The heights of `station_shape`, m.
    #[getter]
    fn station_height_m<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.heights(py, |mode| &mode.station_shape)
    }

    /// The shapes at the requested heights: (modes, heights, 6).
    #[getter]
    fn shape_there<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        self.shapes(py, |mode| &mode.shape_there)
    }

    /// The motions of the joints of the substructure: (modes, joints, 6).
    #[getter]
    fn joint_shape<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let shapes = || self.modes().filter_map(|mode| mode.frame.as_ref());
        let joints = shapes().next().map_or(0, |shape| shape.joints.len());
        let motions = shapes().flat_map(|shape| shape.joints.iter().copied());
        array::sheets(py, motions, [self.solution.modes.len(), joints])
    }

    /// The translations of points within the members of the substructure: (modes, 3 members, 3).
    #[getter]
    fn member_shape<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let shapes = || self.modes().filter_map(|mode| mode.frame.as_ref());
        let members = shapes().next().map_or(0, |shape| shape.members.len());
        let points = shapes().flat_map(|shape| shape.members.iter().flatten().copied());
        array::sheets(py, points, [self.solution.modes.len(), 3 * members])
    }

    /// Family and order of each mode.
    #[getter]
    fn names(&self) -> Vec<(&'static str, usize)> {
        let name = |mode: &Mode| (mode.family.name(), mode.order);
        self.modes().map(name).collect()
    }

    /// For each mode, the other family with the largest share of its energy, and this share.
    #[getter]
    fn second(&self) -> Vec<Option<(&'static str, f64)>> {
        let second = |mode: &Mode| mode.second().map(|it| (it.family.name(), it.share));
        self.modes().map(second).collect()
    }

    /// The names of the modes in words.
    #[getter]
    fn labels(&self) -> Vec<String> {
        self.modes().map(Mode::label).collect()
    }

    /// The method.
    #[getter]
    fn method(&self) -> &'static str {
        self.solution.method.name()
    }

    /// Number of segments or elements.
    #[getter]
    fn segments(&self) -> usize {
        self.solution.segments
    }

    /// Polynomial degree of spectral elements.
    #[getter]
    fn degree(&self) -> Option<usize> {
        self.solution.degree
    }

    /// Degrees of freedom of the whole tower.
    #[getter]
    fn degrees_of_freedom(&self) -> usize {
        self.solution.degrees_of_freedom
    }

    /// Whether no mode is missing, the number of counted modes, and the frequency up to which they
    /// are counted, Hz.
    #[getter]
    fn certificate(&self) -> (bool, usize, f64) {
        let certificate = &self.solution.certificate;
        (
            certificate.complete,
            certificate.count,
            certificate.below_hz,
        )
    }

    /// The interval in which modes may be missing, Hz.
    #[getter]
    fn uncertain_hz(&self) -> Option<(f64, f64)> {
        let ends = self.solution.certificate.uncertain_hz;
        ends.map(|[from_hz, to_hz]| (from_hz, to_hz))
    }

    /// The factor on the acceleration of gravity at which the tower buckles.
    #[getter]
    fn buckling_load_factor(&self) -> Option<f64> {
        self.solution.buckling_load_factor
    }

    /// The notes of the reader.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.model.notes()
    }

    /// Possible mistakes of the input, and limits of the results.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.model.located(&self.solution.warnings)
    }

    /// The table of the program.
    fn table(&self) -> String {
        table::solution(&self.model.tower, &self.solution)
    }

    /// The header and the cells of the table, and the lines below it.
    fn cells(&self) -> (Vec<&'static str>, Vec<Vec<String>>, String) {
        let rows = table::mode_rows(&self.solution).into_iter();
        let rows = rows.map(|row| row.map(|cell| cell.trim_end().to_owned()).to_vec());
        let below = table::below_modes(&self.model.tower, &self.solution);
        (table::MODE_HEADER.to_vec(), rows.collect(), below)
    }

    /// The JSON of the program.
    fn json(&self) -> PyResult<String> {
        let (tower, notes) = (&self.model.tower, &self.model.input.notes);
        text(|out| write_json(tower, &self.solution, notes, out))
    }

    /// The CSV of the program.
    fn csv(&self) -> PyResult<String> {
        text(|out| write_csv(&self.solution, out))
    }

    /// The picture of the mode shapes as SVG.
    fn svg(&self) -> String {
        let Model { tower, input } = &*self.model;
        let computed = computed_by(&self.solution);
        let figure = figures::shapes(&input.description, tower, &self.solution);
        self.model.titled(figure, Some(&computed), &[])
    }
}

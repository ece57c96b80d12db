//! The modes of a whole turbine at a rotor speed.

use std::sync::Arc;

use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use towermodes::turbine::{
    BladeMotion, Turbine, TurbineEnergy, TurbineMode, TurbineModes as Modes,
};

use crate::array;
use crate::error::{of_read, of_turbine, usage};
use crate::lock::released;
use crate::model::Model;
use crate::tower::Tower;

/// Number of parts with energies.
const PARTS: usize = 25;

/// The modes of a turbine at a rotor speed.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct TurbineModes {
    model: Arc<Model>,
    modes: Modes,
}

/// The turbine of a tower.
///
/// # Errors
/// `ValueError` if there is none.
pub fn turbine_of(model: &Model) -> PyResult<Turbine> {
    let turbine = model.input.whole_turbine().map_err(of_read)?;
    turbine.ok_or_else(|| usage(model.missing_turbine()))
}

/// Fractions of the elastic energy by the names of their parts.
fn energy_parts() -> Vec<String> {
    let stationary = [
        "platform_surge",
        "platform_sway",
        "platform_heave",
        "platform_roll",
        "platform_pitch",
        "platform_yaw",
        "substructure",
        "tower_fore_aft",
        "tower_side_side",
        "tower_torsion",
        "tower_axial",
        "yaw_drive",
        "shaft",
    ];
    let blades = BladeMotion::ALL.into_iter().flat_map(|motion| {
        let motion = motion.name().replace(' ', "_");
        ["collective", "forward", "backward"].map(|harmonic| format!("{motion}_{harmonic}"))
    });
    stationary
        .map(str::to_owned)
        .into_iter()
        .chain(blades)
        .collect()
}

/// These fractions, in the order of [`energy_parts`].
fn fractions(energy: &TurbineEnergy) -> [f64; PARTS] {
    let stationary = [
        energy.substructure,
        energy.tower_fore_aft,
        energy.tower_side_side,
        energy.tower_torsion,
        energy.tower_axial,
        energy.yaw_drive,
        energy.shaft,
    ];
    let blades = energy.blades.iter();
    let blades = blades.flat_map(|own| [own.collective, own.forward, own.backward]);
    let platform = energy.platform.into_iter();
    let mut all = platform.chain(stationary).chain(blades);
    std::array::from_fn(|_| all.next().unwrap_or_default())
}

#[pymethods]
impl TurbineModes {
    /// The modes of the turbine of a tower below a limit (Hz) at a rotor speed (rpm).
    #[new]
    fn new(py: Python<'_>, tower: &Tower, rpm: f64, limit_hz: f64) -> PyResult<Self> {
        let model = Arc::clone(&tower.model);
        let turbine = turbine_of(&model)?;
        let modes = released(py, || turbine.modes(limit_hz, rpm));
        let modes = modes.map_err(|error| of_turbine(&error))?;
        Ok(Self { model, modes })
    }

    /// The rotor speed, rpm.
    #[getter]
    fn rotor_speed_rpm(&self) -> f64 {
        self.modes.rotor_speed_rpm
    }

    /// The limit, Hz.
    #[getter]
    fn limit_hz(&self) -> f64 {
        self.modes.limit_hz
    }

    /// Whether the list is complete and the turbine stable.
    #[getter]
    fn certified(&self) -> bool {
        self.modes.is_complete
    }

    /// Numbers of modes of negative energy: expected and found.
    #[getter]
    fn negative_energy(&self) -> (usize, usize) {
        let modes = &self.modes;
        (modes.negative_energy_expected, modes.negative_energy_found)
    }

    /// Least number of unstable modes; 0 if it is unknown.
    #[getter]
    fn growing(&self) -> usize {
        self.modes.growing
    }

    /// Number of motions without stiffness, which are not in the list.
    #[getter]
    fn unresisted(&self) -> usize {
        self.modes.unresisted
    }

    /// Natural frequencies, Hz.
    #[getter]
    fn frequency_hz<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.of_each(py, |mode| mode.frequency.frequency_hz)
    }

    /// Lower and upper bounds, Hz: (modes, 2).
    #[getter]
    fn bounds_hz<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let bounds = self.modes.modes.iter().map(|mode| &mode.frequency);
        array::rows(py, bounds.map(|of| [of.lower_hz, of.upper_hz]))
    }

    /// Estimated discretization errors, Hz; NaN if there is no estimate.
    #[getter]
    fn error_hz<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.of_each(py, |mode| mode.discretization_error_hz.unwrap_or(f64::NAN))
    }

    /// Their names.
    #[getter]
    fn names(&self) -> Vec<String> {
        let modes = self.modes.modes.iter();
        modes.map(|mode| mode.name.to_string()).collect()
    }

    /// Fractions of the elastic energy of the modes in the parts that name them.
    #[getter]
    fn share<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.of_each(py, |mode| mode.share)
    }

    /// For each mode, the other part with the most elastic energy, and its fraction.
    #[getter]
    fn second(&self) -> Vec<Option<(String, f64)>> {
        let modes = self.modes.modes.iter();
        let second = modes.map(|mode| mode.second);
        second
            .map(|second| second.map(|(part, share)| (part.to_string(), share)))
            .collect()
    }

    /// `tilt` or `yaw` for whirls whose backward and forward waves are almost equal.
    #[getter]
    fn nodding(&self) -> Vec<Option<String>> {
        let modes = self.modes.modes.iter();
        let nodding = modes.map(TurbineMode::nodding);
        nodding.map(|of| of.map(|of| of.to_string())).collect()
    }

    /// The names of the parts of `energy`.
    #[getter]
    fn energy_parts(&self) -> Vec<String> {
        energy_parts()
    }

    /// Fractions of the elastic energy: (modes, parts).
    #[getter]
    fn energy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let modes = self.modes.modes.iter();
        array::rows(py, modes.map(|mode| fractions(&mode.energy)))
    }

    /// Notes on the turbine.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.model.notes_with_turbine()
    }
}

impl TurbineModes {
    /// A quantity of each mode.
    fn of_each<'py>(
        &self,
        py: Python<'py>,
        number: impl Fn(&TurbineMode) -> f64,
    ) -> Bound<'py, PyArray1<f64>> {
        array::vector(py, self.modes.modes.iter().map(number))
    }
}

//! A turbine of the manual at a speed of its rotor.

use towermodes::TowerDescription;
use towermodes::turbine::{Turbine, TurbineDescription, TurbineError, TurbineMesh, TurbineModel};

/// A turbine at a speed of its rotor.
#[derive(Debug, Clone)]
pub struct Turning {
    /// What the tower carries.
    pub machine: TurbineDescription,
    /// The speed of the rotor, rpm.
    pub rotor_speed_rpm: f64,
    /// The elements.
    pub mesh: TurbineMesh,
}

impl Turning {
    /// The natural frequencies on a tower up to a limit, Hz.
    pub(crate) fn frequencies_hz(
        &self,
        tower: &TowerDescription,
        limit_hz: f64,
    ) -> Result<Vec<f64>, TurbineError> {
        let turbine = Turbine::new(tower.clone(), self.machine.clone())?;
        let mut model = TurbineModel::new(&turbine, &self.mesh)?;
        let spectrum = model.frequencies(limit_hz, self.rotor_speed_rpm)?;
        let all = spectrum.frequencies.iter();
        Ok(all
            .flat_map(|mode| std::iter::repeat_n(mode.frequency_hz, mode.multiplicity))
            .collect())
    }
}

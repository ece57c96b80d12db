//! A turbine of the manual at a rotor speed.

use towermodes::TowerDescription;
use towermodes::turbine::{Turbine, TurbineDescription, TurbineError, TurbineMesh, TurbineModel};

/// A turbine at a rotor speed.
#[derive(Debug, Clone)]
pub struct Turning {
    /// The turbine on the tower.
    pub machine: TurbineDescription,
    /// The rotor speed, rpm.
    pub rotor_speed_rpm: f64,
    /// The elements.
    pub mesh: TurbineMesh,
}

impl Turning {
    /// The natural frequencies of the turbine on a tower up to a limit, Hz.
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

//! A turbine on its tower: description, equations of motion at a frequency and a speed, and its
//! modes below a limit, with the counts that prove that none is missing.

mod checked;
mod counts;
mod description;
mod equations;
mod error;
mod results;
mod validate;

pub use checked::Turbine;
pub use counts::frequencies::{CoupledFrequency, CoupledSpectrum};
pub use counts::recount::MissedModes;
pub use description::{Generator, Hub, TurbineDescription};
pub use equations::mesh::TurbineMesh;
pub use equations::model::TurbineModel;
pub use error::TurbineError;
pub use results::energy::{
    BladeEnergy, BladeMotion, Harmonic, Nodding, TurbineEnergy, TurbinePart,
};
pub use results::mode::{TurbineMode, TurbineModes};
pub use results::name::TurbineModeName;
pub use results::shape::{BladeDeflection, TowerMotion, TurbineShape};

pub use crate::rotor::RotorError;
pub use crate::scalar::Complex;

//! A turbine on its tower: description, equations of motion at a frequency and a speed, and its
//! modes below a limit, with the counts that prove that none is missing.

mod approach;
mod blade_elements;
mod bordered;
mod checked;
mod coupled;
mod description;
mod elastic;
mod energy;
mod error;
mod falling;
mod frequencies;
mod gyroscopic;
mod machine;
mod machine_vectors;
mod mesh;
mod mode;
mod model;
mod modes;
mod name;
mod naming;
mod recount;
mod search;
mod shape;
mod shaping;
mod validate;

pub use checked::Turbine;
pub use description::{Generator, Hub, TurbineDescription};
pub use energy::{BladeEnergy, BladeMotion, Harmonic, Nodding, TurbineEnergy, TurbinePart};
pub use error::TurbineError;
pub use frequencies::{CoupledFrequency, CoupledSpectrum};
pub use mesh::TurbineMesh;
pub use mode::{TurbineMode, TurbineModes};
pub use model::TurbineModel;
pub use name::TurbineModeName;
pub use recount::MissedModes;
pub use shape::{BladeDeflection, TowerMotion, TurbineShape};

pub use crate::rotor::RotorError;
pub use crate::scalar::Complex;

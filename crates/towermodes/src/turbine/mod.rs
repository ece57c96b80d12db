//! A turbine on its tower: description, equations of motion at a frequency and a speed, and the
//! natural frequencies below a limit with the counts that prove them; its modes with their energies,
//! names and shapes.

mod description;
mod energy;
mod error;
mod frequencies;
mod machine;
mod mode;
mod model;
mod name;
mod root;
mod shape;
mod validate;

pub use description::{Generator, Hub, TurbineDescription};
pub use energy::{BladeEnergy, BladeMotion, Harmonic, TurbineEnergy, TurbinePart};
pub use error::TurbineError;
pub use frequencies::{CoupledFrequency, CoupledSpectrum};
pub use mode::{TurbineMode, TurbineModes};
pub use model::{Turbine, TurbineMesh, TurbineModel};
pub use name::TurbineModeName;
pub use shape::{BladeDeflection, TowerMotion, TurbineShape};

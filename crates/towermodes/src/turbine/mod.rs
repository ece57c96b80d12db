//! A turbine on its tower: description, equations of motion at a frequency and a speed, and the
//! natural frequencies below a limit with the counts that prove them.

mod description;
mod error;
mod frequencies;
mod machine;
mod model;
mod root;
mod validate;

pub use description::{Generator, Hub, TurbineDescription};
pub use error::TurbineError;
pub use frequencies::{CoupledFrequency, CoupledSpectrum};
pub use model::{Turbine, TurbineMesh, TurbineModel};

//! The modes as results: family and order, shape, modal mass, energy, discretization
//! error.

mod arrears;
mod discretization;
mod energy;
mod energy_parts;
mod family;
mod holders;
mod mode_name;
mod rigid;
mod sampling;
#[cfg(feature = "serde")]
pub mod serialized;
mod shape;
mod shares;

pub use arrears::Arrears;
pub use discretization::{Estimate, richardson};
pub(crate) use discretization::{extrapolate, without_powers};
pub use energy::{ByMotion, Energy};
pub use energy_parts::{EnergyParts, KineticParts, StrainParts};
pub use family::{Family, Ordinal};
pub use holders::{Holders, SharedMotion};
pub use mode_name::{ModeName, ModeNameError};
pub(crate) use rigid::RigidTower;
pub use sampling::ModeCurve;
pub use shape::ShapePoint;
pub use shares::{SecondFamily, Shares};

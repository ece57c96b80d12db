//! Soil in layers around the part of a tower below the surface: the description of a geotechnical
//! report, from which springs along the tower follow by named models.

mod description;
mod layer;
mod model;
mod shear_modulus;

pub use description::{AxialModel, Ground, Scour};
pub use layer::{Clay, GroundLayer, LayerSoil, PyRow, Rock, Sand};
pub use model::SoilModel;
pub use shear_modulus::ShearModulus;

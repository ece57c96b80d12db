//! Soil in layers around the part of a tower below the surface: the description of a geotechnical
//! report, from which springs along the tower follow by named models.
//!
//! `pile` has the heights and depths, `reaction` the springs at a height by the model of the layer,
//! each kind of soil in a file of its own; `plan` cuts the pile where springs change their slope,
//! and `rows` makes rows of springs of the whole.

mod axial;
mod clay;
mod description;
mod elastic;
mod kink;
mod layer;
mod lines;
mod model;
mod pile;
mod pisa;
mod plan;
mod reaction;
mod rock;
mod rows;
mod sand;
mod shear_modulus;
mod table;

pub use description::{ApiEdition, AxialModel, Ground, Scour};
pub use layer::{Clay, GroundLayer, LayerSoil, PyRow, Rock, Sand};
pub use model::SoilModel;
pub(in crate::tower) use plan::Plan;
pub(in crate::tower) use rows::with_rows;
pub use shear_modulus::ShearModulus;
pub(in crate::tower) use shear_modulus::{ConeBelowStress, CorrelatedSoil, cone_below_stress};

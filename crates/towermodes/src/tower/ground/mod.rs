//! Soil in layers around the part of a tower below the surface: the description of a geotechnical
//! report, from which springs along the tower follow by named models.
//!
//! `pile` has the heights and depths, `models` and `axial` the formulas of springs, each model in a
//! file of its own; `reaction` gives each layer its models, `plan` cuts the pile where springs
//! change their slope, and `rows` makes rows of springs of the whole. Of a tower on a frame
//! `frame_piles` finds the piles, and `frame_plan` gives their members the springs.

mod axial;
mod description;
mod frame_piles;
mod frame_plan;
mod kink;
mod layer;
mod layer_springs;
mod lines;
mod model;
mod models;
mod modulus;
mod pile;
mod plan;
mod reaction;
mod rows;
mod shear_modulus;
mod spot;
mod values;

pub use description::{ApiEdition, AxialModel, Ground, Scour};
pub(in crate::tower) use frame_piles::{FramePile, NoPile, buried};
pub use layer::{Clay, GroundLayer, LayerSoil, PyRow, Rock, Sand};
pub(in crate::tower) use layer_springs::Piles;
pub use model::SoilModel;
pub(in crate::tower) use models::models_by_soil;
pub(in crate::tower) use modulus::{ConeBelowStress, cone_below_stress};
pub(in crate::tower) use reaction::{Models, Refused};
pub(in crate::tower) use rows::{GroundPlan, with_rows};
pub(in crate::tower) use shear_modulus::CorrelatedSoil;
pub use shear_modulus::ShearModulus;
pub(in crate::tower) use values::NoSprings;

//! Foundations whose stiffness at the base follows by a closed form from their dimensions and the
//! soil. `form` is the common interface; each kind has a file with all its facts.

mod carter_kulhawy;
mod circular_footing;
mod common;
mod flexible_pile;
mod form;
mod half_space;
mod head;
mod monopile;
mod pile_tube;
mod poulos_davis;
mod rectangular_footing;
mod shadlou;
mod soil_spring;
mod suction_caisson;
mod winkler;

pub use circular_footing::CircularFooting;
pub use common::SoilProfile;
pub use form::{Buried, ClosedForm, FormKind, SoilBelow};
pub use half_space::HalfSpace;
pub use head::HeadStiffness;
pub use monopile::{Monopile, PileBehaviour, PileFormula, Slenderness};
pub use pile_tube::PileTube;
pub use rectangular_footing::{FootingFormula, RectangularFooting};
pub use soil_spring::SoilSpring;
pub use suction_caisson::SuctionCaisson;
pub use winkler::{BeamFormula, WinklerPile};

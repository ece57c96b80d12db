//! Chains of flexible beam elements: the finite element of BModes and the spectral beam, one kind
//! of element in both.

mod assembly;
mod element;
mod elimination;
mod general;
mod legendre;
mod model;
mod product;
mod pull;
mod rotating;
mod strain;
mod structure;

pub use assembly::{BeamRecipe, BeamWorkspace, assemble_beams};
pub use elimination::{Factors, count_negative, factorize, solve};
pub use legendre::{Legendre, Term, gauss_points};
pub use model::Beam;
pub use product::{base_excitation, motions, product};
pub(crate) use rotating::{assemble_blade, blade_coordinates};
pub use strain::{Deformation, Strain};
pub use structure::{BeamWork, Beams};

//! Chains of rigid bodies and elastic joints in D components: O(n) product, articulated
//! factorization, eigenvalue count.

#[macro_use]
mod components;

mod articulated;
mod branch;
mod cubic;
mod curves;
mod energies;
mod inverse_step;
mod joint;
mod model;
mod product;
mod states;
mod subsystem;
mod transfer;

pub(crate) use joint::JointFlexibility;
pub use model::Chain;
pub use subsystem::{ChainAssembly, ChainSubsystem, Chains};

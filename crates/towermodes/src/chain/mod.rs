//! Rigid bodies and elastic joints: the O(n) product, the articulated factorization, the inertia
//! count.

mod articulated;
mod joint;
mod model;
mod product;
mod structure;

pub use articulated::{Elimination, count_negative, factorize, solve};
pub use joint::JointFlexibility;
pub use model::{Chain, Link};
pub use product::{Loads, base_excitation, motions, product};
pub use structure::{ChainWork, Chains};

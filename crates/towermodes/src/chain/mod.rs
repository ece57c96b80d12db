//! Rigid bodies and elastic joints: the O(n) product, the articulated factorization, the inertia count.

mod articulated;
mod decoupled;
mod model;
mod pencil;
mod product;
mod space;
mod spatial;

pub use articulated::{Elimination, count_below, factorize, solve};
pub use decoupled::DecoupledChains;
pub use model::{Chain, Link};
pub use pencil::{ChainPencil, ChainWorkspace};
pub use product::{base_excitation, mass_times, motions, stiffness_times};
pub use space::{Dim, Lever, Matrix, Space, add, add_scaled, lower, lower_matrix, raise, times};
pub use spatial::{JointFlexibility, RigidBody};

//! Mooring systems of the verification manual, and their state.

use towermodes::mooring::{Mooring, MooringDescription, MooringState, Pose};

pub use towermodes_verify::towers::offshore::{
    buoyant, buoys, clump, coupled, delta, hywind, iea_22, mooring as deck, oc4_semi, rod, tlp,
    volturnus,
};

/// The state at the reference pose.
pub fn at_rest(description: &MooringDescription) -> MooringState {
    let mooring = Mooring::new(description.clone()).expect("a valid mooring");
    mooring.at(&Pose::default()).expect("an equilibrium")
}

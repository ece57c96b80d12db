//! An elastic line between two points: hanging freely, or partly on the seabed.

use super::cable::{Cable, Profile};
use super::grounded::grounded;
use super::hanging::hanging;

impl Cable {
    /// The line between two points this far apart horizontally; the lower one is `clearance_m`
    /// above the seabed, the upper one `rise_m` above the lower one. None if there is no tension in
    /// double precision.
    pub(super) fn profile(&self, span_m: f64, rise_m: f64, clearance_m: f64) -> Option<Profile> {
        let hanging = hanging(self, span_m, rise_m)?;
        if hanging.sag_m <= clearance_m {
            return Some(hanging);
        }
        grounded(self, span_m, [clearance_m, clearance_m + rise_m])
    }
}

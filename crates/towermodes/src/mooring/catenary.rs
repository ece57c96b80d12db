//! An elastic line between two points: hanging freely, or partly on the seabed.

use super::cable::{Cable, Profile};
use super::grounded::grounded;
use super::hanging::hanging;

impl Cable {
    /// The line between two points this far apart horizontally; the lower one is `clearance_m`
    /// above the seabed, the upper one `rise_m` above the lower one. None where no number is the
    /// tension.
    pub(super) fn profile(&self, span_m: f64, rise_m: f64, clearance_m: f64) -> Option<Profile> {
        let hanging = hanging(self, span_m, rise_m)?;
        if hanging.lower_n <= 0.0 || self.sag_m(&hanging) <= clearance_m {
            return Some(hanging);
        }
        grounded(self, span_m, [clearance_m, clearance_m + rise_m])
    }

    /// How far the lowest point of a line that sags is below its lower end, m.
    fn sag_m(&self, hanging: &Profile) -> f64 {
        let (h, v) = (hanging.horizontal_n, hanging.lower_n);
        if v == 0.0 {
            return 0.0;
        }
        let square = v * v / self.weight_n_per_m;
        square / (h.hypot(v) + h) + 0.5 * square / self.axial_stiffness_n
    }
}

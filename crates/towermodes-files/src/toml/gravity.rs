//! `[gravity]`.

use towermodes::Place;

use super::Reading;
use super::table::{Keys, Table};

const GRAVITY: Keys = Keys {
    known: &["acceleration"],
};

/// Standard acceleration of gravity, m/s².
///
/// Source: 3rd General Conference on Weights and Measures (1901).
const STANDARD_M_PER_S2: f64 = 9.806_65;

/// The acceleration of gravity, m/s²; without the table weights are left out.
pub(super) fn gravity(root: &Table<'_>, reading: &mut Reading) -> Option<f64> {
    let Some(value) = root.get("gravity") else {
        return Some(0.0);
    };
    let table = Table::of(value, "[gravity]", &GRAVITY, reading)?;
    let acceleration = table.number_or(STANDARD_M_PER_S2, "acceleration", Place::Gravity, reading);
    if acceleration == Some(0.0) {
        let message = "[gravity] with acceleration = 0 has no effect: weights are left out; leave [gravity] out if that is meant, or give 9.81 m/s2";
        reading.note(value.span().start, message);
    }
    acceleration
}

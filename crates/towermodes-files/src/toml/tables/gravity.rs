//! `[gravity]`.

use towermodes::Place;
use towermodes::tower::STANDARD_GRAVITY_M_PER_S2;

use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::Table;

/// The acceleration of gravity, m/s²; 0 without the table.
pub(crate) fn gravity(root: &Table<'_>, reading: &mut Reading) -> Option<f64> {
    let Some(value) = root.get("gravity") else {
        return Some(0.0);
    };
    let table = Table::of(value, "[gravity]", &schema::GRAVITY, reading)?;
    let acceleration = table.number_or(
        STANDARD_GRAVITY_M_PER_S2,
        "acceleration",
        Place::Gravity,
        reading,
    );
    if acceleration == Some(0.0) {
        let message = "[gravity] with acceleration = 0 has no effect: remove [gravity], or write acceleration = 9.81 (m/s2)";
        reading.note(value.span().start, message);
    }
    acceleration
}

//! Numbers and names in tables, stored if the tower's own checks may refer to them.

use towermodes::Place;

use super::reading::Reading;
use super::table::Table;
use super::values::{number, text};

impl Table<'_> {
    /// A required finite number.
    pub(crate) fn required_number(
        &self,
        key: &str,
        hint: &str,
        place: Place,
        reading: &mut Reading,
    ) -> Option<f64> {
        let value = self.require(key, hint, reading)?;
        reading.remember(place, value.span());
        number(value, key, reading)
    }

    /// An optional finite number: `Some(None)` if it is absent, `None` after a mistake.
    pub(crate) fn optional_number(
        &self,
        key: &str,
        place: Place,
        reading: &mut Reading,
    ) -> Option<Option<f64>> {
        let Some(value) = self.get(key) else {
            return Some(None);
        };
        reading.remember(place, value.span());
        number(value, key, reading).map(Some)
    }

    /// A finite number with a default.
    pub(crate) fn number_or(
        &self,
        default: f64,
        key: &str,
        place: Place,
        reading: &mut Reading,
    ) -> Option<f64> {
        let number = self.optional_number(key, place, reading)?;
        Some(number.unwrap_or(default))
    }

    /// The `name`, which is used only in messages and reports; empty if there is none.
    pub(crate) fn name_of(&self, what: &str, reading: &mut Reading) -> Option<String> {
        match self.get("name") {
            Some(name) => text(name, what, reading).map(str::to_owned),
            None => Some(String::new()),
        }
    }
}

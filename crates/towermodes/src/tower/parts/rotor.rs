//! The rotor of a turbine as far as it excites the tower: number of blades and speed range.

use std::fmt;

/// The largest number of blades that a rotor may have.
pub const MOST_BLADES: usize = 10;

/// The highest rotor speed that is accepted, rpm. The blade tips of a rotor of 1 m diameter would
/// move at fifteen times the speed of sound.
pub const FASTEST_RPM: f64 = 1e5;

/// A rotor: its number of blades and its range of operating speeds.
///
/// # Example
/// ```
/// use towermodes::Rotor;
///
/// let rotor = Rotor { blades: 3, lowest_rpm: 6.9, highest_rpm: 12.1 };
/// rotor.validate()?;
/// # Ok::<(), towermodes::TowerError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Rotor {
    /// Number of blades, at least one.
    pub blades: usize,
    /// Lowest operating speed, rpm.
    pub lowest_rpm: f64,
    /// Highest operating speed, rpm; equal to the lowest for a rotor of constant speed.
    pub highest_rpm: f64,
}

/// Displays a rotor speed with at most three decimals and without trailing zeros.
///
/// # Example
/// ```
/// assert_eq!(towermodes::tower::Rpm(6.3745).to_string(), "6.375");
/// assert_eq!(towermodes::tower::Rpm(10.0).to_string(), "10");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rpm(
    /// The speed, rpm.
    pub f64,
);

impl fmt::Display for Rpm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = format!("{:.3}", self.0);
        f.pad(text.trim_end_matches('0').trim_end_matches('.'))
    }
}

#[cfg(test)]
mod tests {
    use super::Rpm;

    #[test]
    fn speeds_are_as_short_as_they_can_be() {
        let shown = [12.1, 10.0, 0.0, 6.3745, 100.0].map(|rpm| Rpm(rpm).to_string());
        assert_eq!(shown, ["12.1", "10", "0", "6.375", "100"]);
    }
}

//! What a rotor is, as far as it excites a tower.

use std::fmt;

/// More blades than this no rotor of a wind turbine on a tower has.
pub const MOST_BLADES: usize = 10;

/// No rotor is faster, rpm: the tips of one of 1 m across would be at the speed of sound fifteen
/// times over.
pub const FASTEST_RPM: f64 = 1e5;

/// Diagrams go to this many times the highest speed of operation.
pub const BEYOND_OPERATION: f64 = 1.2;

/// A rotor: how many blades it has and which speeds it runs at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotor {
    /// Number of blades, at least one.
    pub blades: usize,
    /// The lowest speed of operation, rpm.
    pub lowest_rpm: f64,
    /// The highest speed of operation, rpm; of a rotor of constant speed the lowest.
    pub highest_rpm: f64,
}

/// A speed for people, rpm: to three digits after the point, without zeros at the end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rpm(pub f64);

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

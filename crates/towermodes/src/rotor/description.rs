//! What a rotor is, as far as it excites a tower.

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

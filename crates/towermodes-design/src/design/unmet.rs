//! Limits that no tower found meets, and the nearest tower.

use std::fmt;

use towermodes::ModeName;

use super::limits::Limit;

/// The error that no tower was found that meets all limits, with the nearest tower. The search is
/// local: if only frequencies are violated, such a tower may exist elsewhere.
#[derive(Debug, Clone, PartialEq)]
pub struct Infeasible {
    /// The violated limits, the worst first.
    pub violated: Vec<Conflict>,
    /// The limits that prevent a nearer tower, as text; none if the named modes meet their bands
    /// and only other modes that share their motions violate them.
    pub in_the_way: Vec<String>,
    /// The values of the variables of the nearest tower.
    pub values: Vec<f64>,
    /// Modes of equal frequency by symmetry whose bands exclude each other.
    pub equal: Vec<[ModeName; 2]>,
}

/// A limit that the nearest tower does not meet.
#[derive(Debug, Clone, PartialEq)]
pub struct Conflict {
    /// The limit.
    pub limit: Limit,
    /// The limit in words: "fore-aft 1 at least 0.3 Hz".
    pub wanted: String,
    /// The value for the nearest tower as text: "0.284 Hz".
    pub nearest: String,
}

impl fmt::Display for Infeasible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let violated = self.violated.iter();
        let text = violated.map(|of| format!("{} (nearest: {})", of.wanted, of.nearest));
        let text: Vec<String> = text.collect();
        write!(f, "no tower was found that meets {}", text.join(" and "))?;
        if !self.in_the_way.is_empty() {
            write!(f, "; what prevents it: {}", self.in_the_way.join(", "))?;
        }
        for [first, second] in &self.equal {
            write!(
                f,
                "; {first} and {second} have the same frequency, because the tower has the same stiffness in both directions, so their bands must overlap"
            )?;
        }
        Ok(())
    }
}

//! The effect of a clamped base on the first frequencies.

use std::fmt;

use towermodes::tower::Tower;

/// A tower whose base does not move, although no foundation is rigid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ClampedBase;

impl ClampedBase {
    /// The clamped base of a tower; none for a tower that begins in soil or water, where the clamp
    /// is at the tip of a pile.
    pub fn of(tower: &Tower) -> Option<Self> {
        let is_above = tower.base().is_clamped() && !tower.begins_in_soil_or_water();
        is_above.then_some(Self)
    }
}

/// "the base is clamped; a real foundation lowers the first frequencies".
impl fmt::Display for ClampedBase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "the base is clamped; a real foundation lowers the first frequencies; [foundation] in the tower file describes it",
        )
    }
}

#[cfg(test)]
mod tests {
    use super::ClampedBase;
    use towermodes::{Foundation, FoundationSprings, Tower};
    use towermodes_verify::towers::reference_350t;

    #[test]
    fn only_a_base_that_cannot_move_is_clamped() {
        let of = |foundation: Foundation| {
            let mut description = reference_350t();
            description.foundation = foundation;
            ClampedBase::of(&Tower::new(description).expect("a tower"))
        };
        assert_eq!(of(Foundation::Clamped), Some(ClampedBase));
        // Springs without any motion are a clamp too.
        assert_eq!(
            of(Foundation::Springs(FoundationSprings::RIGID)),
            Some(ClampedBase)
        );
        let springs = FoundationSprings {
            rocking_n_m: 1e11,
            ..FoundationSprings::RIGID
        };
        assert_eq!(of(Foundation::Springs(springs)), None);
    }
}

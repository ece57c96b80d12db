//! What the verdicts of a diagram do not consider.

use super::{Campbell, ClampedBase, WeightLeftOut};
use towermodes::tower::Tower;

/// Sentences on what the verdicts of a tower do not consider: its weight, unless gravity is omitted
/// `by_request`, and the flexibility of a foundation. Empty for a diagram without verdicts.
pub fn verdicts_without(tower: &Tower, campbell: &Campbell, by_request: bool) -> Vec<String> {
    if !campbell.not_checked.is_empty() {
        return Vec::new();
    }
    let weight = match by_request {
        true => None,
        false => WeightLeftOut::of(tower),
    };
    let weight = weight.map(|weight| weight.to_string());
    let clamped = ClampedBase::of(tower).map(|base| base.to_string());
    weight.into_iter().chain(clamped).collect()
}

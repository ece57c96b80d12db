//! The check for rigid-body modes: a rigid motion without stiffness has no frequency.

use super::super::error::{FreeMotions, Place, Problem, TowerError};
use super::super::model::Tower;
use crate::space::SpatialMatrix;
use crate::symmetric::eigenpairs;

/// A scaled stiffness below this is treated as zero.
const FREE: f64 = 1e-12;
/// Components of a free motion larger than this, as a fraction of its largest one, are named.
const NAMED: f64 = 0.1;

/// Refuses a tower that can move as a whole without stiffness, unless it floats.
pub(crate) fn check(tower: &Tower) -> Result<(), TowerError> {
    if tower.base.floats || tower.base.on_frame || tower.base.is_clamped() {
        return Ok(());
    }
    match free_motion(&tower.rigid_stiffness(), tower.base.moves) {
        None => Ok(()),
        Some(motions) => Err(TowerError {
            place: Place::Foundation { key: "type" },
            problem: Problem::Free { motions },
        }),
    }
}

/// A possible motion without stiffness, if there is one.
fn free_motion(stiffness: &SpatialMatrix, moves: [bool; 6]) -> Option<FreeMotions> {
    let possible = |i: usize| moves[i];
    let bare: [bool; 6] = std::array::from_fn(|i| possible(i) && stiffness[i][i] <= 0.0);
    if bare.contains(&true) {
        return Some(FreeMotions(bare));
    }
    let scaled: SpatialMatrix = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            if possible(i) && possible(j) {
                stiffness[i][j] / stiffness[i][i].sqrt() / stiffness[j][j].sqrt()
            } else {
                f64::from(u8::from(i == j))
            }
        })
    });
    let (values, vectors) = eigenpairs(scaled);
    // A motion whose value is NaN is free too: the springs overflow.
    let is_free = |value: &f64| value.partial_cmp(&FREE) != Some(std::cmp::Ordering::Greater);
    let mut named = [false; 6];
    for (_, vector) in values
        .iter()
        .zip(&vectors)
        .filter(|(value, _)| is_free(value))
    {
        let largest = vector.iter().fold(0.0_f64, |a, x| a.max(x.abs()));
        for (named, x) in named.iter_mut().zip(vector) {
            *named |= x.abs() > NAMED * largest;
        }
    }
    named.contains(&true).then_some(FreeMotions(named))
}

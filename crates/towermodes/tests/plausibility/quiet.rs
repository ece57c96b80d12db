//! Towers that are right have no warnings.

use super::quiet;
use super::towers::{
    elliptic, floater, monopile, reference, reference_350t, reference_eccentric,
    reference_on_springs, reference_table, reference_with_machine, rich,
};

#[test]
fn the_towers_of_the_manual_are_not_warned_of() {
    let towers = [
        reference(),
        reference_350t(),
        reference_with_machine(),
        reference_eccentric(),
        reference_on_springs(),
        reference_table(1.0, 350e3),
        rich(),
        elliptic(),
        monopile(),
        floater(),
    ];
    for tower in towers {
        quiet(tower, |_| {});
    }
}

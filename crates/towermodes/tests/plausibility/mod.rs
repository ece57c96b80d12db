//! What is possible but looks like a slip is said, and what is usual is not: each warning on both
//! sides of its limit.

mod bodies;
mod effects;
mod floating;
mod foundations;
mod general;
mod geometry;
mod names;
mod quiet;
mod scale;
mod soil_and_wires;
mod tables;

use crate::towers;

use towermodes::{Place, Quantity, Tower, TowerDescription, Warning};

/// The warnings that a changed description gives rise to by itself, without a solve.
#[track_caller]
fn of(
    mut description: TowerDescription,
    change: impl FnOnce(&mut TowerDescription),
) -> Vec<Warning> {
    change(&mut description);
    let tower = Tower::new(description).expect("a tower");
    tower.warnings().to_vec()
}

/// Asserts that there is no warning.
#[track_caller]
fn quiet(description: TowerDescription, change: impl FnOnce(&mut TowerDescription)) {
    let warnings = of(description, change);
    let said: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(said, [""; 0]);
}

/// The only warning there is, in words.
#[track_caller]
fn one(
    description: TowerDescription,
    change: impl FnOnce(&mut TowerDescription),
) -> (Warning, String) {
    let warnings = of(description, change);
    let said: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(said.len(), 1, "{said:#?}");
    (warnings[0].clone(), said[0].clone())
}

/// Asserts that the only warning is of a quantity at a place, and gives its value.
#[track_caller]
fn odd(
    quantity: Quantity,
    place: Place,
    description: TowerDescription,
    change: impl FnOnce(&mut TowerDescription),
) -> f64 {
    let (warning, said) = one(description, change);
    match warning {
        Warning::Unusual {
            quantity: got,
            value,
            ..
        } if got == quantity => {
            assert_eq!(warning.place(), Some(place), "{said}");
            value
        }
        _ => panic!("{said}"),
    }
}

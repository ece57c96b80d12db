//! The limits of single values.

use super::scale::{
    above_zero, coordinate, error, finite, length, not_negative, positive, stiffness,
};
use crate::inputs::{Given, Input, Inputs, Limit};
use crate::tower::error::{Place, Problem, TowerError};

/// Checks each value of a table against its limit; `at` gives the place of a key.
pub(super) fn check_inputs(
    inputs: &dyn Inputs,
    at: impl Fn(&'static str) -> Place,
) -> Result<(), TowerError> {
    let mut result = Ok(());
    inputs.visit(&mut |input, given| {
        if result.is_ok() {
            let mut numbers = numbers_of(given).into_iter().flatten();
            result = numbers.try_for_each(|value| check_input(input, value, at(input.key)));
        }
    });
    result
}

/// The numbers of a value to be checked.
fn numbers_of(given: Given) -> [Option<f64>; 3] {
    match given {
        // Strength and stiffness can be zero at one end, as in normally consolidated clay.
        Given::Pair(Some([0.0, other] | [other, 0.0])) if other > 0.0 => [Some(other), None, None],
        Given::Pair(Some([top, bottom])) => [Some(top), Some(bottom), None],
        Given::Triple(triple) => triple.map(Some),
        _ => [given.number(), None, None],
    }
}

pub(super) fn check_input(input: &Input, value: f64, place: Place) -> Result<(), TowerError> {
    if input.may_be_infinite && value == f64::INFINITY {
        return Ok(());
    }
    let (name, unit) = (input.name, input.spaced_unit);
    match input.limit {
        Limit::Finite => finite(place, name, value, unit),
        Limit::Height | Limit::Coordinate => coordinate(place, name, value),
        Limit::Depth => {
            not_negative(place, name, value, unit)?;
            coordinate(place, name, value)
        }
        Limit::Length => length(place, name, value),
        Limit::Positive => positive(place, name, value, unit),
        Limit::NotNegative => not_negative(place, name, value, unit),
        Limit::Spring => {
            above_zero(place, name, value, unit)?;
            stiffness(place, name, value, unit)
        }
        Limit::Stiffness => stiffness(place, name, value, unit),
        Limit::UpTo(most) => {
            positive(place, name, value, unit)?;
            let (quantity, is_possible) = (name, value <= most);
            let problem = Problem::TooLarge {
                quantity,
                value,
                unit,
                most,
            };
            if is_possible {
                Ok(())
            } else {
                error(place, problem)
            }
        }
        Limit::Within(range) => within(place, input, value, range),
        Limit::Slope if (0.0..=90.0).contains(&value) => Ok(()),
        Limit::Slope => {
            finite(place, name, value, unit)?;
            let (quantity, value_deg) = (name, value);
            error(
                place,
                Problem::Slope {
                    quantity,
                    value_deg,
                },
            )
        }
        Limit::LossFactor if (0.0..=1.0).contains(&value) => Ok(()),
        Limit::LossFactor => {
            let quantity = name;
            error(place, Problem::LossFactor { quantity, value })
        }
        Limit::AtLeast(least) if value >= least as f64 => Ok(()),
        Limit::AtLeast(least) => {
            let problem = Problem::TooFew {
                quantity: name,
                count: value as u64,
                least,
                remedy: input.remedy,
            };
            error(place, problem)
        }
        Limit::PoissonsRatioOfSoil => {
            finite(place, name, value, unit)?;
            match (0.0..=0.5).contains(&value) {
                true => Ok(()),
                false => error(place, Problem::SoilPoissonsRatio { value }),
            }
        }
        Limit::Inertia | Limit::Elsewhere => Ok(()),
    }
}

fn within(
    place: Place,
    input: &Input,
    value: f64,
    [least, most]: [f64; 2],
) -> Result<(), TowerError> {
    finite(place, input.name, value, input.spaced_unit)?;
    if (least..=most).contains(&value) {
        return Ok(());
    }
    let problem = Problem::OutOfRange {
        quantity: input.name,
        value,
        unit: input.spaced_unit,
        least,
        most,
    };
    error(place, problem)
}

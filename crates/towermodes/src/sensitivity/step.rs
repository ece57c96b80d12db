//! The value of a change for the unchanged tower, and the step of its variation for a derivative.

use super::error::SensitivityError;
use crate::inputs::Dimension;
use crate::parameter::{Change, Operation, Parameter};
use crate::tower::{Neighbours, Tower, TowerDescription};

/// The step relative to a value, to the distance to the next height, or to the numbers to which it
/// is added.
pub(super) const RELATIVE: f64 = 2e-3;
/// Fraction of the step of quotients over which the input values of a tower are differenced: these
/// differences have small rounding errors. It is also used for quotients that may have a kink.
pub(super) const SHORTER: f64 = 0.1;
/// A step that changes every eigenvalue by less than this, relatively, is enlarged if the tower
/// depends linearly on the input value.
pub(super) const SMALL: f64 = 1e-6;
/// Largest relative change of an eigenvalue by an enlarged step.
pub(super) const LARGE: f64 = 1e-3;

/// The value of a change on the tower as it is.
///
/// # Errors
/// [`SensitivityError::Unequal`].
pub(super) fn present_value(
    change: &Change,
    description: &TowerDescription,
) -> Result<f64, SensitivityError> {
    match change.operation() {
        Operation::Scale => Ok(1.0),
        Operation::Add => Ok(0.0),
        Operation::Set => {
            let mut values = change.parameters().iter().map(|p| p.value(description));
            let first = values.next().unwrap_or(f64::NAN);
            match values.find(|value| *value != first) {
                Some(second) => Err(SensitivityError::Unequal {
                    change: change.name().to_owned(),
                    first,
                    second,
                }),
                None => Ok(first),
            }
        }
    }
}

/// The step of the value of a change.
pub(super) fn step(change: &Change, value: f64, neighbours: &Neighbours) -> f64 {
    RELATIVE * size_of(change, value, neighbours)
}

/// The size of a change: its value, the shortest piece between heights, or the input values to
/// which it adds.
pub(super) fn size_of(change: &Change, value: f64, neighbours: &Neighbours) -> f64 {
    let heights = change.parameters().iter().filter(|p| p.is_height());
    let of_heights = change.operation() != Operation::Scale;
    let gaps = heights
        .map(|_| shortest_piece_m(neighbours.tower()))
        .filter(|_| of_heights);
    match gaps.reduce(f64::min) {
        Some(gap_m) => gap_m,
        None if value != 0.0 => value.abs(),
        None => size(change, neighbours.description()),
    }
}

/// The largest of the input values to which a change adds; if they are zero, their unit.
fn size(change: &Change, description: &TowerDescription) -> f64 {
    let numbers = change.parameters().iter();
    let sizes = numbers.map(|number| number.value(description).abs());
    match sizes.filter(|size| size.is_finite()).fold(0.0, f64::max) {
        0.0 => 1.0,
        size => size,
    }
}

/// The shortest linear piece of a tower, m.
fn shortest_piece_m(tower: &Tower) -> f64 {
    let lengths = tower.pieces().iter().map(|piece| piece.length_m());
    lengths.fold(f64::INFINITY, f64::min)
}

/// Whether stiffness and inertia depend linearly on the input values of a change, so that the step
/// may be as large as necessary.
pub(super) fn is_linear(change: &Change) -> bool {
    let is_linear = |parameter: &Parameter| {
        // Between the rows of a table inertias follow from masses.
        !parameter.is_of_rows() && is_mass_or_spring(parameter.dimension())
    };
    change.operation() != Operation::Scale && change.parameters().iter().all(is_linear)
}

/// Whether stiffness and inertia are sums of input values with this dimension.
fn is_mass_or_spring(dimension: Dimension) -> bool {
    use Dimension as D;
    match dimension {
        D::Mass | D::MassTimesLength | D::Inertia => true,
        D::ForcePerLength | D::Force | D::Moment | D::ForcePerArea => true,
        D::Pure | D::Length | D::Angle | D::MassPerLength | D::Density | D::Volume => false,
        D::Bending | D::ForcePerVolume | D::Pressure | D::OfEntries => false,
        D::Velocity | D::Acceleration | D::RotorSpeed | D::PerAngle => false,
    }
}

/// Whether the numbers of a tower depend on the input values of a change linearly or quadratically,
/// so that a central difference is exact.
pub(super) fn is_quadratic(change: &Change) -> bool {
    change.parameters().iter().all(|parameter| {
        let is_of_profile = parameter.is_of_stations() && !parameter.is_height();
        // Between the rows of a table inertias are masses times squared radii of gyration.
        let is_of_rows = parameter.is_of_rows();
        let is_excluded = is_of_rows || parameter.is_of_ground();
        is_of_profile || !(is_excluded || is_curved(parameter.dimension()))
    })
}

/// Whether a tower is a polynomial of at least third degree in input values with this dimension, or
/// not a polynomial.
fn is_curved(dimension: Dimension) -> bool {
    matches!(
        dimension,
        Dimension::Length | Dimension::Angle | Dimension::Pure
    )
}

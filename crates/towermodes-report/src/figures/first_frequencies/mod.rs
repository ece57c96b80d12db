//! The first bending frequencies on one bar, between what the rotor excites most.

mod draw;
mod numbers;
mod ranges;

use towermodes_analysis::resonance::Campbell;

use crate::svg::Figure;
use ranges::{Lane, Range, lanes, ranges};

/// The name that a page calls the picture by.
const NAME: &str = "first-frequencies";

/// The first fore-aft and side-side frequencies of a tower (where it has none, the lowest coupled
/// ones) on an axis of frequencies, with their distances to the rotor's speed (1P) and to the
/// passing of its blades; the ranges of these in operation are shaded, and beside them what the
/// margin keeps free. None if neither a mode nor an excitation is there to be shown.
///
/// With the margin m an excitation from a to b keeps natural frequencies out of a/(1 + m) to b/(1 −
/// m): there |n Ω/f − 1| is below m at some speed of operation.
pub fn first_frequencies(campbell: &Campbell) -> Option<Figure> {
    let (ranges, lanes) = (ranges(campbell), lanes(campbell));
    if ranges.is_empty() || lanes.is_empty() {
        return None;
    }
    let bar = Bar {
        ranges,
        lanes,
        margin: campbell.margin,
    };
    Some(Figure {
        name: NAME.to_owned(),
        title: "First natural frequencies between the rotor's excitations".to_owned(),
        description: numbers::description(&bar),
        drawing: draw::drawing(&bar),
        table: numbers::table(&bar),
    })
}

/// What is on the bar.
#[derive(Debug, Clone, PartialEq)]
struct Bar {
    /// What excites most, by frequency.
    ranges: Vec<Range>,
    /// The modes, each in a lane of its own.
    lanes: Vec<Lane>,
    /// Least share of a natural frequency that an excitation stays away from it.
    margin: f64,
}

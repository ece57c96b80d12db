//! The first bending frequencies on one bar, with the strongest excitations of the rotor.

mod draw;
mod numbers;
mod ranges;

use towermodes_analysis::resonance::Campbell;

use crate::svg::Figure;
use ranges::{Lane, Range, lanes, ranges};

/// The id of the picture on a page.
const NAME: &str = "first-frequencies";

/// The first fore-aft and side-side frequencies of a tower (or the lowest coupled ones) on a
/// frequency axis, with their distance from the rotor speed (1P) and the blade passing frequency.
/// The ranges of both in operation are shaded, with the required margin around them. None if there
/// is neither a mode nor an excitation to show, and if nothing is checked.
///
/// With the margin m, an excitation from a to b Hz excludes natural frequencies from a/(1 + m) to
/// b/(1 − m): there the distance |d| is below m at some operating speed.
pub fn first_frequencies(campbell: &Campbell) -> Option<Figure> {
    let (ranges, lanes) = (ranges(campbell), lanes(campbell));
    if !campbell.not_checked.is_empty() || ranges.is_empty() || lanes.is_empty() {
        return None;
    }
    let bar = Bar {
        ranges,
        lanes,
        margin: campbell.margin,
    };
    Some(Figure {
        name: NAME.to_owned(),
        title: "First bending frequencies and ranges of the rotor excitations".to_owned(),
        description: numbers::description(&bar),
        drawing: draw::drawing(&bar),
        table: numbers::table(&bar),
    })
}

/// The content of the bar.
#[derive(Debug, Clone, PartialEq)]
struct Bar {
    /// The strongest excitations, by frequency.
    ranges: Vec<Range>,
    /// The modes, each in its own row.
    lanes: Vec<Lane>,
    /// The required margin, a fraction.
    margin: f64,
}

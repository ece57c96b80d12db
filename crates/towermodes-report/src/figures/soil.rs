//! The first bending frequencies against the stiffness of the soil, or against the depth of scour.

use towermodes::number::{Plain, percent};
use towermodes::{Family, Rotor};
use towermodes_analysis::soil_band::{BandMode, ScourCurve, SoilBand};

use super::chart::{Axis, Band, Chart, Series};
use crate::number::four_digits;
use crate::svg::{Colour, Figure, Numbers, extent};

const HEIGHT: f64 = 420.0;
/// Room above the highest and below the lowest frequency, as a fraction of their difference.
const ROOM: f64 = 0.25;
/// The axis covers at least this fraction of the frequency, so that a nearly constant frequency
/// looks constant.
const LEAST_RANGE: f64 = 0.02;
/// The axis is extended to an excluded range that is at most this fraction of the frequency away.
const NEAR: f64 = 0.3;

/// The rotor whose excitations are drawn, and the required distance from them (a fraction).
pub type Excitations<'a> = Option<(&'a Rotor, f64)>;

/// The first bending frequencies against the factor of the soil stiffness.
pub fn soil(band: &SoilBand, rotor: Excitations<'_>) -> Figure {
    let factors = band
        .factors
        .iter()
        .filter(|value| value.log2().fract() == 0.0);
    let numbers = factors.map(|value| (*value, Plain(*value).to_string()));
    let x = Axis {
        is_logarithmic: true,
        numbers: Numbers::At(numbers.collect()),
        ..Axis::linear(
            "factor on the stiffness of the soil (\u{2212})",
            ends(&band.factors),
        )
    };
    let title = "First bending frequencies against the stiffness of the soil";
    figure(
        ["soil", title],
        &chart(x, &band.factors, &band.modes, rotor),
    )
}

/// The first bending frequencies against the depth of local scour.
pub fn scour(curve: &ScourCurve, rotor: Excitations<'_>) -> Figure {
    let x = Axis {
        numbers: Numbers::About(7),
        ..Axis::linear("depth of local scour (m)", ends(&curve.depths_m))
    };
    let title = "First bending frequencies against the depth of scour";
    figure(
        ["scour", title],
        &chart(x, &curve.depths_m, &curve.modes, rotor),
    )
}

fn ends(values: &[f64]) -> [f64; 2] {
    [
        values.first().copied().unwrap_or(0.0),
        values.last().copied().unwrap_or(1.0),
    ]
}

fn figure([name, title]: [&str; 2], chart: &Chart) -> Figure {
    let each = chart.series.iter().filter_map(|series| {
        let ([from, from_hz], [to, to_hz]) = (series.finite().next()?, series.finite().last()?);
        let (label, from, to) = (&series.label, Plain(from), Plain(to));
        Some(format!(
            "{label} from {from_hz:.4} Hz at {from} to {to_hz:.4} Hz at {to}"
        ))
    });
    let each: Vec<String> = each.collect();
    let bands = chart.bands.iter().map(|band| format!(" {}.", band.name));
    Figure {
        name: name.to_owned(),
        title: title.to_owned(),
        description: format!(
            "Frequencies against {}: {}.{}",
            chart.x.name,
            each.join("; "),
            bands.collect::<String>()
        ),
        drawing: chart.drawing(HEIGHT),
        table: chart.table("Hz"),
    }
}

/// The first bending modes, with the frequencies that 1P and the blade passing frequency exclude.
fn chart(x: Axis, values: &[f64], modes: &[BandMode], rotor: Excitations<'_>) -> Chart {
    let bends = |mode: &&BandMode| {
        let families = [Family::ForeAft, Family::SideSide];
        mode.order == 1 && families.contains(&mode.family)
    };
    let series = |(index, mode): (usize, &BandMode)| Series {
        index,
        label: mode.label.clone(),
        points: values
            .iter()
            .zip(&mode.at)
            .map(|(value, at)| [*value, at.map_or(f64::NAN, |at| at.frequency_hz)])
            .collect(),
    };
    let series: Vec<Series> = modes.iter().filter(bends).enumerate().map(series).collect();
    let bands = rotor.map(|(rotor, margin)| {
        let mut multiples = vec![1, rotor.blades];
        multiples.dedup();
        let bands = multiples.into_iter();
        bands
            .map(|multiple| forbidden(rotor, margin, multiple))
            .collect()
    });
    let bands: Vec<Band> = bands.unwrap_or_default();
    Chart {
        x,
        y: Axis::linear("natural frequency (Hz)", range_hz(&series, &bands)),
        bands,
        series,
        ..Chart::default()
    }
}

/// The natural frequencies that are closer to a multiple of the rotor speed in operation than the
/// margin; the ends of the excitation itself are marked.
fn forbidden(rotor: &Rotor, margin: f64, multiple: usize) -> Band {
    let operation_hz =
        [rotor.lowest_rpm, rotor.highest_rpm].map(|rpm| multiple as f64 * rpm / 60.0);
    let range = [
        operation_hz[0] / (1.0 + margin),
        operation_hz[1] / (1.0 - margin),
    ];
    let [low, high] = range.map(four_digits);
    Band {
        range,
        name: format!(
            "within {} % of {multiple}P in operation: {low} to {high} Hz",
            percent(margin)
        ),
        colour: Colour::TooNear,
        marked: operation_hz.to_vec(),
    }
}

/// The frequencies, and the borders of excluded ranges near them.
fn range_hz(series: &[Series], bands: &[Band]) -> [f64; 2] {
    let points = series.iter().flat_map(Series::finite);
    let [low, high] = extent(points.map(|[_, hz]| hz)).unwrap_or([0.0; 2]);
    let near = |hz: &f64| (1.0 - NEAR) * low <= *hz && *hz <= (1.0 + NEAR) * high;
    let edges = bands.iter().flat_map(|band| band.range).filter(near);
    let [low, high] = extent(edges.chain([low, high])).unwrap_or([0.0; 2]);
    let room = (ROOM * (high - low)).max(LEAST_RANGE * high).max(1e-9);
    [(low - room).max(0.0), high + room]
}

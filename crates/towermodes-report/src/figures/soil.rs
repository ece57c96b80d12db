//! The first bending frequencies against the stiffness of the soil, or against the depth of scour.

use towermodes::number::Plain;
use towermodes::{Family, Rotor};
use towermodes_analysis::soil_band::{BandMode, ScourCurve, SoilBand};

use super::chart::{Axis, Chart, Series};
use crate::svg::{Figure, Numbers, extent};

const HEIGHT: f64 = 420.0;
/// Room above the highest and below the lowest frequency, as a fraction of their difference.
const ROOM: f64 = 0.25;
/// The axis covers at least this fraction of the frequency, so that a line looks flat if it is.
const LEAST_RANGE: f64 = 0.02;

/// The first bending frequencies against the factor of the soil stiffness.
pub fn soil(band: &SoilBand, rotor: Option<&Rotor>) -> Figure {
    let factors = band
        .factors
        .iter()
        .filter(|value| value.log2().fract() == 0.0);
    let numbers = factors.map(|value| (*value, Plain(*value).to_string()));
    let x = Axis {
        is_logarithmic: true,
        numbers: Numbers::At(numbers.collect()),
        ..Axis::linear(
            "factor on the stiffness of the soil (–)",
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
pub fn scour(curve: &ScourCurve, rotor: Option<&Rotor>) -> Figure {
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
    Figure {
        name: name.to_owned(),
        title: title.to_owned(),
        description: format!("Frequencies against {}: {}.", chart.x.name, each.join("; ")),
        drawing: chart.drawing(HEIGHT),
        table: chart.table("Hz"),
    }
}

/// The first bending modes, with the ranges of 1P and of the blade passing frequency in operation.
fn chart(x: Axis, values: &[f64], modes: &[BandMode], rotor: Option<&Rotor>) -> Chart {
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
    let operation = |rotor: &Rotor, multiple: usize| {
        let hz = [rotor.lowest_rpm, rotor.highest_rpm].map(|rpm| multiple as f64 * rpm / 60.0);
        (hz, format!("{multiple}P in operation"))
    };
    let bands = rotor.map(|rotor| [1, rotor.blades].map(|multiple| operation(rotor, multiple)));
    Chart {
        x,
        y: Axis::linear("natural frequency (Hz)", range_hz(&series)),
        bands: bands.into_iter().flatten().collect(),
        series,
        ..Chart::default()
    }
}

fn range_hz(series: &[Series]) -> [f64; 2] {
    let points = series.iter().flat_map(Series::finite);
    let [low, high] = extent(points.map(|[_, hz]| hz)).unwrap_or([0.0; 2]);
    let room = (ROOM * (high - low)).max(LEAST_RANGE * high).max(1e-9);
    [(low - room).max(0.0), high + room]
}

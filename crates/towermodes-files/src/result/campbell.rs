//! The excitations of a rotor and the natural frequencies, as JSON and as CSV.

use std::io::Write;

use serde::Serialize;
use towermodes::{Family, Tower, Warning};
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::{
    Campbell, Excited, FrequencyLine, Margin, ModeClass, StiffnessClass,
};
use towermodes_analysis::soil_band::SoilBand;

use super::{ResultError, write_records_csv, write_result_json};
use crate::input::Note;

/// The result of `towermodes campbell`: the diagram with the tower and the notes of the reader.
///
/// The rows of `margins` repeat the label of their line, and the multiple that crosses a mode is a
/// separate key; therefore lines, distances and classes have their own structures here.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct CampbellDocument<'a> {
    /// The worst verdict; at best `warn` if the list of modes does not cover all excitations;
    /// `undecided` if nothing is checked.
    verdict: Verdict,
    /// Why nothing is checked; empty if the distances are checked.
    not_checked: Vec<String>,
    /// The tower.
    tower: NamedJson<'a>,
    /// The rotor.
    rotor: RotorJson,
    /// The required distance, as a fraction of the natural frequency.
    margin: f64,
    /// The frequency range (from, to), Hz, in which the tower may have modes that are not in the
    /// list although an excitation comes close to them; null if the list covers all excitations.
    unjudged_hz: Option<[f64; 2]>,
    /// The multiples of the rotor speed.
    multiples: &'a [usize],
    /// Natural frequencies: tower modes by frequency, then blade modes.
    lines: Vec<LineJson<'a>>,
    /// The distance of every line from every multiple, except rigid-body modes without stiffness.
    margins: Vec<MarginJson<'a>>,
    /// The stiffness class of the lowest fore-aft and of the lowest side-side bending mode.
    classes: Vec<ClassJson>,
    /// Frequencies and verdicts for softer and stiffer soil; null without soil.
    soil_band: Option<&'a SoilBand>,
    /// Assumptions of the reader, data that it omits, and possible input mistakes.
    warnings: Vec<String>,
}

/// The tower that was solved.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct NamedJson<'a> {
    /// The name in the file; may be empty.
    pub(super) name: &'a str,
}

/// A rotor.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct RotorJson {
    /// Number of blades.
    blades: usize,
    /// Lowest operating speed, rpm; null if the operating speeds are unknown.
    lowest_rpm: Option<f64>,
    /// Highest operating speed, rpm; null if the operating speeds are unknown.
    highest_rpm: Option<f64>,
}

impl RotorJson {
    pub(super) fn of(campbell: &Campbell) -> Self {
        let rotor = campbell.rotor;
        let known = |rpm: f64| Some(rpm).filter(|_| campbell.speeds_are_known());
        Self {
            blades: rotor.blades,
            lowest_rpm: known(rotor.lowest_rpm),
            highest_rpm: known(rotor.highest_rpm),
        }
    }
}

/// Why nothing is checked.
pub(super) fn not_checked(campbell: &Campbell) -> Vec<String> {
    let reasons = campbell.not_checked.iter();
    reasons.map(ToString::to_string).collect()
}

/// A natural frequency against the rotor speed.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct LineJson<'a> {
    /// `tower` or `blade`.
    of: &'static str,
    /// Class of the mode, by its energy. Modes of the class `substructure` have no verdict.
    class: ModeClass,
    /// Its number in the list of tower modes, from 1; null for a blade.
    number: Option<usize>,
    /// Its family, as in the result of `solve`; for a blade mode the family at standstill: `flap`,
    /// `lag`, `torsion` or `axial`.
    family: String,
    /// Order within the family, from 1.
    order: usize,
    /// The name of the mode, for example "1st fore-aft bending".
    label: &'a str,
    /// Rotor speeds in increasing order, rpm.
    rotor_speed_rpm: Vec<f64>,
    /// The natural frequency at each rotor speed, Hz.
    frequency_hz: Vec<f64>,
    /// The largest estimated error of the frequencies, Hz.
    error_hz: f64,
    /// The rotor speed at which a blade mode is no longer found, rpm: its line ends before; null if
    /// it reaches the highest speed.
    lost_at_rpm: Option<f64>,
}

/// The distance of an excitation from a natural frequency in the operating range.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct MarginJson<'a> {
    /// Index of the line, from 0; for a turbine, index of the curve.
    line: usize,
    /// The name of its mode.
    label: &'a str,
    /// The multiple of the rotor speed.
    multiple: usize,
    /// The operating speed at which both are closest, rpm.
    nearest_rpm: f64,
    /// The excitation frequency at this rotor speed, Hz.
    excitation_hz: f64,
    /// The natural frequency at this rotor speed, Hz.
    natural_hz: f64,
    /// excitation/natural − 1 at this speed; 0 if the excitation crosses the natural frequency.
    distance: f64,
    /// The verdict on the distance.
    verdict: Verdict,
}

/// The stiffness class of a first bending mode.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct ClassJson {
    /// The plane of the mode: `fore-aft` or `side-side`.
    family: Family,
    /// `soft-soft`, `soft-stiff`, `stiff-stiff`, or `met` if 1P or the blade passing frequency
    /// crosses the mode in operation.
    class: &'static str,
    /// The multiple that crosses it; null otherwise.
    met_by_multiple: Option<usize>,
}

/// Writes a Campbell diagram as indented JSON with a newline at the end; the notes of the
/// reader come before the warnings.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_campbell_json(
    tower: &Tower,
    campbell: &Campbell,
    soil_band: Option<&SoilBand>,
    notes: &[Note],
    warnings: &[Warning],
    writer: impl Write,
) -> Result<(), ResultError> {
    let notes = notes.iter().map(ToString::to_string);
    let warnings = warnings.iter().map(ToString::to_string);
    let margins = campbell.margins.iter();
    let document = CampbellDocument {
        verdict: campbell.verdict(),
        not_checked: not_checked(campbell),
        tower: NamedJson { name: tower.name() },
        rotor: RotorJson::of(campbell),
        margin: campbell.margin,
        unjudged_hz: campbell.uncovered_range_hz(),
        multiples: &campbell.multiples,
        lines: campbell.lines.iter().map(line_json).collect(),
        margins: margins
            .map(|margin| margin_json(campbell, margin))
            .collect(),
        classes: campbell.classes.iter().map(class_json).collect(),
        soil_band,
        warnings: notes.chain(warnings).collect(),
    };
    write_result_json(&document, writer)
}

/// The class of the line (`tower`, `blade` or `turbine`), number, family or part, and order.
fn named(of: Excited) -> (&'static str, Option<usize>, String, usize) {
    match of {
        Excited::Tower {
            number,
            family,
            order,
            ..
        } => ("tower", Some(number), family.name().to_owned(), order),
        Excited::Blade { family, order } => ("blade", None, family.name().to_owned(), order),
        Excited::Turbine { name, .. } => ("turbine", None, name.part.to_string(), name.order),
    }
}

fn line_json(line: &FrequencyLine) -> LineJson<'_> {
    let (of, number, family, order) = named(line.of);
    LineJson {
        of,
        class: line.class(),
        number,
        family,
        order,
        label: &line.label,
        rotor_speed_rpm: line.points.iter().map(|[rpm, _]| *rpm).collect(),
        frequency_hz: line.points.iter().map(|[_, hz]| *hz).collect(),
        error_hz: line.error_hz,
        lost_at_rpm: line.lost.map(|end| end.rotor_speed_rpm),
    }
}

/// A distance with the index of its line, for a turbine with the index of its curve.
pub(super) fn margin_json<'a>(campbell: &'a Campbell, margin: &Margin) -> MarginJson<'a> {
    let line = &campbell.lines[margin.line];
    MarginJson {
        line: match line.of {
            Excited::Turbine { curve, .. } => curve,
            Excited::Tower { .. } | Excited::Blade { .. } => margin.line,
        },
        label: &line.label,
        multiple: margin.multiple,
        nearest_rpm: margin.nearest_rpm,
        excitation_hz: margin.excitation_hz,
        natural_hz: margin.natural_hz,
        distance: margin.distance,
        verdict: margin.verdict,
    }
}

pub(super) fn class_json((family, class): &(Family, StiffnessClass)) -> ClassJson {
    ClassJson {
        family: *family,
        class: class.name(),
        met_by_multiple: match *class {
            StiffnessClass::Coincident { multiple } => Some(multiple),
            _ => None,
        },
    }
}

/// The columns of the CSV.
const HEADER: [&str; 11] = [
    "of",
    "number",
    "family",
    "order",
    "label",
    "multiple",
    "nearest_rpm",
    "excitation_hz",
    "natural_hz",
    "distance",
    "verdict",
];

/// Writes a Campbell diagram as CSV: one line per pair of a natural frequency and an excitation.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_campbell_csv(campbell: &Campbell, writer: impl Write) -> Result<(), ResultError> {
    let row = |margin: &Margin| {
        let line = &campbell.lines[margin.line];
        let (of, number, family, order) = named(line.of);
        [
            of.to_owned(),
            number.map_or_else(String::new, |number| number.to_string()),
            family,
            order.to_string(),
            line.label.clone(),
            margin.multiple.to_string(),
            margin.nearest_rpm.to_string(),
            margin.excitation_hz.to_string(),
            margin.natural_hz.to_string(),
            margin.distance.to_string(),
            margin.verdict.name().to_owned(),
        ]
    };
    write_records_csv(HEADER, campbell.margins.iter().map(row), writer)
}

//! A rotor's excitations against natural frequencies, as JSON and as CSV.

use std::io::Write;

use schemars::JsonSchema;
use serde::Serialize;
use towermodes::{Family, Tower, Warning};
use towermodes_analysis::resonance::{Campbell, Excited, FrequencyLine, Margin, StiffnessClass};

use super::{ResultError, write_pretty};
use crate::input::Note;

/// The result of `towermodes campbell --format json`. Keys are stable: new ones may be added, none
/// is renamed.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "towermodes campbell")]
pub(super) struct CampbellJson<'a> {
    /// The worst verdict: `pass`, `warn` or `fail`; `warn` at best where modes are not judged.
    verdict: &'static str,
    /// The tower.
    tower: NamedJson<'a>,
    /// The rotor.
    rotor: RotorJson,
    /// The margin asked for, as a share of the natural frequency.
    margin: f64,
    /// From and to which frequency, Hz, the tower may have modes that are near an excitation but
    /// not in the list; null if they all are.
    unjudged_hz: Option<[f64; 2]>,
    /// The multiples of the rotor's speed.
    multiples: &'a [usize],
    /// Natural frequencies: modes of the tower by frequency, then those of the blade.
    lines: Vec<LineJson<'a>>,
    /// Every line against every multiple, but for motions that nothing resists.
    margins: Vec<MarginJson<'a>>,
    /// Where the lowest mode that bends the tower fore-aft lies, and that side-side; a coupled mode
    /// may be both.
    classes: Vec<ClassJson>,
    /// What the reader of the file decided or left out, and what looks like a slip.
    warnings: Vec<String>,
}

/// What was solved.
#[derive(Serialize, JsonSchema)]
struct NamedJson<'a> {
    /// The name in the file; may be empty.
    name: &'a str,
}

/// A rotor.
#[derive(Serialize, JsonSchema)]
struct RotorJson {
    /// Number of blades.
    blades: usize,
    /// Lowest speed of operation, rpm.
    lowest_rpm: f64,
    /// Highest speed of operation, rpm.
    highest_rpm: f64,
}

/// A natural frequency against the rotor's speed.
#[derive(Serialize, JsonSchema)]
struct LineJson<'a> {
    /// `tower` or `blade`.
    of: &'static str,
    /// Its number in the list of the tower's modes, from 1; null for a blade.
    number: Option<usize>,
    /// Its family, as in the result of `solve`; of a blade that at standstill: `flap`, `lag`,
    /// `torsion` or `axial`.
    family: &'static str,
    /// Order within the family, from 1.
    order: usize,
    /// What it is called, as "1st fore-aft bending".
    label: &'a str,
    /// Rotor speeds, rpm, rising.
    rotor_speed_rpm: Vec<f64>,
    /// The natural frequency at each, Hz.
    frequency_hz: Vec<f64>,
    /// The largest estimated error of the frequencies, Hz.
    error_hz: f64,
    /// The speed at which a mode of a blade was lost, rpm: none there is like it, and its line ends
    /// before; null if it goes on to the end.
    lost_at_rpm: Option<f64>,
}

/// How far an excitation stays from a natural frequency in operation.
#[derive(Serialize, JsonSchema)]
struct MarginJson<'a> {
    /// Which of the lines, from 0.
    line: usize,
    /// What it is called.
    label: &'a str,
    /// Which multiple of the rotor's speed.
    multiple: usize,
    /// The speed of operation at which they are nearest, rpm.
    nearest_rpm: f64,
    /// The excitation there, Hz.
    excitation_hz: f64,
    /// The natural frequency there, Hz.
    natural_hz: f64,
    /// excitation/natural − 1 there; 0 where they meet.
    distance: f64,
    /// `pass`, `warn` or `fail`.
    verdict: &'static str,
}

/// Where a first bending mode lies among the excitations.
#[derive(Serialize, JsonSchema)]
struct ClassJson {
    /// `fore-aft` or `side-side`.
    family: &'static str,
    /// `soft-soft`, `soft-stiff`, `stiff-stiff`, or `met` where an excitation meets it in
    /// operation.
    class: &'static str,
    /// The multiple that meets it; null otherwise.
    met_by_multiple: Option<usize>,
}

/// Writes a Campbell diagram as indented JSON with a newline at the end; what the reader of the
/// file noted comes before the warnings.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_campbell_json(
    tower: &Tower,
    campbell: &Campbell,
    notes: &[Note],
    warnings: &[Warning],
    writer: impl Write,
) -> Result<(), ResultError> {
    let notes = notes.iter().map(ToString::to_string);
    let warnings = warnings.iter().map(ToString::to_string);
    let json = CampbellJson {
        verdict: campbell.verdict().name(),
        tower: NamedJson { name: tower.name() },
        rotor: RotorJson {
            blades: campbell.rotor.blades,
            lowest_rpm: campbell.rotor.lowest_rpm,
            highest_rpm: campbell.rotor.highest_rpm,
        },
        margin: campbell.margin,
        unjudged_hz: campbell.uncovered_range_hz(),
        multiples: &campbell.multiples,
        lines: campbell.lines.iter().map(line_json).collect(),
        margins: campbell
            .margins
            .iter()
            .map(|margin| margin_json(campbell, margin))
            .collect(),
        classes: campbell.classes.iter().map(class_json).collect(),
        warnings: notes.chain(warnings).collect(),
    };
    write_pretty(&json, writer)
}

/// `tower` or `blade`, number, family, order.
fn named(of: Excited) -> (&'static str, Option<usize>, &'static str, usize) {
    match of {
        Excited::Tower {
            number,
            family,
            order,
        } => ("tower", Some(number), family.name(), order),
        Excited::Blade { family, order } => ("blade", None, family.name(), order),
    }
}

fn line_json(line: &FrequencyLine) -> LineJson<'_> {
    let (of, number, family, order) = named(line.of);
    LineJson {
        of,
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

fn margin_json<'a>(campbell: &'a Campbell, margin: &Margin) -> MarginJson<'a> {
    MarginJson {
        line: margin.line,
        label: &campbell.lines[margin.line].label,
        multiple: margin.multiple,
        nearest_rpm: margin.nearest_rpm,
        excitation_hz: margin.excitation_hz,
        natural_hz: margin.natural_hz,
        distance: margin.distance,
        verdict: margin.verdict.name(),
    }
}

fn class_json((family, class): &(Family, StiffnessClass)) -> ClassJson {
    ClassJson {
        family: family.name(),
        class: class.name(),
        met_by_multiple: match *class {
            StiffnessClass::Coincident { multiple } => Some(multiple),
            _ => None,
        },
    }
}

/// Writes a Campbell diagram as CSV: one line a pair of a natural frequency and an excitation.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_campbell_csv(campbell: &Campbell, writer: impl Write) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record([
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
    ])?;
    for margin in &campbell.margins {
        let line = &campbell.lines[margin.line];
        let (of, number, family, order) = named(line.of);
        csv.write_record([
            of,
            &number.map_or_else(String::new, |number| number.to_string()),
            family,
            &order.to_string(),
            &line.label,
            &margin.multiple.to_string(),
            &margin.nearest_rpm.to_string(),
            &margin.excitation_hz.to_string(),
            &margin.natural_hz.to_string(),
            &margin.distance.to_string(),
            margin.verdict.name(),
        ])?;
    }
    csv.flush()?;
    Ok(())
}

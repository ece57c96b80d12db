//! Reads a tower file of ElastoDyn, or of FAST 7.
//!
//! Source: OpenFAST reads it by position (`ReadTowerFile` in `ElastoDyn_IO.f90`) and makes the same
//! checks (`ValidateTowerData`).

use std::ops::Range;

use super::super::positional::{Parameter, Positional};
use super::super::record::{Kind, NON_NEGATIVE, POSITIVE, Record};
use super::rows::{check_cell, last_fraction, next_fraction, numbers};
use super::tower_file::{CoefficientSpans, ConcentratedMass, TowerFile, TowerRow};
use super::tower_records::{self as records, COLUMNS, MASS_COLUMNS};
use crate::diagnostic::Diagnostic;
use crate::note::Note;
use crate::records::Line;
use crate::source::Source;

/// The modes whose coefficients a file has.
const MODES: [&str; 4] = [
    "1st fore-aft",
    "2nd fore-aft",
    "1st side-side",
    "2nd side-side",
];

/// A fraction of the length.
const FRACTION: Kind = Kind::Number(|value| (0.0..=1.0).contains(&value), "from 0 to 1");

/// OpenFAST refuses coefficients whose sum differs from 1 by more than this.
const SUM_TOLERANCE: f64 = 0.0015;

/// The indices of the factors on mass and stiffness of the rows among all factors, in the order of
/// the columns.
const ADJUSTMENTS: [usize; 3] = [4, 5, 6];
/// Factors outside this range change a tower into another one.
const USUAL_ADJUSTMENTS: std::ops::RangeInclusive<f64> = 0.1..=10.0;

/// The byte ranges of the values in a tower file.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct TowerSpans {
    /// The byte range of the number of rows.
    pub(crate) count: Range<usize>,
    /// The values of each row in the order of the columns.
    pub(crate) rows: Vec<[Range<usize>; 4]>,
    /// Height and mass of each concentrated mass.
    pub(crate) masses: Vec<[Range<usize>; 2]>,
    pub(crate) coefficients: CoefficientSpans,
}

/// A tower file that was read.
#[derive(Debug, Clone)]
pub(crate) struct TowerReading {
    pub(crate) file: TowerFile,
    pub(crate) spans: TowerSpans,
    pub(crate) notes: Vec<Note>,
}

/// Reads a tower file of ElastoDyn, of any version of OpenFAST, or of FAST 7.
///
/// Mode shapes whose coefficients do not sum to 1 are read, with a note, although OpenFAST refuses
/// them: they can be replaced.
///
/// # Errors
/// The first mistake in it.
pub fn read_tower_file(
    source: &Source,
) -> Result<(TowerFile, CoefficientSpans, Vec<Note>), Diagnostic> {
    let TowerReading { file, spans, notes } = read_with_places(source)?;
    Ok((file, spans.coefficients, notes))
}

/// Reads a tower file with the places of all values.
pub(crate) fn read_with_places(source: &Source) -> Result<TowerReading, Diagnostic> {
    let mut lines = Positional::new(&source.text, records::all());
    let header = lines.header(&records::ROWS)?;
    lines.heading("the heading TOWER PARAMETERS")?;
    let count = lines.parameter(&records::ROWS)?;
    if lines.is_next(&records::CALC_MODE) {
        lines.parameter(&records::CALC_MODE)?;
    }
    let damping = values(&mut lines, &records::DAMPING)?;
    lines.heading("the heading TOWER ADJUSTMENT FACTORS")?;
    let factors = parameters(&mut lines, &records::FACTORS)?;
    let at = factors.clone().map(|(_, at)| at);
    let factors = factors.map(|(value, _)| value);
    let mut spans = TowerSpans {
        count: count.span(),
        ..TowerSpans::default()
    };
    let rows = rows(&mut lines, &count, &mut spans)?;
    let coefficients = coefficients(&mut lines, &mut spans)?;
    let concentrated_masses = concentrated_masses(&mut lines, &mut spans)?;
    let mut notes = notes_on_sums(source, &coefficients, &spans.coefficients);
    for (column, index) in (1..).zip(ADJUSTMENTS) {
        let (value, name) = (factors[index], records::FACTORS[index].name);
        if !USUAL_ADJUSTMENTS.contains(&value) {
            notes.push(on_adjustment(name, value).at(source, at[index].start));
            // What looks wrong in the product is wrong because of the factor.
            spans
                .rows
                .iter_mut()
                .for_each(|row| row[column] = at[index].clone());
        }
    }
    let file = TowerFile {
        header,
        fore_aft_damping_percent: [damping[0], damping[1]],
        side_side_damping_percent: [damping[2], damping[3]],
        fore_aft_tuners: [factors[0], factors[1]],
        side_side_tuners: [factors[2], factors[3]],
        mass_factor: factors[4],
        fore_aft_factor: factors[5],
        side_side_factor: factors[6],
        rows,
        coefficients,
        concentrated_masses,
    };
    Ok(TowerReading { file, spans, notes })
}

/// The note on an adjustment factor that is far from 1.
fn on_adjustment(name: &str, value: f64) -> Note {
    Note::suspicious(format!(
        "{name} is {value} and multiplies its column in all rows; an adjustment factor is about 1, at least {} and at most {}: check it before the rows",
        USUAL_ADJUSTMENTS.start(),
        USUAL_ADJUSTMENTS.end()
    ))
}

/// The numbers of successive parameters.
fn values<const N: usize>(
    lines: &mut Positional<'_>,
    records: &[Record; N],
) -> Result<[f64; N], Diagnostic> {
    Ok(parameters(lines, records)?.map(|(value, _)| value))
}

/// The numbers of successive parameters with their places.
fn parameters<const N: usize>(
    lines: &mut Positional<'_>,
    records: &[Record; N],
) -> Result<[(f64, Range<usize>); N], Diagnostic> {
    let mut found = std::array::from_fn(|_| (0.0, 0..0));
    for (found, record) in found.iter_mut().zip(records) {
        let parameter = lines.parameter(record)?;
        *found = (parameter.number()?, parameter.span());
    }
    Ok(found)
}

/// The distributed properties.
fn rows(
    lines: &mut Positional<'_>,
    count: &Parameter<'_>,
    spans: &mut TowerSpans,
) -> Result<Vec<TowerRow>, Diagnostic> {
    let wanted = count.count()?;
    lines.heading("the heading DISTRIBUTED TOWER PROPERTIES")?;
    lines.heading("the names of the columns")?;
    lines.heading("the units of the columns")?;
    let mut rows: Vec<TowerRow> = Vec::new();
    while rows.len() < wanted {
        let line = lines.row("the distributed properties", rows.len(), count)?;
        let name = format!("row {}", rows.len() + 1);
        let (row, span) = row(&line, &name, rows.last())?;
        rows.push(row);
        spans.rows.push(span);
    }
    // A single row, at 0, is that of a uniform tower.
    if let ([_, .., row], Some([span, ..])) = (rows.as_mut_slice(), spans.rows.last()) {
        row.height_fraction = last_fraction(row.height_fraction, span.clone(), "HtFract")?;
    }
    Ok(rows)
}

/// A row and the places of its values; its name is for messages.
fn row(
    line: &Line<'_>,
    name: &str,
    before: Option<&TowerRow>,
) -> Result<(TowerRow, [Range<usize>; 4]), Diagnostic> {
    let columns = COLUMNS.map(|(column, _)| column);
    let values = numbers(line, name, columns)?;
    for ((value, token), column) in values.iter().zip(columns).skip(1) {
        check_cell(token, format!("{column} of {name}"), *value, POSITIVE)?;
    }
    let previous = before.map(|row| row.height_fraction);
    let height_fraction = next_fraction(values[0].0, &values[0].1, previous, "HtFract")?;
    let row = TowerRow {
        height_fraction,
        mass_kg_per_m: values[1].0,
        fore_aft_n_m2: values[2].0,
        side_side_n_m2: values[3].0,
    };
    Ok((row, values.map(|(_, token)| token.span)))
}

/// The coefficients of the four mode shapes.
fn coefficients(
    lines: &mut Positional<'_>,
    spans: &mut TowerSpans,
) -> Result<[[f64; 5]; 4], Diagnostic> {
    let mut coefficients = [[0.0; 5]; 4];
    for (mode, records) in records::COEFFICIENTS.iter().enumerate() {
        if mode == 0 {
            lines.heading("the heading TOWER FORE-AFT MODE SHAPES, after the rows,")?;
        } else if mode == 2 {
            lines.heading("the heading TOWER SIDE-TO-SIDE MODE SHAPES")?;
        }
        let places = coefficients[mode]
            .iter_mut()
            .zip(&mut spans.coefficients[mode]);
        for (record, (coefficient, span)) in records.iter().zip(places) {
            let parameter = lines.parameter(record)?;
            *coefficient = parameter.number()?;
            *span = parameter.span();
        }
    }
    Ok(coefficients)
}

/// The section of concentrated masses, in files for OpenFAST 4.2 and later.
fn concentrated_masses(
    lines: &mut Positional<'_>,
    spans: &mut TowerSpans,
) -> Result<Vec<ConcentratedMass>, Diagnostic> {
    let mut masses = Vec::new();
    if !has_masses(lines) {
        return Ok(masses);
    }
    lines.heading("the heading TOWER CONCENTRATED MASSES")?;
    let count = lines.parameter(&records::MASSES)?;
    let wanted = count.count()?;
    if wanted > 0 {
        lines.heading("the names of the columns")?;
        lines.heading("the units of the columns")?;
    }
    while masses.len() < wanted {
        let line = lines.row("the concentrated masses", masses.len(), &count)?;
        let name = format!("concentrated mass {}", masses.len() + 1);
        let values = numbers(&line, &name, MASS_COLUMNS.map(|(column, _)| column))?;
        let [(height_fraction, height), (mass_kg, mass)] = &values;
        check_cell(
            height,
            format!("HtFract of {name}"),
            *height_fraction,
            FRACTION,
        )?;
        check_cell(mass, format!("TwCMass of {name}"), *mass_kg, NON_NEGATIVE)?;
        masses.push(ConcentratedMass {
            height_fraction: *height_fraction,
            mass_kg: *mass_kg,
        });
        spans.masses.push(values.map(|(_, token)| token.span));
    }
    Ok(masses)
}

/// Whether the next line that is not blank is the heading of the concentrated masses.
fn has_masses(lines: &mut Positional<'_>) -> bool {
    lines.skip_blank();
    lines.peek().is_some_and(|line| {
        let start: String = line.text.chars().take(200).collect();
        start.to_ascii_uppercase().contains("CONCENTRATED")
    })
}

/// The notes on sums of coefficients that OpenFAST refuses.
fn notes_on_sums(
    source: &Source,
    coefficients: &[[f64; 5]; 4],
    spans: &CoefficientSpans,
) -> Vec<Note> {
    let modes = coefficients.iter().zip(spans).zip(MODES);
    let off = modes.filter_map(|((mode, spans), name)| {
        let sum: f64 = mode.iter().sum();
        let is_off = sum.is_nan() || (sum - 1.0).abs() > SUM_TOLERANCE;
        is_off.then(|| {
            let message = format!(
                "the coefficients of the {name} mode sum to {sum:.6} instead of 1; OpenFAST refuses a difference of more than {SUM_TOLERANCE}"
            );
            Note::suspicious(message).at(source, spans[0].start)
        })
    });
    off.collect()
}

//! Reads a tower file of ElastoDyn, or of FAST 7.
//!
//! OpenFAST reads it by position (`ReadTowerFile` in `ElastoDyn_IO.f90`) and refuses what is
//! refused here (`ValidateTowerData`).

use std::ops::Range;

use super::names::name_on;
use super::positional::{Parameter, Positional, last_fraction, next_fraction, numbers};
use super::tower_file::{CoefficientSpans, ConcentratedMass, TowerFile, TowerRow};
use crate::diagnostic::Diagnostic;
use crate::input::Note;
use crate::source::Source;

/// The names of all parameters of a tower file.
const KEYS: &[&str] = &[
    "NTwInpSt",
    "CalcTMode",
    "TwrFADmp(1)",
    "TwrFADmp(2)",
    "TwrSSDmp(1)",
    "TwrSSDmp(2)",
    "FAStTunr(1)",
    "FAStTunr(2)",
    "SSStTunr(1)",
    "SSStTunr(2)",
    "AdjTwMa",
    "AdjFASt",
    "AdjSSSt",
    "TwFAM1Sh(2)",
    "TwFAM1Sh(3)",
    "TwFAM1Sh(4)",
    "TwFAM1Sh(5)",
    "TwFAM1Sh(6)",
    "TwFAM2Sh(2)",
    "TwFAM2Sh(3)",
    "TwFAM2Sh(4)",
    "TwFAM2Sh(5)",
    "TwFAM2Sh(6)",
    "TwSSM1Sh(2)",
    "TwSSM1Sh(3)",
    "TwSSM1Sh(4)",
    "TwSSM1Sh(5)",
    "TwSSM1Sh(6)",
    "TwSSM2Sh(2)",
    "TwSSM2Sh(3)",
    "TwSSM2Sh(4)",
    "TwSSM2Sh(5)",
    "TwSSM2Sh(6)",
    "NTwCMass",
];

/// Where damping, factors and coefficients begin in [`KEYS`].
const FIRST_DAMPING: usize = 2;
const FIRST_FACTOR: usize = 6;
const FIRST_COEFFICIENT: usize = 13;

/// The modes whose coefficients a file has.
const MODES: [&str; 4] = [
    "1st fore-aft",
    "2nd fore-aft",
    "1st side-side",
    "2nd side-side",
];

/// OpenFAST refuses coefficients whose sum is further from 1.
const SUM_TOLERANCE: f64 = 0.0015;

const COLUMNS: [&str; 4] = ["HtFract", "TMassDen", "TwFAStif", "TwSSStif"];
const MASS_COLUMNS: [&str; 2] = ["HtFract", "TwCMass"];

/// Where the values of a tower file stand, bytes.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct TowerSpans {
    /// The number of rows.
    pub(super) count: Range<usize>,
    /// Each row's values in the order of the columns.
    pub(super) rows: Vec<[Range<usize>; 4]>,
    /// Each concentrated mass's height and mass.
    pub(super) masses: Vec<[Range<usize>; 2]>,
    pub(super) coefficients: CoefficientSpans,
}

/// What reading a tower file gives.
#[derive(Debug, Clone)]
pub(super) struct TowerReading {
    pub(super) file: TowerFile,
    pub(super) spans: TowerSpans,
    pub(super) notes: Vec<Note>,
}

/// Reads a tower file of ElastoDyn, of any version of OpenFAST, or of FAST 7.
///
/// Mode shapes whose coefficients do not sum to 1 are read, with a note, though OpenFAST refuses
/// them: they are there to be replaced.
///
/// # Errors
/// The first mistake in it.
pub fn read_tower_file(
    source: &Source,
) -> Result<(TowerFile, CoefficientSpans, Vec<Note>), Diagnostic> {
    let TowerReading { file, spans, notes } = read_with_places(source)?;
    Ok((file, spans.coefficients, notes))
}

/// The same with the places of all values.
pub(super) fn read_with_places(source: &Source) -> Result<TowerReading, Diagnostic> {
    let mut lines = Positional::new(&source.text, KEYS);
    let header = lines.header("NTwInpSt")?;
    lines.heading("the heading TOWER PARAMETERS")?;
    let count = lines.parameter("NTwInpSt", "number of rows")?;
    if lines
        .peek_filled()
        .and_then(|line| name_on(&line))
        .as_deref()
        == Some("calctmode")
    {
        lines.parameter("CalcTMode", "flag of FAST 7")?;
    }
    let mut damping = [0.0; 4];
    for (ratio, key) in damping.iter_mut().zip(&KEYS[FIRST_DAMPING..FIRST_FACTOR]) {
        *ratio = damping_ratio(&lines.parameter(key, "damping, percent of critical")?)?;
    }
    lines.heading("the heading TOWER ADJUSTMENT FACTORS")?;
    let factors = factors(&mut lines)?;
    let mut spans = TowerSpans {
        count: count.span(),
        ..TowerSpans::default()
    };
    let rows = rows(&mut lines, &count, &mut spans)?;
    let coefficients = coefficients(&mut lines, &mut spans)?;
    let concentrated_masses = concentrated_masses(&mut lines, &mut spans)?;
    let notes = notes_on_sums(source, &coefficients, &spans.coefficients);
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

fn damping_ratio(parameter: &Parameter<'_>) -> Result<f64, Diagnostic> {
    let within = |value: f64| (0.0..=100.0).contains(&value);
    parameter.number_if(within, "it must be from 0 to 100 percent")
}

/// The tuners of the modal stiffnesses and the factors of the columns.
fn factors(lines: &mut Positional<'_>) -> Result<[f64; 7], Diagnostic> {
    let mut values = [0.0; 7];
    for (value, key) in values
        .iter_mut()
        .zip(&KEYS[FIRST_FACTOR..FIRST_COEFFICIENT])
    {
        *value = lines.parameter(key, "factor")?.positive()?;
    }
    Ok(values)
}

/// The distributed properties.
fn rows(
    lines: &mut Positional<'_>,
    count: &Parameter<'_>,
    spans: &mut TowerSpans,
) -> Result<Vec<TowerRow>, Diagnostic> {
    let wanted = count.count(1)?;
    lines.heading("the heading DISTRIBUTED TOWER PROPERTIES")?;
    lines.heading("the names of the columns")?;
    lines.heading("the units of the columns")?;
    let mut rows: Vec<TowerRow> = Vec::new();
    while rows.len() < wanted {
        let line = lines.row("the distributed properties", rows.len(), count)?;
        let name = format!("row {}", rows.len() + 1);
        let values = numbers(&line, &name, COLUMNS)?;
        for ((value, token), column) in values.iter().zip(COLUMNS).skip(1) {
            if *value <= 0.0 {
                let message = format!("{column} of {name} is {}", token.text);
                let mistake = Diagnostic::new(token.span.clone(), message);
                return Err(mistake.with_hint("it must be greater than 0"));
            }
        }
        let [
            (height, token),
            (mass_kg_per_m, _),
            (fore_aft_n_m2, _),
            (side_side_n_m2, _),
        ] = &values;
        let previous = rows.last().map(|row| row.height_fraction);
        rows.push(TowerRow {
            height_fraction: next_fraction(*height, token, previous, "HtFract")?,
            mass_kg_per_m: *mass_kg_per_m,
            fore_aft_n_m2: *fore_aft_n_m2,
            side_side_n_m2: *side_side_n_m2,
        });
        spans.rows.push(values.map(|(_, token)| token.span));
    }
    // A single row, at 0, is that of a uniform tower.
    if let ([_, .., row], Some([span, ..])) = (rows.as_mut_slice(), spans.rows.last()) {
        row.height_fraction = last_fraction(row.height_fraction, span.clone(), "HtFract")?;
    }
    Ok(rows)
}

/// The coefficients of the four mode shapes.
fn coefficients(
    lines: &mut Positional<'_>,
    spans: &mut TowerSpans,
) -> Result<[[f64; 5]; 4], Diagnostic> {
    let mut coefficients = [[0.0; 5]; 4];
    for mode in 0..4 {
        if mode == 0 {
            lines.heading("the heading TOWER FORE-AFT MODE SHAPES, after the rows,")?;
        } else if mode == 2 {
            lines.heading("the heading TOWER SIDE-TO-SIDE MODE SHAPES")?;
        }
        for power in 0..5 {
            let key = KEYS[FIRST_COEFFICIENT + 5 * mode + power];
            let parameter = lines.parameter(key, "coefficient of a mode shape")?;
            coefficients[mode][power] = parameter.number()?;
            spans.coefficients[mode][power] = parameter.span();
        }
    }
    Ok(coefficients)
}

/// The section of concentrated masses, which files for OpenFAST before 4.2 do not have.
fn concentrated_masses(
    lines: &mut Positional<'_>,
    spans: &mut TowerSpans,
) -> Result<Vec<ConcentratedMass>, Diagnostic> {
    lines.skip_blank();
    let is_there = lines.peek().is_some_and(|line| {
        let start = line.text.chars().take(200).collect::<String>();
        start.to_ascii_uppercase().contains("CONCENTRATED")
    });
    let mut masses = Vec::new();
    if !is_there {
        return Ok(masses);
    }
    lines.heading("the heading TOWER CONCENTRATED MASSES")?;
    let count = lines.parameter("NTwCMass", "number of concentrated masses")?;
    let wanted = count.count(0)?;
    if wanted == 0 {
        return Ok(masses);
    }
    lines.heading("the names of the columns")?;
    lines.heading("the units of the columns")?;
    while masses.len() < wanted {
        let line = lines.row("the concentrated masses", masses.len(), &count)?;
        let name = format!("concentrated mass {}", masses.len() + 1);
        let values = numbers(&line, &name, MASS_COLUMNS)?;
        let [(height_fraction, height), (mass_kg, mass)] = &values;
        if !(0.0..=1.0).contains(height_fraction) {
            let message = format!("HtFract of {name} is {}", height.text);
            let mistake = Diagnostic::new(height.span.clone(), message);
            return Err(mistake.with_hint("it must be from 0 to 1"));
        }
        if *mass_kg < 0.0 {
            let message = format!("TwCMass of {name} is {}", mass.text);
            let mistake = Diagnostic::new(mass.span.clone(), message);
            return Err(mistake.with_hint("it must not be negative"));
        }
        masses.push(ConcentratedMass {
            height_fraction: *height_fraction,
            mass_kg: *mass_kg,
        });
        spans.masses.push(values.map(|(_, token)| token.span));
    }
    Ok(masses)
}

/// What OpenFAST would say of the sums of the coefficients.
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
                "the coefficients of the {name} mode sum to {sum:.6} instead of 1: OpenFAST refuses more than {SUM_TOLERANCE} off"
            );
            Note::at(source, spans[0].start, message)
        })
    });
    off.collect()
}

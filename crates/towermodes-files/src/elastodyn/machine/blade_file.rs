//! Blade files of ElastoDyn and FAST 7: mass, stiffness and twist along the blade.
//!
//! OpenFAST reads them by position (`ReadBladeFile` in `ElastoDyn_IO.f90`). The number of columns
//! changed from seventeen (FAST 7) to six (FAST 8) to five (OpenFAST 5, without `PitchAxis`). The
//! line of names shows the mass column; the twist precedes it and both stiffnesses follow it.

use std::ops::Range;

use super::super::names::plain;
use super::super::positional::{Parameter, Positional};
use super::super::record::{Kind, POSITIVE, Record, record};
use super::super::tower_input::rows::{check_cell, last_fraction, next_fraction};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::records::{Line, Token};
use crate::source::Source;

/// The record before the table of a blade file.
const ROWS: Record = record("NBlInpSt", "number of rows", Kind::Count(1));
const CALC_MODE: Record = record("CalcBMode", "flag of FAST 7", Kind::Other);
const DAMPING: [Record; 3] = [
    record("BldFlDmp(1)", "damping, percent of critical", Kind::Other),
    record("BldFlDmp(2)", "damping, percent of critical", Kind::Other),
    record("BldEdDmp(1)", "damping, percent of critical", Kind::Other),
];
const TUNERS: [Record; 2] = [
    record("FlStTunr(1)", "stiffness tuner", Kind::Other),
    record("FlStTunr(2)", "stiffness tuner", Kind::Other),
];
/// Factors on the columns of mass, flapwise and edgewise stiffness.
const FACTORS: [Record; 3] = [
    record("AdjBlMs", "factor of the masses", POSITIVE),
    record("AdjFlSt", "factor of the flapwise stiffness", POSITIVE),
    record("AdjEdSt", "factor of the edgewise stiffness", POSITIVE),
];

/// The properties of a blade along its length.
#[derive(Debug, Clone, PartialEq)]
pub struct BladeFile {
    /// Factor of the column of masses (`AdjBlMs`).
    pub mass_factor: f64,
    /// Factor of the column of flapwise stiffnesses (`AdjFlSt`).
    pub flap_factor: f64,
    /// Factor of the column of edgewise stiffnesses (`AdjEdSt`).
    pub edge_factor: f64,
    /// The table as written, without the factors; linear between rows. For a uniform blade the
    /// single row of the file is used at both ends.
    pub rows: Vec<BladeRow>,
}

/// A row of a blade's table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BladeRow {
    /// Distance from the root as a fraction of the blade's length, 0 to 1 (`BlFract`).
    pub length_fraction: f64,
    /// Mass per length, kg/m (`BMassDen`).
    pub mass_kg_per_m: f64,
    /// Structural twist, positive towards feather, degrees (`StrcTwst`).
    pub twist_deg: f64,
    /// Flapwise stiffness, N m² (`FlpStff`).
    pub flap_n_m2: f64,
    /// Edgewise stiffness, N m² (`EdgStff`).
    pub edge_n_m2: f64,
}

/// Mass of a blade and its moments about the root.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BladeMasses {
    /// Mass ∫ μ dr, kg.
    pub mass_kg: f64,
    /// First moment ∫ μ r dr, kg m.
    pub first_moment_kg_m: f64,
    /// Second moment ∫ μ r² dr, kg m².
    pub second_moment_kg_m2: f64,
}

impl BladeFile {
    /// The integrals along a blade of this length, m, exact for a mass per length that is linear
    /// between the rows.
    ///
    /// ElastoDyn itself uses `BldNodes` elements with the mass at their middles; the difference is
    /// some thousandths.
    pub fn masses(&self, length_m: f64) -> BladeMasses {
        let mut sum = BladeMasses::default();
        for pair in self.rows.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|row| row.length_fraction);
            let [p, q] = [pair[0], pair[1]].map(|row| self.mass_factor * row.mass_kg_per_m);
            let h = b - a;
            // With s from 0 to 1 across the piece: ∫ (p + (q − p) s) (a + h s)^n h ds.
            let (zeroth, first, second) =
                (0.5 * (p + q), (p + 2.0 * q) / 6.0, (p + 3.0 * q) / 12.0);
            sum.mass_kg += h * zeroth;
            sum.first_moment_kg_m += h * (a * zeroth + h * first);
            sum.second_moment_kg_m2 += h * (a * a * zeroth + 2.0 * a * h * first + h * h * second);
        }
        BladeMasses {
            mass_kg: length_m * sum.mass_kg,
            first_moment_kg_m: length_m.powi(2) * sum.first_moment_kg_m,
            second_moment_kg_m2: length_m.powi(3) * sum.second_moment_kg_m2,
        }
    }
}

/// Reads a blade file of ElastoDyn, of any version of OpenFAST, or of FAST 7.
///
/// # Errors
/// The first mistake in it.
pub fn read_blade_file(source: &Source) -> Result<BladeFile, Diagnostic> {
    let single = [&ROWS, &CALC_MODE].into_iter();
    let all = single.chain(&DAMPING).chain(&TUNERS).chain(&FACTORS);
    let mut lines = Positional::new(&source.text, all);
    lines.header(&ROWS)?;
    lines.heading("the heading BLADE PARAMETERS")?;
    let count = lines.parameter(&ROWS)?;
    let wanted = count.count()?;
    if lines.is_next(&CALC_MODE) {
        lines.parameter(&CALC_MODE)?;
    }
    // Public writers give the dampings wrong names; they are not used.
    for record in &DAMPING {
        lines.unnamed_parameter(record)?;
    }
    lines.heading("the heading BLADE ADJUSTMENT FACTORS")?;
    for record in &TUNERS {
        lines.parameter(record)?;
    }
    let mut factor = |record| lines.parameter(record)?.number();
    Ok(BladeFile {
        mass_factor: factor(&FACTORS[0])?,
        flap_factor: factor(&FACTORS[1])?,
        edge_factor: factor(&FACTORS[2])?,
        rows: rows(&mut lines, &count, wanted)?,
    })
}

/// Reads the distributed properties.
fn rows(
    lines: &mut Positional<'_>,
    count: &Parameter<'_>,
    wanted: usize,
) -> Result<Vec<BladeRow>, Diagnostic> {
    lines.heading("the heading DISTRIBUTED BLADE PROPERTIES")?;
    let names = lines.heading("the names of the columns")?;
    lines.heading("the units of the columns")?;
    let mut rows: Vec<BladeRow> = Vec::new();
    let mut last = 0..0;
    while rows.len() < wanted {
        let line = lines.row("the distributed properties", rows.len(), count)?;
        let before = rows.last().map(|row| row.length_fraction);
        let (row, span) = row(&line, &names, rows.len(), before)?;
        rows.push(row);
        last = span;
    }
    match rows.as_mut_slice() {
        // A single row is that of a uniform blade.
        [only] => {
            let tip = BladeRow {
                length_fraction: 1.0,
                ..*only
            };
            rows.push(tip);
        }
        [.., row] => row.length_fraction = last_fraction(row.length_fraction, last, "BlFract")?,
        [] => {}
    }
    Ok(rows)
}

/// A row, and the place of its fraction of the length; `names` are those of the columns.
fn row(
    line: &Line<'_>,
    names: &Line<'_>,
    index: usize,
    before: Option<f64>,
) -> Result<(BladeRow, Range<usize>), Diagnostic> {
    let tokens: Vec<Token<'_>> = line.tokens().take(MOST_COLUMNS).collect();
    let (fraction, token) = cell(line, &tokens, 0, "BlFract")?;
    let mass = mass_column(names, tokens.len());
    let positive = |column, name| positive_cell(line, &tokens, column, name, index);
    let mass_kg_per_m = positive(mass, "BMassDen")?;
    let flap_n_m2 = positive(mass + 1, "FlpStff")?;
    let edge_n_m2 = positive(mass + 2, "EdgStff")?;
    let (twist_deg, _) = cell(line, &tokens, mass.saturating_sub(1), "StrcTwst")?;
    let row = BladeRow {
        length_fraction: next_fraction(fraction, token, before, "BlFract")?,
        mass_kg_per_m,
        twist_deg,
        flap_n_m2,
        edge_n_m2,
    };
    Ok((row, token.span.clone()))
}

/// Columns beyond those of FAST 7 are ignored.
const MOST_COLUMNS: usize = 20;

/// The index of the mass column: the column of that name, otherwise the third of five columns or
/// the fourth of more.
fn mass_column(names: &Line<'_>, columns: usize) -> usize {
    let mut names = names.tokens().take(MOST_COLUMNS);
    let named = names.position(|token| plain(token.text) == "bmassden");
    named.unwrap_or(if columns == 5 { 2 } else { 3 })
}

/// A number of a row that must be positive.
fn positive_cell(
    line: &Line<'_>,
    tokens: &[Token<'_>],
    column: usize,
    name: &str,
    row: usize,
) -> Result<f64, Diagnostic> {
    let (value, token) = cell(line, tokens, column, name)?;
    check_cell(token, format!("{name} of row {}", row + 1), value, POSITIVE)?;
    Ok(value)
}

/// A number of a row.
fn cell<'t, 'a>(
    line: &Line<'_>,
    tokens: &'t [Token<'a>],
    column: usize,
    name: &str,
) -> Result<(f64, &'t Token<'a>), Diagnostic> {
    match tokens.get(column) {
        Some(token) => Ok((token.number(name)?, token)),
        None => {
            let kind = DiagnosticKind::wrong_count_of("numbers", "the row", tokens.len(), "5 or 6");
            let hint = format!("{name} is number {}", column + 1);
            Err(Diagnostic::new(line.span(), kind).with_hint(hint))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{BladeFile, BladeRow};

    #[test]
    fn a_linear_blade_has_the_integrals_of_a_trapezoid() {
        let row = |length_fraction, mass_kg_per_m| BladeRow {
            length_fraction,
            mass_kg_per_m,
            twist_deg: 0.0,
            flap_n_m2: 1.0,
            edge_n_m2: 1.0,
        };
        // μ = 2 (10 − r/3) on 0 to 30 m, in two pieces: ∫ μ = 300, ∫ μ r = 3000, ∫ μ r² = 45000.
        let rows = vec![row(0.0, 10.0), row(0.25, 7.5), row(1.0, 0.0)];
        let blade = BladeFile {
            mass_factor: 2.0,
            flap_factor: 1.0,
            edge_factor: 1.0,
            rows,
        };
        let masses = blade.masses(30.0);
        assert!((masses.mass_kg - 300.0).abs() < 1e-10);
        assert!((masses.first_moment_kg_m - 3000.0).abs() < 1e-9);
        assert!((masses.second_moment_kg_m2 - 45000.0).abs() < 1e-8);
    }
}

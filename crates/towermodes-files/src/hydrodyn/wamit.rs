//! The files of WAMIT that HydroDyn reads: `.1`, the added mass by period, and `.hst`, the
//! hydrostatic stiffness.
//!
//! Source: WAMIT User Manual, ch. 4 (output files); `WAMIT.f90` (OpenFAST): a negative period is
//! the zero frequency, the period zero the infinite frequency, and entries that are absent are
//! zero.

use std::collections::BTreeMap;

use towermodes::AddedMassTable;
use towermodes::space::SpatialMatrix;

use super::spatial::NONE;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::records::{Line, Lines, Token};
use crate::source::Source;

/// Largest number of periods of a file.
const MOST_PERIODS: usize = 20_000;

/// The matrix for a period, and the entries that the file contains.
#[derive(Debug, Clone)]
struct Entries {
    matrix: SpatialMatrix,
    given: [[bool; 6]; 6],
}

impl Entries {
    const EMPTY: Self = Self {
        matrix: NONE,
        given: [[false; 6]; 6],
    };

    fn set(&mut self, (i, j): (usize, usize), value: f64) -> bool {
        self.matrix[i][j] = value;
        !std::mem::replace(&mut self.given[i][j], true)
    }

    fn has_lower(&self) -> bool {
        (0..6).any(|i| (0..i).any(|j| self.given[i][j]))
    }

    /// The matrix with the upper triangle copied to the lower one.
    fn mirrored(&self) -> SpatialMatrix {
        let entry = |i: usize, j: usize| self.matrix[i.min(j)][i.max(j)];
        std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
    }
}

/// The content of a file.
pub(super) struct Read<T> {
    pub(super) content: T,
    /// Whether the file contains only the entries on and above the diagonal.
    pub(super) is_upper_triangle: bool,
}

/// Reads a `.1` file: nondimensional added mass, not yet symmetric.
pub(super) fn read_added_mass(source: &Source) -> Result<Read<AddedMassTable>, Diagnostic> {
    let periods = periods(&source.text)?;
    check_diagonal(&periods)?;
    let is_upper_triangle = !periods.values().any(Entries::has_lower)
        && periods
            .values()
            .any(|entries| entries.mirrored() != entries.matrix);
    let matrix = |entries: &Entries| match is_upper_triangle {
        true => entries.mirrored(),
        false => entries.matrix,
    };
    let find = |at: Frequency, what: &str| {
        let missing = || {
            let what = format!("the added mass at {what}");
            Diagnostic::new(0..0, DiagnosticKind::Missing { what }).with_hint(
                "HydroDyn needs both limits: lines with the period -1 (zero frequency) and with the period 0 (infinite frequency), as WAMIT writes them if its list of periods has -1 and 0",
            )
        };
        periods.get(&at).map(matrix).ok_or_else(missing)
    };
    let mut rows: Vec<(f64, SpatialMatrix)> = Vec::new();
    for (frequency, entries) in &periods {
        if let Frequency::Finite(bits) = frequency {
            rows.push((f64::from_bits(*bits), matrix(entries)));
        }
    }
    let content = AddedMassTable {
        zero: find(Frequency::Zero, "zero frequency")?,
        rows,
        infinite: find(Frequency::Infinite, "infinite frequency")?,
    };
    Ok(Read {
        content,
        is_upper_triangle,
    })
}

/// Checks that a diagonal entry that the file has for some periods exists for all periods.
fn check_diagonal(periods: &BTreeMap<Frequency, Entries>) -> Result<(), Diagnostic> {
    for i in 0..6 {
        let has = |entries: &Entries| entries.given[i][i];
        let lacks = periods.iter().find(|(_, entries)| !has(entries));
        let Some((frequency, _)) = lacks.filter(|_| periods.values().any(has)) else {
            continue;
        };
        let at = match frequency {
            Frequency::Zero => "zero frequency".to_owned(),
            Frequency::Infinite => "infinite frequency".to_owned(),
            Frequency::Finite(bits) => {
                format!("{:.6} rad/s", f64::from_bits(*bits))
            }
        };
        let what = format!("entry ({0}, {0}) of the added mass at {at}", i + 1);
        let mistake = Diagnostic::new(0..0, DiagnosticKind::Missing { what });
        return Err(mistake.with_hint("the file has this entry at other periods: add the line"));
    }
    Ok(())
}

/// A frequency as a sort key; positive numbers are in the order of their bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Frequency {
    Zero,
    Finite(u64),
    Infinite,
}

impl Frequency {
    fn of_period(token: &Token<'_>) -> Result<Self, Diagnostic> {
        let period_s = token.number("the period (s)")?;
        if period_s < 0.0 {
            return Ok(Self::Zero);
        }
        if period_s == 0.0 {
            return Ok(Self::Infinite);
        }
        let angular = std::f64::consts::TAU / period_s;
        match angular.is_finite() && angular > 0.0 {
            true => Ok(Self::Finite(angular.to_bits())),
            false => Err(token.wrong(DiagnosticKind::Overflow {
                what: "the angular frequency of this period".to_owned(),
            })),
        }
    }
}

fn periods(text: &str) -> Result<BTreeMap<Frequency, Entries>, Diagnostic> {
    let mut periods: BTreeMap<Frequency, Entries> = BTreeMap::new();
    for line in numeric_lines(text) {
        let tokens: Vec<Token<'_>> = line.tokens().take(5).collect();
        check_count(
            &line,
            &tokens,
            4,
            "the period, two indices and the added mass",
        )?;
        line.check_commas("the added mass")?;
        let frequency = Frequency::of_period(&tokens[0])?;
        let at = (index(&tokens[1])?, index(&tokens[2])?);
        let value = tokens[3].number("the added mass")?;
        if periods.len() >= MOST_PERIODS && !periods.contains_key(&frequency) {
            let (what, limit) = ("periods".to_owned(), MOST_PERIODS);
            let found = periods.len() + 1;
            return Err(tokens[0].wrong(DiagnosticKind::TooMany { what, found, limit }));
        }
        let entries = periods.entry(frequency).or_insert(Entries::EMPTY);
        if !entries.set(at, value) {
            return Err(repeated(&line, at, "of this period"));
        }
    }
    Ok(periods)
}

/// Reads a `.hst` file: nondimensional stiffness, not yet symmetric.
pub(super) fn read_hydrostatic(source: &Source) -> Result<Read<SpatialMatrix>, Diagnostic> {
    let mut entries = Entries::EMPTY;
    let mut is_empty = true;
    for line in numeric_lines(&source.text) {
        let tokens: Vec<Token<'_>> = line.tokens().take(3).collect();
        check_count(&line, &tokens, 3, "two indices and the stiffness")?;
        line.check_commas("the stiffness")?;
        let at = (index(&tokens[0])?, index(&tokens[1])?);
        if !entries.set(at, tokens[2].number("the stiffness")?) {
            return Err(repeated(&line, at, "of the stiffness"));
        }
        is_empty = false;
    }
    if is_empty {
        return Err(Diagnostic::new(0..0, DiagnosticKind::EmptyFile));
    }
    let is_upper_triangle = !entries.has_lower() && entries.mirrored() != entries.matrix;
    let content = match is_upper_triangle {
        true => entries.mirrored(),
        false => entries.matrix,
    };
    Ok(Read {
        content,
        is_upper_triangle,
    })
}

/// The lines that are not blank, without a title on the first line.
fn numeric_lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let is_title = |line: &Line<'_>| !line.first().is_some_and(|token| token.is_number());
    let lines = Lines::new(text).enumerate();
    let lines = lines.filter(move |(index, line)| *index > 0 || !is_title(line));
    lines.map(|(_, line)| line).filter(|line| !line.is_blank())
}

fn check_count(
    line: &Line<'_>,
    tokens: &[Token<'_>],
    least: usize,
    columns: &str,
) -> Result<(), Diagnostic> {
    if tokens.len() >= least {
        return Ok(());
    }
    let kind = DiagnosticKind::wrong_count("the line", tokens.len(), format!("at least {least}"));
    Err(Diagnostic::new(line.span(), kind).with_hint(format!("a line has {columns}")))
}

fn index(token: &Token<'_>) -> Result<usize, Diagnostic> {
    let value = token.integer("an index of a motion")?;
    match value {
        1..=6 => Ok(value as usize - 1),
        7.. => {
            let message =
                format!("the index {value} refers to a second body: only one body can be solved");
            Err(token.wrong(DiagnosticKind::Unsupported(message)))
        }
        _ => {
            let rule = "from 1 (surge) to 6 (yaw)";
            let kind = DiagnosticKind::out_of_range("an index of a motion", value as f64, rule);
            Err(token.wrong(kind))
        }
    }
}

fn repeated(line: &Line<'_>, (i, j): (usize, usize), of: &str) -> Diagnostic {
    let what = format!("entry ({}, {}) {of}", i + 1, j + 1);
    Diagnostic::new(line.span(), DiagnosticKind::Repeated { what, times: 2 })
        .with_hint("each entry may be given only once")
}

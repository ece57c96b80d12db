//! The checks of OpenFAST on a tower file.

use thiserror::Error;
use towermodes_analysis::elastodyn::{COEFFICIENT_DECIMALS, RoundingError, TowerPolynomial};

use super::tower_file::TowerFile;
use super::tower_records as records;

/// Why content cannot be written as a tower file: OpenFAST would refuse it, or the file would
/// describe another tower.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TowerFileError {
    /// A quantity outside its range.
    #[error("{name} is {value}; it must be {rule}")]
    Quantity {
        /// Its name in the file, with the row (from 1) if it is in one.
        name: String,
        /// Its value.
        value: f64,
        /// The range.
        rule: &'static str,
    },
    /// Fewer than two rows (base and top).
    #[error("a tower file has at least 2 rows of distributed properties, not {rows}")]
    Rows {
        /// Number of rows.
        rows: usize,
    },
    /// Coefficients that cannot be printed with a sum of 1.
    #[error("{shape}: {error}")]
    Coefficients {
        /// The name of the shape.
        shape: &'static str,
        /// The reason.
        error: RoundingError,
    },
    /// Concentrated masses, but no section for them.
    #[error(
        "the tower has {masses} concentrated masses, but the section for them is not requested; OpenFAST has it since 4.2"
    )]
    NoSection {
        /// Number of masses.
        masses: usize,
    },
}

/// The coefficients of a shape as they are printed: decimals whose sum is 1.
pub(crate) fn coefficient_texts(
    shape: &'static str,
    coefficients: [f64; 5],
) -> Result<[String; 5], TowerFileError> {
    let rounded = TowerPolynomial { coefficients }.rounded(COEFFICIENT_DECIMALS);
    match rounded {
        Ok(rounded) => Ok(rounded.texts()),
        Err(error) => Err(TowerFileError::Coefficients { shape, error }),
    }
}

/// Checks what OpenFAST 5.0 checks, and that numbers are finite and factors positive. The
/// coefficients are checked when they are printed.
pub(crate) fn check(content: &TowerFile) -> Result<(), TowerFileError> {
    let damping = content.damping_percent();
    let factors = content.factors();
    let pairs = records::DAMPING.iter().zip(damping);
    for (record, value) in pairs.chain(records::FACTORS.iter().zip(factors)) {
        let (is_right, rule) = record.check(value);
        demand(is_right && value.is_finite(), record.name, value, rule)?;
    }
    check_rows(content)?;
    check_masses(content)
}

fn check_rows(content: &TowerFile) -> Result<(), TowerFileError> {
    let rows = content.rows.len();
    if rows < 2 {
        return Err(TowerFileError::Rows { rows });
    }
    let mut below = f64::NEG_INFINITY;
    for (number, row) in (1..).zip(&content.rows) {
        let of_row = |name: &str| format!("{name} of row {number}");
        let height = row.height_fraction;
        let (is_right, rule) = match number {
            1 => (height == 0.0, "0, the base"),
            _ if number == rows => (
                height == 1.0 && below < 1.0,
                "1, the top, and above the others",
            ),
            _ => (
                height > below && height < 1.0,
                "above the row before and below 1",
            ),
        };
        demand(is_right, of_row("HtFract"), height, rule)?;
        positive(of_row("TMassDen"), row.mass_kg_per_m)?;
        positive(of_row("TwFAStif"), row.fore_aft_n_m2)?;
        positive(of_row("TwSSStif"), row.side_side_n_m2)?;
        below = height;
    }
    Ok(())
}

fn check_masses(content: &TowerFile) -> Result<(), TowerFileError> {
    for (number, mass) in (1..).zip(&content.concentrated_masses) {
        let of_mass = |name: &str| format!("{name} of concentrated mass {number}");
        let height = mass.height_fraction;
        let is_fraction = (0.0..=1.0).contains(&height);
        demand(is_fraction, of_mass("HtFract"), height, "from 0 to 1")?;
        let is_mass = mass.mass_kg >= 0.0 && mass.mass_kg.is_finite();
        demand(is_mass, of_mass("TwCMass"), mass.mass_kg, "non-negative")?;
    }
    Ok(())
}

fn positive(name: impl Into<String>, value: f64) -> Result<(), TowerFileError> {
    demand(value > 0.0 && value.is_finite(), name, value, "above 0")
}

fn demand(
    is_right: bool,
    name: impl Into<String>,
    value: f64,
    rule: &'static str,
) -> Result<(), TowerFileError> {
    if is_right {
        return Ok(());
    }
    let name = name.into();
    Err(TowerFileError::Quantity { name, value, rule })
}

//! What OpenFAST refuses in a tower file.

use thiserror::Error;
use towermodes_analysis::elastodyn::{COEFFICIENT_DECIMALS, RoundingError, TowerPolynomial};

use super::tower_file::TowerFile;

/// The names of the four shapes of a tower file, without the number of the coefficient.
pub(super) const SHAPES: [&str; 4] = ["TwFAM1Sh", "TwFAM2Sh", "TwSSM1Sh", "TwSSM2Sh"];

/// Why a content cannot be written as a tower file: OpenFAST would refuse it, or it would not say
/// what it should.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TowerFileError {
    /// A quantity that cannot be.
    #[error("{name} is {value}; it must be {rule}")]
    Quantity {
        /// Its name in the file, with the row (from 1) if it is in one.
        name: String,
        /// Its value.
        value: f64,
        /// What it must be.
        rule: &'static str,
    },
    /// Fewer rows than the base's and the top's.
    #[error("a tower file has at least 2 rows of distributed properties, not {rows}")]
    Rows {
        /// How many there are.
        rows: usize,
    },
    /// Coefficients that cannot be printed so that they add up to 1.
    #[error("{shape}: {error}")]
    Coefficients {
        /// The name of the shape.
        shape: &'static str,
        /// Why.
        error: RoundingError,
    },
    /// Masses and no section to write them to.
    #[error(
        "there are {masses} concentrated masses, and the section for them was not asked for; OpenFAST has it since 4.2"
    )]
    NoSection {
        /// How many there are.
        masses: usize,
    },
}

/// The coefficients of a shape as they are printed: decimals that add up to 1.
pub(super) fn coefficient_texts(
    shape: &'static str,
    coefficients: [f64; 5],
) -> Result<[String; 5], TowerFileError> {
    let rounded = TowerPolynomial { coefficients }.rounded(COEFFICIENT_DECIMALS);
    match rounded {
        Ok(rounded) => Ok(rounded.texts()),
        Err(error) => Err(TowerFileError::Coefficients { shape, error }),
    }
}

/// Refuses what OpenFAST 5.0 refuses, numbers that are none, and factors that leave no tower. The
/// coefficients are checked where they are printed.
pub(super) fn check(content: &TowerFile) -> Result<(), TowerFileError> {
    let of_modes = |name: &str, values: [f64; 2]| {
        let [first, second] = values;
        [
            (format!("{name}(1)"), first),
            (format!("{name}(2)"), second),
        ]
    };
    let damping = [
        of_modes("TwrFADmp", content.fore_aft_damping_percent),
        of_modes("TwrSSDmp", content.side_side_damping_percent),
    ];
    for (name, value) in damping.into_iter().flatten() {
        demand((0.0..=100.0).contains(&value), name, value, "from 0 to 100")?;
    }
    let tuners = [
        of_modes("FAStTunr", content.fore_aft_tuners),
        of_modes("SSStTunr", content.side_side_tuners),
    ];
    for (name, value) in tuners.into_iter().flatten() {
        positive(name, value)?;
    }
    positive("AdjTwMa", content.mass_factor)?;
    positive("AdjFASt", content.fore_aft_factor)?;
    positive("AdjSSSt", content.side_side_factor)?;
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
        let is_share = (0.0..=1.0).contains(&height);
        demand(is_share, of_mass("HtFract"), height, "from 0 to 1")?;
        let is_mass = mass.mass_kg >= 0.0 && mass.mass_kg.is_finite();
        demand(is_mass, of_mass("TwCMass"), mass.mass_kg, "no less than 0")?;
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

//! The four mode shapes of a tower for ElastoDyn.

use thiserror::Error;

use super::decimal::{COEFFICIENT_DECIMALS, DecimalPolynomial, RoundingError};
use super::fit::{FitError, PolynomialFit, fit};
use super::selection::{
    BendingModes, DEFAULT_TORSION_LIMIT, PassedOver, SelectionError, sample_heights_m,
    select_bending_modes,
};
use super::shape_samples::ShapeSamples;
use towermodes::Plain;
use towermodes::tower::{Plane, Tower};
use towermodes::{Mode, Options, Solution, SolveError, Solver};

/// The number of modes solved at first; more are solved if torsion or rigid-body modes of a
/// floating platform are among them.
const FIRST_MODES: usize = 12;
/// Largest number of modes solved.
const MOST_MODES: usize = 96;

/// A shape for ElastoDyn.
#[derive(Debug, Clone, PartialEq)]
pub struct TowerShape {
    /// The bending plane of the mode.
    pub plane: Plane,
    /// Number of the shape: 1 or 2.
    pub number: usize,
    /// The name of the mode: "1st fore-aft bending".
    pub label: String,
    /// The frequency of the mode, with rotor-nacelle assembly and foundation, Hz.
    pub frequency_hz: f64,
    /// The fraction of torsion in the energy of the mode, which the shape does not have.
    pub torsion_share: f64,
    /// The shape as samples.
    pub samples: ShapeSamples,
    /// The fitted polynomial and its residuals.
    pub fit: PolynomialFit,
    /// The polynomial rounded to the decimals of the file.
    pub decimals: DecimalPolynomial,
}

/// The shapes for ElastoDyn: first and second fore-aft, first and second side-side.
#[derive(Debug, Clone, PartialEq)]
pub struct TowerShapes {
    /// The four shapes.
    pub shapes: [TowerShape; 4],
    /// Modes skipped because of their torsion.
    pub passed_over: Vec<PassedOver>,
}

/// Why a tower has no shapes for ElastoDyn.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ShapesError {
    /// The tower cannot be solved.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// It has too few bending modes.
    #[error(transparent)]
    Selection(#[from] SelectionError),
    /// A mode cannot be fitted by a polynomial.
    #[error("the {label} cannot be fitted: {error}")]
    Fit {
        /// Label of the mode.
        label: String,
        /// The reason.
        error: FitError,
    },
    /// The polynomial cannot be rounded.
    #[error("the {label} cannot be printed: {error}")]
    Rounding {
        /// Label of the mode.
        label: String,
        /// The reason.
        error: RoundingError,
    },
    /// The flexible tower begins outside the tower.
    #[error("the flexible tower begins at {} m, but the tower reaches from {} m to {} m", Plain(*.from_m), Plain(*.base_m), Plain(*.top_m))]
    Outside {
        /// Height where the flexible tower would begin, m.
        from_m: f64,
        /// Base of the tower, m.
        base_m: f64,
        /// Top of the tower, m.
        top_m: f64,
    },
}

/// Solves a tower and fits polynomials to the first two bending modes of each plane above a height
/// (m), without the motion at that height.
///
/// The options apply to the solution; the number of modes and the heights are set here.
///
/// # Errors
/// [`ShapesError`]: the tower cannot be solved, has too few bending modes, or a mode cannot be
/// fitted.
///
/// # Example
/// See the [crate's front page](crate).
pub fn tower_shapes(
    tower: &Tower,
    options: &Options,
    from_m: f64,
) -> Result<TowerShapes, ShapesError> {
    let (base_m, top_m) = (tower.base_m(), tower.top_m());
    if !(base_m..top_m).contains(&from_m) {
        return Err(ShapesError::Outside {
            from_m,
            base_m,
            top_m,
        });
    }
    let mut solver = Solver::new(Options {
        modes: FIRST_MODES,
        points: 2,
        heights_m: sample_heights_m(from_m, top_m),
        ..options.clone()
    });
    let has_all = |solution: &Solution| {
        let selected = select_bending_modes(solution, DEFAULT_TORSION_LIMIT);
        !matches!(selected, Err(SelectionError::TooFewModes { .. }))
    };
    let solution = solver.until(MOST_MODES, |solver| solver.solve(tower), has_all)?;
    fitted(select_bending_modes(&solution, DEFAULT_TORSION_LIMIT)?)
}

/// The shapes fitted to the selected modes.
fn fitted(bending: BendingModes<'_>) -> Result<TowerShapes, ShapesError> {
    let shape = |plane, number: usize| {
        let mode = bending.modes.of(plane)[number - 1];
        let samples = bending.samples(plane, number - 1);
        shape(plane, number, mode, samples)
    };
    Ok(TowerShapes {
        shapes: [
            shape(Plane::ForeAft, 1)?,
            shape(Plane::ForeAft, 2)?,
            shape(Plane::SideSide, 1)?,
            shape(Plane::SideSide, 2)?,
        ],
        passed_over: bending.passed_over,
    })
}

fn shape(
    plane: Plane,
    number: usize,
    mode: &Mode,
    samples: ShapeSamples,
) -> Result<TowerShape, ShapesError> {
    let label = mode.label();
    let fit = fit(&samples).map_err(|error| ShapesError::Fit {
        label: label.clone(),
        error,
    })?;
    let decimals = fit.polynomial.rounded(COEFFICIENT_DECIMALS);
    let decimals = decimals.map_err(|error| ShapesError::Rounding {
        label: label.clone(),
        error,
    })?;
    Ok(TowerShape {
        plane,
        number,
        label,
        frequency_hz: mode.frequency_hz,
        torsion_share: mode.energy.mean().torsion,
        samples,
        fit,
        decimals,
    })
}

/// The name of the coefficients of a shape in a tower file, without the power of x: `TwFAM1Sh`.
pub fn shape_name(plane: Plane, number: usize) -> String {
    let plane = match plane {
        Plane::ForeAft => "FA",
        Plane::SideSide => "SS",
    };
    format!("Tw{plane}M{number}Sh")
}

/// If a shape has a larger fraction of its energy in torsion, a note reports it.
const MUCH_TORSION: f64 = 0.1;

impl TowerShapes {
    /// The shapes with more than a tenth of their energy in torsion, which ElastoDyn's towers do
    /// not have.
    pub fn with_torsion(&self) -> impl Iterator<Item = &TowerShape> {
        self.shapes
            .iter()
            .filter(|shape| shape.torsion_share > MUCH_TORSION)
    }

    /// The rounded polynomials of both modes of a plane.
    pub fn polynomials(&self, plane: Plane) -> [super::TowerPolynomial; 2] {
        let first = match plane {
            Plane::ForeAft => 0,
            Plane::SideSide => 2,
        };
        [0, 1].map(|i| self.shapes[first + i].decimals.polynomial())
    }

    /// The rounded coefficients: of the first and second fore-aft, first and second side-side
    /// shape.
    pub fn coefficients(&self) -> [[f64; 5]; 4] {
        let polynomial = |shape: &TowerShape| shape.decimals.polynomial().coefficients;
        [0, 1, 2, 3].map(|i| polynomial(&self.shapes[i]))
    }
}

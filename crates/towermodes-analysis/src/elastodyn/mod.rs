//! The tower in ElastoDyn, the structural module of OpenFAST: polynomial mode shapes, frequencies
//! by the formulas of ElastoDyn, damping, rows of the tower file.
//!
//! ElastoDyn solves no eigenvalue problem. It represents the tower by two shapes in each plane,
//! polynomials with the powers x² to x⁶ of the height x as a fraction of the flexible tower, which
//! the user must provide. [`select_bending_modes()`] selects the modes of a
//! [`Solution`](towermodes::Solution), [`fit()`] fits the polynomials, [`TowerPolynomial::rounded`]
//! rounds them to the decimals of the file, and [`TowerModel`] computes the quantities that
//! ElastoDyn computes from them. [`tower_shapes`] gives the shapes of a tower, and [`make_tower`]
//! the whole content of its tower file.

mod check;
mod damping;
mod decimal;
mod fit;
mod generalized;
mod least_squares;
mod make;
mod model;
mod model_difference;
mod polynomial;
mod same_tower;
mod selection;
mod shape_samples;
mod shape_validation;
mod shapes;
mod stations;
mod sums;

pub use damping::{DampingError, damping_of_system_percent, damping_to_write_percent};
pub use decimal::{
    COEFFICIENT_DECIMALS, DecimalPolynomial, MAX_DECIMALS, RoundingError, SUM_TOLERANCE,
};
pub use fit::{FitError, PolynomialFit, SMALLEST_TIP_SHARE, fit};
pub use generalized::Generalized;
pub use make::{Coarseness, DEFAULT_NODES, Damping, MadeTower, MakeError, MakeOptions, make_tower};
pub use model::{ConcentratedMass, MAX_NODES, ModelError, PlaneModes, TowerModel, TowerStation};
pub use model_difference::ModelDifference;
pub use polynomial::TowerPolynomial;
pub use same_tower::{OtherTower, SameTower, same_tower};
pub use selection::{
    BendingModes, DEFAULT_TORSION_LIMIT, PassedOver, SelectionError, sample_heights_m,
    select_bending_modes,
};
pub use shape_samples::ShapeSamples;
pub use shape_validation::{ShapeValidation, ValidatedShape, ValidationLimits, validate_shapes};
pub use shapes::{ShapesError, TowerShape, TowerShapes, shape_name, tower_shapes};
pub use stations::{MAX_STATIONS, PointMasses, Rows, RowsError, TowerRows, tower_rows};

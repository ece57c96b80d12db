//! What ElastoDyn, OpenFAST's tower model, makes of a tower and its modes: polynomial shapes,
//! frequencies by its formulas, damping.
//!
//! ElastoDyn solves no eigenvalue problem. It moves the tower by two shapes in each plane,
//! polynomials of x² to x⁶ of the height x as a share of the flexible tower, which a user takes
//! from elsewhere: [`choose()`] picks the modes of a [`Solution`](towermodes::Solution), [`fit()`] makes
//! polynomials of them, [`TowerPolynomial::rounded`] the decimals that are printed, and
//! [`TowerModel`] says what ElastoDyn computes with them.

mod check;
mod choose;
mod damping;
mod decimal;
mod fit;
mod judgement;
mod least_squares;
mod likeness;
mod model;
mod polynomial;
mod shape_samples;
mod shapes;
mod stations;
mod sums;

pub use choose::{
    BendingModes, ChooseError, DEFAULT_TORSION_LIMIT, PassedOver, choose, sample_heights_m,
};
pub use damping::{DampingError, damping_of_system_percent, damping_to_write_percent};
pub use decimal::{
    COEFFICIENT_DECIMALS, DecimalPolynomial, MAX_DECIMALS, RoundingError, SUM_TOLERANCE,
};
pub use fit::{FitError, PolynomialFit, SMALLEST_TIP_SHARE, fit};
pub use judgement::{Judgement, JudgementLimits, judge};
pub use likeness::Likeness;
pub use model::{
    ConcentratedMass, Generalized, MAX_NODES, ModelError, PlaneModes, TowerModel, TowerStation,
};
pub use polynomial::TowerPolynomial;
pub use shape_samples::ShapeSamples;
pub use shapes::{ShapesError, TowerShape, TowerShapes, tower_shapes};
pub use stations::{MAX_STATIONS, PointMasses, Rows, RowsError, TowerRows, tower_rows};

//! The tower model of ElastoDyn: rows, factors and masses of its files, and its modes.

use thiserror::Error;

use super::polynomial::TowerPolynomial;
use towermodes::Plain;
use towermodes::tower::Planes;

/// The largest number of elements; usual ElastoDyn towers have some tens.
pub const MAX_NODES: usize = 1_000_000;

/// The tower model of ElastoDyn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TowerModel {
    /// Length of the flexible tower, m.
    pub flexible_length_m: f64,
    /// Number of elements, `TwrNodes`.
    pub nodes: usize,
    /// Rows from the base to the top.
    pub stations: Vec<TowerStation>,
    /// Factor of the masses per length, `AdjTwMa`.
    pub mass_factor: f64,
    /// Factors of the bending stiffnesses, `AdjFASt` and `AdjSSSt`.
    pub stiffness_factors: Planes<f64>,
    /// Masses along the tower; each is distributed over its element.
    pub concentrated_masses: Vec<ConcentratedMass>,
    /// Mass of the rotor-nacelle assembly, kg.
    pub tower_top_mass_kg: f64,
    /// Acceleration of gravity, m/s².
    pub gravity_m_per_s2: f64,
}

/// A row of properties of the tower.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TowerStation {
    /// Height as a fraction of the flexible tower, 0 to 1.
    pub height_fraction: f64,
    /// Mass per length, kg/m.
    pub mass_kg_per_m: f64,
    /// Bending stiffness in each plane, N m².
    pub bending_n_m2: Planes<f64>,
}

/// A mass at a height.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ConcentratedMass {
    /// Height as a fraction of the flexible tower, 0 to 1.
    pub height_fraction: f64,
    /// Mass, kg.
    pub mass_kg: f64,
}

/// The two modes of a plane in a tower file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneModes {
    /// The shapes.
    pub shapes: [TowerPolynomial; 2],
    /// Factors of the stiffnesses, `FAStTunr` or `SSStTunr`.
    pub tuners: [f64; 2],
    /// Structural damping, percent of critical, `TwrFADmp` or `TwrSSDmp`.
    pub damping_percent: [f64; 2],
}

/// Why the quantities of ElastoDyn cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum ModelError {
    /// A quantity is out of its range.
    #[error("{what} cannot be {}", Plain(*.value))]
    Quantity {
        /// The name of the quantity.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// The number of elements is 0 or too large.
    #[error(
        "a tower cannot be divided into {nodes} elements; the number must be from 1 to {MAX_NODES}"
    )]
    Nodes {
        /// The number.
        nodes: usize,
    },
    /// The tower has fewer than 2 rows.
    #[error("a tower needs at least 2 rows of properties, not {rows}")]
    Rows {
        /// Number of rows.
        rows: usize,
    },
    /// The heights of the rows do not increase from 0 to 1.
    #[error("the heights of the tower's rows must rise from 0 to 1; row {row} is at {}", Plain(*.height_fraction))]
    Heights {
        /// The row, from 1.
        row: usize,
        /// Its height.
        height_fraction: f64,
    },
    /// The computation overflowed, or a shape is zero.
    #[error(
        "the masses, stiffnesses or shapes of this tower are too large, too small or zero: the equations of ElastoDyn give no frequency"
    )]
    NotFinite,
}

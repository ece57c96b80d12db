//! The content of a BModes deck: every value as it is written, with its place.

use std::ops::{Index, Range};

use super::parameters::{COLUMNS, Column};
use super::reader::Value;
use super::unread::Unread;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::input::OutLayout;

/// A main input file with its section file.
#[derive(Debug, Clone)]
pub(super) struct Deck {
    pub(super) dialect: Dialect,
    pub(super) title: String,
    pub(super) beam: Beam,
    pub(super) general: General,
    pub(super) tip: Tip,
    pub(super) multipliers: Multipliers,
    /// Element borders from the root, as fractions of the flexible length.
    pub(super) borders: Vec<Value<f64>>,
    /// The support of a tower; empty for a blade.
    pub(super) support: Support,
    /// The rows of the section file, by increasing `sec_loc`.
    pub(super) sections: Vec<Section>,
    /// The byte of the section file where numbers begin that are not read.
    pub(super) extra_columns: Option<usize>,
}

/// The version of BModes whose records a deck has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Dialect {
    /// BModes 1.03: no `cm_axial`, no `tow_support`.
    V1,
    /// BModes 3.00.
    V3,
    /// A later BModes, of which no source is public (`BModes_JJ`): `tow_support` 1 is the offshore
    /// block, and wires follow it.
    Later,
}

/// The kind of beam that a deck describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Beam {
    Blade,
    Tower,
}

/// How the root or base is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum HubConnection {
    /// 1: clamped.
    Clamped,
    /// 2: free, or on springs.
    Free,
    /// 3: held axially and in torsion, on springs otherwise.
    AxiallyAndInTorsion,
}

impl HubConnection {
    /// That of a number from 1 to 3.
    pub(super) fn of_number(number: f64) -> Self {
        match number {
            1.0 => Self::Clamped,
            2.0 => Self::Free,
            _ => Self::AxiallyAndInTorsion,
        }
    }
}

/// The general parameters.
#[derive(Debug, Clone)]
pub(super) struct General {
    pub(super) rot_rpm: Value<f64>,
    pub(super) rpm_mult: Value<f64>,
    pub(super) radius_m: Value<f64>,
    pub(super) root_m: Value<f64>,
    pub(super) precone_deg: Value<f64>,
    pub(super) pitch_deg: Value<f64>,
    pub(super) hub: Value<HubConnection>,
    pub(super) modes: Value<usize>,
    pub(super) layout: OutLayout,
}

/// The body at the tip.
#[derive(Debug, Clone)]
pub(super) struct Tip {
    pub(super) mass_kg: Value<f64>,
    pub(super) cm_loc_m: Value<f64>,
    /// Not in version 1.03.
    pub(super) cm_axial_m: Option<Value<f64>>,
    /// ixx, iyy, izz, ixy, izx, iyz.
    pub(super) inertia_kg_m2: [Value<f64>; 6],
}

/// The factors of the section file's columns.
#[derive(Debug, Clone)]
pub(super) struct Multipliers {
    pub(super) mass: Value<f64>,
    pub(super) flap_inertia: Value<f64>,
    pub(super) edge_inertia: Value<f64>,
    pub(super) flap: Value<f64>,
    pub(super) edge: Value<f64>,
    pub(super) torsion: Value<f64>,
    pub(super) axial: Value<f64>,
    pub(super) center_of_mass: Value<f64>,
    pub(super) shear_center: Value<f64>,
    pub(super) tension_center: Value<f64>,
}

/// A row of the section file: the value of each [`Column`].
#[derive(Debug, Clone)]
pub(super) struct Section(pub(super) [Value<f64>; COLUMNS.len()]);

impl Index<Column> for Section {
    type Output = Value<f64>;

    fn index(&self, column: Column) -> &Value<f64> {
        &self.0[column as usize]
    }
}

/// The support of a tower apart from its base.
#[derive(Debug, Clone, Default)]
pub(super) struct Support {
    pub(super) wires: Vec<WireSet>,
    pub(super) offshore: Option<Box<Offshore>>,
    /// Values in the file that are not read.
    pub(super) unread: Vec<Unread>,
}

/// Wires at one node.
#[derive(Debug, Clone)]
pub(super) struct WireSet {
    pub(super) count: Value<usize>,
    /// From 1 at the base.
    pub(super) node: Value<usize>,
    pub(super) stiffness_n_per_m: Value<f64>,
    pub(super) angle_deg: Value<f64>,
}

/// The block of a platform or a monopile.
#[derive(Debug, Clone)]
pub(super) struct Offshore {
    pub(super) draft_m: Value<f64>,
    pub(super) cm_depth_m: Value<f64>,
    pub(super) mass_kg: Value<f64>,
    pub(super) inertia_kg_m2: MatrixValue<3>,
    pub(super) reference_depth_m: Value<f64>,
    pub(super) hydro_mass: MatrixValue<6>,
    pub(super) hydro_stiffness: MatrixValue<6>,
    pub(super) mooring_stiffness: MatrixValue<6>,
    pub(super) added_mass: Distribution,
    pub(super) stiffness: Distribution,
}

impl Offshore {
    /// Whether the platform has a mass or a matrix.
    pub(super) fn has_platform(&self) -> bool {
        self.mass_kg.value != 0.0
            || !self.inertia_kg_m2.is_zero()
            || !self.hydro_mass.is_zero()
            || !self.hydro_stiffness.is_zero()
            || !self.mooring_stiffness.is_zero()
    }
}

/// A matrix and the bytes of its rows.
#[derive(Debug, Clone)]
pub(super) struct MatrixValue<const N: usize> {
    pub(super) rows: [[f64; N]; N],
    pub(super) spans: [Range<usize>; N],
}

impl<const N: usize> MatrixValue<N> {
    /// The bytes of all its rows.
    pub(super) fn span(&self) -> Range<usize> {
        let start = self.spans.first().map_or(0, |span| span.start);
        start..self.spans.last().map_or(start, |span| span.end)
    }

    /// Whether all entries are zero.
    pub(super) fn is_zero(&self) -> bool {
        self.rows.iter().flatten().all(|entry| *entry == 0.0)
    }
}

/// A table over the height.
#[derive(Debug, Clone)]
pub(super) struct Distribution {
    pub(super) count: Value<usize>,
    /// Heights above the flexible base, m, and values there; empty if there are fewer than two.
    pub(super) rows: Vec<(Value<f64>, Value<f64>)>,
}

/// A value times its factor.
///
/// # Errors
/// [`DiagnosticKind::Overflow`] if the product is infinite, or zero by underflow.
pub(super) fn scaled(value: &Value<f64>, factor: &Value<f64>) -> Result<f64, Diagnostic> {
    let product = value.value * factor.value;
    let is_lost = product == 0.0 && value.value != 0.0 && factor.value != 0.0;
    if product.is_finite() && !is_lost {
        return Ok(product);
    }
    let what = format!("{} times its factor {}", value.value, factor.value);
    Err(value.wrong(DiagnosticKind::Overflow { what }))
}

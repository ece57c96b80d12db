//! The content of a BModes deck: every value as written, with its place.

use std::ops::{Index, Range};

use super::parameters::{COLUMNS, Column};
use super::reader::Value;
use super::unread::Unread;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::input::OutLayout;

/// A main input file with its section file.
#[derive(Debug, Clone)]
pub(crate) struct Deck {
    pub(crate) dialect: Dialect,
    pub(crate) title: String,
    pub(crate) beam: Beam,
    pub(crate) general: General,
    pub(crate) tip: Tip,
    pub(crate) multipliers: Multipliers,
    /// Element boundaries from the root, as fractions of the flexible length.
    pub(crate) borders: Vec<Value<f64>>,
    /// The support of a tower; empty for a blade.
    pub(crate) support: Support,
    /// The rows of the section file, by increasing `sec_loc`.
    pub(crate) sections: Vec<Section>,
    /// The byte of the section file at which the first unused number begins.
    pub(crate) extra_columns: Option<usize>,
}

/// The version of BModes for which a deck is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Dialect {
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
pub(crate) enum Beam {
    Blade,
    Tower,
}

/// The support of the root or base.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum HubConnection {
    /// 1: clamped.
    Clamped,
    /// 2: free, or on springs.
    Free,
    /// 3: fixed axially and in torsion, otherwise on springs.
    AxiallyAndInTorsion,
}

impl HubConnection {
    /// The support with a number from 1 to 3.
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
pub(crate) struct General {
    pub(crate) rot_rpm: Value<f64>,
    pub(crate) rpm_mult: Value<f64>,
    pub(crate) radius_m: Value<f64>,
    pub(crate) root_m: Value<f64>,
    pub(crate) precone_deg: Value<f64>,
    pub(crate) pitch_deg: Value<f64>,
    pub(crate) hub: Value<HubConnection>,
    pub(crate) modes: Value<usize>,
    pub(crate) layout: OutLayout,
}

/// The body at the tip.
#[derive(Debug, Clone)]
pub(crate) struct Tip {
    pub(crate) mass_kg: Value<f64>,
    pub(crate) cm_loc_m: Value<f64>,
    /// Missing in version 1.03.
    pub(crate) cm_axial_m: Option<Value<f64>>,
    /// ixx, iyy, izz, ixy, izx, iyz.
    pub(crate) inertia_kg_m2: [Value<f64>; 6],
}

/// The factors of the section file's columns.
#[derive(Debug, Clone)]
pub(crate) struct Multipliers {
    pub(crate) mass: Value<f64>,
    pub(crate) flap_inertia: Value<f64>,
    pub(crate) edge_inertia: Value<f64>,
    pub(crate) flap: Value<f64>,
    pub(crate) edge: Value<f64>,
    pub(crate) torsion: Value<f64>,
    pub(crate) axial: Value<f64>,
    pub(crate) center_of_mass: Value<f64>,
    pub(crate) shear_center: Value<f64>,
    pub(crate) tension_center: Value<f64>,
}

/// A row of the section file: the value of each [`Column`].
#[derive(Debug, Clone)]
pub(crate) struct Section(pub(super) [Value<f64>; COLUMNS.len()]);

impl Index<Column> for Section {
    type Output = Value<f64>;

    fn index(&self, column: Column) -> &Value<f64> {
        &self.0[column as usize]
    }
}

/// The support of a tower except its base.
#[derive(Debug, Clone, Default)]
pub(crate) struct Support {
    pub(crate) wires: Vec<WireSet>,
    pub(crate) offshore: Option<Box<Offshore>>,
    /// Values in the file that are not used.
    pub(crate) unread: Vec<Unread>,
}

/// Wires at one node.
#[derive(Debug, Clone)]
pub(crate) struct WireSet {
    pub(crate) count: Value<usize>,
    /// Number of the node, from 1 at the base.
    pub(crate) node: Value<usize>,
    pub(crate) stiffness_n_per_m: Value<f64>,
    pub(crate) angle_deg: Value<f64>,
}

/// The block of a platform or a monopile.
#[derive(Debug, Clone)]
pub(crate) struct Offshore {
    pub(crate) draft_m: Value<f64>,
    pub(crate) cm_depth_m: Value<f64>,
    pub(crate) mass_kg: Value<f64>,
    pub(crate) inertia_kg_m2: MatrixValue<3>,
    pub(crate) reference_depth_m: Value<f64>,
    pub(crate) hydro_mass: MatrixValue<6>,
    pub(crate) hydro_stiffness: MatrixValue<6>,
    pub(crate) mooring_stiffness: MatrixValue<6>,
    pub(crate) added_mass: Distribution,
    pub(crate) stiffness: Distribution,
}

impl Offshore {
    /// Whether the platform has a mass or a matrix.
    pub(crate) fn has_platform(&self) -> bool {
        self.mass_kg.value != 0.0
            || !self.inertia_kg_m2.is_zero()
            || !self.hydro_mass.is_zero()
            || !self.hydro_stiffness.is_zero()
            || !self.mooring_stiffness.is_zero()
    }
}

/// A matrix and the bytes of its rows.
#[derive(Debug, Clone)]
pub(crate) struct MatrixValue<const N: usize> {
    pub(crate) rows: [[f64; N]; N],
    pub(crate) spans: [Range<usize>; N],
}

impl<const N: usize> MatrixValue<N> {
    /// The byte range of all its rows.
    pub(crate) fn span(&self) -> Range<usize> {
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
pub(crate) struct Distribution {
    pub(crate) count: Value<usize>,
    /// Heights above the flexible base, m, and values there; empty if there are fewer than two.
    pub(crate) rows: Vec<(Value<f64>, Value<f64>)>,
}

/// A value times its factor.
///
/// # Errors
/// [`DiagnosticKind::Overflow`] if the product is infinite, or underflows to zero.
pub(crate) fn scaled(value: &Value<f64>, factor: &Value<f64>) -> Result<f64, Diagnostic> {
    let product = value.value * factor.value;
    let is_lost = product == 0.0 && value.value != 0.0 && factor.value != 0.0;
    if product.is_finite() && !is_lost {
        return Ok(product);
    }
    let what = format!("{} times its factor {}", value.value, factor.value);
    Err(value.wrong(DiagnosticKind::Overflow { what }))
}

//! The keys of a mode in serialized results: its fields, and values that follow from them.

use serde::{Serialize, Serializer};

use super::super::Mode;
use crate::frame::FrameShape;
use crate::modes::serialized::{directions, shape};
use crate::modes::{Energy, Family, SecondFamily, ShapePoint};

/// A natural mode.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(remote = "Mode")]
struct ModeKeys {
    /// Place in the list, from 1.
    number: usize,
    /// Natural frequency of the chain of rigid bodies or of the beam, Hz.
    frequency_hz: f64,
    /// 1/frequency, s; null for a rigid-body mode without stiffness.
    #[serde(getter = "finite_period_s")]
    period_s: Option<f64>,
    /// The kind of motion. A floating tower that moves as one body has `surge`, `sway`, `heave`,
    /// `roll`, `pitch` or `yaw`.
    family: Family,
    /// Order within the family, from 1.
    order: usize,
    /// The share of its own family in its energy. For floating towers the shares are fractions of
    /// the kinetic energy, first of the rigid-body motions.
    #[serde(getter = "Mode::share")]
    share: f64,
    /// The other family with the largest share of the energy of the mode; null if there is none.
    #[serde(getter = "Mode::second")]
    second: Option<SecondFamily>,
    /// The name of the mode, for example "1st fore-aft bending".
    #[serde(getter = "Mode::label")]
    label: String,
    /// Bound on the error of the eigenvalue computation, Hz.
    algebraic_error_hz: f64,
    /// Estimate of the discretization error, Hz.
    discretization_error_hz: f64,
    /// The frequency of the beam extrapolated from several numbers of segments, Hz.
    extrapolated_hz: f64,
    /// Modal mass for the shape as normalized, kg; null for torsion and yaw.
    #[serde(getter = "Mode::modal_mass_kg")]
    modal_mass_kg: Option<f64>,
    /// Modal inertia for the shape as normalized, kg m2; null except for torsion and yaw.
    #[serde(getter = "Mode::modal_inertia_kg_m2")]
    modal_inertia_kg_m2: Option<f64>,
    /// The distribution of its energy.
    energy: Energy,
    /// Effective modal masses: over all modes they add up to the diagonal of the tower's rigid
    /// inertia, if all modes have the same added mass.
    #[serde(serialize_with = "directions")]
    #[cfg_attr(
        feature = "schema",
        schemars(with = "crate::modes::serialized::Directions")
    )]
    effective_mass: [f64; 6],
    /// The effective modal masses as fractions of the total masses of the tower, with the added
    /// mass of this mode.
    #[serde(getter = "Mode::effective_mass_shares", serialize_with = "directions")]
    #[cfg_attr(
        feature = "schema",
        schemars(with = "crate::modes::serialized::Directions")
    )]
    effective_mass_shares: [f64; 6],
    /// The shape at equal heights from the base to the top.
    #[serde(serialize_with = "shape")]
    #[cfg_attr(feature = "schema", schemars(with = "crate::modes::serialized::Shape"))]
    shape: Vec<ShapePoint>,
    /// The shape at the stations of the file.
    #[serde(serialize_with = "shape")]
    #[cfg_attr(feature = "schema", schemars(with = "crate::modes::serialized::Shape"))]
    station_shape: Vec<ShapePoint>,
    /// The shape of the substructure on the scale of the other shapes; null for a tower that does
    /// not stand on members.
    frame: Option<FrameShape>,
}

fn finite_period_s(mode: &Mode) -> Option<f64> {
    Some(mode.period_s()).filter(|period_s| period_s.is_finite())
}

impl Serialize for Mode {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        ModeKeys::serialize(self, serializer)
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Mode {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Mode".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        ModeKeys::json_schema(generator)
    }
}

//! A body of the scene: its substance, its form and its points.

use serde::Serialize;

/// A body of the scene at rest: x fore-aft (downwind), y side-side, z up in the datum of the
/// stations, m.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Body {
    /// The height at which it is attached to the tower axis, m: it moves with the section there.
    /// None if it does not move.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub follows_m: Option<f64>,
    /// Its substance.
    pub of: Substance,
    /// Its form.
    pub form: Form,
    /// Its points.
    pub points: Vec<[f64; 3]>,
    /// Radius of a ball, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_m: Option<f64>,
}

/// The substance of a body, which gives its colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Substance {
    /// The nacelle.
    Rna,
    /// Hub and blades.
    Rotor,
    /// A point mass.
    Mass,
    /// A footing, a plate, a platform.
    Foundation,
    /// Ground without stiffness, and everything that does not move.
    Ground,
    /// Soil with springs.
    Soil,
    /// Water.
    Water,
    /// Springs, guy wires, moorings.
    Link,
}

/// How the points of a body define its form.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Form {
    /// The smallest convex body around its points.
    Solid,
    /// A ball around its single point.
    Ball,
    /// A straight line from its first point, which moves with the tower, to its second point, which
    /// does not.
    Line,
    /// A spring from its first point, which moves with the tower, to its second point, which does
    /// not.
    Spring,
}

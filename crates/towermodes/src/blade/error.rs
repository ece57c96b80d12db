//! Why a description is no blade.

use thiserror::Error;

use crate::number::Plain;

/// What no blade can have. Indices count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum BladeError {
    /// A number that is none.
    #[error("{quantity} is {value}, which is not a finite number")]
    NotFinite {
        /// What it is.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// What must be positive and is not.
    #[error("{quantity} of section {} is {}, but it must be positive", .section + 1, Plain(*.value))]
    NotPositive {
        /// What it is.
        quantity: &'static str,
        /// Of which section.
        section: usize,
        /// The value given.
        value: f64,
    },
    /// A tension centre so far out that stretching the blade would bend it without resistance.
    #[error(
        "the tension centre of section {} is {} m off the axis: EA times its square, {:.4e} N m2, is not less than the edge stiffness {:.4e} N m2",
        .section + 1, Plain(*.offset_m), axial_n * offset_m * offset_m, edge_n_m2
    )]
    TensionCenter {
        /// Of which section.
        section: usize,
        /// The offset, m.
        offset_m: f64,
        /// EA, N.
        axial_n: f64,
        /// EI in lag, N m².
        edge_n_m2: f64,
    },
    /// Infinite in some sections only.
    #[error(
        "{quantity} is {first:e} in section 1 and {value:e} in section {}: it is infinite in all sections, for a blade that does not move \
         so, or in none",
        .section + 1
    )]
    RigidInSomeSections {
        /// What it is.
        quantity: &'static str,
        /// Of which section.
        section: usize,
        /// The value there.
        value: f64,
        /// The value of the first section.
        first: f64,
    },
    /// A hub beyond the tip, or a negative one.
    #[error("the blade reaches from radius {} m to {} m", Plain(*.hub_m), Plain(*.tip_m))]
    NoLength {
        /// Radius of the hub, m.
        hub_m: f64,
        /// Radius of the tip, m.
        tip_m: f64,
    },
    /// Sections or borders of elements that do not go from 0 to 1.
    #[error("the {what} go from {} to {}, but the span from 0 to 1", Plain(*.first), Plain(*.last))]
    NotWhole {
        /// Which.
        what: &'static str,
        /// The first, as a share of the span.
        first: f64,
        /// The last, as a share of the span.
        last: f64,
    },
    /// Sections or borders of elements that do not rise.
    #[error("the {what} do not rise at {}", Plain(*.span))]
    NotRising {
        /// Which.
        what: &'static str,
        /// Where, as a share of the span.
        span: f64,
    },
    /// A mass at the tip that is negative.
    #[error("the mass at the tip is {} kg", Plain(*.mass_kg))]
    NegativeTip {
        /// The mass, kg.
        mass_kg: f64,
    },
    /// A body at the tip that no body is.
    #[error("the inertia at the tip has the negative principal moment {} kg m2", Plain(*.moment_kg_m2))]
    NegativeTipInertia {
        /// The moment, kg m².
        moment_kg_m2: f64,
    },
}

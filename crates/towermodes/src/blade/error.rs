//! Errors in the description of a blade.

use thiserror::Error;

use crate::number::Plain;

/// An impossible value in the description of a blade. Indices count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum BladeError {
    /// A value that is NaN or infinite.
    #[error("{quantity} is {value}, which is not a finite number")]
    NotFinite {
        /// The quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A value is not positive.
    #[error("{quantity} of section {} is {}; it must be positive", .section + 1, Plain(*.value))]
    NotPositive {
        /// The quantity.
        quantity: &'static str,
        /// Index of the section.
        section: usize,
        /// The value given.
        value: f64,
    },
    /// A value is negative.
    #[error("{quantity} of section {} is {}; it must not be negative", .section + 1, Plain(*.value))]
    Negative {
        /// The quantity.
        quantity: &'static str,
        /// Index of the section.
        section: usize,
        /// The value given.
        value: f64,
    },
    /// An edgewise inertia below m x̄², the inertia of the mass m at its centre x̄.
    #[error(
        "the edgewise inertia of section {} is {} kg m; it is about the axis of the blade, so that with a mass of {} kg/m whose centre is {} m from the axis it must be \
         at least mass times offset squared, {:.6} kg m; if the value given is about the centre of mass, add that product",
        .section + 1, Plain(*.edge_inertia_kg_m), Plain(*.mass_kg_per_m), Plain(*.offset_m), mass_kg_per_m * offset_m * offset_m
    )]
    CenterOfMass {
        /// Index of the section.
        section: usize,
        /// The offset of the centre of mass, m.
        offset_m: f64,
        /// Mass per length, kg/m.
        mass_kg_per_m: f64,
        /// The inertia given, kg m.
        edge_inertia_kg_m: f64,
    },
    /// A tension centre so far from the axis that EA times the square of its offset is not less
    /// than the edgewise stiffness.
    #[error(
        "the tension centre of section {} is too far from the axis: EA times its offset of {} m squared, {:.4e} N m2, must be less than the edgewise stiffness, {:.4e} N m2",
        .section + 1, Plain(*.offset_m), axial_n * offset_m * offset_m, edge_n_m2
    )]
    TensionCenter {
        /// Index of the section.
        section: usize,
        /// The offset, m.
        offset_m: f64,
        /// EA, N.
        axial_n: f64,
        /// EI in lag, N m².
        edge_n_m2: f64,
    },
    /// A stiffness that is infinite in some sections only.
    #[error(
        "{quantity} is {first:e} in section 1 and {value:e} in section {}; it must be infinite in all sections (no such deformation) or in \
         none",
        .section + 1
    )]
    RigidInSomeSections {
        /// The stiffness, by its name.
        quantity: &'static str,
        /// Index of the section.
        section: usize,
        /// The value in this section.
        value: f64,
        /// The value of the first section.
        first: f64,
    },
    /// A hub radius that is negative or not less than the tip radius.
    #[error("the blade extends from radius {} m to {} m; the tip radius must be larger than the hub radius, which must not be negative", Plain(*.hub_m), Plain(*.tip_m))]
    NoLength {
        /// Radius of the hub, m.
        hub_m: f64,
        /// Radius of the tip, m.
        tip_m: f64,
    },
    /// Sections or borders of elements that do not go from 0 to 1.
    #[error("the {what} are given from {} to {} of the span; they must be given from 0 to 1", Plain(*.first), Plain(*.last))]
    NotWhole {
        /// The list: "sections" or "borders of the elements".
        what: &'static str,
        /// The first, as a fraction of the span.
        first: f64,
        /// The last, as a fraction of the span.
        last: f64,
    },
    /// Sections or borders of elements that do not rise.
    #[error("the {what} must increase along the span, but do not at {}", Plain(*.span))]
    NotRising {
        /// The list: "sections" or "borders of the elements".
        what: &'static str,
        /// Where the first of them is not larger than the one before, as a fraction of the span.
        span: f64,
    },
    /// A mass at the tip that is negative.
    #[error("the tip mass is {} kg; it must not be negative", Plain(*.mass_kg))]
    NegativeTip {
        /// The mass, kg.
        mass_kg: f64,
    },
    /// A body at the tip whose inertia has a negative principal moment.
    #[error("the tip inertia has a negative principal moment, {} kg m2", Plain(*.moment_kg_m2))]
    NegativeTipInertia {
        /// The negative principal moment, kg m².
        moment_kg_m2: f64,
    },
}

//! Errors in the description of a turbine, and impossible options.

use thiserror::Error;

use crate::blade::BladeError;
use crate::frame::FrameSolveError;
use crate::number::Plain;
use crate::rotor::RotorError;
use crate::tower::TowerError;

/// Largest inertia of a generator as a multiple of that of the rotor. In wind turbines it is about
/// a tenth; far above this limit no digit of the rotor's rotation would remain.
pub(super) const MOST_GENERATOR: f64 = 1e9;

/// An impossible value in the description of a turbine.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TurbineError {
    /// An error in the description of the tower.
    #[error(transparent)]
    Tower(#[from] TowerError),
    /// An error of the frame under the tower.
    #[error(transparent)]
    Frame(#[from] FrameSolveError),
    /// An error in the description of the blade.
    #[error("a blade of the rotor: {0}")]
    Blade(#[from] BladeError),
    /// A number of blades that is not supported.
    #[error(transparent)]
    Rotor(#[from] RotorError),
    /// A number that is infinite or NaN.
    #[error("{quantity} is {value}, which is not a finite number")]
    NotFinite {
        /// The quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A value is negative.
    #[error("{quantity} is {}; it must not be negative", Plain(*.value))]
    Negative {
        /// The quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A value is not positive.
    #[error("{quantity} is {}; it must be positive", Plain(*.value))]
    NotPositive {
        /// The quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A tilt or a cone of more than 45 degrees.
    #[error("{quantity} is {:.2} degrees; it must be between -45 and 45 degrees", .angle_rad.to_degrees())]
    Angle {
        /// The quantity.
        quantity: &'static str,
        /// The angle given, rad.
        angle_rad: f64,
    },
    /// The tower carries a rotor-nacelle assembly already.
    #[error(
        "the tower carries a rotor-nacelle assembly of {} kg besides the nacelle and the rotor of the turbine; describe the tower without a rotor-nacelle assembly",
        Plain(*.mass_kg)
    )]
    TwoMachines {
        /// Mass of the rotor-nacelle assembly in the description of the tower, kg.
        mass_kg: f64,
    },
    /// The description of the blade has a rotor speed other than 0.
    #[error("the description of the blade has a rotor speed of {} rad/s; the rotor speed of a turbine is given when the turbine is solved, so the speed in the description of the blade must be 0", Plain(*.speed_rad_per_s))]
    BladeTurns {
        /// The rotor speed in the description of the blade, rad/s.
        speed_rad_per_s: f64,
    },
    /// The centrifugal force on the body at the tip is switched off.
    #[error("the centrifugal force of the body of {} kg at the tip of the blade is omitted (tip_is_pulled = false); in a turbine it must be included", Plain(*.mass_kg))]
    TipNotPulled {
        /// Its mass, kg.
        mass_kg: f64,
    },
    /// An impossible inertia at the blade tip: the largest principal moment is larger than the sum
    /// of the other two.
    #[error(
        "the largest principal inertia of the body at the tip of the blade, {} kg m2, is more than the sum of the other two, {} kg m2: this is physically impossible; the largest principal inertia must be at most that sum",
        Plain(*.largest_kg_m2), Plain(*.others_kg_m2)
    )]
    TipInertia {
        /// The largest principal moment, kg m².
        largest_kg_m2: f64,
        /// The sum of the other two, kg m².
        others_kg_m2: f64,
    },
    /// No elements, or a degree that is too low or too high.
    #[error(
        "{elements} elements of degree {degree} are not possible for {part}; the number of elements must be 1 or more and the degree from 2 to {most}"
    )]
    Mesh {
        /// Tower or blade.
        part: &'static str,
        /// Number of elements.
        elements: usize,
        /// Polynomial degree.
        degree: usize,
        /// The highest degree.
        most: usize,
    },
    /// The tower buckles under the weight on it, or the platform capsizes.
    #[error(
        "the tower with the turbine is not stable at rest: {negative} of its motions have a negative stiffness (the tower buckles or the platform capsizes)"
    )]
    Unstable {
        /// Number of such motions.
        negative: usize,
    },
    /// Generator inertia out of range.
    #[error(
        "the inertia of the generator referred to the low-speed shaft (generator inertia times the gear ratio squared) is {} kg m2, more than {MOST_GENERATOR:e} times the inertia of the rotor, {} kg m2; the unit of both is kg m2",
        Plain(*.generator_kg_m2), Plain(*.rotor_kg_m2)
    )]
    Generator {
        /// Inertia of the generator referred to the low-speed shaft, kg m².
        generator_kg_m2: f64,
        /// Inertia of hub and blades about the shaft, kg m².
        rotor_kg_m2: f64,
    },
    /// Numbers so large that products of them are infinite.
    #[error("the values of the turbine are too large: their products overflow")]
    Overflow,
    /// A limit that is not positive, or infinite.
    #[error("the limit of the frequencies is {} Hz; it must be positive and finite", Plain(*.limit_hz))]
    Limit {
        /// The limit given, Hz.
        limit_hz: f64,
    },
    /// A speed that is infinite or NaN.
    #[error("the speed of the rotor is {rotor_speed_rpm} rpm, which is not a finite number")]
    Speed {
        /// The speed given, rpm.
        rotor_speed_rpm: f64,
    },
}

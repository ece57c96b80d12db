//! Natural frequencies against the speed of a rotor.

use thiserror::Error;

use crate::verdict::Verdict;
use towermodes::blade::BladeError;
use towermodes::modes::Family;
use towermodes::tower::TowerError;
use towermodes::tower::{Rotor, Rpm};
use towermodes::{BladeFamily, SolveError};

/// The margin that guidelines for certification ask for: an excitation must be 5 % away from a
/// natural frequency (Germanischer Lloyd, *Guideline for the Certification of Wind Turbines*, 2010;
/// DIBt, *Richtlinie für Windenergieanlagen*, 2012: f_R/f₀ ≤ 0.95 or ≥ 1.05).
pub const DEFAULT_MARGIN: f64 = 0.05;

/// Diagrams go to this many times the highest operating speed.
pub const BEYOND_OPERATION: f64 = 1.2;

/// What is asked of a diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct CampbellOptions {
    /// The least relative distance |n Ω/f − 1| of an excitation to a natural frequency that passes.
    pub margin: f64,
    /// Which multiples of the rotor's speed; empty is the speed itself and one, two and three times
    /// the number of blades.
    pub multiples: Vec<usize>,
    /// How many modes of a blade, from the lowest.
    pub blade_modes: usize,
    /// How many equally spaced speeds from standstill to
    /// [`BEYOND_OPERATION`](super::BEYOND_OPERATION) times the highest a blade is solved at, 2 to
    /// 1000; the lowest and the highest speed of operation come in addition where they are not
    /// among them.
    pub speeds: usize,
}

/// What has a natural frequency.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Excited {
    /// A mode of the tower: its number in the list of its solution, from 1, its family and order.
    Tower {
        /// Its number.
        number: usize,
        /// Its family.
        family: Family,
        /// Its order in the family.
        order: usize,
    },
    /// A mode of a rotating blade, followed from speed to speed: its family and order at
    /// standstill.
    Blade {
        /// Its family.
        family: BladeFamily,
        /// Its order in the family.
        order: usize,
    },
}

/// A natural frequency against the rotor's speed.
#[derive(Debug, Clone, PartialEq)]
pub struct FrequencyLine {
    /// Of what.
    pub of: Excited,
    /// What it is called: "1st fore-aft bending", "blade 1st flap".
    pub label: String,
    /// Rotor speed (rpm) and frequency (Hz) by rising speed, from standstill; of a tower's mode the
    /// two ends.
    pub points: Vec<[f64; 2]>,
    /// The largest estimated error of the frequencies, Hz.
    pub error_hz: f64,
    /// Why it ends before the others; none if it goes on to the end.
    pub lost: Option<LineEnd>,
}

/// Where a mode of a blade was lost: none of the modes at the next speed is like it, and its line
/// ends before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineEnd {
    /// The speed at which it is not found, rpm.
    pub rotor_speed_rpm: f64,
    /// How alike the mode is that was left for it there: the modal assurance criterion, 0 to 1,
    /// where 1 is the same shape.
    pub alike: f64,
}

/// How far an excitation stays from a natural frequency in operation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margin {
    /// Which line of the diagram, from 0.
    pub line: usize,
    /// Which multiple n of the rotor's speed Ω.
    pub multiple: usize,
    /// The speed of operation at which they are nearest, rpm; of a line that was lost as far as it
    /// goes.
    pub nearest_rpm: f64,
    /// The excitation n Ω there, Hz.
    pub excitation_hz: f64,
    /// The natural frequency f there, Hz.
    pub natural_hz: f64,
    /// n Ω/f − 1 there: negative where the excitation stays below, zero where they meet.
    pub distance: f64,
    /// What it is worth.
    pub verdict: Verdict,
}

impl Margin {
    /// Whether it is worth a look: the excitation is less than a factor 2 from the natural
    /// frequency, or the pair does not pass.
    pub fn is_near(&self) -> bool {
        let ratio = 1.0 + self.distance;
        self.verdict != Verdict::Pass || (0.5 < ratio && ratio < 2.0)
    }
}

/// Where the first bending frequency of a tower lies among the excitations.
///
/// The rotor's speed excites from its lowest to its highest speed, its blades' passing from the
/// number of blades times the one to that times the other. Where both ranges overlap (a wide range
/// of speeds), what is in both counts as met by the rotor's speed, and nothing is soft-stiff. A
/// rotor of one blade has one range: below it is soft-soft, above it stiff-stiff.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StiffnessClass {
    /// Below the rotor's lowest speed.
    SoftSoft,
    /// Between the rotor's highest speed and the lowest passing frequency of the blades.
    SoftStiff,
    /// Above the highest passing frequency of the blades.
    StiffStiff,
    /// Within the range of this multiple of the rotor's speed: it is met in operation.
    Met {
        /// The multiple: 1 or the number of blades.
        multiple: usize,
    },
}

/// Natural frequencies against the speed of a rotor, with margins.
#[derive(Debug, Clone, PartialEq)]
pub struct Campbell {
    /// The rotor.
    pub rotor: Rotor,
    /// The margin asked for.
    pub margin: f64,
    /// The multiples of the rotor's speed, rising.
    pub multiples: Vec<usize>,
    /// The frequency below which every mode of the tower is in the list, Hz; none if all modes are.
    pub known_to_hz: Option<f64>,
    /// The lines: modes of the tower by frequency, then those of the blade.
    pub lines: Vec<FrequencyLine>,
    /// Every line against every multiple, by line, then by multiple.
    pub margins: Vec<Margin>,
    /// Where the lowest mode that bends the tower fore-aft lies, and that side-side, if they are in
    /// the list; a coupled mode may be both.
    pub classes: Vec<(Family, StiffnessClass)>,
    /// Which lines these modes are, from 0, in the order of `classes`.
    pub first_bending: Vec<usize>,
}

/// Why there is no diagram.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum CampbellError {
    /// A margin that is none.
    #[error("the margin is {margin}, but it must be above 0 and below 1")]
    Margin {
        /// The margin.
        margin: f64,
    },
    /// A multiple of nothing.
    #[error("a multiple of the rotor's speed is 0")]
    Multiple,
    /// Too few speeds, or more than anybody looks at.
    #[error("{speeds} speeds; a blade's modes are followed over 2 to 1000")]
    Speeds {
        /// How many.
        speeds: usize,
    },
    /// A rotor that cannot be.
    #[error(transparent)]
    Rotor(#[from] TowerError),
    /// A solution whose shapes are at other heights than the tower's stations.
    #[error("the solution is not of this tower")]
    OtherTower,
    /// A blade that cannot be.
    #[error("the blade: {0}")]
    NoBlade(#[from] BladeError),
    /// A blade that cannot be solved at a speed.
    #[error("the blade at {} rpm: {error}", Rpm(*.rotor_speed_rpm))]
    Blade {
        /// The speed, rpm.
        rotor_speed_rpm: f64,
        /// Why.
        error: SolveError,
    },
}

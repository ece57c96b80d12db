//! The Campbell diagram: natural frequencies against the rotor speed, and their distances from
//! the excitations.

use thiserror::Error;

use super::mode_class::ModeClass;
use super::not_checked::NotChecked;
use crate::verdict::Verdict;
use towermodes::blade::BladeError;
use towermodes::modes::Family;
use towermodes::tower::TowerError;
use towermodes::tower::{Rotor, Rpm};
use towermodes::turbine::TurbineModeName;
use towermodes::{BladeFamily, SolveError};

/// The margin that certification guidelines require: an excitation must be at least 5 % away from a
/// natural frequency (Germanischer Lloyd, *Guideline for the Certification of Wind Turbines*, 2010;
/// DIBt, *Richtlinie für Windenergieanlagen*, 2012: f_R/f₀ ≤ 0.95 or ≥ 1.05).
pub const DEFAULT_MARGIN: f64 = 0.05;

/// Diagrams extend to this multiple of the highest operating speed.
pub const BEYOND_OPERATION: f64 = 1.2;

/// Options of a Campbell diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct CampbellOptions {
    /// The required distance |d| of an excitation from a natural frequency, above 0 and below 1.
    pub margin: f64,
    /// The multiples n of the rotor speed; if empty, 1 and one, two and three times the number of
    /// blades.
    pub multiples: Vec<usize>,
    /// Number of blade modes, from the lowest.
    pub blade_modes: usize,
    /// Number of equally spaced rotor speeds at which a blade is solved, 2 to 1000, from standstill
    /// to [`BEYOND_OPERATION`] times the highest operating speed. The lowest and the highest
    /// operating speed are added if they are not among them.
    pub speeds: usize,
    /// Whether the speeds of the rotor are its operating speeds, as by default. Otherwise they are
    /// only the ends of the diagram, and it has no verdicts.
    pub speeds_are_known: bool,
}

impl Default for CampbellOptions {
    fn default() -> Self {
        Self {
            margin: DEFAULT_MARGIN,
            multiples: Vec::new(),
            blade_modes: 6,
            speeds: 25,
            speeds_are_known: true,
        }
    }
}

impl CampbellOptions {
    /// The multiples of the rotor speed, in increasing order, each once.
    pub fn multiples_of(&self, rotor: &Rotor) -> Vec<usize> {
        let blades = rotor.blades;
        let mut multiples = match &self.multiples[..] {
            [] => vec![1, blades, 2 * blades, 3 * blades],
            asked => asked.to_vec(),
        };
        multiples.sort_unstable();
        multiples.dedup();
        multiples
    }
}

/// The mode that a natural frequency belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Excited {
    /// A mode of the tower.
    Tower {
        /// Its number in the list of the solution, from 1.
        number: usize,
        /// Its family.
        family: Family,
        /// Its order in the family, from 1.
        order: usize,
        /// Class of the mode.
        class: ModeClass,
    },
    /// A mode of a rotating blade, followed from speed to speed. Family and order are those at
    /// standstill.
    Blade {
        /// Its family.
        family: BladeFamily,
        /// Its order in the family, from 1.
        order: usize,
    },
    /// A mode of the whole turbine over the speeds at which it has one name; see
    /// [`mod@crate::whirl`].
    Turbine {
        /// The name.
        name: TurbineModeName,
        /// The index of the curve that has the name there.
        curve: usize,
        /// Class of the mode; see [`CurvePoint::class`](crate::whirl::CurvePoint::class).
        class: ModeClass,
    },
}

/// A natural frequency against the rotor speed: one line of the diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct FrequencyLine {
    /// The mode.
    pub of: Excited,
    /// Its name: "1st fore-aft bending", "blade 1st flap".
    pub label: String,
    /// Rotor speed (rpm) and natural frequency (Hz) by increasing speed, from standstill. The line
    /// of a tower mode is horizontal and has two points.
    pub points: Vec<[f64; 2]>,
    /// The largest estimated error of the frequencies, Hz.
    pub error_hz: f64,
    /// The end of a line that does not reach the highest speed, with the reason; none otherwise.
    pub lost: Option<LineEnd>,
}

impl FrequencyLine {
    /// Whether it is assessed as a blade mode, of a single blade or of the blades of a turbine.
    pub fn is_of_blade(&self) -> bool {
        self.class() == ModeClass::Blades
    }

    /// Class of its mode.
    pub fn class(&self) -> ModeClass {
        match self.of {
            Excited::Tower { class, .. } | Excited::Turbine { class, .. } => class,
            Excited::Blade { .. } => ModeClass::Blades,
        }
    }

    /// Whether its mode has the name of the first mode of a family. The lines of a turbine in
    /// [`Campbell::first_bending`] always have it.
    pub(super) fn is_named_first_of(&self, family: Family) -> bool {
        match self.of {
            Excited::Tower {
                family: own, order, ..
            } => own == family && order == 1,
            Excited::Blade { .. } => false,
            Excited::Turbine { .. } => true,
        }
    }

    /// Whether both lines have the same mode name: a turbine has a line for each curve with the
    /// name.
    pub fn is_of_same_mode(&self, other: &Self) -> bool {
        match (self.of, other.of) {
            (Excited::Turbine { name, .. }, Excited::Turbine { name: other, .. }) => name == other,
            (of, other) => of == other,
        }
    }
}

/// The end of the line of a blade mode that was lost: no mode at the next speed has a similar
/// shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineEnd {
    /// The first rotor speed at which the mode is not found, rpm.
    pub rotor_speed_rpm: f64,
    /// The largest modal assurance criterion there with a mode that does not belong to another
    /// line, 0 to 1 (1: the same shape).
    pub mac: f64,
}

/// The distance of an excitation from a natural frequency in the operating range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margin {
    /// Index of the line in the diagram, from 0.
    pub line: usize,
    /// The multiple n of the rotor speed Ω.
    pub multiple: usize,
    /// The operating speed at which both are closest, rpm. A line that ends early is considered up
    /// to its end.
    pub nearest_rpm: f64,
    /// The excitation n Ω there, Hz.
    pub excitation_hz: f64,
    /// The natural frequency f there, Hz.
    pub natural_hz: f64,
    /// d = n Ω/f − 1 there, with the rotor speed Ω in Hz: negative if the excitation is below the
    /// natural frequency, 0 if they cross.
    pub distance: f64,
    /// The verdict on the distance.
    pub verdict: Verdict,
}

impl Margin {
    /// Whether tables list it by default: excitation and natural frequency differ by less than a
    /// factor of 2, or the verdict is not PASS.
    pub fn is_near(&self) -> bool {
        let ratio = 1.0 + self.distance;
        self.verdict.is_objection() || (0.5 < ratio && ratio < 2.0)
    }
}

/// The stiffness class of a tower: where its first bending frequency lies among the excitations.
///
/// In operation 1P ranges from the lowest to the highest rotor speed, and the blade passing
/// frequency over the number of blades times that range. If both ranges overlap (a wide range of
/// speeds), a frequency in both counts as crossed by 1P, and no tower is soft-stiff. A rotor of one
/// blade has one range: below it a tower is soft-soft, above it stiff-stiff.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StiffnessClass {
    /// Below 1P at the lowest operating speed.
    SoftSoft,
    /// Between 1P at the highest and the blade passing frequency at the lowest operating speed.
    SoftStiff,
    /// Above the blade passing frequency at the highest operating speed.
    StiffStiff,
    /// A multiple of the rotor speed crosses the frequency at some operating speed.
    Coincident {
        /// The multiple: 1 or the number of blades.
        multiple: usize,
    },
}

/// A first bending mode of a turbine with less than 60 % of its energy in its motion at the highest
/// operating speed. Modes are names, frequencies (Hz) and the fraction of their energy in the
/// motion.
#[derive(Debug, Clone, PartialEq)]
pub struct SharedFirst {
    /// The motion.
    pub family: Family,
    /// The mode that has the name.
    pub named: (String, f64, f64),
    /// The others with at least 25 % of the energy of the first mode of this motion, by frequency.
    pub others: Vec<(String, f64, f64)>,
}

/// Natural frequencies against the rotor speed, with their distances from all excitations.
#[derive(Debug, Clone, PartialEq)]
pub struct Campbell {
    /// The rotor.
    pub rotor: Rotor,
    /// The required distance, a fraction of the natural frequency.
    pub margin: f64,
    /// The multiples of the rotor speed, in increasing order.
    pub multiples: Vec<usize>,
    /// The frequency below which the list of tower modes is complete, Hz; none if the list has all
    /// modes.
    pub known_to_hz: Option<f64>,
    /// The lines: tower modes by frequency, then blade modes. A mode of a turbine has a line for
    /// each curve with its name.
    pub lines: Vec<FrequencyLine>,
    /// The distance of every mode that is [assessed](ModeClass::is_judged) from every multiple, by
    /// line, then by multiple. For a mode with several lines it is the distance of the worst line.
    pub margins: Vec<Margin>,
    /// The stiffness class of the first fore-aft and of the first side-side bending mode, if they
    /// are in the list. If several modes share the motion, it is the class of the lowest mode that
    /// [has a large share of it](towermodes::modes::Holders). Empty if nothing is checked.
    pub classes: Vec<(Family, StiffnessClass)>,
    /// The indices of the lines of these modes, from 0, in the order of `classes` if that is not
    /// empty.
    pub first_bending: Vec<usize>,
    /// The first bending modes of a turbine that share their motion with other modes.
    pub shared: Vec<SharedFirst>,
    /// Why there are no verdicts; empty if there are.
    pub not_checked: Vec<NotChecked>,
}

impl Campbell {
    /// Whether a distance belongs to a first bending mode.
    #[must_use]
    pub fn is_of_first_bending(&self, margin: &Margin) -> bool {
        let own = &self.lines[margin.line];
        let mut first = self.first_bending.iter();
        first.any(|line| self.lines[*line].is_of_same_mode(own))
    }

    /// The multiples that can fail with tower modes: 1P and the blade passing frequency, if they
    /// are in the diagram.
    pub fn strong_multiples(&self) -> impl Iterator<Item = usize> + '_ {
        let multiples = self.multiples.iter().copied();
        multiples.filter(|multiple| is_strong(*multiple, &self.rotor))
    }

    /// Whether tables list a pair by default: it [is near](Margin::is_near), or it consists of a
    /// first bending mode and 1P or the blade passing frequency.
    #[must_use]
    pub fn is_listed(&self, margin: &Margin) -> bool {
        let is_strong = is_strong(margin.multiple, &self.rotor);
        margin.is_near() || (is_strong && self.is_of_first_bending(margin))
    }

    /// The pair that determines the verdict on the mode of a line: the one with the worst verdict,
    /// among equal verdicts the one with the smallest distance.
    #[must_use]
    pub fn decisive(&self, line: &FrequencyLine) -> Option<&Margin> {
        let margins = self.margins.iter();
        let own = margins.filter(|margin| self.lines[margin.line].is_of_same_mode(line));
        own.max_by(|a, b| {
            let by_distance = || b.distance.abs().total_cmp(&a.distance.abs());
            // Of several crossings the lowest multiple decides: it has the strongest excitation.
            let by_multiple = || b.multiple.cmp(&a.multiple);
            let by_verdict = a.verdict.cmp(&b.verdict);
            by_verdict.then_with(by_distance).then_with(by_multiple)
        })
    }

    /// The lines of each mode, in the order of their first lines: a mode of a turbine has a line
    /// for each curve with its name.
    #[must_use]
    pub fn lines_by_mode(&self) -> Vec<Vec<&FrequencyLine>> {
        let mut modes: Vec<Vec<&FrequencyLine>> = Vec::new();
        for line in &self.lines {
            let mut known = modes.iter_mut();
            match known.find(|lines| lines[0].is_of_same_mode(line)) {
                Some(lines) => lines.push(line),
                None => modes.push(vec![line]),
            }
        }
        modes
    }
}

/// Whether a multiple is 1P or the blade passing frequency.
pub(super) fn is_strong(multiple: usize, rotor: &Rotor) -> bool {
    multiple == 1 || multiple == rotor.blades
}

/// Why there is no Campbell diagram.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum CampbellError {
    /// The required margin is not between 0 and 1.
    #[error("the margin is {margin}, but it must be above 0 and below 1")]
    Margin {
        /// The margin.
        margin: f64,
    },
    /// A multiple is 0.
    #[error("a multiple of the rotor speed is 0; multiples start at 1")]
    Multiple,
    /// The number of speeds is not 2 to 1000.
    #[error("the number of rotor speeds is {speeds}, but it must be 2 to 1000")]
    Speeds {
        /// The given number.
        speeds: usize,
    },
    /// The description of the rotor is invalid.
    #[error(transparent)]
    Rotor(#[from] TowerError),
    /// The shapes of the solution are at other heights than those of the tower.
    #[error("the solution is not of this tower")]
    OtherTower,
    /// The description of the blade is invalid.
    #[error("the blade: {0}")]
    NoBlade(#[from] BladeError),
    /// The blade cannot be solved at a rotor speed.
    #[error("the blade at {} rpm: {error}", Rpm(*.rotor_speed_rpm))]
    Blade {
        /// The speed, rpm.
        rotor_speed_rpm: f64,
        /// The error of the solver.
        error: SolveError,
    },
}

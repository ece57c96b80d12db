//! A solved tower as a page shows it: numbers with all digits, and as the terminal prints them.

use serde::Serialize;
use towermodes::number::{four_digits, with_error};
use towermodes::{Mode, Solution, Tower, Warning};
use towermodes_analysis::damping::{ModeDamping, damping};
use towermodes_analysis::resonance::{Assessment, Campbell};
use towermodes_files::TowerInput;
use towermodes_report::figures::{AnimationData, animation_data};
use towermodes_report::wording::{buckling_load_factor, completeness, computed_by, mode_shape};

use super::explorer::{Explorer, Solved};
use super::linked::numbers;
use super::refusal::{Refusal, names_at};
use super::resonance::{Resonance, Verdicted, verdict_on};
use super::state::State;

/// A solved tower.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answer {
    /// The values of all numbers, in the order of the sheet.
    pub values: Vec<f64>,
    /// Masses, height, buckling load factor.
    pub facts: Vec<Fact>,
    /// The modes by frequency.
    pub modes: Vec<AnsweredMode>,
    /// The proof that no mode is missing, in one line.
    pub certificate: String,
    /// Method and mesh, and that the rotor of a turbine is rigid here.
    pub method: String,
    /// Possible input mistakes and limits of the results.
    pub warnings: Vec<Remark>,
    /// The resonance check; none if the rotor speed is unknown.
    pub resonance: Option<Resonance>,
    /// The tower with its surroundings and the shapes of its modes.
    pub scene: AnimationData,
    /// Its duration.
    #[serde(flatten)]
    pub time: Timed,
}

/// Duration of an answer, ms.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Timed {
    /// The solution alone.
    pub solve_ms: f64,
    /// All of it.
    pub answer_ms: f64,
}

/// A number of the whole tower.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Fact {
    /// Its key: `tower_mass_kg`.
    pub key: &'static str,
    /// Its name: "mass of the tower".
    pub name: &'static str,
    /// Its value; none where the tower has none.
    pub value: Option<f64>,
    /// Its unit.
    pub unit: &'static str,
    /// Value and unit, rounded.
    pub text: String,
}

/// A mode of the answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnsweredMode {
    /// Its number in the list, from 1.
    pub number: usize,
    /// Its name: "1st fore-aft bending".
    pub label: String,
    /// The name, with its share and other motions where it has less than 90 % of the energy.
    pub shape: String,
    /// Its family: `fore-aft`.
    pub family: &'static str,
    /// Its order in the family, from 1.
    pub order: usize,
    /// Natural frequency, Hz, with all digits.
    pub frequency_hz: f64,
    /// Estimated error, Hz.
    pub error_hz: f64,
    /// The frequency with the digits that its error leaves.
    pub frequency: String,
    /// The error with as many decimals.
    pub error: String,
    /// Period, s; none of a motion that nothing resists.
    pub period_s: Option<f64>,
    /// Effective masses in x, y, z and about x, y, z as fractions of the whole; none where nothing
    /// moves.
    pub effective_mass: [Option<f64>; 6],
    /// Modal mass of the shape of the scene: kg, or kg m² for torsion and yaw.
    pub modal_mass: f64,
    /// The damping ratio of the parts whose loss factors the file gives, and that with the rotor
    /// in the wind at its operating speeds.
    pub damping: Option<DampedMode>,
    /// The verdict on the closest excitation.
    pub verdict: Option<Verdicted>,
}

/// The damping of a mode, as fractions of critical damping.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DampedMode {
    /// Damping ratio from the loss factors of the parts of the tower; none if the file gives no
    /// loss factor.
    pub ratio: Option<f64>,
    /// Rotor speed (rpm) and damping ratio, including the aerodynamic damping of the rotor.
    pub running: Vec<[f64; 2]>,
}

/// A warning with the numbers that it is about.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Remark {
    /// The warning.
    pub text: String,
    /// The names of the numbers.
    pub parameters: Vec<String>,
}

impl Explorer {
    /// Solves the tower with changed numbers.
    ///
    /// # Errors
    /// [`Refusal`]: the tower cannot be, or cannot be solved.
    pub fn solve(&self, state: &State) -> Result<Answer, Refusal> {
        let started = self.now_ms();
        let solved = self.solved(state)?;
        let mut answer = Answer::new(&solved, &self.exploration.input);
        answer.time = Timed {
            solve_ms: solved.solve_ms,
            answer_ms: self.now_ms() - started,
        };
        Ok(answer)
    }
}

impl Answer {
    /// The answer for a solved tower; its numbers are in the order of those of its file.
    pub(crate) fn new(solved: &Solved, file: &TowerInput) -> Self {
        let (tower, solution) = (&solved.tower, &solved.solution);
        let description = &solved.input.description;
        let all = numbers(file).into_iter();
        let campbell = solved.assessment.as_ref().map(|of| &of.campbell);
        let damped = damped(solved);
        let of_mode = |mode: &Mode| AnsweredMode {
            damping: damped.get(mode.number - 1).cloned(),
            ..AnsweredMode::new(mode, campbell)
        };
        let warnings = solution.warnings.iter();
        Self {
            values: all.map(|one| one.value(description)).collect(),
            facts: facts(tower, solution),
            modes: solution.modes.iter().map(of_mode).collect(),
            certificate: completeness(solution),
            method: method(solution, file),
            warnings: warnings.map(|one| Remark::new(one, solved)).collect(),
            resonance: solved.assessment.as_ref().map(checked),
            scene: animation_data(description, tower, solution),
            time: Timed::default(),
        }
    }
}

fn checked(of: &Assessment) -> Resonance {
    let remarks = of.remarks.iter().map(ToString::to_string);
    Resonance::new(&of.campbell, of.campbell.verdict(), remarks)
}

/// The damping of all modes, if the file gives any.
fn damped(solved: &Solved) -> Vec<DampedMode> {
    let rotor = solved.assessment.as_ref().map(|of| &of.campbell.rotor);
    let damping = damping(&solved.input.description, &solved.solution, rotor);
    let of_mode = |mode: &ModeDamping| DampedMode {
        ratio: mode.damping_ratio,
        running: (0..mode.aerodynamic.len())
            .filter_map(|speed| Some([mode.aerodynamic[speed].rotor_rpm, mode.running(speed)?]))
            .collect(),
    };
    // Without loss factors the modes have no energy by parts.
    damping.map_or_else(|_| Vec::new(), |of| of.modes.iter().map(of_mode).collect())
}

/// The solver of a page knows towers alone.
fn method(solution: &Solution, file: &TowerInput) -> String {
    let computed = computed_by(solution);
    match file.turbine {
        Some(_) => format!("{computed}; in the list of the tower the rotor is a rigid body"),
        None => computed,
    }
}

impl Remark {
    fn new(warning: &Warning, solved: &Solved) -> Self {
        let description = &solved.input.description;
        let parameters = warning.place().map(|place| names_at(place, description));
        Self {
            text: warning.to_string(),
            parameters: parameters.unwrap_or_default(),
        }
    }
}

impl AnsweredMode {
    fn new(mode: &Mode, campbell: Option<&Campbell>) -> Self {
        let (hz, error_hz) = (mode.frequency_hz, mode.error_hz());
        let shares = mode.effective_mass_shares();
        let shares = shares.map(|share| share.is_finite().then_some(share));
        Self {
            number: mode.number,
            label: mode.label(),
            shape: mode_shape(mode),
            family: mode.family.name(),
            order: mode.order,
            frequency_hz: hz,
            error_hz,
            frequency: with_error(hz, hz, error_hz).trim().to_owned(),
            error: with_error(error_hz, hz, error_hz).trim().to_owned(),
            period_s: (hz > 0.0).then(|| mode.period_s()),
            effective_mass: shares,
            modal_mass: mode.modal_mass,
            damping: None,
            verdict: campbell.and_then(|of| verdict_on(of, mode.number)),
        }
    }
}

fn facts(tower: &Tower, solution: &Solution) -> Vec<Fact> {
    let tonnes = |kg: f64| format!("{} t", four_digits(kg / 1000.0));
    let fact = |key, name, value: f64, unit, text: String| Fact {
        key,
        name,
        value: value.is_finite().then_some(value),
        unit,
        text,
    };
    let (own_kg, rna_kg, height_m) = (tower.mass_kg(), tower.rna().mass_kg, tower.height_m());
    let height = format!("{} m", four_digits(height_m));
    let mut facts = vec![
        fact(
            "tower_mass_kg",
            "mass of the tower",
            own_kg,
            "kg",
            tonnes(own_kg),
        ),
        fact(
            "rna_mass_kg",
            "mass of the RNA",
            rna_kg,
            "kg",
            tonnes(rna_kg),
        ),
        fact("height_m", "height", height_m, "m", height),
    ];
    let buckling = solution.buckling_load_factor.map(|factor| {
        let (key, name) = ("buckling_load_factor", "buckling load factor");
        fact(key, name, factor, "", buckling_load_factor(factor))
    });
    facts.extend(buckling);
    facts
}

//! A tower as its file describes it, solved with changed input values. Each answer to the page has
//! its own file in this folder.

use std::sync::{Mutex, PoisonError};

use towermodes::{Damping, Options, Solution, Solver, Tower};
use towermodes_analysis::resonance::{
    Assessment, CampbellOptions, GivenRotor, assess, reach_hz, solve_to_reach,
};
use towermodes_files::TowerInput;

use super::refusal::Refusal;
use super::state::State;

/// Writes the report of an input; returns the page, or the reason why there is none. The texts are
/// the arguments of the command that writes the same report.
pub type Reporter = Box<dyn Fn(TowerInput, &[String]) -> Result<String, String> + Send + Sync>;

/// Returns whether a long computation shall continue; if not, it is cancelled.
pub type Wanted<'a> = &'a dyn Fn() -> bool;

/// Number of heights of the shapes that the page draws.
pub const POINTS: usize = 41;

/// The data of an explorer.
pub struct Exploration {
    /// The tower as its file describes it, before any input value is changed.
    pub input: TowerInput,
    /// The options of each solution.
    pub options: Options,
    /// Whether more modes are solved until they cover the excitations of the rotor.
    pub covers_excitations: bool,
    /// Rotor data that replace those of the file.
    pub rotor: GivenRotor,
    /// The options of the resonance check.
    pub campbell: CampbellOptions,
    /// The file as the user wrote it.
    pub file: String,
    /// The command-line options that every command with this file needs, as separate arguments.
    pub reading: Vec<String>,
    /// The options of method and mesh, as separate arguments.
    pub solving: Vec<String>,
    /// The options of the rotor, as separate arguments.
    pub rotating: Vec<String>,
    /// Another tower with which the page compares this tower, as its file describes it.
    pub against: Option<Box<Exploration>>,
    /// Writes reports.
    pub report: Reporter,
    /// Milliseconds since an arbitrary moment, to measure durations.
    pub clock: fn() -> f64,
}

impl Exploration {
    /// The data of an explorer without options: the file determines how the tower is solved.
    pub fn of_file(input: TowerInput, file: String, report: Reporter, clock: fn() -> f64) -> Self {
        let options = Options {
            points: POINTS,
            ..input.prescribed.options(None, None)
        };
        Self {
            input,
            options,
            covers_excitations: true,
            rotor: GivenRotor::default(),
            campbell: CampbellOptions::default(),
            file,
            reading: Vec::new(),
            solving: Vec::new(),
            rotating: Vec::new(),
            against: None,
            report,
            clock,
        }
    }
}

/// The explorer of one tower.
pub struct Explorer {
    pub(crate) exploration: Exploration,
    solver: Mutex<Solver>,
    against: Option<Box<Explorer>>,
}

/// A tower with changed input values, and its solution.
pub(crate) struct Solved {
    pub(crate) input: TowerInput,
    pub(crate) tower: Tower,
    pub(crate) solution: Solution,
    /// The resonance check, if the rotor speed is known.
    pub(crate) assessment: Option<Assessment>,
    pub(crate) solve_ms: f64,
}

impl Explorer {
    /// An explorer of a tower.
    pub fn new(mut exploration: Exploration) -> Self {
        let against = exploration.against.take();
        Self {
            against: against.map(|other| Box::new(Self::new(*other))),
            exploration,
            solver: Mutex::default(),
        }
    }

    /// The explorer that a state belongs to: the other tower if the state belongs to it and there
    /// is one.
    pub(crate) fn of(&self, state: &State) -> &Self {
        let other = self.against.as_deref().filter(|_| state.is_of_other);
        other.unwrap_or(self)
    }

    /// The explorer of the tower of the comparison.
    pub(crate) fn other(&self) -> Option<&Self> {
        self.against.as_deref()
    }

    /// The tower with changed input values, and its checked description.
    pub(crate) fn changed(&self, state: &State) -> Result<(TowerInput, Tower), Refusal> {
        let input = state.apply(&self.exploration.input);
        let input = input.map_err(|error| Refusal::of_setting(&error))?;
        let tower = Tower::new(input.description.clone());
        match tower {
            Ok(tower) => Ok((input, tower)),
            Err(error) => Err(Refusal::of_tower(&error, &input.description)),
        }
    }

    pub(crate) fn solved(&self, state: &State) -> Result<Solved, Refusal> {
        let (input, tower) = self.changed(state)?;
        let started = self.now_ms();
        let solution = self.solution(&input, &tower, self.options(&input));
        let solution = solution.map_err(|error| Refusal::of_solve(&error))?;
        let solve_ms = self.now_ms() - started;
        let assessment = self.assessment(&input, &tower, &solution)?;
        Ok(Solved {
            input,
            tower,
            solution,
            assessment,
            solve_ms,
        })
    }

    fn solution(
        &self,
        input: &TowerInput,
        tower: &Tower,
        options: Options,
    ) -> Result<Solution, towermodes::SolveError> {
        let of = &self.exploration;
        let rotor = self.rotor(input).filter(|_| of.covers_excitations);
        self.solver().with(options, |solver| match rotor {
            Some(rotor) => solve_to_reach(solver, tower, reach_hz(&rotor, &of.campbell)),
            None => solver.solve_certain(tower),
        })
    }

    /// The resonance check of the tower modes. Blade modes are omitted: they would have to be
    /// solved at many rotor speeds for every frame, and no slider changes them; they are in the
    /// report.
    fn assessment(
        &self,
        input: &TowerInput,
        tower: &Tower,
        solution: &Solution,
    ) -> Result<Option<Assessment>, Refusal> {
        let Some(rotor) = self.rotor(input) else {
            return Ok(None);
        };
        let assessed = assess(tower, solution, None, &rotor, &self.exploration.campbell);
        let assessed = assessed.map(Some);
        assessed.map_err(|error| Refusal::of_campbell(&error, &input.description))
    }

    /// The rotor of the description with the data of the command line in place of its own.
    pub(crate) fn rotor(&self, input: &TowerInput) -> Option<towermodes::Rotor> {
        let given = &self.exploration.rotor;
        let chosen = given.in_place_of(input.description.rotor, input.blades);
        chosen.map(|chosen| chosen.rotor)
    }

    /// The options; without the element boundaries of a BModes deck if a height has changed.
    pub(crate) fn options(&self, input: &TowerInput) -> Options {
        let mut options = self.exploration.options.clone();
        options.borders_m = options
            .borders_m
            .filter(|_| input.prescribed.borders_m.is_some());
        options.energy_parts |= input.description.damping != Damping::default();
        options
    }

    pub(crate) fn now_ms(&self) -> f64 {
        (self.exploration.clock)()
    }

    pub(crate) fn solver(&self) -> std::sync::MutexGuard<'_, Solver> {
        // Its memory is scratch: a panic leaves nothing in it that the next solve reads.
        self.solver.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

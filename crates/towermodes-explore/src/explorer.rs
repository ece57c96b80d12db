//! A tower as its file describes it, solved with changed numbers. Each answer to a page has a file.

use std::sync::{Mutex, PoisonError};

use towermodes::{Damping, Options, Solution, Solver, Tower};
use towermodes_analysis::resonance::{
    Assessment, CampbellOptions, GivenRotor, assess, reach_hz, solve_to_reach,
};
use towermodes_files::TowerInput;

use super::refusal::Refusal;
use super::state::State;

/// Writes the report of an input: the page, or why there is none. The words are the command that
/// writes the same report.
pub type Reporter = Box<dyn Fn(TowerInput, &[String]) -> Result<String, String> + Send + Sync>;

/// Returns whether a long computation shall continue; if not, it is cancelled.
pub type Wanted<'a> = &'a dyn Fn() -> bool;

/// Heights of the shapes: as many as the page draws.
pub const POINTS: usize = 41;

/// The data of an explorer.
pub struct Exploration {
    /// The tower as its file describes it, before any number is changed.
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
    /// The options of the command line that every command with this file needs, as words.
    pub reading: Vec<String>,
    /// The options of method and mesh, as words.
    pub solving: Vec<String>,
    /// The options of the rotor, as words.
    pub rotating: Vec<String>,
    /// Another tower that the page compares with, as its file describes it.
    pub against: Option<Box<Exploration>>,
    /// Writes reports.
    pub report: Reporter,
    /// Milliseconds from any moment on, to measure times.
    pub clock: fn() -> f64,
}

impl Exploration {
    /// The data of an explorer if only the file determines how the tower is solved.
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

/// The tower under the user's hand.
pub struct Explorer {
    pub(crate) exploration: Exploration,
    solver: Mutex<Solver>,
    against: Option<Box<Explorer>>,
}

/// A tower with changed numbers, solved.
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

    /// The tower of a state: the other one if the state is one of it and there is one.
    pub(crate) fn of(&self, state: &State) -> &Self {
        let other = self.against.as_deref().filter(|_| state.is_of_other);
        other.unwrap_or(self)
    }

    /// The tower that the page compares with.
    pub(crate) fn other(&self) -> Option<&Self> {
        self.against.as_deref()
    }

    /// The tower with changed numbers, and its description checked.
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

    /// The resonance check of the tower modes. A blade would be solved at many speeds for every
    /// frame, and no slider changes it: its modes are in the report.
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

    /// The options, without the elements of a deck where a height has changed.
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

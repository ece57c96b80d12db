//! One case: a tower, its reference values, and the methods that must reproduce them.

use towermodes::frame::FrameRecipe;
use towermodes::{Method, Mode, Options, Solution, Solver, StaticBalance, Tower, TowerDescription};

use crate::chapter::Chapter;
use crate::expected::{Digits, Expected, Quantity, families};
use crate::found::{FoundFrame, at_rest, of_mooring};
use crate::row::Row;
use crate::subject::Subject;
use crate::turning::Turning;

/// A tower with reference values.
#[derive(Debug, Clone)]
pub struct Case {
    /// Its chapter of the manual.
    pub chapter: Chapter,
    /// Its name.
    pub name: String,
    /// The source of the expected values.
    pub source: &'static str,
    /// A remark for readers of the values, for example on omitted digits of the source; empty if
    /// there is none.
    pub remark: &'static str,
    /// The structure.
    pub subject: Subject,
    /// The unit of the frequencies.
    pub unit: Unit,
    /// The uncertainty of the last digit of an expected value.
    pub digits: Digits,
    /// The expected values.
    pub expected: Vec<Expected>,
    /// The methods that must reproduce them.
    pub runs: Vec<Run>,
}

/// The unit of a value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Its name: `Hz`, or `1` for a dimensionless frequency.
    pub name: &'static str,
    /// Its size, Hz.
    pub hz: f64,
}

impl Unit {
    /// Values in Hz.
    pub const HZ: Self = Self {
        name: "Hz",
        hz: 1.0,
    };
    /// Values that are not frequencies.
    pub const NONE: Self = Self { name: "1", hz: 1.0 };

    /// Dimensionless values, as in the literature, in units of `hz`.
    pub fn dimensionless(hz: f64) -> Self {
        Self { name: "1", hz }
    }
}

/// The frequency of a mode that is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Value {
    /// The frequency of the model.
    Frequency,
    /// The frequency extrapolated from several numbers of segments.
    Extrapolated,
}

/// A method that must reproduce the expected values.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// The options of the solve; the number of modes is set as the case requires.
    pub options: Options,
    /// The frequency that is compared.
    pub value: Value,
    /// The permitted relative error of the method, in addition to the rounding of the source.
    pub allowance: f64,
}

impl Run {
    /// A method with this number of segments, without extrapolation.
    pub fn of(method: Method, segments: usize) -> Self {
        Self {
            options: Options {
                method,
                segments: Some(segments),
                ..Options::default()
            },
            value: Value::Frequency,
            allowance: 0.0,
        }
    }

    /// The method `bmodes` with equal elements between two heights (m), independent of the rows of
    /// the tower.
    pub fn bmodes(base_m: f64, top_m: f64, elements: usize) -> Self {
        let mut run = Self::of(Method::Bmodes, elements);
        let border = |k: usize| {
            let s = k as f64 / elements as f64;
            base_m * (1.0 - s) + top_m * s
        };
        run.options.borders_m = Some((0..=elements).map(border).collect());
        run
    }

    /// The reference solution, converged to 1e-10.
    pub fn spectral() -> Self {
        Self {
            options: Options {
                method: Method::Spectral,
                ..Options::default()
            },
            value: Value::Frequency,
            allowance: 1e-10,
        }
    }

    /// A method, extrapolated from n segments; the remaining error is of order n⁻⁴.
    pub fn extrapolated(method: Method, segments: usize, allowance: f64) -> Self {
        Self {
            value: Value::Extrapolated,
            allowance,
            ..Self::of(method, segments)
        }
    }

    /// The case for an Euler-Bernoulli beam.
    pub fn without_rotary_inertia(mut self) -> Self {
        self.options.rotary_inertia = false;
        self
    }

    /// The case with another allowance.
    pub fn allowing(mut self, allowance: f64) -> Self {
        self.allowance = allowance;
        self
    }

    /// The frequency of a mode that is compared, Hz.
    fn frequency_hz(&self, mode: &Mode) -> f64 {
        match self.value {
            Value::Frequency => mode.frequency_hz,
            Value::Extrapolated => mode.extrapolated_hz,
        }
    }

    /// The method with its number of segments: "rmje 20", "rmje-exact 400, extrapolated".
    pub fn name(&self) -> String {
        let method = self.options.method.name();
        let segments = self.options.segments.map(|n| format!(" {n}"));
        let extrapolated = match self.value {
            Value::Frequency => "",
            Value::Extrapolated => ", extrapolated",
        };
        format!("{method}{}{extrapolated}", segments.unwrap_or_default())
    }
}

impl Case {
    /// Solves the tower by each method and compares.
    pub fn run(&self) -> Vec<Row> {
        self.runs.iter().flat_map(|run| self.rows(run)).collect()
    }

    fn rows(&self, run: &Run) -> Vec<Row> {
        match &self.subject {
            Subject::Tower(tower) => self.tower_rows(run, tower),
            Subject::Turbine(tower, turning) => self.turning_rows(run, tower, turning),
            Subject::Frame(frame, recipe) => {
                let found = FoundFrame::of(frame, *recipe, &self.expected);
                let method = recipe.map_or_else(|| run.name(), method_of);
                self.other_rows(run, &method, &found, FoundFrame::get)
            }
            Subject::Mooring(mooring) => {
                self.other_rows(run, "catenary", &at_rest(mooring), of_mooring)
            }
        }
    }

    /// The rows of a subject without a tower: a frame or a mooring system.
    fn other_rows<T>(
        &self,
        run: &Run,
        method: &str,
        found: &Result<T, String>,
        get: impl Fn(&T, Quantity) -> Option<f64>,
    ) -> Vec<Row> {
        let got = |expected: &Expected| {
            let found = found.as_ref().map_err(Clone::clone)?;
            let value = get(found, expected.quantity);
            value.ok_or_else(|| "the quantity is not there".to_owned())
        };
        let row = |expected| Row {
            method: method.to_owned(),
            ..self.row(run, expected, false, got(expected))
        };
        self.expected.iter().map(row).collect()
    }

    fn tower_rows(&self, run: &Run, tower: &TowerDescription) -> Vec<Row> {
        let tower = Tower::new(tower.clone());
        let planes_are_equal = tower.as_ref().is_ok_and(Tower::planes_are_equal);
        let solution = match &tower {
            Ok(tower) => self.solution(run, tower),
            Err(error) => Err(error.to_string()),
        };
        let got = |expected: &Expected| match (&tower, &solution) {
            (Ok(tower), Ok(solution)) => self.got(run, (tower, solution), expected),
            (Err(error), _) => Err(error.to_string()),
            (_, Err(error)) => Err(error.clone()),
        };
        let row = |expected| self.row(run, expected, planes_are_equal, got(expected));
        self.expected.iter().map(row).collect()
    }

    /// The rows of a turbine: its lowest modes.
    fn turning_rows(&self, run: &Run, tower: &TowerDescription, turning: &Turning) -> Vec<Row> {
        let values = self.expected.iter().map(|expected| expected.value);
        let highest_hz = self.unit.hz * values.fold(0.0, f64::max);
        let found = turning.frequencies_hz(tower, 1.001 * highest_hz);
        let got = |expected: &Expected| {
            let found = found.as_ref().map_err(ToString::to_string)?;
            let place = match expected.quantity {
                Quantity::Lowest(place) => place,
                _ => return Err("turbines have their lowest modes compared".into()),
            };
            let frequency_hz = found.get(place - 1).ok_or("the mode is not there")?;
            Ok(frequency_hz / self.unit.hz)
        };
        let row = |expected| self.row(run, expected, false, got(expected));
        self.expected.iter().map(row).collect()
    }

    fn row(
        &self,
        run: &Run,
        expected: &Expected,
        planes_are_equal: bool,
        got: Result<f64, String>,
    ) -> Row {
        Row {
            chapter: self.chapter,
            case: self.name.clone(),
            source: self.source,
            remark: self.remark,
            what: expected.what(planes_are_equal),
            method: run.name(),
            unit: expected.quantity.unit().unwrap_or(self.unit.name),
            expected: *expected,
            got,
            tolerance: run.allowance + expected.open(self.digits) / expected.value.abs(),
        }
    }

    /// The number of modes to begin with: enough for the expected indices, or more than the number
    /// expected by family.
    fn modes(&self) -> usize {
        let place = |expected: &Expected| match expected.quantity {
            Quantity::Lowest(place) => Some(place),
            Quantity::Weight | Quantity::ForceLeft => Some(0),
            _ => None,
        };
        let places: Option<Vec<usize>> = self.expected.iter().map(place).collect();
        let last = places.and_then(|places| places.into_iter().max());
        last.unwrap_or(2 * self.expected.len() + 4)
    }

    /// Solves for all expected modes, or for all modes of the tower if it has fewer.
    fn solution(&self, run: &Run, tower: &Tower) -> Result<Solution, String> {
        let mut solver = Solver::new(Options {
            modes: self.modes(),
            points: 2,
            ..run.options.clone()
        });
        let planes_are_equal = tower.planes_are_equal();
        let has = |solution: &Solution, expected: &Expected| match expected.quantity {
            Quantity::Mode(family, order) => {
                let mut families = families(family, planes_are_equal).into_iter();
                families.all(|family| solution.mode(family, order).is_some())
            }
            Quantity::Lowest(place) => solution.modes.len() >= place,
            Quantity::BucklingLoadFactor
            | Quantity::Weight
            | Quantity::ForceLeft
            | Quantity::Mass
            | Quantity::MotionsWithoutStiffness
            | Quantity::Stiffness(..)
            | Quantity::Force(_)
            | Quantity::Tension(..)
            | Quantity::Place(..) => true,
        };
        let has_all = |solution: &Solution| {
            let mut expected = self.expected.iter();
            expected.all(|expected| has(solution, expected))
        };
        let solution = solver.until(usize::MAX, |solver| solver.solve(tower), has_all);
        solution.map_err(|error| error.to_string())
    }

    /// The computed value, or the reason why there is none. If both modes of a pair are expected,
    /// both must have it.
    fn got(
        &self,
        run: &Run,
        (tower, solution): (&Tower, &Solution),
        expected: &Expected,
    ) -> Result<f64, String> {
        let planes_are_equal = tower.planes_are_equal();
        let in_unit = |mode: &Mode| run.frequency_hz(mode) / self.unit.hz;
        match expected.quantity {
            Quantity::Mode(family, order) => {
                let value = |family| solution.mode(family, order).map(in_unit);
                let got = value(family).ok_or("the mode is not there")?;
                let mut families = families(family, planes_are_equal).into_iter();
                if families.all(|family| value(family) == Some(got)) {
                    Ok(got)
                } else {
                    Err("the pair is not complete".into())
                }
            }
            Quantity::Lowest(place) => {
                let mode = solution.modes.get(place - 1);
                Ok(mode.map(in_unit).ok_or("the mode is not there")?)
            }
            Quantity::BucklingLoadFactor => {
                let factor = solution.buckling_load_factor;
                Ok(factor.ok_or("no weights buckle the tower")?)
            }
            Quantity::Weight => Ok(balance(tower)?.weight_n()),
            Quantity::ForceLeft => Ok(balance(tower)?.residual_force_n[2]),
            Quantity::Mass
            | Quantity::MotionsWithoutStiffness
            | Quantity::Stiffness(..)
            | Quantity::Force(_)
            | Quantity::Tension(..)
            | Quantity::Place(..) => Err("no quantity of a tower".into()),
        }
    }
}

/// The static balance of a floating tower.
fn balance(tower: &Tower) -> Result<StaticBalance, String> {
    let balance = tower.static_balance();
    balance.ok_or_else(|| "the buoyancy is not known".into())
}

/// The method of a frame: "subdyn 4".
fn method_of(recipe: FrameRecipe) -> String {
    match recipe {
        FrameRecipe::Spectral { degree } => format!("spectral {degree}"),
        FrameRecipe::Subdyn { divisions } => format!("subdyn {divisions}"),
    }
}

//! One case: a tower, its known answers, and the methods that should give them.

use towermodes::solve_until;
use towermodes::{Method, Mode, Options, Solution, Tower, TowerDescription, Workspace};

use crate::expected::{Digits, Expected, Quantity, families};
use crate::manual::Chapter;
use crate::row::Row;

/// A tower with known answers.
#[derive(Debug, Clone)]
pub struct Case {
    /// Where in the manual it stands.
    pub chapter: Chapter,
    /// What it is.
    pub name: String,
    /// Where the expected values are from.
    pub source: &'static str,
    /// The tower.
    pub tower: TowerDescription,
    /// What the values are multiples of.
    pub unit: Unit,
    /// What the last digit of an expected value means.
    pub digits: Digits,
    /// What is expected.
    pub expected: Vec<Expected>,
    /// Who should give it.
    pub runs: Vec<Run>,
}

/// What a value is a multiple of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Its name: `Hz`, or `1` for a dimensionless frequency.
    pub name: &'static str,
    /// How much it is, Hz.
    pub hz: f64,
}

impl Unit {
    /// Values in Hz.
    pub const HZ: Self = Self {
        name: "Hz",
        hz: 1.0,
    };
    /// Values that are no frequencies.
    pub const NONE: Self = Self { name: "1", hz: 1.0 };

    /// Dimensionless values, as the literature has them, each worth so many Hz.
    pub fn dimensionless(hz: f64) -> Self {
        Self { name: "1", hz }
    }
}

/// Which of a mode's frequencies is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Value {
    /// That of the model itself.
    Frequency,
    /// The one extrapolated from several numbers of segments.
    Extrapolated,
}

/// A method that should give the expected values.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// How the tower is solved; the number of modes is set as the case needs it.
    pub options: Options,
    /// Which frequency is compared.
    pub value: Value,
    /// What the method promises, relatively: the error that is left to it beside the digits of the
    /// source.
    pub allowance: f64,
}

impl Run {
    /// A method with so many segments, whose own frequencies are compared.
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

    /// BModes with so many equal elements between two heights (m), wherever the rows of the tower
    /// are.
    pub fn bmodes(base_m: f64, top_m: f64, elements: usize) -> Self {
        let mut run = Self::of(Method::Bmodes, elements);
        let border = |k: usize| {
            let s = k as f64 / elements as f64;
            base_m * (1.0 - s) + top_m * s
        };
        run.options.borders_m = Some((0..=elements).map(border).collect());
        run
    }

    /// The spectral beam, converged to 1e-10.
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

    /// A method extrapolated from so many segments, with an error of n⁻⁴ left.
    pub fn extrapolated(method: Method, segments: usize, allowance: f64) -> Self {
        Self {
            value: Value::Extrapolated,
            allowance,
            ..Self::of(method, segments)
        }
    }

    /// The same as an Euler-Bernoulli beam.
    pub fn without_rotary_inertia(mut self) -> Self {
        self.options.rotary_inertia = false;
        self
    }

    /// The same with more left to the method.
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

    /// The method with its segments: "rmje 20", "rmje-exact 400, extrapolated".
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
    /// Solves the tower by every method and compares.
    pub fn run(&self) -> Vec<Row> {
        self.runs.iter().flat_map(|run| self.rows(run)).collect()
    }

    fn rows(&self, run: &Run) -> Vec<Row> {
        let tower = Tower::new(self.tower.clone());
        let planes_are_equal = tower.as_ref().is_ok_and(Tower::planes_are_equal);
        let solution = match &tower {
            Ok(tower) => self.solution(run, tower),
            Err(error) => Err(error.to_string()),
        };
        let row = |expected: &Expected| Row {
            chapter: self.chapter,
            case: self.name.clone(),
            source: self.source,
            what: expected.what(planes_are_equal),
            method: run.name(),
            unit: self.unit.name,
            expected: *expected,
            got: match &solution {
                Ok(solution) => self.got(run, solution, expected, planes_are_equal),
                Err(error) => Err(error.clone()),
            },
            tolerance: run.allowance + expected.open(self.digits) / expected.value,
        };
        self.expected.iter().map(row).collect()
    }

    /// Solves for all expected modes, or for as many as there are.
    fn solution(&self, run: &Run, tower: &Tower) -> Result<Solution, String> {
        let options = Options {
            modes: 2 * self.expected.len() + 4,
            ..run.options.clone()
        };
        let planes_are_equal = tower.planes_are_equal();
        let has = |solution: &Solution, expected: &Expected| match expected.quantity {
            Quantity::Mode(family, order) => {
                let mut families = families(family, planes_are_equal).into_iter();
                families.all(|family| solution.mode(family, order).is_some())
            }
            Quantity::Lowest(place) => solution.modes.len() >= place,
            Quantity::BucklingLoadFactor => true,
        };
        let has_all = |solution: &Solution| {
            let mut expected = self.expected.iter();
            expected.all(|expected| has(solution, expected))
        };
        solve_until(tower, &options, &mut Workspace::default(), has_all)
            .map_err(|error| error.to_string())
    }

    /// What came out for a value; of a pair that there should be, both members.
    fn got(
        &self,
        run: &Run,
        solution: &Solution,
        expected: &Expected,
        planes_are_equal: bool,
    ) -> Result<f64, String> {
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
        }
    }
}

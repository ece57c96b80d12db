//! One row of a sweep: the changed tower, solved.

use towermodes::{Change, ModeName, Parameter, Place, Solver, Tower, TowerError, Warning};

use super::warned::RowRemarks;
use crate::lowest::Lowest;
use crate::sweep::Sweep;

/// A row in which a mode is missing is solved again with up to this many more modes than the base
/// needs.
pub const MORE_MODES: usize = 16;

/// The cells of a row's results.
#[derive(Debug)]
pub(crate) struct Cells<'a> {
    pub(crate) mass_kg: &'a mut f64,
    pub(crate) certified: &'a mut bool,
    pub(crate) frequency_hz: &'a mut [f64],
    pub(crate) error_hz: &'a mut [f64],
    pub(crate) share: &'a mut [f64],
}

/// Solves rows one after the other with the same memory; each thread has one.
#[derive(Debug)]
pub(crate) struct RowSolver<'a> {
    sweep: &'a Sweep,
    pub(crate) solver: Solver,
    lowest: Lowest,
    /// The warning about the input of the last row, if there is one.
    warning: Option<Warning>,
    /// The first name of the last row whose motion several modes share.
    shared: Option<ModeName>,
}

impl<'a> RowSolver<'a> {
    pub(crate) fn new(sweep: &'a Sweep) -> Self {
        Self::within(sweep, Solver::default())
    }

    /// A row solver with this solver, whose observer is called for every solve.
    pub(crate) fn within(sweep: &'a Sweep, mut solver: Solver) -> Self {
        solver.options = sweep.options().clone();
        // The sweep has solved its base before; without a base, rows are solved alone.
        if let Ok(base) = Tower::new(sweep.base().clone()) {
            solver.start_from(&base).ok();
        }
        Self {
            sweep,
            solver,
            lowest: Lowest::default(),
            warning: None,
            shared: None,
        }
    }

    /// Solves the tower with the values of a row. Cells without a value become NaN, and the
    /// returned message states the reason.
    pub(crate) fn solve(&mut self, values: &[f64], cells: Cells<'_>) -> Option<String> {
        *cells.mass_kg = f64::NAN;
        *cells.certified = false;
        cells.frequency_hz.fill(f64::NAN);
        cells.error_hz.fill(f64::NAN);
        cells.share.fill(f64::NAN);
        (self.warning, self.shared) = (None, None);
        self.try_solve(values, cells).err()
    }

    fn try_solve(&mut self, values: &[f64], mut cells: Cells<'_>) -> Result<(), String> {
        let tower = self.tower(values)?;
        *cells.mass_kg = tower.structure_mass_kg();
        self.warning = self.sweep.new_warning(&tower).cloned();
        let asked = self.sweep.options().modes;
        self.solver.options.modes = asked;
        let solved = self.lowest.solve_for(
            self.sweep.modes(),
            &tower,
            asked + MORE_MODES,
            &mut self.solver,
        );
        solved.map_err(|error| error.to_string())?;
        self.take(&mut cells)?;
        let mut modes = self.sweep.modes().iter();
        self.shared = modes.find(|name| self.lowest.is_shared(**name)).copied();
        Ok(())
    }

    /// Adds the warning about the input of the last row, if there is one.
    pub(crate) fn warn(&mut self, row: u64, warnings: &mut RowRemarks) {
        if let Some(warning) = self.warning.take() {
            warnings.add(row, || named(&warning, |place| name_at(place, self.sweep)));
        }
    }

    /// Adds the last row, if several of its modes share a motion.
    pub(crate) fn share(&mut self, row: u64, shared: &mut RowRemarks) {
        if let Some(name) = self.shared.take() {
            let sentence = || self.lowest.shared(name).map(|of| of.to_string());
            shared.add(row, || sentence().unwrap_or_default());
        }
    }

    /// The changed tower.
    fn tower(&self, values: &[f64]) -> Result<Tower, String> {
        let mut description = self.sweep.base().clone();
        for (change, value) in self.sweep.changes().iter().zip(values) {
            if !value.is_finite() {
                return Err(format!("{} is {value}; it must be finite", change.name()));
            }
            change.apply(&mut description, *value);
        }
        Tower::new(description).map_err(|error| message(&error, self.sweep))
    }

    /// Copies the frequencies into the cells, by name.
    ///
    /// # Errors
    /// The message with the names of the missing modes.
    fn take(&self, cells: &mut Cells<'_>) -> Result<(), String> {
        *cells.certified = self.lowest.certified;
        let mut missing = Vec::new();
        for (index, name) in self.sweep.modes().iter().enumerate() {
            match self.lowest.mode(*name) {
                Some(mode) => {
                    cells.frequency_hz[index] = mode.hz;
                    cells.error_hz[index] = mode.error_hz;
                    cells.share[index] = mode.share();
                }
                None => missing.push(name.to_string()),
            }
        }
        let verb = if missing.len() == 1 { "is" } else { "are" };
        match missing.is_empty() {
            true => Ok(()),
            false => Err(format!(
                "{} {verb} not among the lowest {} modes{}",
                missing.join(", "),
                self.lowest.modes.len(),
                match &self.lowest.no_more {
                    Some(error) => format!("; more could not be computed: {error}"),
                    None => String::new(),
                }
            )),
        }
    }
}

/// The message for an impossible tower, with input values named as in columns: indices count from
/// 0.
fn message(error: &TowerError, sweep: &Sweep) -> String {
    match name_at(error.place, sweep) {
        Some(name) => format!("{name}: {}", error.problem),
        None => error.to_string(),
    }
}

/// The name of the input value at a place: one that the sweep changes, otherwise one of the base.
fn name_at(place: Place, sweep: &Sweep) -> Option<String> {
    let changed = sweep.changes().iter().flat_map(Change::parameters).copied();
    number_at(place, changed).or_else(|| number_at(place, Parameter::all(sweep.base()).into_iter()))
}

/// A warning that begins with the name of the input value that it is about, with indices from 0.
/// This name replaces the description of the place, which counts from 1.
pub fn named(warning: &Warning, name_at: impl FnOnce(Place) -> Option<String>) -> String {
    let said = warning.to_string();
    let Some(place) = warning.place() else {
        return said;
    };
    match name_at(place) {
        Some(name) => {
            let counted = format!("{place}: ");
            format!("{name}: {}", said.strip_prefix(&counted).unwrap_or(&said))
        }
        None => said,
    }
}

/// The name of the input value at a place; if there are several, of the list entry that contains
/// them.
pub fn number_at(place: Place, parameters: impl Iterator<Item = Parameter>) -> Option<String> {
    let mut there = parameters.filter(|parameter| parameter.place() == place);
    let first = there.next()?.to_string();
    match there.all(|other| other.to_string() == first) {
        true => Some(first),
        false => {
            let end = first.rfind(']')?;
            Some(first[..=end].to_owned())
        }
    }
}

//! A sweep: a tower, the changes of each row, and the modes that are written.

use std::collections::HashSet;
use std::mem::discriminant;

use thiserror::Error;
use towermodes::{
    Change, ModeName, Options, SolveError, Solver, Tower, TowerDescription, TowerError, Warning,
};
use towermodes_files::{SweepModes, SweepResults};

use crate::base::Base;
use crate::first::first;
use crate::lowest::Lowest;

/// The largest number of modes of the base that are computed to find the named modes.
pub const MOST_MODES: usize = 64;

/// A sweep: a tower, the changes whose values each row gives, and the modes whose results are
/// columns.
///
/// # Example
/// ```
/// use towermodes::{Change, Material, Rna, Station, TowerDescription};
/// use towermodes_files::{SweepModes, SweepResults};
/// use towermodes_sweep::{Base, Sweep};
///
/// let description = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// };
/// let changes = Change::parse_all(["rna.mass", "scale(stations[*].wall)"], &description)?;
/// let results = SweepResults { modes: SweepModes::Lowest(3), ..SweepResults::default() };
/// let sweep = Sweep::new(Base::from(description), changes, &results)?;
/// let names: Vec<String> = sweep.modes().iter().map(ToString::to_string).collect();
/// assert_eq!(names, ["fore-aft 1", "side-side 1", "fore-aft 2"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    base: TowerDescription,
    /// Warnings about the base tower.
    base_warnings: Vec<Warning>,
    changes: Vec<Change>,
    modes: Vec<ModeName>,
    /// The options, with the number of modes that the base needs for all names.
    options: Options,
    inputs: bool,
}

/// Why a sweep cannot begin.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The base is not a possible tower.
    #[error("the base of the sweep is not a tower: {0}")]
    Base(#[from] TowerError),
    /// The base cannot be solved.
    #[error("the base of the sweep cannot be solved: {0}")]
    Unsolved(#[from] SolveError),
    /// There is no change.
    #[error("nothing is varied; name at least one parameter")]
    NothingVaried,
    /// A change that is named twice.
    #[error("`{name}` is changed twice; remove one")]
    RepeatedChange {
        /// The name of the change.
        name: String,
    },
    /// There are no modes.
    #[error("the sweep has no modes; ask for at least one")]
    NoModes,
    /// A mode that is named twice.
    #[error("the mode `{name}` is named twice; remove one")]
    RepeatedMode {
        /// The mode.
        name: ModeName,
    },
    /// A mode that is not among the lowest modes of the base.
    #[error(
        "`{name}` is not among the lowest {modes} modes of the base tower; these are {}",
        first(found)
    )]
    MissingMode {
        /// The mode.
        name: ModeName,
        /// Number of modes that were computed.
        modes: usize,
        /// The names of these modes.
        found: Vec<ModeName>,
    },
}

impl Sweep {
    /// Checks the base by solving it, and finds the modes whose results are columns.
    ///
    /// # Errors
    /// [`SweepError`]: the base cannot be solved, or does not have a mode.
    pub fn new(
        base: Base,
        changes: Vec<Change>,
        results: &SweepResults,
    ) -> Result<Self, SweepError> {
        if changes.is_empty() {
            return Err(SweepError::NothingVaried);
        }
        // Their names are those of columns.
        let mut seen = HashSet::new();
        if let Some(second) = changes.iter().find(|change| !seen.insert(change.name())) {
            let name = second.name().to_owned();
            return Err(SweepError::RepeatedChange { name });
        }
        let mut options = base.options(results);
        let tower = Tower::new(base.description.clone())?;
        let modes = match &results.modes {
            SweepModes::Lowest(0) => return Err(SweepError::NoModes),
            SweepModes::Lowest(count) => {
                options.modes = *count;
                names(&lowest(&tower, &options)?)
            }
            SweepModes::Named(names) => {
                options.modes = reaching(&tower, &options, names)?;
                names.clone()
            }
        };
        Ok(Self {
            base: base.description,
            base_warnings: tower.warnings().to_vec(),
            changes,
            modes,
            options,
            inputs: results.inputs,
        })
    }

    /// The tower that each row changes.
    pub fn base(&self) -> &TowerDescription {
        &self.base
    }

    /// The first warning about the input of a changed tower that the base does not have.
    pub(crate) fn new_warning<'t>(&self, changed: &'t Tower) -> Option<&'t Warning> {
        let is_same = |one: &Warning, other: &Warning| {
            discriminant(one) == discriminant(other) && one.place() == other.place()
        };
        let is_new = |warning: &&Warning| {
            let mut of_base = self.base_warnings.iter();
            !of_base.any(|other| is_same(warning, other))
        };
        changed.warnings().iter().find(is_new)
    }

    /// The changes, one for each value of a row.
    pub fn changes(&self) -> &[Change] {
        &self.changes
    }

    /// The modes whose results are columns, in the order of the columns.
    pub fn modes(&self) -> &[ModeName] {
        &self.modes
    }

    /// The options of the first solve of each row.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// Whether the values of the changes are columns of results.
    pub fn has_inputs(&self) -> bool {
        self.inputs
    }
}

fn lowest(tower: &Tower, options: &Options) -> Result<Lowest, SolveError> {
    let mut lowest = Lowest::default();
    lowest.solve(tower, &mut Solver::new(options.clone()))?;
    Ok(lowest)
}

fn names(lowest: &Lowest) -> Vec<ModeName> {
    lowest.modes.iter().map(|mode| mode.name).collect()
}

/// The number of modes of a tower that is needed to include all modes with these names.
fn reaching(tower: &Tower, options: &Options, wanted: &[ModeName]) -> Result<usize, SweepError> {
    if wanted.is_empty() {
        return Err(SweepError::NoModes);
    }
    let repeated = (1..wanted.len()).find(|&i| wanted[..i].contains(&wanted[i]));
    if let Some(second) = repeated {
        let name = wanted[second];
        return Err(SweepError::RepeatedMode { name });
    }
    let mut solver = Solver::new(options.clone());
    solver.options.modes = wanted.len();
    let most = MOST_MODES.max(2 * wanted.len());
    let mut lowest = Lowest::default();
    lowest.solve_for(wanted, tower, most, &mut solver)?;
    let found = names(&lowest);
    let place = |name: &ModeName| found.iter().position(|other| other == name);
    if let Some(name) = wanted.iter().find(|name| place(name).is_none()) {
        if let Some(error) = lowest.no_more {
            return Err(error.into());
        }
        return Err(SweepError::MissingMode {
            name: *name,
            modes: found.len(),
            found,
        });
    }
    let last = wanted.iter().filter_map(place).max();
    Ok(last.map_or(wanted.len(), |last| last + 1))
}

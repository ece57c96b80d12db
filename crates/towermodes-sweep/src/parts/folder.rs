//! The folder of the parts.

use std::fs;
use std::io::ErrorKind;
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::check::State;
use super::part::{Column, Part, PartFormat, columns};
use super::plan::{Plan, SweepSource};
use super::write::{is_temporary, sync_folder, write, write_new};
use super::{PartOptions, PartsError, Shard, csv};
use crate::results::Results;
use crate::sweep::Sweep;

/// The file with the plan.
const PLAN: &str = "_sweep.json";
/// The empty file of a complete folder.
const SUCCESS: &str = "_SUCCESS";

/// A folder of results: what is there, what is missing, and how a part is written.
///
/// # Example
/// 1000 towers, drawn by a Latin hypercube, in parts of 500 rows:
/// ```
/// use std::ops::ControlFlow;
/// use towermodes::{Change, Material, Rna, Station, TowerDescription};
/// use towermodes_files::{Distribution, Sampling, SamplingKind, SweepResults, Varied};
/// use towermodes_sweep::{Base, PartOptions, Parts, Sweep, SweepSource};
///
/// let description = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// };
/// let changes = Change::parse_all(["rna.mass"], &description)?;
/// let sweep = Sweep::new(Base::from(description), changes, &SweepResults::default())?;
/// let mass = Varied {
///     name: "rna.mass".to_owned(),
///     distribution: Distribution::Uniform { low: 3.3e5, high: 3.7e5 },
///     levels: None,
/// };
/// let source = SweepSource::sampled(Sampling {
///     kind: SamplingKind::LatinHypercube,
///     rows: 1000,
///     seed: 1,
///     vary: vec![mass],
/// })?;
///
/// let folder = std::env::temp_dir().join(format!("towermodes-{}", std::process::id()));
/// let options = PartOptions { rows_per_part: 500, ..PartOptions::default() };
/// let parts = Parts::open(&sweep, &source, &folder, options)?;
/// let missing = parts.missing()?;
/// let done = parts.solve(&missing, 2, &mut |_| ControlFlow::Continue(()))?;
/// assert_eq!((done.rows, done.parts, parts.finish()?), (1000, 2, true));
///
/// let first = parts.summary(None)?.modes[0].frequency_hz.clone().expect("frequencies");
/// assert!(first.min > 0.29 && first.max < 0.31);
/// # std::fs::remove_dir_all(folder)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Parts<'a> {
    pub(super) sweep: &'a Sweep,
    pub(super) source: &'a SweepSource,
    folder: PathBuf,
    plan: Plan,
    format: PartFormat,
    shard: Shard,
    columns: Vec<(String, Column)>,
}

impl<'a> Parts<'a> {
    /// Opens the folder of a sweep, and makes it if it does not exist.
    ///
    /// # Errors
    /// [`PartsError`]: the folder has results of another sweep, or cannot be written.
    pub fn open(
        sweep: &'a Sweep,
        source: &'a SweepSource,
        folder: &Path,
        options: PartOptions,
    ) -> Result<Self, PartsError> {
        if options.format == PartFormat::Parquet && !cfg!(feature = "parquet") {
            return Err(PartsError::NoParquet);
        }
        let parts = Self {
            plan: Plan::new(sweep, source, &options)?,
            sweep,
            source,
            folder: folder.to_path_buf(),
            format: options.format,
            shard: options.shard,
            columns: columns(sweep),
        };
        fs::create_dir_all(folder).map_err(PartsError::io(folder))?;
        if options.force {
            parts.remove_results()?;
        }
        parts.claim()?;
        Ok(parts)
    }

    /// Writes the plan, or compares it with the one that is there.
    fn claim(&self) -> Result<(), PartsError> {
        let path = self.folder.join(PLAN);
        if !path.exists() {
            self.check_without_plan()?;
            if write_new(&self.folder, PLAN, self.plan.text().as_bytes())? {
                return Ok(());
            }
            // Another run was faster.
        }
        let text = fs::read_to_string(&path).map_err(PartsError::io(&path))?;
        let differences = self.plan.differences(&text);
        let differences = differences.map_err(|detail| PartsError::Plan { path, detail })?;
        match differences.is_empty() {
            true => Ok(()),
            false => Err(PartsError::OtherSweep {
                folder: self.folder.clone(),
                differences,
            }),
        }
    }

    /// A folder without a plan must have no parts but those of this sweep.
    fn check_without_plan(&self) -> Result<(), PartsError> {
        for name in self.names()? {
            if !is_part(&name) {
                continue;
            }
            let number = part_number(&name).filter(|part| self.name(*part) == name);
            let foreign = |reason: &str| PartsError::Foreign {
                path: self.folder.join(&name),
                reason: reason.to_owned(),
            };
            let state = match number.filter(|part| *part < self.count()) {
                Some(part) => self.state(part)?,
                None => return Err(foreign("the sweep has no part with this name")),
            };
            if state != State::Done {
                return Err(foreign("it has no key, or that of another sweep"));
            }
        }
        Ok(())
    }

    /// Removes the files of results, and no others.
    fn remove_results(&self) -> Result<(), PartsError> {
        // Without the plan first, a kill in between leaves a folder that is refused.
        let mut names = self.names()?;
        names.retain(|name| {
            let is_hidden = name.starts_with(".part-") && name.ends_with(".key");
            let is_ours = is_part(name) || is_hidden || is_temporary(name);
            is_ours || [PLAN, SUCCESS].contains(&name.as_str())
        });
        names.sort_by_key(|name| (name != SUCCESS, name == PLAN));
        for name in names {
            let path = self.folder.join(name);
            match fs::remove_file(&path) {
                Err(error) if error.kind() != ErrorKind::NotFound => {
                    return Err(PartsError::Io { path, error });
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn names(&self) -> Result<Vec<String>, PartsError> {
        let entries = fs::read_dir(&self.folder).map_err(PartsError::io(&self.folder))?;
        let names = entries.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
        let names: Result<Vec<String>, std::io::Error> = names.collect();
        names.map_err(PartsError::io(&self.folder))
    }

    /// The sweep whose results they are.
    pub fn sweep(&self) -> &Sweep {
        self.sweep
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The number of parts of the whole sweep.
    pub fn count(&self) -> u64 {
        self.plan.parts()
    }

    /// The number of rows of the whole sweep.
    pub fn rows(&self) -> u64 {
        self.plan.rows
    }

    /// The rows of a part, numbered from 0.
    pub fn rows_of(&self, part: u64) -> Range<u64> {
        self.plan.rows_of(part)
    }

    /// The format of the parts.
    pub fn format(&self) -> PartFormat {
        self.format
    }

    /// The key: the SHA-256 of all that the results depend on.
    pub fn key(&self) -> &str {
        &self.plan.key
    }

    /// The file name of a part.
    pub fn name(&self, part: u64) -> String {
        let digits = self.count().saturating_sub(1).max(1).ilog10() as usize + 1;
        let width = digits.max(5);
        format!("part-{part:0width$}.{}", self.format.name())
    }

    /// The path of a part.
    pub fn path(&self, part: u64) -> PathBuf {
        self.folder.join(self.name(part))
    }

    /// The parts of the shard that are not there or not whole.
    ///
    /// # Errors
    /// [`PartsError::Foreign`] for a part of another sweep; it is not overwritten.
    pub fn missing(&self) -> Result<Vec<u64>, PartsError> {
        let mut missing = Vec::new();
        for part in (0..self.count()).filter(|part| self.shard.has(*part)) {
            match self.state(part)? {
                State::Done => {}
                State::Missing | State::Damaged => missing.push(part),
                State::Foreign(reason) => {
                    let path = self.path(part);
                    return Err(PartsError::Foreign { path, reason });
                }
            }
        }
        Ok(missing)
    }

    /// Writes `_SUCCESS` if all parts of all shards are there and whole, and removes what killed
    /// runs have left; whether they are.
    ///
    /// # Errors
    /// [`PartsError`] if a file cannot be read or written.
    pub fn finish(&self) -> Result<bool, PartsError> {
        // Names first: this is quick while other shards are at work.
        let is_there = |part: u64| self.path(part).exists();
        if !(0..self.count()).all(is_there) {
            return Ok(false);
        }
        for part in 0..self.count() {
            if self.state(part)? != State::Done {
                return Ok(false);
            }
        }
        for name in self.names()?.iter().filter(|name| is_temporary(name)) {
            // A run that is still writing has written the same; it finds the part there.
            let _ = fs::remove_file(self.folder.join(name));
        }
        write(&self.folder, SUCCESS, b"")?;
        sync_folder(&self.folder);
        Ok(true)
    }

    /// Reads the results of a part; those of a missing mode or a failed row are NaN.
    ///
    /// # Errors
    /// [`PartsError`] if the part is not there or not whole.
    pub fn read(&self, part: u64) -> Result<Results, PartsError> {
        let path = self.path(part);
        let rows = self.rows_of(part);
        let results = match self.format {
            PartFormat::Csv => {
                let content = fs::read(&path).map_err(PartsError::io(&path))?;
                csv::read(&content, &self.columns, rows.start, self.sweep.modes())
            }
            PartFormat::Parquet => self.read_parquet(&path, rows.start)?,
        };
        let expected = (rows.end - rows.start) as usize;
        let results = match results {
            Ok(results) if results.rows() != expected => Err(format!(
                "it has {} rows in place of {expected}",
                results.rows()
            )),
            results => results,
        };
        results.map_err(|detail| PartsError::Damaged { path, detail })
    }

    #[cfg(feature = "parquet")]
    fn read_parquet(
        &self,
        path: &Path,
        first_row: u64,
    ) -> Result<Result<Results, String>, PartsError> {
        let file = fs::File::open(path).map_err(PartsError::io(path))?;
        let modes = self.sweep.modes();
        let read = super::parquet::read(file, &self.columns, first_row, modes);
        Ok(read.map_err(|error| error.to_string()))
    }

    #[cfg(not(feature = "parquet"))]
    fn read_parquet(&self, _: &Path, _: u64) -> Result<Result<Results, String>, PartsError> {
        Err(PartsError::NoParquet)
    }

    /// Writes a part.
    pub(super) fn write(&self, number: u64, part: &Part) -> Result<(), PartsError> {
        let name = self.name(number);
        let unwritable = |detail: String| PartsError::Unwritable {
            path: self.path(number),
            detail,
        };
        let content = match self.format {
            PartFormat::Csv => {
                let content = csv::write(part, &self.columns);
                let content = content.map_err(|error| unwritable(error.to_string()))?;
                // Before the part, so that no part is without it.
                let text = csv::key_text(self.key(), number, &content);
                write(&self.folder, &csv::key_name(&name), text.as_bytes())?;
                content
            }
            #[cfg(feature = "parquet")]
            PartFormat::Parquet => {
                let content = super::parquet::write(part, &self.columns, (self.key(), number));
                content.map_err(|error| unwritable(error.to_string()))?
            }
            #[cfg(not(feature = "parquet"))]
            PartFormat::Parquet => return Err(PartsError::NoParquet),
        };
        write(&self.folder, &name, &content)
    }
}

fn is_part(name: &str) -> bool {
    let is_ours = |name: &str| name.ends_with(".csv") || name.ends_with(".parquet");
    name.starts_with("part-") && is_ours(name)
}

/// The number in the name of a part.
fn part_number(name: &str) -> Option<u64> {
    let digits = name.strip_prefix("part-")?.split('.').next()?;
    digits.parse().ok()
}

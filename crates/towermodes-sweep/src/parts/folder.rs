//! The folder of the parts.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::check::{State, Verified};
use super::names::{SUCCESS, is_temporary};
use super::part::{Column, PartFormat, columns};
use super::plan::{Plan, SweepSource};
use super::write::{sync_folder, write};
use super::{PartOptions, PartsError, Shard};
use crate::sweep::Sweep;

/// A folder of results: what is there and what is missing.
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
///     correlations: Vec::new(),
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
    pub(super) plan: Plan,
    format: PartFormat,
    shard: Shard,
    pub(super) columns: Vec<(String, Column)>,
    pub(super) verified: Verified,
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
            verified: Verified::default(),
        };
        fs::create_dir_all(folder).map_err(PartsError::io(folder))?;
        if options.force {
            parts.remove_results()?;
        }
        parts.claim()?;
        Ok(parts)
    }

    pub(super) fn names(&self) -> Result<Vec<String>, PartsError> {
        let entries = fs::read_dir(&self.folder).map_err(PartsError::io(&self.folder))?;
        let names = entries.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
        let names: Result<Vec<String>, std::io::Error> = names.collect();
        names.map_err(PartsError::io(&self.folder))
    }

    /// The sweep whose results they are.
    pub fn sweep(&self) -> &Sweep {
        self.sweep
    }

    /// The source of the values of its rows.
    pub fn source(&self) -> &SweepSource {
        self.source
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

    /// The rows of a part, numbered from 0; none behind the last part.
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
    /// runs have left. False if the parts of the own shard are, and those of other shards are not.
    ///
    /// # Errors
    /// [`PartsError::Lost`] for a part of the own shard that is not there or not whole,
    /// [`PartsError::Foreign`] for one of another sweep: another run has removed or replaced it.
    /// [`PartsError::Io`] if a file cannot be read or written.
    pub fn finish(&self) -> Result<bool, PartsError> {
        // One that is written from here on is that of a shard that has found all parts.
        let was_marked = self.folder.join(SUCCESS).exists();
        let is_complete = self.is_complete();
        if !matches!(is_complete, Ok(true)) {
            if was_marked {
                self.remove(SUCCESS)?;
            }
            return is_complete;
        }
        for name in self.names()?.iter().filter(|name| is_temporary(name)) {
            // A run that is still writing has written the same; it finds the part there.
            let _ = fs::remove_file(self.folder.join(name));
        }
        write(&self.folder, SUCCESS, b"")?;
        sync_folder(&self.folder);
        Ok(true)
    }

    /// Whether all parts of all shards are there and whole.
    fn is_complete(&self) -> Result<bool, PartsError> {
        // Names first: this is quick while other shards are at work.
        let are_there = (0..self.count()).all(|part| self.path(part).exists());
        let mut is_complete = are_there;
        for part in (0..self.count()).filter(|part| are_there || self.shard.has(*part)) {
            let state = self.state(part)?;
            let path = self.path(part);
            let reason = match state {
                State::Done => continue,
                State::Foreign(reason) => return Err(PartsError::Foreign { path, reason }),
                State::Missing => "is missing",
                State::Damaged => "is damaged",
            };
            if self.shard.has(part) {
                return Err(PartsError::Lost { path, reason });
            }
            is_complete = false;
        }
        Ok(is_complete)
    }

    /// Refuses a part that the sweep does not have.
    pub(super) fn check_number(&self, part: u64) -> Result<(), PartsError> {
        let count = self.count();
        match part < count {
            true => Ok(()),
            false => Err(PartsError::NoSuchPart { part, count }),
        }
    }
}

//! A sweep in memory.

use std::collections::TryReserveError;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use thiserror::Error;

use crate::failed::FailedRows;
use crate::results::{Piece, Results};
use crate::row::RowSolver;
use crate::source::RowSource;
use crate::sweep::Sweep;
use crate::threads::{Tick, Watch, lock, shared};
use crate::warned::RowRemarks;

/// Rows that a thread takes at a time, some milliseconds of work; fewer are not worth a thread.
pub(crate) const PIECE_ROWS: usize = 64;

/// Why a sweep in memory has no results.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum RunError {
    /// The [`Watch`] ended it.
    #[error("the sweep was stopped")]
    Stopped,
    /// The rows have another number of values than the sweep has changes.
    #[error(
        "the rows have {values} values, but the sweep has {changes} changes; give one value for each change"
    )]
    Width {
        /// Number of values of a row.
        values: usize,
        /// Number of changes.
        changes: usize,
    },
    /// The results need more memory than there is.
    #[error("the results of {rows} rows do not fit into memory; write them to a folder instead")]
    Memory {
        /// Number of rows.
        rows: u64,
    },
}

/// Solves all rows of a source. The results do not depend on the number of threads.
///
/// With one thread, and for up to 64 rows, the calling thread does the work; otherwise it watches.
///
/// # Errors
/// [`RunError`]; a row that fails is a row of the results.
///
/// # Example
/// ```
/// use std::ops::ControlFlow;
/// use towermodes::{Change, Material, Rna, Station, TowerDescription};
/// use towermodes_files::SweepResults;
/// use towermodes_sweep::{Base, Columns, Sweep, run};
///
/// let description = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// };
/// let changes = Change::parse_all(["rna.mass"], &description)?;
/// let sweep = Sweep::new(Base::from(description), changes, &SweepResults::default())?;
/// let masses = [3.3e5, 3.5e5, -1.0];
/// let columns = Columns::new(vec![&masses])?;
/// let results = run(&sweep, &columns, 1, &mut |_| ControlFlow::Continue(()))?;
/// assert!(results.frequency_hz[0] > results.frequency_hz[sweep.modes().len()]);
/// assert!(results.certified[1] && (results.mass_kg[1] - 267_586.067).abs() < 1e-3);
/// let (row, sentence) = results.failures.get(0).expect("a row that failed");
/// assert!(row == 2 && sentence.contains("-1 kg"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn run(
    sweep: &Sweep,
    source: &dyn RowSource,
    threads: usize,
    watch: &mut Watch<'_>,
) -> Result<Results, RunError> {
    let (values, changes) = (source.width(), sweep.changes().len());
    if values != changes {
        return Err(RunError::Width { values, changes });
    }
    let rows = source.rows();
    let too_many = RunError::Memory { rows };
    let Ok(count) = usize::try_from(rows) else {
        return Err(too_many);
    };
    let Ok(mut results) = Results::unsolved(0, count, sweep.modes()) else {
        return Err(too_many);
    };
    let threads = threads.min(count.div_ceil(PIECE_ROWS));
    let (failures, full) = (Mutex::new(Vec::new()), AtomicBool::new(false));
    let [warnings, shared_rows] = [(); 2].map(|()| Mutex::new(RowRemarks::default()));
    let pieces = Mutex::new(results.pieces(PIECE_ROWS));
    let ended = shared(threads, watch, |tick| {
        let mut rows = Rows::new(sweep);
        while !full.load(Ordering::Relaxed) {
            // The lock is not held while rows are solved.
            let piece = lock(&pieces).next();
            let Some(piece) = piece else { break };
            let first = piece.first_row;
            match rows.solve(source, first, piece, tick) {
                Ok(true) => {}
                Ok(false) => break,
                Err(_) => full.store(true, Ordering::Relaxed),
            }
        }
        lock(&failures).push(rows.failed);
        lock(&warnings).append(rows.warnings);
        lock(&shared_rows).append(rows.shared);
    });
    drop(pieces);
    ended.map_err(|_| RunError::Stopped)?;
    let failures = failures.into_inner().unwrap_or_else(|e| e.into_inner());
    if full.into_inner() {
        return Err(too_many);
    }
    results.failures = FailedRows::merged(failures).map_err(|_| too_many)?;
    let inner = |rows: Mutex<RowRemarks>| rows.into_inner().unwrap_or_else(|e| e.into_inner());
    (results.warnings, results.shared) = (inner(warnings), inner(shared_rows));
    Ok(results)
}

/// What one thread needs to solve rows.
pub(crate) struct Rows<'a> {
    solver: RowSolver<'a>,
    values: Vec<f64>,
    /// Of all rows that it has solved, which rise.
    pub(crate) failed: FailedRows,
    /// On all rows that it has solved.
    pub(crate) warnings: RowRemarks,
    /// The rows that it has solved in which modes share their motions.
    pub(crate) shared: RowRemarks,
}

impl<'a> Rows<'a> {
    pub(crate) fn new(sweep: &'a Sweep) -> Self {
        Self {
            solver: RowSolver::new(sweep),
            values: vec![0.0; sweep.changes().len()],
            failed: FailedRows::default(),
            warnings: RowRemarks::default(),
            shared: RowRemarks::default(),
        }
    }

    /// Solves the rows of a piece, whose values are those of a source from its row `first` on;
    /// false if the tick ended it.
    ///
    /// # Errors
    /// If there is no memory for the sentences of rows that failed.
    pub(crate) fn solve(
        &mut self,
        source: &dyn RowSource,
        first: u64,
        mut piece: Piece<'_>,
        tick: &mut Tick<'_>,
    ) -> Result<bool, TryReserveError> {
        for index in 0..piece.rows() {
            let row = piece.first_row + index as u64;
            source.row(first + index as u64, &mut self.values);
            let failure = self.solver.solve(&self.values, piece.cells(index));
            if let Some(sentence) = failure {
                self.failed.push(row, &sentence)?;
            }
            self.solver.warn(row, &mut self.warnings);
            self.solver.share(row, &mut self.shared);
            if !tick() {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

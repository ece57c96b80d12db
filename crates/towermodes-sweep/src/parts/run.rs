//! Solves parts: all threads work on one part, and the one that finishes it writes it.

use std::collections::{HashSet, TryReserveError};
use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use towermodes::ModeName;

use super::block::SourceBlock;
use super::names::SUCCESS;
use super::part::Part;
use super::write::sync_folder;
use super::{Parts, PartsError};
use crate::failed::FailedRows;
use crate::results::Results;
use crate::run::{PIECE_ROWS, Rows, RunError};
use crate::threads::{Tick, lock, shared};
use crate::warned::RowRemarks;

/// How far a sweep is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PartsProgress {
    /// Rows solved by this run.
    pub rows: u64,
    /// Parts written by this run.
    pub parts: u64,
    /// Rows of these parts with a sentence.
    pub failures: u64,
    /// Rows with input that is probably a mistake; known at the end.
    pub warnings: RowRemarks,
    /// Rows in which modes share the motion of a name; known at the end.
    pub shared: RowRemarks,
}

impl Parts<'_> {
    /// Solves parts, each once, and writes each when it is complete. The bytes of a part do not
    /// depend on the number of threads.
    ///
    /// The watch is called on the calling thread about fifty times a second. If it ends the run,
    /// the parts in work are lost: one, or as many as threads if parts have fewer rows than these
    /// take at a time, 64 each.
    ///
    /// # Errors
    /// [`PartsError`]: a part does not exist or cannot be written, the table or the plan of the
    /// folder has changed, or the watch ended the run. What is written stays.
    pub fn solve(
        &self,
        parts: &[u64],
        threads: usize,
        watch: &mut dyn FnMut(PartsProgress) -> ControlFlow<()>,
    ) -> Result<PartsProgress, PartsError> {
        let mut seen = HashSet::new();
        let mut waiting = parts.to_vec();
        waiting.retain(|part| seen.insert(*part));
        waiting
            .iter()
            .try_for_each(|part| self.check_number(*part))?;
        if !waiting.is_empty() {
            self.remove(SUCCESS)?;
        }
        let pieces = waiting.iter().map(|part| pieces(&self.rows_of(*part)));
        let threads = threads.min(pieces.fold(0, usize::saturating_add));
        let run = Run {
            parts: self,
            queue: Mutex::new(Queue {
                waiting: &waiting,
                open: None,
            }),
            problem: Mutex::new(None),
            written: AtomicU64::new(0),
            failures: AtomicU64::new(0),
            warnings: Mutex::new(RowRemarks::default()),
            shared: Mutex::new(RowRemarks::default()),
        };
        let progress = |rows: u64| PartsProgress {
            rows,
            parts: run.written.load(Ordering::Relaxed),
            failures: run.failures.load(Ordering::Relaxed),
            warnings: RowRemarks::default(),
            shared: RowRemarks::default(),
        };
        let mut done = 0;
        let mut watch = |rows: u64| {
            done = rows;
            watch(progress(rows))
        };
        let ended = shared(threads, &mut watch, |tick| {
            if let Err(problem) = run.work(tick) {
                lock(&run.problem).get_or_insert(problem);
            }
        });
        sync_folder(self.folder());
        let mut result = progress(done);
        result.warnings = std::mem::take(&mut *lock(&run.warnings));
        result.shared = std::mem::take(&mut *lock(&run.shared));
        match (lock(&run.problem).take(), ended) {
            (Some(problem), _) => Err(problem),
            (None, Err(_)) => Err(RunError::Stopped.into()),
            (None, Ok(())) => Ok(result),
        }
    }
}

/// What the threads share.
struct Run<'a> {
    parts: &'a Parts<'a>,
    queue: Mutex<Queue<'a>>,
    /// The first problem; it ends the run.
    problem: Mutex<Option<PartsError>>,
    written: AtomicU64,
    failures: AtomicU64,
    warnings: Mutex<RowRemarks>,
    shared: Mutex<RowRemarks>,
}

/// The parts that are not begun, and the one whose rows are given out.
struct Queue<'a> {
    waiting: &'a [u64],
    open: Option<Share<'a>>,
}

/// Rows of a part in work.
struct Share<'a> {
    part: Arc<OpenPart<'a>>,
    rows: Range<u64>,
}

/// A part in work.
struct OpenPart<'a> {
    number: u64,
    block: SourceBlock<'a>,
    rows: Range<u64>,
    /// The solved pieces by their place.
    pieces: Mutex<Vec<Option<Results>>>,
    left: AtomicUsize,
}

/// The number of pieces of a part.
fn pieces(rows: &Range<u64>) -> usize {
    (rows.end - rows.start).div_ceil(PIECE_ROWS as u64) as usize
}

impl<'a> Run<'a> {
    /// Solves pieces until none is left; the work of one thread.
    fn work(&self, tick: &mut Tick<'_>) -> Result<(), PartsError> {
        let mut solver = Rows::new(self.parts.sweep);
        while let Some(Share { part: open, rows }) = self.next()? {
            let place = ((rows.start - open.rows.start) / PIECE_ROWS as u64) as usize;
            let Some(piece) = self.solve(&mut solver, &open, rows, tick)? else {
                return Ok(());
            };
            lock(&open.pieces)[place] = Some(piece);
            if open.left.fetch_sub(1, Ordering::AcqRel) == 1 {
                self.write(&open)?;
            }
        }
        lock(&self.warnings).append(solver.warnings);
        lock(&self.shared).append(solver.shared);
        Ok(())
    }

    /// The next rows, of the open part or of a new one; none if there are no more or the run has
    /// failed.
    fn next(&self) -> Result<Option<Share<'a>>, PartsError> {
        let mut queue = lock(&self.queue);
        if lock(&self.problem).is_some() {
            return Ok(None);
        }
        let Share { part, rows: left } = match queue.open.take() {
            Some(open) => open,
            None => {
                let Some((number, waiting)) = queue.waiting.split_first() else {
                    return Ok(None);
                };
                queue.waiting = waiting;
                let part = self.begin(*number)?;
                let rows = part.rows.clone();
                let part = Arc::new(part);
                Share { part, rows }
            }
        };
        let end = left.end.min(left.start + PIECE_ROWS as u64);
        if end < left.end {
            queue.open = Some(Share {
                part: Arc::clone(&part),
                rows: end..left.end,
            });
        }
        let rows = left.start..end;
        Ok(Some(Share { part, rows }))
    }

    fn begin(&self, number: u64) -> Result<OpenPart<'a>, PartsError> {
        let rows = self.parts.rows_of(number);
        let count = pieces(&rows);
        Ok(OpenPart {
            number,
            block: self.parts.source.block(rows.clone())?,
            rows,
            pieces: Mutex::new(vec![None; count]),
            left: AtomicUsize::new(count),
        })
    }

    /// Solves a piece; none if the tick ended it.
    fn solve(
        &self,
        solver: &mut Rows<'_>,
        open: &OpenPart<'_>,
        rows: Range<u64>,
        tick: &mut Tick<'_>,
    ) -> Result<Option<Results>, PartsError> {
        let count = (rows.end - rows.start) as usize;
        let memory = |_| RunError::Memory { rows: count as u64 };
        let modes = self.parts.sweep.modes();
        let mut results = Results::unsolved(rows.start, count, modes).map_err(memory)?;
        let first = rows.start - open.rows.start;
        for piece in results.pieces(count) {
            if !solver
                .solve(&open.block, first, piece, tick)
                .map_err(memory)?
            {
                return Ok(None);
            }
        }
        results.failures = std::mem::take(&mut solver.failed);
        Ok(Some(results))
    }

    fn write(&self, open: &OpenPart<'_>) -> Result<(), PartsError> {
        let pieces = std::mem::take(&mut *lock(&open.pieces));
        let sweep = self.parts.sweep;
        let results = joined(open.rows.start, sweep.modes(), pieces.into_iter().flatten());
        let rows = open.rows.end - open.rows.start;
        let results = results.map_err(|_| RunError::Memory { rows })?;
        let part = Part::new(sweep, &open.block, 0, results);
        self.parts.write(open.number, &part)?;
        self.written.fetch_add(1, Ordering::Relaxed);
        let failures = part.results.failures.len() as u64;
        self.failures.fetch_add(failures, Ordering::Relaxed);
        Ok(())
    }
}

/// The pieces one after the other.
fn joined(
    first_row: u64,
    modes: &[ModeName],
    pieces: impl Iterator<Item = Results>,
) -> Result<Results, TryReserveError> {
    let mut all = Results {
        first_row,
        modes: modes.to_vec(),
        mass_kg: Vec::new(),
        certified: Vec::new(),
        frequency_hz: Vec::new(),
        error_hz: Vec::new(),
        share: Vec::new(),
        failures: FailedRows::default(),
        warnings: RowRemarks::default(),
        shared: RowRemarks::default(),
    };
    let mut failures = Vec::new();
    for mut piece in pieces {
        all.mass_kg.append(&mut piece.mass_kg);
        all.certified.append(&mut piece.certified);
        all.frequency_hz.append(&mut piece.frequency_hz);
        all.error_hz.append(&mut piece.error_hz);
        all.share.append(&mut piece.share);
        failures.push(piece.failures);
    }
    all.failures = FailedRows::merged(failures)?;
    Ok(all)
}

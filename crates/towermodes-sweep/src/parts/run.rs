//! Solves parts: all threads work on one part, and the one that finishes it writes it.

use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use super::part::Part;
use super::plan::SweepSource;
use super::write::sync_folder;
use super::{Parts, PartsError};
use crate::results::Results;
use crate::row::RowSolver;
use crate::run::RunError;
use crate::threads::{Tick, lock, shared};

/// Rows that a thread takes at a time.
const PIECE_ROWS: u64 = 256;

/// How far a sweep is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PartsProgress {
    /// Rows solved by this run.
    pub rows: u64,
    /// Parts written by this run.
    pub parts: u64,
    /// Rows of these parts with a sentence.
    pub failures: u64,
}

impl Parts<'_> {
    /// Solves parts and writes each when it is complete. The bytes of a part do not depend on the
    /// number of threads.
    ///
    /// The watch is called on the calling thread about fifty times a second. If it ends the run,
    /// the parts in work are lost, usually one.
    ///
    /// # Errors
    /// [`PartsError`]: a part cannot be written, the table has changed, or the watch ended the run.
    /// What is written stays.
    pub fn solve(
        &self,
        parts: &[u64],
        threads: usize,
        watch: &mut dyn FnMut(PartsProgress) -> ControlFlow<()>,
    ) -> Result<PartsProgress, PartsError> {
        let run = Run {
            parts: self,
            queue: Mutex::new(Queue {
                waiting: parts,
                open: None,
            }),
            problem: Mutex::new(None),
            written: AtomicU64::new(0),
            failures: AtomicU64::new(0),
        };
        let progress = |rows: u64| PartsProgress {
            rows,
            parts: run.written.load(Ordering::Relaxed),
            failures: run.failures.load(Ordering::Relaxed),
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
        let result = progress(done);
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
}

/// The parts that are not begun, and the one whose rows are given out.
struct Queue<'a> {
    waiting: &'a [u64],
    open: Option<Share>,
}

/// Rows of a part in work.
struct Share {
    part: Arc<OpenPart>,
    rows: Range<u64>,
}

/// A part in work.
struct OpenPart {
    number: u64,
    /// The values of its rows if they are from a table.
    table: Option<Vec<f64>>,
    rows: Range<u64>,
    /// The solved pieces by their place.
    pieces: Mutex<Vec<Option<Part>>>,
    left: AtomicUsize,
}

impl Run<'_> {
    /// Solves pieces until none is left; the work of one thread.
    fn work(&self, tick: &mut Tick<'_>) -> Result<(), PartsError> {
        let mut solver = RowSolver::new(self.parts.sweep);
        while let Some(Share { part: open, rows }) = self.next()? {
            let place = ((rows.start - open.rows.start) / PIECE_ROWS) as usize;
            let Some(piece) = self.solve(&mut solver, &open, rows, tick)? else {
                return Ok(());
            };
            lock(&open.pieces)[place] = Some(piece);
            if open.left.fetch_sub(1, Ordering::AcqRel) == 1 {
                self.write(&open)?;
            }
        }
        Ok(())
    }

    /// The next rows, of the open part or of a new one; none if there are no more or the run has
    /// failed.
    fn next(&self) -> Result<Option<Share>, PartsError> {
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
        let end = left.end.min(left.start + PIECE_ROWS);
        if end < left.end {
            queue.open = Some(Share {
                part: Arc::clone(&part),
                rows: end..left.end,
            });
        }
        let rows = left.start..end;
        Ok(Some(Share { part, rows }))
    }

    fn begin(&self, number: u64) -> Result<OpenPart, PartsError> {
        let rows = self.parts.rows_of(number);
        let table = match self.parts.source {
            SweepSource::Table(table) => Some(table.read(rows.clone())?),
            SweepSource::Sampled { .. } => None,
        };
        let count = (rows.end - rows.start).div_ceil(PIECE_ROWS) as usize;
        Ok(OpenPart {
            number,
            table,
            rows,
            pieces: Mutex::new(vec![None; count]),
            left: AtomicUsize::new(count),
        })
    }

    /// Solves a piece; none if the tick ended it.
    fn solve(
        &self,
        solver: &mut RowSolver<'_>,
        open: &OpenPart,
        rows: Range<u64>,
        tick: &mut Tick<'_>,
    ) -> Result<Option<Part>, PartsError> {
        let sweep = self.parts.sweep;
        let count = (rows.end - rows.start) as usize;
        let memory = |_| RunError::Memory { rows: count as u64 };
        let mut results = Results::unsolved(rows.start, count, sweep.modes()).map_err(memory)?;
        let inputs = self.values(open, &rows);
        let width = sweep.changes().len();
        let mut failures = Vec::new();
        for mut piece in results.pieces(count) {
            for (index, values) in inputs.chunks_exact(width).enumerate() {
                let sentence = solver.solve(values, piece.cells(index));
                failures.extend(sentence.map(|text| (rows.start + index as u64, text)));
                if !tick() {
                    return Ok(None);
                }
            }
        }
        results.failures = failures;
        Ok(Some(Part { inputs, results }))
    }

    /// The values of rows, row by row.
    fn values(&self, open: &OpenPart, rows: &Range<u64>) -> Vec<f64> {
        let width = self.parts.sweep.changes().len();
        match (&open.table, self.parts.source) {
            (Some(values), _) => {
                let place = |row: u64| (row - open.rows.start) as usize * width;
                values[place(rows.start)..place(rows.end)].to_vec()
            }
            (None, SweepSource::Sampled { draw, .. }) => {
                let mut values = vec![0.0; (rows.end - rows.start) as usize * width];
                for (row, values) in rows.clone().zip(values.chunks_exact_mut(width)) {
                    draw.row(row, values);
                }
                values
            }
            // `begin` reads the rows of every table.
            (None, SweepSource::Table(_)) => Vec::new(),
        }
    }

    fn write(&self, open: &OpenPart) -> Result<(), PartsError> {
        let pieces = std::mem::take(&mut *lock(&open.pieces));
        let mut part = joined(pieces.into_iter().flatten(), self.parts);
        if !self.parts.sweep.has_inputs() {
            part.inputs = Vec::new();
        }
        part.results.first_row = open.rows.start;
        self.parts.write(open.number, &part)?;
        self.written.fetch_add(1, Ordering::Relaxed);
        let failures = part.results.failures.len() as u64;
        self.failures.fetch_add(failures, Ordering::Relaxed);
        Ok(())
    }
}

/// The pieces one after the other.
fn joined(pieces: impl Iterator<Item = Part>, parts: &Parts<'_>) -> Part {
    let mut all = Part {
        inputs: Vec::new(),
        results: Results {
            first_row: 0,
            modes: parts.sweep.modes().to_vec(),
            mass_kg: Vec::new(),
            certified: Vec::new(),
            frequency_hz: Vec::new(),
            error_hz: Vec::new(),
            failures: Vec::new(),
        },
    };
    for mut piece in pieces {
        all.inputs.append(&mut piece.inputs);
        let (to, from) = (&mut all.results, &mut piece.results);
        to.mass_kg.append(&mut from.mass_kg);
        to.certified.append(&mut from.certified);
        to.frequency_hz.append(&mut from.frequency_hz);
        to.error_hz.append(&mut from.error_hz);
        to.failures.append(&mut from.failures);
    }
    all
}

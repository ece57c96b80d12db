//! Rows solved by several threads, whose results are taken in the order of the rows.
//!
//! Each thread fetches a piece of rows, solves it and prepares its results; the thread that has the
//! next piece in the order passes it to `take`. At most [`AHEAD`] rows wait for an earlier piece,
//! so any number of rows needs little memory.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::{Arc, Condvar, Mutex};
use std::time::Duration;

use super::results::Results;
use super::row::RowSolver;
use super::run_error::RunError;
use super::threads::{Tick, Watch, lock, shared};
use super::warned::RowRemarks;
use crate::source::{RowSource, SourceBlock};
use crate::sweep::Sweep;

/// Number of rows that a thread fetches at a time, some milliseconds of work; for fewer rows a
/// further thread is not worthwhile.
const PIECE_ROWS: u64 = 64;
/// Number of rows whose values are read at a time.
const BLOCK_ROWS: u64 = 16_384;
/// Number of rows that may be solved before an earlier row is finished.
const AHEAD: u64 = 16_384;
/// A thread that waits for an earlier piece checks with this interval whether the run has ended.
const BETWEEN_LOOKS: Duration = Duration::from_millis(20);

/// Remarks on the rows of a run.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Remarks {
    /// Rows with input that is probably a mistake.
    pub(crate) warnings: RowRemarks,
    /// Rows in which several modes share a motion.
    pub(crate) shared: RowRemarks,
}

/// Solves rows and passes their prepared results to `take` in the order of the rows. What is passed
/// does not depend on the number of threads.
///
/// # Errors
/// The first error of `block` or `take`, [`RunError::Stopped`] or [`RunError::Memory`].
pub(crate) fn stream<'a, P: Send, E: From<RunError> + Send>(
    sweep: &Sweep,
    rows: Range<u64>,
    (threads, watch): (usize, &mut Watch<'_>),
    block: impl Fn(Range<u64>) -> Result<SourceBlock<'a>, E> + Sync,
    prepare: impl Fn(&SourceBlock<'_>, Results) -> P + Sync,
    take: impl FnMut(P) -> Result<(), E> + Send,
) -> Result<Remarks, E> {
    let pieces = (rows.end - rows.start).div_ceil(PIECE_ROWS);
    let threads = threads.min(usize::try_from(pieces).unwrap_or(usize::MAX));
    let run = Run {
        sweep,
        end: rows.end,
        block,
        prepare,
        queue: Mutex::new(Queue {
            next: rows.start,
            block: None,
        }),
        order: Mutex::new(Order {
            next: rows.start,
            waiting: BTreeMap::new(),
            is_taking: false,
            is_over: false,
        }),
        has_moved: Condvar::new(),
        take: Mutex::new(take),
        problem: Mutex::new(None),
        remarks: Mutex::new(Remarks::default()),
    };
    let ended = shared(threads, watch, |tick| run.work(tick));
    let problem = run.problem.into_inner().unwrap_or_else(|e| e.into_inner());
    match (problem, ended) {
        (Some(problem), _) => Err(problem),
        (None, Err(_)) => Err(RunError::Stopped.into()),
        (None, Ok(())) => Ok(run.remarks.into_inner().unwrap_or_else(|e| e.into_inner())),
    }
}

/// Data shared by the threads.
struct Run<'r, 'a, B, F, T, P, E> {
    sweep: &'r Sweep,
    /// The number after the last row.
    end: u64,
    block: B,
    prepare: F,
    queue: Mutex<Queue<'a>>,
    order: Mutex<Order<P>>,
    /// Signals that results were passed on, or that the run has ended.
    has_moved: Condvar,
    take: Mutex<T>,
    /// The first error; it ends the run.
    problem: Mutex<Option<E>>,
    remarks: Mutex<Remarks>,
}

/// The rows that no thread has begun.
struct Queue<'a> {
    next: u64,
    /// The values of the next rows.
    block: Option<Arc<SourceBlock<'a>>>,
}

/// Rows of a block that a thread solves.
struct Share<'a> {
    block: Arc<SourceBlock<'a>>,
    rows: Range<u64>,
}

/// The results that are not yet passed on.
struct Order<P> {
    /// The first row that is not yet passed on.
    next: u64,
    /// By the first row of a piece: the number after its last row, and the results.
    waiting: BTreeMap<u64, (u64, P)>,
    /// Whether a thread is passing results on.
    is_taking: bool,
    /// Whether the run has ended.
    is_over: bool,
}

impl<'a, B, F, T, P, E> Run<'_, 'a, B, F, T, P, E>
where
    B: Fn(Range<u64>) -> Result<SourceBlock<'a>, E>,
    F: Fn(&SourceBlock<'_>, Results) -> P,
    T: FnMut(P) -> Result<(), E>,
    E: From<RunError>,
{
    /// Solves pieces until none is left; the work of one thread.
    fn work(&self, tick: &mut Tick<'_>) {
        // Also where the work panics, so that no thread waits for its piece.
        let _over = Over(&self.order, &self.has_moved);
        let mut solver = Rows::new(self.sweep);
        let done = self.solve_all(&mut solver, tick);
        if let Err(problem) = done {
            lock(&self.problem).get_or_insert(problem);
        }
        let mut remarks = lock(&self.remarks);
        remarks.warnings.append(solver.remarks.warnings);
        remarks.shared.append(solver.remarks.shared);
    }

    fn solve_all(&self, solver: &mut Rows<'_>, tick: &mut Tick<'_>) -> Result<(), E> {
        while let Some(Share { block, rows }) = self.next()? {
            let Some(results) = solver.solve(&block, rows.clone(), tick)? else {
                break;
            };
            let prepared = (self.prepare)(&block, results);
            self.put(rows, prepared)?;
        }
        Ok(())
    }

    /// The next rows; none if there are no more or the run has ended.
    fn next(&self) -> Result<Option<Share<'a>>, E> {
        let mut queue = lock(&self.queue);
        if queue.next == self.end || !self.may_begin(queue.next) {
            return Ok(None);
        }
        let block = match queue.block.take() {
            Some(block) => block,
            None => {
                let end = self.end.min(queue.next + BLOCK_ROWS);
                Arc::new((self.block)(queue.next..end)?)
            }
        };
        let end_of_block = block.first_row() + block.rows();
        let rows = queue.next..end_of_block.min(queue.next + PIECE_ROWS);
        queue.next = rows.end;
        if rows.end < end_of_block {
            queue.block = Some(Arc::clone(&block));
        }
        Ok(Some(Share { block, rows }))
    }

    /// Waits until the row is within [`AHEAD`] rows of the next row to be passed on; false if the
    /// run has ended.
    fn may_begin(&self, row: u64) -> bool {
        let mut order = lock(&self.order);
        while !order.is_over && row >= order.next + AHEAD {
            let waited = self.has_moved.wait_timeout(order, BETWEEN_LOOKS);
            order = waited.unwrap_or_else(|e| e.into_inner()).0;
        }
        !order.is_over
    }

    /// Adds results, and passes on all that are next in the order, unless another thread is doing
    /// this.
    fn put(&self, rows: Range<u64>, prepared: P) -> Result<(), E> {
        let mut order = lock(&self.order);
        order.waiting.insert(rows.start, (rows.end, prepared));
        if order.is_taking {
            return Ok(());
        }
        loop {
            let next = order.next;
            let Some((end, results)) = order.waiting.remove(&next) else {
                order.is_taking = false;
                return Ok(());
            };
            order.is_taking = true;
            drop(order);
            // Others go on while the results are written.
            (lock(&self.take))(results)?;
            order = lock(&self.order);
            order.next = end;
            self.has_moved.notify_all();
        }
    }
}

/// On the end of a thread: wakes the others, because nothing is left to do or the run has ended.
struct Over<'a, P>(&'a Mutex<Order<P>>, &'a Condvar);

impl<P> Drop for Over<'_, P> {
    fn drop(&mut self) {
        let Self(order, has_moved) = self;
        lock(order).is_over = true;
        has_moved.notify_all();
    }
}

/// Data of one thread for solving rows.
struct Rows<'a> {
    sweep: &'a Sweep,
    solver: RowSolver<'a>,
    values: Vec<f64>,
    /// The remarks on all rows that it has solved.
    remarks: Remarks,
}

impl<'a> Rows<'a> {
    fn new(sweep: &'a Sweep) -> Self {
        Self {
            sweep,
            solver: RowSolver::new(sweep),
            values: vec![0.0; sweep.changes().len()],
            remarks: Remarks::default(),
        }
    }

    /// Solves rows of a block; none if the tick stopped the work.
    fn solve(
        &mut self,
        block: &SourceBlock<'_>,
        rows: Range<u64>,
        tick: &mut Tick<'_>,
    ) -> Result<Option<Results>, RunError> {
        let count = rows.end - rows.start;
        let full = |_| RunError::Memory { rows: count };
        let results = Results::unsolved(rows.start, count as usize, self.sweep.modes());
        let mut results = results.map_err(full)?;
        for (place, row) in rows.enumerate() {
            block.row(row - block.first_row(), &mut self.values);
            let failure = self.solver.solve(&self.values, results.cells(place));
            if let Some(sentence) = failure {
                results.failures.push(row, &sentence).map_err(full)?;
            }
            self.solver.warn(row, &mut self.remarks.warnings);
            self.solver.share(row, &mut self.remarks.shared);
            if !tick() {
                return Ok(None);
            }
        }
        Ok(Some(results))
    }
}

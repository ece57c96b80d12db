//! Computations without the interpreter lock that Ctrl-C interrupts.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::time::{Duration, Instant};

use pyo3::prelude::*;
use towermodes::{Options, Progress, Solver, Stage};

use crate::lock::{attached, released};

/// Time between two checks for signals.
const BETWEEN_LOOKS: Duration = Duration::from_millis(50);

/// Time between two calls of a Python function.
pub const BETWEEN_REPORTS: Duration = Duration::from_secs(1);

/// The exception of a signal handler, while it unwinds a computation.
struct Interrupted(PyErr);

/// Runs a computation without the interpreter lock; other Python threads run meanwhile.
///
/// The computation reports its progress to this function, which checks for signals. It can be
/// interrupted only by unwinding, which releases its memory.
///
/// # Errors
/// The exception of a signal handler: `KeyboardInterrupt`.
pub fn interruptible<T: Send>(
    py: Python<'_>,
    options: Options,
    work: impl FnOnce(&mut Solver) -> T + Send,
) -> PyResult<T> {
    looking(py, |mut look| {
        work(&mut Solver::new(options).watched(move |_| look()))
    })
}

/// Runs a computation of many towers without the interpreter lock. A Python function is called
/// about once a second with the number of solved towers; its exceptions end the computation too.
///
/// # Errors
/// The exception of a signal handler or of the function.
pub fn reported<T: Send>(
    py: Python<'_>,
    progress: Option<Py<PyAny>>,
    options: Options,
    work: impl FnOnce(&mut Solver) -> T + Send,
) -> PyResult<T> {
    let (mut solved, mut reported) = (0_u64, Instant::now());
    looking(py, |mut look| {
        let mut solver = Solver::new(options).watched(move |now| {
            solved += u64::from(begins(&now));
            if let Some(progress) = &progress
                && reported.elapsed() >= BETWEEN_REPORTS
            {
                reported = Instant::now();
                let called = attached(|py| progress.call1(py, (solved,)).map(drop));
                called.unwrap_or_else(|exception| interrupted(exception));
            }
            look();
        });
        work(&mut solver)
    })
}

/// Whether a solve begins.
fn begins(now: &Progress) -> bool {
    now.products == 0 && matches!(now.stage, Stage::Modes { .. })
}

/// Ends the computation.
fn interrupted(exception: PyErr) -> ! {
    resume_unwind(Box::new(Interrupted(exception)))
}

/// Runs a computation without the interpreter lock; the computation receives the function that
/// checks for signals.
///
/// # Errors
/// The exception of a signal handler: `KeyboardInterrupt`.
pub fn looking<T: Send>(py: Python<'_>, work: impl FnOnce(Look) -> T + Send) -> PyResult<T> {
    released(py, || {
        let work = AssertUnwindSafe(|| work(watch()));
        catch_unwind(work).map_err(|thrown| match thrown.downcast::<Interrupted>() {
            Ok(interrupted) => interrupted.0,
            Err(panic) => resume_unwind(panic),
        })
    })
}

/// Checks for signals, unless the last check was a short time ago.
pub type Look = Box<dyn FnMut() + Send + Sync>;

fn watch() -> Look {
    let mut looked = Instant::now();
    Box::new(move || {
        if looked.elapsed() < BETWEEN_LOOKS {
            return;
        }
        looked = Instant::now();
        attached(|py| py.check_signals()).unwrap_or_else(|exception| interrupted(exception));
    })
}

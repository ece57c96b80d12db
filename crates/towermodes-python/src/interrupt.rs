//! Computations without the interpreter lock that Ctrl-C ends.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::time::{Duration, Instant};

use pyo3::prelude::*;
use towermodes::Workspace;

use crate::lock::{attached, released};

/// Time between two looks for a signal.
const BETWEEN_LOOKS: Duration = Duration::from_millis(50);

/// The exception of a signal handler, on its way out of a computation.
struct Interrupted(PyErr);

/// Runs a computation without the interpreter lock; other Python threads run meanwhile.
///
/// The computation reports its progress to this function, which looks for signals. There is no
/// other way out of it than unwinding; its memory is released on the way.
///
/// # Errors
/// The exception of a signal handler: `KeyboardInterrupt`.
pub fn interruptible<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&mut Workspace) -> T + Send,
) -> PyResult<T> {
    looking(py, |mut look| {
        let mut workspace = Workspace::watched(move |_| look());
        work(&mut workspace)
    })
}

/// The same for a computation that is given the function that looks for signals.
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

/// Looks for signals, if it has not just done so.
pub type Look = Box<dyn FnMut() + Send + Sync>;

fn watch() -> Look {
    let mut looked = Instant::now();
    Box::new(move || {
        if looked.elapsed() < BETWEEN_LOOKS {
            return;
        }
        looked = Instant::now();
        if let Err(exception) = attached(|py| py.check_signals()) {
            resume_unwind(Box::new(Interrupted(exception)));
        }
    })
}

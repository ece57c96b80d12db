//! The interpreter lock, which is released during computations and acquired again.
//!
//! When the interpreter ends, CPython before 3.14 ends every other thread that tries to acquire the
//! lock again: it unwinds the stack of the thread, which crashes or aborts the process if the stack
//! has frames of Rust. Therefore, after [`close`], which Python calls at its exit, no other thread
//! of this module acquires the lock or runs Python: it sleeps until the process ends, as in CPython
//! 3.14.

use std::cell::Cell;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

use pyo3::prelude::*;

/// The longest time that the exit waits for busy threads. They take some milliseconds; the limit is
/// reached only in the child of a fork, where the counted threads do not exist.
const PATIENCE: Duration = Duration::from_secs(1);

/// Whether the interpreter is ending.
static CLOSED: AtomicBool = AtomicBool::new(false);
/// The thread that ends the interpreter, which may continue to run Python.
static CLOSING: OnceLock<ThreadId> = OnceLock::new();
/// Number of threads of this module that wait for the lock or run Python.
static BUSY: AtomicUsize = AtomicUsize::new(0);

/// A thread of this module that waits for the lock or runs Python.
struct Busy;

impl Busy {
    /// Counts this thread; none if the interpreter is ending and the thread must stop.
    fn new() -> Option<Self> {
        // Counted before the look: `close` sees this thread, or this thread sees that it is closed.
        BUSY.fetch_add(1, Ordering::SeqCst);
        let busy = Self;
        let is_closing = || CLOSING.get() == Some(&thread::current().id());
        let may_go_on = !CLOSED.load(Ordering::SeqCst) || is_closing();
        may_go_on.then_some(busy)
    }
}

impl Drop for Busy {
    fn drop(&mut self) {
        BUSY.fetch_sub(1, Ordering::SeqCst);
    }
}

/// Sleeps until the process ends.
fn stop() -> ! {
    loop {
        thread::park();
    }
}

thread_local! {
    /// Whether this thread has released the lock by [`released`].
    static IS_RELEASED: Cell<bool> = const { Cell::new(false) };
}

/// Marks the lock as released or not released by this thread, until the end of a block.
struct Released(bool);

impl Released {
    fn set(is_released: bool) -> Self {
        Self(IS_RELEASED.replace(is_released))
    }
}

impl Drop for Released {
    fn drop(&mut self) {
        IS_RELEASED.set(self.0);
    }
}

/// Runs a computation without the interpreter lock; other Python threads run meanwhile.
pub fn released<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> T {
    let (result, busy) = py.detach(|| {
        let released = Released::set(true);
        let result = work();
        drop(released);
        (result, Busy::new().unwrap_or_else(|| stop()))
    });
    drop(busy);
    result
}

/// Runs Python, also during a computation without the lock.
pub fn attached<T>(run: impl FnOnce(Python<'_>) -> T) -> T {
    if IS_RELEASED.get() {
        let _busy = Busy::new().unwrap_or_else(|| stop());
        let _attached = Released::set(false);
        return Python::attach(run);
    }
    Python::attach(|py| {
        // A thread that has the lock may not stop with it.
        let _busy = Busy::new().unwrap_or_else(|| py.detach(|| stop()));
        run(py)
    })
}

/// Prevents other threads from returning to Python; Python calls this function at its exit.
#[pyfunction]
pub fn close(py: Python<'_>) {
    CLOSING.get_or_init(|| thread::current().id());
    CLOSED.store(true, Ordering::SeqCst);
    py.detach(|| {
        let start = Instant::now();
        while BUSY.load(Ordering::SeqCst) > 0 && start.elapsed() < PATIENCE {
            thread::sleep(Duration::from_millis(1));
        }
    });
}

//! Work in pieces, shared by threads and watched by the caller.
//!
//! The threads end with the work: there is no pool that a forked process could wait for.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// The watcher is called at least this often, up to the time of one row.
const BETWEEN_LOOKS: Duration = Duration::from_millis(20);

/// Called on the thread that runs a sweep about fifty times a second with the number of rows that
/// are done; [`ControlFlow::Break`] ends the sweep.
pub type Watch<'a> = dyn FnMut(u64) -> ControlFlow<()> + 'a;

/// Called after each row; false ends the work.
pub(crate) type Tick<'a> = dyn FnMut() -> bool + 'a;

/// The work was ended by the [`Watch`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Ended;

/// Runs `work` on a number of threads at once; with one thread on the calling one. Each takes its
/// pieces by itself and returns when none is left, or when its tick is false.
pub(crate) fn shared(
    threads: usize,
    watch: &mut Watch<'_>,
    work: impl Fn(&mut Tick<'_>) + Sync,
) -> Result<(), Ended> {
    if threads <= 1 {
        return on_this_thread(watch, work);
    }
    let (done, working) = (AtomicU64::new(0), AtomicUsize::new(threads));
    let ends = AtomicBool::new(false);
    let caller = thread::current();
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                // Also where the work panics, so that the caller does not wait for it.
                let _leave = Leave(&working, &caller, &ends);
                work(&mut || {
                    done.fetch_add(1, Ordering::Relaxed);
                    !ends.load(Ordering::Relaxed)
                });
            });
        }
        while working.load(Ordering::Acquire) > 0 {
            thread::park_timeout(BETWEEN_LOOKS);
            if watch(done.load(Ordering::Relaxed)).is_break() {
                ends.store(true, Ordering::Relaxed);
            }
        }
    });
    let has_ended = ends.load(Ordering::Relaxed);
    // The last look sees all that was done, however fast it was.
    match has_ended || watch(done.load(Ordering::Relaxed)).is_break() {
        true => Err(Ended),
        false => Ok(()),
    }
}

/// A thread that leaves the work.
struct Leave<'a>(&'a AtomicUsize, &'a thread::Thread, &'a AtomicBool);

impl Drop for Leave<'_> {
    fn drop(&mut self) {
        let Self(working, caller, ends) = self;
        if thread::panicking() {
            ends.store(true, Ordering::Relaxed);
        }
        working.fetch_sub(1, Ordering::Release);
        caller.unpark();
    }
}

fn on_this_thread(watch: &mut Watch<'_>, work: impl Fn(&mut Tick<'_>)) -> Result<(), Ended> {
    let (mut done, mut looked, mut ended) = (0, Instant::now(), Ok(()));
    work(&mut || {
        done += 1;
        if looked.elapsed() >= BETWEEN_LOOKS {
            looked = Instant::now();
            if watch(done).is_break() {
                ended = Err(Ended);
            }
        }
        ended.is_ok()
    });
    if ended.is_ok() && watch(done).is_break() {
        return Err(Ended);
    }
    ended
}

/// A lock; a thread that panicked while it had it left the list as it was.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

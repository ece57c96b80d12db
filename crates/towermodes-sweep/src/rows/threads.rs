//! Work in pieces, done by several threads while the caller is kept informed.
//!
//! The threads end with the work: there is no thread pool, because after a fork a process would
//! wait for it forever.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::{self, Builder};
use std::time::{Duration, Instant};

/// The watch is called at least with this interval, plus the time of one row.
const BETWEEN_LOOKS: Duration = Duration::from_millis(20);

/// Called on the thread that runs a sweep about fifty times a second with the number of finished
/// rows; [`ControlFlow::Break`] stops the sweep.
pub type Watch<'a> = dyn FnMut(u64) -> ControlFlow<()> + 'a;

/// Called after each row; false stops the work.
pub(crate) type Tick<'a> = dyn FnMut() -> bool + 'a;

/// The [`Watch`] stopped the work before it was finished.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Ended;

/// Runs `work` on several threads at once; with one thread on the calling thread. Each thread
/// fetches pieces until none is left, or until its tick is false.
///
/// If the system does not start all threads, the started ones do all the work.
pub(crate) fn shared(
    threads: usize,
    watch: &mut Watch<'_>,
    work: impl Fn(&mut Tick<'_>) + Sync,
) -> Result<(), Ended> {
    match threads {
        0 | 1 => on_this_thread(watch, work),
        _ => on_threads(threads, Builder::new, watch, work),
    }
}

fn on_threads(
    threads: usize,
    builder: impl Fn() -> Builder,
    watch: &mut Watch<'_>,
    work: impl Fn(&mut Tick<'_>) + Sync,
) -> Result<(), Ended> {
    let (done, working) = (AtomicU64::new(0), AtomicUsize::new(0));
    let [ends, is_cut] = [AtomicBool::new(false), AtomicBool::new(false)];
    let caller = thread::current();
    let started = thread::scope(|scope| {
        let mut started = 0;
        while started < threads {
            working.fetch_add(1, Ordering::Relaxed);
            let spawned = builder().spawn_scoped(scope, || {
                // Also where the work panics, so that the caller does not wait for it.
                let _leave = Leave(&working, &caller, &ends);
                work(&mut || {
                    done.fetch_add(1, Ordering::Relaxed);
                    let goes_on = !ends.load(Ordering::Relaxed);
                    if !goes_on {
                        is_cut.store(true, Ordering::Relaxed);
                    }
                    goes_on
                });
            });
            if spawned.is_err() {
                working.fetch_sub(1, Ordering::Relaxed);
                break;
            }
            started += 1;
        }
        while working.load(Ordering::Acquire) > 0 {
            thread::park_timeout(BETWEEN_LOOKS);
            if watch(done.load(Ordering::Relaxed)).is_break() {
                ends.store(true, Ordering::Relaxed);
            }
        }
        started
    });
    if started == 0 {
        return on_this_thread(watch, work);
    }
    last_look(watch, done.into_inner());
    match is_cut.into_inner() {
        true => Err(Ended),
        false => Ok(()),
    }
}

/// The last call of the watch reports all rows, however fast they were solved; it cannot stop
/// finished work.
fn last_look(watch: &mut Watch<'_>, done: u64) {
    let _ = watch(done);
}

/// On the end of a thread: decreases the number of working threads and wakes the caller.
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
    last_look(watch, done);
    ended
}

/// Locks a mutex; if a thread panicked while it had the lock, the list is still valid.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::thread::Builder;

    use super::{Ended, on_this_thread, on_threads, shared};

    /// 1000 rows that threads take one by one.
    fn rows(taken: &AtomicUsize) -> impl Fn(&mut super::Tick<'_>) + Sync {
        move |tick| while taken.fetch_add(1, Ordering::Relaxed) < 1000 && tick() {}
    }

    /// No system can allocate 2⁶⁰ bytes for the stack of a thread.
    #[test]
    fn threads_that_do_not_start_are_not_waited_for() {
        for most in [0, 1, 3] {
            let (taken, asked) = (AtomicUsize::new(0), AtomicUsize::new(0));
            let builder = || match asked.fetch_add(1, Ordering::Relaxed) < most {
                true => Builder::new(),
                false => Builder::new().stack_size(1 << 60),
            };
            let mut last = 0;
            let mut watch = |done| {
                last = done;
                ControlFlow::Continue(())
            };
            assert_eq!(on_threads(8, builder, &mut watch, rows(&taken)), Ok(()));
            assert_eq!((last, asked.into_inner()), (1000, most + 1));
        }
    }

    /// A watch that stops the work when it is called for the last row has no effect.
    #[test]
    fn finished_work_is_not_thrown_away() {
        for threads in [1, 4] {
            let taken = AtomicUsize::new(0);
            let mut watch = |done| match done {
                1000 => ControlFlow::Break(()),
                _ => ControlFlow::Continue(()),
            };
            // The threads are still there when the watch sees the last row.
            let lingering = |tick: &mut super::Tick<'_>| {
                rows(&taken)(tick);
                std::thread::sleep(2 * super::BETWEEN_LOOKS);
            };
            assert_eq!(shared(threads, &mut watch, lingering), Ok(()));
        }
        let taken = AtomicUsize::new(0);
        let slow = |tick: &mut super::Tick<'_>| {
            std::thread::sleep(2 * super::BETWEEN_LOOKS);
            rows(&taken)(tick);
        };
        let ended = on_this_thread(&mut |_| ControlFlow::Break(()), slow);
        assert_eq!(ended, Err(Ended));
        assert!(taken.into_inner() < 1000);
    }
}

//! Progress of long computations on the last line of the terminal (standard error), shown after
//! half a second and removed at the end. If standard error is a file, a line is written every half
//! minute.

use std::fmt::Write;
use std::io::IsTerminal;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use towermodes::{Options, Solution, SolveError, Solver, Stage, Tower};
use towermodes_report::wording::printable;

use crate::messages::report;
use crate::terminal::NOT_SHOWN;

/// Shorter computations show no progress.
pub(crate) const QUIET: Duration = Duration::from_millis(500);
/// Time between two updates.
const TICK: Duration = Duration::from_millis(100);
/// Steps of the bar.
const STEPS: u64 = 1000;
/// Below this fraction the remaining time is not estimated.
const KNOWN: f64 = 0.03;

/// Time between two lines of a log.
const BETWEEN_LINES: Duration = Duration::from_secs(30);

/// The times at which a long computation writes a line to a log, which shows that it continues.
#[derive(Debug, Clone, Default)]
pub(crate) struct Log {
    /// Number of lines written.
    lines: u32,
}

impl Log {
    /// Whether the next line is due at this time since the beginning.
    pub(crate) fn is_due(&mut self, elapsed: Duration) -> bool {
        let is_due = elapsed >= BETWEEN_LINES * (self.lines + 1);
        if is_due {
            self.lines = (elapsed.as_secs() / BETWEEN_LINES.as_secs()) as u32;
        }
        is_due
    }
}

/// A solver for a search that solves many towers, with a line that states their number. On a
/// terminal it is the last line and is removed at the end; in a log a line is written from time to
/// time.
pub(crate) fn searching(options: Options) -> (Solver, impl Drop) {
    let is_seen = std::io::stderr().is_terminal();
    let target = match is_seen {
        true => ProgressDrawTarget::stderr(),
        false => ProgressDrawTarget::hidden(),
    };
    let line = Cleared(ProgressBar::with_draw_target(None, target));
    let (bar, begun) = (line.0.clone(), Instant::now());
    // The template is a constant and valid.
    let style = ProgressStyle::with_template("{msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let (mut solved, mut log) = (0_u64, Log::default());
    let solver = Solver::new(options).watched(move |now| {
        let begins = now.products == 0 && matches!(now.stage, Stage::Modes { .. });
        solved += u64::from(begins);
        let elapsed = begun.elapsed();
        if !begins || elapsed < QUIET {
            return;
        }
        let said = || {
            format!(
                "{}: {solved} towers solved",
                duration(elapsed.as_secs_f64())
            )
        };
        match is_seen {
            true => bar.set_message(said()),
            false if log.is_due(elapsed) => report(&(said() + "\n")),
            false => {}
        }
    });
    (solver, line)
}

/// A line that is removed at the end.
struct Cleared(ProgressBar);

impl Drop for Cleared {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

/// The progress line, or lines in a log.
pub(crate) struct Progress {
    now: Arc<Mutex<Now>>,
    /// None if standard error is not a terminal.
    line: Option<Arc<Line>>,
    begun: Instant,
}

impl Progress {
    /// Progress of one computation.
    pub(crate) fn of_one() -> Self {
        Self::of([String::new()])
    }

    /// Progress of several computations of equal cost, by their names.
    pub(crate) fn of(names: impl IntoIterator<Item = String>) -> Self {
        Self::of_weighted(names.into_iter().map(|name| (name, 1.0)))
    }

    /// Progress of several computations, by their names and relative costs.
    pub(crate) fn of_weighted(pieces: impl IntoIterator<Item = (String, f64)>) -> Self {
        let now = Arc::new(Mutex::new(Now::new(pieces.into_iter().collect())));
        let is_seen = std::io::stderr().is_terminal();
        Self {
            line: is_seen.then(|| Arc::new(Line::new(Arc::clone(&now)))),
            now,
            begun: Instant::now(),
        }
    }

    /// Marks the current computation as finished, and begins the next one.
    pub(crate) fn done(&self) {
        locked(&self.now).next();
    }

    /// A solver for the current computation that reports its progress. The progress line remains
    /// until the solver is dropped.
    pub(crate) fn solver(&self, options: Options) -> Solver {
        let (now, line, begun) = (Arc::clone(&self.now), self.line.clone(), self.begun);
        Solver::new(options).watched(move |progress| {
            let mut now = locked(&now);
            now.hear(progress);
            let elapsed = begun.elapsed();
            if line.is_none() && now.log.is_due(elapsed) {
                report(&(self::line(&now, elapsed.as_secs_f64()) + "\n"));
            }
        })
    }
}

/// Solves a tower with a progress line.
///
/// # Errors
/// As [`Solver::solve_certain`].
pub(crate) fn solve(tower: &Tower, options: &Options) -> Result<Solution, SolveError> {
    let mut solver = Progress::of_one().solver(options.clone());
    solver.solve_certain(tower)
}

/// The state of the progress.
#[derive(Debug, Clone)]
struct Now {
    /// Names and relative costs; the name of a single computation is empty.
    pieces: Vec<(String, f64)>,
    /// The index of the current computation.
    at: usize,
    /// The finished fraction of the current computation.
    share: f64,
    stage: Option<Stage>,
    log: Log,
}

impl Now {
    fn new(pieces: Vec<(String, f64)>) -> Self {
        Self {
            pieces,
            at: 0,
            share: 0.0,
            stage: None,
            log: Log::default(),
        }
    }

    fn next(&mut self) {
        self.at += 1;
        self.share = 0.0;
        self.stage = None;
    }

    /// Updates the progress. A computation may consist of several solves; the progress never
    /// decreases.
    fn hear(&mut self, progress: towermodes::Progress) {
        self.share = self.share.max(progress.fraction);
        self.stage = Some(progress.stage);
    }

    /// The finished fraction of all computations, 0 to 1.
    fn fraction(&self) -> f64 {
        let weight =
            |pieces: &[(String, f64)]| pieces.iter().map(|(_, weight)| weight).sum::<f64>();
        let before = weight(&self.pieces[..self.at.min(self.pieces.len())]);
        let here = self.pieces.get(self.at).map_or(0.0, |(_, weight)| *weight);
        let fraction = (before + here * self.share) / weight(&self.pieces);
        if fraction.is_finite() { fraction } else { 0.0 }
    }

    /// "2 of 7, rmje 60", or the stage of a single solve.
    fn what(&self) -> String {
        match (self.pieces.get(self.at), self.stage) {
            (Some((name, _)), stage) if name.is_empty() => {
                stage.map_or_else(|| "solving".to_owned(), said)
            }
            (Some((name, _)), _) => {
                let (number, of) = (self.at + 1, self.pieces.len());
                format!(
                    "{number} of {of}, {}",
                    shortened(&printable(name, NOT_SHOWN))
                )
            }
            (None, _) => "all done".to_owned(),
        }
    }
}

fn locked(now: &Mutex<Now>) -> std::sync::MutexGuard<'_, Now> {
    now.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The line on the terminal, drawn by its own thread after [`QUIET`] and removed on drop.
struct Line {
    bar: ProgressBar,
    stop: Option<Sender<()>>,
    drawer: Option<JoinHandle<()>>,
}

impl Line {
    fn new(now: Arc<Mutex<Now>>) -> Self {
        let bar = ProgressBar::with_draw_target(Some(STEPS), ProgressDrawTarget::hidden());
        bar.set_style(style(Arc::clone(&now)));
        let (stop, stopped) = channel::<()>();
        let (drawn, seen) = (bar.clone(), now);
        let draw = move || {
            let fraction = locked(&seen).fraction();
            drawn.set_position((fraction * STEPS as f64) as u64);
            drawn.tick();
        };
        let target = bar.clone();
        let drawer = thread::Builder::new().spawn(move || {
            if stopped.recv_timeout(QUIET) != Err(RecvTimeoutError::Timeout) {
                return;
            }
            target.set_draw_target(ProgressDrawTarget::stderr());
            draw();
            while stopped.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
                draw();
            }
        });
        Self {
            bar,
            stop: Some(stop),
            // Without a thread there is no progress line.
            drawer: drawer.ok(),
        }
    }
}

impl Drop for Line {
    fn drop(&mut self) {
        drop(self.stop.take());
        if let Some(drawer) = self.drawer.take() {
            // A panic of the drawing thread is ignored.
            let _ = drawer.join();
        }
        self.bar.finish_and_clear();
    }
}

/// A bar and the text after it.
fn style(now: Arc<Mutex<Now>>) -> ProgressStyle {
    let words = move |state: &ProgressState, out: &mut dyn Write| {
        let now = locked(&now).clone();
        let _ = out.write_str(&line(&now, state.elapsed().as_secs_f64()));
    };
    // The template is a constant and valid.
    let style = ProgressStyle::with_template("[{bar:10}] {words}");
    let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
    style.with_key("words", words).progress_chars("=> ")
}

/// "43 %, 12 s, 16 s left: modes on 1000000 segments".
fn line(now: &Now, seconds: f64) -> String {
    let fraction = now.fraction();
    let left = match fraction {
        known if known >= KNOWN => {
            let left = seconds * (1.0 - fraction) / fraction;
            format!(", {} left", duration(left))
        }
        _ => String::new(),
    };
    let percent = (100.0 * fraction).floor();
    format!("{percent} %, {}{left}: {}", duration(seconds), now.what())
}

/// "12 s", "3 min".
pub(crate) fn duration(seconds: f64) -> String {
    match seconds {
        short if short < 99.5 => format!("{short:.0} s"),
        long => format!("{:.0} min", long / 60.0),
    }
}

/// Names are cut to this number of characters, so that the text fits on one line.
const LONGEST: usize = 28;

fn shortened(name: &str) -> String {
    match name.char_indices().nth(LONGEST) {
        None => name.to_owned(),
        Some((end, _)) => format!("{}\u{2026}", &name[..end]),
    }
}

/// "modes on 1000000 segments".
fn said(stage: Stage) -> String {
    match stage {
        Stage::Modes {
            segments,
            degree: None,
        } => format!("modes on {segments} segments"),
        Stage::Modes {
            segments,
            degree: Some(degree),
        } => format!("modes on {segments} elements of degree {degree}"),
        Stage::Certificate => "mode count".to_owned(),
        Stage::Buckling => "buckling load".to_owned(),
        Stage::Shapes => "mode shapes".to_owned(),
        Stage::Errors {
            mesh,
            meshes,
            segments,
        } => format!("errors, mesh {mesh} of {meshes}, {segments} segments"),
        _ => "solving".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::{Log, Now, line};
    use std::time::Duration;
    use towermodes::Stage;

    #[test]
    fn a_log_gets_a_line_every_half_minute_and_none_for_short_work() {
        let mut log = Log::default();
        let seconds = [0.0, 29.9, 30.0, 30.1, 59.0, 61.0, 200.0, 201.0, 210.0];
        let lines = seconds.map(|s| log.is_due(Duration::from_secs_f64(s)));
        let expected = [false, false, true, false, false, true, true, false, true];
        assert_eq!(lines, expected);
    }

    fn pieces(names: &[&str]) -> Now {
        Now::new(names.iter().map(|name| ((*name).to_owned(), 1.0)).collect())
    }

    fn at(stage: Stage, fraction: f64) -> Now {
        let mut now = pieces(&[""]);
        now.hear(towermodes::Progress {
            stage,
            products: 84,
            fraction,
        });
        now
    }

    #[test]
    fn a_solve_says_how_much_is_done_and_how_long_the_rest_takes() {
        let segments = 1_000_000;
        let modes = Stage::Modes {
            segments,
            degree: None,
        };
        assert_eq!(
            line(&at(modes, 0.25), 12.0),
            "25 %, 12 s, 36 s left: modes on 1000000 segments"
        );
        // At the beginning no time is known.
        assert_eq!(
            line(&at(modes, 0.0), 1.0),
            "0 %, 1 s: modes on 1000000 segments"
        );
        assert_eq!(line(&pieces(&[""]), 1.0), "0 %, 1 s: solving");
        assert_eq!(
            line(&at(Stage::Shapes, 0.5), 240.0),
            "50 %, 4 min, 4 min left: mode shapes"
        );
    }

    #[test]
    fn pieces_are_counted_with_what_is_done_of_the_one_at_hand() {
        let mut now = pieces(&["spectral, rmje 60", "lumped 60", "bmodes 60", "cardanic 60"]);
        assert_eq!(line(&now, 1.0), "0 %, 1 s: 1 of 4, spectral, rmje 60");
        now.next();
        let progress = |fraction: f64| towermodes::Progress {
            stage: Stage::Shapes,
            products: 0,
            fraction,
        };
        now.hear(progress(0.8));
        // A second solve of the same computation does not reduce the progress.
        now.hear(progress(0.1));
        assert_eq!(line(&now, 9.0), "45 %, 9 s, 11 s left: 2 of 4, lumped 60");
        (0..3).for_each(|_| now.next());
        assert_eq!(line(&now, 20.0), "100 %, 20 s, 0 s left: all done");
        assert_eq!(Now::new(Vec::new()).fraction(), 0.0);
    }

    #[test]
    fn no_line_is_wider_than_eighty() {
        let segments = 1_000_000;
        let longest = [
            at(
                Stage::Modes {
                    segments: 100_000,
                    degree: Some(60),
                },
                0.5,
            ),
            at(
                Stage::Errors {
                    mesh: 3,
                    meshes: 3,
                    segments,
                },
                0.5,
            ),
            pieces(&["\u{e9}".repeat(40).as_str(); 1000]),
        ];
        for now in longest {
            let wide = "[==========] ".to_owned() + &line(&now, 6000.0);
            assert!(wide.chars().count() <= 80, "{wide}");
        }
    }

    #[test]
    fn long_names_are_cut() {
        let now = pieces(&["\u{e9}".repeat(40).as_str()]);
        assert!(line(&now, 1.0).ends_with(&format!("{}\u{2026}", "\u{e9}".repeat(28))));
    }
}

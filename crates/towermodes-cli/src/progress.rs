//! What long work is at, on the last line of a terminal: standard error only, after half a second, and gone when the work is done.

use std::fmt::Write;
use std::io::IsTerminal;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use towermodes::{Options, Solution, SolveError, Stage, Tower, Workspace, solve_certain};

/// Work that takes no longer than this is done without a word.
const QUIET: Duration = Duration::from_millis(500);
/// From one look at the work to the next.
const TICK: Duration = Duration::from_millis(100);

/// A line with what is done; nothing where nobody sees it.
pub(crate) struct Progress {
    line: Option<Line>,
    /// What the pieces of work are called.
    names: Vec<String>,
}

impl Progress {
    /// Of one piece of work that tells what it is at.
    pub(crate) fn of_one() -> Self {
        Self::with(|| ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden()))
    }

    /// Of pieces of work that are done one after the other, by their names.
    pub(crate) fn of(names: impl IntoIterator<Item = String>) -> Self {
        let names: Vec<String> = names.into_iter().collect();
        let count = Some(names.len() as u64);
        let bar = || ProgressBar::with_draw_target(count, ProgressDrawTarget::hidden());
        let progress = Self {
            names,
            ..Self::with(bar)
        };
        progress.say_next();
        progress
    }

    fn with(bar: impl FnOnce() -> ProgressBar) -> Self {
        let is_seen = std::io::stderr().is_terminal();
        Self {
            line: is_seen.then(|| Line::new(bar())),
            names: Vec::new(),
        }
    }

    /// One more piece is done, and the next one begins.
    pub(crate) fn done(&self) {
        if let Some(line) = &self.line {
            line.bar.inc(1);
        }
        self.say_next();
    }

    fn say_next(&self) {
        if let Some(line) = &self.line {
            let next = self.names.get(line.bar.position() as usize);
            say(
                &line.now,
                next.map_or(Now::Unknown, |name| Now::At(name.clone())),
            );
        }
    }

    /// Memory for a solve that tells what it is at.
    pub(crate) fn workspace(&self) -> Workspace {
        let Some(line) = &self.line else {
            return Workspace::default();
        };
        let now = Arc::clone(&line.now);
        Workspace::watched(move |progress| say(&now, Now::Solving(progress)))
    }
}

/// Solves a tower, and says what that is at if it takes long.
///
/// # Errors
/// As [`solve_certain`].
pub(crate) fn solve(tower: &Tower, options: &Options) -> Result<Solution, SolveError> {
    let progress = Progress::of_one();
    solve_certain(tower, options, &mut progress.workspace())
}

/// What is at hand.
#[derive(Debug, Clone, Default)]
enum Now {
    /// Nothing was heard yet.
    #[default]
    Unknown,
    /// A solve told this.
    Solving(towermodes::Progress),
    /// This piece of several.
    At(String),
}

fn say(now: &Mutex<Now>, what: Now) {
    *now.lock().unwrap_or_else(PoisonError::into_inner) = what;
}

/// A line of the terminal, drawn by a thread of its own from [`QUIET`] on; dropped it is gone.
struct Line {
    bar: ProgressBar,
    now: Arc<Mutex<Now>>,
    stop: Option<Sender<()>>,
    drawer: Option<JoinHandle<()>>,
}

impl Line {
    fn new(bar: ProgressBar) -> Self {
        let now = Arc::new(Mutex::new(Now::default()));
        bar.set_style(style(&bar, Arc::clone(&now)));
        let (stop, stopped) = channel::<()>();
        let drawn = bar.clone();
        let drawer = thread::Builder::new().spawn(move || {
            if stopped.recv_timeout(QUIET) != Err(RecvTimeoutError::Timeout) {
                return;
            }
            drawn.set_draw_target(ProgressDrawTarget::stderr());
            drawn.tick();
            while stopped.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
                drawn.tick();
            }
        });
        Self {
            bar,
            now,
            stop: Some(stop),
            // Without a thread there is no line, and all else is as it would be.
            drawer: drawer.ok(),
        }
    }
}

impl Drop for Line {
    fn drop(&mut self) {
        drop(self.stop.take());
        if let Some(drawer) = self.drawer.take() {
            // One that panicked has nothing to say any more.
            let _ = drawer.join();
        }
        self.bar.finish_and_clear();
    }
}

/// A spinner or a bar, what is at hand, and the seconds so far.
fn style(bar: &ProgressBar, now: Arc<Mutex<Now>>) -> ProgressStyle {
    let template = match bar.length() {
        None => "{spinner} {now}, {seconds}",
        Some(_) => "[{bar:16}] {pos} of {len}, {seconds}{now}",
    };
    let is_spinner = bar.length().is_none();
    let now = move |_: &ProgressState, out: &mut dyn Write| {
        let now = now.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let _ = out.write_str(&text(&now, is_spinner));
    };
    let seconds = |state: &ProgressState, out: &mut dyn Write| {
        let _ = write!(out, "{:.1} s", state.elapsed().as_secs_f64());
    };
    // The templates above are right: another style would be a fault of this file.
    let style = ProgressStyle::with_template(template);
    let style = style.unwrap_or_else(|_| ProgressStyle::default_spinner());
    style
        .with_key("now", now)
        .with_key("seconds", seconds)
        .progress_chars("=> ")
}

fn text(now: &Now, is_spinner: bool) -> String {
    match now {
        Now::Unknown if is_spinner => "solving".to_owned(),
        Now::Unknown => String::new(),
        Now::Solving(progress) if is_spinner => solving(*progress),
        Now::Solving(progress) => format!("; {}", solving(*progress)),
        Now::At(what) => format!("; now: {}", shortened(what)),
    }
}

/// A name is cut after so many characters, so that a line stays one.
const LONGEST: usize = 28;

fn shortened(name: &str) -> String {
    match name.char_indices().nth(LONGEST) {
        None => name.to_owned(),
        Some((end, _)) => format!("{}\u{2026}", &name[..end]),
    }
}

/// "looking for modes on 1000000 segments: 84 products".
fn solving(progress: towermodes::Progress) -> String {
    let stage = match progress.stage {
        Stage::Modes {
            segments,
            degree: None,
        } => format!("looking for modes on {segments} segments"),
        Stage::Modes {
            segments,
            degree: Some(degree),
        } => format!("looking for modes on {segments} elements of degree {degree}"),
        Stage::Certificate => "proving that none is missing".to_owned(),
        Stage::Buckling => "looking for the load that buckles it".to_owned(),
        Stage::Shapes => "naming the modes".to_owned(),
        Stage::Errors {
            mesh,
            meshes,
            segments,
        } => format!("errors: mesh {mesh} of {meshes}, {segments} segments"),
        _ => "solving".to_owned(),
    };
    match progress.products {
        0 => stage,
        1 => format!("{stage}: 1 product"),
        products => format!("{stage}: {products} products"),
    }
}

#[cfg(test)]
mod tests {
    use super::{Now, solving, text};
    use towermodes::Stage;

    fn at(stage: Stage, products: usize) -> towermodes::Progress {
        towermodes::Progress { stage, products }
    }

    #[test]
    fn a_stage_is_said_with_its_numbers() {
        let segments = 1_000_000;
        let modes = |degree| Stage::Modes { segments, degree };
        assert_eq!(
            solving(at(modes(None), 84)),
            "looking for modes on 1000000 segments: 84 products"
        );
        let errors = Stage::Errors {
            mesh: 1,
            meshes: 2,
            segments: 50,
        };
        assert_eq!(
            text(&Now::Solving(at(errors, 0)), false),
            "; errors: mesh 1 of 2, 50 segments"
        );
        assert_eq!(text(&Now::At("rmje 60".into()), false), "; now: rmje 60");
    }

    #[test]
    fn no_line_is_wider_than_eighty() {
        let segments = 1_000_000;
        let longest = [
            at(
                Stage::Modes {
                    segments,
                    degree: Some(199),
                },
                99_999,
            ),
            at(Stage::Buckling, 99_999),
            at(
                Stage::Errors {
                    mesh: 2,
                    meshes: 2,
                    segments,
                },
                99_999,
            ),
        ];
        // A spinner, a comma and the seconds.
        for progress in longest {
            assert!(solving(progress).len() + "  , 1000.0 s".len() <= 80);
        }
    }

    #[test]
    fn long_names_are_cut() {
        let now = Now::At("\u{e9}".repeat(40));
        let cut = format!("; now: {}\u{2026}", "\u{e9}".repeat(28));
        assert_eq!(text(&now, false), cut);
        // The bar, its numbers and the seconds before it.
        let bar = "[================] 1000 of 1000, 1000.0 s";
        assert!((bar.to_owned() + &cut).chars().count() <= 80);
    }
}

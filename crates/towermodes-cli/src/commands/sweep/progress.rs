//! Progress of a sweep: rows, rate, remaining time. On a terminal it is the last line; in a log a
//! line is written from time to time.

use std::fmt::Write as _;
use std::io::IsTerminal;
use std::time::Instant;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use crate::messages::report;
use crate::progress::{Log, QUIET, duration};

/// The progress line, or lines of a log if standard error is not a terminal.
pub(super) struct SweepProgress {
    bar: Option<ProgressBar>,
    log: Log,
    rows: u64,
    begun: Instant,
}

impl SweepProgress {
    /// Progress of a sweep with this number of rows. Rows printed on a terminal already show the
    /// progress.
    pub(super) fn new(rows: u64, are_printed: bool) -> Self {
        let begun = Instant::now();
        let is_shown = !are_printed || !std::io::stdout().is_terminal();
        let bar = (is_shown && std::io::stderr().is_terminal()).then(|| {
            let bar = ProgressBar::with_draw_target(Some(rows), ProgressDrawTarget::hidden());
            let words = move |state: &ProgressState, out: &mut dyn std::fmt::Write| {
                let seconds = begun.elapsed().as_secs_f64();
                let _ = out.write_str(&line(state.pos(), rows, seconds));
            };
            // The template is a constant and valid.
            let style = ProgressStyle::with_template("[{bar:10}] {words}");
            let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
            bar.set_style(style.with_key("words", words).progress_chars("=> "));
            bar
        });
        let log = Log::default();
        Self {
            bar,
            log,
            rows,
            begun,
        }
    }

    /// Sets the number of finished rows.
    pub(super) fn set(&mut self, rows: u64) {
        let Some(bar) = &self.bar else {
            let elapsed = self.begun.elapsed();
            if rows < self.rows && self.log.is_due(elapsed) {
                report(&format!(
                    "{}\n",
                    line(rows, self.rows, elapsed.as_secs_f64())
                ));
            }
            return;
        };
        if bar.is_hidden() && self.begun.elapsed() >= QUIET {
            bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        bar.set_position(rows);
    }
}

impl Drop for SweepProgress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

/// "43 %, 430000 of 1000000 rows, 44100 rows/s, 13 s left".
fn line(done: u64, rows: u64, seconds: f64) -> String {
    let percent = (100.0 * done as f64 / rows.max(1) as f64).floor();
    let mut line = format!("{percent} %, {done} of {rows} rows");
    let rate = done as f64 / seconds;
    if done > 0 && rate.is_finite() {
        let left = rows.saturating_sub(done) as f64 / rate;
        let _ = write!(line, ", {rate:.0} rows/s, {} left", duration(left));
    }
    line
}

#[cfg(test)]
mod tests {
    use super::line;

    #[test]
    fn rows_rate_and_time_left() {
        assert_eq!(line(0, 10, 0.0), "0 %, 0 of 10 rows");
        assert_eq!(
            line(250_000, 1_000_000, 5.0),
            "25 %, 250000 of 1000000 rows, 50000 rows/s, 15 s left"
        );
        let widest = line(4_294_967_295, 4_294_967_296, 1e5);
        assert!(widest.len() + 13 <= 80, "{widest}");
    }
}

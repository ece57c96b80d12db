//! Random frames, by themselves and under a tower: how often the errors hold that are estimated for
//! their modes.
//!
//! `cargo run --release -p towermodes-random --example random_frames [FRAMES]` prints a line for
//! each kind: the modes, the percentage whose error is at most three times the estimate, the median
//! of estimated/true, and the worst. On standard error it prints the modes that are not covered.
#![allow(clippy::print_stdout, reason = "an example prints")]

use towermodes::{Method, Solver};
use towermodes_random::{Sample, Tally, frame_samples, samples_on_frame};

const FRAMES: u64 = 1000;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let frames = arguments.next().and_then(|text| text.parse().ok());
    let frames = frames.unwrap_or(FRAMES);
    let mut solver = Solver::default();
    show("frames alone", frames, frame_samples);
    for method in [Method::Spectral, Method::RmjeExact] {
        show(
            &format!("under a tower, {}", method.name()),
            frames,
            |number| samples_on_frame(number, method, &mut solver),
        );
    }
}

/// Prints the coverage of so many frames that can be solved.
fn show(title: &str, frames: u64, mut samples: impl FnMut(u64) -> Option<Vec<Sample>>) {
    let mut tally = Tally::default();
    for sample in (0..)
        .filter_map(&mut samples)
        .take(frames as usize)
        .flatten()
    {
        tally.add(&sample);
        if !sample.is_covered() {
            eprintln!(
                "{title} {}, mode {}: {:.9} Hz, estimated {:.3e}, true {:.3e}, relative {:.1e}",
                sample.tower,
                sample.mode,
                sample.frequency_hz,
                sample.claimed_hz,
                sample.true_hz,
                sample.true_hz / sample.frequency_hz,
            );
        }
    }
    let of = |ratio: Option<f64>| ratio.map_or_else(|| "-".into(), |ratio| format!("{ratio:.2}"));
    println!(
        "{title}: {} modes, {:.3} %, median {}, least {}",
        tally.modes(),
        100.0 * tally.coverage(),
        of(tally.median_ratio()),
        of(tally.least_ratio()),
    );
}

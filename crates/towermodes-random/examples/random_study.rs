//! Random towers of many classes by every method: how often the claimed errors hold.
//!
//! `cargo run --release -p towermodes-random --example random_study [SEEDS [CLASS]]` prints two
//! tables, the one of the default number of segments and that of 10 to 60: for each class and
//! method the share of modes whose error is at most three times the claimed one, in percent, and
//! the median of claimed/true. On standard error it prints the modes that are not covered.
#![allow(clippy::print_stdout, reason = "an example prints")]

use towermodes::{Method, Solver};
use towermodes_random::{Class, Fineness, Sample, Tally, samples, table};

const SEEDS: u64 = 500;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let seeds = arguments.next().and_then(|text| text.parse().ok());
    let seeds = seeds.unwrap_or(SEEDS);
    let wanted = arguments.next();
    let is_wanted = |class: &Class| wanted.as_deref().is_none_or(|name| class.name() == name);
    let classes: Vec<Class> = Class::ALL.into_iter().filter(is_wanted).collect();
    for (title, fineness) in [
        ("Default segments", Fineness::Default),
        ("10 to 60 segments", Fineness::Coarse),
    ] {
        let rows: Vec<_> = classes
            .iter()
            .map(|&class| (class, study(class, seeds, fineness)))
            .collect();
        println!("{title}:\n\n{}", table(&Method::ALL, &rows));
        for (class, tallies) in &rows {
            for (method, tally) in Method::ALL.iter().zip(tallies) {
                let (class, method) = (class.name(), method.name());
                let (refused, warned) = (tally.refused(), tally.warned());
                if refused + warned > 0 {
                    eprintln!(
                        "{class}, {method}: {refused} towers refused, {warned} modes beside a warning"
                    );
                }
            }
        }
    }
}

/// All towers of a class by all methods.
fn study(class: Class, seeds: u64, fineness: Fineness) -> Vec<Tally> {
    let mut tallies = vec![Tally::default(); Method::ALL.len()];
    let mut solver = Solver::default();
    for number in 0..seeds {
        let solved = match samples(class, number, fineness, &Method::ALL, &mut solver) {
            Ok(solved) => solved,
            Err(error) => {
                eprintln!("{} {number}: no reference: {error}", class.name());
                continue;
            }
        };
        for ((method, tally), solved) in Method::ALL.iter().zip(&mut tallies).zip(solved) {
            match solved {
                Ok(samples) => samples.iter().for_each(|sample| {
                    tally.add(sample);
                    show(class, *method, sample);
                }),
                Err(error) => {
                    eprintln!("{} {number}, {}: {error}", class.name(), method.name());
                    tally.refuse();
                }
            }
        }
    }
    tallies
}

/// Tells of a mode that is not covered.
fn show(class: Class, method: Method, sample: &Sample) {
    if sample.is_covered() {
        return;
    }
    eprintln!(
        "{} {}, {}, {} segments, mode {}: {:.8} Hz, claimed {:.3e}, true {:.3e}, relative {:.1e}{}",
        class.name(),
        sample.tower,
        method.name(),
        sample.segments,
        sample.mode,
        sample.frequency_hz,
        sample.claimed_hz,
        sample.true_hz,
        sample.true_hz / sample.frequency_hz,
        if sample.is_warned { ", warned" } else { "" }
    );
}

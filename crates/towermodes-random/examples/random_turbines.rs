//! Random turbines of many classes: how often the errors hold that are estimated for their modes.
//!
//! `cargo run --release -p towermodes-random --example random_turbines [SEEDS [CLASS]]` prints a
//! table: for each class the percentage of modes whose error is at most three times the estimate,
//! the median of estimated/true, and the worst. On standard error it prints the modes that are not
//! covered.
#![allow(clippy::print_stdout, reason = "an example prints")]

use towermodes_random::{Tally, TurbineClass, turbine_samples, turbine_table};

const SEEDS: u64 = 100;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let seeds = arguments.next().and_then(|text| text.parse().ok());
    let seeds = seeds.unwrap_or(SEEDS);
    let wanted = arguments.next();
    let is_wanted =
        |class: &TurbineClass| wanted.as_deref().is_none_or(|name| class.name() == name);
    let classes = TurbineClass::ALL.into_iter().filter(is_wanted);
    let rows: Vec<_> = classes.map(|class| (class, study(class, seeds))).collect();
    println!("{}", turbine_table(&rows));
    for (class, tally) in &rows {
        let (refused, open) = (tally.refused(), tally.warned());
        if refused + open > 0 {
            let class = class.name();
            eprintln!("{class}: {refused} turbines refused, {open} modes in lists not certified");
        }
    }
}

/// All turbines of a class.
fn study(class: TurbineClass, seeds: u64) -> Tally {
    let mut tally = Tally::default();
    for number in 0..seeds {
        let samples = match turbine_samples(class, number) {
            Ok(samples) => samples,
            Err(error) => {
                eprintln!("{} {number}: {error}", class.name());
                tally.refuse();
                continue;
            }
        };
        for sample in samples {
            tally.add(&sample);
            if !sample.is_covered() {
                eprintln!(
                    "{} {number}, mode {}: {:.8} Hz, estimated {:.3e}, true {:.3e}, relative {:.1e}{}",
                    class.name(),
                    sample.mode,
                    sample.frequency_hz,
                    sample.claimed_hz,
                    sample.true_hz,
                    sample.true_hz / sample.frequency_hz,
                    if sample.is_warned {
                        ", not certified"
                    } else {
                        ""
                    }
                );
            }
        }
    }
    tally
}

//! Names of modes along random paths of towers: how often and how far a name jumps.
//!
//! `cargo run --release -p towermodes-random --example name_study [PATHS [STEPS]]` compares the
//! names of the program with those of a majority of 60 %.
#![allow(clippy::print_stdout, reason = "an example prints")]

use towermodes_random::paths::{NAMES, Outcome, Path, Rule, by_majority, follow};

fn main() {
    let mut arguments = std::env::args().skip(1).map(|text| text.parse().ok());
    let paths = arguments.next().flatten().unwrap_or(200);
    let steps = arguments.next().flatten().unwrap_or(100);
    println!("{paths} paths of {steps} steps, {NAMES} names each");
    println!(
        "| rule | modes without a name | names twice or left out | jumps | of these lost | largest, ln f | beyond the bound |"
    );
    println!("|---|---|---|---|---|---|---|");
    let majority: Rule = by_majority;
    for (title, rule) in [
        ("largest arrears", None),
        ("majority of 60 %", Some(majority)),
    ] {
        let outcomes: Vec<Outcome> = (0..paths)
            .map(|number| follow(&Path::new(number as u64), steps, rule))
            .collect();
        let unnamed: usize = outcomes.iter().map(|outcome| outcome.unnamed).sum();
        let irregular: usize = outcomes.iter().map(|outcome| outcome.irregular).sum();
        let jumps = || outcomes.iter().flat_map(|outcome| &outcome.jumps);
        let known = jumps().filter(|jump| jump.by.is_finite());
        let largest = known.map(|jump| jump.by).fold(0.0, f64::max);
        println!(
            "| {title} | {unnamed} | {irregular} | {} | {} | {largest:.2} | {} |",
            jumps().count(),
            jumps().filter(|jump| jump.by.is_infinite()).count(),
            jumps().filter(|jump| jump.by > 1.001 * jump.bound).count(),
        );
    }
}

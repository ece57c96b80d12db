//! How long a tower on a frame takes, with 8 modes, certificate and errors: `cargo bench -p
//! towermodes --bench frame`. With the argument `once NAME` it is solved once, for a profiler.

use std::hint::black_box;

use criterion::Criterion;
use towermodes::{Options, Solver, Tower};
use towermodes_random::Lattice;

/// A name and what makes the frame.
type Case = (&'static str, fn() -> Lattice);

const CASES: [Case; 2] = [
    ("jacket", Lattice::jacket),
    ("lattice of 700 members", || Lattice::of_members(700)),
];

fn solve(tower: &Tower) {
    let solved = Solver::new(Options::default()).solve(black_box(tower));
    assert!(solved.is_ok_and(|solution| solution.certificate.complete));
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let Some(place) = arguments.iter().position(|argument| argument == "once") {
        let wanted = arguments.get(place + 1).map_or("", String::as_str);
        let cases = CASES.iter().filter(|(name, _)| name.starts_with(wanted));
        cases.for_each(|(_, lattice)| solve(&lattice().with_tower()));
        return;
    }
    let mut criterion = Criterion::default().configure_from_args().sample_size(10);
    for (name, lattice) in CASES {
        let tower = lattice().with_tower();
        criterion.bench_function(name, |b| b.iter(|| solve(&tower)));
    }
    criterion.final_summary();
}

//! Who watches a solve is told every stage and every product, and changes nothing.

use crate::towers;

use std::backtrace::Backtrace;
use std::sync::{Arc, Mutex};

use towermodes::{Method, Options, Progress, Solution, Solver, Stage, Tower, solve};
use towermodes_testing::{changed, with};
use towers::{reference, reference_350t};

/// A solution, with what was told on the way.
fn watched(tower: &Tower, options: &Options) -> (Solution, Vec<Progress>) {
    let told = Arc::new(Mutex::new(Vec::new()));
    let teller = Arc::clone(&told);
    let mut solver = Solver::new(options.clone()).watched(move |progress| {
        teller.lock().expect("a list").push(progress);
    });
    let solution = solver.solve(tower).expect("solved");
    let told = told.lock().expect("a list").clone();
    (solution, told)
}

#[test]
fn what_is_watched_is_the_same() {
    let tower = Tower::new(reference_350t()).expect("a valid tower");
    for method in Method::ALL {
        let options = with!(Options, method);
        let plain = solve(&tower, &options).expect("solved");
        assert_eq!(watched(&tower, &options).0, plain);
    }
}

/// The stages that were told of, one by one.
fn stages(told: &[Progress]) -> Vec<Stage> {
    let entered = told.iter().filter(|progress| progress.products == 0);
    entered.map(|progress| progress.stage).collect()
}

#[test]
fn stages_come_in_order() {
    let tower = Tower::new(reference()).expect("a valid tower");
    let modes = Stage::Modes {
        segments: 100,
        degree: None,
    };
    let errors = |mesh: usize, meshes: usize, segments: usize| Stage::Errors {
        mesh,
        meshes,
        segments,
    };
    let before = [modes, Stage::Certificate, Stage::Buckling, Stage::Shapes];
    // Errors in n^-2 need one other mesh, and one more that finds out what agrees by chance; those
    // in n^-2 and n^-4 two.
    let after = [Method::RmjeExact, Method::Bmodes]
        .map(|method| (method, vec![errors(1, 2, 50), errors(2, 2, 25)]));
    for (method, after) in after {
        let (solution, told) = watched(&tower, &with!(Options, method));
        assert_eq!(stages(&told), [&before[..], &after].concat());
        let last_of_modes = told.iter().rfind(|progress| progress.stage == modes);
        let products = last_of_modes.map(|progress| progress.products);
        assert_eq!(products, Some(solution.statistics.products));
    }
}

#[test]
fn products_of_a_stage_are_counted_one_by_one() {
    let heavy = changed!(reference_350t(), gravity_m_per_s2 = 9.81);
    let tower = Tower::new(heavy).expect("a valid tower");
    let (_, told) = watched(&tower, &Options::default());
    for pair in told.windows(2) {
        let is_next = pair[0].stage == pair[1].stage && pair[1].products == pair[0].products + 1;
        assert!(is_next || pair[1].products == 0, "{pair:?}");
    }
    let of_buckling = told.iter().filter(|told| told.stage == Stage::Buckling);
    assert!(of_buckling.count() > 1, "buckling is iterated too");
}

#[test]
fn the_spectral_beam_tells_its_degrees() {
    let tower = Tower::new(reference()).expect("a valid tower");
    let (solution, told) = watched(&tower, &with!(Options, method = Method::Spectral));
    let degree = |stage: Stage| match stage {
        Stage::Modes { degree, .. } => degree,
        _ => None,
    };
    let degrees: Vec<usize> = stages(&told).into_iter().filter_map(degree).collect();
    assert!(degrees.windows(2).all(|pair| pair[1] == pair[0] + 2));
    assert_eq!(degrees.last().copied(), solution.degree);
}

#[test]
fn the_share_that_is_done_rises_to_the_end() {
    let tower = Tower::new(reference_350t()).expect("a valid tower");
    for method in Method::ALL {
        for modes in [4, 8, 40] {
            let (_, told) = watched(&tower, &with!(Options, method, modes));
            let shares: Vec<f64> = told.iter().map(|progress| progress.fraction).collect();
            let name = method.name();
            assert_eq!(shares[0], 0.0, "{name}");
            assert!(shares.windows(2).all(|pair| pair[0] <= pair[1]), "{name}");
            let last = shares.last().copied().unwrap_or_default();
            assert!((0.4..1.0).contains(&last), "{name}, {modes} modes: {last}");
        }
    }
}

/// A second solve in the same memory begins anew.
#[test]
fn every_solve_begins_with_nothing_done() {
    let tower = Tower::new(reference()).expect("a valid tower");
    let told = Arc::new(Mutex::new(Vec::new()));
    let teller = Arc::clone(&told);
    let mut solver = Solver::default().watched(move |progress: Progress| {
        teller.lock().expect("a list").push(progress.fraction);
    });
    for _ in 0..2 {
        solver.solve(&tower).expect("solved");
    }
    let told = told.lock().expect("a list").clone();
    let falls = told.windows(2).filter(|pair| pair[1] < pair[0]);
    assert_eq!(falls.count(), 1);
}

/// Where in the library the functions are that lead from the front door to the first step of the
/// Lanczos process.
fn way_to_the_first_step() -> Vec<String> {
    let trace = Arc::new(Mutex::new(String::new()));
    let taken = Arc::clone(&trace);
    let mut solver = Solver::default().watched(move |progress: Progress| {
        let mut taken = taken.lock().expect("a text");
        if progress.products == 1 && taken.is_empty() {
            *taken = Backtrace::force_capture().to_string();
        }
    });
    let tower = Tower::new(reference()).expect("a valid tower");
    solver.solve(&tower).expect("solved");
    let trace = trace.lock().expect("a text").clone();
    let places = trace.lines().map(str::trim);
    // The observer itself is not on the way.
    let is_way = |place: &&str| {
        let rooms = ["src/solve/", "src/eigen/"];
        rooms.iter().any(|room| place.contains(room)) && !place.contains("progress.rs")
    };
    places.filter(is_way).map(str::to_owned).collect()
}

/// As far as line tables show them: inlined functions count, and without line tables there are
/// none.
#[test]
fn from_the_front_door_to_a_lanczos_step_there_are_at_most_eight_functions() {
    let way = way_to_the_first_step();
    assert!(way.len() <= 8, "{way:#?}");
}

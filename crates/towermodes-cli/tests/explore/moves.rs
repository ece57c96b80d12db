//! Random moves in one page: sliders, fields, keys, buttons, tabs, the pointer, the window.
//!
//! `TOWERMODES_BROWSER` names a Chromium; without it these tests are skipped.

use serde_json::{Value, json};

use super::page::{Explored, same_digits};
use crate::page::browser::View;

const MOVES_JS: &str = include_str!("moves.js");
/// Moves of one page where every build runs the tests.
const MOVES: usize = 300;
/// Moves between which the pointer drags in the view and the window changes its width.
const BATCH: usize = 50;

/// Nothing on the console, no text without a number, no results of other values, no leak, and what
/// is shown is what `solve` computes.
#[test]
fn random_moves_leave_no_trace() {
    random_moves("examples/monopile.toml", MOVES);
}

/// Each move of a turbine ends the diagram that is being solved.
#[test]
fn random_moves_of_a_turbine_leave_no_trace() {
    random_moves("examples/nrel-5mw-turbine.toml", MOVES.div_ceil(3));
}

/// Rigid sections, lines and soil, a jacket.
#[test]
fn random_moves_of_other_towers_leave_no_trace() {
    for file in [
        "examples/small-turbine/ElastoDyn.dat",
        "examples/floating-lines.toml",
        "examples/monopile-layers.toml",
        "examples/jacket.toml",
    ] {
        random_moves(file, BATCH);
    }
}

#[test]
#[ignore = "takes minutes: cargo test -p towermodes-cli --test all -- --ignored ten_thousand"]
fn ten_thousand_random_moves_leave_no_trace() {
    random_moves("examples/monopile.toml", 10_000);
}

fn random_moves(file: &str, moves: usize) {
    let view = |width| View {
        width,
        is_dark: false,
    };
    let Some(of) = Explored::open(&[file], view(1200)) else {
        return;
    };
    of.page.value(&format!("({MOVES_JS}, 0)"));
    let rounds = moves.div_ceil(BATCH);
    let mut warm = heap(&of);
    for round in 0..rounds {
        of.page.look(view([1200, 360, 900, 1440][round % 4]));
        let seed = round + 1;
        of.page.value(&format!(
            "(window.wrong = null, window.moves({seed}, {BATCH}).then(wrong => window.wrong = wrong), 0)"
        ));
        of.page.wait_long("window.wrong !== null");
        let wrong = of.page.value("window.wrong");
        assert_eq!(wrong, json!([]), "{file}, seed {seed}");
        if of
            .page
            .value("document.querySelector('#view canvas').checkVisibility()")
            == json!(true)
        {
            of.page.drag("#view canvas", (35.0, 10.0 - round as f64));
        }
        of.is_shown();
        // What is shown is what `solve` computes, where the last move was no refusal.
        if round % 8 == 0 && of.page.value("window.towermodes.isCurrent") == Value::Bool(true) {
            same_digits(&of.frequencies_hz(), &of.solved_hz(file));
        }
        // The first rounds fill what is kept on purpose: steps of undo, measured times.
        if round == rounds / 4 {
            warm = heap(&of);
        }
    }
    let after = heap(&of);
    eprintln!(
        "{file}, {moves} moves: heap {:.1} MB, then {:.1} MB",
        warm / 1e6,
        after / 1e6
    );
    assert!(after < 1.2 * warm + 4e6, "{warm} bytes, then {after}");
    of.page.was_quiet();
}

/// What the scripts of the page use, bytes.
fn heap(of: &Explored) -> f64 {
    of.page.call("HeapProfiler.collectGarbage", &json!({}));
    let used = &of.page.call("Runtime.getHeapUsage", &json!({}))["usedSize"];
    used.as_f64().expect("bytes")
}

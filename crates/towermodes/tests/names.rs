//! Names of modes: each once, whatever the number of modes, without jumps; see the files crate for
//! names and shares of an independent code.

use crate::towers;

use towermodes::{Method, Options, Solver};
use towermodes_random::Class;
use towermodes_random::paths::{Path, follow};
use towermodes_testing::with;
use towers::{elliptic, floater, reference_350t, reference_eccentric, rich};

/// All numbers of towers with an eccentric rotor-nacelle assembly change in small steps: a name
/// moves within the modes that share its unit of energy. A mode has a name of one of four motions,
/// and each name is there once. `cargo run --release -p towermodes-random --example name_study`
/// follows more paths.
#[test]
fn names_jump_no_further_than_their_bound() {
    let mut jumps = 0;
    for number in 0..8 {
        let outcome = follow(&Path::new(number), 40, None);
        assert_eq!((outcome.unnamed, outcome.irregular), (0, 0), "{number}");
        for jump in &outcome.jumps {
            assert!(jump.by <= 1.001 * jump.bound, "path {number}: {jump:?}");
        }
        jumps += outcome.jumps.len();
    }
    assert!(jumps > 0, "no path has an avoided crossing");
}

/// A name depends on the modes up to its own: a longer list changes none.
#[test]
fn names_do_not_depend_on_the_number_of_modes() {
    let mut solver = Solver::default();
    let known = [
        reference_350t(),
        reference_eccentric(),
        rich(),
        elliptic(),
        floater(),
    ];
    let random = Class::ALL.iter().map(|class| class.description(1));
    for (place, description) in known.into_iter().chain(random).enumerate() {
        let tower = towermodes::Tower::new(description).expect("a tower");
        for method in [Method::RmjeExact, Method::Bmodes] {
            let mut names = |modes: usize| -> Vec<String> {
                solver.options = with!(Options, method, modes, segments = Some(16));
                let solved = solver.frequencies(&tower);
                let solved = solved.expect("modes");
                solved.modes.iter().map(|mode| mode.label()).collect()
            };
            let all = names(14);
            for count in 1..14 {
                let case = format!("tower {place}, {}, {count} modes", method.name());
                assert_eq!(names(count), all[..count], "{case}");
            }
        }
    }
}

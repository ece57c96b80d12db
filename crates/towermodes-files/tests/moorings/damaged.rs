//! No damaged file makes the readers panic or hang, and what is refused has a place inside its
//! file.

use proptest::prelude::*;
use towermodes_files::ReadError;

use super::texts::{MAP, MOORDYN_2, SITE, changed, map, moordyn};
use crate::mutations::{any_mutation, mutated};

/// With a body, a rod and a free point.
pub fn whole() -> String {
    let parts = "\
--- ROD TYPES ---
TypeName Diam Mass/m
(name) (m) (kg/m)
can 1.2 900
--- BODIES ---
ID  Attachment  X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*
(#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)
1 Coupled 1 2 -5 10 20 30 2e5 0.5|0|-8.0 1e6 250 0 1
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs
(#) (name) (#/key) (m) (m) (m) (m) (m) (m) (-) (-)
1 can Vessel 20 -6 -65 27 -9 -77 8 -
--- POINTS";
    let text = changed(MOORDYN_2, "---------------------- POINTS", parts);
    let text = changed(&text, "1         4 ", "1         R1A ");
    let text = changed(
        &text,
        "5      Vessel    -2.6      4.5     -70.0",
        "5 Body1 -2 4 -65",
    );
    changed(
        &text,
        "4      Vessel     5.2      0.0     -70.0    0     0",
        "4 Free 400 0 -200 10 2",
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, ..ProptestConfig::default() })]

    #[test]
    fn damaged_files_are_evaluated_or_refused(
        file in 0..3_usize,
        mutations in prop::collection::vec(any_mutation(), 1..4),
    ) {
        let text = [MOORDYN_2.to_owned(), MAP.to_owned(), whole()][file].clone();
        let damaged = mutations.iter().fold(text, |text, mutation| mutated(&text, mutation));
        let read = if file == 1 { map(&damaged, &SITE) } else { moordyn(&damaged, &SITE) };
        let result = read.and_then(|input| {
            let mooring = input.mooring()?;
            let state = input.at_rest(&mooring)?;
            let _ = input.warnings(&mooring, &state);
            Ok(state)
        });
        match result {
            Ok(state) => prop_assert!(state.load.force.iter().all(|force| force.is_finite())),
            Err(ReadError::Mistakes { source_file, mistakes }) => {
                prop_assert!(!mistakes.is_empty());
                for mistake in mistakes {
                    prop_assert!(source_file.text.get(mistake.span.clone()).is_some(), "{mistake:?}");
                }
            }
            Err(ReadError::Unreadable(error)) => prop_assert!(false, "{error}"),
        }
    }
}

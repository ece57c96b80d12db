//! A second solve in the same memory allocates nothing in the iteration.

use crate::towers;

use towermodes::Tower;
use towermodes::beam::{BeamRecipe, BeamWorkspace, Beams, assemble_beams};
use towermodes::chain::Chains;
use towermodes::eigen::{EigenWorkspace, lowest};
use towermodes::elements::{Borders, Mesh, Recipe, assemble_chains};
use towermodes::subsystem::{Eigenproblem, SubsystemPencil};
use towers::{reference, reference_350t};

const AT_REST: Eigenproblem = Eigenproblem::Vibration { origin: 0.0 };

#[test]
fn a_reused_workspace_allocates_nothing() {
    let towers = [reference(), reference_350t()].map(|d| Tower::new(d).expect("a valid tower"));
    let mesh = towers
        .each_ref()
        .map(|tower| Mesh::new(tower, Borders::Pieces, 100));
    let (mut chains, mut eigen) = (Chains::default(), EigenWorkspace::default());
    let mut solve = |index: usize| {
        assemble_chains(
            &towers[index],
            &mesh[index],
            &Recipe::default(),
            &mut chains,
        );
        let mut pencil = SubsystemPencil::new(&mut *chains.members_mut()[0], AT_REST);
        lowest(&mut pencil, 4, &mut eigen).expect("stable");
    };
    let first = allocation_counter::measure(|| solve(0));
    assert!(first.count_total > 0, "the counter does not count");
    // The other tower may need a vector more, so it goes first once; from then on nothing.
    solve(1);
    let again = allocation_counter::measure(|| {
        solve(0);
        solve(1);
    });
    assert_eq!(again.count_total, 0);
}

#[test]
fn beams_allocate_nothing_either() {
    let tower = Tower::new(reference_350t()).expect("a valid tower");
    let recipes = [
        (BeamRecipe::Bmodes, 50),
        (
            BeamRecipe::Spectral {
                degree: 15,
                rotary_inertia: true,
                shear: true,
            },
            1,
        ),
    ];
    for (recipe, segments) in recipes {
        let mesh = Mesh::new(&tower, Borders::Pieces, segments);
        let (mut beams, mut assembly) = (Beams::default(), BeamWorkspace::default());
        let mut eigen = EigenWorkspace::default();
        let mut solve = || {
            assemble_beams(&tower, &mesh, recipe, &mut assembly, &mut beams);
            let mut pencil = SubsystemPencil::new(&mut *beams.members_mut()[0], AT_REST);
            lowest(&mut pencil, 4, &mut eigen).expect("stable");
        };
        assert!(allocation_counter::measure(&mut solve).count_total > 0);
        assert_eq!(allocation_counter::measure(&mut solve).count_total, 0);
    }
}

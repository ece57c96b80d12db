//! A second solve in the same memory allocates nothing in the iteration.

use crate::towers;

use towermodes::internal::beam::{BeamRecipe, BeamWorkspace, Beams, assemble_beams};
use towermodes::internal::chain::Chains;
use towermodes::internal::eigen::{EigenWorkspace, lowest};
use towermodes::internal::elements::{Borders, Mesh, Recipe, assemble_chains};
use towermodes::internal::subsystem::{Eigenproblem, SubsystemPencil};
use towermodes::{Options, Solver, Tower};
use towermodes_testing::{changed, with};
use towers::{
    elliptic, floater, monopile, reference, reference_350t, reference_eccentric,
    reference_on_springs,
};

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

#[test]
fn frequencies_of_a_changed_tower_allocate_nothing() {
    let bases = [
        reference_350t(),
        reference_eccentric(),
        elliptic(),
        monopile(),
        floater(),
        changed!(reference_on_springs(), gravity_m_per_s2 = 9.81),
    ];
    for base in bases {
        let changed = |factor: f64| {
            let mut description = base.clone();
            description.rna.mass_kg *= factor;
            let walls = description.stations.iter_mut();
            walls.for_each(|station| station.wall_thickness_m *= factor);
            Tower::new(description).expect("a valid tower")
        };
        let towers = [1.0, 0.97, 1.02].map(changed);
        let options = with!(Options, modes = 4, segments = Some(40));
        let mut solver = Solver::new(options);
        let mut solve = || {
            for tower in &towers {
                solver.frequencies(tower).expect("solvable");
            }
        };
        assert!(allocation_counter::measure(&mut solve).count_total > 0);
        let again = allocation_counter::measure(&mut solve);
        assert_eq!(again.count_total, 0, "{}", towers[0].name());
    }
}

#[test]
fn counts_of_a_turbine_allocate_nothing() {
    let mut model = None;
    let first = allocation_counter::measure(|| {
        model = Some(crate::turbine::model(crate::turbine::tilted()));
    });
    assert!(first.count_total > 0, "the counter does not count");
    let mut count = || model.as_mut().map_or(0, |model| model.count(1.0, 11.5));
    let again = allocation_counter::measure(|| assert!(count() > 0));
    assert_eq!(again.count_total, 0);
}

//! Random free points, bodies and rods: wherever the search begins it ends at the same equilibrium.

use super::decks::{at_rest, buoys, clump, delta, rod};
use towermodes::mooring::{Attachment, Mooring, MooringDescription, MooringError, Pose};
use towermodes_random::Seed;
use towermodes_testing::Close;

fn scattered(mooring: &MooringDescription, by_m: f64, seed: &mut Seed) -> MooringDescription {
    let mut scattered = mooring.clone();
    let mut shift = |at: [f64; 3]| at.map(|x| x + seed.between(-by_m, by_m));
    for point in &mut scattered.points {
        if point.attachment == Attachment::Free {
            point.position_m = shift(point.position_m);
        }
    }
    for body in &mut scattered.bodies {
        body.position_m = shift(body.position_m);
    }
    for rod in &mut scattered.rods {
        rod.ends_m = rod.ends_m.map(&mut shift);
    }
    scattered
}

#[test]
fn the_start_of_the_search_does_not_matter() {
    let mut seed = Seed::new(41);
    for mooring in [clump(), delta()] {
        let expected = at_rest(&mooring);
        for _ in 0..100 {
            let found = at_rest(&scattered(&mooring, 30.0, &mut seed));
            for (found, expected) in found.points_m.iter().zip(&expected.points_m) {
                for (found, expected) in found.iter().zip(expected) {
                    found.within(*expected, 1e-8);
                }
            }
            found.load.stiffness[3][3].close_to(expected.load.stiffness[3][3], 1e-9);
        }
    }
}

/// Bodies and rods can have several equilibria: each found one is stable, and nothing else is
/// answered than an error.
#[test]
fn random_bodies_and_rods_are_in_balance() {
    let mut seed = Seed::new(42);
    let mut found = 0;
    for number in 0..300 {
        let mut mooring = match number % 3 {
            0 => buoys(),
            1 => rod(),
            _ => clump(),
        };
        mooring = scattered(&mooring, 15.0, &mut seed);
        for line in &mut mooring.lines {
            line.length_m *= seed.between(0.97, 1.02);
        }
        for body in &mut mooring.bodies {
            body.mass_kg *= seed.between(0.5, 2.0);
            body.center_m = body.center_m.map(|c| c + seed.between(-1.0, 1.0));
        }
        for rod in &mut mooring.rods {
            // The rod has the length that the scattered ends have.
            rod.mass_kg_per_m *= seed.between(0.5, 3.0);
        }
        let checked = Mooring::new(mooring.clone()).expect("a valid mooring");
        match checked.at(&Pose::default()) {
            Ok(state) => {
                found += 1;
                assert_points_in_balance(&mooring, &state);
            }
            Err(
                MooringError::Sinks { .. }
                | MooringError::TooShort { .. }
                | MooringError::Unstable { .. },
            ) => {}
            Err(error) => panic!("{number}: {error}"),
        }
    }
    assert!(found > 250, "{found}");
}

/// The forces of the lines at each free point are its weight.
fn assert_points_in_balance(
    mooring: &MooringDescription,
    state: &towermodes::mooring::MooringState,
) {
    for (index, point) in mooring.points.iter().enumerate() {
        if point.attachment != Attachment::Free {
            continue;
        }
        let mut sum = [
            0.0,
            0.0,
            (1025.0 * point.volume_m3 - point.mass_kg) * 9.80665,
        ];
        for (line, found) in mooring.lines.iter().zip(&state.lines) {
            for end in 0..2 {
                if line.points[end] == index {
                    sum = std::array::from_fn(|i| sum[i] + found.forces_n[end][i]);
                }
            }
        }
        let tensions = state.lines.iter().flat_map(|line| line.tensions_n);
        let most = tensions.fold(1e6, f64::max);
        let is_small = sum.iter().all(|force| force.abs() < 1e-9 * most);
        assert!(is_small, "{index}: {sum:?} {most}");
    }
}

/// Values of any size: a finite answer or an error, never a search without end.
#[test]
fn wild_free_parts_are_answered() {
    let mut seed = Seed::new(43);
    let mut answers = 0;
    for _ in 0..500 {
        let mut wild = [clump(), delta(), buoys(), rod()][seed.whole(0, 3)].clone();
        let factor = |seed: &mut Seed| seed.log_between(1e-4, 1e4);
        for point in &mut wild.points {
            point.mass_kg *= factor(&mut seed);
            point.volume_m3 *= factor(&mut seed);
        }
        for body in &mut wild.bodies {
            body.mass_kg *= factor(&mut seed);
            body.volume_m3 *= factor(&mut seed);
            body.center_m = body.center_m.map(|c| c * seed.log_between(1e-3, 1e3));
            body.angles_rad = body.angles_rad.map(|_| seed.between(-4.0, 4.0));
        }
        for rod in &mut wild.rods {
            rod.mass_kg_per_m *= factor(&mut seed);
            rod.diameter_m *= seed.log_between(0.1, 10.0);
        }
        for kind in &mut wild.line_types {
            kind.mass_kg_per_m *= seed.log_between(0.1, 10.0);
            kind.axial_stiffness_n *= seed.log_between(1e-2, 1e1);
        }
        for line in &mut wild.lines {
            line.length_m *= seed.between(0.8, 1.3);
        }
        wild = scattered(&wild, seed.log_between(0.1, 100.0), &mut seed);
        let state = Mooring::new(wild.clone()).and_then(|mooring| mooring.at(&Pose::default()));
        if let Ok(state) = state {
            answers += 1;
            let mut entries = state
                .load
                .stiffness
                .iter()
                .flatten()
                .chain(&state.load.force);
            assert!(entries.all(|entry| entry.is_finite()), "{wild:?}");
            assert_points_in_balance(&wild, &state);
        }
    }
    // Others stretch too far, sink, or would rise for kilometres.
    assert!(answers > 200, "{answers}");
}

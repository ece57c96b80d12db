//! Added mass by frequency: modes against dense matrices, the proof where a mode appears twice,
//! limits, derivatives.

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::pencils::dense;
use crate::towers::{all_frequencies, assert_close, assert_same, floater, solved};

use nalgebra::{DMatrix, SymmetricEigen};
use towermodes::internal::chain::Chains;
use towermodes::internal::elements::{Borders, Element, Mesh, Recipe, assemble_chains};
use towermodes::internal::subsystem::{Eigenproblem, SubsystemPencil};
use towermodes::space::{SpatialMatrix, add_scaled, transform_matrix};
use towermodes::{
    AddedMassAt, AddedMassTable, Change, FloatingPlatform, Foundation, Options, RigidBody, Solver,
    Tower, TowerDescription,
};
use towermodes_testing::{changed, with};

const SEGMENTS: usize = 4;

/// Numbers by a linear congruence (Knuth 1998, vol. 2, ch. 3.3.4).
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        let next = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        self.0 = next;
        low + (high - low) * (next >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn platform_of(description: &mut TowerDescription) -> &mut FloatingPlatform {
    match &mut description.foundation {
        Foundation::Floating(platform) => platform,
        other => panic!("{other:?}"),
    }
}

/// The floater with an added mass that couples all motions and has this table beside it.
fn with_table(table: AddedMassTable) -> TowerDescription {
    let mut description = floater();
    platform_of(&mut description).added_mass_by_frequency = Some(Arc::new(table));
    description
}

fn on_segments(modes: usize) -> Options {
    with!(Options, segments = Some(SEGMENTS), modes = modes)
}

/// A positive definite matrix of the size of the floater's added mass that couples all motions.
fn random_matrix(random: &mut Random, size: f64) -> SpatialMatrix {
    let units = [2.8e3, 2.8e3, 5e2, 2e5, 2e5, 1e4];
    let mut matrix = [[0.0; 6]; 6];
    for _ in 0..6 {
        let vector = units.map(|unit| unit * random.between(-1.0, 1.0));
        for i in 0..6 {
            for j in 0..6 {
                matrix[i][j] += size * vector[i] * vector[j];
            }
        }
    }
    matrix
}

/// Rows over the range of all modes, each a little from the one before.
fn random_table(random: &mut Random) -> AddedMassTable {
    let mut matrix = random_matrix(random, 0.5);
    let zero = matrix;
    let mut frequency = 0.0;
    let mut rows = Vec::new();
    while frequency < 3.5 {
        frequency += random.between(0.02, 0.4);
        let sign = random.between(-1.0, 1.0).signum();
        let step = random_matrix(random, 0.02);
        add_scaled(&mut matrix, sign, &step);
        rows.push((frequency, matrix));
    }
    add_scaled(&mut matrix, 1.0, &random_matrix(random, 0.01));
    AddedMassTable {
        zero,
        rows,
        infinite: matrix,
    }
}

/// Stiffness and inertia of the floater without its table, and the table in the coordinates of its
/// base: an independent model of the whole.
struct Dense<'a> {
    stiffness: DMatrix<f64>,
    mass: DMatrix<f64>,
    table: &'a AddedMassTable,
    rise_m: f64,
    units: [f64; 6],
}

impl<'a> Dense<'a> {
    fn of(description: &TowerDescription, table: &'a AddedMassTable) -> Self {
        let tower = Tower::new(description.clone()).expect("a tower");
        let held = tower.with_added_mass_at(f64::INFINITY);
        let mesh = Mesh::new(&held, Borders::Pieces, SEGMENTS);
        let recipe = Recipe {
            element: Element::RmjeExact,
            rotary_inertia: true,
            hinge_position: 0.2,
        };
        let mut chains = Chains::default();
        assemble_chains(&held, &mesh, &recipe, &mut chains);
        let [chain] = chains.members_mut() else {
            panic!("all motions are coupled");
        };
        let problem = Eigenproblem::Vibration { origin: 0.0 };
        let (stiffness, mass) = dense(&mut SubsystemPencil::new(&mut **chain, problem));
        let mut dense = Self {
            stiffness,
            mass,
            table,
            rise_m: -tower.base_m(),
            units: tower.base().units,
        };
        let infinite = dense.on_base(&table.infinite);
        dense.mass -= infinite;
        dense
    }

    /// A matrix about the origin as one of all unknowns, of which the first are those of the base.
    fn on_base(&self, matrix: &SpatialMatrix) -> DMatrix<f64> {
        let mut matrix = *matrix;
        transform_matrix(&mut matrix, self.rise_m);
        let size = self.mass.nrows();
        DMatrix::from_fn(size, size, |i, j| match i < 6 && j < 6 {
            true => matrix[i][j] * self.units[i] * self.units[j],
            false => 0.0,
        })
    }

    /// The added mass at an angular frequency, rad/s, straight from its definition.
    fn added_mass(&self, frequency: f64) -> SpatialMatrix {
        let mut before = (0.0, &self.table.zero);
        for (row, matrix) in &self.table.rows {
            if *row > frequency {
                let share = (frequency - before.0) / (row - before.0);
                let mut sum = [[0.0; 6]; 6];
                add_scaled(&mut sum, 1.0 - share, before.1);
                add_scaled(&mut sum, share, matrix);
                return sum;
            }
            before = (*row, matrix);
        }
        self.table.infinite
    }

    /// The number of negative eigenvalues of K − ω²(M + A(ω)), scaled.
    fn count(&self, hz: f64) -> usize {
        let frequency = hz * TAU;
        let mass = &self.mass + self.on_base(&self.added_mass(frequency));
        let whole = &self.stiffness - mass * (frequency * frequency);
        let scale: Vec<f64> = (0..whole.nrows())
            .map(|i| 1.0 / whole[(i, i)].abs().sqrt())
            .collect();
        let scaled = DMatrix::from_fn(whole.nrows(), whole.nrows(), |i, j| {
            whole[(i, j)] * scale[i] * scale[j]
        });
        let values = SymmetricEigen::new(scaled).eigenvalues;
        values.iter().filter(|value| **value < 0.0).count()
    }
}

/// 1000 random frequencies on 50 random floaters, and both sides of each of their modes.
#[test]
fn counts_of_modes_are_those_of_dense_matrices() {
    let mut random = Random(31);
    let mut solver = Solver::new(on_segments(12));
    let (mut checked, mut complete, mut refused) = (0, 0, 0);
    for case in 0..60 {
        let table = random_table(&mut random);
        let description = with_table(table.clone());
        // The mass of the platform with its added mass may be negative in a random table.
        let Ok(tower) = Tower::new(description.clone()) else {
            refused += 1;
            continue;
        };
        let solution = solver.solve(&tower).expect("modes");
        let dense = Dense::of(&description, &table);
        let modes_hz = all_frequencies(&solution);
        complete += usize::from(solution.certificate.complete);
        for (below, hz) in modes_hz.iter().enumerate() {
            let counts = [1.0 - 1e-8, 1.0 + 1e-8].map(|side| dense.count(hz * side));
            assert_eq!(counts, [below, below + 1], "case {case} at {hz} Hz");
        }
        assert!(modes_hz.is_sorted());
        if !solution.certificate.complete {
            continue;
        }
        for _ in 0..25 {
            let hz = random.between(0.001, solution.certificate.below_hz);
            let listed = modes_hz.iter().filter(|mode| **mode < hz).count();
            assert_eq!(dense.count(hz), listed, "case {case} at {hz} Hz");
            checked += 1;
        }
    }
    assert!(checked >= 1000 && complete >= 40, "{checked}, {complete}");
    assert!(refused <= 10, "{refused}");
}

/// An added mass that falls in heave by `high_kg` between two angular frequencies. What else it has
/// couples all motions.
fn falling(high_kg: f64, [from, to]: [f64; 2]) -> AddedMassTable {
    let low = random_matrix(&mut Random(3), 0.01);
    let mut high = low;
    high[2][2] += high_kg;
    AddedMassTable {
        zero: high,
        rows: vec![(from, high), (to, low)],
        infinite: low,
    }
}

/// Heave with the large added mass is at about 0.8 of its frequency without. If the added mass
/// falls between the two, the stiffness changes its sign three times.
#[test]
fn where_a_mode_appears_again_the_list_is_not_called_complete() {
    let kg = 4e6;
    let heavy = solved(&with_table(falling(kg, [90.0, 91.0])), &on_segments(8));
    let heave_hz = all_frequencies(&heavy)[2];
    let falls = [1.02, 1.1].map(|factor| factor * heave_hz * TAU);
    let table = falling(kg, falls);
    let description = with_table(table.clone());
    let solution = solved(&description, &on_segments(8));
    let certificate = solution.certificate;
    assert!(!certificate.complete);
    let [low, high] = certificate.uncertain_hz.expect("an interval");
    assert!(low * TAU >= falls[0] && low * TAU <= falls[1]);
    // The count of modes falls within the interval; above it heave without the large added mass is
    // a mode again, which is not in the list.
    let dense = Dense::of(&description, &table);
    assert_eq!(dense.count(low), dense.count(falls[1] / TAU) + 1);
    let light = solved(&with_table(falling(0.0, [90.0, 91.0])), &on_segments(8));
    let again_hz = all_frequencies(&light)[2];
    let [below, above] = [0.999, 1.001].map(|factor| dense.count(factor * again_hz));
    assert_eq!(below + 1, above);
    let is_again = |hz: &f64| (hz / again_hz - 1.0).abs() < 1e-3;
    assert!(!all_frequencies(&solution).iter().any(is_again));
    assert!(low < again_hz && again_hz < high);
    assert_eq!(high, certificate.below_hz);
    let warnings: Vec<String> = solution.warnings.iter().map(ToString::to_string).collect();
    let says = |warning: &String| warning.contains("proved complete only outside");
    assert!(warnings.iter().any(says), "{warnings:?}");
}

/// Heave is below roll and pitch with the added mass at low frequencies and above them with that at
/// high ones; on a tower with two planes of symmetry it has nothing of their motions. The modes
/// above, which are solved with the other order, have their own frequencies, names and shapes.
#[test]
fn modes_above_others_whose_order_depends_on_the_added_mass_are_solved() {
    let mut heavy = [[0.0; 6]; 6];
    heavy[2][2] = 3e6;
    let mut description = with_table(AddedMassTable {
        zero: heavy,
        rows: vec![(0.5, heavy), (1.0, [[0.0; 6]; 6])],
        infinite: [[0.0; 6]; 6],
    });
    description.rna = RigidBody::point(350e3, [0.0, 0.0, 2.0]).into();
    platform_of(&mut description).hydrostatic.matrix[2][2] = 4.5e5;
    let at = |added_mass| solved(&description, &with!(Options, modes = 8, added_mass));
    let [low, own, high] = [AddedMassAt::Zero, AddedMassAt::Own, AddedMassAt::Infinite].map(at);
    assert_eq!(low.modes[2].name().to_string(), "heave");
    assert_eq!(high.modes[4].name().to_string(), "heave");
    for (mode, low) in own.modes.iter().zip(&low.modes) {
        assert_eq!(mode.name(), low.name());
        // Modes 1 to 5 are below 0.5 rad/s; the others have no heave.
        let name = low.name().to_string();
        assert_close(mode.frequency_hz, low.frequency_hz, 1e-10, &name);
    }
}

/// Where it falls as fast but no mode is near, two counts prove that none is there.
#[test]
fn a_fall_of_the_added_mass_beside_all_modes_leaves_nothing_uncertain() {
    let kg = 4e6;
    let plain = solved(&with_table(falling(kg, [90.0, 91.0])), &on_segments(8));
    let modes_hz = all_frequencies(&plain);
    let gap = modes_hz
        .windows(2)
        .max_by(|a, b| (a[1] / a[0]).total_cmp(&(b[1] / b[0])));
    let gap = gap.expect("modes");
    let middle = (gap[0] * gap[1]).sqrt() * TAU;
    let table = falling(kg, [middle, 1.001 * middle]);
    let solution = solved(&with_table(table), &on_segments(8));
    assert!(solution.certificate.complete);
    assert_eq!(solution.certificate.uncertain_hz, None);
}

#[test]
fn an_added_mass_that_is_the_same_at_all_frequencies_is_a_constant_one() {
    let mut random = Random(5);
    let matrix = random_matrix(&mut random, 0.5);
    let constant = AddedMassTable {
        zero: matrix,
        rows: vec![(0.1, matrix), (1.0, matrix)],
        infinite: matrix,
    };
    let mut plain = floater();
    add_scaled(&mut platform_of(&mut plain).added_mass.matrix, 1.0, &matrix);
    let expected = solved(&plain, &Options::default());
    let found = solved(&with_table(constant), &Options::default());
    assert_same(
        &all_frequencies(&found),
        &all_frequencies(&expected),
        1e-12,
        "constant",
    );
    assert_eq!(found.added_mass, Some(AddedMassAt::Own));
    assert_eq!(expected.added_mass, None);
}

#[test]
fn frequencies_alone_have_the_bits_of_a_solution() {
    let mut random = Random(8);
    for added_mass in [AddedMassAt::Own, AddedMassAt::Zero, AddedMassAt::Hz(0.3)] {
        let tower = Tower::new(with_table(random_table(&mut random))).expect("a tower");
        let mut solver = Solver::new(with!(Options, added_mass));
        let solution = solver.solve(&tower).expect("modes");
        let frequencies = solver.frequencies(&tower).expect("frequencies");
        assert_eq!(frequencies.certificate, solution.certificate);
        for (mode, alone) in solution.modes.iter().zip(&frequencies.modes) {
            let of_mode = [mode.frequency_hz, mode.extrapolated_hz, mode.error_hz()];
            let of_alone = [alone.frequency_hz, alone.extrapolated_hz, alone.error_hz()];
            assert_eq!(of_mode, of_alone);
            assert_eq!((mode.name(), mode.shares), (alone.name(), alone.shares));
        }
    }
}

/// The derivative counts that the added mass changes with the frequency.
#[test]
fn derivatives_are_differences_of_frequencies() {
    let mut random = Random(13);
    let description = with_table(random_table(&mut random));
    let names = ["foundation.mass", "rna.mass"];
    let changes = Change::parse_all(names, &description).expect("numbers");
    let mut solver = Solver::new(with!(Options, modes = 8));
    let found = solver
        .sensitivities(&description, &changes)
        .expect("derivatives");
    let steps: [fn(&mut TowerDescription, f64); 2] = [
        |d, kg| platform_of(d).mass_kg += kg,
        |d, kg| d.rna.mass_kg += kg,
    ];
    for (of_change, step) in found.changes.iter().zip(steps) {
        let kg = 1e-4 * of_change.value;
        let mut there = |kg: f64| {
            let mut description = description.clone();
            step(&mut description, kg);
            let tower = Tower::new(description).expect("a tower");
            solver.frequencies(&tower).expect("modes").clone()
        };
        let (less, more) = (there(-kg), there(kg));
        for (place, derivative) in of_change.modes.iter().enumerate() {
            let difference = more.modes[place].extrapolated_hz - less.modes[place].extrapolated_hz;
            let slope = difference / (2.0 * kg);
            let own = derivative.as_ref().expect("a derivative").hz_per_unit;
            // Where a mode hardly depends on the mass, rounding is left of the difference.
            let scale = slope
                .abs()
                .max(1e-4 * found.modes[place].frequency_hz / of_change.value);
            assert!(
                (own - slope).abs() < 2e-5 * scale,
                "{place}: {own:e}, {slope:e}"
            );
        }
    }
}

#[test]
fn a_frequency_held_is_that_of_the_mode_itself() {
    let mut random = Random(21);
    let description = with_table(random_table(&mut random));
    let own = solved(&description, &on_segments(8));
    for mode in &own.modes {
        let added_mass = AddedMassAt::Hz(mode.frequency_hz);
        let held = solved(&description, &changed!(on_segments(8), added_mass));
        let case = format!("mode {}", mode.number);
        let there_hz = held.modes[mode.number - 1].frequency_hz;
        assert_close(there_hz, mode.frequency_hz, 1e-11, &case);
    }
}

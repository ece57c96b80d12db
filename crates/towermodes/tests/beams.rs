//! Chains of flexible elements: the O(n) algorithms against dense matrices, the degree, fine
//! meshes, planes that differ.

use crate::pencils;
use crate::towers;

use pencils::{check_counts, check_solve, dense_eigenvalues};
use towermodes::internal::beam::{BeamRecipe, BeamWorkspace, Beams, assemble_beams};
use towermodes::internal::elements::{Borders, Mesh};
use towermodes::internal::subsystem::{Eigenproblem, SubsystemPencil};
use towermodes::tower::{Properties, Section};
use towermodes::{
    Family, Foundation, Method, Options, Planes, SoilRow, SoilStiffness, Tower, TowerDescription,
};
use towermodes_testing::{parts, with};
use towers::{assert_close, elliptic, frequencies, reference, reference_350t, rich, solved};

fn spectral(degree: usize) -> BeamRecipe {
    BeamRecipe::Spectral {
        degree,
        rotary_inertia: true,
        shear: true,
    }
}

fn beams(description: &TowerDescription, segments: usize, recipe: BeamRecipe) -> Beams {
    let tower = Tower::new(description.clone()).expect("a valid tower");
    let mesh = Mesh::new(&tower, Borders::Pieces, segments);
    let (mut beams, mut work) = (Beams::default(), BeamWorkspace::default());
    assemble_beams(&tower, &mesh, recipe, &mut work, &mut beams);
    beams
}

const AT_REST: Eigenproblem = Eigenproblem::Vibration { origin: 0.0 };

#[test]
fn counts_and_solves_equal_those_of_dense_matrices() {
    let mut towers = vec![
        ("reference", reference_350t()),
        ("rich", rich()),
        ("elliptic", elliptic()),
    ];
    // With weights, soil, and a base and a machine that couple everything.
    for (_, tower) in &mut towers.clone() {
        tower.gravity_m_per_s2 = 9.81;
        tower.rna.center_m = [1.2, -0.4, 2.0];
        let soil = |height_m| SoilRow {
            height_m,
            stiffness: SoilStiffness {
                x_n_per_m2: 1e6,
                y_n_per_m2: 2e6,
                z_n_per_m2: 3e6,
                torsion_n: 4e6,
                rotation_x_n: 2e8,
                rotation_y_n: 3e8,
            },
        };
        tower.soil = vec![vec![soil(0.0), soil(30.0)]];
        tower.foundation = Foundation::Springs(parts::springs(1e8, 1e11, 0.0, f64::INFINITY, 1e10));
        towers.push(("tied", tower.clone()));
    }
    for (name, description) in towers {
        for (recipe, segments) in [(BeamRecipe::Bmodes, 12), (spectral(3), 8), (spectral(9), 1)] {
            let mut beams = beams(&description, segments, recipe);
            for (index, beam) in beams.members_mut().iter_mut().enumerate() {
                let case = format!("{name}, {recipe:?}, subsystem {index}");
                let mut pencil = SubsystemPencil::new(&mut **beam, AT_REST);
                check_counts(&mut pencil, 8, &case);
                check_solve(&mut pencil, 1e-8, &case);
            }
        }
    }
}

/// Relative errors of the first three bending modes of the reference tower at a degree, as an
/// Euler-Bernoulli beam.
fn errors_at(degree: usize) -> [f64; 3] {
    let recipe = BeamRecipe::Spectral {
        degree,
        rotary_inertia: false,
        shear: true,
    };
    let mut beams = beams(&reference(), 1, recipe);
    let first = &mut *beams.members_mut()[0];
    let lambdas = dense_eigenvalues(&mut SubsystemPencil::new(first, AT_REST));
    let exact = [0.892169154365, 4.378139643592, 11.400647435166];
    std::array::from_fn(|mode| lambdas[mode].sqrt() / std::f64::consts::TAU / exact[mode] - 1.0)
}

#[test]
fn the_spectral_error_falls_exponentially_with_the_degree() {
    // A Ritz value is never too low, and four degrees more are worth two digits and more until
    // rounding is left: an algebraic order would have to be 9 from 6 to 10 and 11 from 8 to 12.
    for degree in [5, 6, 7, 8, 9] {
        let (coarse, fine) = (errors_at(degree), errors_at(degree + 4));
        for (mode, (coarse, fine)) in coarse.into_iter().zip(fine).enumerate() {
            let case = format!("mode {mode}, degree {degree}: {coarse:e} to {fine:e}");
            assert!(fine > -1e-12, "{case}");
            assert!(fine < 0.01 * coarse || fine < 1e-12, "{case}");
        }
    }
    assert!(errors_at(13).into_iter().all(|error| error < 1e-10));
}

#[test]
fn a_hundred_thousand_elements_of_bmodes_keep_their_digits() {
    let options = with!(Options, method = Method::Bmodes, segments = Some(100_000));
    let got = frequencies(&solved(&reference(), &options), Family::ForeAft);
    // The order is 2, so what is left is 1e-4 of what 1000 elements leave: 1e-10.
    let expected = [0.892169154365, 4.378139643592, 11.400647435166];
    for (got, expected) in got.iter().zip(expected) {
        assert_close(*got, expected, 2e-10, "bmodes");
    }
}

/// The elliptic tower with both planes as one of them is.
fn as_plane(pick: impl Fn(Planes<f64>) -> f64) -> TowerDescription {
    let mut tower = elliptic();
    let both = |planes| Planes::both(pick(planes));
    for row in &mut tower.properties {
        let properties: &mut Properties = &mut row.properties;
        properties.bending_n_m2 = both(properties.bending_n_m2);
        properties.rotary_inertia_kg_m = both(properties.rotary_inertia_kg_m);
        properties.shear_n = properties.shear_n.map(both);
    }
    tower
}

#[test]
fn each_plane_of_a_table_is_solved_as_if_the_other_were_not_there() {
    let (fore_aft, side_side) = (as_plane(|p| p.fore_aft), as_plane(|p| p.side_side));
    for method in Method::ALL {
        let options = with!(Options, method, modes = 9);
        let together = solved(&elliptic(), &options);
        for (alone, family) in [(&fore_aft, Family::ForeAft), (&side_side, Family::SideSide)] {
            let got = frequencies(&together, family);
            let expected = frequencies(&solved(alone, &options), family);
            assert!(got.len() >= 2, "{}", method.name());
            for (got, expected) in got.iter().zip(&expected) {
                assert_close(*got, *expected, 1e-11, method.name());
            }
        }
    }
}

#[test]
fn every_method_has_the_limit_of_a_table_with_two_planes_steps_and_shear() {
    let with = |method, segments| Options {
        method,
        segments,
        modes: 8,
        rotary_inertia: true,
        ..Options::default()
    };
    let truth = solved(&elliptic(), &with(Method::Spectral, None));
    // The published element is of first order in torsion, so 400 segments are not enough.
    let methods = Method::ALL.into_iter();
    let segmented = methods.filter(|m| m.unit() == "segment" && *m != Method::Rmje);
    for method in segmented {
        let got = solved(&elliptic(), &with(method, Some(400)));
        for (got, truth) in got.modes.iter().zip(&truth.modes) {
            assert_eq!((got.family, got.order), (truth.family, truth.order));
            assert_close(got.extrapolated_hz, truth.frequency_hz, 2e-7, method.name());
        }
    }
}

#[test]
fn a_table_of_a_tubes_rows_has_the_tubes_section_at_them() {
    let tube = Tower::new(reference()).expect("a valid tower");
    let table = Tower::new(towers::reference_table(1.0, 0.0)).expect("a valid tower");
    for row in table.properties() {
        let of =
            |tower: &Tower| -> Section { tower.piece_at(row.height_m).section_at(row.height_m) };
        let (tube, table) = (of(&tube), of(&table));
        let close = |a: f64, b: f64| assert_close(a, b, 1e-13, "section");
        close(table.masses.mass_kg_per_m, tube.masses.mass_kg_per_m);
        close(
            table.masses.polar_inertia_kg_m,
            tube.masses.polar_inertia_kg_m,
        );
        close(table.bending_n_m2.fore_aft, tube.bending_n_m2.fore_aft);
        close(table.torsion_n_m2, tube.torsion_n_m2);
        close(table.axial_n, tube.axial_n);
    }
}

#[test]
fn a_cone_that_ends_in_a_point_carries_its_tip_mass_on_a_soft_tip() {
    // Tip of 1 µm: a polynomial over the whole cone cannot follow 1/EI, which grows by 27 powers of
    // ten; elements are cut for it.
    let description = TowerDescription {
        materials: vec![towermodes::Material::from_shear_modulus(
            7850.0, 2.1e11, 8.08e10,
        )],
        stations: vec![
            towermodes::Station::new(0.0, 6.0, 3.0),
            towermodes::Station::new(80.0, 1e-6, 5e-7),
        ],
        rna: towermodes::Rna::point(1.0),
        ..TowerDescription::default()
    };
    let with = |method, segments| with!(Options, method, segments, modes = 4);
    let spectral = solved(&description, &with(Method::Spectral, None));
    let got = frequencies(&spectral, Family::ForeAft);
    // Deflection of a cone's tip by a unit force: 64 L³/(3 π E d₀³ d₁); all the mass that moves is
    // the tip's.
    let compliance = 64.0 * 80.0_f64.powi(3) / (3.0 * std::f64::consts::PI * 2.1e11 * 216.0 * 1e-6);
    assert_close(
        got[0],
        (1.0 / compliance).sqrt() / std::f64::consts::TAU,
        3e-4,
        "static",
    );
    let chain = solved(&description, &with(Method::CardanicExact, Some(4000)));
    for (mode, got) in got.iter().enumerate() {
        let expected = towers::extrapolated(&chain, Family::ForeAft)[mode];
        // The chain's own error here, from 2000 and 4000 segments.
        assert_close(*got, expected, 5e-8, "cardanic-exact");
    }
    assert!(spectral.segments > 10 && spectral.modes[0].error_hz() < 1e-9);
}

#[test]
fn bmodes_sees_every_piece() {
    // A wall that alternates: the elements' middles would see one of the two walls alone.
    let mut description = reference();
    let station = |k: usize| {
        let s = k as f64 / 300.0;
        let wall = if k.is_multiple_of(2) { 0.03 } else { 0.036 };
        towermodes::Station::new(87.6 * s, 6.0 - 2.0 * s, wall)
    };
    description.stations = (0..=300).map(station).collect();
    let with = |segments| with!(Options, method = Method::Bmodes, segments, modes = 2);
    // Every piece has two elements.
    let seen = solved(&description, &with(None));
    assert_eq!((seen.segments, seen.warnings.len()), (600, 0));
    let beam = Options {
        method: Method::Spectral,
        rotary_inertia: false,
        ..with(None)
    };
    let truth = solved(&description, &beam).modes[0].frequency_hz;
    let ratio = seen.modes[0].discretization_error_hz / (seen.modes[0].frequency_hz - truth);
    assert!((0.8..1.25).contains(&ratio), "{ratio}");
    assert_close(seen.modes[0].extrapolated_hz, truth, 1e-5, "extrapolated");
}

#[test]
fn a_table_whose_shear_stiffness_grows_a_millionfold() {
    // What is linear is the stiffness, not the flexibility: cut by the wrong one, elements would
    // never be gradual.
    for reversed in [false, true] {
        let mut description = elliptic();
        let shears = if reversed {
            [1.2e10, 2.6e4]
        } else {
            [2.6e4, 1.2e10]
        };
        let rows = [0, 3].map(|index| description.properties[index]);
        description.properties = rows.to_vec();
        for (row, shear) in description.properties.iter_mut().zip(shears) {
            row.properties.shear_n = Some(Planes::both(shear));
        }
        let with = |method, segments| with!(Options, method, segments, modes = 4);
        let spectral = solved(&description, &with(Method::Spectral, None));
        assert!(spectral.segments < 20, "{}", spectral.segments);
        let chain = solved(&description, &with(Method::RmjeExact, Some(40_000)));
        for (mode, beam) in chain.modes.iter().zip(&spectral.modes) {
            assert_close(mode.extrapolated_hz, beam.frequency_hz, 1e-7, &mode.label());
        }
    }
}

#[test]
fn shapes_and_modal_masses_are_those_of_the_chains() {
    // Three ways from an eigenvector to a shape: bodies at borders, Hermite's cubics, Legendre's
    // polynomials.
    for description in [rich(), elliptic()] {
        let with = |method| Options {
            method,
            segments: (method != Method::Spectral).then_some(400),
            modes: 8,
            ..Options::default()
        };
        let beam = solved(&description, &with(Method::Spectral));
        let chain = solved(&description, &with(Method::CardanicExact));
        for (beam, chain) in beam.modes.iter().zip(&chain.modes) {
            assert_eq!(beam.label(), chain.label());
            assert_close(beam.modal_mass, chain.modal_mass, 2e-4, &beam.label());
            let points = beam.shape.iter().chain(&beam.station_shape);
            for (p, q) in points.zip(chain.shape.iter().chain(&chain.station_shape)) {
                for axis in 0..3 {
                    let moved = (p.translation[axis] - q.translation[axis]).abs();
                    let turned = (p.rotation[axis] - q.rotation[axis]).abs();
                    let case = format!(
                        "{} at {} m: {moved:e}, {turned:e}",
                        beam.label(),
                        p.height_m
                    );
                    assert!(moved < 2e-4 && turned < 2e-4, "{case}");
                }
            }
        }
    }
}

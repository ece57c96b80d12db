//! The O(n) algorithms against dense matrices.

use crate::pencils;
use crate::towers;

use nalgebra::{DMatrix, DVector, SymmetricEigen, Vector3};
use pencils::{check_counts, check_solve, dense_eigenvalues};
use towermodes::internal::chain::Chains;
use towermodes::internal::eigen::Pencil;
use towermodes::internal::elements::{Borders, Element, Mesh, Recipe, assemble_chains};
use towermodes::internal::subsystem::{Eigenproblem, SubsystemPencil};
use towermodes::{
    Foundation, Inertia, Method, Options, PointMass, SoilRow, SoilStiffness, Tower,
    TowerDescription,
};
use towermodes_testing::{parts, with};
use towers::{assert_close, reference, reference_350t, rich, solved};

/// A one-degree joint of the paper: axis, height, sliding or turning, stiffness.
struct Joint {
    axis: Vector3<f64>,
    height: f64,
    slides: bool,
    stiffness: f64,
}

/// A rigid body of the paper: mass, height of its centre, principal inertias, number of joints
/// below it.
struct Body {
    mass: f64,
    centre: f64,
    inertia: Vector3<f64>,
    joints_below: usize,
}

/// The paper's system of 3n bodies and 6n joints, written down from its text, independent of the
/// library's chains.
fn paper_system(segments: usize, tip_kg: f64) -> (Vec<Joint>, Vec<Body>) {
    let (h, e, g, density) = (87.6, 2.1e11, 8.08e10, 8500.0);
    let length = h / segments as f64;
    let (ex, ey, ez) = (Vector3::x(), Vector3::y(), Vector3::z());
    let (mut joints, mut bodies) = (Vec::new(), Vec::new());
    for i in 0..segments {
        let base = i as f64 * length;
        let s = (base + length / 2.0) / h;
        let (d, t) = (6.0 + s * (3.87 - 6.0), 0.027 + s * (0.019 - 0.027));
        let area = std::f64::consts::PI * t * (d - t);
        let moment = std::f64::consts::PI / 64.0 * (d.powi(4) - (d - 2.0 * t).powi(4));
        let mut body = |from: f64, to: f64, joints_below: usize| {
            let l = to - from;
            let mass = density * area * l;
            let across = mass * l * l / 12.0 + density * moment * l;
            bodies.push(Body {
                mass,
                centre: base + (from + to) / 2.0,
                inertia: Vector3::new(across, across, 2.0 * density * moment * l),
                joints_below,
            });
        };
        body(0.0, length / 4.0, 6 * i);
        body(length / 4.0, length / 2.0, 6 * i + 4);
        body(length / 2.0, length, 6 * i + 6);
        let mut joint = |axis, at: f64, slides, stiffness| {
            joints.push(Joint {
                axis,
                height: base + at,
                slides,
                stiffness,
            });
        };
        let lateral = 12.0 * e * moment / length.powi(3);
        joint(ex, length / 4.0, true, lateral);
        joint(ey, length / 4.0, true, lateral);
        joint(ez, length / 4.0, true, e * area / length);
        joint(ez, length / 4.0, false, g * 2.0 * moment / length);
        joint(ex, length / 2.0, false, e * moment / length);
        joint(ey, length / 2.0, false, e * moment / length);
    }
    bodies.push(Body {
        mass: tip_kg,
        centre: h,
        inertia: Vector3::zeros(),
        joints_below: 6 * segments,
    });
    (joints, bodies)
}

/// Equation (15): M = Σ JᵀmJ over the bodies, and from it the eigenvalues of (17), rising.
fn paper_eigenvalues(joints: &[Joint], bodies: &[Body]) -> Vec<f64> {
    let size = joints.len();
    let mut mass: DMatrix<f64> = DMatrix::zeros(size, size);
    for body in bodies {
        let columns: Vec<(Vector3<f64>, Vector3<f64>)> = joints[..body.joints_below]
            .iter()
            .map(|joint| {
                if joint.slides {
                    (joint.axis, Vector3::zeros())
                } else {
                    let arm = Vector3::z() * (body.centre - joint.height);
                    (joint.axis.cross(&arm), joint.axis)
                }
            })
            .collect();
        for (a, (va, wa)) in columns.iter().enumerate() {
            for (b, (vb, wb)) in columns.iter().enumerate() {
                mass[(a, b)] += body.mass * va.dot(vb) + wa.dot(&body.inertia.component_mul(wb));
            }
        }
    }
    let root = DVector::from_iterator(size, joints.iter().map(|j| 1.0 / j.stiffness.sqrt()));
    let scaled = DMatrix::from_fn(size, size, |a, b| root[a] * mass[(a, b)] * root[b]);
    rising(
        SymmetricEigen::new(scaled)
            .eigenvalues
            .iter()
            .map(|theta| 1.0 / theta),
    )
}

fn rising(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}

#[test]
fn equation_15_as_a_dense_matrix_gives_the_same_eigenvalues() {
    for (description, tip_kg) in [(reference(), 0.0), (reference_350t(), 350e3)] {
        let (joints, bodies) = paper_system(20, tip_kg);
        let dense = paper_eigenvalues(&joints, &bodies);
        let options = Options {
            method: Method::Rmje,
            segments: Some(20),
            modes: 24,
            ..Options::default()
        };
        let solution = solved(&description, &options);
        assert_eq!(solution.degrees_of_freedom, dense.len());
        for (mode, lambda) in solution.modes.iter().zip(dense) {
            let omega = std::f64::consts::TAU * mode.frequency_hz;
            // A dense solver is exact to ε λ_max/λ here: 1e-10 is what it can promise for these
            // modes.
            assert_close(omega * omega, lambda, 1e-10, &mode.label());
        }
    }
}

fn chains(description: &TowerDescription, segments: usize, element: Element) -> Chains {
    let tower = Tower::new(description.clone()).expect("a valid tower");
    let mesh = Mesh::new(&tower, Borders::Pieces, segments);
    let mut chains = Chains::default();
    let recipe = with!(Recipe, element);
    assemble_chains(&tower, &mesh, &recipe, &mut chains);
    chains
}

const AT_REST: Eigenproblem = Eigenproblem::Vibration { origin: 0.0 };

#[test]
fn inertia_counts_equal_dense_eigenvalue_counts() {
    for (name, description) in [("reference", reference()), ("rich", rich())] {
        for element in Element::ALL {
            let mut chains = chains(&description, 20, element);
            for (index, chain) in chains.members_mut().iter_mut().enumerate() {
                let case = format!("{name}, {element:?}, subsystem {index}");
                check_counts(&mut SubsystemPencil::new(&mut **chain, AT_REST), 30, &case);
            }
        }
    }
}

/// Soil, water, wires, weights, springs under the base and a machine beside the axis, in one plane,
/// in both, or in all directions.
fn grounded() -> Vec<(&'static str, TowerDescription)> {
    let base = TowerDescription {
        foundation: Foundation::Springs(parts::springs(2e8, 5e10, -1e9, 1e10, 2e10)),
        soil: vec![vec![soil(10.0, 3e7, 2e7), soil(30.0, 0.0, 1e6)]],
        water: Some(parts::water(55.0, Some(30.0), 1025.0, 1.0, true)),
        wires: vec![parts::wires(90.0, 4, 3e6, 40.0)],
        gravity_m_per_s2: 9.81,
        ..rich()
    };
    let with_centre = |x: f64, y: f64| {
        let mut tower = base.clone();
        tower.rna.center_m = [x, y, 2.1];
        tower
    };
    vec![
        ("centred", with_centre(0.0, 0.0)),
        ("beside the axis", with_centre(-1.5, 0.0)),
        ("beside both planes", with_centre(-1.5, 0.8)),
    ]
}

fn soil(height_m: f64, x_n_per_m2: f64, y_n_per_m2: f64) -> SoilRow {
    SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2,
            y_n_per_m2,
            z_n_per_m2: 1e6,
            torsion_n: 1e7,
            rotation_x_n: 5e8,
            rotation_y_n: 7e8,
        },
    }
}

#[test]
fn counts_and_solves_hold_with_all_that_ties_a_tower_to_the_ground() {
    for (name, description) in grounded() {
        for element in Element::ALL {
            let mut chains = chains(&description, 14, element);
            for (index, chain) in chains.members_mut().iter_mut().enumerate() {
                let case = format!("{name}, {element:?}, subsystem {index}");
                check_counts(&mut SubsystemPencil::new(&mut **chain, AT_REST), 20, &case);
                for origin in [-10.0, -1000.0, 0.0] {
                    let problem = Eigenproblem::Vibration { origin };
                    check_solve(
                        &mut SubsystemPencil::new(&mut **chain, problem),
                        1e-8,
                        &case,
                    );
                }
            }
        }
    }
}

#[test]
fn buckling_counts_equal_dense_eigenvalue_counts() {
    for (name, description) in grounded() {
        let mut chains = chains(&description, 10, Element::RmjeExact);
        let case = format!("{name}, buckling");
        let first = &mut *chains.members_mut()[0];
        let mut pencil = SubsystemPencil::new(first, Eigenproblem::Buckling);
        check_counts(&mut pencil, 10, &case);
    }
}

#[test]
fn a_six_component_chain_has_the_spectra_of_its_decoupled_ones() {
    // A tower whose motions are all coupled, but by springs too weak to be seen.
    let description = grounded().remove(0).1;
    let mut coupled = description.clone();
    coupled.point_masses.push(PointMass {
        height_m: 95.0,
        mass_kg: 0.0,
        inertia_kg_m2: Inertia {
            xx: 1e-3,
            yy: 1e-3,
            zz: 1e-3,
            xy: 1e-4,
            xz: 1e-4,
            yz: 1e-4,
        },
    });
    coupled.rna.center_m[0] = 1e-9;
    let (mut one, mut four) = (
        chains(&coupled, 12, Element::RmjeExact),
        chains(&description, 12, Element::RmjeExact),
    );
    assert_eq!((one.members().len(), four.members().len()), (1, 4));
    let mut union: Vec<f64> = Vec::new();
    for chain in four.members_mut() {
        let mut pencil = SubsystemPencil::new(&mut **chain, AT_REST);
        union.extend(dense_eigenvalues(&mut pencil));
    }
    let union = rising(union.into_iter());
    let only = &mut *one.members_mut()[0];
    let all = dense_eigenvalues(&mut SubsystemPencil::new(only, AT_REST));
    for (got, expected) in all.iter().zip(&union).take(30) {
        assert_close(*got, *expected, 1e-8, "coupled");
    }
}

#[test]
fn a_pencil_gives_the_same_answers_whatever_was_asked_before() {
    let mut chains = chains(&reference(), 10, Element::RmjeExact);
    let mut pencil = SubsystemPencil::new(&mut *chains.members_mut()[0], AT_REST);
    let x: Vec<f64> = (0..pencil.size()).map(|i| (i as f64).cos()).collect();
    let (mut first, mut second) = (x.clone(), x.clone());
    pencil.mass_times(&x, &mut first);
    pencil.count_below(50.0);
    pencil.stiffness_times(&x, &mut second);
    pencil.mass_times(&x, &mut second);
    assert_eq!(first, second);
}

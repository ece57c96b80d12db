//! The O(n) algorithms against dense matrices.

mod towers;

use nalgebra::{DMatrix, DVector, SymmetricEigen, Vector3};
use towermodes::chain::{
    Chain, ChainPencil, ChainWorkspace, DecoupledChains, Dim, JointFlexibility, RigidBody, Space,
    count_below, factorize, mass_times, solve as articulated_solve, stiffness_times,
};
use towermodes::eigen::Pencil;
use towermodes::elements::{Borders, Element, Mesh, Recipe, assemble};
use towermodes::{Method, Options, Planes, Tower, TowerDescription};
use towers::{assert_close, reference, reference_350t, rich, solved};

/// A one-degree joint of the paper: axis, height, sliding or turning, stiffness.
struct Joint {
    axis: Vector3<f64>,
    height: f64,
    slides: bool,
    stiffness: f64,
}

/// A rigid body of the paper: mass, height of its centre, principal inertias, number of joints below it.
struct Body {
    mass: f64,
    centre: f64,
    inertia: Vector3<f64>,
    joints_below: usize,
}

/// The paper's system of 3n bodies and 6n joints, written down from its text, independent of the library's chains.
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
            // A dense solver is exact to ε λ_max/λ here: 1e-10 is what it can promise for these modes.
            assert_close(omega * omega, lambda, 1e-10, &mode.label());
        }
    }
}

fn chains(description: &TowerDescription, segments: usize, element: Element) -> DecoupledChains {
    let tower = Tower::new(description.clone()).expect("a valid tower");
    let mesh = Mesh::new(&tower, Borders::Pieces, segments);
    let mut chains = DecoupledChains::default();
    let recipe = Recipe {
        element,
        ..Recipe::default()
    };
    assemble(&tower, &mesh, &recipe, &mut chains);
    chains
}

/// A matrix from a product, column by column.
fn dense_of(size: usize, mut times: impl FnMut(&[f64], &mut [f64])) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(size, size);
    let mut unit = vec![0.0; size];
    for column in 0..size {
        unit[column] = 1.0;
        times(&unit, matrix.column_mut(column).as_mut_slice());
        unit[column] = 0.0;
    }
    matrix
}

fn dense_pencil<const D: usize>(chain: &Chain<D>) -> (DMatrix<f64>, DMatrix<f64>)
where
    Dim<D>: Space,
{
    let size = chain.degrees_of_freedom();
    let mut loads = Vec::new();
    let mass = dense_of(size, |x, y| mass_times(chain, &mut loads, x, y));
    let stiffness = dense_of(size, |x, y| stiffness_times(chain, &mut loads, x, y));
    (stiffness, mass)
}

/// λ of K u = λ M u for K positive definite, rising.
fn dense_eigenvalues((stiffness, mass): &(DMatrix<f64>, DMatrix<f64>)) -> Vec<f64> {
    let root = stiffness.clone().cholesky().expect("positive definite").l();
    let half = root.solve_lower_triangular(mass).expect("regular");
    let scaled = root
        .solve_lower_triangular(&half.transpose())
        .expect("regular");
    let symmetric = 0.5 * (&scaled + scaled.transpose());
    rising(
        SymmetricEigen::new(symmetric)
            .eigenvalues
            .iter()
            .map(|theta| 1.0 / theta),
    )
}

/// Shifts all over the spectrum: between neighbours, close to each side of each, below all and above all.
fn shifts(eigenvalues: &[f64]) -> Vec<(f64, usize)> {
    let mut shifts = vec![(-1.0, 0), (0.0, 0), (eigenvalues[0] * 0.5, 0)];
    // Above 1e6 λ₁ the dense eigenvalues have lost the digits that a near shift needs.
    let trusted = eigenvalues
        .iter()
        .take_while(|&&value| value < 1e6 * eigenvalues[0]);
    for (index, &value) in trusted.enumerate() {
        shifts.push((value * (1.0 - 1e-7), index));
        shifts.push((value * (1.0 + 1e-7), index + 1));
        if let Some(next) = eigenvalues.get(index + 1) {
            shifts.push(((value * next).sqrt(), index + 1));
        }
    }
    shifts
}

fn check_counts<const D: usize>(chain: &Chain<D>, case: &str)
where
    Dim<D>: Space,
{
    let eigenvalues = dense_eigenvalues(&dense_pencil(chain));
    let shifts = shifts(&eigenvalues);
    assert!(shifts.len() > 30, "{case}: too few shifts to mean anything");
    for (shift, count) in shifts {
        assert_eq!(count_below(chain, shift), count, "{case} at {shift:e}");
        assert_eq!(
            factorize(chain, shift, &mut Vec::new()),
            count,
            "{case} at {shift:e}"
        );
    }
}

#[test]
fn inertia_counts_equal_dense_eigenvalue_counts() {
    for (name, description) in [("reference", reference()), ("rich", rich())] {
        for element in Element::ALL {
            let chains = chains(&description, 20, element);
            check_counts(&chains.fore_aft, &format!("{name} bending"));
            check_counts(&chains.torsion, &format!("{name} torsion"));
            check_counts(&chains.axial, &format!("{name} axial"));
        }
    }
}

#[test]
fn inertia_counts_hold_with_springs_to_ground() {
    let mut chain = chains(&reference(), 20, Element::RmjeExact).fore_aft;
    // At the tip: a lateral spring and a negative rotational one, as gravity makes.
    chain.add_ground_stiffness(87.6, [[1e5, 0.0], [0.0, -1e6]]);
    check_counts(&chain, "springs");
}

fn check_solve<const D: usize>(chain: &Chain<D>, shift: f64)
where
    Dim<D>: Space,
{
    let (stiffness, mass) = dense_pencil(chain);
    let size = chain.degrees_of_freedom();
    let exact = DVector::from_fn(size, |i, _| 1.0 + (i as f64).sin());
    let mut x: Vec<f64> = ((stiffness - shift * mass) * &exact)
        .iter()
        .copied()
        .collect();
    let mut factors = Vec::new();
    factorize(chain, shift, &mut factors);
    articulated_solve(chain, &factors, &mut x);
    for (x, exact) in x.iter().zip(&exact) {
        assert!(
            (x - exact).abs() < 1e-7,
            "{x} instead of {exact} at shift {shift}"
        );
    }
}

#[test]
fn articulated_solve_inverts_the_shifted_matrix() {
    for element in Element::ALL {
        let mut chains = chains(&rich(), 16, element);
        for shift in [-10.0, 0.0, 3.0, 500.0] {
            check_solve(&chains.fore_aft, shift);
            check_solve(&chains.torsion, shift);
        }
        chains
            .fore_aft
            .add_ground_stiffness(110.0, [[3e5, 1e5], [1e5, 2e6]]);
        for shift in [-10.0, 0.0, 3.0] {
            check_solve(&chains.fore_aft, shift);
        }
    }
}

/// The reference tower as one coupled chain of 6×6 blocks with lumped bodies, beside its decoupled chains.
#[test]
fn a_six_component_chain_has_the_spectra_of_its_decoupled_ones() {
    let (mut coupled, mut decoupled) = (Chain::<6>::default(), DecoupledChains::default());
    decoupled.restart(false, 12);
    for k in 0..12 {
        let s = f64::from(k);
        let flexibility = JointFlexibility {
            deflection_m_per_n: Planes {
                fore_aft: 1e-9 * (1.0 + 0.1 * s),
                side_side: 1.3e-9,
            },
            bending_per_n_m: Planes {
                fore_aft: 2e-11 * (1.0 + 0.2 * s),
                side_side: 3e-11 * (1.0 + 0.1 * s),
            },
            axial_m_per_n: 5e-11,
            torsion_per_n_m: 3e-11 * (1.0 + 0.3 * s),
        };
        coupled.add_joint(7.0 * s + 3.0, flexibility.spatial());
        decoupled.add_joint(7.0 * s + 3.0, &flexibility);
        let body = RigidBody {
            mass_kg: 2e4,
            first_moment_kg_m: 3e3,
            inertia_xx_kg_m2: 9e4 + 1e3 * s,
            inertia_yy_kg_m2: 8e4,
            inertia_zz_kg_m2: 1e5,
        };
        coupled.add_body(7.0 * s + 5.0, body.spatial());
        decoupled.add_body(7.0 * s + 5.0, &body);
    }
    let union = dense_eigenvalues(&dense_pencil(&decoupled.fore_aft))
        .into_iter()
        .chain(dense_eigenvalues(&dense_pencil(&decoupled.side_side)))
        .chain(dense_eigenvalues(&dense_pencil(&decoupled.torsion)))
        .chain(dense_eigenvalues(&dense_pencil(&decoupled.axial)));
    let union = rising(union);
    for (got, expected) in dense_eigenvalues(&dense_pencil(&coupled))
        .iter()
        .zip(&union)
    {
        assert_close(*got, *expected, 1e-8, "coupled");
    }
    for pair in union[..40].windows(2) {
        let (shift, sum) = ((pair[0] * pair[1]).sqrt(), |shift| {
            count_below(&decoupled.fore_aft, shift)
                + count_below(&decoupled.side_side, shift)
                + count_below(&decoupled.torsion, shift)
                + count_below(&decoupled.axial, shift)
        });
        assert_eq!(count_below(&coupled, shift), sum(shift), "at {shift}");
    }
    check_solve(&coupled, 100.0);
}

#[test]
fn a_pencil_gives_the_same_answers_whatever_was_asked_before() {
    let chain = chains(&reference(), 10, Element::RmjeExact).fore_aft;
    let mut work = ChainWorkspace::default();
    let mut pencil = ChainPencil::new(&chain, &mut work);
    let x: Vec<f64> = (0..pencil.size()).map(|i| (i as f64).cos()).collect();
    let (mut first, mut second) = (x.clone(), x.clone());
    pencil.mass_times(&x, &mut first);
    pencil.count_below(50.0);
    pencil.stiffness_times(&x, &mut second);
    pencil.mass_times(&x, &mut second);
    assert_eq!(first, second);
}

//! Frames against an independent assembly: Lagrange polynomials of displacements and rotations in
//! each member, constraints between the ends of members, and dense matrices.
//!
//! A member is divided where its water begins and ends. Its inner points are eliminated at each
//! frequency, with the count of their negative pivots, so that a count of the whole needs a small
//! matrix. Nothing of the program is called but the description of the frame.

use std::f64::consts::{PI, TAU};

use towermodes::frame::*;
use towermodes::internal::frame::FrameBelow;
use towermodes::{Material, RigidBody, Tower};
use towermodes_random::{Lattice, Seed, random_frame, tower_on};

type Matrix = Vec<Vec<f64>>;

/// Frames on nearly free hinges are drawn again: a dense matrix has too few digits for them.
const SLOWEST_HZ: f64 = 0.2;

fn zeros(rows: usize, columns: usize) -> Matrix {
    vec![vec![0.0; columns]; rows]
}

/// Gauss points of Legendre polynomials, by Newton's method.
fn gauss(n: usize) -> Vec<(f64, f64)> {
    let legendre = |x: f64| {
        let (mut before, mut p) = (1.0, x);
        for k in 1..n {
            let k = k as f64;
            (before, p) = (p, ((2.0 * k + 1.0) * x * p - k * before) / (k + 1.0));
        }
        (p, n as f64 * (x * p - before) / (x * x - 1.0))
    };
    let point = |k: usize| {
        let mut x = (PI * (k as f64 + 0.75) / (n as f64 + 0.5)).cos();
        for _ in 0..50 {
            let (p, slope) = legendre(x);
            x -= p / slope;
        }
        let (_, slope) = legendre(x);
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(point).collect()
}

/// The Lagrange polynomials of these nodes and their slopes at x.
fn lagrange(nodes: &[f64], x: f64) -> Vec<[f64; 2]> {
    let n = nodes.len();
    let value = |k: usize| {
        let factor = |j: usize| (x - nodes[j]) / (nodes[k] - nodes[j]);
        let others = |k: usize| (0..n).filter(move |j| *j != k);
        let product: f64 = others(k).map(factor).product();
        let slope: f64 = others(k)
            .map(|i| {
                let rest: f64 = others(k).filter(|j| *j != i).map(factor).product();
                rest / (nodes[k] - nodes[i])
            })
            .sum();
        [product, slope]
    };
    (0..n).map(value).collect()
}

/// K and M of a stretch of a member for the motions of its points, the ends first.
struct Stretch {
    ends: [usize; 2],
    stiffness: Matrix,
    inertia: Matrix,
}

/// A frame for counts.
struct Dense {
    stretches: Vec<Stretch>,
    /// Matrices for the motions of two points, or one of them twice.
    bodies: Vec<(Vec<usize>, Matrix, Matrix)>,
    /// The motions of all points for the free ones: six rows for each point.
    free: Matrix,
}

/// The properties of a tube at a point of it: EA, EI, GJ, κGA, and ρA, ρI, water across.
fn tube_at(member: &FrameMember, at: f64) -> ([f64; 4], [f64; 3]) {
    let MemberKind::Beam {
        ends: SectionEnds::Tube([from, to]),
        material,
    } = &member.kind
    else {
        panic!("a tube");
    };
    let Material {
        youngs_modulus_pa: e,
        shear_modulus_pa: g,
        density_kg_per_m3: rho,
        ..
    } = *material;
    let blend = |a: f64, b: f64| a + at * (b - a);
    let d = blend(from.outer_diameter_m, to.outer_diameter_m);
    let inner = d - 2.0 * blend(from.wall_thickness_m, to.wall_thickness_m);
    let area = PI / 4.0 * (d * d - inner * inner);
    let second = PI / 64.0 * (d.powi(4) - inner.powi(4));
    let nu = e / (2.0 * g) - 1.0;
    let q = (inner / d).powi(2);
    let s = (1.0 + q).powi(2);
    let kappa = 6.0 * (1.0 + nu).powi(2) * s
        / (s * (7.0 + 14.0 * nu + 8.0 * nu * nu) + 4.0 * q * (5.0 + 10.0 * nu + 4.0 * nu * nu));
    let (mut mass, mut rotary, mut water) = (rho * area, rho * second, 0.0);
    for coat in member
        .coats
        .iter()
        .filter(|c| c.range[0] <= at && at <= c.range[1])
    {
        let s = (at - coat.range[0]) / (coat.range[1] - coat.range[0]);
        let of = |[a, b]: [f64; 2]| a + s * (b - a);
        match coat.kind {
            CoatKind::AddedMass {
                density_kg_per_m3,
                radius_m,
                across,
                ..
            } => water += density_kg_per_m3 * PI * of(radius_m).powi(2) * of(across),
            CoatKind::Solid {
                density_kg_per_m3,
                outer_radius_m,
                inner_radius_m,
            } => {
                let (outer, inner) = (of(outer_radius_m), of(inner_radius_m));
                mass += of(density_kg_per_m3) * PI * (outer * outer - inner * inner);
                rotary += of(density_kg_per_m3) * PI / 4.0 * (outer.powi(4) - inner.powi(4));
            }
        }
    }
    (
        [e * area, e * second, 2.0 * g * second, kappa * g * area],
        [mass, rotary, water],
    )
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| b[i] - a[i])
}

fn length(a: [f64; 3]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Three axes as rows, the third along a vector.
fn axes(along: [f64; 3]) -> [[f64; 3]; 3] {
    let z = along.map(|a| a / length(along));
    let other = if z[2].abs() < 0.8 {
        [0.0, 0.0, 1.0]
    } else {
        [1.0, 0.0, 0.0]
    };
    let y = cross(z, other);
    let y = y.map(|a| a / length(y));
    [cross(y, z), y, z]
}

impl Dense {
    fn new(frame: &FrameDescription, degree: usize) -> Self {
        let at = |joint: usize| frame.joints[joint].position_m;
        // Points: the joints, then two ends of each member, then what is between.
        let joints = frame.joints.len();
        let mut points = joints + 2 * frame.members.len();
        let end = |member: usize, side: usize| joints + 2 * member + side;
        let mut dense = Self {
            stretches: Vec::new(),
            bodies: Vec::new(),
            free: Vec::new(),
        };
        for (index, member) in frame.members.iter().enumerate() {
            let along = difference(at(member.joints[0]), at(member.joints[1]));
            match &member.kind {
                MemberKind::Beam { .. } => {
                    let mut cuts = vec![0.0, 1.0];
                    cuts.extend(member.coats.iter().flat_map(|coat| coat.range));
                    cuts.sort_by(f64::total_cmp);
                    cuts.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
                    let mut near = end(index, 0);
                    for (k, cut) in cuts.windows(2).enumerate() {
                        let far = if k + 2 == cuts.len() {
                            end(index, 1)
                        } else {
                            points
                        };
                        points += usize::from(k + 2 < cuts.len());
                        let made = stretch(member, along, [cut[0], cut[1]], [near, far], degree);
                        dense.stretches.push(made);
                        near = far;
                    }
                }
                MemberKind::Cable {
                    axial_n,
                    mass_kg_per_m,
                    pretension_n,
                } => {
                    let l = length(along);
                    let l0 = l / (1.0 + pretension_n / axial_n);
                    let (mass, z) = (mass_kg_per_m * l0, along.map(|a| a / l));
                    let of = |across: f64, own: f64, i: usize, j: usize| {
                        across * f64::from(u8::from(i == j)) + (own - across) * z[i] * z[j]
                    };
                    let (mut k, mut m) = (zeros(12, 12), zeros(12, 12));
                    for i in 0..3 {
                        for j in 0..3 {
                            let spring = of(pretension_n / l, axial_n / l0, i, j);
                            let own = of(13.0 / 35.0 * mass, mass / 3.0, i, j);
                            let other = of(9.0 / 70.0 * mass, mass / 6.0, i, j);
                            for (a, b) in [(0, 0), (6, 6)] {
                                k[a + i][b + j] = spring;
                                m[a + i][b + j] = own;
                            }
                            for (a, b) in [(0, 6), (6, 0)] {
                                k[a + i][b + j] = -spring;
                                m[a + i][b + j] = other;
                            }
                        }
                    }
                    dense
                        .bodies
                        .push((vec![end(index, 0), end(index, 1)], k, m));
                }
                MemberKind::Rigid { mass_kg_per_m } => {
                    // The program gives a rigid link the inertia of a cable.
                    let (l, z) = (length(along), along.map(|a| a / length(along)));
                    let mass = mass_kg_per_m * l;
                    let mut m = zeros(12, 12);
                    for i in 0..3 {
                        for j in 0..3 {
                            let unit = f64::from(u8::from(i == j));
                            let of = |across: f64, own: f64| {
                                mass * (across * unit + (own - across) * z[i] * z[j])
                            };
                            let (own, other) =
                                (of(13.0 / 35.0, 1.0 / 3.0), of(9.0 / 70.0, 1.0 / 6.0));
                            (m[i][j], m[6 + i][6 + j]) = (own, own);
                            (m[i][6 + j], m[6 + i][j]) = (other, other);
                        }
                    }
                    dense
                        .bodies
                        .push((vec![end(index, 0), end(index, 1)], zeros(12, 12), m));
                }
                MemberKind::Spring(_) => panic!("not made"),
            }
        }
        for support in &frame.supports {
            let rows = |matrix: &[[f64; 6]; 6]| matrix.iter().map(|row| row.to_vec()).collect();
            let (k, m) = (rows(&support.stiffness), rows(&support.inertia));
            dense.bodies.push((vec![support.joint], k, m));
        }
        for (joint, body) in &frame.masses {
            dense
                .bodies
                .push((vec![*joint], zeros(6, 6), body_inertia(body)));
        }
        let constraints = constraints(frame, points, &mut dense, end);
        dense.free = null_space(constraints, 6 * points);
        dense
    }

    /// Eigenvalues below a frequency, Hz.
    fn count(&self, hz: f64) -> usize {
        let lambda = (TAU * hz).powi(2);
        let size = self.free[0].len();
        let (mut sum, mut count) = (zeros(size, size), 0);
        for stretch in &self.stretches {
            let mut a = shifted(&stretch.stiffness, &stretch.inertia, lambda);
            count += eliminate(&mut a, 12);
            self.add(&stretch.ends, &a, &mut sum);
        }
        for (points, k, m) in &self.bodies {
            self.add(points, &shifted(k, m, lambda), &mut sum);
        }
        count + eliminate(&mut sum, 0)
    }

    /// sum += Fᵀ A F for the rows F of some points; A symmetric with its lower triangle.
    fn add(&self, points: &[usize], a: &Matrix, sum: &mut Matrix) {
        let rows: Vec<&Vec<f64>> = points
            .iter()
            .flat_map(|point| &self.free[6 * point..6 * point + 6])
            .collect();
        let n = rows.len();
        let used: Vec<usize> = (0..sum.len())
            .filter(|c| rows.iter().any(|row| row[*c] != 0.0))
            .collect();
        for (i, row) in rows.iter().enumerate() {
            let mut forces = vec![0.0; used.len()];
            for (j, other) in rows.iter().enumerate().take(n) {
                let entry = a[i.max(j)][i.min(j)];
                for (force, c) in forces.iter_mut().zip(&used) {
                    *force += entry * other[*c];
                }
            }
            for c in used.iter().filter(|c| row[**c] != 0.0) {
                for (force, d) in forces.iter().zip(&used) {
                    sum[*c][*d] += row[*c] * force;
                }
            }
        }
    }
}

fn shifted(k: &Matrix, m: &Matrix, lambda: f64) -> Matrix {
    let row = |(k, m): (&Vec<f64>, &Vec<f64>)| {
        let entries = k.iter().zip(m);
        entries.map(|(k, m)| k - lambda * m).collect()
    };
    k.iter().zip(m).map(row).collect()
}

/// Eliminates the rows from `first` on by the lower triangle; returns the negative pivots.
fn eliminate(a: &mut Matrix, first: usize) -> usize {
    let mut negative = 0;
    for last in (first..a.len()).rev() {
        let row = a[last].clone();
        negative += usize::from(row[last] < 0.0);
        for (i, out) in a.iter_mut().enumerate().take(last) {
            let factor = row[i] / row[last];
            out[..=i]
                .iter_mut()
                .zip(&row)
                .for_each(|(o, r)| *o -= factor * r);
        }
        a[last].fill(0.0);
    }
    negative
}

/// A stretch of a tube: the translations and rotations of each of its points are unknowns.
fn stretch(
    member: &FrameMember,
    along: [f64; 3],
    [from, to]: [f64; 2],
    ends: [usize; 2],
    degree: usize,
) -> Stretch {
    let axes = axes(along);
    let l = length(along) * (to - from);
    // Chebyshev points, the ends first.
    let mut nodes = vec![-1.0, 1.0];
    nodes.extend((1..degree).map(|k| -(PI * k as f64 / degree as f64).cos()));
    let size = 6 * nodes.len();
    let (mut k, mut m) = (zeros(size, size), zeros(size, size));
    for (xi, weight) in gauss(degree + 4) {
        let shapes = lagrange(&nodes, xi);
        let s = from + (to - from) * 0.5 * (1.0 + xi);
        let ([ea, ei, gj, kga], [mass, rotary, water]) = tube_at(member, s);
        let weight = 0.5 * l * weight;
        // Strains and motions in the axes of the member, as rows for all unknowns.
        let row = |parts: &[(usize, bool, f64)]| {
            let mut row = vec![0.0; size];
            for (node, [value, slope]) in shapes.iter().enumerate() {
                for (component, is_slope, sign) in parts {
                    let shape = if *is_slope { slope * 2.0 / l } else { *value };
                    let (group, axis) = (component / 3 * 3, axes[component % 3]);
                    for (i, a) in axis.iter().enumerate() {
                        row[6 * node + group + i] += sign * shape * a;
                    }
                }
            }
            row
        };
        let strains = [
            (kga, row(&[(0, true, 1.0), (4, false, -1.0)])),
            (kga, row(&[(1, true, 1.0), (3, false, 1.0)])),
            (ea, row(&[(2, true, 1.0)])),
            (ei, row(&[(3, true, 1.0)])),
            (ei, row(&[(4, true, 1.0)])),
            (gj, row(&[(5, true, 1.0)])),
        ];
        let masses = [
            mass + water,
            mass + water,
            mass,
            rotary,
            rotary,
            2.0 * rotary,
        ];
        for (factor, row) in &strains {
            add_square(weight * factor, row, &mut k);
        }
        for (component, factor) in masses.iter().enumerate() {
            add_square(weight * factor, &row(&[(component, false, 1.0)]), &mut m);
        }
    }
    Stretch {
        ends,
        stiffness: k,
        inertia: m,
    }
}

fn add_square(factor: f64, row: &[f64], sum: &mut Matrix) {
    for (out, a) in sum.iter_mut().zip(row) {
        out.iter_mut()
            .zip(row)
            .for_each(|(o, b)| *o += factor * a * b);
    }
}

fn body_inertia(body: &RigidBody) -> Matrix {
    // The centre moves by v + θ × c.
    let [x, y, z] = body.center_m;
    let center = [
        [1.0, 0.0, 0.0, 0.0, z, -y],
        [0.0, 1.0, 0.0, -z, 0.0, x],
        [0.0, 0.0, 1.0, y, -x, 0.0],
    ];
    let own = body.inertia_kg_m2.tensor();
    let entry = |i: usize, j: usize| {
        let moved: f64 = center.iter().map(|row| row[i] * row[j]).sum();
        let turned = if i > 2 && j > 2 {
            own[i - 3][j - 3]
        } else {
            0.0
        };
        body.mass_kg * moved + turned
    };
    (0..6)
        .map(|i| (0..6).map(|j| entry(i, j)).collect())
        .collect()
}

/// What holds points together or to the ground, as rows that are zero; adds the springs of hinges.
fn constraints(
    frame: &FrameDescription,
    points: usize,
    dense: &mut Dense,
    end: impl Fn(usize, usize) -> usize,
) -> Matrix {
    let mut rows: Matrix = Vec::new();
    let mut tie = |entries: &[(usize, f64)]| {
        let mut row = vec![0.0; 6 * points];
        entries.iter().for_each(|(at, factor)| row[*at] += factor);
        rows.push(row);
    };
    for (index, joint) in frame.joints.iter().enumerate() {
        let here: Vec<usize> = frame
            .members
            .iter()
            .enumerate()
            .filter_map(|(m, member)| {
                let side = (0..2).find(|side| member.joints[*side] == index);
                side.map(|side| end(m, side))
            })
            .collect();
        for (place, point) in here.iter().enumerate() {
            let same = |k: usize| [(6 * point + k, 1.0), (6 * index + k, -1.0)];
            (0..3).for_each(|k| tie(&same(k)));
            let (free, stiffness): (Vec<[f64; 3]>, f64) = match joint.kind {
                JointKind::Cantilever => (Vec::new(), 0.0),
                JointKind::Ball {
                    stiffness_n_m_per_rad,
                } => (
                    vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
                    stiffness_n_m_per_rad,
                ),
                JointKind::Pin {
                    axis,
                    stiffness_n_m_per_rad,
                } => (vec![axis.map(|a| a / length(axis))], stiffness_n_m_per_rad),
                JointKind::Universal { .. } => panic!("not made"),
            };
            // The joint rotates with its first member.
            if place == 0 || free.is_empty() {
                (3..6).for_each(|k| tie(&same(k)));
            } else if let [axis] = free[..] {
                let [x, y, _] = axes(axis);
                for across in [x, y] {
                    let entry =
                        |(k, a): (usize, &f64)| [(6 * point + 3 + k, *a), (6 * index + 3 + k, -a)];
                    let entries: Vec<_> = across.iter().enumerate().flat_map(entry).collect();
                    tie(&entries);
                }
            }
            for other in &here[..place] {
                let mut k = zeros(12, 12);
                for axis in &free {
                    let mut row = vec![0.0; 12];
                    for i in 0..3 {
                        (row[3 + i], row[9 + i]) = (axis[i], -axis[i]);
                    }
                    add_square(stiffness, &row, &mut k);
                }
                dense.bodies.push((vec![*other, *point], k, zeros(12, 12)));
            }
        }
    }
    for (index, member) in frame.members.iter().enumerate() {
        if !matches!(member.kind, MemberKind::Rigid { .. }) {
            continue;
        }
        let [near, far] = [end(index, 0), end(index, 1)].map(|point| 6 * point);
        let at = |joint: usize| frame.joints[joint].position_m;
        let [x, y, z] = difference(at(member.joints[0]), at(member.joints[1]));
        tie(&[(far, 1.0), (near, -1.0), (near + 4, -z), (near + 5, y)]);
        tie(&[
            (far + 1, 1.0),
            (near + 1, -1.0),
            (near + 3, z),
            (near + 5, -x),
        ]);
        tie(&[
            (far + 2, 1.0),
            (near + 2, -1.0),
            (near + 3, -y),
            (near + 4, x),
        ]);
        (3..6).for_each(|k| tie(&[(far + k, 1.0), (near + k, -1.0)]));
    }
    for support in &frame.supports {
        for (k, is_fixed) in support.fixed.iter().enumerate() {
            if *is_fixed {
                tie(&[(6 * support.joint + k, 1.0)]);
            }
        }
    }
    rows
}

/// A basis of the vectors that satisfy all rows: a row for each entry of the vectors.
fn null_space(mut rows: Matrix, size: usize) -> Matrix {
    let (mut pivots, mut done) = (Vec::new(), 0);
    while done < rows.len() {
        let (mut row, mut column, mut most) = (done, 0, 1e-9);
        for (i, candidate) in rows.iter().enumerate().skip(done) {
            for (j, entry) in candidate.iter().enumerate() {
                if entry.abs() > most {
                    (row, column, most) = (i, j, entry.abs());
                }
            }
        }
        if most <= 1e-9 {
            break;
        }
        rows.swap(done, row);
        let own: Vec<f64> = rows[done].iter().map(|x| x / rows[done][column]).collect();
        for (i, other) in rows.iter_mut().enumerate() {
            let factor = other[column];
            if i != done && factor != 0.0 {
                other
                    .iter_mut()
                    .zip(&own)
                    .for_each(|(x, r)| *x -= factor * r);
            }
        }
        rows[done] = own;
        pivots.push(column);
        done += 1;
    }
    let free: Vec<usize> = (0..size).filter(|c| !pivots.contains(c)).collect();
    let mut basis = zeros(size, free.len());
    for (k, column) in free.iter().enumerate() {
        basis[*column][k] = 1.0;
        for (row, pivot) in rows.iter().zip(&pivots) {
            basis[*pivot][k] = -row[*column];
        }
    }
    basis
}

/// Cables hold no rotations: each joint has another member, and the end of a cable is welded.
fn is_usable(frame: &FrameDescription) -> bool {
    let is_cable = |member: &FrameMember| matches!(member.kind, MemberKind::Cable { .. });
    (0..frame.joints.len()).all(|joint| {
        let here = frame.members.iter().filter(|m| m.joints.contains(&joint));
        let (cables, others): (Vec<_>, Vec<_>) = here.partition(|member| is_cable(member));
        let is_welded = frame.joints[joint].kind == JointKind::Cantilever;
        !others.is_empty() && (cables.is_empty() || is_welded)
    })
}

#[test]
fn random_frames_have_the_frequencies_of_an_independent_assembly() {
    let mut seed = Seed::new(15);
    let mut solved = 0;
    while solved < 200 {
        let description = random_frame(&mut seed);
        if !is_usable(&description) {
            continue;
        }
        let Ok(frame) = Frame::new(description.clone()) else {
            continue;
        };
        let options = FrameOptions {
            modes: 4,
            ..FrameOptions::default()
        };
        let found = match solve_frame(&frame, &options) {
            // A rigid link between the feet, which both hold, or nothing but rigid links.
            Err(FrameSolveError::RigidBetweenSupports { .. } | FrameSolveError::Modes { .. }) => {
                continue;
            }
            found => found.unwrap_or_else(|error| panic!("{error}: {description:?}")),
        };
        if found.modes[0].frequency_hz < SLOWEST_HZ {
            continue;
        }
        solved += 1;
        let dense = Dense::new(&description, 12);
        for (k, mode) in found.modes.iter().enumerate().take(3) {
            // The dense stiffness of short stretches, 1e10 of a mode's, rounds its λ by about
            // 1e-6 rad²/s².
            let hz = mode.frequency_hz;
            let digits = 1e-9 + 3e-6 / (TAU * hz).powi(2);
            let below = dense.count(hz * (1.0 - digits));
            let above = dense.count(hz * (1.0 + digits));
            assert!(
                below <= k && above > k,
                "frame {solved}, mode {k}, {mode:?}: {below}, {above} of {description:?}"
            );
        }
    }
}

/// A tower stands on a jacket as a rigid body with the inertia of both.
#[test]
fn a_jacket_has_the_counts_of_dense_matrices_at_random_frequencies() {
    let lattice = Lattice {
        bays: 2,
        ..Lattice::jacket()
    };
    let mut description = lattice.description();
    let tower: Tower = tower_on(description.clone(), RigidBody::default());
    let nothing = [[0.0; 6]; 6];
    let foundation = tower.frame().expect("a frame");
    let [_, _, base_m] = foundation.reference_m();
    let mut below = FrameBelow::new(foundation, (base_m, 0.0), &nothing, 10).expect("equations");
    let body = RigidBody {
        mass_kg: 6e5,
        center_m: [0.0, 0.0, 40.0],
        inertia_kg_m2: towermodes::Inertia::from_tensor([
            [3e8, 0.0, 0.0],
            [0.0, 3e8, 0.0],
            [0.0, 0.0, 4e7],
        ]),
    };
    let inertia = body_inertia(&body);
    // The same in the dense model: a joint at the reference point, rigid links to the legs.
    let transition = description.transition.take().expect("a transition piece");
    let top = description.joints.len();
    description
        .joints
        .push(FrameJoint::new("top", transition.position_m));
    for joint in transition.joints {
        let rigid = MemberKind::Rigid { mass_kg_per_m: 0.0 };
        description
            .members
            .push(FrameMember::new("rigid", [top, joint], rigid));
    }
    description.masses.push((top, body));
    let dense = Dense::new(&description, 8);
    let mut seed = Seed::new(7);
    let mut seen = 0;
    for _ in 0..1000 {
        let hz = seed.log_between(0.1, 9.0);
        let lambda = (TAU * hz).powi(2);
        let reduced = below.seen_from_base(-lambda);
        let mut sum: Matrix = (0..6)
            .map(|i| {
                (0..6)
                    .map(|j| reduced.stiffness[i][j] - lambda * inertia[i][j])
                    .collect()
            })
            .collect();
        let count = reduced.count + eliminate(&mut sum, 0);
        if count != dense.count(hz) {
            // Within the digits of the dense matrices beside an eigenvalue.
            let (low, high) = (
                dense.count(hz * (1.0 - 1e-6)),
                dense.count(hz * (1.0 + 1e-6)),
            );
            assert!(
                low <= count && count <= high && low < high,
                "{hz} Hz: {count}"
            );
        }
        seen = seen.max(count);
    }
    assert!(seen > 20, "{seen}");
}

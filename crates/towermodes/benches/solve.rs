//! How long a tower takes: `cargo bench -p towermodes`.
//!
//! The tower is loaded; what is timed is all that `solve` does: assembly, eigenvalues, certificate, shapes, error estimates.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use towermodes::chain::Chains;
use towermodes::eigen::{EigenWorkspace, lowest};
use towermodes::elements::{Borders, Mesh, Recipe, assemble};
use towermodes::parts::{Parts, Problem};
use towermodes::{
    FloatingPlatform, Foundation, FoundationSprings, Inertia, Material, Method, Options,
    ReferredMatrix, Rna, Station, Tower, TowerDescription, Workspace, solve_with,
};

fn tower(rna_kg: f64) -> Tower {
    Tower::new(description(rna_kg)).expect("a valid tower")
}

fn description(rna_kg: f64) -> TowerDescription {
    TowerDescription {
        materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
        stations: vec![
            Station::new(0.0, 6.0, 0.027),
            Station::new(87.6, 3.87, 0.019),
        ],
        rna: Rna::point(rna_kg),
        ..TowerDescription::default()
    }
}

/// The same with an eccentric machine, on springs, with weights: coupled chains.
fn real_tower() -> TowerDescription {
    TowerDescription {
        rna: Rna {
            mass_kg: 350e3,
            center_m: [-0.41, 0.3, 1.97],
            inertia_kg_m2: Inertia {
                xx: 4.37e7,
                yy: 2.353e7,
                zz: 2.542e7,
                xz: 1.169e6,
                ..Inertia::default()
            },
        },
        foundation: Foundation::Springs(FoundationSprings {
            lateral_n_per_m: 2e9,
            rocking_n_m: 1e11,
            coupling_n: 0.0,
            vertical_n_per_m: 1e10,
            torsion_n_m: 1e11,
        }),
        gravity_m_per_s2: 9.81,
        ..description(0.0)
    }
}

/// A spar that carries the same tower.
fn floating_tower() -> TowerDescription {
    let diagonal = |values: [f64; 6]| ReferredMatrix {
        matrix: std::array::from_fn(|i| {
            std::array::from_fn(|j| if i == j { values[i] } else { 0.0 })
        }),
        height_m: 0.0,
    };
    let inertia = Inertia {
        xx: 4e9,
        yy: 4e9,
        zz: 1.6e8,
        ..Inertia::default()
    };
    TowerDescription {
        foundation: Foundation::Floating(Box::new(FloatingPlatform {
            mass_kg: 7.5e6,
            center_m: [0.0, 0.0, -90.0],
            inertia_kg_m2: inertia,
            added_mass: diagonal([8e6, 8e6, 2.4e5, 3.8e10, 3.8e10, 0.0]),
            hydrostatic: diagonal([0.0, 0.0, 3.3e5, -5.0e9, -5.0e9, 0.0]),
            mooring: diagonal([4.1e4, 4.1e4, 1.2e4, 3.1e8, 3.1e8, 1.1e8]),
        })),
        ..real_tower()
    }
}

fn chains(tower: &Tower, segments: usize) -> Parts<Chains> {
    let mut parts = Parts::default();
    let mesh = Mesh::new(tower, Borders::Pieces, segments);
    assemble(tower, &mesh, &Recipe::default(), &mut parts);
    parts
}

const AT_REST: Problem = Problem::Vibration { origin: 0.0 };

/// Towers whose motions are all coupled, 8 modes, by the default method.
fn coupled(c: &mut Criterion) {
    let mut group = c.benchmark_group("coupled, 8 modes");
    for (name, description) in [("held", real_tower()), ("floating", floating_tower())] {
        let tower = Tower::new(description).expect("a valid tower");
        for segments in [100, 100_000] {
            if segments > 1000 {
                group
                    .sample_size(10)
                    .measurement_time(Duration::from_secs(3));
            }
            let options = Options {
                segments: Some(segments),
                ..Options::default()
            };
            let mut workspace = Workspace::default();
            group.bench_function(BenchmarkId::new(name, segments), |b| {
                b.iter(|| solve_with(black_box(&tower), &options, &mut workspace));
            });
        }
    }
    group.finish();
}

/// 8 modes of the tower with 350 t on top: everything a user gets.
fn whole_solve(c: &mut Criterion) {
    let mut group = c.benchmark_group("solve, 8 modes");
    let tower = tower(350e3);
    for method in Method::ALL {
        let segments: &[usize] = match method {
            // One element, whatever degree it needs for 1e-10, then more than it needs.
            Method::Spectral => &[1, 10, 100, 1000],
            _ => &[20, 50, 60, 100, 200, 400, 10_000, 1_000_000],
        };
        for &segments in segments {
            if segments > 1000 {
                group
                    .sample_size(10)
                    .measurement_time(Duration::from_secs(3));
            }
            let options = Options {
                method,
                segments: Some(segments),
                ..Options::default()
            };
            let mut workspace = Workspace::default();
            group.bench_function(BenchmarkId::new(method.name(), segments), |b| {
                b.iter(|| solve_with(black_box(&tower), &options, &mut workspace));
            });
        }
    }
    group.finish();
}

/// One bending plane alone: chain built, 4 modes with certificate.
fn bending_plane(c: &mut Criterion) {
    let mut group = c.benchmark_group("bending plane, 4 modes");
    let tower = tower(350e3);
    for segments in [60, 100] {
        let (mut chains, mut eigen) = (chains(&tower, segments), EigenWorkspace::default());
        group.bench_function(BenchmarkId::from_parameter(segments), |b| {
            b.iter(|| {
                let part = black_box(&mut chains).part_mut(0);
                part.with_pencil(AT_REST, |pencil| lowest(pencil, 4, &mut eigen))
            });
        });
    }
    group.finish();
}

/// The pieces: assembly, product, inertia count.
fn pieces(c: &mut Criterion) {
    let mut group = c.benchmark_group("pieces, 100 segments");
    let tower = tower(350e3);
    let mut chains = chains(&tower, 100);
    let mesh = Mesh::new(&tower, Borders::Pieces, 100);
    chains.part_mut(0).with_pencil(AT_REST, |pencil| {
        let (x, mut y) = (vec![1.0; pencil.size()], vec![0.0; pencil.size()]);
        group.bench_function("product", |b| {
            b.iter(|| pencil.mass_times(black_box(&x), &mut y));
        });
        group.bench_function("count", |b| {
            b.iter(|| pencil.count_below(black_box(400.0)));
        });
    });
    group.bench_function("assembly", |b| {
        b.iter(|| {
            assemble(black_box(&tower), &mesh, &Recipe::default(), &mut chains);
        });
    });
    group.finish();
}

criterion_group!(benches, whole_solve, coupled, bending_plane, pieces);
criterion_main!(benches);

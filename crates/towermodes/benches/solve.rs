//! How long a tower takes: `cargo bench -p towermodes`.
//!
//! The tower is loaded; what is timed is all that `solve` does: assembly, eigenvalues, certificate, shapes, error estimates.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use towermodes::chain::{ChainPencil, ChainWorkspace, DecoupledChains, count_below, mass_times};
use towermodes::eigen::{EigenWorkspace, lowest};
use towermodes::elements::{Borders, Mesh, Recipe, assemble};
use towermodes::{
    Material, Method, Options, Rna, Station, Tower, TowerDescription, Workspace, solve_with,
};

fn tower(rna_kg: f64) -> Tower {
    Tower::new(TowerDescription {
        materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
        stations: vec![
            Station::new(0.0, 6.0, 0.027),
            Station::new(87.6, 3.87, 0.019),
        ],
        rna: Rna::point(rna_kg),
        ..TowerDescription::default()
    })
    .expect("a valid tower")
}

fn chains(tower: &Tower, segments: usize) -> DecoupledChains {
    let mut chains = DecoupledChains::default();
    let mesh = Mesh::new(tower, Borders::Pieces, segments);
    assemble(tower, &mesh, &Recipe::default(), &mut chains);
    chains
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
        let chains = chains(&tower, segments);
        let (mut work, mut eigen) = (ChainWorkspace::default(), EigenWorkspace::default());
        group.bench_function(BenchmarkId::from_parameter(segments), |b| {
            b.iter(|| {
                let mut pencil = ChainPencil::new(black_box(&chains.fore_aft), &mut work);
                lowest(&mut pencil, 4, &mut eigen)
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
    let size = chains.fore_aft.degrees_of_freedom();
    let (x, mut y, mut loads) = (vec![1.0; size], vec![0.0; size], Vec::new());
    group.bench_function("product", |b| {
        b.iter(|| mass_times(&chains.fore_aft, &mut loads, black_box(&x), &mut y));
    });
    group.bench_function("count", |b| {
        b.iter(|| count_below(&chains.fore_aft, black_box(400.0)));
    });
    group.bench_function("assembly", |b| {
        b.iter(|| {
            assemble(black_box(&tower), &mesh, &Recipe::default(), &mut chains);
        });
    });
    group.finish();
}

criterion_group!(benches, whole_solve, bending_plane, pieces);
criterion_main!(benches);

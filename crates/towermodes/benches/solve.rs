//! How long a tower takes: `cargo bench -p towermodes`.
//!
//! The tower is loaded; what is timed is all that `solve` does: assembly, eigenvalues, certificate,
//! shapes, error estimates.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use towermodes::internal::chain::Chains;
use towermodes::internal::eigen::{EigenWorkspace, Pencil, lowest};
use towermodes::internal::elements::{Borders, Mesh, Recipe, assemble_chains};
use towermodes::internal::subsystem::{Eigenproblem, SubsystemPencil};
use towermodes::turbine::{Turbine, TurbineMesh, TurbineModel, TurbineModes};
use towermodes::{Change, Method, Options, Rna, Solver, Tower, TowerDescription};
use towermodes_verify::towers::{
    floater, monopile, nrel_tower, nrel_turbine, reference, reference_350t, reference_eccentric,
    reference_on_springs,
};

fn tower(rna_kg: f64) -> Tower {
    Tower::new(TowerDescription {
        rna: Rna::point(rna_kg),
        ..reference()
    })
    .expect("a valid tower")
}

/// A tower with its machine turned out of the planes, so that all motions are coupled.
fn turned(mut tower: TowerDescription) -> TowerDescription {
    tower.rna.center_m[1] = 0.3;
    tower.gravity_m_per_s2 = 9.81;
    tower
}

fn chains(tower: &Tower, segments: usize) -> Chains {
    let mut chains = Chains::default();
    let mesh = Mesh::new(tower, Borders::Pieces, segments);
    assemble_chains(tower, &mesh, &Recipe::default(), &mut chains);
    chains
}

const AT_REST: Eigenproblem = Eigenproblem::Vibration { origin: 0.0 };

/// Towers whose motions are all coupled, 8 modes, by the default method.
fn coupled(c: &mut Criterion) {
    let mut group = c.benchmark_group("coupled, 8 modes");
    for (name, description) in [
        ("held", turned(reference_on_springs())),
        ("floating", turned(floater())),
    ] {
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
            let mut solver = Solver::new(options);
            group.bench_function(BenchmarkId::new(name, segments), |b| {
                b.iter(|| solver.solve(black_box(&tower)));
            });
        }
    }
    group.finish();
}

/// A sweep: 4 or 2 modes on 20 segments of towers that differ in their numbers, each made from its
/// description. The time is that of one tower.
fn many_towers(c: &mut Criterion) {
    for modes in [4, 2] {
        many_towers_with(modes, c);
    }
}

fn many_towers_with(modes: usize, c: &mut Criterion) {
    let mut group = c.benchmark_group(format!("frequencies of many towers, {modes} modes"));
    let heavy = |description| TowerDescription {
        gravity_m_per_s2: 9.81,
        ..description
    };
    for (name, base) in [
        ("clamped, RNA on the axis", reference_350t()),
        ("clamped, RNA beside the axis", reference_eccentric()),
        ("on springs, with gravity", heavy(reference_on_springs())),
        ("floating", floater()),
        ("monopile", monopile()),
    ] {
        let options = Options {
            modes,
            segments: Some(20),
            ..Options::default()
        };
        let (mut solver, mut number) = (Solver::new(options), 0_u32);
        group.bench_function(name, |b| {
            b.iter(|| {
                number = (number + 1) % 1000;
                let mut description = base.clone();
                description.rna.mass_kg *= 0.9 + 2e-4 * f64::from(number);
                let tower = Tower::new(description).expect("a valid tower");
                let frequencies = solver.frequencies(&tower);
                frequencies.map(|frequencies| frequencies.modes[0].extrapolated_hz)
            });
        });
    }
    group.finish();
}

/// The derivatives of 8 modes with respect to all numbers, beside the solve of the same tower.
fn all_sensitivities(c: &mut Criterion) {
    let mut group = c.benchmark_group("sensitivities, 8 modes");
    for (name, description) in [
        ("monopile", monopile()),
        ("floating", floater()),
        ("clamped, RNA on the axis", reference_350t()),
    ] {
        let tower = Tower::new(description.clone()).expect("a valid tower");
        let changes = Change::every(&description);
        let mut solver = Solver::default();
        for segments in [100, 400] {
            solver.options.segments = Some(segments);
            group.bench_function(BenchmarkId::new(format!("{name}, solve"), segments), |b| {
                b.iter(|| solver.solve(black_box(&tower)));
            });
            group.bench_function(
                BenchmarkId::new(format!("{name}, all numbers"), segments),
                |b| {
                    b.iter(|| solver.sensitivities(black_box(&description), &changes));
                },
            );
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
            let mut solver = Solver::new(options);
            group.bench_function(BenchmarkId::new(method.name(), segments), |b| {
                b.iter(|| solver.solve(black_box(&tower)));
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
                let first = &mut *black_box(&mut chains).members_mut()[0];
                lowest(&mut SubsystemPencil::new(first, AT_REST), 4, &mut eigen)
            });
        });
    }
    group.finish();
}

/// The pieces: assembly, product, eigenvalue count.
fn pieces(c: &mut Criterion) {
    let mut group = c.benchmark_group("pieces, 100 segments");
    let tower = tower(350e3);
    let mut chains = chains(&tower, 100);
    let mesh = Mesh::new(&tower, Borders::Pieces, 100);
    let mut pencil = SubsystemPencil::new(&mut *chains.members_mut()[0], AT_REST);
    let (x, mut y) = (vec![1.0; pencil.size()], vec![0.0; pencil.size()]);
    group.bench_function("product", |b| {
        b.iter(|| pencil.mass_times(black_box(&x), &mut y));
    });
    group.bench_function("count", |b| {
        b.iter(|| pencil.count_below(black_box(400.0)));
    });
    group.bench_function("assembly", |b| {
        b.iter(|| {
            assemble_chains(black_box(&tower), &mesh, &Recipe::default(), &mut chains);
        });
    });
    group.finish();
}

/// The NREL 5 MW turbine at 30 speeds, 20 modes each with names and shapes, certified; and with
/// blades of two and four times as many elements.
fn turning(c: &mut Criterion) {
    let mut group = c.benchmark_group("turning turbine, 30 speeds");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(5));
    for times in [1, 2, 4] {
        let mut machine = nrel_turbine(true, f64::INFINITY);
        let spans: Vec<f64> = machine.blade.sections.iter().map(|s| s.span).collect();
        let parts = spans.windows(2).flat_map(|pair| {
            let step = (pair[1] - pair[0]) / f64::from(times);
            (0..times).map(move |k| pair[0] + f64::from(k) * step)
        });
        machine.blade.borders = parts.chain([1.0]).collect();
        let turbine = Turbine::new(nrel_tower(), machine).expect("a turbine");
        let mesh = TurbineMesh::default();
        group.bench_function(BenchmarkId::new("blade elements", 48 * times), |b| {
            b.iter(|| {
                let mut model = TurbineModel::new(black_box(&turbine), &mesh).expect("a model");
                let mut all: Vec<TurbineModes> = Vec::new();
                for k in 0..30 {
                    let speed = 0.5 * f64::from(k);
                    all.push(model.modes_from(7.3, speed, &all).expect("modes"));
                }
                assert!(all.iter().all(|at| at.is_complete));
                assert!(all.iter().all(|at| at.modes.len() >= 20));
            });
        });
    }
    group.finish();
}

criterion_group!(
    benches,
    turning,
    whole_solve,
    many_towers,
    all_sensitivities,
    coupled,
    bending_plane,
    pieces
);
criterion_main!(benches);

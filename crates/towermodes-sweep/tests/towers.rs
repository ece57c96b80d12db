//! Towers and sweeps for tests.

use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use towermodes::{Change, Inertia, ModeName, Rna, TowerDescription};
use towermodes_files::{SweepModes, SweepResults, TowerInput, read_tower};
use towermodes_sweep::{Base, Columns, Results, Sweep, run};
use towermodes_testing::{changed, rotor, tube, with};

/// The reference tower with a rotor-nacelle assembly of 350 t that turns about the tower's axis
/// with an inertia, kg m².
pub(crate) fn tower(inertia_kg_m2: f64) -> TowerDescription {
    let inertia_kg_m2 = Inertia {
        zz: inertia_kg_m2,
        xx: inertia_kg_m2,
        yy: inertia_kg_m2,
        ..Inertia::default()
    };
    TowerDescription {
        rna: changed!(Rna::point(350e3), inertia_kg_m2),
        rotor: Some(rotor(3, 6.9, 12.1)),
        ..tube(&[(0.0, 6.0, 0.027), (40.0, 5.0, 0.023), (87.6, 3.87, 0.019)])
    }
}

pub(crate) fn names(texts: &[&str]) -> Vec<ModeName> {
    let name = |text: &&str| text.parse().expect("the name of a mode");
    texts.iter().map(name).collect()
}

pub(crate) fn sweep(base: Base, changes: &[&str], results: &SweepResults) -> Sweep {
    let changes = Change::parse_all(changes.iter().copied(), &base.description);
    Sweep::new(base, changes.expect("changes"), results).expect("a sweep")
}

/// A sweep of [`tower`] with the lowest modes.
pub(crate) fn lowest(changes: &[&str], modes: usize) -> Sweep {
    let results = with!(SweepResults, modes = SweepModes::Lowest(modes));
    sweep(Base::from(tower(4e7)), changes, &results)
}

pub(crate) fn solved(sweep: &Sweep, columns: &[&[f64]], threads: usize) -> Results {
    let columns = Columns::new(columns.to_vec()).expect("equal lengths");
    run(sweep, &columns, threads, &mut |_| ControlFlow::Continue(())).expect("results")
}

/// A tower of `examples/`.
pub(crate) fn example(name: &str) -> TowerInput {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../examples")
        .join(name);
    read_tower(&path).expect("a tower").input
}

/// A new empty folder, removed at the end of the test.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn new() -> Self {
        static NUMBER: AtomicU64 = AtomicU64::new(0);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let name = format!("towermodes-sweep-{}-{number}", std::process::id());
        let path = std::env::temp_dir().join(name);
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

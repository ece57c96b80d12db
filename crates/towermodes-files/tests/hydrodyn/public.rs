//! Public models, if they are at hand: `TOWERMODES_PEER_DATA` is the folder of `offshore`.
//!
//! The digits are those of an independent program with the same files, and of the summary that
//! HydroDyn wrote.

use std::path::{Path, PathBuf};

use towermodes::RigidBody;
use towermodes_files::{
    HydrodynInput, SiblingFiles, Source, WaterDefaults, read_hydrodyn, read_water,
};

const MONOPILE: &str = "fast8/5MW_Baseline/NRELOffshrBsline5MW_OC3Monopile_HydroDyn.dat";
const TRIPOD: &str = "fast8/5MW_Baseline/NRELOffshrBsline5MW_OC3Tripod_HydroDyn.dat";
const JACKET: &str = "fast8/5MW_Baseline/NRELOffshrBsline5MW_OC4Jacket_HydroDyn.dat";
const HYWIND: &str = "fast8/5MW_Baseline/NRELOffshrBsline5MW_OC3Hywind_HydroDyn.dat";
const SEMI: &str = "fast8/5MW_Baseline/NRELOffshrBsline5MW_OC4DeepCwindSemi_HydroDyn.dat";
const IEA15: &str = "iea15-monopile/OpenFAST/IEA-15-240-RWT-Monopile/IEA-15-240-RWT-Monopile";
const VOLTURNUS: &str =
    "iea15-volturnus/OpenFAST/IEA-15-240-RWT-UMaineSemi/IEA-15-240-RWT-UMaineSemi";

/// Standard gravity, and that of the IEA turbines.
const STANDARD: f64 = 9.80665;
const IEA: f64 = 9.81;

fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("TOWERMODES_PEER_DATA");
    if folder.is_none() {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
    }
    folder.map(|folder| PathBuf::from(folder).join("offshore"))
}

fn source(path: &Path) -> Source {
    Source::from_path(path).unwrap_or_else(|error| panic!("{error}"))
}

fn read_with(path: &Path, water: WaterDefaults) -> HydrodynInput {
    let input = read_hydrodyn(source(path), &SiblingFiles::of(path), "", water);
    input.unwrap_or_else(|error| panic!("{error}"))
}

fn read(path: &Path) -> HydrodynInput {
    read_with(path, WaterDefaults::default())
}

/// A model of OpenFAST 4, whose water is in the `.fst` file.
fn read_new(folder: &Path, model: &str) -> HydrodynInput {
    let path = |ending: &str| folder.join(format!("{model}{ending}"));
    let of_fst = read_water(&source(&path(".fst")), WaterDefaults::default()).expect("water");
    let water = read_water(&source(&path("_SeaState.dat")), of_fst).expect("water");
    assert_eq!(water, of_fst, "SeaState has only `default`");
    read_with(&path("_HydroDyn.dat"), water)
}

fn assert_close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found / expected - 1.0).abs();
    assert!(
        error <= tolerance,
        "{what}: {found:.6}, expected {expected:.6}"
    );
}

#[test]
fn masses_of_water_and_growth_are_those_of_an_independent_program() {
    let Some(folder) = folder() else { return };
    let added = |file: &str| read(&folder.join(file)).strip_added_mass();
    assert_close("monopile", added(MONOPILE)[0][0], 580754.818, 1e-8);
    // By pieces of one metre there.
    assert_close("tripod", added(TRIPOD)[0][0], 1717417.02, 1e-4);
    let jacket = read(&folder.join(JACKET));
    assert_close(
        "jacket, surge",
        jacket.strip_added_mass()[0][0],
        621729.78,
        1e-6,
    );
    assert_close(
        "jacket, heave",
        jacket.strip_added_mass()[2][2],
        125853.79,
        1e-6,
    );
    assert_close("jacket, growth", jacket.growth().mass_kg, 181733.85, 1e-7);
    // The volume of 164.247 m³ in HydroDyn's summary is that of the members without their ends.
    let on_ends: f64 = jacket.ends.iter().map(|end| end.growth_kg).sum();
    let on_members_m3 = (jacket.growth().mass_kg - on_ends) / 1100.0;
    assert_close("jacket, summary", on_members_m3, 164.247, 5e-6);
    assert_close(
        "jacket, water inside",
        jacket.filling().mass_kg,
        204563.34,
        1e-6,
    );
    let iea15 = read_new(&folder, IEA15);
    assert_close("IEA-15", iea15.strip_added_mass()[0][0], 2415099.35, 1e-6);
    assert_close(
        "IEA-15, water inside",
        iea15.filling().mass_kg,
        2361933.61,
        1e-6,
    );
}

#[test]
fn platforms_have_the_statics_of_an_independent_program() {
    let Some(folder) = folder() else { return };
    // Buoyancy, N.
    let cases = [
        (read(&folder.join(HYWIND)), STANDARD, 80708143.553),
        (read(&folder.join(SEMI)), STANDARD, 139891126.751),
        (read_new(&folder, VOLTURNUS), IEA, 203179889.676),
    ];
    for (input, gravity_m_per_s2, buoyancy_n) in cases {
        let platform = input.platform(&RigidBody::default(), gravity_m_per_s2);
        let file = input.files().next().unwrap_or_default().to_owned();
        assert_close(&file, platform.load[2], buoyancy_n, 1e-8);
    }
}

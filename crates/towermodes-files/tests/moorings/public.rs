//! Public and synthetic files, if they are at hand: `TOWERMODES_PEER_DATA` is the folder of
//! `offshore`. The digits are those of an independent program with the same files.

use std::path::PathBuf;

use towermodes_files::{MooringInput, MooringSite, Source, read_map, read_moordyn};
use towermodes_testing::{Close, numbers, rows};

use super::texts::{HYWIND, SITE, assert_digits, state};

const BASELINE: &str = "fast8/5MW_Baseline/NRELOffshrBsline5MW_";
const VOLTURNUS: &str =
    "iea15-volturnus/OpenFAST/IEA-15-240-RWT-UMaineSemi/IEA-15-240-RWT-UMaineSemi_MoorDyn.dat";

fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("TOWERMODES_PEER_DATA");
    if folder.is_none() {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
    }
    folder.map(|folder| PathBuf::from(folder).join("offshore"))
}

fn source(file: &str) -> Option<Source> {
    let path = folder()?.join(file);
    Some(Source::from_path(&path).unwrap_or_else(|error| panic!("{error}")))
}

fn read(source: Source, site: &MooringSite) -> MooringInput {
    read_moordyn(source, site).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn floaters_have_the_stiffness_of_an_independent_program() {
    let digits = [
        (
            format!("{BASELINE}OC3Hywind_MoorDyn.dat"),
            320.0,
            9.80665,
            HYWIND,
        ),
        (
            format!("{BASELINE}OC4DeepCwindSemi_MoorDyn.dat"),
            200.0,
            9.80665,
            "70835.83548 70835.41626 19140.43426 87240788.03 87240567.32 116970120.8 -107230.7990 -1893316.382",
        ),
        (
            VOLTURNUS.to_owned(),
            200.0,
            9.81,
            "71915.73107 71916.75223 60763.32521 258678724.7 258679715.7 252379082.3 1145110.669 -6084518.313",
        ),
    ];
    for (file, depth_m, gravity, digits) in digits {
        let Some(source) = source(&file) else { return };
        let site = MooringSite {
            depth_m: Some(depth_m),
            gravity_m_per_s2: Some(gravity),
            ..SITE
        };
        let input = read(source, &site);
        assert_digits(&state(Ok(input)), digits, 6e-10);
    }
}

#[test]
fn anchors_tell_the_depth_of_files_without_it() {
    for (file, depth_m) in [("OC3Hywind", 320.0), ("OC4DeepCwindSemi", 200.0)] {
        let Some(source) = source(&format!("{BASELINE}{file}_MoorDyn.dat")) else {
            return;
        };
        let input = read(source, &MooringSite::default());
        assert_eq!(input.description.depth_m, depth_m);
        let notes: Vec<String> = input.notes.iter().map(ToString::to_string).collect();
        assert!(
            notes
                .iter()
                .any(|note| note.contains("depth of the water is not given")),
            "{notes:#?}"
        );
    }
}

/// Tensions and lengths on the seabed in the summaries of MAP++: H, V and L_B of line 1.
#[test]
fn lines_of_map_have_the_tensions_of_its_summaries() {
    let summaries = "
        OC3Hywind | 320 | 736939.302 535728.001 134.785
        OC4DeepCwindSemi | 200 | 909408.441 631704.309 243.7";
    for [file, depth, digits] in rows(summaries) {
        let Some(source) = source(&format!("{BASELINE}{file}_MAP.dat")) else {
            return;
        };
        let site = MooringSite {
            depth_m: Some(depth.parse().expect("a depth")),
            ..SITE
        };
        let state = state(read_map(source, &site));
        let [horizontal_n, vertical_n, on_seabed_m] = numbers(digits);
        let line = state.lines[0];
        assert_eq!(state.lines.len(), 3);
        line.horizontal_n.close_to(horizontal_n, 2e-6);
        line.vertical_n.close_to(vertical_n, 2e-6);
        if file == "OC3Hywind" {
            assert!((line.on_seabed_m - on_seabed_m).abs() < 6e-4, "{line:?}");
        }
    }
}

#[test]
fn free_parts_have_the_stiffness_of_an_independent_program() {
    let digits = "
        clump | 294603.11991 294601.95195 89943.247517 255268327.59 255268627.44 281531049.84 -1577166.2694 -6669167.0355
        body | 8580.1901565 1597.8315538 3993.4479072 3527314.9440 6589538.6547 2957115.4621 -52544.290504 -208735.23068
        coupled | 1131482.9053 200325.76711 122555.78380 204231562.18 611797237.56 426965016.84 -11336463.141 -7561385.7431
        rod | 131503.86842 332821.63058 67464.692585 172309965.45 133611361.60 221957747.62 256886.11334 -4751925.6094
        buoyant | 226872.82501 226872.77513 12340.561065 75858543.914 75858771.355 77380094.256 -2796834.3083 -175048.87182
        delta | 540352.73536 540354.20507 88699.634909 3493073162.0 3493058945.7 466624282.24 -40109035.363 -5839328.77190";
    for [name, digits] in rows(digits) {
        let Some(source) = source(&format!("synthetic/{name}_MoorDyn.dat")) else {
            return;
        };
        // The files have depth, density and gravity themselves.
        let input = read(source, &MooringSite::default());
        assert_digits(&state(Ok(input)), digits, 2e-10);
    }
}

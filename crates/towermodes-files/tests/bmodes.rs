//! What decks of BModes become: small ones of our own, and those of other people where they are at
//! hand.

use crate::decks;

use std::path::{Path, PathBuf};

use decks::{
    ALONE, BLADE_SECTIONS, OFFSHORE, SECTIONS, TOWER, WIRES, blade_file, tower_file, with,
};
use towermodes::{Foundation, Method, Options, RigidBody, solve};
use towermodes_files::{
    BladeInput, BmodesInput, Note, ReadOptions, SiblingFiles, Source, TowerInput, read_bmodes,
};
use towermodes_testing::with;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

#[track_caller]
fn noted(notes: &[Note], line: usize, words: &[&str]) {
    let is_meant = |note: &&Note| {
        let is_there = note.place.as_ref().is_some_and(|(_, at)| *at == line);
        is_there && words.iter().all(|word| note.message.contains(word))
    };
    let holds = notes.iter().any(|note| is_meant(&note));
    assert!(holds, "{line} {words:?}: {notes:#?}");
}

#[test]
fn a_tower_on_land() {
    let input = decks::tower(&tower_file(ALONE), SECTIONS, false);
    let tower = &input.description;
    assert_eq!(tower.name, "A small tower");
    assert_eq!(input.prescribed.method, Some(Method::Bmodes));
    assert_eq!(input.prescribed.modes, Some(10));
    let wanted = Some(vec![0.0, 20.0, 40.0, 60.0, 80.0]);
    assert_eq!(input.prescribed.borders_m, wanted);
    assert_eq!(tower.foundation, Foundation::Clamped);
    assert_eq!(tower.gravity_m_per_s2, 0.0);
    let heights: Vec<f64> = tower.properties.iter().map(|row| row.height_m).collect();
    assert_eq!(heights, [0.0, 40.0, 40.0, 80.0]);
    let row = &tower.properties[2].properties;
    assert_eq!(row.mass_kg_per_m, 3000.0);
    assert_eq!(row.bending_n_m2.fore_aft, 3e11);
    assert_eq!(row.bending_n_m2.side_side, 3e11);
    assert_eq!(row.torsion_n_m2, 2.4e11);
    assert_eq!(row.axial_n, 8e10);
    assert_eq!(row.polar_inertia_kg_m, 24000.0);
    assert_eq!(row.rotary_inertia_kg_m.side_side, 12000.0);
    let rna = &tower.rna;
    assert_eq!((rna.mass_kg, rna.center_m), (2e5, [-1.5, 0.0, 2.5]));
    let expected = [[3e6, 1e4, -2e4], [1e4, 4e6, 3e4], [-2e4, 3e4, 5e6]];
    assert_eq!(rna.inertia_kg_m2.tensor(), expected);
    assert_eq!(input.files().collect::<Vec<_>>(), ["tower.bmi", "secs.dat"]);
    let words = ["cm_axial = 2.5 m", "cm_loc = -1.5 m", "here its centre"];
    noted(&input.notes, 21, &words);
    assert_eq!(input.notes.len(), 1);
}

#[test]
fn line_ends_and_blank_lines_change_nothing() {
    let plain = decks::tower(&tower_file(OFFSHORE), SECTIONS, false);
    let parameter = [("80.0      radius", "\n\n8.0D1,  radius")];
    let changed = with(&tower_file(OFFSHORE), &parameter);
    let changed = with(&changed, &[("0.  0.25  0.5", "\n0.\n0.25,0.5")]);
    let (main, sections) = (
        changed.replace('\n', "\r\n"),
        SECTIONS.replace('\n', "\r\n"),
    );
    let other = decks::tower(main.trim_end(), sections.trim_end(), false);
    assert_eq!(plain.description, other.description);
    assert_eq!(plain.prescribed.borders_m, other.prescribed.borders_m);
}

#[test]
fn factors_scale_their_columns() {
    let changes = [
        ("1.0       sec_mass", "1.5 sec_mass"),
        ("1.0       flp_iner", "2.0 flp_iner"),
        ("1.0       lag_iner", "3.0 lag_iner"),
        ("1.0       flp_stff", "4.0 flp_stff"),
        ("1.0       edge_stff", "5.0 edge_stff"),
        ("1.0       tor_stff", "6.0 tor_stff"),
        ("1.0       axial_stff", "7.0 axial_stff"),
    ];
    let main = with(&tower_file(ALONE), &changes);
    let input = decks::tower(&main, SECTIONS, false);
    let row = &input.description.properties[0].properties;
    assert_eq!(row.mass_kg_per_m, 6000.0);
    // Twice and three times 20000 kg m: the factor of mass does not act on inertia.
    assert_eq!(row.polar_inertia_kg_m, 100_000.0);
    assert_eq!(row.rotary_inertia_kg_m.fore_aft, 4e4);
    assert_eq!(row.rotary_inertia_kg_m.side_side, 6e4);
    assert_eq!(row.bending_n_m2.fore_aft, 2e12);
    assert_eq!(row.bending_n_m2.side_side, 2.5e12);
    assert_eq!((row.torsion_n_m2, row.axial_n), (2.4e12, 7.7e11));
    noted(
        &input.notes,
        37,
        &[
            "swaps",
            "flp_stff_mult = 4",
            "use --bmodes-quirks for the behaviour of",
        ],
    );
    let quirks = decks::tower(&main, SECTIONS, true);
    let row = &quirks.description.properties[0].properties;
    assert_eq!(row.bending_n_m2.fore_aft, 2.5e12);
    assert_eq!(row.bending_n_m2.side_side, 2e12);
    let words = ["swaps", "as in BModes 3.00 (--bmodes-quirks)"];
    noted(&quirks.notes, 37, &words);
}

#[test]
fn quirks_take_the_axial_offset_for_the_lateral_one() {
    let input = decks::tower(&tower_file(ALONE), SECTIONS, true);
    assert_eq!(input.description.rna.center_m, [2.5, 0.0, 0.0]);
    noted(&input.notes, 21, &["as in BModes 3.00 (--bmodes-quirks)"]);
    let none = [
        ("-1.5      cm_loc", "0. cm_loc"),
        ("2.5       cm_axial", "0. cm_axial"),
    ];
    let input = decks::tower(&with(&tower_file(ALONE), &none), SECTIONS, true);
    assert!(input.notes.is_empty());
}

#[test]
fn wires_hold_at_their_nodes() {
    let input = decks::tower(&tower_file(WIRES), SECTIONS, false);
    let wires = &input.description.wires;
    let said = |i: usize| {
        (
            wires[i].height_m,
            wires[i].count,
            wires[i].stiffness_n_per_m,
            wires[i].angle_deg,
        )
    };
    assert_eq!(said(0), (40.0, 3, 1e8, 60.0));
    assert_eq!(said(1), (80.0, 4, 2e8, 30.0));
    // Three of 1e8 N/m at 60 degrees: 3/4 1e8 in BModes, half of it in truth, and 9/4 1e8 upwards.
    let words = ["node 3", "7.50000e7", "3.75000e7", "2.25000e8"];
    noted(&input.notes, 56, &words);
    let quirks = decks::tower(&tower_file(WIRES), SECTIONS, true);
    let wires = &quirks.description.wires;
    assert!(close(wires[0].horizontal_n_per_m(), 0.75e8));
    // 4 · 2e8 · 3/4.
    assert!(close(wires[1].horizontal_n_per_m(), 6e8));
    assert_eq!(wires[1].vertical_n_per_m(), 0.0);
}

#[test]
fn a_floating_tower() {
    let changes = [
        ("1         hub_conn", "2 hub_conn"),
        ("0.        hub_rad", "4. hub_rad"),
    ];
    let input = decks::tower(&with(&tower_file(OFFSHORE), &changes), SECTIONS, false);
    let tower = &input.description;
    // The flexible base lies at hub_rad − draft.
    assert_eq!(tower.properties[0].height_m, -6.0);
    assert_eq!(tower.properties[1].height_m, 37.0);
    assert_eq!(tower.properties[3].height_m, 80.0);
    assert_eq!(
        input.prescribed.borders_m.as_deref().expect("borders")[1],
        15.5
    );
    let Foundation::Floating(platform) = &tower.foundation else {
        panic!("{:?}", tower.foundation)
    };
    assert_eq!(platform.mass_kg, 8e6);
    assert_eq!(platform.center_m, [0.0, 0.0, -40.0]);
    let inertia = platform.inertia_kg_m2;
    assert_eq!((inertia.xx, inertia.yy, inertia.zz), (4e9, 5e9, 2e8));
    for referred in [
        &platform.added_mass,
        &platform.hydrostatic,
        &platform.mooring,
    ] {
        assert_eq!(referred.height_m, -5.0);
    }
    assert_eq!(platform.added_mass.matrix[0][4], -4e8);
    assert_eq!(platform.hydrostatic.matrix[2][2], 3.3e5);
    assert_eq!(platform.mooring.matrix[3][1], 2.8e6);
    let rows = &tower.added_mass[0];
    assert_eq!((rows[1].height_m, rows[1].mass_kg_per_m), (-1.0, 6000.0));
    let rows = &tower.soil[0];
    assert_eq!((rows.len(), rows[1].height_m), (2, 0.0));
    assert_eq!(rows[1].stiffness.x_n_per_m2, 5e7);
    assert_eq!(rows[1].stiffness.y_n_per_m2, 5e7);
    assert_eq!(rows[1].stiffness.z_n_per_m2, 0.0);
    assert!(input.tower().is_ok());
}

#[test]
fn a_monopile_on_springs() {
    let parameter = [("1         hub_conn", "3 hub_conn")];
    let main = with(&tower_file(OFFSHORE), &parameter);
    let input = decks::tower(&main, SECTIONS, false);
    let Foundation::Stiffness(springs) = &input.description.foundation else {
        panic!("{:?}", input.description.foundation)
    };
    // The matrices' point at −5 m is 5 m above the base: K14 + 5 K00, K44 + 10 K04 + 25 K00 of
    // hydro_K and mooring_K together.
    let k = &springs.stiffness;
    assert_eq!((k[0][0], k[1][1]), (4e4, 4e4));
    assert!(close(k[0][4], -2.6e6) && close(k[4][0], -2.6e6));
    assert!(close(k[1][3], 2.6e6));
    assert!(close(k[4][4], 1.31e9 - 2.8e7 + 1e6), "{}", k[4][4]);
    assert_eq!((k[2][2], k[5][5]), (f64::INFINITY, f64::INFINITY));
    assert_eq!((k[2][0], k[5][4]), (0.0, 0.0));
    // The platform's centre at −40 m is 30 m below the base, its added mass again 5 m above it.
    let m = &springs.inertia;
    assert!(close(m[0][0], 1.5e7));
    assert!(close(m[0][4], -30.0 * 8e6 - 4e8 + 5.0 * 7e6), "{}", m[0][4]);
    assert!(close(m[1][3], 30.0 * 8e6 + 4e8 - 5.0 * 7e6));
    let expected = 4e9 + 900.0 * 8e6 + 3.8e10 - 10.0 * 4e8 + 25.0 * 7e6;
    assert!(close(m[3][3], expected), "{} {expected}", m[3][3]);
    assert!(close(m[4][4], expected + 1e9));
}

#[test]
fn springs_without_a_platform_are_a_foundation() {
    let changes = [
        ("1         hub_conn", "2 hub_conn"),
        ("8.0e6     mass", "0. mass"),
    ];
    let input = decks::tower(&with(&tower_file(OFFSHORE), &changes), SECTIONS, false);
    let Foundation::Stiffness(springs) = &input.description.foundation else {
        panic!("{:?}", input.description.foundation)
    };
    assert_eq!(springs.stiffness[2][2], 3.42e5);
    assert_eq!(springs.stiffness[5][5], 1.1e7);
    assert_eq!(springs.inertia[2][2], 2.4e5);
}

#[test]
fn a_clamped_base_makes_matrices_useless() {
    let input = decks::tower(&tower_file(OFFSHORE), SECTIONS, false);
    assert_eq!(input.description.foundation, Foundation::Clamped);
    noted(&input.notes, 13, &["no effect"]);
}

#[test]
fn slight_asymmetry_is_noted() {
    let changes = [
        ("1         hub_conn", "2 hub_conn"),
        ("-2.8e6 0. 0. 0. 3.1e8", "-2.7e6 0. 0. 0. 3.1e8"),
    ];
    let input = decks::tower(&with(&tower_file(OFFSHORE), &changes), SECTIONS, false);
    noted(
        &input.notes,
        79,
        &["mooring_K is not symmetric", "-2800000", "-2700000", "mean"],
    );
    let Foundation::Floating(platform) = &input.description.foundation else {
        panic!("{:?}", input.description.foundation)
    };
    assert!(close(platform.mooring.matrix[0][4], -2.75e6));
    assert!(close(platform.mooring.matrix[4][0], -2.75e6));
}

#[test]
fn a_later_bmodes_has_wires_after_the_platform() {
    let parameter = [("2         tow_support", "1 tow_support"), ("END\n", "")];
    let later = with(OFFSHORE, &parameter);
    let bare = decks::tower(&tower_file(&later), SECTIONS, false);
    assert!(bare.description.wires.is_empty());
    let start = WIRES.find("2         n_att").expect("wires");
    let later = format!("{later}\nTension wires data\n{}", &WIRES[start..]);
    let input = decks::tower(&tower_file(&later), SECTIONS, false);
    assert_eq!(input.description.wires.len(), 2);
    // Node 3 of 5 between −10 and 80 m.
    assert_eq!(input.description.wires[0].height_m, 35.0);
    noted(&input.notes, 21, &["later version of BModes"]);
    let third = with(&later, &[("1 tow_support", "2 tow_support")]);
    let input = decks::tower(&tower_file(&third), SECTIONS, false);
    assert!(input.description.wires.is_empty());
    noted(&input.notes, 93, &["wires", "not read"]);
}

#[test]
fn version_1_has_no_axial_offset() {
    let main = with(TOWER, &[("2.5       cm_axial    m\n", "")]);
    let start = WIRES.find("2         n_att").expect("wires");
    let main = format!("{main}\n--- Wires ---\n{}", &WIRES[start..]);
    let input = decks::tower(&main, SECTIONS, true);
    assert_eq!(input.description.rna.center_m, [-1.5, 0.0, 0.0]);
    assert_eq!(input.description.wires.len(), 2);
    noted(&input.notes, 20, &["BModes 1.03"]);
}

#[test]
fn names_on_the_lines_may_be_left_out() {
    let bare: String = TOWER
        .lines()
        .enumerate()
        .map(|(index, line)| {
            let is_value = (5..=47).contains(&(index + 1)) && !line.starts_with("---");
            let first = line.split_whitespace().next().unwrap_or_default();
            format!("{}\n", if is_value && index != 46 { first } else { line })
        })
        .collect();
    let support = ALONE.replace(" tow_support: none", "");
    let input = decks::tower(&format!("{bare}{support}"), SECTIONS, false);
    let named = decks::tower(&tower_file(ALONE), SECTIONS, false);
    assert_eq!(input.description, named.description);
}

#[test]
fn columns_that_towers_do_not_have_may_be_anything() {
    let row = "3000. 12000. 12000. 300.0E9 300.0E9 240.0E9  80.0E9 0. 0. 0.";
    let other = "3000. 12000. -1. 300.0E9 0. 240.0E9  80.0E9 0. 0.4 0. 99. 98. and more";
    let input = decks::tower(&tower_file(ALONE), &with(SECTIONS, &[(row, other)]), false);
    let plain = decks::tower(&tower_file(ALONE), SECTIONS, false);
    assert_eq!(input.description, plain.description);
    noted(&input.notes, 8, &["edge_stff = 0e0", "not used for towers"]);
    noted(&input.notes, 8, &["cg_offst", "not all 0"]);
    noted(&input.notes, 8, &["more than 13 numbers"]);
}

#[test]
fn a_row_may_go_on_on_the_next_line() {
    let row = "3000. 12000. 12000. 300.0E9 ";
    let broken = "3000. 12000. 12000.\n300.0E9 ";
    let input = decks::tower(&tower_file(ALONE), &with(SECTIONS, &[(row, broken)]), false);
    let plain = decks::tower(&tower_file(ALONE), SECTIONS, false);
    assert_eq!(input.description, plain.description);
}

#[test]
fn more_modes_than_there_are_are_not_asked_for() {
    let main = with(&tower_file(ALONE), &[("10        modepr", "1000 modepr")]);
    let input = decks::tower(&main, SECTIONS, false);
    // Nine for each of four elements.
    assert_eq!(input.prescribed.modes, Some(36));
    noted(&input.notes, 14, &["1000", "36"]);
}

#[test]
fn a_blade_has_the_signs_of_bmodes() {
    let input = decks::blade(&blade_file(), BLADE_SECTIONS, false);
    let blade = &input.description;
    assert_eq!((blade.hub_radius_m, blade.tip_radius_m), (2.0, 80.0));
    assert_eq!(blade.borders, [0.0, 0.25, 0.5, 0.75, 1.0]);
    assert!(close(blade.rotor_speed_rad_per_s, std::f64::consts::PI));
    assert_eq!(input.modes, 10);
    let RigidBody {
        mass_kg,
        center_m,
        inertia_kg_m2,
    } = blade.tip;
    assert_eq!((mass_kg, center_m), (50.0, [1.5, 0.0, 2.5]));
    let expected = [[11.0, -0.1, -0.3], [-0.1, 10.0, -0.2], [-0.3, -0.2, 12.0]];
    assert_eq!(inertia_kg_m2.tensor(), expected);
    let row = &blade.sections[1];
    assert_eq!((row.span, row.mass_kg_per_m), (0.4, 200.0));
    assert!(close(row.twist_rad, -10f64.to_radians()));
    // Turned by 30 degrees: 40 ∓ 30 cos 60°.
    let holds = close(row.flap_inertia_kg_m, 25.0);
    assert!(holds, "{}", row.flap_inertia_kg_m);
    assert!(close(row.edge_inertia_kg_m, 55.0));
    assert_eq!((row.flap_n_m2, row.edge_n_m2), (4e9, 7e9));
    assert_eq!((row.torsion_n_m2, row.axial_n), (1e9, 1.2e10));
    assert_eq!(row.center_of_mass_m, -0.15);
    assert!(close(row.tension_center_m, -0.05));
    let words = ["cm_axial", "3 sections", "here it is 1.5 m"];
    noted(&input.notes, 21, &words);
}

#[test]
fn a_blades_factors_and_quirks() {
    let changes = [
        ("1.0       cg_offst", "1.2 cg_offst"),
        ("1.0       sc_offst", "3.0 sc_offst"),
        ("1.0       tc_offst", "0.5 tc_offst"),
        ("0.        bl_thp", "5.0 bl_thp"),
        ("0.        precone", "2.5 precone"),
    ];
    let main = with(&blade_file(), &changes);
    let input = decks::blade(&main, BLADE_SECTIONS, true);
    let row = &input.description.sections[1];
    assert!(close(row.center_of_mass_m, -0.15 * 1.2));
    assert!(close(row.tension_center_m, -0.05 * 1.5));
    assert!(close(input.description.pitch_rad, 5f64.to_radians()));
    noted(&input.notes, 12, &["bl_thp = 5"]);
    noted(&input.notes, 11, &["precone = 2.5"]);
    // Three rows turn the sign of the value that is taken for cm_loc three times.
    assert_eq!(input.description.tip.center_m, [-2.5, 0.0, 0.0]);
    let fourth = "1.0 0. 0. 10. 0.1 0.7 0.2E9 8.0E6 0.2E6 1.2E8 0.20 0.10 0.0\n";
    let more = [
        (fourth, &*fourth.repeat(2)),
        ("3        n_secs", "4 n_secs"),
    ];
    let input = decks::blade(&main, &with(BLADE_SECTIONS, &more), true);
    assert_eq!(input.description.tip.center_m, [2.5, 0.0, 0.0]);
}

/// A file of BModes' own samples, if they are at hand.
fn sample(name: &str) -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("TOWERMODES_PEER_DATA") else {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
        return None;
    };
    Some(Path::new(&folder).join("bmodes").join(name))
}

fn read_sample(path: &Path, quirks: bool) -> BmodesInput {
    let source = Source::from_path(path).expect("the sample is there");
    let options = with!(ReadOptions, bmodes_quirks = quirks);
    read_bmodes(source, &SiblingFiles::of(path), &options).unwrap_or_else(|error| panic!("{error}"))
}

fn sample_tower(path: &Path, quirks: bool) -> TowerInput {
    match read_sample(path, quirks) {
        BmodesInput::Tower(tower) => *tower,
        BmodesInput::Blade(_) => panic!("{} is a tower", path.display()),
    }
}

fn sample_blade(path: &Path, quirks: bool) -> BladeInput {
    match read_sample(path, quirks) {
        BmodesInput::Blade(blade) => *blade,
        BmodesInput::Tower(_) => panic!("{} is a blade", path.display()),
    }
}

#[test]
fn the_sample_blades() {
    let Some(path) = sample("Test01_nonunif_blade.bmi") else {
        return;
    };
    let input = sample_blade(&path, false);
    let blade = &input.description;
    assert_eq!(blade.sections.len(), 21);
    assert_eq!(blade.borders.len(), 13);
    assert_eq!(input.modes, 20);
    assert_eq!((blade.hub_radius_m, blade.tip_radius_m), (1.75, 35.0));
    assert!(close(
        blade.rotor_speed_rad_per_s,
        2.0 * std::f64::consts::PI
    ));
    assert!(close(blade.sections[0].twist_rad, -11.1f64.to_radians()));
    assert_eq!(blade.sections[20].center_of_mass_m, -0.22);
    assert_eq!(blade.sections[20].tension_center_m, 0.098);
    assert_eq!(blade.tip.mass_kg, 0.0);
    assert!(input.notes.is_empty(), "{:?}", input.notes);
    let Some(path) = sample("Test02_blade_with_tip_mass.bmi") else {
        return;
    };
    let input = sample_blade(&path, true);
    let inertia = input.description.tip.inertia_kg_m2;
    assert_eq!((inertia.xx, inertia.yy, inertia.zz), (1.75, 10.0, 2.5));
}

#[test]
fn the_sample_towers_on_land() {
    let Some(path) = sample("Test03_tower.bmi") else {
        return;
    };
    let input = sample_tower(&path, false);
    let tower = &input.description;
    assert_eq!(tower.properties.len(), 10);
    assert_eq!(input.prescribed.modes, Some(20));
    assert_eq!(tower.properties[9].height_m, 82.39);
    assert_eq!(tower.properties[9].properties.mass_kg_per_m, 644.666);
    assert_eq!(
        tower.properties[0].properties.bending_n_m2.side_side,
        243.058e9
    );
    assert_eq!(tower.rna.mass_kg, 78055.8);
    assert_eq!(tower.rna.center_m, [-3.3, 0.0, 1.1]);
    assert_eq!(tower.rna.inertia_kg_m2.xz, -18400.0);
    assert!(tower.wires.is_empty());
    let found = sample_tower(&path, true).description.rna.center_m;
    assert_eq!(found, [1.1, 0.0, 0.0]);
    assert!(input.tower().is_ok());
    let Some(path) = sample("Test04_wires_supported_tower.bmi") else {
        return;
    };
    let input = sample_tower(&path, false);
    let wires = &input.description.wires;
    assert_eq!(wires.len(), 2);
    assert_eq!(wires[1].count, 3);
    assert_eq!(wires[1].stiffness_n_per_m, 1.6e9);
    assert_eq!(wires[1].angle_deg, 30.0);
    let borders_m = input.prescribed.borders_m.as_deref().expect("borders");
    assert_eq!(wires[0].height_m, borders_m[5]);
    assert_eq!(wires[1].height_m, borders_m[9]);
    assert!(input.tower().is_ok());
}

#[test]
fn the_sample_monopile() {
    let Some(path) = sample("CS_Monopile.bmi") else {
        return;
    };
    let input = sample_tower(&path, false);
    let tower = &input.description;
    let ends = (tower.properties[0].height_m, tower.properties[12].height_m);
    assert_eq!(ends, (-20.0, 87.6));
    assert_eq!(
        input
            .prescribed
            .borders_m
            .as_deref()
            .expect("borders")
            .len(),
        62
    );
    let Foundation::Stiffness(springs) = &tower.foundation else {
        panic!("{:?}", tower.foundation)
    };
    // The matrices are about the base already.
    let k = &springs.stiffness;
    assert_eq!(k[0][0], 2_574_800_000.0);
    assert_eq!(k[0][4], -22_532_500_000.0);
    assert_eq!(k[1][3], 22_532_500_000.0);
    assert_eq!((k[3][3], k[2][2]), (262_912_300_000.0, f64::INFINITY));
    assert_eq!(springs.inertia, [[0.0; 6]; 6]);
    assert!(tower.soil.is_empty() && tower.wires.is_empty());
}

#[test]
fn the_sample_spar() {
    let Some(path) = sample("OC3Hywind.bmi") else {
        return;
    };
    let input = sample_tower(&path, false);
    let tower = &input.description;
    let ends = (tower.properties[0].height_m, tower.properties[10].height_m);
    assert_eq!(ends, (10.0, 87.6));
    let Foundation::Floating(platform) = &tower.foundation else {
        panic!("{:?}", tower.foundation)
    };
    assert_eq!(platform.mass_kg, 7_466_330.0);
    assert_eq!(platform.center_m[2], -89.9155);
    assert_eq!(platform.mooring.height_m, 0.0);
    assert_eq!(platform.mooring.matrix[0][4], -2_818_500.0);
    assert_eq!(platform.mooring.matrix[4][4], 6_894_680_000.0);
    assert_eq!(platform.added_mass.matrix[3][3], 37_936_090_500.0);
    assert!(
        input
            .notes
            .iter()
            .any(|note| note.message.contains("mooring_K is not symmetric"))
    );
    // The deck has 50 equal elements. What its authors' later BModes prints, and what 3.00 prints
    // with tow_support = 2.
    let later = [
        0.0324282, 0.0393116, 0.0393271, 0.120510, 0.481579, 0.490754,
    ];
    let third = [
        0.0324282, 0.0394686, 0.0394887, 0.120241, 0.499688, 0.508739,
    ];
    for (quirks, expected) in [(false, later), (true, third)] {
        let tower = sample_tower(&path, quirks).tower().expect("a tower");
        let options = with!(Options, method = Method::Bmodes, segments = Some(50));
        let solution = solve(&tower, &options).expect("modes");
        // Surge and sway come first, which the program's own solver rounds most.
        for (mode, hz) in solution.modes[2..].iter().zip(expected) {
            let off = (mode.frequency_hz / hz - 1.0).abs();
            assert!(off < 2e-5, "{} {hz}", mode.frequency_hz);
        }
    }
}

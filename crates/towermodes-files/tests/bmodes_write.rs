//! Decks of BModes: every record in its place, and the tower in them.

use crate::written_decks;

use std::f64::consts::PI;

use towermodes::{
    Inertia, Method, Options, Planes, PointMass, Properties, PropertyStation, Rna, Shear, Station,
    Tower, TowerDescription, solve,
};
use towermodes_files::{BmodesWriteError, BmodesWriteOptions, write_bmodes};
use towermodes_testing::{Says, assert_matches, parts, with};

use written_decks::{Deck, assert_near, between, try_to_write, tubes, written};

#[test]
fn records_of_a_clamped_tower_stand_where_bmodes_reads_them() {
    let deck = written(&tubes());
    assert!(deck.notes.is_empty(), "{:?}", deck.notes);
    assert_eq!(deck.lines[1], "Tower of the test");
    let records = [
        (5, "Echo"),
        (6, "beam_type"),
        (7, "rot_rpm"),
        (8, "rpm_mult"),
        (9, "radius"),
        (10, "hub_rad"),
        (11, "precone"),
        (12, "bl_thp"),
        (13, "hub_conn"),
        (14, "modepr"),
        (15, "TabDelim"),
        (16, "mid_node_tw"),
        (19, "tip_mass"),
        (20, "cm_loc"),
        (21, "cm_axial"),
        (22, "ixx_tip"),
        (23, "iyy_tip"),
        (24, "izz_tip"),
        (25, "ixy_tip"),
        (26, "izx_tip"),
        (27, "iyz_tip"),
        (30, "id_mat"),
        (31, "sec_props_file"),
        (34, "sec_mass_mult"),
        (35, "flp_iner_mult"),
        (36, "lag_iner_mult"),
        (37, "flp_stff_mult"),
        (38, "edge_stff_mult"),
        (39, "tor_stff_mult"),
        (40, "axial_stff_mult"),
        (41, "cg_offst_mult"),
        (42, "sc_offst_mult"),
        (43, "tc_offst_mult"),
        (46, "nselt"),
    ];
    for (record, name) in records {
        assert_eq!(deck.record(name), record, "{name}");
    }
    // 61 borders on eight lines, and two records before tow_support.
    assert_eq!(deck.record("tow_support"), 48 + 8 + 2);
    assert_eq!((deck.value("radius"), deck.value("hub_rad")), (100.0, 0.0));
    assert_eq!(deck.value("hub_conn"), 1.0);
    assert_eq!(deck.value("beam_type"), 2.0);
    assert_eq!(deck.value("nselt"), 60.0);
    assert_eq!(deck.value("tow_support"), 0.0);
    deck.lines[30].begins("'tower_sections.dat'");
    assert_eq!(deck.borders()[30], 0.5);
}

#[test]
fn lines_between_sections_are_the_tube() {
    let deck = written(&tubes());
    assert!(deck.sections.len() < 300, "{}", deck.sections.len());
    for step in 0..=1000 {
        let share = f64::from(step) / 1000.0 * 0.999_99 + 3e-6;
        let (d, t) = (6.0 - 2.0 * share, 0.027 - 0.007 * share);
        let inner = d - 2.0 * t;
        let area = PI / 4.0 * (d * d - inner * inner);
        let second = PI / 64.0 * (d.powi(4) - inner.powi(4));
        let expected = [
            (3, 8500.0 * area),
            (6, 2.1e11 * second),
            (8, 8.08e10 * 2.0 * second),
            (9, 2.1e11 * area),
        ];
        for (column, expected) in expected {
            assert_near(deck.column_at(column, share), expected, 1.2e-5);
        }
    }
    // Twice flp_iner is the polar inertia.
    let first = &deck.sections[0];
    let (outer, inner) = (6.0_f64, 6.0_f64 - 0.054);
    assert_near(
        first[4],
        8500.0 * PI / 64.0 * (outer.powi(4) - inner.powi(4)),
        1e-12,
    );
    assert_eq!((first[4], first[6]), (first[5], first[7]));
}

/// The tower that a deck describes, as far as a table of properties can.
fn tower_of(deck: &Deck) -> Tower {
    let (base_m, length_m) = (
        deck.value("hub_rad"),
        deck.value("radius") - deck.value("hub_rad"),
    );
    let rows = deck.sections.iter().map(|row| PropertyStation {
        height_m: base_m + row[0] * length_m,
        properties: Properties {
            mass_kg_per_m: row[3],
            rotary_inertia_kg_m: Planes::both(row[4]),
            polar_inertia_kg_m: 2.0 * row[4],
            bending_n_m2: Planes::both(row[6]),
            torsion_n_m2: row[8],
            axial_n: row[9],
            shear_n: None,
        },
    });
    Tower::new(TowerDescription {
        properties: rows.collect(),
        rna: Rna {
            mass_kg: deck.value("tip_mass"),
            center_m: [deck.value("cm_loc"), 0.0, deck.value("cm_axial")],
            inertia_kg_m2: Inertia {
                xx: deck.value("ixx_tip"),
                yy: deck.value("iyy_tip"),
                zz: deck.value("izz_tip"),
                xy: deck.value("ixy_tip"),
                xz: deck.value("izx_tip"),
                yz: deck.value("iyz_tip"),
            },
        },
        ..TowerDescription::default()
    })
    .expect("a tower")
}

#[test]
fn the_tower_of_a_deck_has_the_frequencies_of_the_tower() {
    let mut description = between(10.0, 97.0);
    description.rna = Rna {
        mass_kg: 350e3,
        center_m: [-0.41, 0.0, 1.97],
        inertia_kg_m2: Inertia {
            xx: 4.37e7,
            yy: 2.353e7,
            zz: 2.542e7,
            xy: 1e5,
            xz: 1.169e6,
            yz: 2e5,
        },
    };
    description.outfitting_factor = 1.1;
    description.point_masses = vec![
        parts::point_mass(97.0, 5e3, Inertia::default()),
        parts::point_mass(50.0, 20e3, Inertia::default()),
    ];
    let deck = written(&description);
    let options = with!(Options, method = Method::Spectral);
    let frequencies = |tower: &Tower| -> Vec<f64> {
        let solution = solve(tower, &options).expect("modes");
        solution
            .modes
            .iter()
            .take(6)
            .map(|mode| mode.frequency_hz)
            .collect()
    };
    let own = frequencies(&Tower::new(description).expect("a tower"));
    for (deck, own) in frequencies(&tower_of(&deck)).into_iter().zip(own) {
        // As right as the lines of the table are.
        assert_near(deck, own, 1e-5);
    }
    deck.says("point masses at the top (1) are part of the tip mass, 355000 kg");
    deck.says("20000 kg at 50 m is distributed over 0.435 m");
    deck.says("reads cm_axial as cm_loc");
}

#[test]
fn a_step_is_two_rows_and_an_element_border() {
    let mut description = tubes();
    description.stations = vec![
        Station::new(0.0, 6.0, 0.06),
        Station::new(25.0, 6.0, 0.06),
        Station::new(25.0, 6.0, 0.03),
        Station::new(100.0, 6.0, 0.03),
    ];
    let deck = written(&description);
    let heights: Vec<f64> = deck.sections.iter().map(|row| row[0]).collect();
    assert_eq!(heights, [0.0, 0.25, 0.2500001, 1.0]);
    assert_eq!(deck.sections[0][1..], deck.sections[1][1..]);
    assert_near(deck.sections[1][3], 8500.0 * PI * 0.06 * 5.94, 1e-12);
    assert_near(deck.sections[2][3], 8500.0 * PI * 0.03 * 5.97, 1e-12);
    assert!(deck.borders().contains(&0.25));
}

#[test]
fn masses_keep_their_mass_their_centre_and_their_inertia_about_the_axis() {
    let mut description = tubes();
    let mass = |height_m, mass_kg, zz| PointMass {
        height_m,
        mass_kg,
        inertia_kg_m2: with!(Inertia, xx = zz, yy = zz, zz),
    };
    // Apart, overlapping, nearer to an end than half the width, and where the tower has a step.
    description.point_masses = vec![
        mass(30.0, 1e4, 1e5),
        mass(30.1, 2e4, 0.0),
        mass(60.0, 4e4, 3e5),
        mass(99.9, 500.0, 0.0),
    ];
    description
        .stations
        .insert(1, Station::new(60.0, 4.8, 0.0228));
    description
        .stations
        .insert(2, Station::new(60.0, 4.6, 0.0228));
    let (with, mut bare) = (written(&description), description);
    bare.point_masses.clear();
    let without = written(&bare);
    let moments = |deck: &Deck, from: f64, to: f64| {
        // Simpson over each line between rows: exact, as a row's columns are linear.
        let mut sums = [0.0; 3];
        for pair in deck
            .sections
            .windows(2)
            .filter(|pair| from <= pair[0][0] && pair[1][0] <= to)
        {
            let (a, b) = (pair[0][0] * 100.0, pair[1][0] * 100.0);
            let middle = 0.5 * (pair[0][3] + pair[1][3]);
            let sixth = (b - a) / 6.0;
            sums[0] += sixth * (pair[0][3] + 4.0 * middle + pair[1][3]);
            sums[1] += sixth * (a * pair[0][3] + 2.0 * (a + b) * middle + b * pair[1][3]);
            sums[2] += sixth * (pair[0][4] + 2.0 * (pair[0][4] + pair[1][4]) + pair[1][4]);
        }
        sums
    };
    let total = |from, to| {
        let (with, without) = (moments(&with, from, to), moments(&without, from, to));
        [
            with[0] - without[0],
            with[1] - without[1],
            with[2] - without[2],
        ]
    };
    let [kg, moment, half_polar] = total(0.0, 1.0);
    assert_near(kg, 70_500.0, 1e-3);
    let expected = 30.0 * 1e4 + 30.1 * 2e4 + 60.0 * 4e4 + 99.9 * 500.0;
    assert_near(moment, expected, 1e-3);
    assert_near(half_polar, 0.5 * 4e5, 2e-2);
    let borders = with.borders();
    for end in [0.2975, 0.3025, 0.2985, 0.3035, 0.5975, 0.6, 0.6025, 0.998] {
        let nearest = borders
            .iter()
            .map(|border| (border - end).abs())
            .fold(1.0, f64::min);
        assert!(nearest < 1e-12, "{end}: {borders:?}");
    }
    with.says("only zz of its inertia is kept");
}

#[test]
fn planes_in_one_ratio_or_not_at_all() {
    let row = |height_m, fore_aft, side_side| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: 5000.0,
            rotary_inertia_kg_m: Planes::both(2e4),
            polar_inertia_kg_m: 4e4,
            bending_n_m2: parts::planes(fore_aft, side_side),
            torsion_n_m2: 4.7e11,
            axial_n: 1.4e11,
            shear_n: None,
        },
    };
    let of = |properties| with!(TowerDescription, properties);
    let deck = written(&of(vec![row(0.0, 4e11, 5e11), row(90.0, 2e11, 2.5e11)]));
    assert_eq!(deck.value("flp_stff_mult"), 1.0);
    assert_eq!(deck.value("edge_stff_mult"), 1.25);
    // Both ends of a table's line are enough.
    assert_eq!(deck.sections.len(), 2);
    let expected = [5000.0, 2e4, 2e4, 2e11, 2e11, 4.7e11, 1.4e11];
    assert_eq!(deck.sections[1][3..10], expected);
    deck.says("BModes 3.00 swaps flp_stff_mult and edge_stff_mult");
    let error = try_to_write(&of(vec![row(0.0, 4e11, 5e11), row(90.0, 2e11, 2e11)]));
    let error = error.expect_err("planes that differ").to_string();
    error.says("1.25 at 0 m and 1.16667 at 45 m");
}

#[test]
fn what_bmodes_leaves_out_is_said() {
    let mut description = tubes();
    description.shear = Shear::Cowper;
    description.gravity_m_per_s2 = 9.81;
    let deck = written(&description);
    deck.says("BModes has no shear deformation: Cowper's shear coefficient is left out");
    deck.says("BModes has no gravity: 9.81 m/s2 is left out");
}

#[test]
fn no_more_elements_than_bmodes_takes_and_no_heights_too_close() {
    let mut description = tubes();
    let steps = |count: i32, gap: f64| -> Vec<Station> {
        let step = |i: i32| {
            let z = f64::from(i) * gap;
            let wall = if i % 2 == 0 { 0.03 } else { 0.04 };
            [
                Station::new(z, 6.0, wall),
                Station::new(f64::from(i + 1) * gap, 6.0, wall),
            ]
        };
        (0..count).flat_map(step).collect()
    };
    description.stations = steps(100, 1.0);
    let deck = written(&description);
    assert_eq!((deck.value("nselt"), deck.sections.len()), (100.0, 200));
    description.stations = steps(150, 1.0);
    let deck = written(&description);
    assert_eq!(deck.value("nselt"), 60.0);
    deck.says("need 150 elements, but BModes 3.00 has at most 111");
    description.stations = steps(20, 1e-8);
    description
        .stations
        .push(Station::new(20.0 * 1e-8, 6.0, 0.03));
    description.stations.push(Station::new(100.0, 6.0, 0.03));
    let deck = written(&description);
    deck.says("heights are merged with neighbours");
    let tower = Tower::new(tubes()).expect("a tower");
    let options = |elements| with!(BmodesWriteOptions, elements, modes = 0);
    let many = Deck::of(&write_bmodes(&tower, &tubes(), &options(usize::MAX)).expect("a deck"));
    assert_eq!((many.value("nselt"), many.value("modepr")), (111.0, 1.0));
    let few = Deck::of(&write_bmodes(&tower, &tubes(), &options(0)).expect("a deck"));
    assert_eq!(few.value("nselt"), 1.0);
}

#[test]
fn names_and_titles_stay_on_their_lines() {
    let mut description = tubes();
    description.name = "two\nlines, ".repeat(20);
    let deck = written(&description);
    assert_eq!(deck.record("radius"), 9);
    deck.lines[1].begins("two lines, two lines,");
    assert!(deck.lines[1].chars().count() <= 99);
    let tower = Tower::new(tubes()).expect("a tower");
    let named = |sections_file: &str| {
        let options = with!(BmodesWriteOptions, sections_file = sections_file.into());
        write_bmodes(&tower, &tubes(), &options).map(|files| files.deck)
    };
    let deck = named("it's in/a folder.dat").expect("a deck");
    deck.says("\n\"it's in/a folder.dat\" ");
    for wrong in ["", "a'b\"c", "two\nlines", &"x".repeat(201)] {
        let error = named(wrong).expect_err("no name");
        assert_matches!(error, BmodesWriteError::FileName { .. });
    }
}

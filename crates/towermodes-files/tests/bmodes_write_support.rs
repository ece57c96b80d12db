//! What holds and surrounds a tower, in decks of BModes.

use crate::written_decks;

use std::f64::consts::PI;

use proptest::prelude::*;
use towermodes::{
    FloatingPlatform, Foundation, FoundationSprings, Inertia, ReferredMatrix, Rna, SoilRow,
    SoilStiffness, Station, StiffnessFoundation, Tower, TowerDescription, Wires,
};
use towermodes_files::{BmodesWriteOptions, write_bmodes};
use towermodes_testing::{Says, changed, parts, with};

use written_decks::{Deck, assert_near, between, try_to_write, tubes, written};

#[test]
fn masses_at_the_ends_are_part_of_what_is_there() {
    let mut description = tubes();
    let inertia = with!(Inertia, xx = 10.0, yy = 20.0, zz = 30.0);
    let mass = |height_m| parts::point_mass(height_m, 1000.0, inertia);
    description.point_masses = vec![mass(0.0), mass(100.0)];
    description.rna = Rna {
        mass_kg: 3000.0,
        center_m: [0.4, 0.8, 2.0],
        inertia_kg_m2: Inertia::default(),
    };
    description.foundation = Foundation::Springs(parts::springs(1e9, 2e11, -3e9, 4e9, 5e10));
    let deck = written(&description);
    assert_eq!(deck.value("tip_mass"), 4000.0);
    assert_near(deck.value("cm_loc"), 0.3, 1e-14);
    assert_near(deck.value("cm_axial"), 1.5, 1e-14);
    // Reduced mass 750 kg: 750 (0.8² + 2²), 750 (0.4² + 2²), 750 (0.4² + 0.8²).
    assert_near(deck.value("ixx_tip"), 10.0 + 3480.0, 1e-12);
    assert_near(deck.value("iyy_tip"), 20.0 + 3120.0, 1e-12);
    assert_near(deck.value("izz_tip"), 30.0 + 600.0, 1e-12);
    deck.says("side-side offset of the tip mass: 0.6 m is left out");
    let mass = deck.matrix("hydro_M (", 6);
    let diagonal: Vec<f64> = (0..6).map(|i| mass[i][i]).collect();
    assert_eq!(diagonal, [1000.0, 1000.0, 1000.0, 10.0, 20.0, 30.0]);
    assert_eq!(deck.value("hub_conn"), 2.0);
    assert_eq!(deck.value("tow_support"), 2.0);
    assert_eq!(deck.value("draft"), 0.0);
    assert_eq!(deck.value("ref_msl"), 0.0);
    assert_eq!(deck.value("mass_pform"), 0.0);
    let springs = deck.matrix("mooring_K (", 6);
    assert_eq!(springs[0], [1e9, 0.0, 0.0, 0.0, -3e9, 0.0]);
    assert_eq!(springs[1], [0.0, 1e9, 0.0, 3e9, 0.0, 0.0]);
    let expected = (springs[2][2], springs[3][3], springs[4][4], springs[5][5]);
    assert_eq!(expected, (4e9, 2e11, 2e11, 5e10));
}

#[test]
fn bases_are_held_as_bmodes_can_say_it() {
    let springs = |lateral_n_per_m, rocking_n_m, vertical_n_per_m, torsion_n_m| TowerDescription {
        foundation: Foundation::Springs(FoundationSprings {
            lateral_n_per_m,
            rocking_n_m,
            coupling_n: 0.0,
            vertical_n_per_m,
            torsion_n_m,
        }),
        ..between(-20.0, 80.0)
    };
    let rigid = f64::INFINITY;
    let deck = written(&springs(1e9, 1e11, rigid, rigid));
    assert_eq!(deck.value("hub_conn"), 3.0);
    assert_eq!(deck.value("draft"), 20.0);
    assert_eq!(deck.value("radius"), 80.0);
    assert_eq!(deck.value("ref_msl"), 20.0);
    let matrix = deck.matrix("mooring_K (", 6);
    assert_eq!((matrix[1][1], matrix[2][2], matrix[5][5]), (1e9, 0.0, 0.0));
    let clamped = written(&springs(rigid, rigid, rigid, rigid));
    assert_eq!(clamped.value("hub_conn"), 1.0);
    assert_eq!(clamped.value("tow_support"), 2.0);
    let error = try_to_write(&springs(1e9, 1e11, rigid, 1e10)).expect_err("no hub_conn");
    error.says("rigidly held only in z");
    let error = try_to_write(&springs(rigid, 1e11, rigid, rigid)).expect_err("no hub_conn");
    error.says("only in x, y, z, rotation about z");
}

#[test]
fn matrices_and_footings_are_the_moorings_of_the_base() {
    let mut stiffness = [[0.0; 6]; 6];
    let mut inertia = [[0.0; 6]; 6];
    for i in 0..6 {
        stiffness[i][i] = 1e9 * (i + 1) as f64;
        inertia[i][i] = 1e5 * (i + 1) as f64;
    }
    (stiffness[0][4], stiffness[4][0]) = (-1.5e9, -1.5e9);
    let mut description = between(10.0, 90.0);
    description.foundation =
        Foundation::Stiffness(Box::new(StiffnessFoundation { stiffness, inertia }));
    let deck = written(&description);
    // A base above the datum has a negative draft, as on a platform above the sea.
    assert_eq!(deck.value("draft"), -10.0);
    assert_eq!(deck.value("ref_msl"), -10.0);
    assert_eq!(deck.value("hub_rad"), 0.0);
    let expected = stiffness.map(|row| row.to_vec());
    assert_eq!(deck.matrix("mooring_K (", 6), expected);
    assert_eq!(deck.matrix("hydro_M (", 6), inertia.map(|row| row.to_vec()));
    assert_eq!(deck.matrix("hydro_K (", 6), vec![vec![0.0; 6]; 6]);
    description.foundation = Foundation::HalfSpace(parts::half_space(8.0, 0.0, 5e7, 0.5));
    let matrix = written(&description).matrix("mooring_K (", 6);
    // 4GR/(1−ν) and 16GR³/3.
    assert_near(matrix[2][2], 3.2e9, 1e-14);
    assert_near(matrix[5][5], 16.0 * 5e7 * 512.0 / 3.0, 1e-14);
}

fn platform() -> FloatingPlatform {
    let diagonal = |entries: [f64; 6]| {
        let mut matrix = [[0.0; 6]; 6];
        for (i, entry) in entries.into_iter().enumerate() {
            matrix[i][i] = entry;
        }
        matrix
    };
    FloatingPlatform {
        added_mass_by_frequency: None,
        mass_kg: 7.5e6,
        center_m: [0.0, 0.0, -90.0],
        inertia_kg_m2: Inertia {
            xx: 4e9,
            yy: 4.1e9,
            zz: 1.6e8,
            xy: 0.0,
            xz: 2e6,
            yz: 0.0,
        },
        added_mass: ReferredMatrix {
            matrix: diagonal([8e6, 8e6, 2.4e5, 3.8e10, 3.8e10, 0.0]),
            height_m: 0.0,
        },
        hydrostatic: ReferredMatrix {
            matrix: diagonal([0.0, 0.0, 3.3e5, -5e9, -5e9, 0.0]),
            height_m: 0.0,
        },
        mooring: ReferredMatrix {
            matrix: diagonal([4e4, 5e4, 1.2e4, 3e8, 3e8, 1e8]),
            height_m: -70.0,
        },
        ..FloatingPlatform::default()
    }
}

#[test]
fn a_floating_platform_is_the_platform_of_the_deck() {
    let mut description = between(10.0, 90.0);
    description.foundation = Foundation::Floating(Box::new(platform()));
    let deck = written(&description);
    assert_eq!((deck.value("hub_conn"), deck.value("draft")), (2.0, -10.0));
    assert_eq!(deck.value("cm_pform"), 90.0);
    assert_eq!(deck.value("mass_pform"), 7.5e6);
    assert_eq!(deck.value("ref_msl"), 0.0);
    let inertia = deck.matrix("i_matrix_pform (", 3);
    let expected = [[4e9, 0.0, 2e6], [0.0, 4.1e9, 0.0], [2e6, 0.0, 1.6e8]];
    assert_eq!(inertia, expected);
    let expected = [8e6, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert_eq!(deck.matrix("hydro_M (", 6)[0], expected);
    assert_eq!(deck.matrix("hydro_K (", 6)[3][3], -5e9);
    // 70 m below the reference point: -k h and k h², with the sign of rotation about y and about x.
    let mooring = deck.matrix("mooring_K (", 6);
    assert_eq!(mooring[0], [4e4, 0.0, 0.0, 0.0, -2.8e6, 0.0]);
    assert_eq!(mooring[1], [0.0, 5e4, 0.0, 3.5e6, 0.0, 0.0]);
    assert_eq!(mooring[3][3], 3e8 + 5e4 * 4900.0);
    assert_eq!(mooring[4][4], 3e8 + 4e4 * 4900.0);
    deck.says("the matrix of mooring is transformed to the height 0 m");
}

#[test]
fn the_weights_hold_a_platform_upright() {
    let mut description = between(10.0, 90.0);
    // A tube without taper: its centre is at 50 m.
    description.stations[1] = Station::new(90.0, 6.0, 0.027);
    description.rna = Rna {
        mass_kg: 350e3,
        center_m: [0.0, 0.0, 2.0],
        inertia_kg_m2: Inertia::default(),
    };
    description.gravity_m_per_s2 = 10.0;
    description.foundation = Foundation::Floating(Box::new(platform()));
    let deck = written(&description);
    let tower_kg = 8500.0 * PI * 0.027 * (6.0 - 0.027) * 80.0;
    let weights = -10.0 * (7.5e6 * -90.0 + tower_kg * 50.0 + 350e3 * 92.0);
    let mooring = deck.matrix("mooring_K (", 6);
    assert_near(mooring[3][3], 3e8 + 5e4 * 4900.0 + weights, 1e-12);
    assert_near(mooring[4][4], 3e8 + 4e4 * 4900.0 + weights, 1e-12);
    deck.says(
        "BModes has no gravity (10 m/s2): the geometric stiffness of platform, tower and RNA",
    );
}

#[test]
fn a_platform_beside_the_axis_keeps_its_inertia() {
    let mut description = between(10.0, 90.0);
    let beside = FloatingPlatform {
        center_m: [2.0, -3.0, -90.0],
        added_mass: ReferredMatrix::default(),
        mooring: ReferredMatrix::default(),
        ..platform()
    };
    description.foundation = Foundation::Floating(Box::new(beside));
    let added = written(&description).matrix("hydro_M (", 6);
    let m = 7.5e6;
    // What the offset changes of the inertia about the reference point: moments m x, m y, and m
    // (y², x², x² + y²), -m x y, -m x z, -m y z.
    assert_eq!((added[0][5], added[1][5]), (m * 3.0, m * 2.0));
    assert_eq!((added[2][3], added[2][4]), (m * -3.0, m * -2.0));
    assert_eq!((added[0][4], added[1][3], added[0][0]), (0.0, 0.0, 0.0));
    assert_near(added[3][3], m * 9.0, 1e-6);
    assert_near(added[4][4], m * 4.0, 1e-6);
    assert_near(added[5][5], m * 13.0, 1e-12);
    assert_near(added[3][4], m * 6.0, 1e-12);
    assert_near(added[3][5], m * 180.0, 1e-12);
    assert_near(added[4][5], m * -270.0, 1e-12);
}

fn soil(height_m: f64, x: f64, y: f64, z: f64) -> SoilRow {
    SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2: x,
            y_n_per_m2: y,
            z_n_per_m2: z,
            ..SoilStiffness::default()
        },
    }
}

#[test]
fn soil_is_the_table_of_stiffness() {
    let mut description = between(-20.0, 80.0);
    description.soil = vec![
        vec![
            soil(-30.0, 3e8, 3e8, 0.0),
            soil(-10.0, 1e8, 1e8, 0.0),
            soil(0.0, 5e7, 5e7, 0.0),
        ],
        vec![soil(-15.0, 1e7, 1e7, 2e6), soil(0.0, 1e7, 1e7, 2e6)],
    ];
    let deck = written(&description);
    assert_eq!((deck.value("hub_conn"), deck.value("draft")), (1.0, 20.0));
    let rows = deck.table("k");
    let heights: Vec<f64> = rows.iter().map(|row| row.0).collect();
    assert_eq!(heights, [0.0, 5.0, 5.00001, 10.0, 20.0]);
    for ((_, value), expected) in rows.iter().zip([2e8, 1.5e8, 1.6e8, 1.1e8, 6e7]) {
        assert_near(*value, expected, 1e-12);
    }
    assert!(deck.table("m").is_empty());
    // 15 m of 2e6 N/m².
    deck.says("3e7 N/m and 0 N m, are left out");
    assert!(
        deck.borders()
            .iter()
            .any(|border| (border - 0.2).abs() < 1e-15)
    );
    description.foundation = Foundation::Springs(parts::springs(1e8, 1e10, 0.0, 1e9, 1e9));
    let deck = written(&description);
    assert_near(deck.matrix("mooring_K (", 6)[2][2], 1.03e9, 1e-12);
    deck.says("are written as springs of the base");
    description.soil[0][1].stiffness.y_n_per_m2 = 2e8;
    let error = try_to_write(&description).expect_err("soil that is not round");
    error.says("in x and");
}

#[test]
fn water_is_the_table_of_mass() {
    let mut description = between(-20.0, 80.0);
    description.stations[1].outer_diameter_m = 5.0;
    description.water = Some(parts::water(0.0, Some(-15.0), 1025.0, 1.0, false));
    let deck = written(&description);
    let rows = deck.table("m");
    assert_eq!((rows[0].0, rows[rows.len() - 1].0), (5.0, 20.0));
    for (height, value) in &rows {
        let d = 6.0 - height / 100.0;
        assert_near(*value, 1025.0 * PI / 4.0 * d * d, 1e-12);
    }
    assert!((2..50).contains(&rows.len()), "{}", rows.len());
    assert!(deck.table("k").is_empty());
}

#[test]
fn added_mass_is_in_the_table_of_mass() {
    let mut description = between(-20.0, 80.0);
    let added = |height_m, mass_kg_per_m| parts::added_mass_row(height_m, mass_kg_per_m);
    description.added_mass = vec![vec![added(-20.0, 3e4), added(0.0, 2e4)]];
    assert_eq!(written(&description).table("m"), [(0.0, 3e4), (20.0, 2e4)]);
}

fn wires(height_m: f64, angle_deg: f64) -> Wires {
    parts::wires(height_m, 4, 1.5e6, angle_deg)
}

#[test]
fn wires_on_land_are_at_nodes() {
    let mut description = tubes();
    description.wires = vec![wires(33.0, 45.0), wires(71.0, 60.0), wires(100.0, 0.0)];
    let deck = written(&description);
    let first = deck.record("tow_support");
    for (after, name) in [
        "n_attachments",
        "n_wires",
        "node_attach",
        "wire_stfness",
        "th_wire",
    ]
    .iter()
    .enumerate()
    {
        assert_eq!(deck.record(name), first + 2 + after);
    }
    assert_eq!(deck.value("tow_support"), 1.0);
    assert_eq!(deck.value("n_attachments"), 3.0);
    assert_eq!(deck.values("n_wires"), [4.0, 4.0, 4.0]);
    assert_eq!(deck.values("wire_stfness"), [1.5e6; 3]);
    assert_eq!(deck.values("th_wire"), [45.0, 60.0, 0.0]);
    let borders = deck.borders();
    let nodes = deck
        .values("node_attach")
        .into_iter()
        .map(|node| borders[node as usize - 1]);
    assert_eq!(nodes.collect::<Vec<f64>>(), [0.33, 0.71, 1.0]);
    deck.says("twice as much, and no vertical spring");
}

#[test]
fn wires_beside_springs_are_spread_like_soil() {
    let mut description = tubes();
    description.wires = vec![wires(50.0, 60.0), wires(100.0, 0.0), wires(0.0, 0.0)];
    description.foundation = Foundation::Springs(parts::springs(1e8, 1e10, 0.0, 1e9, 1e9));
    let deck = written(&description);
    assert_eq!(deck.value("tow_support"), 2.0);
    let rows = deck.table("k");
    // n/2 k cos² over half a metre.
    let (middle, top) = (2.0 * 1.5e6 * 0.25 / 0.5, 2.0 * 1.5e6 / 0.5);
    let expected = [
        (49.75, middle),
        (50.25, middle),
        (50.25001, 0.0),
        (99.5, 0.0),
        (99.50001, top),
        (100.0, top),
    ];
    assert_eq!(rows.len(), expected.len(), "{rows:?}");
    for (row, expected) in rows.iter().zip(expected) {
        assert_near(row.0, expected.0, 1e-13);
        assert!((row.1 - expected.1).abs() <= 1e-9 * top, "{row:?}");
    }
    let mooring = deck.matrix("mooring_K (", 6);
    assert_eq!(mooring[0][0], 1e8 + 3e6);
    // n k sin² of the first set.
    assert_near(mooring[2][2], 1e9 + 4.0 * 1.5e6 * 0.75, 1e-12);
    deck.says("the horizontal stiffness of set 1 of guy wires");
}

#[test]
fn a_tower_below_its_datum_is_moved_up() {
    let mut description = between(-120.0, -20.0);
    description.soil = vec![vec![
        soil(-120.0, 1e8, 1e8, 0.0),
        soil(-100.0, 1e8, 1e8, 0.0),
    ]];
    let deck = written(&description);
    assert_eq!((deck.value("radius"), deck.value("draft")), (100.0, 0.0));
    assert_eq!(deck.table("k"), [(0.0, 1e8), (20.0, 1e8)]);
    deck.says("heights are written from the base, shifted by 120 m");
}

fn any_tower() -> BoxedStrategy<TowerDescription> {
    // Heights that meet, nearly meet, and lie apart.
    let rise = prop_oneof![Just(0.0), 1e-9..1e-6, 0.1..50.0];
    let station = (rise, 2.0..9.0, 0.002..0.2);
    let stations = (-60.0..40.0, prop::collection::vec(station, 1..8));
    let mass = (0.0..=1.0, 0.0..1e5, 0.0..1e6).boxed();
    let masses = prop::collection::vec(mass, 0..4);
    let sets = prop::collection::vec((0.0..=1.0, 0.0..=90.0), 0..3);
    let foundation = prop_oneof![
        Just(Foundation::Clamped),
        (1e7..1e9, 1e9..1e11).prop_map(|(lateral_n_per_m, rocking_n_m)| {
            Foundation::Springs(parts::springs(
                lateral_n_per_m,
                rocking_n_m,
                0.0,
                1e9,
                f64::INFINITY,
            ))
        }),
        Just(Foundation::Springs(changed!(
            FoundationSprings::RIGID,
            lateral_n_per_m = 1e8
        ))),
        Just(Foundation::Floating(Box::new(platform()))),
    ];
    (stations, masses, sets, foundation, 0.0..=1.0)
        .prop_map(|((base_m, rises), masses, sets, foundation, level)| {
            let mut height_m = base_m;
            let mut stations = vec![Station::new(base_m, 5.0, 0.03)];
            for (rise, diameter, wall) in rises {
                height_m += rise;
                stations.push(Station::new(height_m, diameter, wall));
            }
            let top_m = height_m + 20.0;
            stations.push(Station::new(top_m, 4.0, 0.02));
            let at = |share: f64| base_m + share * (top_m - base_m);
            let mass = |(share, mass_kg, zz): (f64, f64, f64)| {
                parts::point_mass(at(share).min(top_m), mass_kg, with!(Inertia, zz))
            };
            TowerDescription {
                stations,
                point_masses: masses.into_iter().map(mass).collect(),
                wires: sets
                    .into_iter()
                    .map(|(share, angle)| wires(at(share).min(top_m), angle))
                    .collect(),
                soil: vec![vec![
                    soil(base_m, 1e8, 1e8, 1e6),
                    soil(at(0.5), 0.0, 0.0, 0.0),
                ]],
                water: (level > 0.2).then(|| parts::water(at(level), None, 1025.0, 1.0, true)),
                foundation,
                ..tubes()
            }
        })
        .boxed()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn decks_of_any_tower_are_in_order(description in any_tower()) {
        // Some are refused: a height three times, or held as BModes cannot say it.
        if let Ok(tower) = Tower::new(description.clone())
            && let Ok(files) = write_bmodes(&tower, &description, &BmodesWriteOptions::default())
        {
            let deck = Deck::of(&files);
            for table in [deck.table("k"), deck.table("m")] {
                for &(height, value) in &table {
                    prop_assert!(height >= 0.0 && value >= 0.0 && value.is_finite());
                    prop_assert!(tower.base_m() + height <= tower.top_m());
                }
                prop_assert!(table.windows(2).all(|pair| pair[0].0 < pair[1].0), "{:?}", table);
            }
            let nan = files.deck.contains("NaN") || files.sections.contains("NaN");
            prop_assert!(!nan && !files.deck.contains("inf"));
        }
    }
}

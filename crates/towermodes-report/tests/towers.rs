//! Pictures of towers that are unlike any example: large, small, with many stations, masses and
//! modes.

use crate::pictures;

use pictures::{EXAMPLES, check, example, keep, look, plain, solved, steel};
use towermodes::{
    Family, Inertia, Mode, Options, PointMass, Rna, Station, Tower, TowerDescription, solve,
};
use towermodes_report::figures;
use towermodes_report::svg::Look;
use towermodes_testing::{Says, parts, stations, with};

#[test]
fn any_number_of_modes() {
    for name in EXAMPLES {
        for modes in [1, 2, 5, 15, 30] {
            let (description, tower, solution) = example(name, modes);
            let figure = figures::shapes(&description, &tower, &solution);
            check(&format!("{name}, {modes} modes"), &figure);
            keep(&format!("{name} {modes}"), &[figure]);
        }
    }
}

#[test]
fn few_and_many_stations() {
    look("one pair", &plain(), 8);
    let rows = (0..2000).map(|k| {
        let share = f64::from(k) / 1999.0;
        let ripple = 0.2 * (40.0 * share).sin();
        Station::new(
            150.0 * share,
            8.0 - 3.0 * share + ripple,
            0.06 - 0.03 * share,
        )
    });
    look("2000 stations", &steel(rows.collect()), 8);
}

#[test]
fn thin_walls_high_towers_small_towers() {
    let thin = stations(&[(0.0, 6.0, 0.001), (300.0, 4.0, 0.001)]);
    look("300 m of 1 mm", &steel(thin), 10);
    let small = stations(&[(0.0, 0.05, 0.002), (0.8, 0.04, 0.002)]);
    look("0.8 m", &steel(small), 6);
    let squat = stations(&[(0.0, 12.0, 0.05), (10.0, 12.0, 0.05)]);
    look("10 m wide", &steel(squat), 8);
    let deep = stations(&[(-60.0, 9.0, 0.09), (120.0, 5.0, 0.03)]);
    look("base at minus 60", &steel(deep), 8);
    let rod = stations(&[(1e6, 1.0, 0.5), (1e6 + 30.0, 1.0, 0.5)]);
    look("a rod far up", &steel(rod), 4);
}

#[test]
fn rnas_that_hang_over() {
    for (what, center_m) in [
        ("RNA before", [-20.0, 0.0, 3.0]),
        ("RNA above", [0.0, 0.0, 20.0]),
        ("RNA below", [0.0, 0.0, -5.0]),
        ("RNA beside", [6.0, 9.0, 2.0]),
        ("RNA far away", [500.0, 0.0, 0.0]),
    ] {
        let description = TowerDescription {
            rna: Rna {
                mass_kg: 200e3,
                center_m,
                inertia_kg_m2: with!(Inertia, xx = 2e7, yy = 1e7, zz = 1.5e7),
            },
            ..plain()
        };
        look(what, &description, 12);
    }
}

#[test]
fn very_many_masses() {
    let mass = |k: u32| PointMass {
        height_m: 87.6 * f64::from(k) / 499.0,
        mass_kg: 10.0 + f64::from(k),
        ..PointMass::default()
    };
    let description = TowerDescription {
        point_masses: (0..500).map(mass).collect(),
        rna: Rna::point(100e3),
        ..plain()
    };
    look("500 masses", &description, 8);
}

#[test]
fn what_moves_in_all_directions_at_once() {
    // An RNA far off in x and y couples everything.
    let description = TowerDescription {
        rna: Rna {
            mass_kg: 200e3,
            center_m: [3.0, 3.0, 1.0],
            inertia_kg_m2: Inertia {
                xx: 3e7,
                yy: 3e7,
                zz: 3e7,
                xy: -1e7,
                xz: 5e6,
                yz: 5e6,
            },
        },
        ..plain()
    };
    look("coupled", &description, 30);
}

/// An RNA beside the tower in y couples fore-aft bending with torsion alone, one in front of it
/// side-side bending with torsion: the panel of the direction that does not move would be empty.
#[test]
fn coupled_modes_have_the_panels_in_which_they_move() {
    for (center_m, moving, still) in [
        ([0.0, 6.0, 0.0], "coupled: x", "coupled: y"),
        ([6.0, 0.0, 0.0], "coupled: y", "coupled: x"),
    ] {
        let description = TowerDescription {
            rna: Rna {
                mass_kg: 350e3,
                center_m,
                // So much about z that torsion is as slow as bending.
                inertia_kg_m2: with!(Inertia, xx = 3.5e8, yy = 3.5e8, zz = 6.9e8),
            },
            ..plain()
        };
        let tower = Tower::new(description.clone()).expect("a tower");
        let solution = solved(&tower, 10);
        let coupled = |mode: &Mode| mode.is_coupled();
        let holds = solution.modes.iter().any(coupled);
        assert!(holds, "{center_m:?} couples nothing");
        let figure = figures::shapes(&description, &tower, &solution);
        check(moving, &figure);
        let says = |text: &str| figure.labels().iter().any(|label| label.text == text);
        assert!(says(moving) && says("coupled: rotation z"), "{center_m:?}");
        assert!(!says(still), "{still} is empty");
        let rows = figure.table.rows.iter();
        let parts: Vec<&str> = rows.map(|row| row[2].as_str()).collect();
        assert!(parts.contains(&"rotation z"), "{parts:?}");
    }
}

#[test]
fn the_table_has_the_shapes_of_a_uniform_cantilever() {
    let uniform = steel(stations(&[(0.0, 1.0, 0.01), (100.0, 1.0, 0.01)]));
    let tower = Tower::new(uniform.clone()).expect("a tower");
    let options = with!(Options, modes = 20, rotary_inertia = false);
    let solution = solve(&tower, &options).expect("its modes");
    let figure = figures::shapes(&uniform, &tower, &solution);
    let half = figure
        .table
        .header
        .iter()
        .position(|name| name == "z = 50 m");
    let half = half.expect("a column of half the height");
    let at_half = |mode: &str| {
        let row = figure.table.rows.iter().find(|row| row[0] == mode);
        row.map(|row| row[half].as_str())
    };
    // cosh λs − cos λs − σ (sinh λs − sin λs) at s = 1/2 over its value at 1, λ = 1.8751 and
    // 4.6941: 0.33952 and −0.71366; sin π/4 = 0.70711 twists and stretches.
    assert_eq!(at_half("1st fore-aft bending"), Some("0.34"));
    assert_eq!(at_half("2nd fore-aft bending"), Some("\u{2212}0.714"));
    assert_eq!(at_half("2nd side-side bending"), Some("\u{2212}0.714"));
    assert_eq!(at_half("1st torsion"), Some("0.707"));
    let texts: Vec<&str> = figure
        .labels()
        .iter()
        .map(|label| label.text.as_str())
        .collect();
    assert!(texts.contains(&"side-side: as fore-aft"), "{texts:?}");
    assert!(!texts.contains(&"side-side"));
    let bending = solution
        .modes
        .iter()
        .filter(|mode| mode.family == Family::ForeAft)
        .count();
    let more = format!("{} more", bending - 6);
    assert!(texts.contains(&more.as_str()), "{texts:?}");
}

#[test]
fn the_same_tower_gives_the_same_picture() {
    let (description, tower, solution) = example("monopile.toml", 8);
    let svg = || {
        let tower = figures::tower(&description, &tower).to_svg(Look::Standalone);
        tower
            + &figures::shapes(&description, &tower_of(&description), &solution)
                .to_svg(Look::Standalone)
    };
    assert_eq!(svg(), svg());
}

fn tower_of(description: &TowerDescription) -> Tower {
    Tower::new(description.clone()).expect("a tower")
}

/// Wires at 80 m that go down at 20 degrees meet the ground 80/tan 20 = 220 m away, far beyond the
/// picture.
#[test]
fn wires_beyond_the_picture_are_cut_and_what_is_left_out_is_named() {
    let mut description = plain();
    description.wires = vec![parts::wires(80.0, 3, 1e6, 20.0)];
    let masses = (0..100).map(|k| with!(PointMass, height_m = 0.8 * f64::from(k), mass_kg = 10.0));
    description.point_masses = masses.collect();
    let tower = Tower::new(description.clone()).expect("a tower");
    let figure = figures::tower(&description, &tower);
    check("cut wires", &figure);
    let said: Vec<&str> = figure.labels().iter().map(|l| l.text.as_str()).collect();
    let cut = "shortened in the picture: anchors 220 m away";
    assert!(said.contains(&cut), "{said:?}");
    let note = said
        .iter()
        .find(|text| text.starts_with("Heights to scale"));
    let note = note.expect("a note");
    note.says("Masses at ");
    note.says(" more heights");
    assert!(!note.contains("table"));
}

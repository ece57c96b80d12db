//! What a format cannot hold is said: each thing that a description can have comes back, or a note
//! names it.

use towermodes::{
    FloatingPlatform, Foundation, Inertia, Planes, PointMass, Properties, Rna, Shear, SoilRow,
    SoilStiffness, Station, TowerDescription, Water,
};
use towermodes_testing::{parts, rotor, with};

use super::comparison::{alone, bending_hz, frequencies_hz, largest_difference};
use super::formats::{Target, tower, written};
use super::towers::{
    axially_held, example, flooded, on_half_space, plain, several_materials, stepped, table,
    unequal_planes, wired, with_masses,
};

/// What becomes of a thing in a format.
#[derive(Debug, Clone, Copy)]
enum Fate {
    /// It comes back, and changes frequencies as it did.
    Kept,
    /// A note with these words, which is not there without it.
    Said(&'static str),
    /// A note with these words, which is always there.
    AlwaysSaid(&'static str),
}

use Fate::{AlwaysSaid, Kept, Said};

/// A tower with a thing and the same without it, and what becomes of it in BModes, ElastoDyn and
/// windIO; TOML keeps everything.
struct Case {
    what: &'static str,
    with: TowerDescription,
    without: TowerDescription,
    fates: [Fate; 3],
}

/// Of a plain tower.
fn plain_with(
    what: &'static str,
    fates: [Fate; 3],
    change: impl Fn(&mut TowerDescription),
) -> Case {
    of(plain(), what, fates, change)
}

fn of(
    without: TowerDescription,
    what: &'static str,
    fates: [Fate; 3],
    change: impl Fn(&mut TowerDescription),
) -> Case {
    let mut with = without.clone();
    change(&mut with);
    Case {
        what,
        with,
        without,
        fates,
    }
}

const LEFT_IN_MAIN_FILE: Fate = Said("the rotor-nacelle assembly, which is in the main file");
const MACHINE: Fate = AlwaysSaid("the rotor-nacelle assembly, which is in the main file");
const FOUNDATION: [Fate; 3] = [
    Kept,
    Said("the foundation, whose motion"),
    Said("the foundation is left out"),
];

fn tubes() -> Vec<Case> {
    let two = |mut description: TowerDescription| {
        let last = description.stations.len() - 1;
        description.stations = vec![description.stations[0], description.stations[last]];
        description
    };
    vec![
        of(two(stepped()), "steps", [Kept; 3], |d| {
            d.stations = stepped().stations;
        }),
        of(two(several_materials()), "materials", [Kept; 3], |d| {
            d.stations = several_materials().stations;
        }),
        plain_with("outfitting", [Kept; 3], |d| d.outfitting_factor = 1.2),
        plain_with(
            "shear",
            [
                Said("no shear deformation"),
                Said("shear deformation"),
                Said("the shear model"),
            ],
            |d| d.shear = Shear::Cowper,
        ),
        plain_with(
            "shear coefficient",
            [
                Said("no shear deformation"),
                Said("shear deformation"),
                Said("the shear model"),
            ],
            |d| d.shear = Shear::Coefficient(0.4),
        ),
        plain_with(
            "gravity",
            [Said("no gravity"), Said("gravity"), Said("gravity")],
            |d| d.gravity_m_per_s2 = 9.81,
        ),
        plain_with("a tower of other heights", [Kept; 3], |d| {
            d.stations[1] = Station::new(93.0, 3.9, 0.022);
        }),
    ]
}

fn masses() -> Vec<Case> {
    let inertia = with!(Inertia, xx = 5e7, yy = 5e7, zz = 5e7);
    let machine = |d: &mut TowerDescription| d.rna.inertia_kg_m2.yz = -9e6;
    let mut alone = plain();
    alone.rna = Rna::default();
    vec![
        plain_with("point masses", [Kept; 3], |d| {
            d.point_masses = with_masses().point_masses;
        }),
        plain_with("a mass at the top", [Kept; 3], |d| {
            d.point_masses.push(mass(90.0, 2e4));
        }),
        of(
            with_masses(),
            "inertia of a mass",
            [
                Said("only zz of its inertia is kept"),
                Said("the inertias of point masses"),
                Said("the inertias of point masses"),
            ],
            |d| d.point_masses[0].inertia_kg_m2 = inertia,
        ),
        of(alone, "a machine", [Kept, LEFT_IN_MAIN_FILE, Kept], |d| {
            d.rna = plain().rna;
        }),
        plain_with("the machine's height", [Kept, MACHINE, Kept], |d| {
            d.rna.center_m[2] = 4.0;
        }),
        plain_with("the machine's offset", [Kept, MACHINE, Kept], |d| {
            d.rna.center_m[0] = -4.0;
        }),
        plain_with(
            "the machine's offset to the side",
            [Said("no side-side offset"), MACHINE, Kept],
            |d| d.rna.center_m[1] = 2.0,
        ),
        plain_with("the machine's products", [Kept, MACHINE, Kept], machine),
        plain_with("the machine's inertia", [Kept, MACHINE, Kept], |d| {
            d.rna.inertia_kg_m2.zz = 4e7;
        }),
    ]
}

fn mass(height_m: f64, mass_kg: f64) -> PointMass {
    with!(PointMass, height_m, mass_kg)
}

fn tables() -> Vec<Case> {
    let each = |change: fn(&mut Properties)| {
        move |d: &mut TowerDescription| {
            for row in &mut d.properties {
                change(&mut row.properties);
            }
        }
    };
    let rotary_said = [
        Said("the rotary inertia differs from half the polar inertia"),
        AlwaysSaid("rotary inertia"),
        Kept,
    ];
    vec![
        of(table(), "planes", [Kept; 3], |d| {
            d.properties = unequal_planes().properties;
        }),
        of(
            table(),
            "shear of a table",
            [
                Said("no shear deformation"),
                Said("shear deformation"),
                Kept,
            ],
            each(|p| p.shear_n = Some(Planes::both(0.1 * p.axial_n))),
        ),
        of(
            table(),
            "other rotary inertia",
            rotary_said,
            each(|p| p.rotary_inertia_kg_m = Planes::both(4.0 * p.polar_inertia_kg_m)),
        ),
        of(
            table(),
            "no rotary inertia",
            rotary_said,
            each(|p| p.rotary_inertia_kg_m = Planes::both(0.0)),
        ),
        of(
            table(),
            "no rotary inertia in one plane",
            rotary_said,
            each(|p| p.rotary_inertia_kg_m.fore_aft = 0.0),
        ),
        of(
            table(),
            "no twist",
            [Said("rigid in torsion"), AlwaysSaid("torsion"), Kept],
            each(|p| p.torsion_n_m2 = f64::INFINITY),
        ),
        of(
            table(),
            "no stretch",
            [Said("axially rigid"), AlwaysSaid("axial motion"), Kept],
            each(|p| p.axial_n = f64::INFINITY),
        ),
    ]
}

fn grounds() -> Vec<Case> {
    let springs = |coupling_n| Foundation::Springs(parts::springs(3e8, 3e10, coupling_n, 3e9, 4e9));
    let mut on_springs = plain();
    on_springs.foundation = springs(0.0);
    vec![
        plain_with("springs", FOUNDATION, |d| d.foundation = springs(0.0)),
        of(
            on_springs,
            "coupling of springs",
            [
                Kept,
                AlwaysSaid("the foundation, whose motion"),
                AlwaysSaid("the foundation is left out"),
            ],
            |d| d.foundation = springs(-1.5e9),
        ),
        plain_with("half-space", FOUNDATION, |d| {
            d.foundation = on_half_space().foundation;
        }),
        plain_with("matrices", FOUNDATION, |d| {
            d.foundation = axially_held().foundation;
        }),
        plain_with("floating", FOUNDATION, |d| {
            d.foundation = Foundation::Floating(Box::new(platform()));
        }),
    ]
}

/// A platform that is upright without its weights.
fn platform() -> FloatingPlatform {
    let Foundation::Floating(mut platform) = example("floating").foundation else {
        panic!("a floating tower");
    };
    platform.hydrostatic.matrix[3][3] = 2e9;
    platform.hydrostatic.matrix[4][4] = 2e9;
    *platform
}

fn surroundings() -> Vec<Case> {
    let soil = |stiffness: SoilStiffness| {
        let row = |height_m| SoilRow {
            height_m,
            stiffness,
        };
        vec![row(0.0), row(20.0)]
    };
    let along = with!(SoilStiffness, z_n_per_m2 = 1e9);
    let twist = with!(SoilStiffness, torsion_n = 1e10);
    let across = with!(SoilStiffness, x_n_per_m2 = 3e7, y_n_per_m2 = 3e7);
    let soil_said = |bmodes| [bmodes, Said("the soil"), Said("the soil")];
    let lost = Said("no vertical and no torsional springs");
    let mut by_the_sea = plain();
    by_the_sea.stations = flooded().stations;
    let growth = |height_m| parts::added_mass_row(height_m, 3e3);
    let dry = |bmodes| [bmodes, Said("the water"), Said("the water")];
    vec![
        plain_with("soil", soil_said(Kept), |d| d.soil = vec![soil(across)]),
        plain_with("soil along", soil_said(lost), |d| {
            d.soil = vec![soil(along)];
        }),
        plain_with("soil's twist", soil_said(lost), |d| {
            d.soil = vec![soil(twist)];
        }),
        of(by_the_sea.clone(), "water", dry(Kept), |d| {
            d.water = flooded().water;
        }),
        of(by_the_sea, "water outside", dry(Kept), |d| {
            d.water = flooded().water.map(|water| Water {
                flooded: false,
                added_mass_coefficient: 1.5,
                ..water
            });
        }),
        plain_with(
            "added mass",
            [Kept, Said("the water's mass"), Said("the added mass")],
            |d| d.added_mass = vec![vec![growth(10.0), growth(80.0)]],
        ),
        plain_with(
            "wires",
            [Kept, Said("the guy wires"), Said("the guy wires")],
            |d| {
                d.wires = wired().wires;
            },
        ),
    ]
}

/// Whether what comes back has the frequencies of what was written, as far as the format has them
/// at all.
fn difference(target: Target, one: &TowerDescription, other: &TowerDescription) -> f64 {
    match target {
        Target::ElastoDyn => {
            let [one, other] =
                [one, other].map(|description| bending_hz(&tower(&alone(description))));
            largest_difference(&one, &other)
        }
        _ => {
            let [one, other] = [one, other].map(|description| frequencies_hz(&tower(description)));
            largest_difference(&one, &other)
        }
    }
}

/// What is kept matters more than this, and comes back nearer than that.
const MATTERS: f64 = 3e-4;
const NEAR: f64 = 1e-5;

fn check(case: &Case, target: Target, fate: Fate) {
    let what = format!("{} in {target:?}", case.what);
    let writing = written(&case.with, target);
    let read = writing.read();
    let notes = writing.notes.iter().map(|note| note.message.as_str());
    let notes: Vec<&str> = notes.collect();
    let has = |notes: &[&str], words: &str| notes.iter().any(|note| note.contains(words));
    match fate {
        Kept => {
            let matters = difference(target, &case.with, &case.without);
            assert!(matters > MATTERS, "{what} does not matter: {matters:e}");
            let off = difference(target, &read.description, &case.with);
            assert!(off <= NEAR, "{what}: {off:e}, {notes:?}");
        }
        Said(words) => {
            assert!(has(&notes, words), "{what}: {notes:?}");
            let without = written(&case.without, target);
            let others = without.notes.iter().map(|note| note.message.as_str());
            let others: Vec<&str> = others.collect();
            assert!(!has(&others, words), "{what}, without it: {others:?}");
        }
        AlwaysSaid(words) => assert!(has(&notes, words), "{what}: {notes:?}"),
    }
}

#[test]
fn all_things_of_a_tower_come_back_or_are_said() {
    let cases = [tubes(), masses(), tables(), grounds(), surroundings()];
    for case in cases.iter().flatten() {
        let again = written(&case.with, Target::Toml).read();
        assert_eq!(again.description, case.with, "{}", case.what);
        assert_ne!(again.description, case.without, "{}", case.what);
        let others = [Target::Bmodes, Target::ElastoDyn, Target::WindIo];
        for (target, fate) in others.into_iter().zip(case.fates) {
            check(case, target, fate);
        }
    }
}

/// It changes no frequency, so it is compared itself.
#[test]
fn a_rotor_comes_back_or_is_said() {
    for (lowest_rpm, highest_rpm) in [(6.9, 12.1), (17.0, 17.0)] {
        let mut description = plain();
        description.rotor = Some(rotor(2, lowest_rpm, highest_rpm));
        for target in Target::ALL {
            let writing = written(&description, target);
            let read = writing.read().description.rotor;
            let said = match target {
                Target::Toml | Target::WindIo => {
                    assert_eq!(read, description.rotor, "{target:?}");
                    continue;
                }
                Target::Bmodes => "a tower deck has no rotor: its 2 blades",
                Target::ElastoDyn => "the rotor, which is in the main file",
            };
            assert_eq!(read, None, "{target:?}");
            let has = |notes: &[towermodes_files::Note]| {
                notes.iter().any(|note| note.message.contains(said))
            };
            assert!(has(&writing.notes), "{target:?}: {:?}", writing.notes);
            assert!(!has(&written(&plain(), target).notes), "{target:?}");
        }
    }
}

#[test]
fn names_come_back() {
    let mut description = plain();
    description.name = "Tower \"A\", TowerHt = 50 m, TowerBsHt = 3 m".into();
    for target in Target::ALL {
        let read = written(&description, target).read().description;
        assert_eq!(read.name, description.name, "{target:?}");
        // Not those that the name speaks of.
        assert_eq!(tower(&read).top_m(), 90.0, "{target:?}");
        assert_eq!(tower(&read).base_m(), 0.0, "{target:?}");
    }
}

//! What is written as TOML is read back as the same description, number by number.

use proptest::prelude::*;
use std::sync::Arc;

use towermodes::{
    AddedMassRow, AddedMassTable, BeamFormula, Buoyancy, CircularFooting, FloatingPlatform,
    FootingFormula, Foundation, FoundationSprings, HalfSpace, Inertia, Material, Monopile,
    PartNames, PileFormula, PileTube, Planes, Properties, PropertyStation, RectangularFooting,
    ReferredMatrix, Rna, Shear, SoilProfile, SoilRow, SoilSpring, SoilStiffness, Station,
    StiffnessFoundation, SuctionCaisson, TowerDescription, Water, WinklerPile, Wires,
};
use towermodes_files::{description_from_toml, tower_from_toml, write_toml};
use towermodes_testing::{Says, changed, line_and_column, parts, rotor, rows, tube, with};

/// Writes, reads again, compares; gives the text.
#[track_caller]
fn comes_back(description: &TowerDescription) -> String {
    let (text, notes) = write_toml(description);
    assert!(notes.is_empty(), "{notes:?}");
    let read = match description_from_toml(&text) {
        Ok(read) => read,
        Err(mistakes) => panic!("{mistakes:?}\n{text}"),
    };
    assert_eq!(&read, description, "\n{text}");
    text
}

fn tubes() -> TowerDescription {
    tube(&[(0.0, 6.0, 0.027), (87.6, 3.87, 0.019)])
}

/// How a material is given decides what a change of Young's modulus does.
#[test]
fn a_material_given_by_poissons_ratio_is_written_by_it() {
    for ratio in [0.0, 0.2, 0.3, 0.1 + 0.2, 0.49999] {
        let description = TowerDescription {
            materials: vec![Material::from_poissons_ratio(7850.0, 2.05e11, ratio)],
            ..tubes()
        };
        let text = comes_back(&description);
        text.says("poissons_ratio = ");
        assert!(!text.contains("shear_modulus = "), "{text}");
    }
    // Another shear modulus than that of the ratio is kept.
    let description = TowerDescription {
        materials: vec![Material {
            shear_modulus_pa: 8e10,
            ..Material::from_poissons_ratio(7850.0, 2.05e11, 0.3)
        }],
        ..tubes()
    };
    let (text, _) = write_toml(&description);
    text.says("shear_modulus = ");
}

fn row(height_m: f64, size: f64) -> PropertyStation {
    PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: 5000.0 * size,
            rotary_inertia_kg_m: Planes::both(2.5e4 * size),
            polar_inertia_kg_m: 5e4 * size,
            bending_n_m2: Planes::both(6.1e11 * size),
            torsion_n_m2: 4.7e11 * size,
            axial_n: 1.4e11 * size,
            shear_n: None,
        },
    }
}

fn table() -> TowerDescription {
    TowerDescription {
        properties: vec![row(0.0, 1.0), row(40.0, 0.7), row(90.0, 0.3)],
        ..TowerDescription::default()
    }
}

/// A matrix without any symmetry, every entry different.
fn full_matrix(unit: f64) -> [[f64; 6]; 6] {
    std::array::from_fn(|i| std::array::from_fn(|j| unit * (1.0 + i as f64 / 7.0 - j as f64 / 3.0)))
}

/// The table of added mass has the upper triangles alone.
fn symmetric_matrix(unit: f64) -> [[f64; 6]; 6] {
    std::array::from_fn(|i| std::array::from_fn(|j| unit / (1.0 + (i + j) as f64)))
}

#[test]
fn every_example() {
    let examples = [
        include_str!("../../../examples/reference-tower.toml"),
        include_str!("../../../examples/reference-tower-350t.toml"),
        include_str!("../../../examples/nrel-5mw.toml"),
        include_str!("../../../examples/nrel-5mw-table.toml"),
        include_str!("../../../examples/monopile.toml"),
        include_str!("../../../examples/floating.toml"),
        include_str!("../../../examples/floating-lines.toml"),
        include_str!("../../../examples/jacket.toml"),
        include_str!("../../../examples/guyed.toml"),
    ];
    for example in examples {
        let text = comes_back(&description_from_toml(example).expect("an example"));
        assert_eq!(tower_from_toml(&text), tower_from_toml(example));
    }
}

#[test]
fn a_rotor_of_one_speed_has_one_number() {
    let mut description = tubes();
    description.rotor = Some(rotor(2, 18.0, 18.0));
    let text = comes_back(&description);
    text.says("rpm = 18.0");
    description.rotor = Some(rotor(3, 6.9, 12.1));
    let text = comes_back(&description);
    text.says("rpm = [6.9, 12.1]");
}

#[test]
fn a_plain_tower_is_a_plain_file() {
    let text = comes_back(&tubes());
    let expected = "
[material]
density = 8500.0               # kg/m3
youngs_modulus = 2.1e11        # Pa
shear_modulus = 8.08e10        # Pa

[tower]
stations = [  # height, outer diameter, wall thickness, all in m
  [ 0.0,  6.0, 0.027],
  [87.6, 3.87, 0.019],
]
";
    let (head, rest) = text.split_once('\n').expect("several lines");
    head.begins("# A tower for towermodes.");
    assert_eq!(rest, expected);
}

#[test]
fn names_of_any_characters() {
    for name in [
        "plain",
        "with \"quotes\" and 'others'",
        "a\\b\\\\",
        "two\nlines\r\nand\ttabs",
        "Grüße ✓ \u{1F300} \u{202E}",
        "\u{0}\u{1}\u{1b}\u{7f}\u{85}",
        "\"\"\"",
        " # no comment = [x]",
        " ",
    ] {
        comes_back(&changed!(tubes(), name = name.into()));
    }
}

/// Names of parts are written as they are read; those that no file has in this order are numbers.
#[test]
fn parts_keep_their_names() {
    let steel = Material::from_poissons_ratio(7850.0, 2.1e11, 0.3);
    let named = |names: [&str; 2]| TowerDescription {
        materials: vec![steel; 2],
        stations: vec![
            Station::new(0.0, 5.0, 0.03),
            changed!(Station::new(30.0, 5.0, 0.03), material = 1),
            changed!(Station::new(80.0, 4.0, 0.02), material = 1),
        ],
        part_names: with!(PartNames, materials = names.map(str::to_owned).to_vec()),
        ..TowerDescription::default()
    };
    let text = comes_back(&named(["concrete", "steel S355 \"new\""]));
    text.says("[materials.concrete]");
    text.says(r#"[materials."steel S355 \"new\""]"#);
    let text = comes_back(&named(["", "steel"]));
    text.says("[material]\n");
    let (text, _) = write_toml(&named(["steel", "concrete"]));
    text.says("[materials.material_1]");
    let mut one = tubes();
    one.part_names.materials = vec!["steel".to_owned()];
    comes_back(&one).says("[materials.steel]");
}

#[test]
fn a_dozen_materials_keep_their_order() {
    let materials =
        (0..12).map(|i| Material::from_poissons_ratio(7000.0 + f64::from(i), 2e11, 0.3));
    let description = TowerDescription {
        materials: materials.collect(),
        stations: (0..12)
            .map(|material| Station {
                material: 11 - material,
                ..Station::new(material as f64 * 10.1, 5.0, 0.03)
            })
            .collect(),
        outfitting_factor: 1.07,
        shear: Shear::Cowper,
        ..TowerDescription::default()
    };
    comes_back(&description).says("[materials.material_02]");
}

#[test]
fn shear_coefficients_masses_and_the_machine() {
    let inertia = Inertia {
        xx: 4.37e7,
        yy: 2.353e7,
        zz: 2.542e7,
        xy: -12.5,
        xz: 1.169e6,
        yz: 0.125,
    };
    let description = TowerDescription {
        shear: Shear::Coefficient(0.53),
        rna: Rna {
            mass_kg: 350_000.25,
            center_m: [-0.4137754432, 0.0, 1.9669893542],
            inertia_kg_m2: inertia,
        },
        point_masses: vec![
            parts::point_mass(40.0, 5000.0, Inertia::default()),
            parts::point_mass(20.0, 1e-9, Inertia { zz: 3.0, ..inertia }),
        ],
        gravity_m_per_s2: 9.81,
        ..tubes()
    };
    comes_back(&description);
    comes_back(&changed!(tubes(), rna = Rna::point(1.0 / 3.0)));
}

#[test]
fn every_foundation() {
    let springs = |lateral_n_per_m, coupling_n, vertical_n_per_m| {
        Foundation::Springs(FoundationSprings {
            lateral_n_per_m,
            rocking_n_m: 2.5e11,
            coupling_n,
            vertical_n_per_m,
            torsion_n_m: 0.0,
        })
    };
    let referred = |unit, height_m| ReferredMatrix {
        matrix: full_matrix(unit),
        height_m,
    };
    let platform = FloatingPlatform {
        mass_kg: 7_466_330.0,
        center_m: [0.0, 0.25, -89.9155],
        inertia_kg_m2: with!(Inertia, xx = 4.22923e9, yy = 4.22923e9, zz = 0.0),
        added_mass: referred(8e6, -10.0),
        added_mass_by_frequency: None,
        hydrostatic: with!(ReferredMatrix, height_m = 3.0),
        buoyancy: Some(Buoyancy {
            force_n: 8.07e7,
            center_m: [0.0, -0.25],
        }),
        mooring: referred(4e4, -70.0),
        mooring_lines: None,
        at_equilibrium: false,
    };
    let of_stiffness = |inertia| {
        Foundation::Stiffness(Box::new(StiffnessFoundation {
            stiffness: full_matrix(1e9),
            inertia,
        }))
    };
    let foundations = [
        Foundation::Clamped,
        of_stiffness([[0.0; 6]; 6]),
        of_stiffness(full_matrix(1e5)),
        Foundation::Springs(FoundationSprings::RIGID),
        springs(1e8, 0.0, f64::INFINITY),
        springs(2.5748e9, -2.25325e10, 1e10),
        Foundation::HalfSpace(parts::half_space(8.0, 0.0, 5e7, 0.35)),
        Foundation::HalfSpace(parts::half_space(8.0, 1.5, 5e7, 0.0)),
        monopile(PileFormula::ShadlouBhattacharya, SoilProfile::Parabolic),
        circular_footing(0.0, f64::INFINITY, f64::INFINITY),
        circular_footing(2.5, 21.0, f64::INFINITY),
        circular_footing(0.0, 21.0, 6e8),
        circular_footing(0.0, f64::INFINITY, 6e8),
        Foundation::RectangularFooting(Box::new(RectangularFooting {
            formula: FootingFormula::PaisKausel,
            length_x_m: 18.0,
            length_y_m: 14.5,
            embedment_m: 1.5,
            shear_modulus_pa: 5e7,
            poissons_ratio: 0.35,
            is_coupled: true,
        })),
        Foundation::SuctionCaisson(Box::new(SuctionCaisson {
            diameter_m: 11.0,
            skirt_length_m: 9.5,
            soil_profile: SoilProfile::Parabolic,
            soil_youngs_modulus_pa: 4e7,
            soil_poissons_ratio: 0.45,
            vertical_n_per_m: 3e9,
            torsion_n_m: f64::INFINITY,
        })),
        winkler_pile(SoilSpring::Gazetas {
            youngs_modulus_pa: 3e7,
        }),
        winkler_pile(SoilSpring::Vesic {
            youngs_modulus_pa: 3e7,
            poissons_ratio: 0.25,
        }),
        monopile(PileFormula::CarterKulhawy, SoilProfile::Homogeneous),
        monopile(PileFormula::Randolph, SoilProfile::Linear),
        monopile(PileFormula::En1998, SoilProfile::Homogeneous),
        Foundation::WinklerPile(Box::new(WinklerPile {
            tube: PILE,
            formula: BeamFormula::Exact,
            soil_spring: SoilSpring::Given {
                spring_n_per_m2: 1.5e8,
            },
            exponent: 0.6,
            vertical_n_per_m: f64::INFINITY,
            torsion_n_m: 3e11,
        })),
        Foundation::Floating(Box::new(platform.clone())),
        Foundation::Floating(Box::new(FloatingPlatform {
            added_mass: with!(ReferredMatrix, height_m = -10.0),
            added_mass_by_frequency: Some(Arc::new(AddedMassTable {
                zero: symmetric_matrix(9e6),
                rows: vec![
                    (0.3, symmetric_matrix(1.1e7)),
                    (2.1, symmetric_matrix(5.5e6)),
                ],
                infinite: symmetric_matrix(6e6),
            })),
            buoyancy: None,
            at_equilibrium: true,
            ..platform
        })),
    ];
    for foundation in foundations {
        comes_back(&changed!(tubes(), foundation));
    }
}

const PILE: PileTube = PileTube {
    diameter_m: 8.0,
    wall_thickness_m: 0.09,
    embedded_length_m: 30.0,
    youngs_modulus_pa: 2.1e11,
};

fn circular_footing(embedment_m: f64, thickness_m: f64, lower_pa: f64) -> Foundation {
    Foundation::CircularFooting(Box::new(CircularFooting {
        radius_m: 9.0,
        embedment_m,
        shear_modulus_pa: 5e7,
        poissons_ratio: 0.35,
        stratum_thickness_m: thickness_m,
        lower_shear_modulus_pa: lower_pa,
        is_coupled: embedment_m > 0.0,
    }))
}

fn winkler_pile(soil_spring: SoilSpring) -> Foundation {
    Foundation::WinklerPile(Box::new(WinklerPile {
        tube: PILE,
        formula: BeamFormula::PoulosDavis,
        soil_spring,
        exponent: 0.0,
        vertical_n_per_m: f64::INFINITY,
        torsion_n_m: 3e11,
    }))
}

fn monopile(formula: PileFormula, soil_profile: SoilProfile) -> Foundation {
    Foundation::Monopile(Box::new(Monopile {
        tube: PILE,
        formula,
        soil_profile,
        soil_youngs_modulus_pa: 3e7,
        soil_poissons_ratio: 0.35,
        vertical_n_per_m: 5e9,
        torsion_n_m: f64::INFINITY,
    }))
}

fn added(rows: &[(f64, f64)]) -> Vec<AddedMassRow> {
    let row = |&(height_m, mass_kg_per_m)| parts::added_mass_row(height_m, mass_kg_per_m);
    rows.iter().map(row).collect()
}

fn soil(height_m: f64, values: [f64; 6]) -> SoilRow {
    let [
        x_n_per_m2,
        y_n_per_m2,
        z_n_per_m2,
        torsion_n,
        rotation_x_n,
        rotation_y_n,
    ] = values;
    SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2,
            y_n_per_m2,
            z_n_per_m2,
            torsion_n,
            rotation_x_n,
            rotation_y_n,
        },
    }
}

#[test]
fn soil_water_added_mass_and_wires() {
    let layer = |base_m, values| vec![soil(base_m, values), soil(5.0, [0.0; 6])];
    let wires = |count| parts::wires(60.25, count, 9e9, 45.0);
    let description = TowerDescription {
        soil: vec![
            layer(0.0, [1e8, 2e8, 0.0, 0.0, 0.0, 0.0]),
            layer(1.0, [1e8, 2e8, 3.0, 0.0, 0.0, 0.0]),
            layer(2.0, [1e8, 2e8, 0.0, 4.0, 0.0, 0.0]),
            layer(3.0, [0.0, 0.0, 0.0, 0.0, 5.0, 0.0]),
            layer(4.0, [1.0, 2.0, 0.0, 0.0, 5.0, 6.0]),
        ],
        added_mass: vec![
            added(&[(0.0, 1e4), (10.0, 5e3), (10.0, 4e3), (20.5, 0.1)]),
            added(&[(3.0, 7.0), (4.0, 7.0)]),
        ],
        water: Some(parts::water(20.0, None, 1025.0, 1.0, false)),
        wires: vec![wires(3), wires(999)],
        ..tubes()
    };
    comes_back(&description);
    let water = Some(parts::water(20.0, Some(-3.5), 999.97, 0.0, true));
    comes_back(&TowerDescription { water, ..tubes() });
}

#[test]
fn tables_of_properties() {
    let text = comes_back(&table());
    // Both planes are equal and the rotary inertia is half the polar one.
    assert!(!text.contains("side_side"), "{text}");
    assert!(!text.contains("rotary"), "{text}");
    let changed = |change: fn(usize, &mut Properties)| {
        let mut description = table();
        for (index, row) in description.properties.iter_mut().enumerate() {
            change(index, &mut row.properties);
        }
        comes_back(&description)
    };
    changed(|_, p| p.torsion_n_m2 = f64::INFINITY);
    changed(|_, p| p.axial_n = f64::INFINITY);
    changed(|_, p| (p.polar_inertia_kg_m, p.rotary_inertia_kg_m) = (0.0, Planes::both(0.0)));
    changed(|_, p| p.polar_inertia_kg_m = 0.0);
    changed(|i, p| p.bending_n_m2.side_side *= 1.0 + i as f64 / 9.0);
    changed(|_, p| p.rotary_inertia_kg_m = Planes::both(0.0));
    changed(|_, p| p.rotary_inertia_kg_m.side_side *= 1.1);
    changed(|_, p| p.shear_n = Some(Planes::both(2.6e10)));
    let text = changed(|_, p| {
        p.shear_n = Some(parts::planes(2.6e10, 2.5e10));
    });
    text.says("shear_stiffness_side_side_n");
}

#[test]
fn zero_polar_inertia_and_infinite_stiffness_are_read() {
    let text = "[tower.properties]\nz_m = [0, 90]\nmass_kg_per_m = [5000, 3000]\n\
        ei_fore_aft_n_m2 = [6e11, 1e11]\ngj_n_m2 = [inf, +inf]\nea_n = [inf, inf]\npolar_inertia_kg_m = [0, 0.0]\n";
    let read = description_from_toml(text).expect("a description");
    for row in &read.properties {
        assert_eq!(row.properties.torsion_n_m2, f64::INFINITY);
        assert_eq!(row.properties.axial_n, f64::INFINITY);
        assert_eq!(row.properties.polar_inertia_kg_m, 0.0);
        assert_eq!(row.properties.rotary_inertia_kg_m, Planes::both(0.0));
    }
    for column in ["mass_kg_per_m", "ei_fore_aft_n_m2", "polar_inertia_kg_m"] {
        let wrong = text.replace(&format!("{column} = ["), &format!("{column} = [inf] #"));
        let mistakes = description_from_toml(&wrong).expect_err("infinite or too short");
        mistakes[0].message().says(column);
    }
}

#[test]
fn added_mass_is_read_with_its_mistakes() {
    let base = "[material]\ndensity = 8500.0\nyoungs_modulus = 2.1e11\nshear_modulus = 8.08e10\n\
        [tower]\nstations = [[-20.0, 6.0, 0.027], [87.6, 3.87, 0.019]]\n[[added_mass]]\n";
    let read = |text: &str| description_from_toml(&format!("{base}{text}\n"));
    let sea = read("name = \"sea\"\nrows = [[-20, 3e4], [0.0, 2.5e4]]").expect("added mass");
    assert_eq!(sea.added_mass, [added(&[(-20.0, 3e4), (0.0, 2.5e4)])]);
    let refused = |text: &str, message: &str, hint: &str, place: (usize, usize)| {
        let mistakes = read(text).expect_err(text);
        let mistake = &mistakes[0];
        mistake.message().says(message);
        mistake.says(hint);
        let whole = format!("{base}{text}\n");
        assert_eq!(mistake.line_and_column(&whole), place, "{mistake}");
    };
    let table = r#"
         | has no `rows` | rows = [[height, mass per length], ...] | 7:1
        row = [] | `row` is not a key | did you mean `rows`? | 8:1
        rows = [[0, 1], [2]] | row 2 of the added mass has 1 value | [height in m | 8:17
        rows = [[0, 1, 2]] | row 1 of the added mass has 3 values | kg/m | 8:9
        rows = [5] | row 1 of the added mass must be a list | [height in m | 8:9
        rows = [[0, nan]] | added mass is NaN |  | 8:13
        rows = [["0", 1]] | height must be a number | without quotation marks | 8:10
        rows = 3 | rows must be a list |  | 8:8
        "#;
    for [text, message, hint, place] in rows(table) {
        refused(text, message, hint, line_and_column(place));
    }
    let single = format!("{}added_mass = 3\n", base.replace("[[added_mass]]\n", ""));
    let single = single.replace("[material]", "added_mass = 3\n[material]");
    let mistakes = description_from_toml(&single).expect_err("no list of tables");
    assert!(
        mistakes
            .iter()
            .any(|m| m.to_string().contains("[[added_mass]] in double brackets"))
    );
}

#[test]
fn what_a_file_cannot_hold_is_said() {
    let said = |description: &TowerDescription, words: &str| {
        let (text, notes) = write_toml(description);
        assert!(notes.iter().any(|n| n.message.contains(words)), "{notes:?}");
        text
    };
    let unused = changed!(table(), materials = tubes().materials);
    let text = said(&unused, "the materials (1) are left out");
    assert_eq!(description_from_toml(&text).expect("a table"), table());
    let sheared = changed!(table(), shear = Shear::Cowper);
    said(&sheared, "the shear model is left out");
    let both = changed!(unused, stations = tubes().stations);
    let text = said(&both, "has both stations and a table");
    assert!(description_from_toml(&text).is_err());
    let mut some = table();
    some.properties[1].properties.shear_n = Some(Planes::both(1e10));
    let text = said(&some, "1 of 3 rows");
    assert!(description_from_toml(&text).is_err());
    let nan = changed!(tubes(), gravity_m_per_s2 = f64::NAN);
    assert!(description_from_toml(&write_toml(&nan).0).is_err());
    // An index without a material is refused by its name, not taken for another one.
    let mut unknown = tubes();
    unknown.stations[0].material = usize::MAX;
    assert!(description_from_toml(&write_toml(&unknown).0).is_err());
}

#[test]
fn a_stiffness_with_rigid_motions_stays_one() {
    let mut stiffness = [[0.0; 6]; 6];
    for (i, entry) in [2e9, 3e9, f64::INFINITY, 3e11, 3e11, f64::INFINITY]
        .into_iter()
        .enumerate()
    {
        stiffness[i][i] = entry;
    }
    (stiffness[0][4], stiffness[4][0]) = (-2e10, -2e10);
    (stiffness[1][3], stiffness[3][1]) = (2e10, 2e10);
    let description = TowerDescription {
        foundation: Foundation::Stiffness(Box::new(StiffnessFoundation {
            stiffness,
            inertia: [[0.0; 6]; 6],
        })),
        ..tubes()
    };
    let (text, notes) = write_toml(&description);
    assert!(notes.is_empty(), "{notes:?}");
    let read = description_from_toml(&text).expect("a description");
    assert_eq!(read.foundation, description.foundation);
}

const SPECIAL: [f64; 9] = [
    0.0,
    -0.0,
    1.0,
    87.6,
    1e-3,
    9_999_999.5,
    1e7,
    f64::MAX,
    5e-324,
];

fn value() -> BoxedStrategy<f64> {
    prop_oneof![
        any::<f64>().prop_filter("finite", |x| x.is_finite()),
        -1e3..1e3,
        prop::sample::select(&SPECIAL[..]),
    ]
    .boxed()
}

/// Numbers and choices of a description, drawn one after the other.
struct Draw {
    numbers: std::vec::IntoIter<f64>,
    choices: std::vec::IntoIter<usize>,
}

impl Draw {
    fn value(&mut self) -> f64 {
        self.numbers.next().expect("enough numbers")
    }

    fn values<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.value())
    }

    fn below(&mut self, count: usize) -> usize {
        self.choices.next().expect("enough choices") % count
    }

    fn is(&mut self) -> bool {
        self.below(2) == 1
    }

    /// Rarely rigid.
    fn stiffness(&mut self) -> f64 {
        if self.below(4) == 0 {
            f64::INFINITY
        } else {
            self.value()
        }
    }

    fn list<T>(&mut self, least: usize, most: usize, one: impl Fn(&mut Self) -> T) -> Vec<T> {
        let count = least + self.below(most + 1 - least);
        (0..count).map(|_| one(self)).collect()
    }

    fn inertia(&mut self) -> Inertia {
        self.values::<6>().into()
    }

    fn matrix(&mut self) -> [[f64; 6]; 6] {
        std::array::from_fn(|_| self.values())
    }

    fn referred(&mut self) -> ReferredMatrix {
        ReferredMatrix {
            matrix: self.matrix(),
            height_m: self.value(),
        }
    }

    fn planes(&mut self, round: bool) -> Planes<f64> {
        let fore_aft = self.value();
        parts::planes(fore_aft, if round { fore_aft } else { self.value() })
    }

    fn material(&mut self) -> Material {
        let [density, youngs, shear] = self.values();
        Material::from_shear_modulus(density, youngs, shear)
    }

    fn station(&mut self, materials: usize) -> Station {
        let [z, d, t] = self.values();
        changed!(Station::new(z, d, t), material = self.below(materials))
    }

    fn row(&mut self, shears: bool) -> PropertyStation {
        let (height_m, polar, round) = (self.value(), self.value(), self.is());
        let shared = self.is().then_some(Planes::both(polar / 2.0));
        let properties = Properties {
            mass_kg_per_m: self.value(),
            rotary_inertia_kg_m: shared.unwrap_or_else(|| self.planes(round)),
            polar_inertia_kg_m: polar,
            bending_n_m2: self.planes(round),
            torsion_n_m2: self.stiffness(),
            axial_n: self.stiffness(),
            shear_n: shears.then(|| self.planes(round)),
        };
        PropertyStation {
            height_m,
            properties,
        }
    }

    fn body(&mut self) -> TowerDescription {
        let shears = self.is();
        if self.is() {
            return with!(
                TowerDescription,
                properties = self.list(1, 8, |d| d.row(shears))
            );
        }
        let materials = self.list(1, 12, Self::material);
        let count = materials.len();
        let stations = self.list(1, 8, |draw| draw.station(count));
        let shear = match self.below(3) {
            0 => Shear::Rigid,
            1 => Shear::Cowper,
            _ => Shear::Coefficient(self.value()),
        };
        with!(TowerDescription, materials, stations, shear)
    }

    fn foundation(&mut self) -> Foundation {
        match self.below(5) {
            0 => Foundation::Clamped,
            1 => Foundation::Stiffness(Box::new(StiffnessFoundation {
                stiffness: self.matrix(),
                inertia: self.matrix(),
            })),
            2 => Foundation::Springs(FoundationSprings {
                lateral_n_per_m: self.stiffness(),
                rocking_n_m: self.stiffness(),
                coupling_n: self.value(),
                vertical_n_per_m: self.stiffness(),
                torsion_n_m: self.stiffness(),
            }),
            3 => Foundation::HalfSpace(HalfSpace {
                radius_m: self.value(),
                embedment_m: self.value(),
                shear_modulus_pa: self.value(),
                poissons_ratio: self.value(),
            }),
            _ => Foundation::Floating(Box::new(FloatingPlatform {
                mass_kg: self.value(),
                center_m: self.values(),
                inertia_kg_m2: self.inertia(),
                added_mass: self.referred(),
                added_mass_by_frequency: None,
                hydrostatic: self.referred(),
                buoyancy: self.is().then(|| Buoyancy {
                    force_n: self.value(),
                    center_m: [self.value(), self.value()],
                }),
                mooring: self.referred(),
                mooring_lines: None,
                at_equilibrium: self.is(),
            })),
        }
    }

    fn water(&mut self) -> Water {
        Water {
            level_m: self.value(),
            bed_m: self.is().then(|| self.value()),
            density_kg_per_m3: self.value(),
            added_mass_coefficient: self.value(),
            flooded: self.is(),
        }
    }

    fn wires(&mut self) -> Wires {
        let [height_m, stiffness_n_per_m, angle_deg] = self.values();
        let count = 1 + self.below(1999);
        parts::wires(height_m, count, stiffness_n_per_m, angle_deg)
    }

    fn description(&mut self, name: String) -> TowerDescription {
        let body = self.body();
        let mass = |draw: &mut Self| parts::point_mass(draw.value(), draw.value(), draw.inertia());
        TowerDescription {
            name,
            outfitting_factor: self.value(),
            foundation: self.foundation(),
            point_masses: self.list(0, 2, mass),
            rna: Rna {
                mass_kg: self.value(),
                center_m: self.values(),
                inertia_kg_m2: self.inertia(),
            },
            rotor: self
                .is()
                .then(|| rotor(self.below(1_000_000), self.value(), self.value())),
            soil: self.list(0, 2, |draw| {
                draw.list(0, 3, |draw| soil(draw.value(), draw.values()))
            }),
            added_mass: self.list(0, 2, |draw| {
                added(&draw.list(0, 3, |d| (d.value(), d.value())))
            }),
            water: self.is().then(|| self.water()),
            wires: self.list(0, 2, Self::wires),
            gravity_m_per_s2: self.value(),
            ..body
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_description_comes_back(
        name in any::<String>(),
        numbers in prop::collection::vec(value(), 500),
        choices in prop::collection::vec(0..1_000_000_usize, 150),
    ) {
        let (numbers, choices) = (numbers.into_iter(), choices.into_iter());
        comes_back(&Draw { numbers, choices }.description(name));
    }
}

/// The rotor of the SWiFT V27: locked in the file, free by the option; written and read back.
#[test]
fn a_drivetrain_is_written_and_frees_the_rotor() {
    let text = include_str!("../../../examples/measured/swift-v27.toml");
    let tower = description_from_toml(text).expect("a tower");
    let (written, notes) = write_toml(&tower);
    assert!(notes.is_empty(), "{notes:?}");
    assert_eq!(description_from_toml(&written).expect("a tower"), tower);
    let freed = tower.with_free_rotor().expect("a drivetrain");
    assert!((freed.rna.inertia_kg_m2.xx - 30_826.0).abs() < 1.0);
    assert_eq!(freed.drivetrain, None);
    // As much as the assembly has: more is impossible.
    let heavy = text.replace("rotor_inertia = 61610.0", "rotor_inertia = 71610.0");
    let refused = towermodes_files::tower_from_toml(&heavy).expect_err("too heavy");
    refused[0].message().says("71660 kg m2");
    let (line, _) = refused[0].line_and_column(&heavy);
    assert!(
        heavy
            .lines()
            .nth(line - 1)
            .is_some_and(|line| line.starts_with("rotor_inertia"))
    );
}

//! What is written as TOML is read back as the same description, number by number.

use proptest::prelude::*;
use towermodes::{
    AddedMassRow, BeamFormula, CircularFooting, FloatingPlatform, FootingFormula, Foundation,
    FoundationSprings, HalfSpace, Inertia, Material, Monopile, PartNames, PileFormula, PileTube,
    Planes, PointMass, Properties, PropertyStation, RectangularFooting, ReferredMatrix, Rna, Rotor,
    Shear, SoilProfile, SoilRow, SoilSpring, SoilStiffness, Station, StiffnessFoundation,
    SuctionCaisson, TowerDescription, Water, WinklerPile, Wires,
};
use towermodes_files::{description_from_toml, tower_from_toml, write_toml};

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
    TowerDescription {
        materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
        stations: vec![
            Station::new(0.0, 6.0, 0.027),
            Station::new(87.6, 3.87, 0.019),
        ],
        ..TowerDescription::default()
    }
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
        assert!(
            text.contains("poissons_ratio = ") && !text.contains("shear_modulus = "),
            "{text}"
        );
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
    assert!(text.contains("shear_modulus = "), "{text}");
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

#[test]
fn every_example() {
    let examples = [
        include_str!("../../../examples/reference-tower.toml"),
        include_str!("../../../examples/reference-tower-350t.toml"),
        include_str!("../../../examples/nrel-5mw.toml"),
        include_str!("../../../examples/nrel-5mw-table.toml"),
        include_str!("../../../examples/monopile.toml"),
        include_str!("../../../examples/floating.toml"),
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
    description.rotor = Some(Rotor {
        blades: 2,
        lowest_rpm: 18.0,
        highest_rpm: 18.0,
    });
    let text = comes_back(&description);
    assert!(text.contains("rpm = 18.0"), "{text}");
    description.rotor = Some(Rotor {
        blades: 3,
        lowest_rpm: 6.9,
        highest_rpm: 12.1,
    });
    let text = comes_back(&description);
    assert!(text.contains("rpm = [6.9, 12.1]"), "{text}");
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
    assert!(head.starts_with("# A tower for towermodes."));
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
        comes_back(&TowerDescription {
            name: name.into(),
            ..tubes()
        });
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
            Station {
                material: 1,
                ..Station::new(30.0, 5.0, 0.03)
            },
            Station {
                material: 1,
                ..Station::new(80.0, 4.0, 0.02)
            },
        ],
        part_names: PartNames {
            materials: names.map(str::to_owned).to_vec(),
            ..PartNames::default()
        },
        ..TowerDescription::default()
    };
    let text = comes_back(&named(["concrete", "steel S355 \"new\""]));
    assert!(text.contains("[materials.concrete]"), "{text}");
    assert!(
        text.contains(r#"[materials."steel S355 \"new\""]"#),
        "{text}"
    );
    let text = comes_back(&named(["", "steel"]));
    assert!(text.contains("[material]\n"), "{text}");
    let (text, _) = write_toml(&named(["steel", "concrete"]));
    assert!(text.contains("[materials.material_1]"), "{text}");
    let mut one = tubes();
    one.part_names.materials = vec!["steel".to_owned()];
    assert!(comes_back(&one).contains("[materials.steel]"));
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
    let text = comes_back(&description);
    assert!(text.contains("[materials.material_02]"), "{text}");
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
            PointMass {
                height_m: 40.0,
                mass_kg: 5000.0,
                inertia_kg_m2: Inertia::default(),
            },
            PointMass {
                height_m: 20.0,
                mass_kg: 1e-9,
                inertia_kg_m2: Inertia { zz: 3.0, ..inertia },
            },
        ],
        gravity_m_per_s2: 9.81,
        ..tubes()
    };
    comes_back(&description);
    comes_back(&TowerDescription {
        rna: Rna::point(1.0 / 3.0),
        ..tubes()
    });
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
        inertia_kg_m2: Inertia {
            xx: 4.22923e9,
            yy: 4.22923e9,
            zz: 0.0,
            ..Inertia::default()
        },
        added_mass: referred(8e6, -10.0),
        hydrostatic: ReferredMatrix {
            height_m: 3.0,
            ..ReferredMatrix::default()
        },
        mooring: referred(4e4, -70.0),
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
        Foundation::HalfSpace(HalfSpace {
            radius_m: 8.0,
            embedment_m: 0.0,
            shear_modulus_pa: 5e7,
            poissons_ratio: 0.35,
        }),
        Foundation::HalfSpace(HalfSpace {
            radius_m: 8.0,
            embedment_m: 1.5,
            shear_modulus_pa: 5e7,
            poissons_ratio: 0.0,
        }),
        monopile(PileFormula::ShadlouBhattacharya, SoilProfile::Parabolic),
        Foundation::CircularFooting(Box::new(circular_footing(
            0.0,
            f64::INFINITY,
            f64::INFINITY,
        ))),
        Foundation::CircularFooting(Box::new(circular_footing(2.5, 21.0, f64::INFINITY))),
        Foundation::CircularFooting(Box::new(circular_footing(0.0, 21.0, 6e8))),
        Foundation::CircularFooting(Box::new(circular_footing(0.0, f64::INFINITY, 6e8))),
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
        Foundation::Floating(Box::new(platform)),
    ];
    for foundation in foundations {
        comes_back(&TowerDescription {
            foundation,
            ..tubes()
        });
    }
}

const PILE: PileTube = PileTube {
    diameter_m: 8.0,
    wall_thickness_m: 0.09,
    embedded_length_m: 30.0,
    youngs_modulus_pa: 2.1e11,
};

fn circular_footing(embedment_m: f64, thickness_m: f64, lower_pa: f64) -> CircularFooting {
    CircularFooting {
        radius_m: 9.0,
        embedment_m,
        shear_modulus_pa: 5e7,
        poissons_ratio: 0.35,
        stratum_thickness_m: thickness_m,
        lower_shear_modulus_pa: lower_pa,
        is_coupled: embedment_m > 0.0,
    }
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

#[test]
fn soil_water_added_mass_and_wires() {
    let soil = |height_m, values: [f64; 6]| SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2: values[0],
            y_n_per_m2: values[1],
            z_n_per_m2: values[2],
            torsion_n: values[3],
            rotation_x_n: values[4],
            rotation_y_n: values[5],
        },
    };
    let added = |height_m, mass_kg_per_m| AddedMassRow {
        height_m,
        mass_kg_per_m,
    };
    let wires = |count| Wires {
        height_m: 60.25,
        count,
        stiffness_n_per_m: 9e9,
        angle_deg: 45.0,
    };
    let description = TowerDescription {
        soil: vec![
            vec![
                soil(0.0, [1e8, 2e8, 0.0, 0.0, 0.0, 0.0]),
                soil(5.0, [0.0; 6]),
            ],
            vec![
                soil(1.0, [1e8, 2e8, 3.0, 0.0, 0.0, 0.0]),
                soil(5.0, [0.0; 6]),
            ],
            vec![
                soil(2.0, [1e8, 2e8, 0.0, 4.0, 0.0, 0.0]),
                soil(5.0, [0.0; 6]),
            ],
            vec![
                soil(3.0, [0.0, 0.0, 0.0, 0.0, 5.0, 0.0]),
                soil(5.0, [0.0; 6]),
            ],
            vec![
                soil(4.0, [1.0, 2.0, 0.0, 0.0, 5.0, 6.0]),
                soil(5.0, [0.0; 6]),
            ],
        ],
        added_mass: vec![
            vec![
                added(0.0, 1e4),
                added(10.0, 5e3),
                added(10.0, 4e3),
                added(20.5, 0.1),
            ],
            vec![added(3.0, 7.0), added(4.0, 7.0)],
        ],
        water: Some(Water {
            level_m: 20.0,
            bed_m: None,
            density_kg_per_m3: 1025.0,
            added_mass_coefficient: 1.0,
            flooded: false,
        }),
        wires: vec![wires(3), wires(999)],
        ..tubes()
    };
    comes_back(&description);
    let water = Some(Water {
        level_m: 20.0,
        bed_m: Some(-3.5),
        density_kg_per_m3: 999.97,
        added_mass_coefficient: 0.0,
        flooded: true,
    });
    comes_back(&TowerDescription { water, ..tubes() });
}

#[test]
fn tables_of_properties() {
    let text = comes_back(&table());
    // Both planes are equal and the rotary inertia is half the polar one.
    assert!(
        !text.contains("side_side") && !text.contains("rotary"),
        "{text}"
    );
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
        p.shear_n = Some(Planes {
            fore_aft: 2.6e10,
            side_side: 2.5e10,
        });
    });
    assert!(text.contains("shear_stiffness_side_side_n"), "{text}");
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
        assert!(mistakes[0].message().contains(column), "{mistakes:?}");
    }
}

#[test]
fn added_mass_is_read_with_its_mistakes() {
    let base = "[material]\ndensity = 8500.0\nyoungs_modulus = 2.1e11\nshear_modulus = 8.08e10\n\
        [tower]\nstations = [[-20.0, 6.0, 0.027], [87.6, 3.87, 0.019]]\n[[added_mass]]\n";
    let read = |text: &str| description_from_toml(&format!("{base}{text}\n"));
    let rows = read("name = \"sea\"\nrows = [[-20, 3e4], [0.0, 2.5e4]]").expect("added mass");
    let expected = [(-20.0, 3e4), (0.0, 2.5e4)].map(|(height_m, mass_kg_per_m)| AddedMassRow {
        height_m,
        mass_kg_per_m,
    });
    assert_eq!(rows.added_mass, [expected.to_vec()]);
    let refused = |text: &str, message: &str, hint: &str, place: (usize, usize)| {
        let mistakes = read(text).expect_err(text);
        let mistake = &mistakes[0];
        assert!(mistake.message().contains(message), "{mistake}");
        assert!(mistake.to_string().contains(hint), "{mistake}");
        let whole = format!("{base}{text}\n");
        assert_eq!(mistake.line_and_column(&whole), place, "{mistake}");
    };
    refused(
        "",
        "has no `rows`",
        "rows = [[height, mass per length], ...]",
        (7, 1),
    );
    refused(
        "row = []",
        "`row` is not a key",
        "did you mean `rows`?",
        (8, 1),
    );
    refused(
        "rows = [[0, 1], [2]]",
        "row 2 of the added mass has 1 values",
        "[height in m",
        (8, 17),
    );
    refused(
        "rows = [[0, 1, 2]]",
        "row 1 of the added mass has 3 values",
        "kg/m",
        (8, 9),
    );
    refused(
        "rows = [5]",
        "row 1 of the added mass must be a list",
        "[height in m",
        (8, 9),
    );
    refused("rows = [[0, nan]]", "added mass is NaN", "", (8, 13));
    refused(
        "rows = [[\"0\", 1]]",
        "height must be a number",
        "without quotation marks",
        (8, 10),
    );
    refused("rows = 3", "rows must be a list", "", (8, 8));
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
    let unused = TowerDescription {
        materials: tubes().materials,
        ..table()
    };
    let text = said(&unused, "the materials (1) are left out");
    assert_eq!(description_from_toml(&text).expect("a table"), table());
    let sheared = TowerDescription {
        shear: Shear::Cowper,
        ..table()
    };
    said(&sheared, "the shear model is left out");
    let both = TowerDescription {
        stations: tubes().stations,
        ..unused
    };
    let text = said(&both, "has both stations and a table");
    assert!(description_from_toml(&text).is_err());
    let mut some = table();
    some.properties[1].properties.shear_n = Some(Planes::both(1e10));
    let text = said(&some, "1 of 3 rows");
    assert!(description_from_toml(&text).is_err());
    let nan = TowerDescription {
        gravity_m_per_s2: f64::NAN,
        ..tubes()
    };
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

fn value() -> BoxedStrategy<f64> {
    prop_oneof![
        any::<f64>().prop_filter("finite", |x| x.is_finite()),
        -1e3..1e3,
        prop::sample::select(vec![
            0.0,
            -0.0,
            1.0,
            87.6,
            1e-3,
            9_999_999.5,
            1e7,
            f64::MAX,
            5e-324
        ]),
    ]
    .boxed()
}

fn inertia() -> BoxedStrategy<Inertia> {
    prop::array::uniform6(value())
        .prop_map(|[xx, yy, zz, xy, xz, yz]| Inertia {
            xx,
            yy,
            zz,
            xy,
            xz,
            yz,
        })
        .boxed()
}

fn station_rows() -> BoxedStrategy<(Vec<Material>, Vec<Station>)> {
    let material = prop::array::uniform3(value())
        .prop_map(|[rho, e, g]| Material::from_shear_modulus(rho, e, g));
    prop::collection::vec(material, 1..13)
        .prop_flat_map(|materials| {
            let count = materials.len();
            let station =
                (prop::array::uniform3(value()), 0..count).prop_map(|([z, d, t], material)| {
                    Station {
                        material,
                        ..Station::new(z, d, t)
                    }
                });
            (Just(materials), prop::collection::vec(station, 1..9))
        })
        .boxed()
}

fn property_rows() -> BoxedStrategy<Vec<PropertyStation>> {
    let row = (prop::array::uniform10(value()), any::<[bool; 4]>());
    let rows = prop::collection::vec(row, 1..9);
    (rows, any::<bool>())
        .prop_map(|(rows, shears)| {
            let of = |(v, [twists, stretches, round, shared]): &([f64; 10], [bool; 4])| {
                let side_side = |i: usize| if *round { v[i] } else { v[i + 1] };
                let planes = |i: usize| Planes {
                    fore_aft: v[i],
                    side_side: side_side(i),
                };
                PropertyStation {
                    height_m: v[0],
                    properties: Properties {
                        mass_kg_per_m: v[1],
                        rotary_inertia_kg_m: if *shared {
                            Planes::both(v[2] / 2.0)
                        } else {
                            planes(3)
                        },
                        polar_inertia_kg_m: v[2],
                        bending_n_m2: planes(5),
                        torsion_n_m2: if *twists { v[7] } else { f64::INFINITY },
                        axial_n: if *stretches { v[9] } else { f64::INFINITY },
                        shear_n: shears.then(|| planes(8)),
                    },
                }
            };
            rows.iter().map(of).collect()
        })
        .boxed()
}

fn any_foundation() -> BoxedStrategy<Foundation> {
    let matrix = || prop::array::uniform6(prop::array::uniform6(value())).boxed();
    let referred = move || {
        (matrix(), value())
            .prop_map(|(matrix, height_m)| ReferredMatrix { matrix, height_m })
            .boxed()
    };
    let spring = || prop_oneof![3 => value(), 1 => Just(f64::INFINITY)];
    let springs = (prop::array::uniform4(spring()), value());
    let platform = (
        value(),
        prop::array::uniform3(value()),
        inertia(),
        referred(),
        referred(),
        referred(),
    );
    prop_oneof![
        Just(Foundation::Clamped),
        (matrix(), matrix()).prop_map(|(stiffness, inertia)| {
            Foundation::Stiffness(Box::new(StiffnessFoundation { stiffness, inertia }))
        }),
        springs.prop_map(|([lateral, rocking, vertical, torsion], coupling_n)| {
            Foundation::Springs(FoundationSprings {
                lateral_n_per_m: lateral,
                rocking_n_m: rocking,
                coupling_n,
                vertical_n_per_m: vertical,
                torsion_n_m: torsion,
            })
        }),
        prop::array::uniform4(value()).prop_map(|[radius_m, embedment_m, g, nu]| {
            Foundation::HalfSpace(HalfSpace {
                radius_m,
                embedment_m,
                shear_modulus_pa: g,
                poissons_ratio: nu,
            })
        }),
        platform.prop_map(
            |(mass_kg, center_m, inertia_kg_m2, added_mass, hydrostatic, mooring)| {
                Foundation::Floating(Box::new(FloatingPlatform {
                    mass_kg,
                    center_m,
                    inertia_kg_m2,
                    added_mass,
                    hydrostatic,
                    mooring,
                }))
            }
        ),
    ]
    .boxed()
}

fn around() -> BoxedStrategy<TowerDescription> {
    let soil = prop::collection::vec(prop::array::uniform7(value()), 0..4).prop_map(|rows| {
        let row = |[height_m, x, y, z, torsion, rotation_x_n, rotation_y_n]: [f64; 7]| SoilRow {
            height_m,
            stiffness: SoilStiffness {
                x_n_per_m2: x,
                y_n_per_m2: y,
                z_n_per_m2: z,
                torsion_n: torsion,
                rotation_x_n,
                rotation_y_n,
            },
        };
        rows.into_iter().map(row).collect::<Vec<_>>()
    });
    let added = prop::collection::vec((value(), value()), 0..4).prop_map(|rows| {
        let row = |(height_m, mass_kg_per_m)| AddedMassRow {
            height_m,
            mass_kg_per_m,
        };
        rows.into_iter().map(row).collect::<Vec<_>>()
    });
    let water = (
        prop::array::uniform3(value()),
        any::<bool>(),
        prop::option::of(value()),
    );
    let water = water.prop_map(
        |([level_m, density_kg_per_m3, coefficient], flooded, bed_m)| Water {
            level_m,
            bed_m,
            density_kg_per_m3,
            added_mass_coefficient: coefficient,
            flooded,
        },
    );
    let wires = (prop::array::uniform3(value()), 1..2000_usize);
    let wires = wires.prop_map(|([height_m, stiffness_n_per_m, angle_deg], count)| Wires {
        height_m,
        count,
        stiffness_n_per_m,
        angle_deg,
    });
    let wires = prop::collection::vec(wires, 0..3);
    let soil = prop::collection::vec(soil, 0..3);
    let added = prop::collection::vec(added, 0..3);
    (soil, added, prop::option::of(water), wires, value())
        .prop_map(
            |(soil, added_mass, water, wires, gravity_m_per_s2)| TowerDescription {
                soil,
                added_mass,
                water,
                wires,
                gravity_m_per_s2,
                ..TowerDescription::default()
            },
        )
        .boxed()
}

fn any_description() -> BoxedStrategy<TowerDescription> {
    let shear = prop_oneof![
        Just(Shear::Rigid),
        Just(Shear::Cowper),
        value().prop_map(Shear::Coefficient)
    ];
    let rna = (value(), prop::array::uniform3(value()), inertia());
    let mass =
        (value(), value(), inertia()).prop_map(|(height_m, mass_kg, inertia_kg_m2)| PointMass {
            height_m,
            mass_kg,
            inertia_kg_m2,
        });
    let masses = prop::collection::vec(mass, 0..3);
    let body = prop_oneof![
        (station_rows(), shear).prop_map(|((materials, stations), shear)| TowerDescription {
            materials,
            stations,
            shear,
            ..TowerDescription::default()
        }),
        property_rows().prop_map(|properties| TowerDescription {
            properties,
            ..TowerDescription::default()
        }),
    ];
    let factor = value();
    let rotor = proptest::option::of((0..1_000_000_usize, value(), value()).prop_map(
        |(blades, lowest_rpm, highest_rpm)| Rotor {
            blades,
            lowest_rpm,
            highest_rpm,
        },
    ));
    (
        any::<String>(),
        body,
        around(),
        any_foundation(),
        rna,
        masses,
        factor,
        rotor,
    )
        .prop_map(
            |(name, body, around, foundation, rna, point_masses, outfitting_factor, rotor)| {
                TowerDescription {
                    name,
                    materials: body.materials,
                    stations: body.stations,
                    properties: body.properties,
                    shear: body.shear,
                    outfitting_factor,
                    foundation,
                    point_masses,
                    rna: Rna {
                        mass_kg: rna.0,
                        center_m: rna.1,
                        inertia_kg_m2: rna.2,
                    },
                    rotor,
                    ..around
                }
            },
        )
        .boxed()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_description_comes_back(description in any_description()) {
        comes_back(&description);
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
    assert!(
        refused[0].message().contains("71660 kg m2"),
        "{}",
        refused[0].message()
    );
    let (line, _) = refused[0].line_and_column(&heavy);
    assert!(
        heavy
            .lines()
            .nth(line - 1)
            .is_some_and(|line| line.starts_with("rotor_inertia"))
    );
}

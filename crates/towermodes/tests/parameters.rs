//! The numbers of a tower by name: complete, distinct, each with its own effect.

use std::collections::{BTreeSet, HashSet};

use towermodes::{
    AddedMassRow, BeamFormula, Buoyancy, Change, CircularFooting, FloatingPlatform, FootingFormula,
    Foundation, FoundationSprings, Inertia, Material, Monopile, Operation, Parameter,
    ParameterError, PartNames, PileFormula, PileTube, Place, Planes, PointMass, Properties,
    PropertyStation, RectangularFooting, ReferredMatrix, Rna, Shear, SoilProfile, SoilRow,
    SoilSpring, SoilStiffness, StiffnessFoundation, SuctionCaisson, TowerDescription, WinklerPile,
};
use towermodes_testing::{Says, changed, parts, rotor, rows, stations, with};

fn tubes() -> TowerDescription {
    let row = |height_m| SoilRow {
        height_m,
        stiffness: SoilStiffness::default(),
    };
    TowerDescription {
        materials: vec![
            Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10),
            Material::from_poissons_ratio(7850.0, 2.1e11, 0.3),
        ],
        stations: stations(&[(0.0, 6.0, 0.027), (87.6, 3.87, 0.019)]),
        shear: Shear::Coefficient(0.5),
        rna: Rna::point(350e3),
        point_masses: vec![PointMass::default(); 2],
        foundation: Foundation::Springs(FoundationSprings::RIGID),
        soil: vec![vec![row(0.0)], vec![row(0.0), row(5.0)]],
        added_mass: vec![vec![AddedMassRow::default(); 2]],
        water: Some(parts::water(20.0, None, 1025.0, 1.0, false)),
        wires: vec![parts::wires(40.0, 3, 1e6, 45.0)],
        gravity_m_per_s2: 9.81,
        rotor: Some(rotor(3, 6.9, 12.1)),
        part_names: with!(PartNames, materials = vec!["steel".into(), "S355.2".into()]),
        ..TowerDescription::default()
    }
}

fn table(foundation: Foundation) -> TowerDescription {
    let properties = Properties {
        mass_kg_per_m: 4e3,
        rotary_inertia_kg_m: Planes::both(1e4),
        polar_inertia_kg_m: 2e4,
        bending_n_m2: Planes::both(5e11),
        torsion_n_m2: 4e11,
        axial_n: 1e11,
        shear_n: Some(Planes::both(1e10)),
    };
    let row = |height_m| PropertyStation {
        height_m,
        properties,
    };
    TowerDescription {
        properties: vec![row(0.0), row(80.0)],
        foundation,
        ..TowerDescription::default()
    }
}

const PILE: PileTube = PileTube {
    diameter_m: 8.0,
    wall_thickness_m: 0.09,
    embedded_length_m: 30.0,
    youngs_modulus_pa: 2.1e11,
};

/// One tower for every type of foundation; together they have every kind of number.
fn towers() -> Vec<TowerDescription> {
    let matrix = std::array::from_fn(|i| std::array::from_fn(|j| (10 + i + j) as f64));
    let referred = ReferredMatrix {
        matrix,
        height_m: 0.0,
    };
    vec![
        tubes(),
        table(Foundation::Clamped),
        table(Foundation::HalfSpace(parts::half_space(8.0, 1.0, 5e7, 0.3))),
        table(Foundation::Stiffness(Box::new(StiffnessFoundation {
            stiffness: matrix,
            inertia: matrix,
        }))),
        table(Foundation::Floating(Box::new(FloatingPlatform {
            mass_kg: 1e7,
            center_m: [0.0, 0.0, -80.0],
            inertia_kg_m2: Inertia::default(),
            added_mass_by_frequency: None,
            added_mass: referred,
            hydrostatic: referred,
            buoyancy: Some(Buoyancy {
                force_n: 1e8,
                center_m: [0.1, 0.2],
            }),
            mooring: referred,
            mooring_lines: None,
            at_equilibrium: false,
        }))),
        table(Foundation::Monopile(Box::new(Monopile {
            tube: PILE,
            formula: PileFormula::Randolph,
            soil_profile: SoilProfile::Linear,
            soil_youngs_modulus_pa: 3e7,
            soil_poissons_ratio: 0.3,
            vertical_n_per_m: 1e9,
            torsion_n_m: 1e11,
        }))),
        table(Foundation::CircularFooting(Box::new(CircularFooting {
            radius_m: 9.0,
            embedment_m: 1.0,
            shear_modulus_pa: 5e7,
            poissons_ratio: 0.3,
            stratum_thickness_m: 20.0,
            lower_shear_modulus_pa: 1e9,
            is_coupled: false,
        }))),
        table(Foundation::RectangularFooting(Box::new(
            RectangularFooting {
                formula: FootingFormula::Gazetas,
                length_x_m: 20.0,
                length_y_m: 12.0,
                embedment_m: 1.0,
                shear_modulus_pa: 5e7,
                poissons_ratio: 0.3,
                is_coupled: true,
            },
        ))),
        table(Foundation::SuctionCaisson(Box::new(SuctionCaisson {
            diameter_m: 12.0,
            skirt_length_m: 9.0,
            soil_profile: SoilProfile::Linear,
            soil_youngs_modulus_pa: 4e7,
            soil_poissons_ratio: 0.2,
            vertical_n_per_m: 1e9,
            torsion_n_m: 1e11,
        }))),
        table(winkler_pile(SoilSpring::Given {
            spring_n_per_m2: 1e8,
        })),
        table(winkler_pile(SoilSpring::Gazetas {
            youngs_modulus_pa: 3e7,
        })),
        table(winkler_pile(SoilSpring::Vesic {
            youngs_modulus_pa: 3e7,
            poissons_ratio: 0.3,
        })),
    ]
}

fn winkler_pile(soil_spring: SoilSpring) -> Foundation {
    Foundation::WinklerPile(Box::new(WinklerPile {
        tube: PILE,
        formula: BeamFormula::Exact,
        soil_spring,
        exponent: 0.5,
        vertical_n_per_m: 1e9,
        torsion_n_m: 1e11,
    }))
}

#[test]
fn every_number_is_found_by_its_name_and_no_two_share_one() {
    for description in towers() {
        let all = Parameter::all(&description);
        let names: HashSet<String> = all.iter().map(ToString::to_string).collect();
        assert_eq!(names.len(), all.len());
        for parameter in all {
            let found = Parameter::parse(&parameter.to_string(), &description);
            assert_eq!(found, Ok(parameter), "{parameter}");
        }
    }
}

/// A number that is set has the new value, and every other number keeps its own.
#[test]
fn a_number_changes_nothing_but_itself() {
    for base in towers() {
        let all = Parameter::all(&base);
        for &parameter in &all {
            let mut changed = base.clone();
            parameter.set(&mut changed, 12345.678);
            assert_eq!(parameter.value(&changed), 12345.678, "{parameter}");
            assert_ne!(changed, base, "{parameter}");
            for other in all.iter().filter(|other| **other != parameter) {
                let (before, after) = (other.value(&base), other.value(&changed));
                let holds = before.to_bits() == after.to_bits();
                assert!(holds, "{parameter} changes {other}");
            }
        }
    }
}

#[test]
fn the_list_of_a_tower_of_tubes_is_complete() {
    let names = |prefix: &str| -> Vec<String> {
        let names = Parameter::all(&tubes())
            .into_iter()
            .map(|one| one.to_string());
        names.filter(|name| name.starts_with(prefix)).collect()
    };
    assert_eq!(
        names("materials[1]"),
        ["density", "youngs_modulus", "poissons_ratio"].map(|key| format!("materials[1].{key}"))
    );
    assert_eq!(names("tower"), ["tower.outfitting_factor", "tower.shear"]);
    assert_eq!(
        names("stations[1]"),
        [
            "stations[1].height",
            "stations[1].diameter",
            "stations[1].wall"
        ]
    );
    assert_eq!(names("soil").len(), 15);
    assert_eq!(names("soil[1].rows[1].t"), ["soil[1].rows[1].torsion"]);
    assert_eq!(names("rotor"), ["rotor.rpm[0]", "rotor.rpm[1]"]);
    assert_eq!(names("water").len(), 3, "the bed is not given");
    // 6 of materials, 2 of the tower, 6 of stations, 10 of the rotor-nacelle assembly, 2 of the
    // rotor, 16 of masses, 5 of springs, 15 of soil, 4 of added mass, 3 of water, 3 of wires, 1.
    assert_eq!(names("").len(), 73);
}

#[test]
fn both_triangles_of_a_matrix_change_together() {
    let mut description = towers().remove(3);
    let lower = Parameter::parse("foundation.matrix[4][0]", &description).expect("an entry");
    assert_eq!(lower.to_string(), "foundation.matrix[0][4]");
    lower.set(&mut description, -3e9);
    let Foundation::Stiffness(foundation) = &description.foundation else {
        panic!("another foundation");
    };
    assert_eq!(foundation.stiffness[0][4], -3e9);
    assert_eq!(foundation.stiffness[4][0], -3e9);
    assert_eq!(lower.place(), Place::Foundation { key: "matrix" });
    let all = Parameter::parse_every("foundation.matrix[*][*]", &description).expect("entries");
    assert_eq!(all.len(), 21);
    let row = Parameter::parse_every("foundation.matrix[5][*]", &description).expect("entries");
    assert_eq!(row.iter().collect::<HashSet<_>>().len(), 6);
}

#[test]
fn the_shear_modulus_follows_youngs_modulus_where_poissons_ratio_is_given() {
    let mut description = tubes();
    for change in
        Change::parse_all(["materials[*].youngs_modulus"], &description).expect("a change")
    {
        change.apply(&mut description, 2.0e11);
    }
    assert_eq!(description.materials[0].shear_modulus_pa, 8.08e10);
    assert_eq!(
        description.materials[1].shear_modulus_pa,
        2.0e11 / (2.0 * (1.0 + 0.3))
    );
    let ratio = Parameter::parse("materials.\"S355.2\".poissons_ratio", &description);
    ratio.expect("a number").set(&mut description, 0.25);
    assert_eq!(description.materials[1].shear_modulus_pa, 8.0e10);
}

#[test]
fn names_may_be_written_as_in_the_file() {
    let description = tubes();
    let same = |written: &str, name: &str| {
        let found = Parameter::parse(written, &description).map(|one| one.to_string());
        assert_eq!(found.as_deref(), Ok(name), "{written}");
    };
    same(" tower.stations[1].wall ", "stations[1].wall");
    same("materials.steel.density", "materials[0].density");
    same("materials.S355.2.density", "materials[1].density");
    same("water.bed", "water.bed");
    let single = TowerDescription {
        materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
        ..tubes()
    };
    for written in [
        "material.density",
        "materials[0].density",
        "materials.steel.density",
    ] {
        let found = Parameter::parse(written, &single).expect("a number");
        assert_eq!(found.to_string(), "material.density");
    }
}

#[test]
fn a_wrong_name_is_answered_with_what_would_be_right() {
    let description = tubes();
    let message = |name: &str| match Change::parse(name, &description) {
        Ok(change) => panic!("{name} is {change:?}"),
        Err(error) => error.to_string(),
    };
    let table = r#"
        rna.mas | did you mean `rna.mass`?
        station[1].wall | did you mean `stations[1].wall`?
        stations[1].Wall | did you mean `stations[1].wall`?
        scale(stations[*].wal) | did you mean `stations[*].wall`?
        stations[1].thickness | the input values of stations[] are height, diameter, wall
        stations[2].wall | index 2 is too large, the stations of this tower have the indices 0 to 1
        soil[0].rows[7].x | index 7 is too large, the rows of this tower have only index 0
        stations[x].wall | `x` is not an index
        stations[-1].wall | `-1` is not an index
        material.density | this tower has 2 materials; write `materials.steel.density`
        foundation.radius | this tower has no foundation of type "half-space"
        properties[0].ea_n | this tower has no table of section properties
        turbine.hub.mass | input values of [turbine] have no names for --set, sweeps, designs and derivatives; change it in the tower file
        banana | names begin with materials[], tower, stations[]
         | the name of the input value is missing
        scale(rna.mass | is not a change
        grow(rna.mass) | is not a change
        rna.mass, rna.center[0] | is not a change
        add(rna.mass,) | the name of the input value is missing
        add(rna.mass, rna.mass) | sets rna.mass, which
        "#;
    for [name, expected] in rows(table) {
        message(name).says(expected);
    }
    let empty = changed!(tubes(), soil = vec![Vec::new()]);
    let error = Parameter::parse("soil[0].rows[0].x", &empty).expect_err("no rows");
    error.says("the rows of this tower have no index");
    let long = format!("stations[{}].wall", "9".repeat(100_000));
    message(&long).says("is not an index");
}

#[test]
fn changes_set_scale_and_add() {
    let base = tubes();
    let mut description = base.clone();
    let names = [
        "rna.mass",
        "scale(stations[*].wall)",
        "add(stations[1].height, wires[0].height)",
    ];
    let changes = Change::parse_all(names, &description).expect("changes");
    let operations: Vec<Operation> = changes.iter().map(Change::operation).collect();
    let expected = [Operation::Set, Operation::Scale, Operation::Add];
    assert_eq!(operations, expected);
    let found = changes.iter().map(Change::unit).collect::<Vec<_>>();
    assert_eq!(found, ["kg", "", "m"]);
    for (change, value) in changes.iter().zip([3e5, 2.0, 10.0]) {
        change.apply(&mut description, value);
    }
    assert_eq!(description.rna.mass_kg, 3e5);
    assert_eq!(description.stations[0].wall_thickness_m, 0.054);
    assert_eq!(description.stations[1].wall_thickness_m, 0.038);
    assert_eq!(description.stations[1].height_m, 97.6);
    assert_eq!(description.wires[0].height_m, 50.0);
    let others = TowerDescription {
        rna: base.rna,
        stations: base.stations.clone(),
        wires: base.wires.clone(),
        ..description
    };
    assert_eq!(others, base);
}

/// A later change must not undo an earlier one; to scale a number that was set is no contradiction.
#[test]
fn a_change_that_overwrites_another_is_refused() {
    let description = tubes();
    let check = |names: [&str; 2]| Change::parse_all(names, &description).map(|_| ());
    let repeated = |parameter: &str, [first, second]: [&str; 2]| {
        Err(ParameterError::Repeated {
            parameter: parameter.into(),
            first: first.into(),
            second: second.into(),
        })
    };
    let twice = ["stations[*].wall", "stations[1].wall"];
    assert_eq!(check(twice), repeated("stations[1].wall", twice));
    let lost = ["scale(rna.mass)", "rna.mass"];
    assert_eq!(check(lost), repeated("rna.mass", lost));
    let moduli = [
        "materials[1].shear_modulus",
        "materials.S355.2.poissons_ratio",
    ];
    let expected = repeated("materials[1].poissons_ratio", moduli);
    assert_eq!(check(moduli), expected);
    assert_eq!(check(["rna.mass", "scale(rna.mass)"]), Ok(()));
    assert_eq!(check(["scale(rna.mass)", "add(rna.mass)"]), Ok(()));
}

#[test]
fn each_unit_is_one_of_the_tower_file() {
    let towers = towers();
    let all = towers.iter().flat_map(Parameter::all);
    let units: BTreeSet<&str> = all.map(Parameter::unit).collect();
    let expected = [
        "",
        "N",
        "N m",
        "N m2",
        "N/m",
        "N/m, N, N m",
        "N/m2",
        "Pa",
        "degrees",
        "kg",
        "kg m",
        "kg m2",
        "kg, kg m, kg m2",
        "kg/m",
        "kg/m3",
        "m",
        "m/s2",
        "rpm",
    ];
    assert_eq!(units, expected.into_iter().collect());
}

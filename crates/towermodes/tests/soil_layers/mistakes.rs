//! Mistakes: each at its place, with its numbers.

use super::scour::random_site;
use super::{Random, clay, ground_of, layer, oc3, sand};
use towermodes::{
    AxialModel, Foundation, LayerSoil, Parameter, Place, Problem, PyRow, Quantity, Sand,
    ShearModulus, SoilModel, Tower, TowerDescription, Warning,
};
use towermodes_testing::{Says, assert_matches, parts, with};

type Change = fn(&mut TowerDescription);

fn of(index: usize, key: &'static str) -> Place {
    Place::GroundLayer { index, key }
}

fn clay_layer(description: &mut TowerDescription, change: fn(&mut towermodes::Clay)) {
    let mut soil = clay();
    change(&mut soil);
    let layers = &mut ground_of(description).layers;
    layers[1] = layer([-25.0, -34.0], LayerSoil::Clay(soil), SoilModel::Api);
}

fn ground(key: &'static str) -> Place {
    Place::Ground { key }
}

/// What is wrong with a change of the tower, which is refused at this place.
#[track_caller]
fn refused(place: Place, change: Change) -> Problem {
    let mut description = oc3(SoilModel::Api);
    change(&mut description);
    let error = Tower::new(description).expect_err("a mistake");
    assert_eq!(error.place, place, "{error}");
    let says_how = error.hint().is_some() || error.problem.to_string().contains("must");
    assert!(says_how, "{error} has no hint");
    error.problem
}

#[test]
fn each_mistake_is_refused_at_its_place_with_its_numbers() {
    refused(of(1, "top"), |d| ground_of(d).layers[1].top_m = -25.5)
        .says("the layer begins at -25.5 m, but the layer above ends at -25 m: there is a gap between them");
    refused(of(1, "top"), |d| ground_of(d).layers[1].top_m = -24.0)
        .says("the layer begins at -24 m, but the layer above ends at -25 m: they overlap");
    refused(of(0, "top"), |d| ground_of(d).layers[0].top_m = -19.0)
        .says("the first layer begins at -19 m, but the surface of the ground is at -20 m");
    refused(ground("surface"), |d| ground_of(d).surface_m = -56.0)
        .says("the tower does not reach into the soil: its lowest station is at -56 m, the surface of the ground at -56 m with scour of 0 m");
    refused(ground("scour"), |d| ground_of(d).scour.local_m = 40.0)
        .says("the tower does not reach into the soil: its lowest station is at -56 m, the surface of the ground at -20 m with scour of 40 m");
    refused(ground("surface"), |d| ground_of(d).surface_m = 100.0)
        .says("the surface of the ground at 100 m is above the tower top at 87.6 m");
    refused(of(2, "bottom"), |d| ground_of(d).layers[2].bottom_m = -50.0)
        .says("the lowest layer ends at -50 m, above the tip of the pile at -56 m");
    refused(of(0, "bottom"), |d| ground_of(d).layers[0].bottom_m = -15.0)
        .says("the bottom of the layer at -15 m is not below its top at -20 m");
    // Exchanged heights join neither the surface nor each other.
    refused(of(0, "bottom"), |d| {
        for layer in &mut ground_of(d).layers {
            (layer.top_m, layer.bottom_m) = (layer.bottom_m, layer.top_m);
        }
    })
    .says("the bottom of the layer at -20 m is not below its top at -25 m");
    refused(ground("layer"), |d| ground_of(d).layers.clear()).says("the ground has no layers");
    refused(ground("factor"), |d| ground_of(d).factor = 0.0)
        .says("the factor on all springs of the ground is 0; it must be positive");
    refused(ground("scour.general"), |d| {
        ground_of(d).scour.general_m = -1.0;
    })
    .says("the depth of general scour is -1 m; it must not be negative");
    refused(of(1, "undrained_strength"), |d| {
        clay_layer(d, |clay| clay.undrained_strength_pa = Some([5e4, -1.0]));
    })
    .says("the undrained shear strength is -1 Pa; it must be positive");
    refused(of(1, "strength_factor"), |d| {
        clay_layer(d, |clay| clay.strength_factor = None);
    })
    .says("api needs the factor J (0.5 for soft, 0.25 for stiff clay)");
    refused(of(0, "effective_unit_weight"), |d| {
            clay_layer(d, |_| {});
            ground_of(d).layers[0].effective_unit_weight_n_per_m3 = None;
        })
        .says("the weight of the soil above, on which this layer or one below depends, needs the effective unit weight");
    refused(of(1, "model"), |d| {
        ground_of(d).layers[1].model = SoilModel::PisaCowden;
    })
    .says("the model pisa-cowden has no formula for sand");
    refused(of(1, "relative_density"), |d| {
        ground_of(d).layers[1].model = SoilModel::PisaDunkirk;
    })
    .says("pisa-dunkirk needs the relative density");
    refused(of(1, "relative_density"), |d| {
        ground_of(d).layers[1].soil = LayerSoil::Sand(with!(Sand, relative_density = Some(75.0)));
    })
    .says("the relative density is 75; it must be from 0 to 1");
    refused(of(1, "friction_angle"), |d| {
        let sand = with!(Sand, friction_angle_deg = Some(75.0));
        ground_of(d).layers[1].soil = LayerSoil::Sand(sand);
    })
    .says("the friction angle is 75 degrees; it must be above 0 and at most 60 degrees");
    refused(of(0, "shear_modulus"), |d| {
        ground_of(d).axial = Some(AxialModel::Kraft);
    })
    .says("axial = \"kraft\" in [ground] needs the shear modulus");
    refused(ground("pile_diameter"), |d| {
        ground_of(d).pile_diameter_m = Some(6.0);
    })
    .says("the diameter of the pile is given twice: its tubes have diameters");
}

#[test]
fn tables_cover_their_layer_from_the_top_down() {
    let row = |height_m| PyRow {
        height_m,
        displacement_m: 0.001,
        reaction_n_per_m: 1e5,
    };
    let with = |rows: &[PyRow]| {
        let mut description = oc3(SoilModel::Api);
        let soil = LayerSoil::Table(rows.to_vec());
        ground_of(&mut description).layers[1] = layer([-25.0, -34.0], soil, SoilModel::Table);
        Tower::new(description).map_err(|error| (error.place, error.problem))
    };
    assert!(with(&[row(-25.0), row(-30.0), row(-34.0)]).is_ok());
    let (place, problem) = with(&[row(-25.0), row(-33.0)]).expect_err("too short");
    let (layer, key) = (1, "height");
    assert_eq!(place, Place::GroundRow { layer, row: 0, key });
    assert!(matches!(problem, Problem::TableShorterThanLayer { .. }));
    let (place, problem) = with(&[row(-34.0), row(-25.0)]).expect_err("rises");
    assert_eq!(place, Place::GroundRow { layer, row: 1, key });
    assert!(matches!(problem, Problem::TableRowsRise { .. }));
    let (_, problem) = with(&[row(-25.0)]).expect_err("one row");
    assert!(matches!(problem, Problem::TooFewRows { .. }));
}

fn warnings_of(change: Change) -> Vec<Warning> {
    let mut description = oc3(SoilModel::Api);
    change(&mut description);
    Tower::new(description)
        .expect("possible")
        .warnings()
        .to_vec()
}

#[test]
fn correct_ground_has_no_warning() {
    for model in [SoilModel::Api, SoilModel::Kallehave, SoilModel::Sorensen] {
        let tower = Tower::new(oc3(model)).expect("valid");
        assert!(tower.warnings().is_empty(), "{:?}", tower.warnings());
    }
}

#[test]
fn wrong_units_are_warned_of() {
    let cases: [(Change, &str, Place); 6] = [
        (
            |d| ground_of(d).layers[0] = sand(-20.0, -25.0, 0.576, SoilModel::Api),
            "the friction angle",
            of(0, "friction_angle"),
        ),
        (
            |d| ground_of(d).layers[0] = sand(-20.0, -25.0, 52.0, SoilModel::Api),
            "the friction angle",
            of(0, "friction_angle"),
        ),
        (
            |d| clay_layer(d, |clay| clay.undrained_strength_pa = Some([40.0, 120.0])),
            "the undrained shear strength",
            of(1, "undrained_strength"),
        ),
        (
            |d| ground_of(d).layers[2].effective_unit_weight_n_per_m3 = Some(1.9e4),
            Quantity::BuoyantUnitWeight.name(),
            of(2, "effective_unit_weight"),
        ),
        (
            |d| {
                ground_of(d).submerged = false;
                ground_of(d).layers[2].effective_unit_weight_n_per_m3 = Some(18.0);
            },
            Quantity::SoilUnitWeight.name(),
            of(2, "effective_unit_weight"),
        ),
        (
            |d| {
                ground_of(d).layers[2].shear_modulus = Some(ShearModulus::RixStokoe {
                    cone_resistance_pa: [20.0, 40.0],
                });
            },
            "the cone resistance",
            of(2, "cone_resistance"),
        ),
    ];
    for (change, expected, place) in cases {
        let warnings = warnings_of(change);
        let found = warnings.iter().any(|warning| {
            matches!(warning, Warning::Unusual { quantity, site, .. }
                if quantity.name() == expected && site.place == Some(place))
        });
        assert!(found, "{expected:?}: {warnings:?}");
    }
}

#[test]
fn clamped_tips_and_unused_layers_are_warned_of() {
    let warnings = warnings_of(|d| d.foundation = Foundation::Clamped);
    assert!(warnings.contains(&Warning::SoilAndClamp), "{warnings:?}");
    let warnings = warnings_of(|d| {
        for (top_m, bottom_m) in [(-56.0, -60.0), (-60.0, -70.0)] {
            ground_of(d)
                .layers
                .push(sand(top_m, bottom_m, 35.0, SoilModel::Api));
        }
    });
    let places: Vec<_> = warnings
        .iter()
        .map(|warning| warning.site().and_then(|site| site.place))
        .collect();
    assert_eq!(places, [Some(of(4, "top"))], "{warnings:?}");
}

#[test]
fn pisa_out_of_range_is_warned_of() {
    let warnings = warnings_of(|d| {
        let soil = LayerSoil::Sand(with!(Sand, relative_density = Some(0.3)));
        let mut last = layer([-34.0, -56.0], soil, SoilModel::PisaDunkirk);
        last.shear_modulus = Some(ShearModulus::Given {
            shear_modulus_pa: [5e7, 1e8],
        });
        ground_of(d).layers[2] = last;
        ground_of(d).scour.general_m = 26.0;
    });
    let values: Vec<f64> = warnings
        .iter()
        .filter_map(|warning| match warning {
            Warning::OutsideFormula { value, .. } => Some(*value),
            _ => None,
        })
        .collect();
    assert_eq!(values, [10.0 / 6.0, 0.3], "{warnings:?}");
}

/// Water that does not fit the ground: the bed off the surface, dry soil under water, a level below
/// the surface.
#[test]
fn water_that_contradicts_the_ground_is_warned_of() {
    let warnings = |level_m, bed_m, submerged| {
        let mut description = oc3(SoilModel::Api);
        ground_of(&mut description).submerged = submerged;
        for layer in &mut ground_of(&mut description).layers {
            layer.effective_unit_weight_n_per_m3 = None;
        }
        description.water = Some(parts::water(level_m, bed_m, 1025.0, 1.0, false));
        Tower::new(description)
            .expect("possible")
            .warnings()
            .to_vec()
    };
    for bed_m in [None, Some(-20.0)] {
        assert_eq!(warnings(0.0, bed_m, true), []);
    }
    let off = warnings(0.0, Some(-22.0), true);
    assert_matches!(off[..], [Warning::BedOffSurface { .. }]);
    let dry = warnings(0.0, None, false);
    assert_matches!(dry[..], [Warning::DryUnderWater { .. }]);
    // Each names its value, so that it is shown at its line.
    let place = |key| Some(Place::Water { key });
    assert_eq!(off[0].place(), place("bed"));
    assert_eq!(dry[0].place(), Some(Place::Ground { key: "submerged" }));
    let low = warnings(-21.0, None, false);
    assert!(matches!(low[..], [Warning::NoEffect { .. }]), "{low:?}");
}

/// Any number of the ground at any size: a tower or an error, never a panic, and no frequency that
/// is not a number.
#[test]
fn no_number_makes_the_ground_panic() {
    let mut sites = Random(99);
    let sizes = [
        0.0,
        -1.0,
        1e-300,
        1e-9,
        1e9,
        1e29,
        1e300,
        f64::NAN,
        f64::INFINITY,
        -20.0,
        -56.0,
    ];
    for _ in 0..20 {
        let mut description = random_site(&mut sites);
        ground_of(&mut description).scour.local_m = 1.0;
        let names = Parameter::all(&description);
        let of_ground = names
            .iter()
            .filter(|name| name.to_string().starts_with("ground"));
        for parameter in of_ground {
            for size in sizes {
                let mut changed = description.clone();
                parameter.set(&mut changed, size);
                if let Ok(tower) = Tower::new(changed) {
                    let environments = tower.pieces().iter().map(|piece| piece.environment);
                    let soil = environments
                        .filter_map(|environment| environment.soil)
                        .flatten();
                    for springs in soil {
                        let lateral = springs.x_n_per_m2;
                        assert!(lateral.is_finite() && lateral >= 0.0, "{parameter} {size}");
                    }
                }
            }
        }
    }
}

/// Who gives a model for the wrong soil reads which models every soil has.
#[test]
fn a_model_of_another_soil_is_answered_with_the_models_of_each_soil() {
    let mut description = oc3(SoilModel::Api);
    ground_of(&mut description).layers[1].model = SoilModel::WeakRock;
    let error = Tower::new(description).expect_err("sand is no rock");
    let hint = error.hint().expect("the models");
    let soils: Vec<&str> = hint.split("; ").collect();
    assert_eq!(soils.len(), 4, "{hint}");
    assert_eq!(soils[2..], ["elastic: winkler, vesic", "rock: weak-rock"]);
    soils[0].says_all("sand: & pisa-dunkirk");
    soils[1].says_all("clay: & reese-stiff-clay & pisa-cowden");
}

/// Numbers that give springs, but not those of the soil that was meant.
#[test]
fn silent_nonsense_is_refused_or_warned_of() {
    let cone = |pair: [f64; 2]| ShearModulus::RobertsonCabal {
        cone_resistance_pa: pair,
        behaviour_index: 2.8,
        density_kg_per_m3: 1800.0,
    };
    let refused = |shear_modulus, soil: LayerSoil, key| {
        let mut description = oc3(SoilModel::Api);
        let mut own = layer([-25.0, -34.0], soil, SoilModel::Winkler);
        own.shear_modulus = Some(shear_modulus);
        own.poissons_ratio = Some(0.4);
        ground_of(&mut description).layers[1] = own;
        let error = Tower::new(description).expect_err("refused");
        assert_eq!(error.place, of(1, key));
        assert!(error.hint().is_some());
        error.problem
    };
    let of_clay = || LayerSoil::Clay(clay());
    let of_sand = || LayerSoil::Sand(Sand::default());
    // 14 m below the surface: 140 kPa of soil and 140 kPa of water.
    match refused(cone([2e5, 2.7e5]), of_clay(), "cone_resistance") {
        Problem::ConeBelowStress {
            height_m,
            stress_pa,
            ..
        } => assert_eq!((height_m, stress_pa), (-34.0, 2.8e5)),
        other => panic!("{other}"),
    }
    let cone_resistance_pa = [2e7; 2];
    let hardin = ShearModulus::Hardin {
        void_ratio: 0.6,
        earth_pressure_at_rest: 0.4,
    };
    let others = [
        (
            ShearModulus::RixStokoe { cone_resistance_pa },
            of_clay(),
            "correlation",
        ),
        (
            ShearModulus::MayneRix { cone_resistance_pa },
            of_sand(),
            "correlation",
        ),
        (hardin, of_clay(), "void_ratio"),
    ];
    for (modulus, soil, key) in others {
        let problem = refused(modulus, soil, key);
        assert_matches!(problem, Problem::CorrelationOfOtherSoil { .. });
    }
    type Factor = (fn(&mut towermodes::Clay), &'static str, &'static str);
    let factors: [Factor; 4] = [
        (
            |c| c.strength_factor = Some(5.0),
            "the factor J of the strength near the surface",
            "strength_factor",
        ),
        (
            |c| c.stiffness_factor = Some(0.3),
            "the factor of the initial stiffness",
            "stiffness_factor",
        ),
        (
            |c| c.stiffness_factor = Some(3000.0),
            "the factor of the initial stiffness",
            "stiffness_factor",
        ),
        (
            |c| c.strain_at_half_strength = Some(0.5),
            "the strain at half the strength",
            "strain_at_half_strength",
        ),
    ];
    for (change, expected, key) in factors {
        let mut description = oc3(SoilModel::Api);
        clay_layer(&mut description, change);
        let warnings = Tower::new(description).expect("possible");
        let warnings = warnings.warnings().iter();
        // The model has no use for one of these numbers, which is said too.
        let warnings = warnings.filter(|warning| {
            !matches!(
                warning,
                Warning::NoEffect { .. } | Warning::UnusedInLayer { .. }
            )
        });
        let warnings: Vec<&Warning> = warnings.collect();
        assert!(
            matches!(&warnings[..], [Warning::Unusual { quantity, site, .. }]
                if quantity.name() == expected && site.place == Some(of(1, key))),
            "{warnings:?}"
        );
    }
    let moduli = [
        (
            ShearModulus::RixStokoe {
                cone_resistance_pa: [2e4, 6e4],
            },
            "the cone resistance",
        ),
        (
            ShearModulus::Hardin {
                void_ratio: 0.6,
                earth_pressure_at_rest: 50.0,
            },
            "the coefficient of earth pressure at rest",
        ),
        (
            ShearModulus::Hardin {
                void_ratio: 60.0,
                earth_pressure_at_rest: 0.5,
            },
            "the void ratio",
        ),
    ];
    for (modulus, expected) in moduli {
        let mut description = oc3(SoilModel::Api);
        let own = &mut ground_of(&mut description).layers[1];
        (own.shear_modulus, own.poissons_ratio) = (Some(modulus), Some(0.3));
        let tower = Tower::new(description).expect("possible");
        let warnings = tower.warnings().iter();
        let warnings = warnings.filter(|warning| {
            !matches!(
                warning,
                Warning::NoEffect { .. } | Warning::UnusedInLayer { .. }
            )
        });
        let warnings: Vec<&Warning> = warnings.collect();
        assert!(
            matches!(&warnings[..], [Warning::Unusual { quantity, .. }] if quantity.name() == expected),
            "{warnings:?}"
        );
    }
    // The modulus k beside the friction angle.
    let warnings = warnings_of(|d| {
        let LayerSoil::Sand(sand) = &mut ground_of(d).layers[1].soil else {
            return;
        };
        sand.subgrade_modulus_n_per_m3 = Some(2e7);
    });
    assert!(
        matches!(&warnings[..], [Warning::NoEffect { site, .. }]
            if site.place == Some(of(1, "friction_angle"))),
        "{warnings:?}"
    );
}

/// PISA needs a pile that shears, and its springs under the tip are no foundation of their own.
#[test]
fn pisa_is_warned_of_without_shear_only() {
    let pisa = |shear| {
        let mut description = oc3(SoilModel::Api);
        description.shear = shear;
        for own in &mut ground_of(&mut description).layers {
            own.soil = LayerSoil::Clay(towermodes::Clay::default());
            own.model = SoilModel::PisaBothkennar;
            own.shear_modulus = Some(ShearModulus::Given {
                shear_modulus_pa: [3e6, 1.2e7],
            });
        }
        let tower = Tower::new(description).expect("valid");
        tower.warnings().to_vec()
    };
    let warnings = pisa(towermodes::Shear::Coefficient(0.5));
    assert_eq!(warnings, []);
    let warnings = pisa(towermodes::Shear::Rigid);
    assert!(
        matches!(&warnings[..], [Warning::PisaWithoutShear { site }]
            if site.place == Some(of(0, "model"))),
        "{warnings:?}"
    );
}

/// G₀ of a measurement stays after scour, G₀ by the void ratio does not; no note without scour, or
/// where the springs do not use it.
#[test]
fn a_modulus_that_does_not_follow_scour_is_noted() {
    let told = |model, modulus, scour_m: f64| {
        let warnings = warnings_of(|_| ());
        assert_eq!(warnings, []);
        let mut description = oc3(SoilModel::Api);
        let ground = ground_of(&mut description);
        ground.scour.local_m = scour_m;
        for own in &mut ground.layers {
            own.model = model;
            own.poissons_ratio = Some(0.3);
            own.shear_modulus = Some(modulus);
        }
        let tower = Tower::new(description).expect("valid");
        let mut warnings = tower.warnings().to_vec();
        warnings.retain(|warning| matches!(warning, Warning::ModulusBeforeScour { .. }));
        warnings
    };
    let given = ShearModulus::Given {
        shear_modulus_pa: [3e7, 9e7],
    };
    let hardin = ShearModulus::Hardin {
        void_ratio: 0.6,
        earth_pressure_at_rest: 0.4,
    };
    let warnings = told(SoilModel::Winkler, given, 4.0);
    assert_eq!(warnings.len(), 1);
    warnings[0].says("shear_modulus is a value before scour");
    assert_eq!(warnings[0].place(), Some(of(0, "shear_modulus")));
    assert_eq!(told(SoilModel::Winkler, given, 0.0), []);
    assert_eq!(told(SoilModel::Winkler, hardin, 4.0), []);
    assert_eq!(told(SoilModel::Api, given, 4.0), []);
}

/// Values that the models of a layer do not use are named in one warning for each layer.
#[test]
fn unused_values_of_a_layer_have_one_warning() {
    let warnings = warnings_of(|d| {
        let layer = &mut ground_of(d).layers[0];
        layer.poissons_ratio = Some(0.3);
        layer.shear_modulus = Some(ShearModulus::Given {
            shear_modulus_pa: [3e7, 9e7],
        });
    });
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    let Warning::UnusedInLayer { keys, .. } = &warnings[0] else {
        panic!("{warnings:?}");
    };
    let mut keys = keys.clone();
    keys.sort_unstable();
    assert_eq!(keys, ["poissons_ratio", "shear_modulus"]);
}

/// A table of springs in kN/m² beside layers.
#[test]
fn a_table_of_springs_in_other_units_beside_layers_is_warned_of() {
    let told = |spring| {
        let mut description = oc3(SoilModel::Api);
        let row = |height_m| towermodes::SoilRow {
            height_m,
            stiffness: towermodes::SoilStiffness {
                x_n_per_m2: spring,
                y_n_per_m2: spring,
                ..towermodes::SoilStiffness::default()
            },
        };
        description.soil = vec![vec![row(-40.0), row(-30.0)]];
        let tower = Tower::new(description).expect("valid");
        tower
            .warnings()
            .iter()
            .map(Warning::place)
            .collect::<Vec<_>>()
    };
    assert_eq!(told(1e8), []);
    let (layer, row, key) = (0, 1, "x");
    assert_eq!(told(1e5), [Some(Place::Soil { layer, row, key })]);
}

/// Normally consolidated clay begins with no strength, Gibson's soil with no stiffness; soil that
/// has none anywhere is refused.
#[test]
fn strength_may_be_zero_at_one_end_of_a_layer() {
    let tower = |bottom_pa: f64| {
        let mut description = oc3(SoilModel::Api);
        clay_layer(&mut description, |_| {});
        let mut soil = clay();
        soil.undrained_strength_pa = Some([0.0, bottom_pa]);
        let layers = &mut ground_of(&mut description).layers;
        layers[0] = layer([-20.0, -25.0], LayerSoil::Clay(soil), SoilModel::Api);
        let mut own = layer([-34.0, -56.0], LayerSoil::Elastic, SoilModel::Winkler);
        own.poissons_ratio = Some(0.49);
        own.shear_modulus = Some(ShearModulus::Given {
            shear_modulus_pa: [0.0, 5e7],
        });
        layers[2] = own;
        Tower::new(description)
    };
    let springs = tower(2e4).expect("legal").springs_of_soil();
    let last = springs.last().expect("springs");
    assert_eq!(last.height_m, -20.0);
    assert!(last.lateral_n_per_m2 >= 0.0);
    let error = tower(0.0).expect_err("no strength");
    assert_eq!(error.place, of(0, "undrained_strength"));
}

/// Rock along the axis: no t-z curve of API, but the springs of Kraft by its shear modulus.
#[test]
fn axial_springs_in_rock_have_a_formula_or_a_reason() {
    let with = |axial, poissons_ratio| {
        let mut description = oc3(SoilModel::Api);
        let rock = LayerSoil::Rock(towermodes::Rock {
            youngs_modulus_pa: Some([1e8; 2]),
        });
        let mut own = layer([-34.0, -56.0], rock, SoilModel::WeakRock);
        own.poissons_ratio = poissons_ratio;
        let ground = ground_of(&mut description);
        ground.layers[2] = own;
        ground.axial = Some(axial);
        for own in &mut ground.layers[..2] {
            own.shaft_friction_pa = Some([6e4; 2]);
            own.shear_modulus = Some(ShearModulus::Given {
                shear_modulus_pa: [6e7; 2],
            });
        }
        Tower::new(description)
    };
    let error = with(AxialModel::Api, None).expect_err("no curve");
    assert_eq!(error.place, of(2, "type"));
    assert!(matches!(error.problem, Problem::AxialOfOtherSoil { .. }));
    error.hint().expect("a hint").says("kraft");
    let error = with(AxialModel::Kraft, None).expect_err("no ratio");
    assert_eq!(error.place, of(2, "poissons_ratio"));
    let springs = with(AxialModel::Kraft, Some(0.25)).expect("valid");
    let deepest = springs.springs_of_soil()[0].vertical_n_per_m2;
    let expected = 2.0 * std::f64::consts::PI * 4e7 / 10.0_f64.ln();
    assert!((deepest / expected - 1.0).abs() < 1e-9, "{deepest}");
}

/// Of 36 m in the ground scour of 17 m leaves more than half, of 34 m 2 m.
#[test]
fn scour_that_leaves_little_of_a_pile_is_warned_of() {
    let warnings = |local_m: f64| {
        let mut description = oc3(SoilModel::Api);
        ground_of(&mut description).scour.local_m = local_m;
        let tower = Tower::new(description).expect("possible");
        let said = tower.warnings().iter().map(ToString::to_string);
        said.filter(|text| text.contains("scour of"))
            .collect::<Vec<_>>()
    };
    assert_eq!(warnings(17.0), [""; 0]);
    let deep = warnings(34.0);
    assert_eq!(deep.len(), 1, "{deep:?}");
    deep[0].says("scour of 34 m leaves 2 m of the embedded length of 36 m");
}

/// One end of a layer in kPa, the other in Pa.
#[test]
fn a_pair_in_two_units_is_warned_of() {
    let warnings = |strength_pa: [f64; 2]| {
        let mut description = oc3(SoilModel::Api);
        let mut soil = clay();
        soil.undrained_strength_pa = Some(strength_pa);
        let layers = &mut ground_of(&mut description).layers;
        layers[1] = layer([-25.0, -34.0], LayerSoil::Clay(soil), SoilModel::Api);
        let tower = Tower::new(description).expect("possible");
        let said = tower.warnings().iter().map(ToString::to_string);
        said.filter(|text| text.contains("undrained shear strength is"))
            .collect::<Vec<_>>()
    };
    assert_eq!(warnings([8e4, 1.2e5]), [""; 0]);
    let mixed = warnings([8e4, 120.0]);
    assert_eq!(mixed.len(), 1, "{mixed:?}");
    mixed[0].says("the undrained shear strength is 120 Pa; expected 1000 to");
}

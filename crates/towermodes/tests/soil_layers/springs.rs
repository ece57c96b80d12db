//! The springs of each model at a height, by hand.

use super::scour::random_site;
use super::{Random, clay, first_hz, free_tip, ground, ground_of, layer, oc3, sand};
use crate::towers::assert_close;
use std::f64::consts::PI;
use towermodes::{
    ApiEdition, AxialModel, GroundLayer, LayerSoil, Method, Options, Problem, Properties,
    PropertyStation, PyRow, Rock, Sand, ShearModulus, SoilModel, SoilStiffness, Tower,
    TowerDescription,
};
use towermodes_testing::with;

/// The OC3 monopile (D = 6 m) in one layer from −20 m to −56 m.
fn in_layer(own: GroundLayer) -> TowerDescription {
    let mut description = oc3(SoilModel::Api);
    description.ground = Some(ground(vec![own]));
    description.foundation = free_tip();
    description
}

const ENDS_M: [f64; 2] = [-20.0, -56.0];

/// The springs at a depth below the surface at −20 m.
fn springs(description: &TowerDescription, depth_m: f64) -> SoilStiffness {
    let tower = Tower::new(description.clone()).expect("valid");
    let height_m = -20.0 - depth_m;
    let pieces = tower.pieces();
    let inside = |piece: &&towermodes::tower::Piece| piece.top_m > height_m;
    let piece = pieces.iter().find(inside).expect("a piece");
    let share = (height_m - piece.base_m) / piece.length_m();
    let [low, high] = piece.environment.soil.expect("soil");
    let blend = |a: f64, b: f64| a + share * (b - a);
    SoilStiffness {
        x_n_per_m2: blend(low.x_n_per_m2, high.x_n_per_m2),
        y_n_per_m2: blend(low.y_n_per_m2, high.y_n_per_m2),
        z_n_per_m2: blend(low.z_n_per_m2, high.z_n_per_m2),
        torsion_n: blend(low.torsion_n, high.torsion_n),
        rotation_x_n: blend(low.rotation_x_n, high.rotation_x_n),
        rotation_y_n: blend(low.rotation_y_n, high.rotation_y_n),
    }
}

/// The modulus of API by its friction angle, MN/m³, in both editions: the table (25, 30, 35, 40
/// degrees) with lines between, and the fit to the figure below and above water.
#[test]
fn sand_has_the_modulus_of_its_friction_angle() {
    let table = [
        // An angle in radians does not become a firm sand.
        (0.6, [5.4, 5.4, 5.4]),
        (15.0, [5.4, 5.4, 5.4]),
        (25.0, [5.4, 5.4, 5.4]),
        (28.0, [8.76, 5.4, 5.4]),
        (30.0, [11.0, 7.9, 10.5]),
        (33.0, [17.6, 14.6, 26.5]),
        (35.0, [22.0, 21.0, 39.3]),
        (36.0, [26.6, 24.8, 46.3]),
        (38.0, [35.8, 33.6, 61.7]),
        (40.0, [45.0, 44.0, 78.9]),
        // Neither source has more.
        (45.0, [45.0, 44.0, 78.9]),
    ];
    let editions = [
        (ApiEdition::Rp2Geo, true),
        (ApiEdition::Rp2A, true),
        (ApiEdition::Rp2A, false),
    ];
    for (angle_deg, expected) in table {
        for ((edition, submerged), expected) in editions.into_iter().zip(expected) {
            let mut description = in_layer(sand(-20.0, -56.0, angle_deg, SoilModel::Api));
            ground_of(&mut description).edition = edition;
            ground_of(&mut description).submerged = submerged;
            let k = springs(&description, 10.0).x_n_per_m2 / 10.0 / 1e6;
            assert!((k - expected).abs() < 0.051, "{angle_deg} {edition:?}: {k}");
            // Linear from zero at the surface.
            let deep = springs(&description, 30.0).x_n_per_m2 / 30.0 / 1e6;
            assert_close(deep, k, 1e-12, "k z");
        }
    }
    let mut given = sand(-20.0, -56.0, 30.0, SoilModel::Api);
    given.soil = LayerSoil::Sand(with!(Sand, subgrade_modulus_n_per_m3 = Some(2.2e7)));
    assert_close(
        springs(&in_layer(given), 10.0).y_n_per_m2,
        2.2e8,
        1e-12,
        "given",
    );
}

/// Clay at 10 m with S_u = 40 + 80 · 10/36 kPa, γ′ = 10 kN/m³, ε₅₀ = 0.01, J = 0.5.
#[test]
fn clay_has_the_stated_secants() {
    let strength = 4e4 + 8e4 * 10.0 / 36.0;
    let shallow: f64 = (3.0 * strength + 1e5) * 6.0 + 0.5 * strength * 10.0;
    let ultimate = shallow.min(9.0 * strength * 6.0);
    // The mean strength down to 10 m.
    let mean = 4e4 + 8e4 * 5.0 / 36.0;
    let wedge: f64 = (2.0 * mean + 1e5) * 6.0 + 2.83 * mean * 10.0;
    let reese = wedge.min(11.0 * strength * 6.0);
    let cases = [
        (SoilModel::Api, 2.3 * ultimate / (2.5 * 0.01 * 6.0)),
        (
            SoilModel::Dnv,
            10.0 * ultimate / (6.0 * 0.01_f64.powf(0.25)),
        ),
        (
            SoilModel::ReeseStiffClay,
            5.0 * reese * 0.1_f64.sqrt() / 0.06,
        ),
    ];
    for (model, expected) in cases {
        let description = in_layer(layer(ENDS_M, LayerSoil::Clay(clay()), model));
        let got = springs(&description, 10.0).x_n_per_m2;
        // The rows replace a curve by lines with the same force and moment.
        assert_close(got, expected, 5e-4, model.name());
    }
}

#[test]
fn rock_tables_and_elastic_soil_have_their_springs() {
    let rock = LayerSoil::Rock(Rock {
        youngs_modulus_pa: Some([1e8, 1e8]),
    });
    let rock = in_layer(layer(ENDS_M, rock, SoilModel::WeakRock));
    assert_close(springs(&rock, 9.0).x_n_per_m2, 3e10, 1e-12, "rock");
    let got = springs(&rock, 18.0 + 1e-9).x_n_per_m2;
    assert_close(got, 5e10, 1e-9, "deep rock");
    let row = |height_m, reaction_n_per_m| PyRow {
        height_m,
        displacement_m: 0.002,
        reaction_n_per_m,
    };
    let rows = vec![row(-20.0, 1e5), row(-30.0, 3e5), row(-60.0, 3e5)];
    let table = in_layer(layer(ENDS_M, LayerSoil::Table(rows), SoilModel::Table));
    assert_close(springs(&table, 5.0).x_n_per_m2, 1e8, 1e-12, "table");
    assert_close(springs(&table, 20.0).x_n_per_m2, 1.5e8, 1e-12, "table");
    let elastic = |model| {
        let mut own = layer(ENDS_M, LayerSoil::Elastic, model);
        own.poissons_ratio = Some(0.25);
        own.shear_modulus = Some(ShearModulus::Youngs {
            youngs_modulus_pa: [2e7, 2e7],
        });
        springs(&in_layer(own), 10.0).x_n_per_m2
    };
    assert_close(elastic(SoilModel::Winkler), 2.4e7, 1e-12, "Winkler");
    let bending = 2.1e11 * PI / 64.0 * (6.0_f64.powi(4) - 5.88_f64.powi(4));
    let ratio = (2e7 * 6.0_f64.powi(4) / bending).powf(1.0 / 12.0);
    let expected = 0.65 * ratio * 2e7 / (1.0 - 0.0625);
    assert_close(elastic(SoilModel::Vesic), expected, 1e-12, "Vesic");
}

/// Shear moduli by correlation, from Winkler springs 1.2 · 2 (1 + ν) G at 10 m.
#[test]
fn shear_moduli_follow_from_soundings() {
    let modulus = |shear_modulus| {
        let mut own = layer(ENDS_M, LayerSoil::Elastic, SoilModel::Winkler);
        own.poissons_ratio = Some(0.25);
        own.shear_modulus = Some(shear_modulus);
        springs(&in_layer(own), 10.0).x_n_per_m2 / 3.0
    };
    let cone_resistance_pa = [1e7, 1e7];
    let (velocity, density_kg_per_m3) = (200.0, 1900.0);
    let cases = [
        (
            ShearModulus::WaveVelocity {
                velocity_m_per_s: [velocity; 2],
                density_kg_per_m3,
            },
            7.6e7,
        ),
        (
            ShearModulus::RixStokoe { cone_resistance_pa },
            1634e3 * 1e4_f64.powf(0.25) * 100.0_f64.powf(0.375),
        ),
        (
            ShearModulus::MayneRix { cone_resistance_pa },
            2.78e3 * 1e4_f64.powf(1.335),
        ),
        (
            ShearModulus::RobertsonCabal {
                cone_resistance_pa,
                behaviour_index: 2.0,
                density_kg_per_m3,
            },
            density_kg_per_m3 * 10_f64.powf(2.78) * (1e7 - 2e5) / 100e3,
        ),
        (
            ShearModulus::Hardin {
                void_ratio: 0.628,
                earth_pressure_at_rest: 0.4,
            },
            875.0 * 101.3e3 / (0.3 + 0.7 * 0.628 * 0.628) * (6e4_f64 / 101.3e3).sqrt(),
        ),
        (
            ShearModulus::BlowCount {
                blow_count: [20.0; 2],
                density_kg_per_m3,
            },
            density_kg_per_m3 * (97.0 * 20.0_f64.powf(0.314)).powi(2),
        ),
    ];
    for (shear_modulus, expected) in cases {
        let case = format!("{shear_modulus:?}");
        assert_close(modulus(shear_modulus), expected, 2e-3, &case);
    }
}

/// Along the axis: per metre of a shaft of D = 6 m, and at the tip.
#[test]
fn axial_springs_have_their_formulas() {
    let mut own = layer(ENDS_M, LayerSoil::Clay(clay()), SoilModel::Api);
    own.shaft_friction_pa = Some([3e4, 3e4]);
    own.end_bearing_pa = Some(1e6);
    own.poissons_ratio = Some(0.5);
    own.shear_modulus = Some(ShearModulus::Given {
        shear_modulus_pa: [4e7, 4e7],
    });
    let mut description = in_layer(own);
    let zone = (2.5 * 36.0 * 0.5 / 3.0_f64).ln();
    let cases = [
        (AxialModel::Api, PI * 3e4 * 0.3 / 0.0016, 0.0),
        (AxialModel::Kraft, 2.0 * PI * 4e7 / 10.0_f64.ln(), 0.0),
        (
            AxialModel::RandolphWroth,
            2.0 * PI * 4e7 / zone,
            4.0 * PI * 4e7 * 9.0,
        ),
    ];
    for (axial, vertical, torsion) in cases {
        ground_of(&mut description).axial = Some(axial);
        let got = springs(&description, 12.0);
        assert_close(got.z_n_per_m2, vertical, 1e-12, axial.name());
        let holds = (got.torsion_n - torsion).abs() <= 1e-12 * torsion;
        assert!(holds, "{axial:?}");
    }
    // A tip that rests on the soil alone.
    let tips = [
        (AxialModel::Api, 0.25e6 * PI * 9.0 / 0.012, 0.0),
        (
            AxialModel::RandolphWroth,
            4.0 * 4e7 * 3.0 / 0.5,
            16.0 * 4e7 * 27.0 / 3.0,
        ),
    ];
    for (axial, vertical, torsion) in tips {
        ground_of(&mut description).axial = Some(axial);
        let springs = towermodes::FoundationSprings {
            lateral_n_per_m: 0.0,
            rocking_n_m: 0.0,
            coupling_n: 0.0,
            vertical_n_per_m: 0.0,
            torsion_n_m: if torsion > 0.0 { 0.0 } else { f64::INFINITY },
        };
        description.foundation = towermodes::Foundation::Springs(springs);
        let tower = Tower::new(description.clone()).expect("valid");
        let base = tower.base();
        assert_close(base.stiffness[2][2], vertical, 1e-12, axial.name());
        assert!((base.stiffness[5][5] - torsion).abs() <= 1e-12 * torsion);
    }
}

/// The factor multiplies every spring, those at the tip too; the tip's add to the foundation.
#[test]
fn the_factor_multiplies_everything() {
    let mut own = layer(ENDS_M, LayerSoil::Clay(clay()), SoilModel::PisaCowden);
    own.shear_modulus = Some(ShearModulus::Given {
        shear_modulus_pa: [4e7, 4e7],
    });
    let mut description = in_layer(own);
    let tip = |description: &TowerDescription| {
        let tower = Tower::new(description.clone()).expect("valid");
        [tower.base().stiffness[0][0], tower.base().stiffness[4][4]]
    };
    let (single, base) = (springs(&description, 12.0), tip(&description));
    assert_close(base[0], (2.717 - 0.3575 * 6.0) * 4e7 * 6.0, 1e-12, "shear");
    let expected = (0.2146 - 0.002132 * 6.0) * 4e7 * 216.0;
    assert_close(base[1], expected, 1e-12, "moment");
    let expected = (10.6 - 1.65 * 2.0) * 4e7;
    assert_close(single.x_n_per_m2, expected, 1e-12, "lateral");
    let rotation = (1.42 - 0.09643 * 2.0) * 4e7 * 36.0;
    assert_close(single.rotation_y_n, rotation, 1e-12, "rotation");
    ground_of(&mut description).factor = 2.0;
    let (double, doubled) = (springs(&description, 12.0), tip(&description));
    assert_close(double.x_n_per_m2, 2.0 * single.x_n_per_m2, 1e-12, "factor");
    let expected = 2.0 * single.rotation_x_n;
    assert_close(double.rotation_x_n, expected, 1e-12, "factor");
    assert_close(doubled[0], 2.0 * base[0], 1e-12, "factor");
    if let towermodes::Foundation::Springs(springs) = &mut description.foundation {
        springs.lateral_n_per_m = 1e9;
    }
    assert_close(tip(&description)[0], 2.0 * base[0] + 1e9, 1e-12, "sum");
}

/// Thinner layers of the same soil are divided into shorter rows: no frequency changes by more than
/// the stated errors, which are small.
#[test]
fn rows_are_as_fine_as_they_need_to_be() {
    let mut random = Random(5);
    for site in 0..80 {
        let mut coarse = random_site(&mut random);
        let ground = ground_of(&mut coarse);
        ground.scour.local_m = [0.0, 4.0, 10.0, 0.5][site % 4];
        if site % 3 == 0 {
            ground.axial = Some(AxialModel::Kraft);
            for layer in &mut ground.layers {
                layer.shear_modulus = layer.shear_modulus.or(Some(ShearModulus::Given {
                    shear_modulus_pa: [2e7, 9e7],
                }));
            }
        }
        let mut fine = coarse.clone();
        let ground = ground_of(&mut fine);
        ground.layers = ground.layers.iter().flat_map(thin).collect();
        let modes = |description| {
            let options = with!(Options, method = Method::Spectral, modes = 4);
            crate::towers::solved(description, &options).modes
        };
        for (coarse, fine) in modes(&coarse).iter().zip(&modes(&fine)) {
            let difference = (fine.frequency_hz / coarse.frequency_hz - 1.0).abs();
            let stated = (fine.error_hz() + coarse.error_hz()) / coarse.frequency_hz;
            let holds = difference <= stated && difference < 1e-8;
            assert!(holds, "site {site}: {difference:.1e}, stated {stated:.1e}");
        }
    }
}

/// The same soil in eight layers.
fn thin(layer: &GroundLayer) -> Vec<GroundLayer> {
    let share = |part: usize, [top, bottom]: [f64; 2]| {
        let at = |part: usize| match part {
            0 => top,
            8 => bottom,
            part => top + part as f64 / 8.0 * (bottom - top),
        };
        [at(part), at(part + 1)]
    };
    let part = |part: usize| {
        let mut own = layer.clone();
        [own.top_m, own.bottom_m] = share(part, [layer.top_m, layer.bottom_m]);
        if let Some(ShearModulus::Given { shear_modulus_pa }) = &mut own.shear_modulus {
            *shear_modulus_pa = share(part, *shear_modulus_pa);
        }
        if let LayerSoil::Clay(clay) = &mut own.soil {
            clay.undrained_strength_pa = clay.undrained_strength_pa.map(|pair| share(part, pair));
        }
        own
    };
    (0..8).map(part).collect()
}

/// The rows of a tower in the ground, given as such, are the same tower.
#[test]
fn the_ground_as_rows_of_soil_is_the_same_tower() {
    let mut random = Random(7);
    for _ in 0..10 {
        let mut description = random_site(&mut random);
        ground_of(&mut description).scour.local_m = 2.0;
        description.part_names.ground = vec!["upper".into()];
        let rows = description.with_ground_as_soil();
        assert_eq!(rows.ground, None);
        assert_eq!(rows.part_names.soil[0], "upper");
        assert_eq!(first_hz(&rows), first_hz(&description));
        // Half the soil is half of its rows.
        let [soft, softer] =
            [description, rows].map(|tower| first_hz(&tower.with_soil_factor(0.5)));
        // The parts into which the ground is cut follow its stiffness.
        assert_close(soft, softer, 1e-8, "factor");
    }
    // PISA's springs under the tip are in the foundation.
    let mut own = layer(ENDS_M, LayerSoil::Clay(clay()), SoilModel::PisaCowden);
    own.shear_modulus = Some(ShearModulus::Given {
        shear_modulus_pa: [4e7, 8e7],
    });
    let description = in_layer(own);
    let rows = description.with_ground_as_soil();
    assert_eq!(first_hz(&rows), first_hz(&description));
    assert!(matches!(
        rows.foundation,
        towermodes::Foundation::Stiffness(_)
    ));
    assert_eq!(rows.with_ground_as_soil(), rows);
}

/// A tower that is given by a table of properties needs the diameter of its pile, and no more.
#[test]
fn a_table_of_properties_stands_in_the_ground_too() {
    for model in [SoilModel::Kallehave, SoilModel::Sorensen] {
        let tubes = oc3(model);
        let tower = Tower::new(tubes.clone()).expect("valid");
        let mut table = tubes.clone();
        table.stations.clear();
        table.materials.clear();
        let ends = tower.pieces().iter().flat_map(|piece| {
            [piece.base_m, piece.top_m].map(|height_m| (height_m, piece.section_at(height_m)))
        });
        table.properties = ends
            .map(|(height_m, section)| PropertyStation {
                height_m,
                properties: Properties {
                    mass_kg_per_m: section.masses.mass_kg_per_m,
                    rotary_inertia_kg_m: section.masses.rotary_inertia_kg_m,
                    polar_inertia_kg_m: section.masses.polar_inertia_kg_m,
                    bending_n_m2: section.bending_n_m2,
                    torsion_n_m2: section.torsion_n_m2,
                    axial_n: section.axial_n,
                    shear_n: None,
                },
            })
            .collect();
        let error = Tower::new(table.clone()).expect_err("no diameter");
        assert_eq!(error.problem, Problem::PileWithoutDiameter);
        ground_of(&mut table).pile_diameter_m = Some(6.0);
        let mut with_rows = table.clone();
        with_rows.ground = None;
        with_rows.soil = tubes.with_ground_as_soil().soil;
        assert_close(first_hz(&table), first_hz(&with_rows), 1e-6, model.name());
    }
}

/// k_p of PISA ends at 6.4 D: the static stiffness of a pile of ten diameters at the surface, by an
/// integration of the formula.
#[test]
fn pisa_with_a_constant_modulus_ends_where_its_formula_does() {
    let soil = LayerSoil::Clay(towermodes::Clay::default());
    let mut own = layer([-20.0, -90.0], soil, SoilModel::PisaCowden);
    own.shear_modulus = Some(ShearModulus::Given {
        shear_modulus_pa: [6e7, 6e7],
    });
    let mut description = in_layer(own);
    description.stations[0].height_m = -80.0;
    let surface = springs(&description, 1e-6).x_n_per_m2;
    assert_close(surface, 10.6 * 6e7, 1e-6, "at the surface");
    assert_eq!(springs(&description, 6.5 * 6.0).x_n_per_m2, 0.0);
    let end = springs(&description, 6.0 * 6.0).x_n_per_m2;
    assert_close(end, (10.6 - 1.65 * 6.0) * 6e7, 1e-9, "above the end");
}

/// A factor of a layer multiplies its springs alone.
#[test]
fn the_factor_of_a_layer_multiplies_its_springs() {
    let mut description = oc3(SoilModel::Api);
    let single = [2.0, 10.0].map(|depth_m| springs(&description, depth_m).x_n_per_m2);
    ground_of(&mut description).layers[1].factor = 3.0;
    let triple = [2.0, 10.0].map(|depth_m| springs(&description, depth_m).x_n_per_m2);
    assert_close(triple[0], single[0], 1e-12, "another layer");
    assert_close(triple[1], 3.0 * single[1], 1e-12, "its own");
}

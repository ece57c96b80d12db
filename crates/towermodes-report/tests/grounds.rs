//! Pictures of what holds and surrounds a tower, beyond what the examples have.

use crate::pictures;

use pictures::{look, plain, steel};
use towermodes::{
    BeamFormula, CircularFooting, FloatingPlatform, FootingFormula, Foundation, FoundationSprings,
    Ground, GroundLayer, Inertia, LayerSoil, Monopile, Options, PileFormula, PileTube,
    RectangularFooting, ReferredMatrix, Rna, Sand, Scour, SoilModel, SoilProfile, SoilRow,
    SoilSpring, SoilStiffness, StiffnessFoundation, SuctionCaisson, Tower, TowerDescription,
    WinklerPile, solve,
};
use towermodes_report::figures::{self, Substance};
use towermodes_report::svg::Look;
use towermodes_testing::{Says, changed, parts, stations, with};

const PILE: PileTube = PileTube {
    diameter_m: 7.0,
    wall_thickness_m: 0.08,
    embedded_length_m: 30.0,
    youngs_modulus_pa: 2.1e11,
};

fn monopile() -> Foundation {
    Foundation::Monopile(Box::new(Monopile {
        tube: PILE,
        formula: PileFormula::ShadlouBhattacharya,
        soil_profile: SoilProfile::Linear,
        soil_youngs_modulus_pa: 3e7,
        soil_poissons_ratio: 0.3,
        vertical_n_per_m: f64::INFINITY,
        torsion_n_m: 1e11,
    }))
}

fn winkler_pile() -> Foundation {
    Foundation::WinklerPile(Box::new(WinklerPile {
        tube: PILE,
        formula: BeamFormula::Exact,
        soil_spring: SoilSpring::Given {
            spring_n_per_m2: 1e8,
        },
        exponent: 1.0,
        vertical_n_per_m: 1e9,
        torsion_n_m: f64::INFINITY,
    }))
}

fn circular_footing(embedment_m: f64) -> Foundation {
    let lower_pa = if embedment_m > 0.0 {
        f64::INFINITY
    } else {
        1e9
    };
    Foundation::CircularFooting(Box::new(CircularFooting {
        radius_m: 9.0,
        embedment_m,
        shear_modulus_pa: 5e7,
        poissons_ratio: 0.3,
        stratum_thickness_m: 20.0,
        lower_shear_modulus_pa: lower_pa,
        is_coupled: true,
    }))
}

fn rectangular_footing(length_x_m: f64, length_y_m: f64) -> Foundation {
    Foundation::RectangularFooting(Box::new(RectangularFooting {
        formula: FootingFormula::Gazetas,
        length_x_m,
        length_y_m,
        embedment_m: 2.0,
        shear_modulus_pa: 5e7,
        poissons_ratio: 0.3,
        is_coupled: false,
    }))
}

fn caisson(skirt_length_m: f64) -> Foundation {
    Foundation::SuctionCaisson(Box::new(SuctionCaisson {
        diameter_m: 10.0,
        skirt_length_m,
        soil_profile: SoilProfile::Linear,
        soil_youngs_modulus_pa: 4e7,
        soil_poissons_ratio: 0.3,
        vertical_n_per_m: f64::INFINITY,
        torsion_n_m: f64::INFINITY,
    }))
}

#[test]
fn every_foundation() {
    let springs = |lateral, rocking, vertical, torsion| {
        Foundation::Springs(parts::springs(lateral, rocking, 0.0, vertical, torsion))
    };
    let inf = f64::INFINITY;
    let mut matrices = StiffnessFoundation::default();
    for i in 0..6 {
        matrices.stiffness[i][i] = if i == 2 { inf } else { 1.234_567e9 };
        matrices.inertia[i][i] = 1e5;
    }
    let half_space = |radius_m, embedment_m| {
        Foundation::HalfSpace(parts::half_space(radius_m, embedment_m, 4e7, 0.35))
    };
    for (what, foundation) in [
        (
            "rigid springs",
            Foundation::Springs(FoundationSprings::RIGID),
        ),
        ("soft springs", springs(1e7, 1e9, 1e8, 1e9)),
        ("some rigid springs", springs(inf, 1e9, inf, 1e9)),
        ("rocking rigid", springs(1e7, inf, 1e8, inf)),
        ("matrix", Foundation::Stiffness(Box::new(matrices))),
        ("footing", half_space(9.0, 3.0)),
        ("wide deep footing", half_space(300.0, 500.0)),
        ("footing on the surface", half_space(9.0, 0.0)),
        ("footing over rock", circular_footing(3.0)),
        ("footing over a stratum", circular_footing(0.0)),
        ("long footing", rectangular_footing(18.0, 12.0)),
        ("wide footing", rectangular_footing(12.0, 400.0)),
        ("caisson", caisson(9.0)),
        ("deep caisson", caisson(30.0)),
        ("monopile", monopile()),
        ("pile on springs", winkler_pile()),
    ] {
        let description = changed!(plain(), foundation);
        look(what, &description, 8);
    }
}

#[test]
fn a_barge_whose_centre_is_above_the_base() {
    let mut hydrostatic = ReferredMatrix::default();
    for (i, value) in [1e5, 1e5, 4e6, 5e9, 5e9, 1e8].into_iter().enumerate() {
        hydrostatic.matrix[i][i] = value;
    }
    for (what, z_m, surface_m) in [
        ("barge", 1.0, -2.0),
        ("deep platform", -900.0, -3.0),
        ("base under water", -20.0, 12.0),
    ] {
        let platform = FloatingPlatform {
            mass_kg: 5e6,
            center_m: [30.0, 0.0, z_m],
            inertia_kg_m2: with!(Inertia, xx = 1e10, yy = 1e10, zz = 1e10),
            hydrostatic: changed!(hydrostatic, height_m = surface_m),
            mooring: changed!(hydrostatic, height_m = -100.0),
            ..FloatingPlatform::default()
        };
        let description = TowerDescription {
            foundation: Foundation::Floating(Box::new(platform)),
            ..plain()
        };
        look(what, &description, 12);
    }
}

#[test]
fn much_around_a_tower() {
    let layer = |from: f64, to: f64, stiffness: f64| {
        let springs = SoilStiffness {
            x_n_per_m2: stiffness,
            y_n_per_m2: 0.8 * stiffness,
            z_n_per_m2: 1e6,
            torsion_n: 1e7,
            ..SoilStiffness::default()
        };
        [from, to]
            .map(|height_m| SoilRow {
                height_m,
                stiffness: springs,
            })
            .to_vec()
    };
    let soil = (0..30).map(|k| {
        layer(
            -30.0 + f64::from(k),
            -29.0 + f64::from(k),
            1e7 + 2e6 * f64::from(k),
        )
    });
    let wires = |height_m: f64| parts::wires(height_m, 4, 1.234_567e6, 60.0);
    let description = TowerDescription {
        name: "North <sea> & \"more\"".to_owned(),
        soil: soil.collect(),
        water: Some(parts::water(12.0, Some(0.0), 1025.0, 1.0, false)),
        added_mass: vec![vec![
            parts::added_mass_row(0.0, 900.0),
            parts::added_mass_row(12.0, 900.0),
        ]],
        wires: (1..10).map(|k| wires(20.0 + 5.0 * f64::from(k))).collect(),
        foundation: Foundation::Springs(parts::springs(1e8, 1e10, -1e8, 1e9, 1e9)),
        rna: Rna::point(100e3),
        ..steel(stations(&[(-30.0, 6.0, 0.05), (87.6, 3.87, 0.019)]))
    };
    look("much around", &description, 15);
    let tower = Tower::new(description.clone()).expect("a tower");
    let svg = figures::tower(&description, &tower).to_svg(Look::Standalone);
    svg.says("North &lt;sea&gt; &amp; &quot;more&quot;");
}

/// Local scour is a hole beside the pile; general scour lowers the whole surface, and the level
/// before it is labelled too.
#[test]
fn local_scour_is_a_hole_beside_the_pile() {
    let sand = LayerSoil::Sand(with!(Sand, friction_angle_deg = Some(35.0)));
    let layer = GroundLayer {
        effective_unit_weight_n_per_m3: Some(1e4),
        ..GroundLayer::new([-30.0, -90.0], sand, SoilModel::Api)
    };
    let ground = Ground {
        scour: Scour {
            general_m: 1.0,
            local_m: 8.0,
        },
        ..Ground::new(-30.0, vec![layer])
    };
    let description = TowerDescription {
        ground: Some(ground),
        water: Some(parts::water(0.0, Some(-30.0), 1025.0, 1.0, false)),
        foundation: Foundation::Springs(parts::springs(0.0, 0.0, 0.0, 1e9, 1e9)),
        rna: Rna::point(350e3),
        ..steel(stations(&[(-66.0, 6.0, 0.06), (88.0, 3.87, 0.019)]))
    };
    look("scour", &description, 8);
    let tower = Tower::new(description.clone()).expect("a tower");
    let svg = figures::tower(&description, &tower).to_svg(Look::Standalone);
    for label in [
        "z = −30 m: seabed before scour",
        "z = −31 m: seabed after general scour",
        "z = −39 m: bottom of the scour hole",
    ] {
        svg.says(label);
    }
    assert!(!svg.contains("z = −39 m: seabed"));
    let solution = solve(&tower, &Options::default()).expect("a solution");
    let scene = figures::animation_data(&description, &tower, &solution);
    let soil = scene.bodies.iter();
    let soil: Vec<_> = soil.filter(|body| body.of == Substance::Soil).collect();
    // Four sides of the hole, and the block below it.
    assert_eq!(soil.len(), 5);
    let rim = soil.iter().flat_map(|body| &body.points);
    let rim = rim.filter(|point| (point[2] + 31.0).abs() < 1e-3);
    // 8 m beside the pile at 30°.
    let nearest_m = rim.map(|point| point[0].abs().max(point[1].abs()));
    let nearest_m = nearest_m.fold(f64::INFINITY, f64::min);
    // The tower tapers from 6 m at -66 m to 3.87 m at 88 m.
    let radius_m = 0.5 * (6.0 - 2.13 * 27.0 / 154.0);
    let expected_m = radius_m + 8.0 / 30.0_f64.to_radians().tan();
    assert!((nearest_m - expected_m).abs() < 0.01, "{nearest_m}");
}

/// The springs of the soil at the tip of a pile are named as such, with their values, and the
/// layers by name; the tip is no end of a layer.
#[test]
fn springs_at_a_pile_tip_and_layers_are_named() {
    let mut clay = GroundLayer::new(
        [-20.0, -80.0],
        LayerSoil::Clay(towermodes::Clay::default()),
        SoilModel::PisaCowden,
    );
    clay.shear_modulus = Some(towermodes::ShearModulus::Given {
        shear_modulus_pa: [1e8; 2],
    });
    let mut description = TowerDescription {
        ground: Some(Ground::new(-20.0, vec![clay])),
        foundation: Foundation::Springs(FoundationSprings {
            lateral_n_per_m: 0.0,
            rocking_n_m: 0.0,
            ..FoundationSprings::RIGID
        }),
        rna: Rna::point(350e3),
        ..steel(stations(&[(-50.0, 6.0, 0.06), (88.0, 3.87, 0.019)]))
    };
    description.part_names.ground = vec!["till".to_owned()];
    look("pile tip", &description, 8);
    let tower = Tower::new(description.clone()).expect("a tower");
    let figure = figures::tower(&description, &tower);
    let svg = figure.to_svg(Look::Standalone);
    // k_H G D = (2.717 - 0.3575 * 5) 1e8 * 6 and k_M G D3 = (0.2146 - 0.002132 * 5) 1e8 * 216.
    svg.says("soil springs at the pile tip: lateral 5.58·10⁸ N/m, rocking");
    svg.says("till (clay), z = −20 to −80 m");
    assert!(!svg.contains("stiffness matrix"));
    figure
        .description
        .says("springs at the base; soil springs at the pile tip");
    assert!(!figure.description.contains("matrix"));
}

/// The base is at the underside of an embedded footing: the soil reaches above it.
#[test]
fn an_embedded_footing_is_above_the_base() {
    let description = TowerDescription {
        foundation: rectangular_footing(18.0, 12.0),
        water: Some(parts::water(20.0, Some(2.0), 1025.0, 1.0, false)),
        ..plain()
    };
    look("embedded footing", &description, 8);
    let tower = Tower::new(description.clone()).expect("a tower");
    let solution = solve(&tower, &Options::default()).expect("a solution");
    let scene = figures::animation_data(&description, &tower, &solution);
    let heights_m = |of: Substance| {
        let bodies = scene.bodies.iter().filter(move |body| body.of == of);
        let heights_m = bodies.flat_map(|body| body.points.iter().map(|point| point[2]));
        heights_m.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| {
            [low.min(z), high.max(z)]
        })
    };
    let [underside_m, _] = heights_m(Substance::Foundation);
    let [_, surface_m] = heights_m(Substance::Soil);
    assert!((underside_m - tower.base_m()).abs() < 1e-3, "{underside_m}");
    // Shallow footings are drawn thicker than 2 m.
    assert!(surface_m >= tower.base_m() + 2.0, "{surface_m}");
}

/// Layers are soil from the surface that scour leaves to their lowest end, and no deeper below the
/// tip than a tenth of the tower's height.
#[test]
fn layers_are_soil_around_the_pile() {
    let layer = |ends_m| {
        let friction_angle_deg = Some(35.0);
        let sand = LayerSoil::Sand(with!(Sand, friction_angle_deg));
        GroundLayer {
            effective_unit_weight_n_per_m3: Some(1e4),
            ..GroundLayer::new(ends_m, sand, SoilModel::Api)
        }
    };
    // The pile reaches to -56 m, the tower is 144 m high.
    for (lowest_m, drawn_m) in [(-60.0, -60.0), (-500.0, -56.0 - 14.4)] {
        let layers = vec![layer([-20.0, -32.0]), layer([-32.0, lowest_m])];
        let ground = Ground {
            scour: with!(Scour, general_m = 2.0),
            ..Ground::new(-20.0, layers)
        };
        let description = TowerDescription {
            ground: Some(ground),
            foundation: Foundation::Springs(parts::springs(0.0, 0.0, 0.0, 1e9, 1e9)),
            rna: Rna::point(350e3),
            ..steel(stations(&[(-56.0, 6.0, 0.06), (88.0, 3.87, 0.019)]))
        };
        look("layers", &description, 8);
        let tower = Tower::new(description.clone()).expect("a tower");
        let solution = solve(&tower, &Options::default()).expect("a solution");
        let scene = figures::animation_data(&description, &tower, &solution);
        let around = |of: Substance| scene.bodies.iter().filter(move |body| body.of == of);
        let soil: Vec<_> = around(Substance::Soil).collect();
        assert_eq!(soil.len(), 2);
        let points = soil.iter().flat_map(|body| &body.points);
        let heights_m = points.map(|point| point[2]);
        let ends_m = [
            heights_m.clone().fold(0.0, f64::min),
            heights_m.fold(-1e9, f64::max),
        ];
        for (end_m, expected_m) in ends_m.into_iter().zip([drawn_m, -22.0]) {
            assert!((end_m - expected_m).abs() < 1e-3, "{ends_m:?}");
        }
    }
}

//! The stiffness of piles at the surface, by an independent integration from the tip up.

use super::{first_hz, free_tip, ground, ground_of, layer, oc3};
use crate::towers::assert_close;
use towermodes::{
    Foundation, FoundationSprings, LayerSoil, Material, Shear, ShearModulus, SoilModel, SoilRow,
    SoilStiffness, Station, Tower, TowerDescription,
};

/// A uniform pile for the integration, and springs at its tip.
struct Pile {
    bending_n_m2: f64,
    shear_flexibility_per_n: f64,
    tip: [f64; 2],
}

impl Pile {
    /// Of the lowest section of a tower.
    fn of(tower: &Tower) -> Self {
        let section = tower.pieces()[0].section_at(tower.base_m());
        let base = tower.base();
        Self {
            bending_n_m2: section.bending_n_m2.fore_aft,
            shear_flexibility_per_n: section.shear_flexibility_per_n.fore_aft,
            tip: [base.stiffness[0][0], base.stiffness[4][4]],
        }
    }

    /// The stiffness K_L, K_LR, K_R at the upper end of a part with smooth springs (lateral and
    /// against rotation, by the height above its lower end), from that at its lower end: it grows
    /// by the springs, loses the flexibility of the pile and moves with its point of reference.
    fn along(&self, below: [f64; 3], length_m: f64, springs: impl Fn(f64) -> [f64; 2]) -> [f64; 3] {
        let steps = 2000;
        let step_m = length_m / f64::from(steps);
        let slope = |height_m: f64, [l, c, r]: [f64; 3]| {
            let [lateral, rotation] = springs(height_m);
            let (shear, bending) = (self.shear_flexibility_per_n, 1.0 / self.bending_n_m2);
            [
                lateral - shear * l * l - bending * c * c,
                -shear * l * c - bending * c * r - l,
                rotation - shear * c * c - bending * r * r - 2.0 * c,
            ]
        };
        let ahead = |k: [f64; 3], s: [f64; 3], h: f64| [0, 1, 2].map(|i| k[i] + h * s[i]);
        let mut stiffness = below;
        for index in 0..steps {
            let height = |s: f64| (f64::from(index) + s) * step_m;
            let a = slope(height(0.0), stiffness);
            let b = slope(height(0.5), ahead(stiffness, a, 0.5 * step_m));
            let c = slope(height(0.5), ahead(stiffness, b, 0.5 * step_m));
            let d = slope(height(1.0), ahead(stiffness, c, step_m));
            let mean = [0, 1, 2].map(|i| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0);
            stiffness = ahead(stiffness, mean, step_m);
        }
        stiffness
    }
}

/// The head stiffness of a uniform pile at the surface of the ground, with the rows that the
/// library makes of the ground.
fn head_of(description: &TowerDescription) -> [f64; 3] {
    let tower = Tower::new(description.clone()).expect("valid");
    let surface_m = description.ground.as_ref().expect("a ground").surface_m;
    let pile = Pile::of(&tower);
    let below = tower
        .pieces()
        .iter()
        .take_while(|piece| piece.base_m < surface_m);
    below.fold([pile.tip[0], 0.0, pile.tip[1]], |stiffness, piece| {
        let length_m = piece.top_m.min(surface_m) - piece.base_m;
        let [low, high] = piece.environment.soil.unwrap_or_default();
        pile.along(stiffness, length_m, |height_m| {
            let share = height_m / piece.length_m();
            let blend = |a: f64, b: f64| a + share * (b - a);
            [
                blend(low.x_n_per_m2, high.x_n_per_m2),
                blend(low.rotation_y_n, high.rotation_y_n),
            ]
        })
    })
}

/// The OC3 monopile: head stiffness in GN/m, GN, GN m, and the first frequency, by each model.
#[test]
fn oc3_has_the_stiffness_and_the_frequency_of_each_model() {
    let table = [
        (SoilModel::Api, true, 1.0, [1.721, -14.31, 185.6], 0.2454),
        (SoilModel::Api, false, 1.0, [2.421, -17.93, 207.7], 0.2489),
        (
            SoilModel::Kallehave,
            true,
            1.0,
            [2.612, -18.11, 205.8],
            0.2508,
        ),
        (
            SoilModel::Sorensen,
            true,
            1.0,
            [0.994, -9.37, 147.1],
            0.2412,
        ),
        (SoilModel::Api, true, 0.5, [1.161, -11.0, 162.6], 0.2410),
    ];
    for (model, submerged, factor, expected, hz) in table {
        let mut description = oc3(model);
        ground_of(&mut description).submerged = submerged;
        ground_of(&mut description).factor = factor;
        let got = head_of(&description);
        for (got, expected) in got.into_iter().zip(expected) {
            assert_close(got / 1e9, expected, 5e-3, &format!("{model:?}, {factor}"));
        }
        assert_close(first_hz(&description), hz, 5e-3, &format!("{model:?}"));
        let tower = Tower::new(description).expect("valid");
        let head = tower.foundation_head().expect("a pile on springs").fore_aft;
        let entries = [head.lateral_n_per_m, head.coupling_n, head.rocking_n_m];
        for (entry, expected) in entries.into_iter().zip(expected) {
            assert_close(entry / 1e9, expected, 5e-3, "the library's");
        }
    }
}

/// The piles D1 and D2 of PISA in Cowden till with G₀ of 20, 200 and 400 MPa at 0, 11 and 35 m, by
/// an integration of the formulas in another program. (A published calculation of the whole curves
/// gives up to 0.3 % less: its curves soften from the first load on.)
#[test]
fn pisa_has_the_head_stiffness_of_its_one_dimensional_model() {
    let cases = [
        (7.5, 22.5, 0.068, [5.357_205e9, -2.574_828e10, 3.231_682e11]),
        (
            8.75,
            35.0,
            0.091,
            [7.097_946e9, -3.988_361e10, 5.852_868e11],
        ),
    ];
    for (diameter_m, length_m, wall_m, expected) in cases {
        let soil = LayerSoil::Clay(towermodes::Clay::default());
        let mut layers = vec![
            layer([0.0, -11.0], soil.clone(), SoilModel::PisaCowden),
            layer([-11.0, -35.0], soil, SoilModel::PisaCowden),
        ];
        let pairs = [[2e7, 2e8], [2e8, 4e8]];
        for (layer, shear_modulus_pa) in layers.iter_mut().zip(pairs) {
            layer.shear_modulus = Some(ShearModulus::Given { shear_modulus_pa });
        }
        let description = TowerDescription {
            materials: vec![Material::from_shear_modulus(7850.0, 2e11, 2e11 / 2.6)],
            stations: vec![
                Station::new(-length_m, diameter_m, wall_m),
                Station::new(37.5, diameter_m, wall_m),
            ],
            shear: Shear::Coefficient(0.5),
            foundation: free_tip(),
            ground: Some(ground(layers)),
            ..TowerDescription::default()
        };
        for (got, expected) in head_of(&description).into_iter().zip(expected) {
            assert_close(got, expected, 1e-5, &format!("D = {diameter_m} m"));
        }
        // k_H G₀ D and k_M G₀ D³ of Cowden till with the tip's G₀ of 20 MPa to 400 MPa.
        let tip = Tower::new(description).expect("valid").springs_at_tip();
        let tip = tip.expect("PISA has springs at the tip");
        let slenderness = length_m / diameter_m;
        let modulus_pa = 2e8 + (length_m - 11.0) / 24.0 * 2e8;
        let lateral = (2.717 - 0.3575 * slenderness).max(0.0) * modulus_pa * diameter_m;
        let rocking = (0.2146 - 0.002132 * slenderness) * modulus_pa * diameter_m.powi(3);
        assert_close(tip.lateral_n_per_m, lateral, 1e-12, "k_H G D");
        assert_close(tip.rocking_n_m, rocking, 1e-12, "k_M G D3");
        assert_eq!((tip.height_m, tip.vertical_n_per_m), (-length_m, 0.0));
    }
}

/// API springs end at the tip; so does the soil of a fixed base.
#[test]
fn soil_without_springs_at_the_tip_has_none() {
    let tower = Tower::new(oc3(SoilModel::Api)).expect("valid");
    assert_eq!(tower.springs_at_tip(), None);
}

/// A pile in uniform springs along its axis: K = √(k EA) tanh(L √(k/EA)) with a free tip, coth with
/// a fixed one; torsion with GJ.
#[test]
fn the_axial_head_is_that_of_a_bar_in_uniform_springs() {
    let length_m = 30.0;
    let soil = SoilStiffness {
        x_n_per_m2: 1e8,
        y_n_per_m2: 1e8,
        z_n_per_m2: 4e7,
        torsion_n: 5e8,
        ..SoilStiffness::default()
    };
    let row = |height_m| SoilRow {
        height_m,
        stiffness: soil,
    };
    let material = Material::from_shear_modulus(7850.0, 2e11, 8e10);
    let head = |vertical_n_per_m, torsion_n_m| {
        let description = TowerDescription {
            materials: vec![material],
            stations: vec![
                Station::new(-length_m, 6.0, 0.06),
                Station::new(60.0, 6.0, 0.06),
            ],
            foundation: Foundation::Springs(FoundationSprings {
                lateral_n_per_m: 0.0,
                rocking_n_m: 0.0,
                vertical_n_per_m,
                torsion_n_m,
                ..FoundationSprings::RIGID
            }),
            soil: vec![vec![row(-length_m), row(0.0)]],
            ..TowerDescription::default()
        };
        let tower = Tower::new(description).expect("valid");
        let section = tower.pieces()[0].section_at(-1.0);
        let head = tower.foundation_head().expect("no frame");
        let stiffness = [head.vertical_n_per_m, head.torsion_n_m].map(|k| k.expect("elastic"));
        (stiffness, [section.axial_n, section.torsion_n_m2])
    };
    let springs = [soil.z_n_per_m2, soil.torsion_n];
    let (free, sections) = head(0.0, 0.0);
    let (fixed, _) = head(f64::INFINITY, f64::INFINITY);
    for i in 0..2 {
        let scale = (springs[i] * sections[i]).sqrt();
        let tanh = (length_m * (springs[i] / sections[i]).sqrt()).tanh();
        assert_close(free[i], scale * tanh, 1e-9, "a free tip");
        assert_close(fixed[i], scale / tanh, 1e-9, "a fixed tip");
    }
}

/// A pile without mass below the surface is a spring at the surface.
#[test]
fn a_condensed_pile_has_the_frequencies_of_the_pile_in_the_chain() {
    let mut chain = oc3(SoilModel::Api);
    // An eccentric mass would stretch the pile, which the condensed one cannot.
    chain.rna.center_m[0] = 0.0;
    chain.rna.inertia_kg_m2.xz = 0.0;
    let massless = Material {
        density_kg_per_m3: 1e-9,
        ..chain.materials[0]
    };
    chain.materials.push(massless);
    chain.stations.insert(1, Station::new(-20.0, 6.0, 0.06));
    chain.stations[0].material = 1;
    let [lateral, coupling, rocking] = head_of(&chain);
    let mut condensed = chain.clone();
    condensed.stations.remove(0);
    condensed.materials.pop();
    condensed.ground = None;
    condensed.foundation = Foundation::Springs(FoundationSprings {
        lateral_n_per_m: lateral,
        coupling_n: coupling,
        rocking_n_m: rocking,
        ..FoundationSprings::RIGID
    });
    let options = towermodes::Options {
        method: towermodes::Method::Spectral,
        modes: 6,
        ..towermodes::Options::default()
    };
    let bending = |description: &TowerDescription| {
        let solution = crate::towers::solved(description, &options);
        crate::towers::frequencies(&solution, towermodes::Family::ForeAft)
    };
    let (got, expected) = (bending(&condensed), bending(&chain));
    assert!(got.len() >= 2, "{got:?}");
    for (got, expected) in got.into_iter().zip(expected) {
        assert_close(got, expected, 1e-9, "condensed");
    }
}

/// Springs that are curved in height: the rows of the library against the formula itself.
#[test]
fn rows_of_curved_springs_have_the_stiffness_of_the_formula() {
    let description = oc3(SoilModel::Kallehave);
    let pile = Pile::of(&Tower::new(description.clone()).expect("valid"));
    let layers = [
        (36.0_f64, 14.0_f64, 38.5_f64),
        (14.0, 5.0, 35.0),
        (5.0, 0.0, 33.0),
    ];
    let formula = layers
        .into_iter()
        .fold([0.0; 3], |stiffness, (from, to, phi)| {
            let k = 1e6 * (0.1978 * phi * phi - 10.232 * phi + 136.82);
            pile.along(stiffness, from - to, |height_m| {
                let depth_m = (from - height_m).max(0.0);
                [
                    k * 2.5 * (depth_m / 2.5).powf(0.6) * (6.0_f64 / 0.61).sqrt(),
                    0.0,
                ]
            })
        });
    for (got, expected) in head_of(&description).into_iter().zip(formula) {
        assert_close(got, expected, 2e-6, "Kallehave");
    }
}

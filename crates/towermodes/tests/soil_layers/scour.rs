//! Scour.

use super::{Random, clay, first_hz, ground, ground_of, layer, oc3, sand};
use towermodes::{GroundLayer, LayerSoil, Scour, ShearModulus, SoilModel, Tower, TowerDescription};
use towermodes_testing::parts;

/// The OC3 monopile with springs of API: the change of the first frequency in percent with general
/// scour, and with springs removed without a loss of stress, by another program. Local scour is
/// between the two.
#[test]
fn scour_lowers_the_first_frequency_of_oc3() {
    let unscoured = first_hz(&oc3(SoilModel::Api));
    let table = [(3.0, -2.0, -0.6), (7.8, -5.4, -2.7), (12.0, -8.3, -5.0)];
    for (depth_m, general, removed) in table {
        let change = |scour: Scour| {
            let mut description = oc3(SoilModel::Api);
            ground_of(&mut description).scour = scour;
            100.0 * (first_hz(&description) / unscoured - 1.0)
        };
        let [of_general, of_local] = [(depth_m, 0.0), (0.0, depth_m)]
            .map(|(general_m, local_m)| change(Scour { general_m, local_m }));
        let holds = (of_general - general).abs() < 0.2;
        assert!(holds, "{depth_m}: {of_general}");
        let between = general..removed;
        assert!(between.contains(&of_local), "{depth_m}: {of_local}");
    }
}

/// Below a hole of depth S the springs k z of sand are k min(z, (z − S) 6D/(6D − S)), with z below
/// the surface around the hole; below 6 D they are those without scour.
#[test]
fn the_stress_is_the_full_one_six_diameters_below_the_surface() {
    let springs = |local_m: f64, depth_m: f64| {
        let mut description = oc3(SoilModel::Api);
        ground_of(&mut description).layers = vec![sand(-20.0, -80.0, 35.0, SoilModel::Api)];
        ground_of(&mut description).scour.local_m = local_m;
        let tower = Tower::new(description).expect("valid");
        let height_m = -20.0 - depth_m;
        let piece = tower.pieces().iter().find(|piece| piece.top_m > height_m);
        let piece = piece.expect("a piece");
        let share = (height_m - piece.base_m) / piece.length_m();
        let [low, high] = piece
            .environment
            .soil
            .expect("soil")
            .map(|soil| soil.x_n_per_m2);
        low + share * (high - low)
    };
    for (depth_m, share) in [
        (10.0, (10.0 - 9.0) * 36.0 / 27.0 / 10.0),
        (20.0, 11.0 * 36.0 / 27.0 / 20.0),
        (35.999, 1.0),
    ] {
        let got = springs(9.0, depth_m) / springs(0.0, depth_m);
        assert!((got - share).abs() < 1e-4, "{depth_m}: {got} for {share}");
    }
}

/// Random sites of one to four layers of any kind: deeper scour of either kind, lower first
/// frequency.
#[test]
fn scour_lowers_the_first_frequency_of_any_site() {
    let mut random = Random(16);
    for site in 0..200 {
        let mut description = random_site(&mut random);
        let depths_m = [0.0, 0.4, 1.5, 3.0, 5.0, 8.0];
        let is_local = site % 2 == 0;
        let frequencies = depths_m.map(|depth_m| {
            let scour = &mut ground_of(&mut description).scour;
            *scour = match is_local {
                true => Scour {
                    general_m: 0.0,
                    local_m: depth_m,
                },
                false => Scour {
                    general_m: depth_m,
                    local_m: 0.0,
                },
            };
            first_hz(&description)
        });
        let falls = frequencies.windows(2).all(|pair| pair[1] < pair[0]);
        assert!(falls, "site {site}: {frequencies:?}\n{description:?}");
    }
}

/// A pile in one to four layers with numbers at random.
pub(super) fn random_site(random: &mut Random) -> TowerDescription {
    let mut description = oc3(SoilModel::Api);
    let count = 1 + (4.0 * random.next()) as usize;
    let thickness_m = 40.0 / count as f64;
    let diameter_m = random.between(5.0, 8.0);
    for station in &mut description.stations[..2] {
        station.outer_diameter_m = diameter_m;
    }
    let layers = (0..count).map(|index| {
        let top_m = -20.0 - thickness_m * index as f64;
        random_layer(random, [top_m, top_m - thickness_m])
    });
    description.ground = Some(ground(layers.collect()));
    description
}

fn random_layer(random: &mut Random, ends_m: [f64; 2]) -> GroundLayer {
    let angle_deg = random.between(29.0, 42.0);
    let modulus_pa = random.between(1e7, 2e8);
    let elastic = |soil, model| GroundLayer {
        shear_modulus: Some(ShearModulus::Given {
            shear_modulus_pa: [modulus_pa, 1.5 * modulus_pa],
        }),
        poissons_ratio: Some(0.3),
        ..layer(ends_m, soil, model)
    };
    let hardin = ShearModulus::Hardin {
        void_ratio: random.between(0.5, 0.8),
        earth_pressure_at_rest: 0.4,
    };
    let [top_m, bottom_m] = ends_m;
    match (9.0 * random.next()) as usize {
        0 => sand(top_m, bottom_m, angle_deg, SoilModel::Api),
        1 => sand(top_m, bottom_m, angle_deg, SoilModel::Kallehave),
        2 => sand(top_m, bottom_m, angle_deg, SoilModel::Sorensen),
        3 => layer(ends_m, LayerSoil::Clay(clay()), SoilModel::Api),
        4 => layer(ends_m, LayerSoil::Clay(clay()), SoilModel::Dnv),
        5 => layer(ends_m, LayerSoil::Clay(clay()), SoilModel::ReeseStiffClay),
        6 => elastic(LayerSoil::Elastic, SoilModel::Winkler),
        7 => elastic(LayerSoil::Elastic, SoilModel::Vesic),
        _ => GroundLayer {
            shear_modulus: Some(hardin),
            poissons_ratio: Some(0.3),
            ..layer(ends_m, LayerSoil::Elastic, SoilModel::Winkler)
        },
    }
}

/// The water stands in the hole: its bed goes down with the soil.
#[test]
fn scour_lowers_the_bed_of_the_water() {
    let mut description = oc3(SoilModel::Api);
    description.water = Some(parts::water(0.0, None, 1025.0, 1.0, true));
    ground_of(&mut description).scour = Scour {
        general_m: 1.0,
        local_m: 3.0,
    };
    let tower = Tower::new(description).expect("valid");
    let wet = tower
        .pieces()
        .iter()
        .filter(|piece| piece.environment.outside_kg_per_m3 > 0.0);
    let bed_m = wet.map(|piece| piece.base_m).fold(f64::INFINITY, f64::min);
    assert_eq!(bed_m, -24.0);
    let flooded = tower
        .pieces()
        .iter()
        .filter(|piece| piece.environment.inside_kg_per_m3 > 0.0);
    let lowest_m = flooded
        .map(|piece| piece.base_m)
        .fold(f64::INFINITY, f64::min);
    assert_eq!(lowest_m, -56.0);
}

//! Whatever the tower, no text leaves the sheet or meets another.

use crate::pictures;

use pictures::{check, steel};
use proptest::prelude::*;
use towermodes::{
    Foundation, HalfSpace, Options, PointMass, Rna, Station, Tower, TowerDescription, Water, solve,
};
use towermodes_report::figures;
use towermodes_testing::{parts, with};

/// Towers of any size with anything on them.
fn any_tower() -> impl Strategy<Value = TowerDescription> {
    let row = (0.01..1.0, 0.1..1.0, 0.001..0.5);
    let rows = prop::collection::vec(row, 2..40);
    let scales = (-0.5..2.5, -300.0..300.0, 0.005..0.2);
    let rna = (
        prop::bool::ANY,
        2.0..7.0,
        -20.0..20.0,
        -20.0..20.0,
        -5.0..20.0,
    );
    let masses = prop::collection::vec((0.0..1.0, -1.0..6.0), 0..40);
    let around = (
        prop::bool::ANY,
        -0.5..1.5,
        prop::collection::vec((0.05..1.0, 20.0..80.0), 0..5),
    );
    (rows, scales, rna, masses, around, 0_u8..4).prop_map(
        |(rows, (size, base_m, slender), rna, masses, (has_water, level, wires), foundation)| {
            let height_m = 10.0_f64.powf(size);
            let whole: f64 = rows.iter().skip(1).map(|row| row.0).sum();
            let mut share = 0.0;
            let stations = rows.iter().enumerate().map(|(k, (rise, diameter, wall))| {
                share += if k > 0 { rise / whole } else { 0.0 };
                let diameter_m = slender * height_m * diameter;
                Station::new(
                    base_m + share * height_m,
                    diameter_m,
                    0.49 * diameter_m * wall,
                )
            });
            let stations: Vec<Station> = stations.collect();
            let (base_m, top_m) = (stations[0].height_m, stations[stations.len() - 1].height_m);
            let at = |share: f64| (base_m + share * (top_m - base_m)).min(top_m);
            let point_masses = masses.into_iter().map(|(share, mass)| PointMass {
                height_m: at(share),
                mass_kg: 10.0_f64.powf(mass),
                ..PointMass::default()
            });
            let wires = wires
                .into_iter()
                .map(|(share, angle_deg)| parts::wires(at(share), 3, 1e4, angle_deg));
            let (has_rna, mass, x, y, z) = rna;
            let rna = with!(Rna, mass_kg = 10.0_f64.powf(mass), center_m = [x, y, z]);
            TowerDescription {
                point_masses: point_masses.collect(),
                wires: wires.collect(),
                rna: if has_rna { rna } else { Rna::default() },
                water: has_water.then(|| Water {
                    level_m: at(level).max(base_m + 0.1 * (top_m - base_m)),
                    bed_m: None,
                    density_kg_per_m3: 1025.0,
                    added_mass_coefficient: 1.0,
                    flooded: level > 0.5,
                }),
                foundation: match foundation {
                    0 => Foundation::Springs(parts::springs(1e9, 1e11, 0.0, f64::INFINITY, 1e11)),
                    1 => Foundation::HalfSpace(HalfSpace {
                        radius_m: 0.1 * (top_m - base_m),
                        embedment_m: 0.05 * (top_m - base_m),
                        shear_modulus_pa: 4e7,
                        poissons_ratio: 0.3,
                    }),
                    _ => Foundation::Clamped,
                },
                ..steel(stations)
            }
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn towers_of_any_size(description in any_tower()) {
        // What the library refuses has no picture.
        if let Ok(tower) = Tower::new(description.clone()) {
            check("any tower", &figures::tower(&description, &tower));
            let options = Options { modes: 8, segments: Some(60), ..Options::default() };
            if let Ok(solution) = solve(&tower, &options) {
                check("any shapes", &figures::shapes(&description, &tower, &solution));
            }
        }
    }
}

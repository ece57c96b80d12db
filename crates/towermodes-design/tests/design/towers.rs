//! Towers of published turbines.

use towermodes::{Rna, Station, TowerDescription};
use towermodes_testing::{rna, tube};

/// The NREL 5 MW tower with its RNA (NREL/TP-500-38060, 2009).
pub fn nrel_5mw() -> TowerDescription {
    TowerDescription {
        rna: rna(
            350e3,
            [-0.41, 0.0, 1.966427],
            [37634182.0, 24376664.3, 22613929.0],
        ),
        gravity_m_per_s2: 9.81,
        ..tube(&[(0.0, 6.0, 0.0351), (87.6, 3.87, 0.0247)])
    }
}

/// Cans of constant wall and linear diameter between two heights.
pub fn of_cans(
    count: usize,
    height_m: f64,
    diameters_m: [f64; 2],
    walls_m: [f64; 2],
) -> Vec<Station> {
    let at = |ends: [f64; 2], share: f64| ends[0] + share * (ends[1] - ends[0]);
    let can = |i: usize| {
        let wall_m = at(walls_m, i as f64 / (count - 1) as f64);
        [i, i + 1].map(|end| {
            let share = end as f64 / count as f64;
            Station::new(height_m * share, at(diameters_m, share), wall_m)
        })
    };
    (0..count).flat_map(can).collect()
}

/// The NREL 5 MW tower of eight cans.
pub fn cans() -> TowerDescription {
    TowerDescription {
        stations: of_cans(8, 87.6, [6.0, 3.87], [0.035, 0.025]),
        ..nrel_5mw()
    }
}

/// A tower as that of the DTU 10 MW reference turbine (Bak et al., DTU Wind Energy Report-I-0092,
/// 2013): 115.63 m, 8.3 to 5.5 m, walls of 38 to 20 mm, 674 t on top; of 20 cans.
pub fn dtu_10mw() -> TowerDescription {
    TowerDescription {
        stations: of_cans(20, 115.63, [8.3, 5.5], [0.038, 0.020]),
        rna: Rna::point(674e3),
        ..nrel_5mw()
    }
}

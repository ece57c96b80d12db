//! Soil in layers: published and independent stiffness of piles, scour, mistakes, derivatives.

mod derivatives;
mod frame_piles;
mod mistakes;
mod piles;
mod scour;
mod springs;

use crate::towers;

use towermodes::{
    ApiEdition, Clay, Foundation, FoundationSprings, Ground, GroundLayer, Inertia, LayerSoil,
    Options, Rna, Sand, Shear, SoilModel, TowerDescription,
};
use towermodes_testing::{changed, tube, with};

/// The pile's tip: held along and about its axis only.
fn free_tip() -> Foundation {
    Foundation::Springs(FoundationSprings {
        lateral_n_per_m: 0.0,
        rocking_n_m: 0.0,
        ..FoundationSprings::RIGID
    })
}

/// A layer of sand.
fn sand(top_m: f64, bottom_m: f64, friction_angle_deg: f64, model: SoilModel) -> GroundLayer {
    let soil = LayerSoil::Sand(with!(Sand, friction_angle_deg = Some(friction_angle_deg)));
    layer([top_m, bottom_m], soil, model)
}

/// A layer with an effective unit weight of 10 kN/m³.
fn layer(ends_m: [f64; 2], soil: LayerSoil, model: SoilModel) -> GroundLayer {
    GroundLayer {
        effective_unit_weight_n_per_m3: Some(1e4),
        ..GroundLayer::new(ends_m, soil, model)
    }
}

fn clay() -> Clay {
    let matlock = with!(
        Clay,
        undrained_strength_pa = Some([4e4, 1.2e5]),
        strain_at_half_strength = Some(0.01),
        strength_factor = Some(0.5),
    );
    changed!(matlock, stiffness_factor = Some(10.0))
}

/// Submerged ground from a surface down.
fn ground(layers: Vec<GroundLayer>) -> Ground {
    Ground::new(layers[0].top_m, layers)
}

/// The NREL 5 MW turbine on the monopile of OC3, from its tip up, in three layers of sand with the
/// modulus of API RP 2A.
fn oc3(model: SoilModel) -> TowerDescription {
    let layers = vec![
        sand(-20.0, -25.0, 33.0, model),
        sand(-25.0, -34.0, 35.0, model),
        sand(-34.0, -56.0, 38.5, model),
    ];
    TowerDescription {
        rna: Rna {
            mass_kg: 350e3,
            center_m: [-0.413_775_4, 0.0, 1.966_989_4],
            inertia_kg_m2: Inertia {
                xx: 4.37e7 - 350e3 * 1.966_989_4_f64.powi(2),
                yy: 2.353e7 - 350e3 * (1.966_989_4_f64.powi(2) + 0.413_775_4_f64.powi(2)),
                zz: 2.542e7 - 350e3 * 0.413_775_4_f64.powi(2),
                xz: 1.169e6 - 350e3 * 0.413_775_4 * 1.966_989_4,
                ..Inertia::default()
            },
        },
        foundation: free_tip(),
        shear: Shear::Rigid,
        ground: Some(changed!(ground(layers), edition = ApiEdition::Rp2A)),
        ..tube(&[
            (-56.0, 6.0, 0.06),
            (10.0, 6.0, 0.06),
            (10.0, 6.0, 0.027),
            (87.6, 3.87, 0.019),
        ])
    }
}

fn ground_of(description: &mut TowerDescription) -> &mut Ground {
    description.ground.as_mut().expect("a ground")
}

fn first_hz(description: &TowerDescription) -> f64 {
    let options = with!(Options, modes = 2);
    towers::solved(description, &options).modes[0].extrapolated_hz
}

/// Numbers from 0 to 1 that are the same in every run (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        least + self.next() * (most - least)
    }
}

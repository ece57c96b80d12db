//! Soil in layers: units, angles in radians, dry weights, and the range of the models.

use super::Given;
use super::usual::Usual;
use crate::tower::ground::{Clay, Ground, GroundLayer, LayerSoil, Sand, ShearModulus, SoilModel};
use crate::tower::{Ineffective, Place, Quantity, Site, Tower, Warning, Water};

const FRICTION_ANGLE: Usual = Usual::new(Quantity::FrictionAngle, 20.0, 50.0);
const BUOYANT_WEIGHT: Usual = Usual::new(Quantity::BuoyantUnitWeight, 3e3, 14e3);
const UNIT_WEIGHT: Usual = Usual::new(Quantity::SoilUnitWeight, 8e3, 25e3);
const STRENGTH: Usual = Usual::new(Quantity::UndrainedStrength, 1e3, 1e6);
const STRAIN: Usual = Usual::new(Quantity::StrainAtHalfStrength, 1e-3, 0.05);
const SUBGRADE: Usual = Usual::new(Quantity::SubgradeModulus, 5e5, 2e8);
const SHEAR_MODULUS: Usual = Usual::new(Quantity::SoilShearModulus, 5e5, 5e10);
const YOUNGS_MODULUS: Usual = Usual::new(Quantity::SoilYoungsModulus, 1e6, 5e10);
const WAVES: Usual = Usual::new(Quantity::SoilWaveVelocity, 30.0, 4000.0);
const DENSITY: Usual = Usual::new(Quantity::SoilDensity, 1000.0, 3000.0);
const CONE: Usual = Usual::new(Quantity::ConeResistance, 2e4, 1.5e8);
const BLOWS: Usual = Usual::new(Quantity::BlowCount, 1.0, 100.0);
const FRICTION: Usual = Usual::new(Quantity::ShaftFriction, 1e3, 5e5);

/// Ranges of PISA: the diameter in m, the embedded length over it, the relative density. Only that
/// of the length is checked against a source.
const PISA_DIAMETERS_M: [f64; 2] = [5.0, 10.0];
const PISA_LENGTHS: [f64; 2] = [2.0, 6.0];
const PISA_DENSITIES: [f64; 2] = [0.45, 0.9];

pub(super) fn check(tower: &Tower, given: &Given<'_>, warnings: &mut Vec<Warning>) {
    let Some(ground) = given.ground else {
        return;
    };
    for (index, layer) in ground.layers.iter().enumerate() {
        let at = |key| Site::at(Place::GroundLayer { index, key });
        weight(ground, layer, at("effective_unit_weight"), warnings);
        if let Some(modulus) = &layer.shear_modulus {
            shear_modulus(modulus, at, warnings);
        }
        for friction_pa in layer.shaft_friction_pa.into_iter().flatten() {
            FRICTION.check(friction_pa, at("shaft_friction"), warnings);
        }
        match &layer.soil {
            LayerSoil::Sand(values) => sand(values, at, warnings),
            LayerSoil::Clay(values) => clay(values, at, warnings),
            LayerSoil::Rock(values) => {
                for modulus_pa in values.youngs_modulus_pa.into_iter().flatten() {
                    YOUNGS_MODULUS.check(modulus_pa, at("youngs_modulus"), warnings);
                }
            }
            LayerSoil::Table(_) | LayerSoil::Elastic => {}
        }
        if layer.top_m <= tower.base_m() && index > 0 && !is_under_tip(ground, index, tower) {
            let (site, what) = (at("top"), Ineffective::LayerBelowTip);
            warnings.push(Warning::NoEffect { site, what });
        }
    }
    range_of_pisa(tower, ground, warnings);
    if let Some(water) = given.water {
        water_over(ground, water, warnings);
    }
}

/// Water and ground that contradict each other. The bed goes down with the scour from the height
/// at which it is given.
fn water_over(ground: &Ground, water: &Water, warnings: &mut Vec<Warning>) {
    let (surface_m, level_m) = (ground.surface_m, water.level_m);
    let at = |key| Site::at(Place::Water { key });
    if let Some(bed_m) = water.bed_m.filter(|bed_m| *bed_m != surface_m) {
        warnings.push(Warning::BedOffSurface {
            site: at("bed"),
            bed_m,
            surface_m,
        });
    }
    if !ground.submerged && level_m > surface_m {
        warnings.push(Warning::DryUnderWater {
            site: Site::at(Place::Ground { key: "submerged" }),
            level_m,
            surface_m,
        });
    }
    if water.bed_m.is_none() && !water.flooded && level_m <= surface_m {
        let (site, what) = (at("level"), Ineffective::WaterBelowGround);
        warnings.push(Warning::NoEffect { site, what });
    }
}

/// The layer that the tip stands on may give springs under the tip.
fn is_under_tip(ground: &Ground, index: usize, tower: &Tower) -> bool {
    ground.layers[index - 1].bottom_m >= tower.base_m()
}

fn weight(ground: &Ground, layer: &GroundLayer, site: Site, warnings: &mut Vec<Warning>) {
    if let Some(weight) = layer.effective_unit_weight_n_per_m3 {
        let usual = if ground.submerged {
            BUOYANT_WEIGHT
        } else {
            UNIT_WEIGHT
        };
        usual.check(weight, site, warnings);
    }
}

fn sand(sand: &Sand, at: impl Fn(&'static str) -> Site, warnings: &mut Vec<Warning>) {
    if let Some(angle_deg) = sand.friction_angle_deg {
        FRICTION_ANGLE.check(angle_deg, at("friction_angle"), warnings);
    }
    if let Some(modulus) = sand.subgrade_modulus_n_per_m3 {
        SUBGRADE.check(modulus, at("subgrade_modulus"), warnings);
    }
}

fn clay(clay: &Clay, at: impl Fn(&'static str) -> Site, warnings: &mut Vec<Warning>) {
    for strength_pa in clay.undrained_strength_pa.into_iter().flatten() {
        if STRENGTH.check(strength_pa, at("undrained_strength"), warnings) {
            break;
        }
    }
    if let Some(strain) = clay.strain_at_half_strength {
        STRAIN.check(strain, at("strain_at_half_strength"), warnings);
    }
}

fn shear_modulus(
    modulus: &ShearModulus,
    at: impl Fn(&'static str) -> Site,
    warnings: &mut Vec<Warning>,
) {
    let density = match *modulus {
        ShearModulus::WaveVelocity {
            density_kg_per_m3, ..
        }
        | ShearModulus::RobertsonCabal {
            density_kg_per_m3, ..
        }
        | ShearModulus::BlowCount {
            density_kg_per_m3, ..
        } => Some(density_kg_per_m3),
        _ => None,
    };
    if let Some(density) = density {
        DENSITY.check(density, at("density"), warnings);
    }
    let (usual, key, values) = match *modulus {
        ShearModulus::Given { shear_modulus_pa } => {
            (SHEAR_MODULUS, "shear_modulus", shear_modulus_pa)
        }
        ShearModulus::Youngs { youngs_modulus_pa } => {
            (YOUNGS_MODULUS, "youngs_modulus", youngs_modulus_pa)
        }
        ShearModulus::WaveVelocity {
            velocity_m_per_s, ..
        } => (WAVES, "shear_wave_velocity", velocity_m_per_s),
        ShearModulus::RixStokoe { cone_resistance_pa }
        | ShearModulus::MayneRix { cone_resistance_pa }
        | ShearModulus::RobertsonCabal {
            cone_resistance_pa, ..
        } => (CONE, "cone_resistance", cone_resistance_pa),
        ShearModulus::BlowCount { blow_count, .. } => (BLOWS, "blow_count", blow_count),
        ShearModulus::Hardin { .. } => return,
    };
    for value in values {
        if usual.check(value, at(key), warnings) {
            break;
        }
    }
}

/// A pile or a sand for which the models of PISA were not derived.
fn range_of_pisa(tower: &Tower, ground: &Ground, warnings: &mut Vec<Warning>) {
    let is_pisa = |layer: &GroundLayer| {
        let model = layer.model;
        matches!(
            model,
            SoilModel::PisaCowden | SoilModel::PisaBothkennar | SoilModel::PisaDunkirk
        )
    };
    let Some(index) = ground.layers.iter().position(is_pisa) else {
        return;
    };
    let site = Site::at(Place::GroundLayer {
        index,
        key: "model",
    });
    let first = tower
        .stations()
        .first()
        .map(|station| station.outer_diameter_m);
    let Some(diameter_m) = ground.pile_diameter_m.or(first) else {
        return;
    };
    let scour_m = ground.scour.general_m + ground.scour.local_m;
    let length = (ground.surface_m - scour_m - tower.base_m()) / diameter_m;
    let quantity = "the diameter of the pile in m";
    warnings.extend(outside(site, quantity, diameter_m, PISA_DIAMETERS_M));
    let quantity = "the embedded length of the pile, divided by its diameter,";
    warnings.extend(outside(site, quantity, length, PISA_LENGTHS));
    for (index, layer) in ground.layers.iter().enumerate() {
        if let (SoilModel::PisaDunkirk, LayerSoil::Sand(sand)) = (layer.model, &layer.soil) {
            let key = "relative_density";
            let site = Site::at(Place::GroundLayer { index, key });
            let density = sand.relative_density.unwrap_or(PISA_DENSITIES[0]);
            warnings.extend(outside(
                site,
                "the relative density",
                density,
                PISA_DENSITIES,
            ));
        }
    }
}

fn outside(
    site: Site,
    quantity: &'static str,
    value: f64,
    [least, most]: [f64; 2],
) -> Option<Warning> {
    (!(least..=most).contains(&value)).then_some(Warning::OutsideFormula {
        site,
        formula: "the model of PISA",
        quantity,
        value,
        least,
        most,
        remedy: "compare with another model and with a factor of 0.5 and 2 on the soil",
    })
}

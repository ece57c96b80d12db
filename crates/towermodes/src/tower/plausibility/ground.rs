//! Soil in layers: units, angles in radians, dry weights, and the range of the models.

use super::Given;
use super::unused;
use super::usual::Usual;
use crate::tower::ground::{
    ApiEdition, Clay, Ground, GroundLayer, LayerSoil, Models, Piles, Sand, ShearModulus,
};
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
const CONE_IN_SAND: Usual = Usual::new(Quantity::ConeResistance, 5e5, 1.5e8);
const CONE_IN_CLAY: Usual = Usual::new(Quantity::ConeResistance, 5e4, 3e7);
const CONE: Usual = Usual::new(Quantity::ConeResistance, 5e4, 1.5e8);
const BEHAVIOUR_INDEX: Usual = Usual::new(Quantity::BehaviourIndex, 1.0, 4.0);
const VOID_RATIO: Usual = Usual::new(Quantity::VoidRatio, 0.25, 2.0);
const EARTH_PRESSURE: Usual = Usual::new(Quantity::EarthPressure, 0.2, 3.0);
const STRENGTH_FACTOR: Usual = Usual::new(Quantity::StrengthFactor, 0.1, 1.0);
const STIFFNESS_FACTOR: Usual = Usual::new(Quantity::StiffnessFactor, 5.0, 60.0);
const BEARING: Usual = Usual::new(Quantity::EndBearing, 2e4, 1e8);
const BLOWS: Usual = Usual::new(Quantity::BlowCount, 1.0, 100.0);
const FRICTION: Usual = Usual::new(Quantity::ShaftFriction, 1e3, 5e5);

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
        if let Some(friction_pa) = layer.shaft_friction_pa {
            profile(FRICTION, friction_pa, at("shaft_friction"), warnings);
        }
        if let Some(bearing_pa) = layer.end_bearing_pa {
            BEARING.check(bearing_pa, at("end_bearing"), warnings);
        }
        match &layer.soil {
            LayerSoil::Sand(values) => sand(values, at, warnings),
            LayerSoil::Clay(values) => clay(values, at, warnings),
            LayerSoil::Rock(values) => {
                if let Some(modulus_pa) = values.youngs_modulus_pa {
                    profile(YOUNGS_MODULUS, modulus_pa, at("youngs_modulus"), warnings);
                }
            }
            LayerSoil::Table(_) | LayerSoil::Elastic => {}
        }
        let models = Models::of(layer, ground).ok();
        for (key, what) in unused::of(layer, models.as_ref()) {
            let site = at(key);
            warnings.push(Warning::NoEffect { site, what });
        }
        if layer.top_m <= tower.base_m() && index > 0 && !is_under_tip(ground, index, tower) {
            let (site, what) = (at("top"), Ineffective::LayerBelowTip);
            warnings.push(Warning::NoEffect { site, what });
        }
    }
    models(tower, ground, warnings);
    if !ground.submerged
        && ground.edition == ApiEdition::Rp2Geo
        && ground.modulus_depends_on_edition()
    {
        let key = "submerged";
        warnings.push(Warning::NoEffect {
            site: Site::at(Place::Ground { key }),
            what: Ineffective::SandAboveWater,
        });
    }
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
    if let Some(strength_pa) = clay.undrained_strength_pa {
        profile(STRENGTH, strength_pa, at("undrained_strength"), warnings);
    }
    let values = [
        (
            STRAIN,
            "strain_at_half_strength",
            clay.strain_at_half_strength,
        ),
        (STRENGTH_FACTOR, "strength_factor", clay.strength_factor),
        (STIFFNESS_FACTOR, "stiffness_factor", clay.stiffness_factor),
    ];
    for (usual, key, value) in values {
        if let Some(value) = value {
            usual.check(value, at(key), warnings);
        }
    }
}

/// The larger one of the values at top and bottom: the other may be zero.
fn profile(usual: Usual, [top, bottom]: [f64; 2], site: Site, warnings: &mut Vec<Warning>) {
    usual.check(top.max(bottom), site, warnings);
}

fn shear_modulus(
    modulus: &ShearModulus,
    at: impl Fn(&'static str) -> Site,
    warnings: &mut Vec<Warning>,
) {
    let mut check = |usual, pair, key| profile(usual, pair, at(key), warnings);
    let mut density = None;
    match *modulus {
        ShearModulus::Given { shear_modulus_pa } => {
            check(SHEAR_MODULUS, shear_modulus_pa, "shear_modulus");
        }
        ShearModulus::Youngs { youngs_modulus_pa } => {
            check(YOUNGS_MODULUS, youngs_modulus_pa, "youngs_modulus");
        }
        ShearModulus::WaveVelocity {
            velocity_m_per_s,
            density_kg_per_m3,
        } => {
            check(WAVES, velocity_m_per_s, "shear_wave_velocity");
            density = Some(density_kg_per_m3);
        }
        ShearModulus::RixStokoe { cone_resistance_pa } => {
            check(CONE_IN_SAND, cone_resistance_pa, "cone_resistance");
        }
        ShearModulus::MayneRix { cone_resistance_pa } => {
            check(CONE_IN_CLAY, cone_resistance_pa, "cone_resistance");
        }
        ShearModulus::RobertsonCabal {
            cone_resistance_pa,
            behaviour_index,
            density_kg_per_m3,
        } => {
            check(CONE, cone_resistance_pa, "cone_resistance");
            check(BEHAVIOUR_INDEX, [behaviour_index; 2], "behaviour_index");
            density = Some(density_kg_per_m3);
        }
        ShearModulus::Hardin {
            void_ratio,
            earth_pressure_at_rest,
        } => {
            check(VOID_RATIO, [void_ratio; 2], "void_ratio");
            let key = "earth_pressure_at_rest";
            check(EARTH_PRESSURE, [earth_pressure_at_rest; 2], key);
        }
        ShearModulus::BlowCount {
            blow_count,
            density_kg_per_m3,
        } => {
            check(BLOWS, blow_count, "blow_count");
            density = Some(density_kg_per_m3);
        }
    }
    if let Some(density) = density {
        DENSITY.check(density, at("density"), warnings);
    }
}

/// Piles and soils for which the models were not derived.
fn models(tower: &Tower, ground: &Ground, warnings: &mut Vec<Warning>) {
    let mut seen = Vec::new();
    for (index, layer) in ground.layers.iter().enumerate() {
        let Ok(models) = Models::of(layer, ground) else {
            continue;
        };
        let at = |key| Site::at(Place::GroundLayer { index, key });
        let piles = models.across.piles();
        if let Some(piles) = piles.filter(|piles| !seen.contains(&piles.formula)) {
            seen.push(piles.formula);
            pile(tower, ground, &piles, at("model"), warnings);
        }
        models.across.doubt(&at, warnings);
    }
}

/// A pile for which a model was not derived.
fn pile(tower: &Tower, ground: &Ground, piles: &Piles, site: Site, warnings: &mut Vec<Warning>) {
    if piles.need_shear && !tower.shears() {
        warnings.push(Warning::PisaWithoutShear { site });
    }
    let first = tower.stations().first();
    let own = first.map(|station| station.outer_diameter_m);
    let Some(diameter_m) = ground.pile_diameter_m.or(own) else {
        return;
    };
    let scour_m = ground.scour.general_m + ground.scour.local_m;
    let length = (ground.surface_m - scour_m - tower.base_m()) / diameter_m;
    let numbers = [
        (
            "the diameter of the pile in m",
            diameter_m,
            piles.diameters_m,
        ),
        (
            "the embedded length of the pile, divided by its diameter,",
            length,
            piles.lengths,
        ),
    ];
    for (quantity, value, [least, most]) in numbers {
        if !(least..=most).contains(&value) {
            warnings.push(Warning::OutsideFormula {
                site,
                formula: piles.formula,
                quantity,
                value,
                least,
                most,
                remedy: piles.remedy,
            });
        }
    }
}

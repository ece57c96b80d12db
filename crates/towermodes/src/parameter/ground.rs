//! The numbers of soil in layers.

use super::part::{Indices, Key, Part, fields};
use crate::tower::{
    Clay, Ground, GroundLayer, LayerSoil, Place, Sand, ShearModulus, TowerDescription,
};

/// A number of the ground that is always there.
macro_rules! ground {
    ($($name:literal $unit:literal $meaning:literal, $field:ident $(. $inner:ident)?;)+) => {
        &[$(Key {
            name: $name,
            unit: $unit,
            meaning: $meaning,
            place: |_| Place::Ground { key: $name },
            get: |d, _| Some(d.ground.as_ref()?.$field$(.$inner)?),
            set: |d, _, value| {
                d.ground.as_mut()?.$field$(.$inner)? = value;
                Some(())
            },
            is_listed: super::part::is_there,
        },)+ PILE_DIAMETER]
    };
}

const PILE_DIAMETER: Key = Key {
    name: "pile_diameter",
    unit: "m",
    meaning: "outer diameter of the pile",
    place: |_| Place::Ground {
        key: "pile_diameter",
    },
    get: |d, _| d.ground.as_ref()?.pile_diameter_m,
    set: |d, _, value| {
        *d.ground.as_mut()?.pile_diameter_m.as_mut()? = value;
        Some(())
    },
    is_listed: |d, _| given(d).is_some_and(|ground| ground.pile_diameter_m.is_some()),
};

/// `[ground]`.
pub(super) static GROUND: Part = Part {
    name: "ground",
    noun: "ground",
    count: |d| usize::from(d.ground.is_some()),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: ground! {
        "surface" "m" "height of the surface before scour", surface_m;
        "scour.general" "m" "depth of general scour", scour.general_m;
        "scour.local" "m" "depth of local scour", scour.local_m;
        "factor" "" "factor on all springs of the ground", factor;
    },
};

/// Numbers of a layer, each found by a function of the layer.
macro_rules! layer {
    ($($name:literal $unit:literal $meaning:literal, $place:literal $find:expr;)+) => {
        &[$(Key {
            name: $name,
            unit: $unit,
            meaning: $meaning,
            place: |i| Place::GroundLayer { index: i[0], key: $place },
            get: |d, i| value(d, i, $find),
            set: |d, i, value| {
                let find: Find = $find;
                *find(d.ground.as_mut()?.layers.get_mut(i[0])?)? = value;
                Some(())
            },
            is_listed: |d, i| value(d, i, $find).is_some(),
        }),+]
    };
}

/// A number of a layer, if the layer has it.
type Find = fn(&mut GroundLayer) -> Option<&mut f64>;

/// `[[ground.layer]]`.
pub(super) static LAYERS: Part = Part {
    name: "ground.layer[]",
    noun: "layers of the ground",
    count: |d| given(d).map_or(0, |ground| ground.layers.len()),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: layer! {
        "top" "m" "height of the top of the layer", "top" |l| Some(&mut l.top_m);
        "bottom" "m" "height of the bottom of the layer", "bottom" |l| Some(&mut l.bottom_m);
        "effective_unit_weight" "N/m3" "effective unit weight", "effective_unit_weight" |l| l.effective_unit_weight_n_per_m3.as_mut();
        "factor" "" "factor on the springs of the layer", "factor" |l| Some(&mut l.factor);
        "friction_angle" "degrees" "friction angle", "friction_angle" |l| sand(l)?.friction_angle_deg.as_mut();
        "subgrade_modulus" "N/m3" "subgrade modulus", "subgrade_modulus" |l| sand(l)?.subgrade_modulus_n_per_m3.as_mut();
        "relative_density" "" "relative density", "relative_density" |l| sand(l)?.relative_density.as_mut();
        "undrained_strength[0]" "Pa" "undrained strength at the top", "undrained_strength" |l| first(&mut clay(l)?.undrained_strength_pa);
        "undrained_strength[1]" "Pa" "undrained strength at the bottom", "undrained_strength" |l| second(&mut clay(l)?.undrained_strength_pa);
        "strain_at_half_strength" "" "strain at half the strength", "strain_at_half_strength" |l| clay(l)?.strain_at_half_strength.as_mut();
        "strength_factor" "" "factor J of the strength near the surface", "strength_factor" |l| clay(l)?.strength_factor.as_mut();
        "stiffness_factor" "" "factor of the initial stiffness", "stiffness_factor" |l| clay(l)?.stiffness_factor.as_mut();
        "shear_modulus[0]" "Pa" "shear modulus at the top", "shear_modulus" |l| shear_modulus(l).map(|[top, _]| top);
        "shear_modulus[1]" "Pa" "shear modulus at the bottom", "shear_modulus" |l| shear_modulus(l).map(|[_, bottom]| bottom);
        "youngs_modulus[0]" "Pa" "Young's modulus at the top", "youngs_modulus" |l| youngs_modulus(l).map(|[top, _]| top);
        "youngs_modulus[1]" "Pa" "Young's modulus at the bottom", "youngs_modulus" |l| youngs_modulus(l).map(|[_, bottom]| bottom);
        "shear_wave_velocity[0]" "m/s" "velocity of shear waves at the top", "shear_wave_velocity" |l| velocity(l).map(|[top, _]| top);
        "shear_wave_velocity[1]" "m/s" "velocity of shear waves at the bottom", "shear_wave_velocity" |l| velocity(l).map(|[_, bottom]| bottom);
        "cone_resistance[0]" "Pa" "cone resistance at the top", "cone_resistance" |l| cone(l).map(|[top, _]| top);
        "cone_resistance[1]" "Pa" "cone resistance at the bottom", "cone_resistance" |l| cone(l).map(|[_, bottom]| bottom);
        "behaviour_index" "" "soil behaviour type index", "behaviour_index" behaviour_index;
        "void_ratio" "" "void ratio", "void_ratio" void_ratio;
        "earth_pressure_at_rest" "" "coefficient of earth pressure at rest", "earth_pressure_at_rest" earth_pressure;
        "blow_count[0]" "" "blow count at the top", "blow_count" |l| blow_count(l).map(|[top, _]| top);
        "blow_count[1]" "" "blow count at the bottom", "blow_count" |l| blow_count(l).map(|[_, bottom]| bottom);
        "density" "kg/m3" "density of the soil with its water", "density" density;
        "poissons_ratio" "" "Poisson's ratio", "poissons_ratio" |l| l.poissons_ratio.as_mut();
        "shaft_friction[0]" "Pa" "shaft friction at the top", "shaft_friction" |l| first(&mut l.shaft_friction_pa);
        "shaft_friction[1]" "Pa" "shaft friction at the bottom", "shaft_friction" |l| second(&mut l.shaft_friction_pa);
        "end_bearing" "Pa" "end bearing", "end_bearing" |l| l.end_bearing_pa.as_mut();
    },
};

/// The rows of a `[[ground.layer]]` of type `py`.
pub(super) static ROWS: Part = Part {
    name: "ground.layer[].rows[]",
    noun: "layers with p-y curves",
    count: |d| given(d).map_or(0, |ground| ground.layers.len()),
    rows: |d, layer| table(d, layer).map_or(0, |rows| rows.len()),
    is_symmetric: false,
    keys: fields! {
        get |d, i| table(d, i[0])?.get(i[1])?;
        set |d, i| table_mut(d, i[0])?.get_mut(i[1])?;
        place |i, key| Place::GroundRow { layer: i[0], row: i[1], key };
        "height" "m" "height", "height" height_m;
        "displacement" "m" "displacement of the pile", "displacement" displacement_m;
        "reaction" "N/m" "reaction per length", "reaction" reaction_n_per_m;
    },
};

fn given(description: &TowerDescription) -> Option<&Ground> {
    description.ground.as_ref()
}

fn value(description: &TowerDescription, indices: Indices, find: Find) -> Option<f64> {
    let layer = given(description)?.layers.get(indices[0])?;
    // The functions find a place to write to; rows are not among them.
    let soil = match &layer.soil {
        LayerSoil::Table(_) => LayerSoil::Table(Vec::new()),
        other => other.clone(),
    };
    find(&mut GroundLayer { soil, ..*layer }).copied()
}

fn table(description: &TowerDescription, layer: usize) -> Option<&Vec<crate::tower::PyRow>> {
    let LayerSoil::Table(rows) = &given(description)?.layers.get(layer)?.soil else {
        return None;
    };
    Some(rows)
}

fn table_mut(
    description: &mut TowerDescription,
    layer: usize,
) -> Option<&mut Vec<crate::tower::PyRow>> {
    let LayerSoil::Table(rows) = &mut description.ground.as_mut()?.layers.get_mut(layer)?.soil
    else {
        return None;
    };
    Some(rows)
}

fn first(pair: &mut Option<[f64; 2]>) -> Option<&mut f64> {
    pair.as_mut().map(|[top, _]| top)
}

fn second(pair: &mut Option<[f64; 2]>) -> Option<&mut f64> {
    pair.as_mut().map(|[_, bottom]| bottom)
}

fn sand(layer: &mut GroundLayer) -> Option<&mut Sand> {
    let LayerSoil::Sand(sand) = &mut layer.soil else {
        return None;
    };
    Some(sand)
}

fn clay(layer: &mut GroundLayer) -> Option<&mut Clay> {
    let LayerSoil::Clay(clay) = &mut layer.soil else {
        return None;
    };
    Some(clay)
}

fn shear_modulus(layer: &mut GroundLayer) -> Option<&mut [f64; 2]> {
    let ShearModulus::Given { shear_modulus_pa } = layer.shear_modulus.as_mut()? else {
        return None;
    };
    Some(shear_modulus_pa)
}

/// Of rock, or as a form of the shear modulus.
fn youngs_modulus(layer: &mut GroundLayer) -> Option<&mut [f64; 2]> {
    if let LayerSoil::Rock(rock) = &mut layer.soil {
        return rock.youngs_modulus_pa.as_mut();
    }
    let ShearModulus::Youngs { youngs_modulus_pa } = layer.shear_modulus.as_mut()? else {
        return None;
    };
    Some(youngs_modulus_pa)
}

fn velocity(layer: &mut GroundLayer) -> Option<&mut [f64; 2]> {
    let ShearModulus::WaveVelocity {
        velocity_m_per_s, ..
    } = layer.shear_modulus.as_mut()?
    else {
        return None;
    };
    Some(velocity_m_per_s)
}

fn cone(layer: &mut GroundLayer) -> Option<&mut [f64; 2]> {
    match layer.shear_modulus.as_mut()? {
        ShearModulus::RixStokoe { cone_resistance_pa }
        | ShearModulus::MayneRix { cone_resistance_pa }
        | ShearModulus::RobertsonCabal {
            cone_resistance_pa, ..
        } => Some(cone_resistance_pa),
        ShearModulus::Given { .. }
        | ShearModulus::Youngs { .. }
        | ShearModulus::WaveVelocity { .. }
        | ShearModulus::Hardin { .. }
        | ShearModulus::BlowCount { .. } => None,
    }
}

fn behaviour_index(layer: &mut GroundLayer) -> Option<&mut f64> {
    let ShearModulus::RobertsonCabal {
        behaviour_index, ..
    } = layer.shear_modulus.as_mut()?
    else {
        return None;
    };
    Some(behaviour_index)
}

fn void_ratio(layer: &mut GroundLayer) -> Option<&mut f64> {
    let ShearModulus::Hardin { void_ratio, .. } = layer.shear_modulus.as_mut()? else {
        return None;
    };
    Some(void_ratio)
}

fn earth_pressure(layer: &mut GroundLayer) -> Option<&mut f64> {
    let ShearModulus::Hardin {
        earth_pressure_at_rest,
        ..
    } = layer.shear_modulus.as_mut()?
    else {
        return None;
    };
    Some(earth_pressure_at_rest)
}

fn blow_count(layer: &mut GroundLayer) -> Option<&mut [f64; 2]> {
    let ShearModulus::BlowCount { blow_count, .. } = layer.shear_modulus.as_mut()? else {
        return None;
    };
    Some(blow_count)
}

fn density(layer: &mut GroundLayer) -> Option<&mut f64> {
    match layer.shear_modulus.as_mut()? {
        ShearModulus::WaveVelocity {
            density_kg_per_m3, ..
        }
        | ShearModulus::RobertsonCabal {
            density_kg_per_m3, ..
        }
        | ShearModulus::BlowCount {
            density_kg_per_m3, ..
        } => Some(density_kg_per_m3),
        ShearModulus::Given { .. }
        | ShearModulus::Youngs { .. }
        | ShearModulus::RixStokoe { .. }
        | ShearModulus::MayneRix { .. }
        | ShearModulus::Hardin { .. } => None,
    }
}

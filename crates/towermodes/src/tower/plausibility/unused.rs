//! Values of a layer of soil that its models do not use.

use crate::tower::Ineffective;
use crate::tower::ground::{AxialModel, GroundLayer, LayerSoil, ShearModulus, SoilModel};

/// A value that is given and has no effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Unused {
    key: &'static str,
    is_axial: bool,
}

impl Unused {
    pub(super) fn key(self) -> &'static str {
        self.key
    }

    pub(super) fn ineffective(self) -> Ineffective {
        match self.is_axial {
            true => Ineffective::KeyOfAxialModel(self.key),
            false => Ineffective::KeyOfOtherModel(self.key),
        }
    }
}

/// What a layer has and its models do not use. Its unit weight loads the layers below; the friction
/// angle beside k, and the factor J of Reese's clay, have warnings of their own.
pub(super) fn of(layer: &GroundLayer, axial: Option<AxialModel>) -> Vec<Unused> {
    let model = layer.model;
    let has_modulus = uses_shear_modulus(layer, axial);
    let mut values = vec![
        (
            "poissons_ratio",
            layer.poissons_ratio.is_some(),
            uses_poissons_ratio(layer, axial),
        ),
        (
            layer.shear_modulus.as_ref().map_or("shear_modulus", key_of),
            layer.shear_modulus.is_some(),
            has_modulus,
        ),
    ];
    match &layer.soil {
        LayerSoil::Sand(sand) => values.extend([
            (
                "friction_angle",
                sand.friction_angle_deg.is_some(),
                model.has_modulus_of_sand() || model == SoilModel::Sorensen,
            ),
            (
                "subgrade_modulus",
                sand.subgrade_modulus_n_per_m3.is_some(),
                model.has_modulus_of_sand(),
            ),
            (
                "relative_density",
                sand.relative_density.is_some(),
                model == SoilModel::PisaDunkirk,
            ),
        ]),
        LayerSoil::Clay(clay) => values.extend([
            (
                "undrained_strength",
                clay.undrained_strength_pa.is_some(),
                model.has_resistance_of_clay(),
            ),
            (
                "strain_at_half_strength",
                clay.strain_at_half_strength.is_some(),
                model.has_resistance_of_clay(),
            ),
            (
                "strength_factor",
                clay.strength_factor.is_some(),
                model.has_resistance_of_clay(),
            ),
            (
                "stiffness_factor",
                clay.stiffness_factor.is_some(),
                model == SoilModel::Dnv,
            ),
        ]),
        LayerSoil::Elastic | LayerSoil::Rock(_) | LayerSoil::Table(_) => {}
    }
    let is_axial = axial == Some(AxialModel::Api);
    let of_axial = [
        ("shaft_friction", layer.shaft_friction_pa.is_some()),
        ("end_bearing", layer.end_bearing_pa.is_some()),
    ];
    let of_axial = of_axial
        .into_iter()
        .filter(|(_, is_given)| *is_given && !is_axial);
    let unused = values
        .into_iter()
        .filter(|(_, is_given, is_used)| *is_given && !*is_used);
    let unused = unused.map(|(key, ..)| Unused {
        key,
        is_axial: false,
    });
    unused
        .chain(of_axial.map(|(key, _)| Unused {
            key,
            is_axial: true,
        }))
        .collect()
}

fn uses_shear_modulus(layer: &GroundLayer, axial: Option<AxialModel>) -> bool {
    let of_axial = match axial {
        Some(AxialModel::Kraft | AxialModel::RandolphWroth) => true,
        None | Some(AxialModel::Api) => false,
    };
    of_axial || layer.model.is_pisa() || is_elastic(layer.model)
}

/// Rock has its shear modulus by Poisson's ratio.
fn uses_poissons_ratio(layer: &GroundLayer, axial: Option<AxialModel>) -> bool {
    let is_rock = matches!(layer.soil, LayerSoil::Rock(_));
    let is_youngs = matches!(layer.shear_modulus, Some(ShearModulus::Youngs { .. }));
    let follows = (is_rock || is_youngs) && uses_shear_modulus(layer, axial);
    follows || axial == Some(AxialModel::RandolphWroth) || is_elastic(layer.model)
}

fn is_elastic(model: SoilModel) -> bool {
    matches!(model, SoilModel::Winkler | SoilModel::Vesic)
}

/// The key by which a shear modulus is given.
fn key_of(modulus: &ShearModulus) -> &'static str {
    match modulus {
        ShearModulus::Given { .. } => "shear_modulus",
        ShearModulus::Youngs { .. } => "youngs_modulus",
        ShearModulus::WaveVelocity { .. } => "shear_wave_velocity",
        ShearModulus::RixStokoe { .. }
        | ShearModulus::MayneRix { .. }
        | ShearModulus::RobertsonCabal { .. } => "cone_resistance",
        ShearModulus::Hardin { .. } => "void_ratio",
        ShearModulus::BlowCount { .. } => "blow_count",
    }
}

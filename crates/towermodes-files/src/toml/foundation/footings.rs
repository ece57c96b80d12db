//! `[foundation] type = "circular-footing"`, `type = "rectangular-footing"` and
//! `type = "suction-caisson"`.

use towermodes::{CircularFooting, FootingFormula, Foundation, RectangularFooting, SuctionCaisson};

use super::choice::choice;
use super::pile::{profile, rigid_or, soil_modulus, soil_poissons_ratio};
use super::{Kind, at};
use crate::toml::reading::Reading;
use crate::toml::schema;
use crate::toml::table::Table;
use crate::toml::values::truth;

pub(super) const CIRCULAR: Kind = Kind {
    name: "circular-footing",
    schema: &schema::CIRCULAR_FOOTING,
    nature: "the stiffness of a circular footing follows from its radius, the stratum and what is below it",
    read: read_circular,
};

pub(super) const RECTANGULAR: Kind = Kind {
    name: "rectangular-footing",
    schema: &schema::RECTANGULAR_FOOTING,
    nature: "the stiffness of a rectangular footing follows from its sides and the soil",
    read: read_rectangular,
};

pub(super) const CAISSON: Kind = Kind {
    name: "suction-caisson",
    schema: &schema::SUCTION_CAISSON,
    nature: "the stiffness of a caisson follows from its dimensions and the elastic soil",
    read: read_caisson,
};

/// The names of the formulas.
pub(in crate::toml) const FOOTING_FORMULAS: [(&str, FootingFormula); 2] = [
    ("gazetas", FootingFormula::Gazetas),
    ("pais-kausel", FootingFormula::PaisKausel),
];

fn read_circular(table: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let radius = number(table, "radius", "radius of the footing in m", reading);
    let embedment = table.number_or(0.0, "embedment", at("embedment"), reading);
    let modulus = shear_modulus(table, reading);
    let ratio = soil_poissons_ratio(table, reading);
    let thickness = rigid_or(table, "soil_thickness", reading);
    let lower = lower_shear_modulus(table, reading);
    let is_coupled = coupled(table, reading);
    Some(Foundation::CircularFooting(Box::new(CircularFooting {
        radius_m: radius?,
        embedment_m: embedment?,
        shear_modulus_pa: modulus?,
        poissons_ratio: ratio?,
        stratum_thickness_m: thickness?,
        lower_shear_modulus_pa: lower?,
        is_coupled: is_coupled?,
    })))
}

fn read_rectangular(table: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let formula = choice(table, "formula", "formula", &FOOTING_FORMULAS, reading);
    let length_x = number(table, "length_x", "side along x in m", reading);
    let length_y = number(table, "length_y", "side along y in m", reading);
    let embedment = table.number_or(0.0, "embedment", at("embedment"), reading);
    let modulus = shear_modulus(table, reading);
    let ratio = soil_poissons_ratio(table, reading);
    let is_coupled = coupled(table, reading);
    Some(Foundation::RectangularFooting(Box::new(
        RectangularFooting {
            formula: formula?,
            length_x_m: length_x?,
            length_y_m: length_y?,
            embedment_m: embedment?,
            shear_modulus_pa: modulus?,
            poissons_ratio: ratio?,
            is_coupled: is_coupled?,
        },
    )))
}

fn read_caisson(table: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let diameter = number(table, "diameter", "diameter of the caisson in m", reading);
    let hint = "from the surface of the soil to the tip of the skirt, in m";
    let length = number(table, "skirt_length", hint, reading);
    let profile = profile(table, reading);
    let modulus = soil_modulus(table, reading);
    let ratio = soil_poissons_ratio(table, reading);
    let vertical = rigid_or(table, "vertical", reading);
    let torsion = rigid_or(table, "torsion", reading);
    Some(Foundation::SuctionCaisson(Box::new(SuctionCaisson {
        diameter_m: diameter?,
        skirt_length_m: length?,
        soil_profile: profile?,
        soil_youngs_modulus_pa: modulus?,
        soil_poissons_ratio: ratio?,
        vertical_n_per_m: vertical?,
        torsion_n_m: torsion?,
    })))
}

fn number(table: &Table<'_>, key: &'static str, hint: &str, reading: &mut Reading) -> Option<f64> {
    table.required_number(key, hint, at(key), reading)
}

fn shear_modulus(table: &Table<'_>, reading: &mut Reading) -> Option<f64> {
    let hint = "Pa; dense sand has about 5e7";
    number(table, "soil_shear_modulus", hint, reading)
}

/// Rock if it is left out; it needs a stratum above it.
fn lower_shear_modulus(table: &Table<'_>, reading: &mut Reading) -> Option<f64> {
    let key = "lower_shear_modulus";
    let thickness = "soil_thickness";
    if table.get(thickness).is_none() && !table.has_misspelled(thickness) {
        let hint = "add the thickness of the stratum above it, in m";
        table.refuse_unused(key, "without `soil_thickness`", hint, reading)?;
    }
    rigid_or(table, key, reading)
}

/// Whether the embedment couples sliding and rocking.
fn coupled(table: &Table<'_>, reading: &mut Reading) -> Option<bool> {
    let value = table.get("coupled");
    value.map_or(Some(false), |value| truth(value, "coupled", reading))
}

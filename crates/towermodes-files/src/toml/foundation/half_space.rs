//! `[foundation] type = "half-space"`: a rigid circular footing on elastic soil.

use towermodes::{Foundation, HalfSpace};

use super::{Kind, at};
use crate::toml::reading::Reading;
use crate::toml::schema;
use crate::toml::table::Table;

pub(super) const KIND: Kind = Kind {
    name: "half-space",
    schema: &schema::HALF_SPACE,
    nature: "the stiffness of a half-space follows from the footing and the soil",
    read,
};

fn read(table: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let mut required =
        |key: &'static str, hint: &str| table.required_number(key, hint, at(key), reading);
    let radius = required("radius", "radius of the footing in m");
    let modulus = required("soil_shear_modulus", "Pa; dense sand has about 5e7");
    let ratio = required("soil_poissons_ratio", "sand has about 0.3");
    let embedment = table.number_or(0.0, "embedment", at("embedment"), reading);
    Some(Foundation::HalfSpace(HalfSpace {
        radius_m: radius?,
        embedment_m: embedment?,
        shear_modulus_pa: modulus?,
        poissons_ratio: ratio?,
    }))
}

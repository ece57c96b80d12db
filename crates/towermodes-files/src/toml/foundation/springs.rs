//! `[foundation] type = "springs"`: a spring for each motion of the base.

use towermodes::{Foundation, FoundationSprings};

use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::number_or_infinity;
use super::{Kind, Read, at};
use crate::toml::schema;

pub(super) const KIND: Kind = Kind {
    name: "springs",
    schema: &schema::SPRINGS,
    nature: "each motion has its own spring",
    read: Read::By(read),
};

fn read(table: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let mut spring = |key: &'static str, unit: &str| {
        let hint = format!("{key} in {unit}; inf is rigid, 0 is none");
        let value = table.require(key, &hint, reading)?;
        reading.remember(at(key), value.span());
        number_or_infinity(value, key, reading)
    };
    let (lateral, rocking) = (spring("lateral", "N/m"), spring("rocking", "N m"));
    let (vertical, torsion) = (spring("vertical", "N/m"), spring("torsion", "N m"));
    let coupling = table.number_or(0.0, "coupling", at("coupling"), reading);
    Some(Foundation::Springs(FoundationSprings {
        lateral_n_per_m: lateral?,
        rocking_n_m: rocking?,
        coupling_n: coupling?,
        vertical_n_per_m: vertical?,
        torsion_n_m: torsion?,
    }))
}

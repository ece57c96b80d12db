//! `[foundation] type = "springs"`: a spring for each motion of the base.

use towermodes::inputs::Inputs;
use towermodes::{Foundation, FoundationSprings};

use super::super::inputs;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::{Kind, Read, at};
use crate::toml::schema;

pub(super) fn kind() -> Kind {
    Kind {
        name: "springs",
        schema: &schema::SPRINGS,
        nature: "each motion has its own spring",
        read: Read::By(read),
    }
}

fn read(table: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    inputs::read(FoundationSprings::blank(), table, at, reading).map(Foundation::Springs)
}

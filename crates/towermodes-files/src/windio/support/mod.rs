//! The support structure of a windIO turbine: tower and monopile, their walls or tables, soil and
//! water.

pub(super) mod comparison;
pub(super) mod curve;
pub(super) mod elastic;
pub(super) mod joint;
pub(super) mod layers;
pub(super) mod materials;
pub(super) mod part;
pub(super) mod sections;
pub(super) mod soil;
pub(super) mod structure;
pub(super) mod uniform;
pub(super) mod wall;
pub(super) mod water;

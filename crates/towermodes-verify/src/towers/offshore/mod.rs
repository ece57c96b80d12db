//! Structures in water: frames, moorings, and turbines on these.

mod floaters;
mod jacket;
mod monopiles;
mod moorings;
mod small_frames;
mod text;
mod turbines;
mod water;

pub use jacket::{jacket, transition_piece};
pub use monopiles::{iea_15_monopile, oc3_monopile};
pub use moorings::{
    buoyant, buoys, clump, coupled, delta, hywind, iea_22, mooring, oc4_semi, rod, tlp, volturnus,
    volturnus_windio,
};
pub use small_frames::{
    bent, guyed, jointed, tube_on_soil, with_body, with_heavy_links, with_spring, with_top_held,
};
pub use turbines::{
    Effects, hywind_turbine, iea_15_monopile_turbine, oc3_monopile_turbine, oc4_jacket_turbine,
    oc4_semi_turbine, volturnus_turbine,
};

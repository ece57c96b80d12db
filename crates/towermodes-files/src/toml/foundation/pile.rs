//! `[foundation] type = "monopile"` and `type = "winkler-pile"`: piles that are not part of the
//! tower.

use towermodes::{
    BeamFormula, Foundation, Monopile, PileFormula, PileTube, SoilProfile, SoilSpring, WinklerPile,
};

use super::choice::choice;
use super::{Kind, at};
use crate::toml::reading::Reading;
use crate::toml::schema;
use crate::toml::table::Table;
use crate::toml::values::number_or_infinity;

pub(super) const MONOPILE: Kind = Kind {
    name: "monopile",
    schema: &schema::MONOPILE,
    nature: "the stiffness of a monopile follows from the pile and the elastic soil",
    read: read_monopile,
};

pub(super) const WINKLER_PILE: Kind = Kind {
    name: "winkler-pile",
    schema: &schema::WINKLER_PILE,
    nature: "the stiffness of the pile follows from its springs soil_spring (z/D)^exponent",
    read: read_winkler_pile,
};

/// The names of the formulas.
pub(in crate::toml) const FORMULAS: [(&str, PileFormula); 4] = [
    ("shadlou-bhattacharya", PileFormula::ShadlouBhattacharya),
    ("randolph", PileFormula::Randolph),
    ("en-1998-5", PileFormula::En1998),
    ("carter-kulhawy", PileFormula::CarterKulhawy),
];

/// The names of the formulas for piles on springs.
pub(in crate::toml) const BEAM_FORMULAS: [(&str, BeamFormula); 2] = [
    ("exact", BeamFormula::Exact),
    ("poulos-davis", BeamFormula::PoulosDavis),
];

/// A formula for the springs along a pile.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::toml) enum SpringFormula {
    Gazetas,
    Vesic,
}

/// The names of the formulas for the springs along a pile.
pub(in crate::toml) const SPRING_FORMULAS: [(&str, SpringFormula); 2] = [
    ("gazetas", SpringFormula::Gazetas),
    ("vesic", SpringFormula::Vesic),
];

/// The names of the profiles.
pub(in crate::toml) const PROFILES: [(&str, SoilProfile); 3] = [
    ("homogeneous", SoilProfile::Homogeneous),
    ("parabolic", SoilProfile::Parabolic),
    ("linear", SoilProfile::Linear),
];

fn read_monopile(table: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let formula = choice(table, "formula", "formula", &FORMULAS, reading);
    let tube = tube(table, reading);
    let profile = profile(table, reading);
    let modulus = soil_modulus(table, reading);
    let ratio = soil_poissons_ratio(table, reading);
    let vertical = rigid_or(table, "vertical", reading);
    let torsion = rigid_or(table, "torsion", reading);
    Some(Foundation::Monopile(Box::new(Monopile {
        tube: tube?,
        formula: formula?,
        soil_profile: profile?,
        soil_youngs_modulus_pa: modulus?,
        soil_poissons_ratio: ratio?,
        vertical_n_per_m: vertical?,
        torsion_n_m: torsion?,
    })))
}

fn read_winkler_pile(table: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let tube = tube(table, reading);
    let formula = match table.get("formula") {
        None => Some(BeamFormula::Exact),
        Some(_) => choice(table, "formula", "formula", &BEAM_FORMULAS, reading),
    };
    let spring = soil_spring(table, reading);
    let (key, hint) = (
        "exponent",
        "of the depth: 0 for constant springs or modulus, 1 for linear growth",
    );
    let exponent = table.required_number(key, hint, at(key), reading);
    let vertical = rigid_or(table, "vertical", reading);
    let torsion = rigid_or(table, "torsion", reading);
    Some(Foundation::WinklerPile(Box::new(WinklerPile {
        tube: tube?,
        formula: formula?,
        soil_spring: spring?,
        exponent: exponent?,
        vertical_n_per_m: vertical?,
        torsion_n_m: torsion?,
    })))
}

/// Springs that are given, or that follow from the modulus of the soil by a formula that is named.
fn soil_spring(table: &Table<'_>, reading: &mut Reading) -> Option<SoilSpring> {
    if table.get("spring_formula").is_none() {
        return given_spring(table, reading);
    }
    let what = "formula for the springs";
    let formula = choice(table, "spring_formula", what, &SPRING_FORMULAS, reading);
    let (because, hint) = ("beside `spring_formula`", "keep one of the two");
    table.refuse_unused("soil_spring", because, hint, reading)?;
    let modulus = soil_modulus(table, reading);
    match formula? {
        SpringFormula::Gazetas => {
            let (key, because) = ("soil_poissons_ratio", "with spring_formula = \"gazetas\"");
            table.refuse_unused(key, because, "remove it", reading)?;
            let youngs_modulus_pa = modulus?;
            Some(SoilSpring::Gazetas { youngs_modulus_pa })
        }
        SpringFormula::Vesic => {
            let ratio = soil_poissons_ratio(table, reading);
            Some(SoilSpring::Vesic {
                youngs_modulus_pa: modulus?,
                poissons_ratio: ratio?,
            })
        }
    }
}

fn given_spring(table: &Table<'_>, reading: &mut Reading) -> Option<SoilSpring> {
    let is_misspelled = table.has_misspelled("spring_formula");
    for key in ["soil_youngs_modulus", "soil_poissons_ratio"] {
        if !is_misspelled {
            let hint = "add spring_formula = \"gazetas\" or \"vesic\", or give soil_spring alone";
            table.refuse_unused(key, "without `spring_formula`", hint, reading)?;
        }
    }
    let hint = "N/m2 per metre of pile at the depth of one diameter; or spring_formula with the modulus of the soil";
    let key = "soil_spring";
    let spring = table.required_number(key, hint, at(key), reading);
    spring.map(|spring_n_per_m2| SoilSpring::Given { spring_n_per_m2 })
}

fn tube(table: &Table<'_>, reading: &mut Reading) -> Option<PileTube> {
    let mut required =
        |key: &'static str, hint: &str| table.required_number(key, hint, at(key), reading);
    let diameter = required("diameter", "outer diameter of the pile in m");
    let wall = required("wall_thickness", "wall thickness of the pile in m");
    let length = required(
        "embedded_length",
        "from the surface of the soil to the tip, in m",
    );
    let modulus = required("youngs_modulus", "of the pile in Pa; steel has 2.1e11");
    Some(PileTube {
        diameter_m: diameter?,
        wall_thickness_m: wall?,
        embedded_length_m: length?,
        youngs_modulus_pa: modulus?,
    })
}

pub(super) fn profile(table: &Table<'_>, reading: &mut Reading) -> Option<SoilProfile> {
    choice(table, "soil_profile", "soil profile", &PROFILES, reading)
}

pub(super) fn soil_modulus(table: &Table<'_>, reading: &mut Reading) -> Option<f64> {
    let (key, hint) = ("soil_youngs_modulus", "Pa, at the depth of one diameter");
    table.required_number(key, hint, at(key), reading)
}

pub(super) fn soil_poissons_ratio(table: &Table<'_>, reading: &mut Reading) -> Option<f64> {
    let key = "soil_poissons_ratio";
    table.required_number(key, "sand has about 0.3", at(key), reading)
}

/// A spring that the closed forms do not give; rigid if it is left out.
pub(super) fn rigid_or(table: &Table<'_>, key: &'static str, reading: &mut Reading) -> Option<f64> {
    let Some(value) = table.get(key) else {
        return Some(f64::INFINITY);
    };
    reading.remember(at(key), value.span());
    number_or_infinity(value, key, reading)
}

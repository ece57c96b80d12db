//! The shear modulus of a layer: itself, or what it follows from by a named correlation.

use towermodes::{Place, ShearModulus};

use super::layer::{pair, pair_of};
use crate::toml::choice::{choices_hint, chosen};
use crate::toml::reading::Reading;
use crate::toml::table::Table;

/// The keys of which a layer may have one.
const SOURCES: [&str; 6] = [
    "shear_modulus",
    "youngs_modulus",
    "shear_wave_velocity",
    "cone_resistance",
    "blow_count",
    "void_ratio",
];

/// Correlations of the shear modulus with the resistance of a cone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Correlation {
    RixStokoe,
    MayneRix,
    RobertsonCabal,
}

const CORRELATIONS: [(&str, Correlation); 3] = [
    ("rix-stokoe", Correlation::RixStokoe),
    ("mayne-rix", Correlation::MayneRix),
    ("robertson-cabal", Correlation::RobertsonCabal),
];

const DENSITY: &str = "density of the soil with its water in kg/m3, about 1900";

/// The shear modulus: `Some(None)` if the layer has none, `None` after a mistake.
pub(super) fn shear_modulus(
    table: &Table<'_>,
    at: impl Fn(&'static str) -> Place,
    reading: &mut Reading,
) -> Option<Option<ShearModulus>> {
    let mut given = SOURCES.into_iter().filter(|key| table.get(key).is_some());
    let Some(source) = given.next() else {
        return unused(table, &[], reading).map(|()| None);
    };
    if let Some(second) = given.next() {
        let because = format!("beside {source}: both give the shear modulus");
        table.refuse_unused(second, because, "keep one of the two", reading)?;
    }
    let modulus = match source {
        "cone_resistance" => by_cone(table, at, reading),
        "void_ratio" => by_void_ratio(table, at, reading),
        source => by_profile(source, table, at, reading),
    };
    modulus.map(Some)
}

/// A modulus, a velocity or a blow count.
fn by_profile(
    source: &'static str,
    table: &Table<'_>,
    at: impl Fn(&'static str) -> Place,
    reading: &mut Reading,
) -> Option<ShearModulus> {
    let profile = pair(table, source, at(source), reading);
    let needs_density = matches!(source, "shear_wave_velocity" | "blow_count");
    let others: &[&str] = if needs_density { &["density"] } else { &[] };
    let unused = unused(table, others, reading);
    let density = match needs_density {
        true => table.required_number("density", DENSITY, at("density"), reading)?,
        false => 0.0,
    };
    unused?;
    let profile = profile??;
    Some(match source {
        "shear_modulus" => ShearModulus::Given {
            shear_modulus_pa: profile,
        },
        "youngs_modulus" => ShearModulus::Youngs {
            youngs_modulus_pa: profile,
        },
        "shear_wave_velocity" => ShearModulus::WaveVelocity {
            velocity_m_per_s: profile,
            density_kg_per_m3: density,
        },
        _ => ShearModulus::BlowCount {
            blow_count: profile,
            density_kg_per_m3: density,
        },
    })
}

fn by_cone(
    table: &Table<'_>,
    at: impl Fn(&'static str) -> Place,
    reading: &mut Reading,
) -> Option<ShearModulus> {
    let key = "cone_resistance";
    let value = table.get(key)?;
    reading.remember(at(key), value.span());
    let cone_resistance_pa = pair_of(value, key, reading);
    let hint = choices_hint("correlation", &CORRELATIONS);
    let value = table.require("correlation", &hint, reading)?;
    let correlation = chosen(value, "correlation", &CORRELATIONS, reading)?;
    if correlation != Correlation::RobertsonCabal {
        unused(table, &["correlation"], reading)?;
        let cone_resistance_pa = cone_resistance_pa?;
        return Some(match correlation {
            Correlation::RixStokoe => ShearModulus::RixStokoe { cone_resistance_pa },
            _ => ShearModulus::MayneRix { cone_resistance_pa },
        });
    }
    unused(
        table,
        &["correlation", "behaviour_index", "density"],
        reading,
    )?;
    let hint = "the soil behaviour type index I_c, about 1 to 4";
    let index = table.required_number("behaviour_index", hint, at("behaviour_index"), reading);
    let density = table.required_number("density", DENSITY, at("density"), reading);
    Some(ShearModulus::RobertsonCabal {
        cone_resistance_pa: cone_resistance_pa?,
        behaviour_index: index?,
        density_kg_per_m3: density?,
    })
}

fn by_void_ratio(
    table: &Table<'_>,
    at: impl Fn(&'static str) -> Place,
    reading: &mut Reading,
) -> Option<ShearModulus> {
    let unused = unused(table, &["earth_pressure_at_rest"], reading);
    let ratio = table.required_number("void_ratio", "", at("void_ratio"), reading);
    let key = "earth_pressure_at_rest";
    let hint = "the coefficient K0, about 0.4";
    let pressure = table.required_number(key, hint, at(key), reading);
    unused?;
    Some(ShearModulus::Hardin {
        void_ratio: ratio?,
        earth_pressure_at_rest: pressure?,
    })
}

/// Refuses keys that belong to another source of the shear modulus.
fn unused(table: &Table<'_>, used: &[&str], reading: &mut Reading) -> Option<()> {
    let keys = [
        ("correlation", "without cone_resistance"),
        (
            "behaviour_index",
            "without correlation = \"robertson-cabal\"",
        ),
        ("earth_pressure_at_rest", "without void_ratio"),
        (
            "density",
            "without shear_wave_velocity, blow_count or correlation = \"robertson-cabal\"",
        ),
    ];
    let unused = |(key, _): &(&str, &str)| !used.contains(key) && table.get(key).is_some();
    let Some((key, because)) = keys.into_iter().find(unused) else {
        return Some(());
    };
    let hint = "remove it, or give the key it belongs to";
    table.refuse_unused(key, because, hint, reading)
}

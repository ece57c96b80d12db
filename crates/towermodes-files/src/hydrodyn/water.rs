//! Density, depth and level of the water: in HydroDyn until OpenFAST 3.5, in SeaState since 4.0, in
//! the `.fst` file since 3.1.

use super::values::Values;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::records::Token;
use crate::source::Source;

const NAMES: [&str; 3] = ["WtrDens", "WtrDpth", "MSL2SWL"];

/// The water that another file gives; a value is none if no file gives it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WaterDefaults {
    /// Density, kg/m³.
    pub density_kg_per_m3: Option<f64>,
    /// Depth below mean sea level, m.
    pub depth_m: Option<f64>,
    /// Height of the still water above mean sea level, m.
    pub level_m: Option<f64>,
}

/// The water of a model. z = 0 is mean sea level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeaWater {
    /// Density, kg/m³.
    pub density_kg_per_m3: f64,
    /// Depth below mean sea level, m.
    pub depth_m: f64,
    /// Height of the still water above mean sea level, m.
    pub level_m: f64,
}

/// A structure stands on the seabed if the distance of its lowest point from the seabed is smaller
/// than the larger of this fraction of the depth and this length, m, because piles
/// end above the seabed.
const NEAR: f64 = 0.1;
const NEAR_M: f64 = 2.0;
/// Two heights that differ by less than this fraction of the depth count as equal.
const ON_SEABED: f64 = 0.01;

impl SeaWater {
    /// The largest distance from the seabed at which a structure stands on it, m.
    pub(crate) fn near_seabed_m(&self) -> f64 {
        (NEAR * self.depth_m).max(NEAR_M)
    }

    /// Whether a height is on the seabed or below it, apart from rounding.
    pub(crate) fn is_on_seabed(&self, z_m: f64) -> bool {
        z_m <= -self.depth_m * (1.0 - ON_SEABED)
    }

    /// Whether a height is in the water.
    pub(super) fn holds(&self, z_m: f64) -> bool {
        z_m >= -self.depth_m && z_m <= self.level_m
    }
}

/// The water that a `.fst` file, a SeaState file or a HydroDyn file gives. A number in the file has
/// priority over the default; `default` and a missing value mean the default.
///
/// # Errors
/// [`ReadError::Mistakes`] at a value that is neither a number nor `default`, and at a density or
/// depth that is not positive.
pub fn read_water(source: &Source, defaults: WaterDefaults) -> Result<WaterDefaults, ReadError> {
    let values = Values::of(&source.text);
    given(&values, defaults).map_err(|mistake| ReadError::mistake(source, mistake))
}

/// The water that a `.fst` file gives. The other files take their defaults from this file, so
/// `default` in this file is a mistake.
///
/// # Errors
/// [`ReadError::Mistakes`] as [`read_water`], and at `default`.
pub(crate) fn water_of_fst(source: &Source) -> Result<WaterDefaults, ReadError> {
    let values = Values::of(&source.text);
    for name in NAMES {
        let token = values.token(name);
        if let Some(token) = token.filter(|token| is_default(token)) {
            let kind = DiagnosticKind::wrong_type(name, "a number", "`DEFAULT`");
            let hint = "write a number: the .fst file gives the defaults of the HydroDyn and SeaState files";
            return Err(ReadError::mistake(
                source,
                token.wrong(kind).with_hint(hint),
            ));
        }
    }
    read_water(source, WaterDefaults::default())
}

fn is_default(token: &Token<'_>) -> bool {
    token.text.trim().eq_ignore_ascii_case("default")
}

/// A value of the water in one file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GivenWater {
    pub(crate) name: &'static str,
    pub(crate) value: f64,
    /// The byte of the value.
    pub(crate) at: usize,
}

/// The values of the water that a file gives as numbers.
pub(crate) fn given_in(source: &Source) -> Vec<GivenWater> {
    let values = Values::of(&source.text);
    let found = NAMES.into_iter().filter_map(|name| {
        Some(GivenWater {
            name,
            value: value(&values, name).ok()??,
            at: values.token(name)?.span.start,
        })
    });
    found.collect()
}

/// As [`given_in`], for a file whose values are already read.
pub(super) fn given(
    values: &Values<'_>,
    defaults: WaterDefaults,
) -> Result<WaterDefaults, Diagnostic> {
    let [density, depth, level] = NAMES;
    let positive = |name: &str, default: Option<f64>| match value(values, name)? {
        Some(_) => values.positive(name).map(Some),
        None => Ok(default),
    };
    Ok(WaterDefaults {
        density_kg_per_m3: positive(density, defaults.density_kg_per_m3)?,
        depth_m: positive(depth, defaults.depth_m)?,
        level_m: value(values, level)?.or(defaults.level_m),
    })
}

/// A number, or none for `default`.
fn value(values: &Values<'_>, name: &str) -> Result<Option<f64>, Diagnostic> {
    match values.token(name) {
        None => Ok(None),
        Some(token) if is_default(&token) => Ok(None),
        Some(_) => values.number(name).map(Some),
    }
}

/// The water of a model with all values; the level is 0 if no file gives it.
pub(super) fn complete(water: WaterDefaults) -> Result<SeaWater, Diagnostic> {
    let missing = |name: &str| {
        let kind = DiagnosticKind::missing_key("the HydroDyn file", name);
        let hint = "since OpenFAST 4.0 the water is in the .fst file or in the SeaState file: read the .fst file, or write the value and this name on a line of their own";
        Diagnostic::new(0..0, kind).with_hint(hint)
    };
    let [density, depth, _] = NAMES;
    let water = SeaWater {
        density_kg_per_m3: water.density_kg_per_m3.ok_or_else(|| missing(density))?,
        depth_m: water.depth_m.ok_or_else(|| missing(depth))?,
        level_m: water.level_m.unwrap_or(0.0),
    };
    match water.level_m > -water.depth_m {
        true => Ok(water),
        false => {
            let message = format!(
                "MSL2SWL is {} m, but the seabed is at {} m: there is no water",
                water.level_m, -water.depth_m
            );
            Err(Diagnostic::new(
                0..0,
                DiagnosticKind::Contradiction(message),
            ))
        }
    }
}

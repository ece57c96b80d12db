//! Comparison of the bodies on the towers and of their supports: rotor-nacelle assembly, platform,
//! moorings, substructure, water.

use super::compared::{AgreementLimits, Compared};
use crate::verdict::Verdict;
use towermodes::tower::{Tower, TowerDescription};

/// A quantity of a part that at least one of two towers has.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ComparedPart {
    /// The quantity: "platform mass".
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// The value of the first tower; none if it has no such part.
    pub first: Option<f64>,
    /// The value of the second tower; none if it has no such part.
    pub second: Option<f64>,
    /// The relative difference second/first − 1, if both have it; infinite (in JSON null) if only
    /// the first is zero.
    pub difference: Option<f64>,
    /// The verdict on the difference. A part that only one tower has gives a warning, because files
    /// of some programs contain only some parts; compare the frequencies to see the effect of this
    /// part.
    pub verdict: Verdict,
}

/// The limit that applies to a quantity.
#[derive(Debug, Clone, Copy)]
enum Limit {
    Mass,
    Stiffness,
}

/// A quantity of a part.
struct Quantity {
    name: &'static str,
    unit: &'static str,
    limit: Limit,
    of: fn(&Described<'_>) -> Option<f64>,
}

/// A tower and its description.
pub(super) struct Described<'a> {
    pub(super) description: &'a TowerDescription,
    pub(super) tower: &'a Tower,
}

const QUANTITIES: [Quantity; 12] = [
    mass("RNA mass", "kg", |of| of.rna(|rna| rna.mass_kg)),
    mass(
        "RNA inertia about the fore-aft axis at the tower top",
        "kg m2",
        |of| of.rna_inertia(3),
    ),
    mass(
        "RNA inertia about the side-side axis at the tower top",
        "kg m2",
        |of| of.rna_inertia(4),
    ),
    mass("RNA inertia about the tower axis", "kg m2", |of| {
        of.rna_inertia(5)
    }),
    mass("substructure mass", "kg", |of| {
        let members_kg = of.tower.structure_mass_kg() - of.tower.mass_kg();
        of.tower.frame().map(|_| members_kg)
    }),
    mass("platform mass", "kg", |of| {
        let platform = of.description.foundation.floating()?;
        (platform.mass_kg != 0.0).then_some(platform.mass_kg)
    }),
    stiffness("hydrostatic stiffness in heave", "N/m", |of| {
        Some(of.description.foundation.floating()?.hydrostatic.matrix[2][2])
    }),
    stiffness("mooring stiffness in surge", "N/m", |of| of.mooring(0)),
    stiffness("mooring stiffness in sway", "N/m", |of| of.mooring(1)),
    stiffness("mooring stiffness in heave", "N/m", |of| of.mooring(2)),
    stiffness("mooring stiffness in yaw", "N m", |of| of.mooring(5)),
    mass("water depth", "m", |of| of.water_depth_m()),
];

/// A quantity to which the limit of masses applies.
const fn mass(
    name: &'static str,
    unit: &'static str,
    of: fn(&Described<'_>) -> Option<f64>,
) -> Quantity {
    Quantity {
        limit: Limit::Mass,
        ..stiffness(name, unit, of)
    }
}

/// A quantity to which the limit of stiffnesses applies.
const fn stiffness(
    name: &'static str,
    unit: &'static str,
    of: fn(&Described<'_>) -> Option<f64>,
) -> Quantity {
    let limit = Limit::Stiffness;
    Quantity {
        name,
        unit,
        limit,
        of,
    }
}

impl Described<'_> {
    /// A quantity of the rotor-nacelle assembly, if there is one.
    fn rna(&self, of: impl Fn(&towermodes::Rna) -> f64) -> Option<f64> {
        let rna = self.tower.rna();
        (!rna.is_absent()).then(|| of(rna))
    }

    /// Inertia of the rotor-nacelle assembly about an axis through the tower top, by component.
    fn rna_inertia(&self, component: usize) -> Option<f64> {
        self.rna(|rna| {
            let [x, y, z] = rna.center_m.map(|coordinate| coordinate * coordinate);
            let (own, arm) = match component {
                3 => (rna.inertia_kg_m2.xx, y + z),
                4 => (rna.inertia_kg_m2.yy, x + z),
                _ => (rna.inertia_kg_m2.zz, x + y),
            };
            own + rna.mass_kg * arm
        })
    }

    /// The stiffness of matrix and lines in a component, if the lines have a stiffness.
    fn mooring(&self, component: usize) -> Option<f64> {
        Some(self.tower.linear_platform()?.mooring.matrix[component][component])
    }

    /// The depth of the water, if the description gives water level and seabed.
    fn water_depth_m(&self) -> Option<f64> {
        let platform = self.description.foundation.floating();
        let lines = platform.and_then(|platform| platform.mooring_lines.as_deref());
        let of_water = self.description.water.as_ref();
        let of_water = of_water.and_then(|water| Some(water.level_m - water.bed_m?));
        of_water.or(lines.map(|lines| lines.description.depth_m))
    }
}

/// The quantities that at least one of two towers has.
pub(super) fn compared_parts(
    [first, second]: [Described<'_>; 2],
    limits: &AgreementLimits,
) -> Vec<ComparedPart> {
    let compared = |quantity: &Quantity| {
        let (first, second) = ((quantity.of)(&first), (quantity.of)(&second));
        let limit = match quantity.limit {
            Limit::Mass => limits.mass,
            Limit::Stiffness => limits.stiffness,
        };
        let both = first.zip(second);
        let both = both.map(|(first, second)| Compared::ratio(first, second, limit));
        first.or(second).map(|_| ComparedPart {
            name: quantity.name,
            unit: quantity.unit,
            first,
            second,
            difference: both.map(|both| both.difference),
            verdict: both.map_or(Verdict::Warn, |both| both.verdict),
        })
    };
    QUANTITIES.iter().filter_map(compared).collect()
}

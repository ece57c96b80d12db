//! The names of the models that give springs from values of the soil.

use crate::inputs::{Named, names};

/// A model of the springs that a layer of soil gives to a pile at small displacements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SoilModel {
    /// API, by the edition of the ground. Sand: k z, the initial stiffness of the curve. Clay
    /// (Matlock 1970), whose curve has no initial stiffness: the secant to 0.23 of the strength, at
    /// 0.1 y₅₀.
    Api,
    /// DNV. Sand as API; clay: ξ p_u/(D ε₅₀^0.25).
    Dnv,
    /// Reese, Cox & Koop (1975), stiff clay: the secant of COSPIN, at 0.1 ε₅₀ D.
    ReeseStiffClay,
    /// Kallehave, Le Blanc Thilsted & Liingaard (2012), sand and large diameters.
    Kallehave,
    /// Sørensen, Ibsen & Augustesen (2010), sand and large diameters.
    Sorensen,
    /// PISA, stiff clay (Cowden till): Byrne et al. (2020).
    PisaCowden,
    /// PISA, soft clay (Bothkennar): Burd et al. (2020), layered soils.
    PisaBothkennar,
    /// PISA, sand (Dunkirk): Burd et al. (2020).
    PisaDunkirk,
    /// Springs 1.2 E per metre of pile, from Young's modulus E.
    Winkler,
    /// Vesić (1961), from Young's modulus and the stiffness of the pile.
    Vesic,
    /// Reese (1997), weak rock.
    WeakRock,
    /// Secants p/y of the points in a table.
    Table,
}

names!(SoilModel:
    Api = "api",
    Dnv = "dnv",
    ReeseStiffClay = "reese-stiff-clay",
    Kallehave = "kallehave",
    Sorensen = "sorensen",
    PisaCowden = "pisa-cowden",
    PisaBothkennar = "pisa-bothkennar",
    PisaDunkirk = "pisa-dunkirk",
    Winkler = "winkler",
    Vesic = "vesic",
    WeakRock = "weak-rock",
    Table = "py",
);

impl SoilModel {
    /// Its name, as in the tower file.
    pub fn name(self) -> &'static str {
        Named::name(self)
    }
}

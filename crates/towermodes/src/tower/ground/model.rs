//! The models by which springs follow from soil.

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
    /// 1.2 E: from Young's modulus.
    Winkler,
    /// Vesić (1961), from Young's modulus and the stiffness of the pile.
    Vesic,
    /// Reese (1997), weak rock.
    WeakRock,
    /// The secants of a table.
    Table,
}

impl SoilModel {
    /// Its name, as in the tower file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Api => "api",
            Self::Dnv => "dnv",
            Self::ReeseStiffClay => "reese-stiff-clay",
            Self::Kallehave => "kallehave",
            Self::Sorensen => "sorensen",
            Self::PisaCowden => "pisa-cowden",
            Self::PisaBothkennar => "pisa-bothkennar",
            Self::PisaDunkirk => "pisa-dunkirk",
            Self::Winkler => "winkler",
            Self::Vesic => "vesic",
            Self::WeakRock => "weak-rock",
            Self::Table => "py",
        }
    }

    /// Whether it is one of PISA.
    pub(in crate::tower) fn is_pisa(self) -> bool {
        match self {
            Self::PisaCowden | Self::PisaBothkennar | Self::PisaDunkirk => true,
            Self::Api
            | Self::Dnv
            | Self::ReeseStiffClay
            | Self::Kallehave
            | Self::Sorensen
            | Self::Winkler
            | Self::Vesic
            | Self::WeakRock
            | Self::Table => false,
        }
    }

    /// Whether the springs of sand are in proportion to the modulus k of API.
    pub(in crate::tower) fn has_modulus_of_sand(self) -> bool {
        match self {
            Self::Api | Self::Dnv | Self::Kallehave => true,
            Self::ReeseStiffClay
            | Self::Sorensen
            | Self::PisaCowden
            | Self::PisaBothkennar
            | Self::PisaDunkirk
            | Self::Winkler
            | Self::Vesic
            | Self::WeakRock
            | Self::Table => false,
        }
    }

    /// Whether the springs of clay are in proportion to its lateral resistance.
    pub(in crate::tower) fn has_resistance_of_clay(self) -> bool {
        match self {
            Self::Api | Self::Dnv | Self::ReeseStiffClay => true,
            Self::Kallehave
            | Self::Sorensen
            | Self::PisaCowden
            | Self::PisaBothkennar
            | Self::PisaDunkirk
            | Self::Winkler
            | Self::Vesic
            | Self::WeakRock
            | Self::Table => false,
        }
    }
}

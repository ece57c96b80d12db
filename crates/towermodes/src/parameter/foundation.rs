//! The numbers of the foundation.

use super::part::{Indices, Key, Part, fields, is_there};
use crate::space::SpatialMatrix;
use crate::tower::{
    CircularFooting, FloatingPlatform, Foundation, FoundationSprings, HalfSpace, Monopile, Place,
    RectangularFooting, SoilSpring, StiffnessFoundation, SuctionCaisson, TowerDescription,
    WinklerPile,
};

/// The foundation of one type, for reading and for writing.
macro_rules! foundation_of {
    ($get:ident, $get_mut:ident, $variant:ident, $type:ty) => {
        fn $get(description: &TowerDescription) -> Option<&$type> {
            let Foundation::$variant(foundation) = &description.foundation else {
                return None;
            };
            Some(foundation)
        }

        fn $get_mut(description: &mut TowerDescription) -> Option<&mut $type> {
            let Foundation::$variant(foundation) = &mut description.foundation else {
                return None;
            };
            Some(foundation)
        }
    };
}

foundation_of!(springs, springs_mut, Springs, FoundationSprings);
foundation_of!(half_space, half_space_mut, HalfSpace, HalfSpace);
foundation_of!(circular, circular_mut, CircularFooting, CircularFooting);
foundation_of!(
    rectangular,
    rectangular_mut,
    RectangularFooting,
    RectangularFooting
);
foundation_of!(caisson, caisson_mut, SuctionCaisson, SuctionCaisson);
foundation_of!(monopile, monopile_mut, Monopile, Monopile);
foundation_of!(winkler_pile, winkler_pile_mut, WinklerPile, WinklerPile);
foundation_of!(stiffness, stiffness_mut, Stiffness, StiffnessFoundation);
foundation_of!(floating, floating_mut, Floating, FloatingPlatform);

/// The numbers of a foundation of one type.
macro_rules! foundation {
    ($(#[$doc:meta])+ $id:ident = $noun:literal, $get:ident $get_mut:ident: $($keys:tt)+) => {
        $(#[$doc])+
        pub(super) static $id: Part = Part {
            name: "foundation",
            noun: $noun,
            count: |d| usize::from($get(d).is_some()),
            rows: |_, _| 1,
            is_symmetric: false,
            keys: fields! {
                get |d, _i| $get(d)?;
                set |d, _i| $get_mut(d)?;
                place |_i, key| Place::Foundation { key };
                $($keys)+
            },
        };
    };
}

foundation! {
    /// `[foundation]` of type `springs`.
    SPRINGS = "foundation of type \"springs\"", springs springs_mut:
        "lateral" "N/m" "stiffness against x and y", "lateral" lateral_n_per_m;
        "rocking" "N m" "stiffness against rotation about x and y", "rocking" rocking_n_m;
        "coupling" "N" "stiffness between x and rotation about y", "coupling" coupling_n;
        "vertical" "N/m" "stiffness against z", "vertical" vertical_n_per_m;
        "torsion" "N m" "stiffness against rotation about z", "torsion" torsion_n_m;
}

foundation! {
    /// `[foundation]` of type `half-space`.
    HALF_SPACE = "foundation of type \"half-space\"", half_space half_space_mut:
        "radius" "m" "radius", "radius" radius_m;
        "embedment" "m" "depth of embedment", "embedment" embedment_m;
        "soil_shear_modulus" "Pa" "shear modulus of the soil", "soil_shear_modulus" shear_modulus_pa;
        "soil_poissons_ratio" "" "Poisson's ratio of the soil", "soil_poissons_ratio" poissons_ratio;
}

foundation! {
    /// `[foundation]` of type `circular-footing`.
    CIRCULAR_FOOTING = "foundation of type \"circular-footing\"", circular circular_mut:
        "radius" "m" "radius", "radius" radius_m;
        "embedment" "m" "depth of embedment", "embedment" embedment_m;
        "soil_shear_modulus" "Pa" "shear modulus of the stratum", "soil_shear_modulus" shear_modulus_pa;
        "soil_poissons_ratio" "" "Poisson's ratio of the stratum", "soil_poissons_ratio" poissons_ratio;
        "soil_thickness" "m" "thickness of the stratum", "soil_thickness" stratum_thickness_m;
        "lower_shear_modulus" "Pa" "shear modulus below the stratum", "lower_shear_modulus" lower_shear_modulus_pa;
}

foundation! {
    /// `[foundation]` of type `rectangular-footing`.
    RECTANGULAR_FOOTING = "foundation of type \"rectangular-footing\"", rectangular rectangular_mut:
        "length_x" "m" "side along x", "length_x" length_x_m;
        "length_y" "m" "side along y", "length_y" length_y_m;
        "embedment" "m" "depth of embedment", "embedment" embedment_m;
        "soil_shear_modulus" "Pa" "shear modulus of the soil", "soil_shear_modulus" shear_modulus_pa;
        "soil_poissons_ratio" "" "Poisson's ratio of the soil", "soil_poissons_ratio" poissons_ratio;
}

foundation! {
    /// `[foundation]` of type `suction-caisson`.
    SUCTION_CAISSON = "foundation of type \"suction-caisson\"", caisson caisson_mut:
        "diameter" "m" "diameter of the caisson", "diameter" diameter_m;
        "skirt_length" "m" "length of the skirt", "skirt_length" skirt_length_m;
        "soil_youngs_modulus" "Pa" "Young's modulus of the soil at the depth of one diameter", "soil_youngs_modulus" soil_youngs_modulus_pa;
        "soil_poissons_ratio" "" "Poisson's ratio of the soil", "soil_poissons_ratio" soil_poissons_ratio;
        "vertical" "N/m" "stiffness against z", "vertical" vertical_n_per_m;
        "torsion" "N m" "stiffness against rotation about z", "torsion" torsion_n_m;
}

foundation! {
    /// `[foundation]` of type `monopile`.
    MONOPILE = "foundation of type \"monopile\"", monopile monopile_mut:
        "diameter" "m" "outer diameter of the pile", "diameter" tube.diameter_m;
        "wall_thickness" "m" "wall thickness of the pile", "wall_thickness" tube.wall_thickness_m;
        "embedded_length" "m" "embedded length of the pile", "embedded_length" tube.embedded_length_m;
        "youngs_modulus" "Pa" "Young's modulus of the pile", "youngs_modulus" tube.youngs_modulus_pa;
        "soil_youngs_modulus" "Pa" "Young's modulus of the soil at the depth of one diameter", "soil_youngs_modulus" soil_youngs_modulus_pa;
        "soil_poissons_ratio" "" "Poisson's ratio of the soil", "soil_poissons_ratio" soil_poissons_ratio;
        "vertical" "N/m" "stiffness against z", "vertical" vertical_n_per_m;
        "torsion" "N m" "stiffness against rotation about z", "torsion" torsion_n_m;
}

foundation! {
    /// `[foundation]` of type `winkler-pile`.
    WINKLER_PILE = "foundation of type \"winkler-pile\"", winkler_pile winkler_pile_mut:
        "diameter" "m" "outer diameter of the pile", "diameter" tube.diameter_m;
        "wall_thickness" "m" "wall thickness of the pile", "wall_thickness" tube.wall_thickness_m;
        "embedded_length" "m" "embedded length of the pile", "embedded_length" tube.embedded_length_m;
        "youngs_modulus" "Pa" "Young's modulus of the pile", "youngs_modulus" tube.youngs_modulus_pa;
        "exponent" "" "exponent of the depth in the soil spring, or in the modulus of the soil", "exponent" exponent;
        "vertical" "N/m" "stiffness against z", "vertical" vertical_n_per_m;
        "torsion" "N m" "stiffness against rotation about z", "torsion" torsion_n_m;
}

/// A number of the springs along a pile, which has it or not.
macro_rules! of_springs {
    ($($(#[$doc:meta])+ $id:ident = $key:literal $unit:literal $meaning:literal, $get:ident;)+) => {
        $($(#[$doc])+ pub(super) static $id: Part = Part {
            name: "foundation",
            noun: "foundation of type \"winkler-pile\"",
            count: |d| usize::from(of_springs(d, $get).is_some()),
            rows: |_, _| 1,
            is_symmetric: false,
            keys: &[Key {
                name: $key,
                unit: $unit,
                meaning: $meaning,
                place: |_| Place::Foundation { key: $key },
                get: |d, _| of_springs(d, $get),
                set: |d, _, value| {
                    *$get(&mut winkler_pile_mut(d)?.soil_spring)? = value;
                    Some(())
                },
                is_listed: is_there,
            }],
        };)+
    };
}

of_springs! {
    /// `soil_spring` of a pile.
    SOIL_SPRING = "soil_spring" "N/m2" "soil spring at the depth of one diameter", given_spring;
    /// `soil_youngs_modulus` of a pile whose springs follow from it.
    SPRING_MODULUS = "soil_youngs_modulus" "Pa" "Young's modulus of the soil at the depth of one diameter", spring_modulus;
    /// `soil_poissons_ratio` of a pile whose springs follow from it.
    SPRING_RATIO = "soil_poissons_ratio" "" "Poisson's ratio of the soil", spring_ratio;
}

fn of_springs(
    description: &TowerDescription,
    number: fn(&mut SoilSpring) -> Option<&mut f64>,
) -> Option<f64> {
    let mut spring = winkler_pile(description)?.soil_spring;
    number(&mut spring).copied()
}

fn given_spring(spring: &mut SoilSpring) -> Option<&mut f64> {
    match spring {
        SoilSpring::Given { spring_n_per_m2 } => Some(spring_n_per_m2),
        SoilSpring::Gazetas { .. } | SoilSpring::Vesic { .. } => None,
    }
}

fn spring_modulus(spring: &mut SoilSpring) -> Option<&mut f64> {
    match spring {
        SoilSpring::Given { .. } => None,
        SoilSpring::Gazetas { youngs_modulus_pa }
        | SoilSpring::Vesic {
            youngs_modulus_pa, ..
        } => Some(youngs_modulus_pa),
    }
}

fn spring_ratio(spring: &mut SoilSpring) -> Option<&mut f64> {
    match spring {
        SoilSpring::Given { .. } | SoilSpring::Gazetas { .. } => None,
        SoilSpring::Vesic { poissons_ratio, .. } => Some(poissons_ratio),
    }
}

foundation! {
    /// `[foundation]` of type `floating`.
    FLOATING = "floating platform", floating floating_mut:
        "mass" "kg" "mass with ballast", "mass" mass_kg;
        "center[0]" "m" "centre of mass from the tower axis, downwind", "center" center_m[0];
        "center[1]" "m" "centre of mass from the tower axis, side-side", "center" center_m[1];
        "center[2]" "m" "height of the centre of mass", "center" center_m[2];
        "inertia.xx" "kg m2" "inertia about the fore-aft axis", "inertia" inertia_kg_m2.xx;
        "inertia.yy" "kg m2" "inertia about the side-side axis", "inertia" inertia_kg_m2.yy;
        "inertia.zz" "kg m2" "inertia about the tower axis", "inertia" inertia_kg_m2.zz;
        "inertia.xy" "kg m2" "entry xy of the inertia", "inertia" inertia_kg_m2.xy;
        "inertia.xz" "kg m2" "entry xz of the inertia", "inertia" inertia_kg_m2.xz;
        "inertia.yz" "kg m2" "entry yz of the inertia", "inertia" inertia_kg_m2.yz;
        "added_mass_height" "m" "height of the reference point of added_mass", "added_mass" added_mass.height_m;
        "hydrostatic_height" "m" "height of the reference point of hydrostatic", "hydrostatic" hydrostatic.height_m;
        "mooring_height" "m" "height of the reference point of mooring", "mooring" mooring.height_m;
}

/// A symmetric 6×6 matrix of a foundation.
macro_rules! matrix {
    ($($(#[$doc:meta])+ $id:ident = $key:literal $unit:literal $meaning:literal of $noun:literal, $get:ident $get_mut:ident, $($field:ident).+;)+) => {
        $($(#[$doc])+ pub(super) static $id: Part = Part {
            name: concat!("foundation.", $key, "[][]"),
            noun: $noun,
            count: |d| if $get(d).is_some() { 6 } else { 0 },
            rows: |_, _| 6,
            is_symmetric: true,
            keys: &[Key {
                name: "",
                unit: $unit,
                meaning: $meaning,
                place: |_| Place::Foundation { key: $key },
                get: |d, i| entry(&$get(d)?.$($field).+, i),
                set: |d, i, value| set_entries(&mut $get_mut(d)?.$($field).+, i, value),
                is_listed: |d, i| $get(d).is_some_and(|of| is_entry(&of.$($field).+, i)),
            }],
        };)+
    };
}

matrix! {
    /// `matrix` of `[foundation]` of type `stiffness`.
    STIFFNESS_MATRIX = "matrix" "N/m, N, N m" "stiffness: x, y, z, rotation about x, y, z" of "foundation of type \"stiffness\"", stiffness stiffness_mut, stiffness;
    /// Its `mass`.
    STIFFNESS_MASS = "mass" "kg, kg m, kg m2" "mass at the base" of "foundation of type \"stiffness\"", stiffness stiffness_mut, inertia;
    /// `added_mass` of a floating platform.
    FLOATING_ADDED_MASS = "added_mass" "kg, kg m, kg m2" "added mass" of "floating platform", floating floating_mut, added_mass.matrix;
    /// Its `hydrostatic`.
    FLOATING_HYDROSTATIC = "hydrostatic" "N/m, N, N m" "hydrostatic stiffness" of "floating platform", floating floating_mut, hydrostatic.matrix;
    /// Its `mooring`.
    FLOATING_MOORING = "mooring" "N/m, N, N m" "stiffness of the moorings" of "floating platform", floating floating_mut, mooring.matrix;
}

fn entry(matrix: &SpatialMatrix, [row, column]: Indices) -> Option<f64> {
    matrix.get(row)?.get(column).copied()
}

fn set_entries(matrix: &mut SpatialMatrix, [row, column]: Indices, value: f64) -> Option<()> {
    *matrix.get_mut(row)?.get_mut(column)? = value;
    *matrix.get_mut(column)?.get_mut(row)? = value;
    Some(())
}

/// Whether an entry is listed: of the upper triangle, and not a zero beside the diagonal.
fn is_entry(matrix: &SpatialMatrix, indices: Indices) -> bool {
    let [row, column] = indices;
    row == column || (row < column && entry(matrix, indices) != Some(0.0))
}

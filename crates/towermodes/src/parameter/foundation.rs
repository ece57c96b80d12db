//! The input values of the foundation.

use super::part::{Indices, Key, Part, fields};
use super::table::Table;
use crate::inputs::{Inputs, Nature, every_input};
use crate::space::SpatialMatrix;
use crate::tower::{
    Buoyancy, FloatingPlatform, FormKind, Foundation, FoundationSprings, Place,
    StiffnessFoundation, TowerDescription,
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
foundation_of!(stiffness, stiffness_mut, Stiffness, StiffnessFoundation);

fn floating(description: &TowerDescription) -> Option<&FloatingPlatform> {
    description.foundation.floating()
}

fn floating_mut(description: &mut TowerDescription) -> Option<&mut FloatingPlatform> {
    description.foundation.floating_mut()
}

/// `[foundation]` of type `springs`.
pub(super) static SPRINGS: Table = Table {
    name: "foundation",
    noun: "foundation of type \"springs\"",
    kind: "",
    get: |d, i, _| Some(springs(d).filter(|_| i[0] == 0)?),
    get_mut: |d, _, _| Some(springs_mut(d)?),
    every: |_| every_input(&FoundationSprings::blank()),
    place: |_, key| Place::Foundation { key },
    absent: |_| None,
};

/// The foundations by closed form, each of which is a table.
pub(super) fn closed_forms() -> Vec<Table> {
    let blanks = Foundation::blank_forms();
    let kinds = blanks.iter().filter_map(|blank| Some(blank.form()?.kind()));
    let table = |kind: &'static FormKind| Table {
        name: "foundation",
        noun: format!("foundation of type \"{}\"", kind.name).leak(),
        kind: kind.name,
        get: |d, i, kind| {
            let form = d
                .foundation
                .form()
                .filter(|form| form.kind().name == kind)?;
            (i[0] == 0).then_some(form)
        },
        get_mut: |d, _, kind| {
            let form = d.foundation.form_mut()?;
            (form.kind().name == kind).then_some(form)
        },
        every: |kind| {
            let blanks = Foundation::blank_forms();
            let mut forms = blanks.iter().filter_map(Foundation::form);
            let form = forms.find(|form| form.kind().name == kind);
            form.map_or_else(Vec::new, |form| every_input(form))
        },
        place: |_, key| Place::Foundation { key },
        absent: |_| None,
    };
    kinds.map(table).collect()
}

/// `[foundation]` of type `floating`.
pub(super) static FLOATING: Part = Part {
    name: "foundation",
    noun: "floating platform",
    count: |d| usize::from(floating(d).is_some()),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: fields! {
        get |d, _i| floating(d)?;
        set |d, _i| floating_mut(d)?;
        place |_i, key| Place::Foundation { key };
        "mass" Amount "kg" "mass with ballast", "mass" mass_kg;
        "center[0]" Signed "m" "centre of mass from the tower axis, downwind", "center" center_m[0];
        "center[1]" Signed "m" "centre of mass from the tower axis, side-side", "center" center_m[1];
        "center[2]" Signed "m" "height of the centre of mass", "center" center_m[2];
        "inertia.xx" Amount "kg m2" "inertia about the fore-aft axis", "inertia" inertia_kg_m2.xx;
        "inertia.yy" Amount "kg m2" "inertia about the side-side axis", "inertia" inertia_kg_m2.yy;
        "inertia.zz" Amount "kg m2" "inertia about the tower axis", "inertia" inertia_kg_m2.zz;
        "inertia.xy" Signed "kg m2" "entry xy of the inertia tensor", "inertia" inertia_kg_m2.xy;
        "inertia.xz" Signed "kg m2" "entry xz of the inertia tensor", "inertia" inertia_kg_m2.xz;
        "inertia.yz" Signed "kg m2" "entry yz of the inertia tensor", "inertia" inertia_kg_m2.yz;
        "added_mass_height" Signed "m" "height of the reference point of added_mass", "added_mass" added_mass.height_m;
        "hydrostatic_height" Signed "m" "height of the reference point of hydrostatic", "hydrostatic" hydrostatic.height_m;
        "mooring_height" Signed "m" "height of the reference point of mooring", "mooring" mooring.height_m;
    },
};

fn buoyancy(description: &TowerDescription) -> Option<&Buoyancy> {
    floating(description)?.buoyancy.as_ref()
}

fn buoyancy_mut(description: &mut TowerDescription) -> Option<&mut Buoyancy> {
    floating_mut(description)?.buoyancy.as_mut()
}

/// The buoyancy of a floating platform, if it is given.
pub(super) static BUOYANCY: Part = Part {
    name: "foundation",
    noun: "buoyancy of a floating platform",
    count: |d| usize::from(buoyancy(d).is_some()),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: fields! {
        get |d, _i| buoyancy(d)?;
        set |d, _i| buoyancy_mut(d)?;
        place |_i, key| Place::Foundation { key };
        "buoyancy" Amount "N" "buoyancy at the reference position", "buoyancy" force_n;
        "buoyancy_center[0]" Signed "m" "centre of buoyancy from the tower axis, downwind", "buoyancy_center" center_m[0];
        "buoyancy_center[1]" Signed "m" "centre of buoyancy from the tower axis, side-side", "buoyancy_center" center_m[1];
    },
};

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
            nature: Nature::Amount,
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
    /// `mass` of `[foundation]` of type `stiffness`.
    STIFFNESS_MASS = "mass" "kg, kg m, kg m2" "mass at the base" of "foundation of type \"stiffness\"", stiffness stiffness_mut, inertia;
    /// `added_mass` of a floating platform.
    FLOATING_ADDED_MASS = "added_mass" "kg, kg m, kg m2" "added mass" of "floating platform", floating floating_mut, added_mass.matrix;
    /// `hydrostatic` of a floating platform.
    FLOATING_HYDROSTATIC = "hydrostatic" "N/m, N, N m" "hydrostatic stiffness" of "floating platform", floating floating_mut, hydrostatic.matrix;
    /// `mooring` of a floating platform.
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

/// Whether an entry is listed: entries of the upper triangle, without zeros outside the diagonal.
fn is_entry(matrix: &SpatialMatrix, indices: Indices) -> bool {
    let [row, column] = indices;
    row == column || (row < column && entry(matrix, indices) != Some(0.0))
}

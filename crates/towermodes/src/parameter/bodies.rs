//! The numbers of the bodies on the tower, and of the rotor.

use super::part::{Part, fields};
use crate::tower::Place;

/// `[rna]`.
pub(super) static RNA: Part = Part {
    name: "rna",
    noun: "rotor-nacelle assembly",
    count: |_| 1,
    rows: |_, _| 1,
    is_symmetric: false,
    keys: fields! {
        get |d, _i| &d.rna;
        set |d, _i| d.rna;
        place |_i, key| Place::Rna { key };
        "mass" "kg" "mass", "mass" mass_kg;
        "center[0]" "m" "centre of mass from the tower top, downwind", "center" center_m[0];
        "center[1]" "m" "centre of mass from the tower top, side-side", "center" center_m[1];
        "center[2]" "m" "centre of mass from the tower top, up", "center" center_m[2];
        "inertia.xx" "kg m2" "inertia about the fore-aft axis", "inertia" inertia_kg_m2.xx;
        "inertia.yy" "kg m2" "inertia about the side-side axis", "inertia" inertia_kg_m2.yy;
        "inertia.zz" "kg m2" "inertia about the tower axis", "inertia" inertia_kg_m2.zz;
        "inertia.xy" "kg m2" "entry xy of the inertia", "inertia" inertia_kg_m2.xy;
        "inertia.xz" "kg m2" "entry xz of the inertia", "inertia" inertia_kg_m2.xz;
        "inertia.yz" "kg m2" "entry yz of the inertia", "inertia" inertia_kg_m2.yz;
    },
};

/// `[rotor]`.
pub(super) static ROTOR: Part = Part {
    name: "rotor",
    noun: "rotor",
    count: |d| usize::from(d.rotor.is_some()),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: fields! {
        get |d, _i| d.rotor.as_ref()?;
        set |d, _i| d.rotor.as_mut()?;
        place |_i, key| Place::Rotor { key };
        "rpm[0]" "rpm" "lowest operating speed", "rpm" lowest_rpm;
        "rpm[1]" "rpm" "highest operating speed", "rpm" highest_rpm;
    },
};

/// `[[point_mass]]`.
pub(super) static POINT_MASSES: Part = Part {
    name: "point_mass[]",
    noun: "point masses",
    count: |d| d.point_masses.len(),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: fields! {
        get |d, i| d.point_masses.get(i[0])?;
        set |d, i| d.point_masses.get_mut(i[0])?;
        place |i, key| Place::PointMass { index: i[0], key };
        "height" "m" "height", "height" height_m;
        "mass" "kg" "mass", "mass" mass_kg;
        "inertia.xx" "kg m2" "inertia about the fore-aft axis", "inertia" inertia_kg_m2.xx;
        "inertia.yy" "kg m2" "inertia about the side-side axis", "inertia" inertia_kg_m2.yy;
        "inertia.zz" "kg m2" "inertia about the tower axis", "inertia" inertia_kg_m2.zz;
        "inertia.xy" "kg m2" "entry xy of the inertia", "inertia" inertia_kg_m2.xy;
        "inertia.xz" "kg m2" "entry xz of the inertia", "inertia" inertia_kg_m2.xz;
        "inertia.yz" "kg m2" "entry yz of the inertia", "inertia" inertia_kg_m2.yz;
    },
};

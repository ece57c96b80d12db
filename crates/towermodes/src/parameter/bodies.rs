//! The input values of the bodies on the tower, and of the rotor.

use super::part::{Part, fields};
use super::table::Table;
use crate::inputs::{Inputs, every_input};
use crate::tower::{Place, PointMass, Rna};

/// `[rna]`.
pub(super) static RNA: Table = Table {
    name: "rna",
    noun: "rotor-nacelle assembly",
    kind: "",
    get: |d, i, _| (i[0] == 0).then_some(&d.rna as &dyn Inputs),
    get_mut: |d, _, _| Some(&mut d.rna),
    every: |_| every_input(&Rna::blank()),
    place: |_, key| Place::Rna { key },
    absent: |_| None,
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
        "rpm[0]" Amount "rpm" "lowest operating speed", "rpm" lowest_rpm;
        "rpm[1]" Amount "rpm" "highest operating speed", "rpm" highest_rpm;
    },
};

/// `[[point_mass]]`.
pub(super) static POINT_MASSES: Table = Table {
    name: "point_mass[]",
    noun: "point masses",
    kind: "",
    get: |d, i, _| Some(d.point_masses.get(i[0])?),
    get_mut: |d, i, _| Some(d.point_masses.get_mut(i[0])?),
    every: |_| every_input(&PointMass::blank()),
    place: |i, key| Place::PointMass { index: i[0], key },
    absent: |_| None,
};

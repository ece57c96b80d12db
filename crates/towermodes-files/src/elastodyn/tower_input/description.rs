//! The tower that a tower file of ElastoDyn describes, once its heights are known.
//!
//! Towers of floating turbines in a current (MHK) hang: their top is the lower end. In the library
//! the top is the higher end, so a hanging tower is solved upside down, with depths as heights.
//! Without self-weight its frequencies are the same.

use std::ops::Range;

use towermodes::{
    Inertia, Place, Planes, PointMass, Properties, PropertyStation, RigidBody, TowerDescription,
};

use super::tower_file::{ConcentratedMass, TowerFile, TowerRow};
use super::tower_reader::TowerSpans;
use crate::note::Note;
use crate::places::{Places, TABLE};

/// The note that ElastoDyn's towers have only bending flexibility.
pub(crate) const ONLY_BENDS: &str = "towers of ElastoDyn are rigid in torsion and axially and have no rotary inertia: there are only bending modes";

/// The heights of both ends of the flexible tower, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ends {
    pub(crate) base_m: f64,
    pub(crate) top_m: f64,
}

/// Whether a tower hangs, which is possible only below the sea surface.
pub(crate) fn hangs(base_m: f64, top_m: f64) -> bool {
    top_m < 0.0 && top_m < base_m
}

impl Ends {
    /// The ends of a tower between these heights; for a hanging tower, their depths.
    pub(crate) fn of(base_m: f64, top_m: f64) -> Self {
        if hangs(base_m, top_m) {
            return Self {
                base_m: 0.0 - base_m,
                top_m: 0.0 - top_m,
            };
        }
        Self { base_m, top_m }
    }

    /// A body on the axis of the tower; its z is the distance from the base along the axis, which
    /// is negative for a hanging tower.
    pub(crate) fn point_mass(&self, body: &RigidBody) -> PointMass {
        let [_, _, z] = body.center_m;
        PointMass {
            height_m: (self.base_m + z.abs()).min(self.top_m),
            mass_kg: body.mass_kg,
            ..PointMass::default()
        }
    }

    fn height_m(&self, fraction: f64) -> f64 {
        if fraction == 1.0 {
            return self.top_m;
        }
        self.base_m + fraction * (self.top_m - self.base_m)
    }
}

/// A body mirrored in the plane z = 0.
pub(crate) fn upside_down(body: &RigidBody) -> RigidBody {
    let [x, y, z] = body.center_m;
    let own = body.inertia_kg_m2;
    RigidBody {
        mass_kg: body.mass_kg,
        center_m: [x, y, 0.0 - z],
        inertia_kg_m2: Inertia {
            xz: 0.0 - own.xz,
            yz: 0.0 - own.yz,
            ..own
        },
    }
}

/// The note that a hanging tower is solved upside down.
pub(crate) fn hanging_note(ends: Ends) -> Note {
    Note::approximation(format!(
        "the tower hangs from z = {} m down to {} m: it is solved upside down, heights in the results are depths, and self-weight and buoyancy, which act against each other, are left out",
        0.0 - ends.base_m,
        0.0 - ends.top_m
    ))
}

/// The tower, clamped, without RNA.
pub(crate) fn description(file: &TowerFile, ends: Ends, title: &str) -> TowerDescription {
    let mass = |mass: &ConcentratedMass| PointMass {
        height_m: ends.height_m(mass.height_fraction),
        mass_kg: mass.mass_kg,
        ..PointMass::default()
    };
    TowerDescription {
        name: title.trim().chars().take(200).collect(),
        properties: file
            .rows_to_the_top()
            .map(|row| station(file, &row, ends))
            .collect(),
        point_masses: file.concentrated_masses.iter().map(mass).collect(),
        ..TowerDescription::default()
    }
}

/// The note that the tuners of the modal stiffnesses are not used, if there are any.
pub(crate) fn tuner_note(file: &TowerFile) -> Option<Note> {
    let tuners = [file.fore_aft_tuners, file.side_side_tuners];
    let is_tuned = tuners.iter().flatten().any(|tuner| *tuner != 1.0);
    is_tuned.then(|| {
        Note::left_out("the stiffness tuners FAStTunr and SSStTunr multiply modal stiffnesses inside ElastoDyn: they are ignored here")
    })
}

fn station(file: &TowerFile, row: &TowerRow, ends: Ends) -> PropertyStation {
    PropertyStation {
        height_m: ends.height_m(row.height_fraction),
        properties: Properties {
            mass_kg_per_m: file.mass_factor * row.mass_kg_per_m,
            rotary_inertia_kg_m: Planes::both(0.0),
            polar_inertia_kg_m: 0.0,
            bending_n_m2: Planes {
                fore_aft: file.fore_aft_factor * row.fore_aft_n_m2,
                side_side: file.side_side_factor * row.side_side_n_m2,
            },
            torsion_n_m2: f64::INFINITY,
            axial_n: f64::INFINITY,
            shear_n: None,
        },
    }
}

/// The names of a row's values in the checks of the tower.
const STATION_KEYS: [&str; 4] = [
    "height",
    "mass_kg_per_m",
    "ei_fore_aft_n_m2",
    "ei_side_side_n_m2",
];

/// Stores the places of the values of the tower file, which is one of the tower's files.
pub(crate) fn remember(places: &mut Places, file: usize, spans: &TowerSpans) {
    places.remember(Place::Stations, file, spans.count.clone());
    let mut at = |place, span: &Range<usize>| places.remember(place, file, span.clone());
    // The second end of a uniform tower has the only row's place.
    let is_uniform = spans.rows.len() == 1;
    let end = spans.rows.iter().filter(|_| is_uniform);
    for (index, row) in spans.rows.iter().chain(end).enumerate() {
        let station = |key| Place::Station { index, key };
        for (key, span) in STATION_KEYS.into_iter().zip(row) {
            at(station(key), span);
        }
        at(station(TABLE), &(row[0].start..row[3].end));
    }
    for (index, [height, mass]) in spans.masses.iter().enumerate() {
        for (key, span) in [("height", height), ("mass", mass), ("inertia", mass)] {
            at(Place::PointMass { index, key }, span);
        }
    }
}

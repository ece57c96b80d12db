//! The tower that a tower file of ElastoDyn describes, once its heights are known.

use std::ops::Range;

use towermodes::{Place, Planes, PointMass, Properties, PropertyStation, TowerDescription};

use super::tower_file::{ConcentratedMass, TowerFile, TowerRow};
use super::tower_reader::TowerSpans;
use crate::input::Note;
use crate::places::{Places, TABLE};

/// That ElastoDyn's towers only bend.
pub(super) const ONLY_BENDS: &str = "towers of ElastoDyn neither twist nor stretch, and have no rotary inertia: there are bending modes only";

/// Where the flexible tower begins and ends, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ends {
    pub(super) base_m: f64,
    pub(super) top_m: f64,
}

/// Whether a tower hangs: only one below the sea does.
pub(super) fn hangs(base_m: f64, top_m: f64) -> bool {
    top_m < 0.0 && top_m < base_m
}

impl Ends {
    /// The ends of a tower between these heights; of one that hangs their depths.
    pub(super) fn of(base_m: f64, top_m: f64) -> Self {
        if hangs(base_m, top_m) {
            return Self {
                base_m: 0.0 - base_m,
                top_m: 0.0 - top_m,
            };
        }
        Self { base_m, top_m }
    }

    fn height_m(&self, fraction: f64) -> f64 {
        if fraction == 1.0 {
            return self.top_m;
        }
        self.base_m + fraction * (self.top_m - self.base_m)
    }
}

/// The tower, clamped, with nothing on top.
pub(super) fn description(file: &TowerFile, ends: Ends, title: &str) -> TowerDescription {
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

/// That the tuners of the modal stiffnesses are ElastoDyn's own, if there are any.
pub(super) fn tuner_note(file: &TowerFile) -> Option<Note> {
    let tuners = [file.fore_aft_tuners, file.side_side_tuners];
    let is_tuned = tuners.iter().flatten().any(|tuner| *tuner != 1.0);
    is_tuned.then(|| {
        Note::new("FAStTunr and SSStTunr multiply modal stiffnesses of ElastoDyn and are in none of these frequencies: they change no tower")
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

/// Remembers where the values of the tower file stand, which is one of the tower's files.
pub(super) fn remember(places: &mut Places, file: usize, spans: &TowerSpans) {
    places.remember(Place::Stations, file, spans.count.clone());
    let mut at = |place, span: &Range<usize>| places.remember(place, file, span.clone());
    // The second end of a uniform tower has the only row's place.
    let is_uniform = spans.rows.len() == 1;
    let end = spans.rows.iter().filter(|_| is_uniform);
    for (index, row) in spans.rows.iter().chain(end).enumerate() {
        let keys = [
            "height",
            "mass_kg_per_m",
            "ei_fore_aft_n_m2",
            "ei_side_side_n_m2",
        ];
        for (key, span) in keys.into_iter().zip(row) {
            at(Place::Station { index, key }, span);
        }
        at(
            Place::Station { index, key: TABLE },
            &(row[0].start..row[3].end),
        );
    }
    for (index, [height, mass]) in spans.masses.iter().enumerate() {
        at(
            Place::PointMass {
                index,
                key: "height",
            },
            height,
        );
        at(Place::PointMass { index, key: "mass" }, mass);
        at(
            Place::PointMass {
                index,
                key: "inertia",
            },
            mass,
        );
    }
}

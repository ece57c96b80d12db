//! Checks of the rows of a property table: wave speeds and radii of gyration imply material and
//! shape, row by row and plane by plane.

use std::f64::consts::PI;

use super::out_of_line::{Spike, worst};
use super::usual::{Usual, check_worst};
use crate::tower::Warning;
use crate::tower::{Place, Plane, Properties, PropertyStation, Tower};
use crate::tower::{Quantity, Site};

/// Speed of sound in steel, m/s.
const SOUND_M_PER_S: f64 = 5000.0;
/// Largest mean density of a section, kg/m³: steel with everything that is attached to it.
const DENSEST_KG_PER_M3: f64 = 1e4;
/// Largest radius of gyration √(EI/EA) of a section, m, and as a fraction of the tower's height.
const WIDEST_M: f64 = 20.0;
const WIDEST_SHARE: f64 = 0.25;
/// EI of one plane is at most this many times EI of the other.
const PLANES_APART: f64 = 5.0;

/// The speed of an elastic wave, √(stiffness per length/mass or inertia per length), with its usual
/// ranges: for a single row, which may contain a distributed additional mass, and for at least half
/// of the rows, which should not.
struct Speed {
    key: &'static str,
    quantity: Quantity,
    of_row: [f64; 2],
    typical: [f64; 2],
    value: fn(&Properties) -> f64,
}

const SPEEDS: [Speed; 3] = [
    Speed {
        key: "ea_n",
        quantity: Quantity::AxialWaveSpeed,
        of_row: [500.0, 8000.0],
        typical: [2000.0, 8000.0],
        value: |p| (p.axial_n / p.mass_kg_per_m).sqrt(),
    },
    Speed {
        key: "gj_n_m2",
        quantity: Quantity::TorsionWaveSpeed,
        of_row: [300.0, 6000.0],
        typical: [1000.0, 6000.0],
        value: |p| (p.torsion_n_m2 / p.polar_inertia_kg_m).sqrt(),
    },
    Speed {
        key: "shear_stiffness_fore_aft_n",
        quantity: Quantity::ShearWaveSpeed,
        // A tower with little shear deformation may have any larger stiffness.
        of_row: [100.0, f64::INFINITY],
        typical: [300.0, f64::INFINITY],
        value: |p| {
            let softer = p.shear_n.map(|shear| shear.fore_aft.min(shear.side_side));
            (softer.unwrap_or(f64::INFINITY) / p.mass_kg_per_m).sqrt()
        },
    },
];

const PERPENDICULAR: Usual = Usual::new(Quantity::PerpendicularAxes, 0.95, 1.05);
const PLANES: Usual = Usual::new(Quantity::PlaneRatio, 1.0 / PLANES_APART, PLANES_APART);

pub(super) fn check(tower: &Tower, warnings: &mut Vec<Warning>) {
    let rows = tower.properties();
    if rows.is_empty() {
        return;
    }
    for speed in &SPEEDS {
        check_speed(speed, rows, warnings);
    }
    let radii = rows.iter().enumerate();
    check_worst(
        radii.flat_map(|(index, row)| radii_of(index, row, tower.height_m())),
        warnings,
    );
    let is_out_of_line = out_of_line(rows, warnings);
    if !is_out_of_line {
        let ratios = rows.iter().enumerate().map(|(index, row)| {
            let bending = row.properties.bending_n_m2;
            let site = at(index, row, "ei_side_side_n_m2");
            (PLANES, bending.side_side / bending.fore_aft, site)
        });
        check_worst(ratios, warnings);
    }
    let sums = rows.iter().enumerate().map(|(index, row)| {
        let (rotary, polar) = (
            row.properties.rotary_inertia_kg_m,
            row.properties.polar_inertia_kg_m,
        );
        let site = at(index, row, "polar_inertia_kg_m");
        (
            PERPENDICULAR,
            (rotary.fore_aft + rotary.side_side) / polar,
            site,
        )
    });
    // A tower without rotary inertia is a valid model.
    check_worst(
        sums.filter(|(_, sum, _)| *sum > 0.0 && sum.is_finite()),
        warnings,
    );
}

fn at(index: usize, row: &PropertyStation, key: &'static str) -> Site {
    Site::at(Place::Station { index, key }).high(row.height_m)
}

fn check_speed(speed: &Speed, rows: &[PropertyStation], warnings: &mut Vec<Warning>) {
    let value = |row: &PropertyStation| (speed.value)(&row.properties);
    // A tower without torsion, axial or shear deformation has no such wave.
    let mut speeds: Vec<f64> = rows.iter().map(value).filter(|v| v.is_finite()).collect();
    speeds.sort_by(f64::total_cmp);
    let Some(&median) = speeds.get(speeds.len() / 2) else {
        return;
    };
    let is_typical = (speed.typical[0]..=speed.typical[1]).contains(&median);
    let [least, most] = if is_typical {
        speed.of_row
    } else {
        speed.typical
    };
    let usual = Usual::new(speed.quantity, least, most);
    let values = rows.iter().enumerate().map(|(index, row)| {
        let site = at(index, row, speed.key);
        (usual, value(row), site)
    });
    check_worst(values.filter(|(_, value, _)| value.is_finite()), warnings);
}

/// The radius of gyration of a section in each plane, with its possible range: the section is at
/// least as wide as a solid rod of the same mass, r² = A/(4π).
fn radii_of(
    index: usize,
    row: &PropertyStation,
    height_m: f64,
) -> impl Iterator<Item = (Usual, f64, Site)> {
    let p = row.properties;
    let solid_m = (p.mass_kg_per_m / DENSEST_KG_PER_M3 / (4.0 * PI)).sqrt();
    let most_m = WIDEST_M.min(WIDEST_SHARE * height_m).max(solid_m);
    let planes = [
        (Plane::ForeAft, "ei_fore_aft_n_m2"),
        (Plane::SideSide, "ei_side_side_n_m2"),
    ];
    let count = if p.bending_n_m2.are_equal() { 1 } else { 2 };
    planes.into_iter().take(count).map(move |(plane, key)| {
        let bending = p.bending_n_m2.of(plane);
        let (quantity, radius_m) = if p.axial_n.is_finite() {
            (Quantity::RadiusOfSection, (bending / p.axial_n).sqrt())
        } else {
            let by_mass = (bending / p.mass_kg_per_m).sqrt() / SOUND_M_PER_S;
            (Quantity::RadiusOfSectionByMass, by_mass)
        };
        let site = Site::at(Place::Station { index, key }).high(row.height_m);
        let site = if count == 1 {
            site
        } else {
            site.in_plane(plane)
        };
        (Usual::new(quantity, solid_m, most_m), radius_m, site)
    })
}

/// Values of single rows that do not fit the adjacent rows; returns whether there are any.
fn out_of_line(rows: &[PropertyStation], warnings: &mut Vec<Warning>) -> bool {
    type Column = fn(&Properties) -> f64;
    let columns: [(&'static str, &'static str, Spike, Column); 5] = [
        (
            "mass_kg_per_m",
            "the mass per length",
            Spike::PowerOfTen,
            |p| p.mass_kg_per_m,
        ),
        ("ei_fore_aft_n_m2", "EI fore-aft", Spike::Any, |p| {
            p.bending_n_m2.fore_aft
        }),
        ("ei_side_side_n_m2", "EI side-side", Spike::Any, |p| {
            p.bending_n_m2.side_side
        }),
        ("gj_n_m2", "GJ", Spike::Any, |p| p.torsion_n_m2),
        ("ea_n", "EA", Spike::Any, |p| p.axial_n),
    ];
    let heights_m: Vec<f64> = rows.iter().map(|row| row.height_m).collect();
    let before = warnings.len();
    let mut fore_aft = Vec::new();
    for (key, column, spike, value) in columns {
        let values: Vec<f64> = rows.iter().map(|row| value(&row.properties)).collect();
        if key == "ei_side_side_n_m2" && values == fore_aft {
            continue;
        }
        if values[0].is_finite() {
            warnings.extend(warning(&heights_m, &values, spike, key, column));
        }
        if key == "ei_fore_aft_n_m2" {
            fore_aft = values;
        }
    }
    warnings.len() > before
}

fn warning(
    heights_m: &[f64],
    values: &[f64],
    spike: Spike,
    key: &'static str,
    column: &'static str,
) -> Option<Warning> {
    let (index, expected) = worst(heights_m, values, spike)?;
    let unit = match key {
        "mass_kg_per_m" => " kg/m",
        "ea_n" => " N",
        _ => " N m2",
    };
    Some(Warning::RowOutOfLine {
        site: Site::at(Place::Station { index, key }).high(heights_m[index]),
        column,
        unit,
        value: values[index],
        expected,
    })
}

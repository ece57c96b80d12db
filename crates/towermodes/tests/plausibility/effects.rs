//! What a user gave and what changes nothing.

use super::towers::{reference, rich};
use super::{of, one, quiet};
use towermodes::{
    Foundation, FoundationSprings, Ineffective, Inertia, Material, PointMass, Rna, SoilRow,
    Station, TowerDescription, Warning, Water,
};
use towermodes_testing::{Says, assert_matches, changed, parts, with};

#[track_caller]
fn without_effect(
    what: Ineffective,
    description: TowerDescription,
    change: impl FnOnce(&mut TowerDescription),
) {
    let (warning, said) = one(description, change);
    assert_matches!(warning, Warning::NoEffect { what: got, .. } if *got == what);
    let holds = said.contains("no effect") || what == Ineffective::UprightWires;
    assert!(holds, "{said}");
}

fn mass(height_m: f64) -> impl FnOnce(&mut TowerDescription) {
    move |t| {
        t.point_masses = vec![with!(PointMass, height_m, mass_kg = 5e3)];
    }
}

#[test]
fn masses_at_a_clamped_base() {
    let heavy = |height_m: f64| {
        move |t: &mut TowerDescription| {
            mass(height_m)(t);
            t.point_masses[0].mass_kg = 50e3;
        }
    };
    without_effect(Ineffective::MassAtClampedBase, reference(), heavy(0.0));
    quiet(reference(), heavy(0.1));
    // The base flange in a list of masses.
    quiet(reference(), mass(0.0));
    // On springs the base moves.
    quiet(reference(), |t| {
        mass(0.0)(t);
        t.foundation = Foundation::Springs(changed!(FoundationSprings::RIGID, rocking_n_m = 1e11));
        t.point_masses[0].inertia_kg_m2 = with!(Inertia, xx = 1e4, yy = 1e4, zz = 1e4);
    });
}

#[test]
fn masses_of_nothing() {
    without_effect(Ineffective::EmptyPointMass, reference(), |t| {
        mass(40.0)(t);
        t.point_masses[0].mass_kg = 0.0;
    });
    without_effect(Ineffective::CentreOfNothing, reference(), |t| {
        t.rna = with!(Rna, center_m = [-0.4, 0.0, 2.0]);
    });
}

fn wires(height_m: f64, angle_deg: f64) -> impl FnOnce(&mut TowerDescription) {
    move |t| {
        t.wires = vec![parts::wires(height_m, 4, 1e6, angle_deg)];
    }
}

#[test]
fn wires_at_a_clamped_base_and_upright_wires() {
    let what = Ineffective::WiresAtClampedBase;
    without_effect(what, reference(), wires(0.0, 45.0));
    quiet(reference(), wires(40.0, 45.0));
    without_effect(Ineffective::UprightWires, reference(), wires(40.0, 85.1));
    quiet(reference(), wires(40.0, 84.9));
}

#[test]
fn materials_that_nothing_is_made_of() {
    let more = |t: &mut TowerDescription| {
        t.materials
            .push(Material::from_poissons_ratio(1.0, 1.0, 0.3));
    };
    without_effect(Ineffective::UnusedMaterial, reference(), more);
    quiet(rich(), |_| {});
    // That of the last row alone has its own words, and only those.
    let of_last = of(reference(), |t| {
        more(t);
        t.stations[1].material = 1;
    });
    assert!(matches!(of_last[..], [Warning::UselessMaterial { .. }]));
}

#[test]
fn soil_and_added_mass_of_zeros() {
    let soil = |x_n_per_m2: f64| {
        move |t: &mut TowerDescription| {
            t.stations[0] = Station::new(-10.0, 6.0, 0.06);
            let row = |height_m| {
                let mut row = with!(SoilRow, height_m);
                (row.stiffness.x_n_per_m2, row.stiffness.y_n_per_m2) = (x_n_per_m2, x_n_per_m2);
                row
            };
            t.soil = vec![vec![row(-10.0), row(-1.0)]];
            t.foundation = Foundation::Springs(FoundationSprings {
                rocking_n_m: 1e11,
                ..FoundationSprings::RIGID
            });
        }
    };
    without_effect(Ineffective::SoilOfZeros, reference(), soil(0.0));
    quiet(reference(), soil(1e7));
    let added = |mass_kg_per_m: f64| {
        move |t: &mut TowerDescription| {
            let row = |height_m| parts::added_mass_row(height_m, mass_kg_per_m);
            t.added_mass = vec![vec![row(0.0), row(10.0)]];
        }
    };
    without_effect(Ineffective::AddedMassOfZeros, reference(), added(0.0));
    quiet(reference(), added(1.0));
}

fn water(
    level_m: f64,
    added_mass_coefficient: f64,
    flooded: bool,
) -> impl FnOnce(&mut TowerDescription) {
    move |t| {
        t.water = Some(Water {
            level_m,
            bed_m: None,
            density_kg_per_m3: 1025.0,
            added_mass_coefficient,
            flooded,
        });
    }
}

#[test]
fn water_of_zeros_and_towers_under_water() {
    let what = Ineffective::WaterOfZeros;
    without_effect(what, reference(), water(20.0, 0.0, false));
    quiet(reference(), water(20.0, 0.0, true));
    quiet(reference(), water(87.6, 1.0, false));
    for level_m in [87.7, 20000.0] {
        let (warning, said) = one(reference(), water(level_m, 1.0, false));
        assert!(matches!(warning, Warning::UnderWater { .. }), "{said}");
        said.says("is above the tower top at 87.6 m");
    }
}

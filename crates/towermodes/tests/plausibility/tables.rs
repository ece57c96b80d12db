//! Tables of properties: waves, radii of gyration, planes and single rows.

use super::towers::{elliptic, reference_table};
use super::{of, quiet};
use towermodes::Quantity::{
    AxialWaveSpeed, PerpendicularAxes, PlaneRatio, RadiusOfSection, RadiusOfSectionByMass,
    ShearWaveSpeed, TorsionWaveSpeed,
};
use towermodes::{Place, Plane, Planes, Properties, Quantity, TowerDescription, Warning};
use towermodes_testing::Says;

/// Every row changed.
fn all(change: impl Fn(&mut Properties)) -> impl FnOnce(&mut TowerDescription) {
    move |t| {
        for row in &mut t.properties {
            change(&mut row.properties);
        }
    }
}

/// The reference tower as a table.
fn table() -> TowerDescription {
    reference_table(1.0, 0.0)
}

/// The rows of the reference tower as ElastoDyn has them: mass and EI alone.
fn bending_alone() -> TowerDescription {
    let mut tower = table();
    all(|p| {
        (p.torsion_n_m2, p.axial_n) = (f64::INFINITY, f64::INFINITY);
        (p.polar_inertia_kg_m, p.rotary_inertia_kg_m) = (0.0, Planes::both(0.0));
    })(&mut tower);
    tower
}

#[track_caller]
fn has(
    quantity: Quantity,
    tower: TowerDescription,
    change: impl FnOnce(&mut TowerDescription),
) -> (Place, Option<Plane>) {
    let warnings = of(tower, change);
    let found = warnings.iter().find_map(|w| match w {
        Warning::Unusual {
            quantity: got,
            site,
            ..
        } if *got == quantity => Some((site.place?, site.plane)),
        _ => None,
    });
    found.unwrap_or_else(|| panic!("{warnings:#?}"))
}

#[test]
fn speeds_of_sound_in_half_of_the_rows() {
    // The tower has sqrt(2.1e11/8500) = 4970 m/s.
    let speed = |m_per_s: f64| {
        all(move |p| {
            p.axial_n = p.mass_kg_per_m * m_per_s * m_per_s;
            p.bending_n_m2 = Planes::both(p.axial_n * 4.0);
        })
    };
    quiet(table(), speed(2010.0));
    has(AxialWaveSpeed, table(), speed(1990.0));
    quiet(table(), speed(7990.0));
    has(AxialWaveSpeed, table(), speed(8010.0));
}

#[test]
fn a_row_may_carry_a_mass_that_is_spread_over_it() {
    let heavier = |factor: f64| {
        move |t: &mut TowerDescription| {
            let p = &mut t.properties[4].properties;
            p.mass_kg_per_m *= factor;
            p.polar_inertia_kg_m *= factor;
            p.rotary_inertia_kg_m = p.rotary_inertia_kg_m.map(|x| factor * x);
        }
    };
    // 4970/sqrt(98) = 502 m/s.
    quiet(table(), heavier(40.0));
    quiet(table(), heavier(60.0));
    has(AxialWaveSpeed, table(), heavier(102.0));
}

#[test]
fn waves_of_torsion_and_shear() {
    let torsion =
        |m_per_s: f64| all(move |p| p.torsion_n_m2 = p.polar_inertia_kg_m * m_per_s * m_per_s);
    quiet(table(), torsion(1010.0));
    has(TorsionWaveSpeed, table(), torsion(990.0));
    quiet(table(), torsion(5990.0));
    has(TorsionWaveSpeed, table(), torsion(6010.0));
    let shear = |m_per_s: f64| {
        all(move |p| p.shear_n = Some(Planes::both(p.mass_kg_per_m * m_per_s * m_per_s)))
    };
    quiet(table(), shear(310.0));
    has(ShearWaveSpeed, table(), shear(290.0));
    // In kN, in one plane.
    let kilo = all(|p| {
        if let Some(shear) = &mut p.shear_n {
            shear.side_side /= 1e3;
        }
    });
    has(ShearWaveSpeed, elliptic(), kilo);
    // A tower that hardly shears.
    quiet(table(), shear(1e6));
}

#[test]
fn radii_of_gyration_in_each_plane() {
    // No section is narrower than a solid rod that is as heavy: r^2 = A/(4 pi), A = m/(10 000
    // kg/m3).
    let of_solid = |factor: f64| {
        all(move |p| {
            let solid_m = (p.mass_kg_per_m / 1e4 / (4.0 * std::f64::consts::PI)).sqrt();
            p.bending_n_m2 = Planes::both((factor * solid_m).powi(2) * p.axial_n);
        })
    };
    quiet(table(), of_solid(1.01));
    has(RadiusOfSection, table(), of_solid(0.99));
    // The upper limit is 20 m, or a quarter of 87.6 m: 20 m.
    let radius = |m: f64| all(move |p| p.bending_n_m2 = Planes::both(m * m * p.axial_n));
    quiet(table(), radius(19.9));
    has(RadiusOfSection, table(), radius(20.1));
    // EI in kN m2, also where only the mass is there to compare with.
    let kilo = || all(|p| p.bending_n_m2 = p.bending_n_m2.map(|x| x / 1e3));
    has(RadiusOfSection, table(), kilo());
    has(RadiusOfSectionByMass, bending_alone(), kilo());
    // One plane alone, and the worst of all rows.
    let change = |t: &mut TowerDescription| {
        for row in &mut t.properties {
            row.properties.bending_n_m2.side_side /= 1e3;
        }
        t.properties[6].properties.bending_n_m2.side_side /= 2.0;
    };
    let (place, plane) = has(RadiusOfSectionByMass, bending_alone(), change);
    let (index, key) = (6, "ei_side_side_n_m2");
    assert_eq!(place, Place::Station { index, key });
    assert_eq!(plane, Some(Plane::SideSide));
}

#[test]
fn planes_that_differ() {
    let ratio =
        |ratio: f64| all(move |p| p.bending_n_m2.side_side = ratio * p.bending_n_m2.fore_aft);
    for inside in [4.9, 1.0 / 4.9] {
        quiet(bending_alone(), ratio(inside));
    }
    for outside in [5.1, 1.0 / 5.1, 1e-3] {
        has(PlaneRatio, bending_alone(), ratio(outside));
    }
}

fn out_of_line(warnings: &[Warning]) -> Vec<(Place, f64)> {
    let found = warnings.iter().filter_map(|w| match w {
        Warning::RowOutOfLine {
            site,
            value,
            expected,
            ..
        } => Some((site.place?, value / expected)),
        _ => None,
    });
    found.collect()
}

#[test]
fn one_row_ten_times_off() {
    let bending = |index: usize, factor: f64| {
        of(bending_alone(), move |t| {
            t.properties[index].properties.bending_n_m2.side_side *= factor;
        })
    };
    // The row below it is 1/0.856 times as stiff: four times that one are 4.67 times itself.
    assert_eq!(out_of_line(&bending(4, 4.6)), []);
    assert_eq!(out_of_line(&bending(4, 4.75)).len(), 1);
    for index in 0..11 {
        for factor in [0.1, 10.0, 1e-10] {
            let found = out_of_line(&bending(index, factor));
            let key = "ei_side_side_n_m2";
            assert!(
                matches!(found[..], [(place, ratio)] if place == Place::Station { index, key } && (ratio / factor - 1.0).abs() < 0.1),
                "row {index}, {factor}: {found:?}"
            );
        }
    }
    let mass = |factor: f64| {
        of(bending_alone(), move |t| {
            t.properties[5].properties.mass_kg_per_m *= factor;
        })
    };
    assert_eq!(out_of_line(&mass(0.1)).len(), 1);
    // A mass spread over a row makes any other factor.
    assert_eq!(out_of_line(&mass(6.0)).len(), 0);
}

#[test]
fn the_worst_row_is_named() {
    let warnings = of(bending_alone(), |t| {
        t.properties[2].properties.bending_n_m2.fore_aft *= 5.0;
        t.properties[7].properties.bending_n_m2.fore_aft *= 30.0;
    });
    let (index, key) = (7, "ei_fore_aft_n_m2");
    assert_eq!(out_of_line(&warnings)[0].0, Place::Station { index, key });
    let said = warnings
        .iter()
        .map(ToString::to_string)
        .find(|said| said.contains("check decimal point"))
        .expect("a row");
    said.begins("station 8: EI fore-aft at z = 61.32 m is ");
    said.says(" 30.1 times the value expected from the adjacent rows");
}

#[test]
fn rotary_and_polar_inertia() {
    let sum = |factor: f64| all(move |p| p.polar_inertia_kg_m /= factor);
    quiet(table(), sum(1.04));
    has(PerpendicularAxes, table(), sum(1.06));
    quiet(table(), sum(0.96));
    has(PerpendicularAxes, table(), sum(0.94));
}

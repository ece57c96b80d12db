//! What is possible but looks like a slip is said, and what is usual is not.

use crate::towers;

use towermodes::{
    Inertia, Material, Method, Options, PointMass, Rna, Station, Tower, TowerDescription, Warning,
};
use towermodes_testing::{Says, changed, rotor, stations, with};
use towers::{elliptic, reference, reference_350t, rich, solved};

/// The warnings of the reference tower changed.
fn warned(change: impl FnOnce(&mut TowerDescription)) -> Vec<Warning> {
    let mut description = reference_350t();
    change(&mut description);
    let options = with!(Options, segments = Some(200), modes = 2);
    solved(&description, &options).warnings
}

/// The only warning, in words.
#[track_caller]
fn only(change: impl FnOnce(&mut TowerDescription)) -> String {
    let warnings = warned(change);
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    warnings[0].to_string()
}

#[test]
fn usual_towers_are_not_warned_of() {
    for description in [reference(), reference_350t(), rich()] {
        assert_eq!(solved(&description, &Options::default()).warnings, []);
    }
}

#[test]
fn diameters_over_30_m() {
    let diameter = |d: f64| {
        move |t: &mut TowerDescription| {
            t.stations[0].outer_diameter_m = d;
            t.stations[0].wall_thickness_m = d / 200.0;
            t.rna = Rna::default();
        }
    };
    assert!(warned(diameter(30.0)).is_empty());
    only(diameter(30.1)).says("30.1 m at z = 0 m is larger than 30 m");
}

#[test]
fn towers_over_1_km() {
    let height = |h: f64| {
        move |t: &mut TowerDescription| {
            t.stations[1] = Station::new(h, 20.0, 0.1);
            t.stations[0] = Station::new(0.0, 29.0, 0.2);
            t.rna = Rna::default();
        }
    };
    assert!(warned(height(1000.0)).is_empty());
    only(height(1001.0)).says("1001 m high, more than 1 km");
}

#[test]
fn walls_thinner_than_a_500th_of_the_diameter() {
    let wall =
        |ratio: f64| move |t: &mut TowerDescription| t.stations[0].wall_thickness_m = 6.0 * ratio;
    assert!(warned(wall(1.0 / 499.0)).is_empty());
    only(wall(1.0 / 510.0)).says("1/510 of the diameter 6 m");
}

#[test]
fn rotors_outside_3_to_100_rpm_on_towers_over_20_m() {
    let turning = |highest_rpm: f64| rotor(3, 0.0, highest_rpm);
    let tower = Tower::new(reference_350t()).expect("a tower");
    let said = |highest_rpm: f64| {
        let warnings = tower.rotor_warnings(&turning(highest_rpm));
        let texts = warnings.iter().map(ToString::to_string);
        texts.collect::<Vec<String>>().join("\n")
    };
    assert_eq!((said(3.0), said(100.0)), (String::new(), String::new()));
    said(101.0).says("101 rpm");
    // 1.27 rad/s is 12.1 rpm.
    said(1.27).says("1 rad/s is 9.55 rpm");
    // A solve of the tower has nothing to do with it.
    assert_eq!(warned(|t| t.rotor = Some(turning(1.27))), []);
    let small = TowerDescription {
        stations: stations(&[(0.0, 0.6, 0.008), (19.0, 0.4, 0.006)]),
        ..reference_350t()
    };
    let small = Tower::new(small).expect("a tower");
    assert_eq!(small.rotor_warnings(&turning(200.0)), []);
    // A machine of some kilowatts on a high mast.
    let of_mass = |kg: f64| {
        let description = changed!(reference_350t(), rna = Rna::point(kg));
        let tower = Tower::new(description).expect("a tower");
        tower.rotor_warnings(&turning(188.0)).len()
    };
    assert_eq!((of_mass(5e3), of_mass(5.1e3)), (0, 1));
}

#[test]
fn machines_heavier_than_five_towers() {
    // The tower has 267 586 kg.
    assert!(warned(|t| t.rna.mass_kg = 1.337e6).is_empty());
    only(|t| t.rna.mass_kg = 1.339e6).says("more than five times the mass of the tower");
}

#[test]
fn frequencies_outside_a_hundredth_to_a_hundred_hertz() {
    let short = warned(|t| {
        t.stations[1].height_m = 3.0;
        t.rna = Rna::default();
    });
    let is_fast = |w: &Warning| matches!(w, Warning::UnusualFrequency { frequency_hz } if *frequency_hz > 100.0);
    assert!(short.iter().any(is_fast), "{short:?}");
    let soft = warned(|t| t.materials[0] = Material::from_poissons_ratio(8500.0, 2e7, 0.3));
    let is_slow = |w: &Warning| matches!(w, Warning::UnusualFrequency { frequency_hz } if *frequency_hz < 0.01);
    assert!(soft.iter().any(is_slow), "{soft:?}");
}

#[test]
fn inertias_that_no_body_has() {
    let inertia = |xx: f64| {
        move |t: &mut TowerDescription| {
            t.rna.inertia_kg_m2 = with!(Inertia, xx, yy = 2e7, zz = 2e7);
        }
    };
    assert!(warned(inertia(4e7)).is_empty());
    only(inertia(4.1e7)).says("exceeds the sum of the other two");
}

#[test]
fn values_in_the_wrong_unit() {
    let light = only(|t| {
        t.materials[0].density_kg_per_m3 = 8.5;
        t.rna = Rna::default();
    });
    light.says("the density is 8.5 kg/m3; expected 300 to 25000 kg/m3");
    only(|t| t.outfitting_factor = 0.8).says("7 % more is 1.07");
    only(|t| t.rna.mass_kg = 350.0).says("the unit is kg");
    only(|t| t.rna.center_m[2] = 87.6).says("from the tower top");
    only(|t| t.materials[0].shear_modulus_pa = 1.2e11).says("Poisson's ratio");
}

#[test]
fn rows_and_materials_that_hold_for_nothing() {
    let step = |t: &mut TowerDescription| t.stations.push(Station::new(87.6, 3.0, 0.02));
    only(step).says("has no effect");
    let other = |t: &mut TowerDescription| {
        t.materials.push(t.materials[0]);
        t.stations[1].material = 1;
    };
    only(other).says("the material of the last row has no effect");
}

#[test]
fn more_segments_than_asked_for() {
    let masses = |t: &mut TowerDescription| {
        let mass = |height_m| with!(PointMass, height_m, mass_kg = 100.0);
        t.point_masses = (1..250).map(|k| mass(0.35 * f64::from(k))).collect();
    };
    only(masses).says("250 segments are used instead of 200");
}

/// The warnings of a table of properties with every row changed.
fn table_warned(change: impl Fn(&mut towermodes::Properties)) -> Vec<String> {
    let mut description = elliptic();
    for row in &mut description.properties {
        change(&mut row.properties);
    }
    let tower = towermodes::Tower::new(description).expect("a valid tower");
    tower.warnings().iter().map(ToString::to_string).collect()
}

#[test]
fn tables_in_wrong_units() {
    let check = |warnings: Vec<String>, words: &str| {
        let holds = warnings.iter().any(|w| w.contains(words));
        assert!(holds, "{words}: {warnings:?}");
    };
    assert_eq!(table_warned(|_| ()), [""; 0]);
    check(table_warned(|p| p.mass_kg_per_m /= 1000.0), "sqrt(EA/mass)");
    check(table_warned(|p| p.axial_n /= 1000.0), "sqrt(EA/mass)");
    let text = "sqrt(GJ/polar inertia)";
    check(table_warned(|p| p.torsion_n_m2 /= 1000.0), text);
    let text = "sqrt(EI/EA)";
    check(table_warned(|p| p.bending_n_m2.fore_aft *= 1e6), text);
    check(
        table_warned(|p| p.rotary_inertia_kg_m.fore_aft *= 2.0),
        "plane section",
    );
    // None at all is an Euler-Bernoulli beam, not a slip.
    let found = table_warned(|p| p.rotary_inertia_kg_m = Default::default());
    assert_eq!(found, [""; 0]);
}

#[test]
fn bmodes_says_that_it_leaves_shear_out() {
    let solve = |description, method| {
        let options = with!(Options, method);
        solved(&description, &options).warnings
    };
    let has = |warnings: Vec<Warning>| warnings.contains(&Warning::ShearLeftOut);
    assert!(has(solve(elliptic(), Method::Bmodes)));
    assert!(!has(solve(elliptic(), Method::Spectral)));
    assert!(!has(solve(reference(), Method::Bmodes)));
}

//! Machines and point masses: centres, inertias, masses.

use super::towers::{reference, reference_with_machine};
use super::{odd, of, one, quiet};
use towermodes::Quantity::{
    CentreDistance, PointMass as PointMassQuantity, RadiusOfBody, RnaShare,
};
use towermodes::{
    Blade, BladeDescription, BladeSection, Inertia, Place, PointMass, RigidBody, TowerDescription,
    Warning,
};
use towermodes_testing::{Says, assert_matches, parts, with};

const INERTIA: Place = Place::Rna { key: "inertia" };

fn scaled(factor: f64) -> impl FnOnce(&mut TowerDescription) {
    move |t| {
        let inertia = &mut t.rna.inertia_kg_m2;
        for moment in [&mut inertia.xx, &mut inertia.yy, &mut inertia.zz] {
            *moment *= factor;
        }
    }
}

#[test]
fn inertias_in_another_unit() {
    // 349.6 t: a ball of lead has a radius of gyration of 1.21 m, the machine 9.25 m in the mean
    // and 11.04 m at most; the tower is 87.6 m high, so the most is 52.56 m.
    let ball_m = 0.4_f64.sqrt() * (3.0 * 349_606.5 / (4.0 * std::f64::consts::PI * 12e3)).cbrt();
    let mean_m = ((42_620_975.3 + 24_376_664.3 + 22_652_099.0) / 3.0 / 349_606.5_f64).sqrt();
    let lightest = (ball_m / mean_m).powi(2);
    quiet(reference_with_machine(), scaled(1.01 * lightest));
    let description = reference_with_machine();
    let got = odd(RadiusOfBody, INERTIA, description, scaled(0.99 * lightest));
    assert!((got / ball_m - 0.99_f64.sqrt()).abs() < 1e-6);
    // In t m2.
    let said = one(reference_with_machine(), scaled(1e-3)).1;
    said.begins("rotor-nacelle assembly: the radius of gyration sqrt(inertia/mass) is 0.2923");
    said.says("expected 1.21 to 52.6 m; check unit and exponent");
    let heaviest = 52.56_f64.powi(2) * 349_606.5 / 42_620_975.3;
    quiet(reference_with_machine(), scaled(0.99 * heaviest));
    let description = reference_with_machine();
    odd(RadiusOfBody, INERTIA, description, scaled(1.01 * heaviest));
    // 4e10 for 4e7.
    odd(RadiusOfBody, INERTIA, reference_with_machine(), scaled(1e3));
}

#[test]
fn machines_without_inertia() {
    let without = |mass_kg: f64| {
        move |t: &mut TowerDescription| {
            t.rna.mass_kg = mass_kg;
            t.rna.inertia_kg_m2 = Inertia::default();
        }
    };
    quiet(reference_with_machine(), without(49.9e3));
    let (warning, said) = one(reference_with_machine(), without(50.1e3));
    assert!(matches!(warning, Warning::RnaWithoutInertia { mass_kg, .. } if mass_kg == 50.1e3));
    said.says("the mass is 50100 kg, but no inertia is given");
    quiet(reference_with_machine(), |t| {
        without(350e3)(t);
        t.rna_is_point = true;
    });
}

#[test]
fn centres_far_from_the_tower() {
    for axis in 0..3 {
        let centre = |m: f64| move |t: &mut TowerDescription| t.rna.center_m[axis] = m;
        quiet(reference_with_machine(), centre(-25.0));
        let place = Place::Rna { key: "center" };
        for far_m in [25.1, -25.1, 410.0, 100.0] {
            let description = reference_with_machine();
            let got = odd(CentreDistance, place, description, centre(far_m));
            assert_eq!(got, far_m.abs());
        }
    }
}

#[test]
fn machines_in_tonnes() {
    // The tower has 267 586 kg.
    let mass = |kg: f64| move |t: &mut TowerDescription| t.rna = towermodes::Rna::point(kg);
    let place = Place::Rna { key: "mass" };
    quiet(reference(), mass(2676.0));
    odd(RnaShare, place, reference(), mass(2675.0));
    odd(RnaShare, place, reference(), mass(350.0));
}

fn with_mass(mass: PointMass) -> TowerDescription {
    TowerDescription {
        point_masses: vec![PointMass::default(), mass]
            .into_iter()
            .filter(|m| *m != PointMass::default())
            .collect(),
        ..reference()
    }
}

fn platform(xx: f64, yy: f64, zz: f64) -> TowerDescription {
    with_mass(parts::point_mass(10.0, 100e3, with!(Inertia, xx, yy, zz)))
}

#[test]
fn triangle_inequality_of_point_masses() {
    // 1 % is for moments that are given to two or three digits.
    quiet(platform(1.009e6, 0.5e6, 0.5e6), |_| {});
    let (warning, said) = one(platform(1.011e6, 0.5e6, 0.5e6), |_| {});
    assert!(matches!(warning, Warning::TriangleInequality { .. }));
    said.begins("point mass 1: a principal moment of inertia (1011000 kg m2) exceeds");
}

#[test]
fn inertias_of_point_masses_in_another_unit() {
    let place = Place::PointMass {
        index: 0,
        key: "inertia",
    };
    quiet(platform(1.5e6, 1.5e6, 1.2e6), |_| {});
    odd(RadiusOfBody, place, platform(1.5e3, 1.5e3, 1.2e3), |_| {});
    odd(RadiusOfBody, place, platform(1.5e9, 1.5e9, 1.2e9), |_| {});
}

#[test]
fn point_masses_with_inertia_and_no_mass() {
    let mass = |mass_kg: f64| {
        let mut tower = platform(1e3, 1e3, 1e3);
        tower.point_masses[0].mass_kg = mass_kg;
        tower
    };
    quiet(mass(100.0), |_| {});
    let (warning, _) = one(mass(0.0), |_| {});
    assert_matches!(warning, Warning::InertiaWithoutMass { .. });
    // A mass without inertia is an ordinary point mass.
    assert_eq!(of(platform(0.0, 0.0, 0.0), |_| {}), []);
}

/// A blade of 28.5 m with a body of 40 kg at its tip.
fn blade_with_tip(mass_kg: f64, xx: f64, yy: f64, zz: f64) -> Blade {
    let section = |span: f64| BladeSection {
        span,
        mass_kg_per_m: 200.0,
        flap_n_m2: 1e8,
        edge_n_m2: 4e8,
        torsion_n_m2: f64::INFINITY,
        axial_n: f64::INFINITY,
        ..BladeSection::default()
    };
    Blade::new(BladeDescription {
        hub_radius_m: 1.5,
        tip_radius_m: 30.0,
        sections: vec![section(0.0), section(1.0)],
        borders: vec![0.0, 0.5, 1.0],
        tip: RigidBody {
            mass_kg,
            center_m: [0.0; 3],
            inertia_kg_m2: with!(Inertia, xx, yy, zz),
        },
        ..BladeDescription::default()
    })
    .expect("a blade")
}

#[test]
fn bodies_at_the_tip_of_a_blade() {
    let said = |mass_kg, xx, yy, zz| -> Vec<String> {
        let warnings = blade_with_tip(mass_kg, xx, yy, zz).warnings();
        warnings.iter().map(ToString::to_string).collect()
    };
    assert!(said(40.0, 4.2, 1.75, 2.5).is_empty());
    assert!(said(0.0, 0.0, 0.0, 0.0).is_empty());
    // That of a certification case of BModes: 10 > 1.75 + 2.5.
    said(40.0, 10.0, 1.75, 2.5)[0].begins("a principal moment of inertia (10 kg m2)");
    // 0.6 of 28.5 m are 17.1 m, and 17.1^2 of 40 kg 11 696 kg m2.
    assert!(said(40.0, 11_600.0, 11_600.0, 11_600.0).is_empty());
    assert_eq!(said(40.0, 11_800.0, 11_800.0, 11_800.0).len(), 1);
    said(0.0, 1.0, 1.0, 1.0)[0].says("an inertia is given but no mass");
}

/// A flange of 6.2 t that is given as 6.2 kg.
#[test]
fn point_masses_in_tonnes() {
    let with = |mass_kg: f64| {
        move |t: &mut TowerDescription| {
            t.point_masses = vec![PointMass {
                mass_kg,
                height_m: 40.0,
                ..PointMass::default()
            }];
        }
    };
    quiet(reference(), with(10.1));
    let place = Place::PointMass {
        index: 0,
        key: "mass",
    };
    assert_eq!(odd(PointMassQuantity, place, reference(), with(6.2)), 6.2);
}

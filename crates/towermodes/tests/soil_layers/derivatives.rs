//! Derivatives of frequencies with respect to the numbers of the ground.

use crate::towers::assert_close;

use super::{clay, first_hz, ground_of, layer, oc3};
use towermodes::{
    ApiEdition, Change, Family, LayerSoil, Method, NoDerivative, Options, Parameter, ShearModulus,
    SoilModel, Solver, TowerDescription,
};
use towermodes_testing::{Says, with};

/// Sand, clay and elastic soil, with scour of both kinds.
fn mixed() -> TowerDescription {
    let mut description = oc3(SoilModel::Kallehave);
    let ground = ground_of(&mut description);
    ground.scour.general_m = 0.5;
    ground.scour.local_m = 2.0;
    ground.layers[1] = layer([-25.0, -34.0], LayerSoil::Clay(clay()), SoilModel::Api);
    let mut last = layer([-34.0, -60.0], LayerSoil::Elastic, SoilModel::Vesic);
    last.poissons_ratio = Some(0.3);
    last.shear_modulus = Some(ShearModulus::RixStokoe {
        cone_resistance_pa: [2e7, 4e7],
    });
    ground.layers[2] = last;
    description
}

/// On the coarsest mesh of a sweep too, where the frequencies are good and the derivatives on that
/// mesh would be off by tens of percent.
#[test]
fn every_number_of_the_ground_has_the_derivative_of_solves() {
    for segments in [None, Some(20), Some(7)] {
        check_ground(segments);
    }
}

fn check_ground(segments: Option<usize>) {
    let description = mixed();
    let changes = Change::every(&description);
    let of_ground: Vec<Change> = changes
        .into_iter()
        .filter(|change| change.name().contains("ground."))
        .collect();
    let names: Vec<&str> = of_ground.iter().map(Change::name).collect();
    for name in [
        "ground.factor",
        "ground.scour.local",
        "ground.layer[0].friction_angle",
        "ground.layer[1].undrained_strength[0]",
        "ground.layer[2].cone_resistance[1]",
        "add(ground.surface,ground.layer[0].top)",
        "add(ground.layer[0].bottom,ground.layer[1].top)",
    ] {
        assert!(names.contains(&name), "{name} in {names:?}");
    }
    let options = with!(Options, modes = 2, segments);
    assert_derivatives_of_solves(&description, options, &of_ground);
}

#[test]
fn names_set_the_numbers_of_the_ground() {
    let mut description = mixed();
    for (name, value) in [
        ("ground.factor", 0.5),
        ("ground.scour.general", 1.5),
        ("ground.layer[1].undrained_strength[1]", 2e5),
        ("ground.layer[2].poissons_ratio", 0.4),
    ] {
        let parameter = Parameter::parse(name, &description).expect(name);
        parameter.set(&mut description, value);
        assert_eq!(parameter.value(&description), value, "{name}");
        assert_eq!(parameter.to_string(), name);
    }
    assert_eq!(ground_of(&mut description).factor, 0.5);
    let error = Parameter::parse("ground.layer[0].undrained_strength[0]", &description);
    error
        .expect_err("sand has none")
        .says("undrained shear strength");
}

/// Scour that is not there yet: the first metre costs what solves say.
#[test]
fn scour_of_zero_has_a_derivative() {
    for model in [SoilModel::Api, SoilModel::Kallehave] {
        let description = oc3(model);
        let names = ["ground.scour.general", "ground.scour.local"];
        let changes = names.map(|name| Change::parse(name, &description).expect(name));
        let options = with!(Options, modes = 2);
        let mut solver = Solver::new(options);
        let result = solver.sensitivities(&description, &changes);
        let result = result.expect("solved");
        for (change, derivatives) in changes.iter().zip(&result.changes) {
            let got = derivatives.modes[0].expect("a derivative").hz_per_unit;
            let at = |depth_m: f64| {
                let mut scoured = description.clone();
                change.apply(&mut scoured, depth_m);
                first_hz(&scoured)
            };
            // One-sided, of second order.
            let expected = (4.0 * at(0.01) - at(0.02) - 3.0 * at(0.0)) / 0.02;
            assert_close(got, expected, 2e-3, &format!("{model:?} {}", change.name()));
        }
    }
}

/// The modulus of sand of API is linear between the rows of its table, one of which is 35°.
#[test]
fn every_method_reports_the_kink_at_a_row_of_the_table_of_sand() {
    let mut description = oc3(SoilModel::Api);
    // The other edition has a figure in place of the table.
    let ground = description.ground.as_mut().expect("layers");
    ground.edition = ApiEdition::Rp2Geo;
    let names = [
        "ground.layer[1].friction_angle",
        "ground.layer[0].friction_angle",
    ];
    let changes = names.map(|name| Change::parse(name, &description).expect(name));
    for method in Method::ALL {
        let options = with!(Options, modes = 6, method);
        let result = Solver::new(options).sensitivities(&description, &changes);
        let result = result.expect("solved");
        let [at_row, between] = [0, 1].map(|change| &result.changes[change].modes);
        let mut second = 0;
        for (place, mode) in result.modes.iter().enumerate() {
            let case = format!("{}, {}: {:?}", method.name(), mode.label(), at_row[place]);
            // The first bending modes hardly move the second layer.
            if matches!(mode.family, Family::ForeAft | Family::SideSide) && mode.order == 2 {
                assert_eq!(at_row[place], Err(NoDerivative::OneSided), "{case}");
                second += 1;
            }
            assert!(between[place].is_ok(), "{case}: {:?}", between[place]);
        }
        assert_eq!(second, 2, "{}", method.name());
    }
}

/// The derivatives of the first frequency are those of solves on both sides.
#[track_caller]
pub(super) fn assert_derivatives_of_solves(
    description: &TowerDescription,
    options: Options,
    changes: &[Change],
) {
    let result = Solver::new(options).sensitivities(description, changes);
    let result = result.expect("solved");
    for (change, derivatives) in changes.iter().zip(&result.changes) {
        let name = change.name();
        let got = derivatives.modes[0].expect(name).hz_per_unit;
        let present = match name.starts_with("add") {
            true => 0.0,
            false => change.parameters()[0].value(description),
        };
        let step = 1e-3 * if present == 0.0 { 1.0 } else { present.abs() };
        let at = |sign: f64| {
            let mut near = description.clone();
            change.apply(&mut near, present + sign * step);
            first_hz(&near)
        };
        let expected = (at(1.0) - at(-1.0)) / (2.0 * step);
        let scale = first_hz(description) / step;
        let difference = (got - expected).abs();
        let allowed = 1e-3 * expected.abs() + 1e-9 * scale;
        assert!(difference <= allowed, "{name}: {got} for {expected}");
    }
}

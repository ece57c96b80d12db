//! Laws of scaling and of invariance: exact, on every mesh.

use super::{methods, sensitivities_of};
use towermodes::{Family, Inertia, Method, Options, TowerDescription};
use towermodes_testing::{parts, rna, with};
use towermodes_verify::towers::{monopile, reference, reference_350t};

/// What rounding leaves of a sweep, and the steps of differenced quotients.
fn tolerance(method: Method) -> f64 {
    match method {
        Method::RmjeExact => 1e-10,
        _ => 1e-8,
    }
}

/// Asserts that sums of elasticities, each times a factor, have a value in every mode.
#[track_caller]
fn assert_sums(
    description: &TowerDescription,
    options: &Options,
    terms: &[(&str, f64)],
    expected: impl Fn(Family) -> f64,
) {
    let names: Vec<&str> = terms.iter().map(|(name, _)| *name).collect();
    let result = sensitivities_of(description, &names, options);
    for (place, mode) in result.modes.iter().enumerate() {
        let of_change = |(change, (_, factor)): (usize, &(&str, f64))| {
            let elasticity = result.changes[change].elasticity(&result.modes, place);
            factor * elasticity.expect("it has a derivative")
        };
        let sum: f64 = terms.iter().enumerate().map(of_change).sum();
        let expected = expected(mode.family);
        assert!(
            (sum - expected).abs() < tolerance(options.method),
            "{} {}, {names:?}: {sum} instead of {expected}",
            options.method.name(),
            mode.label(),
        );
    }
}

fn bends(family: Family) -> bool {
    matches!(family, Family::ForeAft | Family::SideSide)
}

#[test]
fn a_slender_cone_scales_as_a_beam() {
    for method in methods() {
        let options = with!(Options, method, rotary_inertia = false);
        let check = |terms: &[(&str, f64)], expected: fn(Family) -> f64| {
            assert_sums(&reference(), &options, terms, expected);
        };
        check(
            &[("scale(material.youngs_modulus,material.shear_modulus)", 1.0)],
            |_| 0.5,
        );
        check(&[("material.density", 1.0)], |_| -0.5);
        check(
            &[("scale(stations[*].diameter,stations[*].wall)", 1.0)],
            |family| f64::from(u8::from(bends(family))),
        );
        check(&[("scale(stations[*].height)", 1.0)], |family| {
            if bends(family) { -2.0 } else { -1.0 }
        });
    }
}

#[test]
fn a_tower_scaled_as_a_whole_has_frequencies_of_the_inverse_scale() {
    let description = TowerDescription {
        rna: rna(350e3, [-0.41, 0.1, 1.97], [4.37e7, 2.353e7, 2.542e7]),
        point_masses: vec![parts::point_mass(31.0, 8e3, Inertia::default())],
        shear: towermodes::Shear::Cowper,
        ..reference_350t()
    };
    let lengths = "scale(stations[*].height,stations[*].diameter,stations[*].wall,point_mass[*].height,rna.center[0],rna.center[1],rna.center[2])";
    let terms = [
        (lengths, 1.0),
        ("scale(rna.mass,point_mass[*].mass)", 3.0),
        ("scale(rna.inertia.xx,rna.inertia.yy,rna.inertia.zz)", 5.0),
    ];
    for method in methods() {
        assert_sums(&description, &with!(Options, method), &terms, |_| -1.0);
    }
}

#[test]
fn stiffness_and_gravity_go_with_the_square_of_frequencies() {
    let terms = [
        ("scale(material.youngs_modulus,material.shear_modulus)", 1.0),
        (
            "scale(foundation.lateral,foundation.rocking,foundation.vertical,foundation.torsion)",
            1.0,
        ),
        ("gravity.acceleration", 1.0),
    ];
    for method in methods() {
        let options = with!(Options, method);
        assert_sums(&super::on_springs(), &options, &terms, |_| 0.5);
    }
}

#[test]
fn a_tower_that_moves_with_its_surroundings_keeps_its_frequencies() {
    let everything = "add(stations[*].height,point_mass[*].height,soil[0].rows[*].height,\
                      soil[1].rows[*].height,water.level,water.bed,wires[*].height)";
    for method in methods() {
        let result = sensitivities_of(&monopile(), &[everything], &with!(Options, method));
        for (mode, derivative) in result.modes.iter().zip(&result.changes[0].modes) {
            let derivative = derivative.expect("it has a derivative").hz_per_unit;
            let relative = derivative * 100.0 / mode.frequency_hz;
            let holds = relative.abs() < tolerance(method);
            assert!(holds, "{}: {relative}", mode.label());
        }
    }
}

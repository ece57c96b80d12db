//! What the measurements can and cannot tell.

use super::{Problem, fitted, frequencies, measured, remarks, tower, unknown, with_prior};
use towermodes::Change;
use towermodes_design::calibration::{AtBound, CalibrationError, Remark, Unknown};
use towermodes_testing::{Says, assert_matches};

/// One frequency, two springs: a combination is known, the other comes from the priors.
#[test]
fn lateral_and_rocking_stiffness_cannot_be_told_apart_by_one_frequency() {
    let base = tower();
    let hz = frequencies(&base, &["fore-aft 1"])[0];
    let problem = Problem {
        measured: vec![measured("fore-aft 1", hz, 0.001)],
        unknowns: vec![
            with_prior(&base, "foundation.lateral", 2e9, 1e9),
            with_prior(&base, "foundation.rocking", 1e11, 5e10),
        ],
        base,
    };
    let result = fitted(&problem).expect("a fit");
    let weakest = result.directions.last().expect("two directions");
    assert!(weakest.singular_value < 1e-9 * result.directions[0].singular_value);
    let said = remarks(&result).join("\n");
    let expected =
        "the measurements cannot distinguish foundation.lateral and foundation.rocking: with ";
    let holds = said.contains(expected) || said.contains("hardly determine");
    assert!(holds, "{said}");
    for shares in &result.shares {
        assert_eq!(shares.len(), 3);
        assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    }
    // The lateral spring hardly moves the first mode: its prior decides it.
    assert!(result.shares[0][1] > 0.9, "{:?}", result.shares);
}

/// Fore-aft modes do not depend on the torsional spring.
#[test]
fn unknowns_without_effect_are_refused_with_their_names() {
    let base = tower();
    let problem = Problem {
        measured: vec![
            measured("fore-aft 1", 0.26, 0.001),
            measured("fore-aft 2", 1.95, 0.01),
        ],
        unknowns: vec![
            unknown(&base, "foundation.rocking"),
            unknown(&base, "foundation.torsion"),
        ],
        base,
    };
    let error = fitted(&problem).expect_err("refused");
    assert_matches!(error, CalibrationError::NoEffect { .. });
    let text = error.to_string();
    text.begins("`foundation.torsion` does not change any measured frequency (at ");
    text.says("; give it a prior, do not fit it");
}

#[test]
fn an_unknown_without_effect_is_not_said_to_be_at_a_bound_or_to_be_hardly_determined() {
    let base = tower();
    let torsion = Unknown {
        bounds: Some([5e10, 2e11]),
        ..with_prior(&base, "foundation.torsion", 1e11, 1e10)
    };
    let problem = Problem {
        measured: vec![
            measured("fore-aft 1", 0.26, 0.001),
            measured("fore-aft 2", 1.95, 0.01),
        ],
        unknowns: vec![unknown(&base, "foundation.rocking"), torsion],
        base,
    };
    let said = remarks(&fitted(&problem).expect("a fit"));
    let of_torsion = said.iter().filter(|one| one.contains("foundation.torsion"));
    let of_torsion: Vec<&String> = of_torsion.collect();
    assert_eq!(
        of_torsion,
        [
            "foundation.torsion does not change any measured frequency: its value and deviation are those of its prior"
        ]
    );
}

/// One frequency, two stiffnesses of which one has a prior: the prior of that one decides both.
#[test]
fn a_number_without_a_prior_is_not_said_to_have_one() {
    let base = tower();
    let hz = frequencies(&base, &["fore-aft 1"])[0];
    let problem = Problem {
        measured: vec![measured("fore-aft 1", hz, 1e-4)],
        unknowns: vec![
            unknown(&base, "scale(stations[*].wall)"),
            with_prior(&base, "rna.mass", 350e3, 35e3),
        ],
        base,
    };
    let said = remarks(&fitted(&problem).expect("a fit")).join("\n");
    assert!(
        said.contains("scale(stations[*].wall) has no prior, but 100 % of its variance comes from the priors of other inputs, mostly from the prior of rna.mass"),
        "{said}"
    );
    said.says("rna.mass is known mostly from its prior: 100 % of its variance");
}

#[test]
fn a_bound_that_is_reached_is_said() {
    let base = tower();
    let problem = Problem {
        measured: vec![
            measured("fore-aft 1", 0.2, 0.001),
            measured("fore-aft 2", 1.6, 0.1),
        ],
        unknowns: vec![
            Unknown {
                bounds: Some([5e10, 2e11]),
                ..unknown(&base, "foundation.rocking")
            },
            with_prior(&base, "rna.mass", 350e3, 1e2),
        ],
        base,
    };
    let result = fitted(&problem).expect("a fit");
    let rocking = &result.unknowns[0];
    assert_eq!(rocking.at_bound, Some(AtBound::Lower));
    assert!((rocking.value / 5e10 - 1.0).abs() < 1e-12);
    assert_eq!((rocking.deviation, rocking.interval), (None, None));
    let said = remarks(&result).join("\n");
    said.says("foundation.rocking is at its lower bound 5e10");
    said.says("fore-aft 1 is not explained: 0.2 Hz was measured, 0.2");
    said.says("limited by the lower bound 5e10 of foundation.rocking");
    said.says("the residuals are larger than the standard deviations allow");
}

#[test]
fn a_fit_without_degrees_of_freedom_says_nothing_about_the_model() {
    let base = tower();
    let problem = Problem {
        measured: vec![measured("fore-aft 1", 0.25, 0.001)],
        unknowns: vec![unknown(&base, "foundation.rocking")],
        base,
    };
    let said = remarks(&fitted(&problem).expect("a fit")).join("\n");
    said.says("any measurement can be fitted");
    assert!(!said.contains("valid"), "{said}");
}

/// A stiff unknown with a small part in a weak combination is named too: the tower with the named
/// changes has the frequencies that the sentence claims.
#[test]
fn a_weak_combination_does_what_its_sentence_says() {
    let base = tower();
    let names = ["fore-aft 1", "fore-aft 2"];
    let [first, second] = frequencies(&base, &names)[..] else {
        panic!("two frequencies");
    };
    let deviations = [0.0005, 0.005];
    let problem = Problem {
        measured: vec![
            measured(names[0], first, deviations[0]),
            measured(names[1], second, deviations[1]),
        ],
        unknowns: vec![
            with_prior(&base, "foundation.lateral", 2e9, 1e9),
            with_prior(&base, "foundation.rocking", 1e11, 5e10),
            with_prior(&base, "rna.mass", 350e3, 35e3),
        ],
        base: base.clone(),
    };
    let result = fitted(&problem).expect("a fit");
    let mut found = 0;
    for remark in result.remarks() {
        let Remark::NotToldApart {
            changes,
            deviations: claimed,
        } = remark
        else {
            continue;
        };
        let mut moved = result.description.clone();
        for one in &changes {
            let change = Change::parse(&one.name, &moved).expect("a change");
            let at = result.unknowns.iter().find(|u| u.name == one.name);
            let value = at.expect("an unknown").value;
            assert!(one.is_factor && (0.8..1.25).contains(&one.amount), "{one}");
            let digits = one.to_string();
            let factor: f64 = digits
                .rsplit(' ')
                .next()
                .expect("a word")
                .parse()
                .expect("a factor");
            change.apply(&mut moved, value * factor);
        }
        let there = frequencies(&moved, &names);
        let before = frequencies(&result.description, &names);
        let moves = there.iter().zip(&before).zip(deviations);
        let moves = moves.map(|((a, b), sigma)| ((a - b) / sigma).powi(2));
        let effect = moves.sum::<f64>().sqrt();
        assert!((effect - claimed).abs() < 0.3, "{effect} for {claimed}");
        found += 1;
    }
    assert!(found > 0);
}

//! Every method against frequencies that it solves on both sides.

use towermodes::{Change, Method, Options, Solver, Tower, TowerDescription};
use towermodes_random::Class;

/// Some of the changes of a tower.
fn some_changes(description: &TowerDescription, count: usize, offset: usize) -> Vec<Change> {
    let all = Change::every(description);
    let step = 1 + all.len() / count;
    all.into_iter().skip(offset % step).step_by(step).collect()
}

/// What a derivative is multiplied by to be comparable, relative to the frequency.
fn size(change: &Change, value: f64, tower: &Tower) -> f64 {
    match change.unit() {
        "m" if !change.name().contains("diameter") && !change.name().contains("wall") => {
            tower.height_m()
        }
        _ => value.abs(),
    }
}

/// Frequencies on meshes that move with the tower, by the same method.
#[test]
fn derivatives_on_a_mesh_are_those_of_frequencies_on_moved_meshes() {
    let mut compared = 0;
    for (index, class) in Class::ALL.into_iter().enumerate() {
        let method = Method::ALL[index % Method::ALL.len()];
        for number in 20..24 {
            let description = class.description(number);
            compared += compare_on_mesh(&description, method, number as usize);
        }
        // The default method, whose derivatives are swept, with every kind of tower.
        for number in 30..33 {
            compared += compare_on_mesh(&class.description(number), Method::RmjeExact, index);
        }
    }
    assert!(compared > 500, "{compared} compared");
}

fn compare_on_mesh(description: &TowerDescription, method: Method, offset: usize) -> usize {
    let options = Options {
        method,
        modes: 5,
        segments: (method != Method::Spectral).then_some(24),
        degree: (method == Method::Spectral).then_some(14),
        ..Options::default()
    };
    let changes = some_changes(description, 5, offset);
    let mut solver = Solver::new(options);
    let (Ok(tower), Ok(result)) = (
        Tower::new(description.clone()),
        solver.sensitivities(description, &changes),
    ) else {
        return 0;
    };
    let mut compared = 0;
    for of_change in &result.changes {
        let change = &of_change.change;
        // Heights change how the segments are distributed.
        let is_size = ["diameter", "wall", "center"]
            .iter()
            .any(|n| change.name().contains(n));
        if change.unit() == "m" && !is_size || of_change.value == 0.0 {
            continue;
        }
        let h = 1e-3 * of_change.value.abs();
        let mut solve = |step: f64| {
            let mut changed = description.clone();
            change.apply(&mut changed, of_change.value + step);
            let tower = Tower::new(changed).ok()?;
            let solved = solver.frequencies(&tower).ok()?;
            let modes = solved.modes.iter();
            Some(
                modes
                    .map(|m| (m.label(), m.frequency_hz))
                    .collect::<Vec<_>>(),
            )
        };
        let Some([a, b, c, d]) = solve(h)
            .zip(solve(-h))
            .zip(solve(0.5 * h).zip(solve(-0.5 * h)))
            .map(|((a, b), (c, d))| [a, b, c, d])
        else {
            continue;
        };
        let size = size(change, of_change.value, &tower);
        for (place, mode) in result.modes.iter().enumerate() {
            let Ok(derivative) = of_change.modes[place] else {
                continue;
            };
            let hz = |modes: &[(String, f64)]| {
                let same = modes.iter().find(|(label, _)| *label == mode.label());
                same.map_or(f64::NAN, |same| same.1)
            };
            let (whole, half) = ((hz(&a) - hz(&b)) / (2.0 * h), (hz(&c) - hz(&d)) / h);
            let expected = half + (half - whole) / 3.0;
            let middle_hz = 0.5 * (hz(&c) + hz(&d));
            // Rows in one line make other meshes.
            let is_same = (middle_hz / mode.frequency_hz - 1.0).abs() < 1e-5;
            if !is_same || expected.is_nan() {
                continue;
            }
            let relative = |hz: f64| hz.abs() * size / mode.frequency_hz;
            let difference = relative(derivative.mesh_hz_per_unit - expected);
            let of_steps = relative(half - whole).powi(2);
            let own = relative(derivative.error_hz_per_unit);
            let case = format!("{} {}, {}", method.name(), change.name(), mode.label());
            let holds = difference < 1e-7_f64.max(own).max(of_steps);
            assert!(holds, "{case}: {difference:.1e}, {own:.1e}");
            compared += usize::from(difference < 1e-7);
        }
    }
    compared
}

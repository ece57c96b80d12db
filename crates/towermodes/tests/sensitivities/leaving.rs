//! Heights of what stands on a station, a step or a border of soil or water: the derivatives are
//! those of solved frequencies on both sides, and where these differ there is none.

use towermodes::{
    Change, Inertia, Method, ModeFrequency, NoDerivative, Options, PointMass, Rna, Solver, Tower,
    TowerDescription,
};
use towermodes_random::{Class, Seed};
use towermodes_testing::{parts, tube, with};

/// The largest difference from solved frequencies that is allowed where a height changes by the
/// height of the tower, relative to the frequency. Between thin flanges the steps are short, and a
/// kink of this size disappears in the rounding of quotients.
const ALLOWED: f64 = 5e-5;
/// Slopes of solved frequencies with a larger error, by two steps, are left out.
const CERTAIN: f64 = 1e-4;
/// Slopes of both sides that differ by less, in the same measure, belong to no kink.
const NO_KINK: f64 = 1e-7;

/// The slopes of a frequency on both sides of a value.
struct Slopes {
    label: String,
    /// What makes a derivative relative: the height of the tower over the frequency.
    scale: f64,
    /// On the left and on the right the slope and its error, relative; NaN where the tower is
    /// impossible.
    sides: [[f64; 2]; 2],
}

/// The slopes of solved frequencies; none if the tower has no frequencies.
fn slopes(description: &TowerDescription, change: &Change, value: f64) -> Option<Vec<Slopes>> {
    let tower = Tower::new(description.clone()).ok()?;
    let lengths = tower.pieces().iter().map(|piece| piece.length_m());
    let h = 1e-2 * lengths.fold(f64::INFINITY, f64::min);
    let mut solver = Solver::new(spectral());
    let mut solve = |step: f64| {
        let mut changed = description.clone();
        change.apply(&mut changed, value + step);
        let tower = Tower::new(changed).ok()?;
        Some(solver.frequencies(&tower).ok()?.modes.clone())
    };
    let own = solve(0.0)?;
    let solved = [-h, h].map(|h| [0.5, 1.0, 2.0].map(|part| solve(part * h)));
    let of_mode = |mode: &ModeFrequency| {
        let (label, hz) = (mode.label(), mode.frequency_hz);
        let scale = tower.height_m() / hz;
        let sides = [(-h, &solved[0]), (h, &solved[1])].map(|(h, solved)| {
            let [half, one, two] = solved.each_ref().map(|modes| {
                let same = modes.iter().flatten().find(|other| other.label() == label);
                same.map_or(f64::NAN, |same| same.frequency_hz - hz)
            });
            // Of second order, over the step and over its half.
            let (fine, coarse) = ((4.0 * half - one) / h, (4.0 * one - two) / (2.0 * h));
            [fine + (fine - coarse) / 3.0, (fine - coarse).abs()].map(|slope| slope * scale)
        });
        Slopes {
            label,
            scale,
            sides,
        }
    };
    Some(own.iter().map(of_mode).collect())
}

fn spectral() -> Options {
    with!(
        Options,
        method = Method::Spectral,
        degree = Some(14),
        modes = 5
    )
}

/// How many derivatives, and how many kinks, were compared.
#[derive(Default)]
struct Compared {
    derivatives: usize,
    kinks: usize,
    wrong: Vec<String>,
}

impl Compared {
    fn compare(&mut self, description: &TowerDescription, names: &[String], case: &str) {
        let names = names.iter();
        let changes = names.map(|name| Change::parse(name, description).expect("a name"));
        let changes: Vec<Change> = changes.collect();
        let results = [Method::Spectral, Method::RmjeExact, Method::Cardanic].map(|method| {
            let options = match method {
                Method::Spectral => spectral(),
                method => with!(Options, method, modes = 5),
            };
            let result = Solver::new(options).sensitivities(description, &changes);
            (method, result.expect("derivatives"))
        });
        for (index, change) in changes.iter().enumerate() {
            let value = results[0].1.changes[index].value;
            let Some(solved) = slopes(description, change, value) else {
                continue;
            };
            for (method, result) in &results {
                for of_mode in &solved {
                    let label = &of_mode.label;
                    let Some(place) = result.modes.iter().position(|m| m.label() == *label) else {
                        continue;
                    };
                    let got = result.changes[index].modes[place];
                    let got = got.map(|d| [d.hz_per_unit, d.error_hz_per_unit]);
                    let got = got.map(|own| own.map(|hz_per_unit| hz_per_unit * of_mode.scale));
                    let case = format!("{case}, {}, {}, {label}", change.name(), method.name());
                    self.add(got, of_mode, &case);
                }
            }
        }
    }

    fn add(&mut self, got: Result<[f64; 2], NoDerivative>, solved: &Slopes, case: &str) {
        let [[left, left_error], [right, right_error]] = solved.sides;
        let error = left_error.max(right_error);
        // In one direction the tower may be impossible.
        if left.is_nan() || right.is_nan() || error > CERTAIN {
            return;
        }
        let apart = (left - right).abs();
        let slopes = format!("left {left:.6e}, right {right:.6e} ± {error:.0e}");
        match got {
            Ok([value, own_error]) => {
                self.derivatives += 1;
                let misses = (value - left).abs().max((value - right).abs());
                if misses > ALLOWED + error + 3.0 * own_error {
                    let value = format!("{value:.6e} ± {own_error:.0e}");
                    self.wrong.push(format!("{case}: {value}, {slopes}"));
                }
            }
            Err(NoDerivative::OneSided) => {
                self.kinks += 1;
                if apart < NO_KINK {
                    self.wrong.push(format!("{case}: one-sided, {slopes}"));
                }
            }
            Err(NoDerivative::AtRest | NoDerivative::Repeated) => {}
        }
    }

    fn check(&self, derivatives: usize, kinks: usize) {
        let Self { wrong, .. } = self;
        let count = (self.derivatives, self.kinks);
        assert!(wrong.is_empty(), "{} of {count:?}: {wrong:#?}", wrong.len());
        assert!(count.0 >= derivatives && count.1 >= kinks, "{count:?}");
    }
}

/// The names of the heights of a station: of both rows of a step.
fn station(description: &TowerDescription, height_m: f64) -> String {
    let stations = description
        .stations
        .iter()
        .map(|row| ("stations", "height", row.height_m));
    let rows = description.properties.iter();
    let rows = rows.map(|row| ("properties", "z_m", row.height_m));
    let all = stations.chain(rows).enumerate();
    let own = all.filter(|(_, (_, _, row_m))| *row_m == height_m);
    let names = own.map(|(place, (table, key, _))| format!("{table}[{place}].{key}"));
    names.collect::<Vec<_>>().join(",")
}

/// A body with its own inertia, wires, or both, on stations of a random tower, and the heights to
/// compare.
pub(super) fn with_attachments(class: Class, number: u64) -> (TowerDescription, Vec<String>) {
    let mut seed = Seed::new(0x1eaf << 16 | number << 8 | class as u64);
    let mut description = class.description(number);
    description.point_masses.clear();
    description.wires.clear();
    let stations = description.stations.iter().map(|row| row.height_m);
    let rows = description.properties.iter().map(|row| row.height_m);
    let mut heights_m: Vec<f64> = stations.chain(rows).collect();
    heights_m.dedup();
    let (base_m, top_m) = (heights_m[0], heights_m[heights_m.len() - 1]);
    if heights_m.len() < 3 {
        // A cone has no station between its ends: what stands there is at the water or on top.
        heights_m.push(top_m);
    }
    let mut names = Vec::new();
    let within = |height_m: f64| base_m < height_m && height_m < top_m;
    let water_m = description.water.as_ref().map(|water| water.level_m);
    let soil_m = description.soil.iter().flatten().map(|row| row.height_m);
    let fronts: Vec<f64> = water_m
        .into_iter()
        .chain(soil_m)
        .filter(|m| within(*m))
        .collect();
    for index in 0..2 {
        let place = seed.whole(1, heights_m.len() - 2);
        let mut height_m = heights_m[place];
        if !fronts.is_empty() && seed.chance(0.5) {
            height_m = fronts[seed.whole(0, fronts.len() - 1)];
        }
        let mass_kg = seed.log_between(5e3, 3e5);
        let radius_m = seed.between(0.0, 12.0);
        let inertia = mass_kg * radius_m * radius_m;
        description.point_masses.push(PointMass {
            height_m,
            mass_kg,
            inertia_kg_m2: Inertia {
                xx: inertia,
                yy: 1.3 * inertia,
                zz: 0.8 * inertia,
                ..Inertia::default()
            },
        });
        names.push(format!("point_mass[{index}].height"));
        let of_station = station(&description, height_m);
        if !of_station.is_empty() && height_m < top_m {
            names.push(format!("add({of_station})"));
            names.push(format!("add({of_station},point_mass[{index}].height)"));
        }
        if Some(height_m) == water_m {
            names.push("water.level".to_owned());
        }
    }
    if seed.chance(0.7) {
        let height_m = heights_m[seed.whole(1, heights_m.len() - 2)];
        let stiffness = seed.log_between(1e6, 1e8);
        description
            .wires
            .push(parts::wires(height_m, 3, stiffness, 45.0));
        names.push("wires[0].height".to_owned());
    }
    names.sort();
    names.dedup();
    (description, names)
}

#[test]
fn what_stands_on_a_station_has_the_derivatives_of_both_sides() {
    let mut compared = Compared::default();
    // Where a row next to a feature of a few millimetres moves, no derivative is given.
    let classes = Class::ALL
        .into_iter()
        .filter(|class| *class != Class::Narrow);
    for class in classes {
        for number in 0..4 {
            let (description, names) = with_attachments(class, number);
            if Tower::new(description.clone()).is_err() {
                continue;
            }
            compared.compare(&description, &names, &format!("{} {number}", class.name()));
        }
    }
    compared.check(1000, 500);
}

/// The case of a user: a body of 100 t with the inertia of a platform on a station.
#[test]
fn a_platform_on_a_station_moves_with_the_slopes_of_solves() {
    let platform = Inertia {
        xx: 3e7,
        yy: 3e7,
        zz: 3e7,
        ..Inertia::default()
    };
    let on = |stations: &[(f64, f64, f64)]| TowerDescription {
        rna: Rna::point(350e3),
        point_masses: vec![parts::point_mass(40.0, 100e3, platform)],
        ..tube(stations)
    };
    let mut compared = Compared::default();
    let names = ["point_mass[0].height", "stations[1].height"].map(str::to_owned);
    let smooth = on(&[(0.0, 6.0, 0.06), (40.0, 5.0, 0.04), (90.0, 4.0, 0.02)]);
    compared.compare(&smooth, &names, "smooth");
    assert_eq!(compared.kinks, 0);
    let step = on(&[
        (0.0, 6.0, 0.06),
        (40.0, 5.0, 0.04),
        (40.0, 5.0, 0.03),
        (90.0, 4.0, 0.02),
    ]);
    let names = [
        "point_mass[0].height",
        "add(stations[1].height,stations[2].height)",
    ];
    compared.compare(&step, &names.map(str::to_owned), "step");
    compared.check(24, 12);
}

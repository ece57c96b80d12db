//! What a tower stands on and in: limits, sums, formulas, and what more of anything does.

use crate::towers;

use towermodes::{
    Foundation, FoundationSprings, HalfSpace, Material, Method, Options, PointMass, Rna, Shear,
    SoilRow, SoilStiffness, Station, TowerDescription, Warning, Water, Wires,
};
use towermodes::{SolveError, Tower, solve};
use towermodes_testing::{changed, parts, with};
use towers::Uniform;
use towers::{
    all_frequencies, assert_close, assert_same, monopile, reference_350t, reference_eccentric,
    solved,
};

/// The methods with rigid bodies.
fn chains() -> impl Iterator<Item = Method> {
    let methods = Method::ALL.into_iter();
    methods.filter(|method| method.unit() == "segment")
}

fn of_method(method: Method) -> Options {
    with!(Options, method)
}

/// The spectral beam of a degree of its own choice differs by what it promises, 1e-10; of this one
/// by rounding.
fn spectral() -> Options {
    changed!(of_method(Method::Spectral), degree = Some(14))
}

fn all(description: &TowerDescription, options: &Options) -> Vec<f64> {
    all_frequencies(&solved(description, options))
}

fn on(springs: FoundationSprings) -> TowerDescription {
    TowerDescription {
        foundation: Foundation::Springs(springs),
        ..reference_eccentric()
    }
}

#[test]
fn stiff_springs_are_a_clamp() {
    let stiff = parts::springs(1e21, 1e21, 0.0, 1e21, 1e21);
    for method in chains() {
        let options = of_method(method);
        let clamped = all(&reference_eccentric(), &options);
        // The tower is 1e12 times as soft: EI/L, GJ/L and EA/L are 1e9 to 1e10.
        let sprung = all(&on(stiff), &options);
        assert_same(&sprung, &clamped, 1e-9, method.name());
        // Infinite ones are no springs at all.
        let rigid = all(&on(FoundationSprings::RIGID), &options);
        assert_same(&rigid, &clamped, 1e-13, method.name());
    }
    for method in [Method::Bmodes, Method::Spectral] {
        let options = of_method(method);
        let clamped = all(&reference_eccentric(), &options);
        assert_same(
            &all(&on(FoundationSprings::RIGID), &options),
            &clamped,
            1e-13,
            method.name(),
        );
    }
}

#[test]
fn soft_springs_are_not_a_clamp() {
    // Each of them alone lowers something: none is forgotten.
    let clamped = all(&reference_eccentric(), &spectral());
    type Change = fn(&mut FoundationSprings);
    let changes: [(&str, Change); 4] = [
        ("lateral", |s| s.lateral_n_per_m = 1e8),
        ("rocking", |s| s.rocking_n_m = 1e10),
        ("vertical", |s| s.vertical_n_per_m = 1e9),
        ("torsion", |s| s.torsion_n_m = 1e9),
    ];
    for (name, change) in changes {
        let mut springs = FoundationSprings::RIGID;
        change(&mut springs);
        let soft = all(&on(springs), &spectral());
        let fell = soft
            .iter()
            .zip(&clamped)
            .any(|(soft, clamped)| *soft < 0.95 * clamped);
        assert!(fell, "{name}: {soft:?}, {clamped:?}");
    }
}

#[test]
fn the_sign_of_a_coupling_spring_says_on_which_side_of_the_base_it_rests() {
    // Springs K about a point e below the base, where x = x_base − e θ, are K_T, K_R + K_T e² and
    // the coupling −K_T e at the base.
    let (lateral, rocking, e) = (2e9, 1e11, 3.0);
    let about = |e: f64| {
        on(FoundationSprings {
            lateral_n_per_m: lateral,
            rocking_n_m: rocking + lateral * e * e,
            coupling_n: -lateral * e,
            ..FoundationSprings::RIGID
        })
    };
    // Independent Ritz solutions, to a unit of the last digit.
    let below = [0.2689936730, 0.2713919847, 1.2997909652, 1.6467497680];
    let above = [0.2707854912, 0.2732480625, 1.2998561216, 1.6674581627];
    for (e, truth) in [(e, below), (-e, above)] {
        let got = all(&about(e), &spectral());
        assert_same(&got[..4], &truth, 1e-9, "spectral");
        for method in chains() {
            // What 100 segments leave is less than the sign is worth, 0.7 %.
            let got = all(&about(e), &of_method(method));
            assert_same(&got[..4], &truth, 1e-3, method.name());
        }
    }
}

fn soil(height_m: f64, [x, y, z, torsion]: [f64; 4]) -> SoilRow {
    SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2: x,
            y_n_per_m2: y,
            z_n_per_m2: z,
            torsion_n: torsion,
            ..SoilStiffness::default()
        },
    }
}

fn within(layers: Vec<Vec<SoilRow>>) -> TowerDescription {
    changed!(reference_eccentric(), soil = layers)
}

const FIRM: [f64; 4] = [6e6, 5e6, 2e6, 8e6];
const SOFT: [f64; 4] = [2e6, 3e6, 1e6, 4e6];

fn blend(a: [f64; 4], b: [f64; 4], share: f64) -> [f64; 4] {
    std::array::from_fn(|i| a[i] + share * (b[i] - a[i]))
}

fn sum(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|i| a[i] + b[i])
}

#[test]
fn layers_that_overlap_are_one_layer_with_their_sum() {
    // One from 0 to 40 m that softens upwards, one from 20 to 60 m.
    let lower = vec![soil(0.0, FIRM), soil(40.0, SOFT)];
    let upper = vec![soil(20.0, SOFT), soil(60.0, SOFT)];
    let middle = blend(FIRM, SOFT, 0.5);
    let together = vec![
        soil(0.0, FIRM),
        soil(20.0, middle),
        soil(20.0, sum(middle, SOFT)),
        soil(40.0, sum(SOFT, SOFT)),
        soil(40.0, SOFT),
        soil(60.0, SOFT),
    ];
    let (two, one) = (within(vec![lower, upper]), within(vec![together]));
    let methods = chains().chain([Method::Bmodes]).map(of_method);
    for options in methods.chain([spectral()]) {
        // The same cuts and, but for rounding, the same springs.
        let case = options.method.name();
        assert_same(&all(&two, &options), &all(&one, &options), 1e-12, case);
    }
    // A layer forgotten would show.
    let bare = all(&reference_eccentric(), &spectral());
    assert!(all(&two, &spectral())[0] > 1.05 * bare[0]);
}

#[test]
fn rows_on_the_line_between_rows_change_nothing() {
    let (base, top) = (0.0, 87.6);
    let row = |share: f64| soil(base + share * (top - base), blend(FIRM, SOFT, share));
    let whole = within(vec![vec![row(0.0), row(1.0)]]);
    let split = within(vec![vec![row(0.0), row(0.25), row(0.5), row(1.0)]]);
    // Polynomials of degree 14 leave nothing in either.
    let (a, b) = (all(&whole, &spectral()), all(&split, &spectral()));
    assert_same(&a, &b, 1e-11, "spectral");
    // Quarters share 400 segments out as they lay before: it is one mesh, and only rounding
    // differs.
    let fine = with!(Options, segments = Some(400));
    assert_same(&all(&whole, &fine), &all(&split, &fine), 1e-6, "rmje-exact");
}

#[test]
fn soil_below_the_tower_holds_nothing() {
    // Given down to 30 m below the base: what reaches the tower is the line from there.
    let deep = within(vec![vec![soil(-30.0, FIRM), soil(30.0, SOFT)]]);
    let middle = blend(FIRM, SOFT, 0.5);
    let cut = within(vec![vec![soil(0.0, middle), soil(30.0, SOFT)]]);
    assert_same(
        &all(&deep, &spectral()),
        &all(&cut, &spectral()),
        1e-12,
        "deep",
    );
}

type Change = fn(&mut TowerDescription);

/// Every frequency of the monopile before and after.
fn before_and_after(change: Change, options: &Options) -> [Vec<f64>; 2] {
    let mut changed = monopile();
    change(&mut changed);
    [all(&monopile(), options), all(&changed, options)]
}

fn of_springs(tower: &mut TowerDescription, change: fn(&mut FoundationSprings)) {
    if let Foundation::Springs(springs) = &mut tower.foundation {
        change(springs);
    }
}

fn firmer(tower: &mut TowerDescription, change: fn(&mut SoilStiffness)) {
    tower.soil[0]
        .iter_mut()
        .for_each(|row| change(&mut row.stiffness));
}

/// Changes that leave the mesh as it is, so that the k-th eigenvalue of the chain itself cannot
/// fall (Weyl).
const STIFFER: [(&str, Change); 11] = [
    ("lateral", |t| of_springs(t, |s| s.lateral_n_per_m *= 2.0)),
    ("rocking", |t| of_springs(t, |s| s.rocking_n_m *= 2.0)),
    ("vertical", |t| of_springs(t, |s| s.vertical_n_per_m *= 2.0)),
    ("torsion", |t| of_springs(t, |s| s.torsion_n_m *= 2.0)),
    ("soil x", |t| firmer(t, |s| s.x_n_per_m2 *= 1.5)),
    ("soil y", |t| firmer(t, |s| s.y_n_per_m2 *= 1.5)),
    ("soil z", |t| firmer(t, |s| s.z_n_per_m2 *= 1.5)),
    ("soil torsion", |t| firmer(t, |s| s.torsion_n *= 1.5)),
    ("soil rotation x", |t| firmer(t, |s| s.rotation_x_n += 1e9)),
    ("soil rotation y", |t| firmer(t, |s| s.rotation_y_n += 1e9)),
    ("wires", |t| {
        t.wires.push(Wires {
            count: 4,
            ..t.wires[0]
        });
    }),
];

const HEAVIER: [(&str, Change); 4] = [
    ("water", |t| {
        if let Some(water) = &mut t.water {
            water.added_mass_coefficient *= 1.5;
        }
    }),
    ("denser water", |t| {
        if let Some(water) = &mut t.water {
            water.density_kg_per_m3 *= 1.1;
        }
    }),
    // It presses too, which lowers them further.
    ("point mass", |t| {
        t.point_masses
            .push(with!(PointMass, height_m = 12.0, mass_kg = 50e3));
    }),
    ("inertia", |t| t.point_masses[0].inertia_kg_m2.zz *= 10.0),
];

#[test]
fn more_stiffness_raises_and_more_mass_lowers_every_frequency() {
    for method in [Method::RmjeExact, Method::CardanicExact, Method::Bmodes] {
        let options = changed!(of_method(method), modes = 12);
        for (changes, sign) in [(&STIFFER[..], 1.0), (&HEAVIER[..], -1.0)] {
            for (name, change) in changes {
                let [before, after] = before_and_after(*change, &options);
                let case = format!("{}, {name}", method.name());
                let rises = before.iter().zip(&after).map(|(a, b)| sign * (b / a - 1.0));
                let (least, most) = rises.fold((f64::INFINITY, 0.0_f64), |(least, most), rise| {
                    (least.min(rise), most.max(rise))
                });
                // Rounding alone may go the other way; what counts for nothing would not go its own
                // way.
                assert!(least > -1e-11, "{case}: {least:e}");
                assert!(most > 1e-7, "{case}: {most:e}");
            }
        }
    }
}

#[test]
fn weights_lower_the_bending_frequencies() {
    let heavy = changed!(reference_350t(), gravity_m_per_s2 = 9.81);
    for method in Method::ALL {
        let (light, heavy) = (
            all(&reference_350t(), &of_method(method)),
            all(&heavy, &of_method(method)),
        );
        // 0.30020574 and 0.29380746 Hz, by two independent Ritz solutions; BModes has no rotary
        // inertia, which changes it less.
        assert_close(heavy[0] / light[0], 0.978_687, 1e-4, method.name());
        assert_eq!(heavy[0], heavy[1], "{}", method.name());
    }
}

#[test]
fn flooding_adds_the_water_inside() {
    let inertia = |flooded| {
        let mut tower = monopile();
        if let Some(water) = &mut tower.water {
            water.flooded = flooded;
        }
        let tower = Tower::new(tower).expect("a valid tower");
        (tower.rigid_inertia(true), tower)
    };
    let ((dry, _), (wet, tower)) = (inertia(false), inertia(true));
    // ρ π/4 ∫ dᵢ² dz from the base to the level, by a fine midpoint rule.
    let (base_m, level_m, steps) = (tower.base_m(), 0.0, 100_000);
    let step = (level_m - base_m) / f64::from(steps);
    let inner = |z: f64| {
        let stations = tower.stations();
        let above = stations
            .iter()
            .position(|s| s.height_m > z)
            .expect("below the top");
        let (a, b) = (&stations[above - 1], &stations[above]);
        let s = (z - a.height_m) / (b.height_m - a.height_m);
        let bore = |s: &Station| s.outer_diameter_m - 2.0 * s.wall_thickness_m;
        bore(a) + s * (bore(b) - bore(a))
    };
    let heights = (0..steps).map(|k| base_m + (f64::from(k) + 0.5) * step);
    let volume: f64 = heights
        .map(|z| std::f64::consts::FRAC_PI_4 * inner(z).powi(2) * step)
        .sum();
    for i in [0, 1] {
        assert_close(wet[i][i] - dry[i][i], 1025.0 * volume, 1e-8, "transverse");
    }
    assert_eq!((wet[2][2], wet[5][5]), (dry[2][2], dry[5][5]));
    let frequencies = |flooded| {
        let mut tower = monopile();
        tower.water = tower.water.map(|water| Water { flooded, ..water });
        all(&tower, &spectral())
    };
    assert!(frequencies(true)[0] < frequencies(false)[0]);
}

fn footing(embedment_m: f64) -> HalfSpace {
    parts::half_space(10.0, embedment_m, 5e7, 1.0 / 3.0)
}

#[test]
fn a_surface_footing_has_the_springs_of_the_textbook() {
    // For ν = 1/3 the formulas of Richart, Hall & Woods are 6 GR, 64/13 GR, 4 GR³ and 16/3 GR³.
    let (g, r) = (5e7, 10.0_f64);
    let springs = footing(0.0).springs();
    assert_close(springs.vertical_n_per_m, 6.0 * g * r, 1e-14, "vertical");
    let lateral = 64.0 / 13.0 * g * r;
    assert_close(springs.lateral_n_per_m, lateral, 1e-14, "lateral");
    assert_close(springs.rocking_n_m, 4.0 * g * r.powi(3), 1e-14, "rocking");
    let torsion = 16.0 / 3.0 * g * r.powi(3);
    assert_close(springs.torsion_n_m, torsion, 1e-14, "torsion");
    assert_eq!(springs.coupling_n, 0.0);
}

#[test]
fn a_footing_half_its_radius_deep_is_stiffer_by_the_textbook() {
    // e/R = 1/2, ν = 1/3: 1 + 0.6 × 2/3 × 1/2, 1 + 0.55 × 5/3 × 1/2, 1 + 1.2 × 2/3 × 1/2 + 0.2 ×
    // 5/3 × 1/8.
    let (surface, deep) = (footing(0.0).springs(), footing(5.0).springs());
    let factor = |of: fn(&FoundationSprings) -> f64| of(&deep) / of(&surface);
    assert_close(factor(|s| s.vertical_n_per_m), 1.2, 1e-14, "vertical");
    assert_close(factor(|s| s.lateral_n_per_m), 35.0 / 24.0, 1e-14, "lateral");
    assert_close(factor(|s| s.rocking_n_m), 173.0 / 120.0, 1e-14, "rocking");
    assert_eq!(factor(|s| s.torsion_n_m), 1.0);
}

#[test]
fn a_footing_lowers_the_frequencies_as_its_springs_do() {
    // The springs of the surface footing for ν = 1/3, by hand.
    let (g, r) = (5e7, 10.0_f64);
    let by_hand = Foundation::Springs(FoundationSprings {
        lateral_n_per_m: 64.0 / 13.0 * g * r,
        rocking_n_m: 4.0 * g * r.powi(3),
        coupling_n: 0.0,
        vertical_n_per_m: 6.0 * g * r,
        torsion_n_m: 16.0 / 3.0 * g * r.powi(3),
    });
    let of = |foundation| {
        let tower = changed!(reference_eccentric(), foundation);
        all(&tower, &Options::default())
    };
    let footing = of(Foundation::HalfSpace(footing(0.0)));
    assert_same(&footing, &of(by_hand), 1e-13, "the springs by hand");
    assert!(footing[0] < all(&reference_eccentric(), &Options::default())[0]);
}

#[test]
fn springs_of_any_size_are_springs() {
    for stiffness in [1e100, 1e200, 1e300] {
        let tower = on(parts::springs(
            stiffness, stiffness, 0.0, stiffness, stiffness,
        ));
        let clamped = all(&reference_eccentric(), &Options::default());
        let case = "clamped";
        assert_same(&all(&tower, &Options::default()), &clamped, 1e-12, case);
    }
}

/// A weightless column that shears under a heavy top.
fn haringx(gravity_m_per_s2: f64) -> TowerDescription {
    let tube = |z| Station::new(z, 4.0, 0.2);
    TowerDescription {
        materials: vec![Material::from_shear_modulus(1e-6, 1e9, 4e8)],
        stations: vec![tube(0.0), tube(20.0)],
        shear: Shear::Coefficient(0.02),
        rna: Rna::point(5e5),
        gravity_m_per_s2,
        ..TowerDescription::default()
    }
}

#[test]
fn a_column_that_shears_buckles_at_haringxs_load() {
    // A cantilever under P on its tip buckles where P (1 + P/κGA) = π² EI/(4 L²) (Haringx 1948).
    let (area, gravity) = (std::f64::consts::PI * 0.2 * 3.8, 9.81);
    let second_moment = area * (16.0 + 3.6 * 3.6) / 16.0;
    let shear_n = 0.02 * 4e8 * area;
    let euler_n = std::f64::consts::PI.powi(2) * 1e9 * second_moment / (4.0 * 400.0);
    let critical_n = 0.5 * shear_n * ((1.0 + 4.0 * euler_n / shear_n).sqrt() - 1.0);
    let exact = critical_n / (5e5 * gravity);
    // Shear takes a third of Euler's load: a wrong coupling would show.
    assert!(critical_n < 0.7 * euler_n);
    for method in Method::ALL {
        let options = Options {
            segments: (method != Method::Spectral).then_some(200),
            modes: 2,
            ..of_method(method)
        };
        let factor = solved(&haringx(gravity), &options).buckling_load_factor;
        let tolerance = match method {
            Method::Spectral => 1e-9,
            // BModes has no shear.
            Method::Bmodes => continue,
            // Its sliding joint at L/4 is an error of first order.
            Method::Rmje => 5e-3,
            _ => 5e-5,
        };
        assert_close(factor.expect("it presses"), exact, tolerance, method.name());
    }
}

#[test]
fn errors_are_honest_where_a_coarser_chain_buckles() {
    // The chain of 100 segments bears 1.0000 times these weights, that of 50 less than once.
    let mut description = reference_350t();
    description.gravity_m_per_s2 = 228.054;
    let beam = solved(&description, &of_method(Method::Spectral));
    for method in [Method::RmjeExact, Method::Lumped] {
        let chain = solved(&description, &of_method(method));
        for (mode, exact) in chain.modes.iter().zip(&beam.modes) {
            let error = (mode.frequency_hz - exact.frequency_hz).abs();
            let case = format!("{}, {}: {error:e}", method.name(), mode.label());
            assert!(error <= 1.5 * mode.error_hz(), "{case}");
            // And no nonsense above the first.
            let holds = mode.order == 1 || mode.error_hz() < 1e-3 * mode.frequency_hz;
            assert!(holds, "{case}");
        }
    }
}

#[test]
fn soil_that_no_segment_resolves_is_warned_of() {
    for (stiffness, is_warned) in [(1e9, false), (1e22, true)] {
        let rows = [0.0, 40.0].map(|z| soil(z, [stiffness, stiffness, 0.0, 0.0]));
        let tower = within(vec![rows.to_vec()]);
        for method in [Method::RmjeExact, Method::Spectral] {
            let said = solved(&tower, &of_method(method)).warnings;
            let warned = said
                .iter()
                .any(|w| matches!(w, Warning::SoilUnresolved { .. }));
            assert_eq!(warned, is_warned, "{}, {stiffness:e}", method.name());
        }
    }
}

#[test]
fn wires_beside_which_rounding_hides_the_tower_are_refused() {
    let held = |stiffness_n_per_m| TowerDescription {
        wires: vec![parts::wires(60.0, 3, stiffness_n_per_m, 45.0)],
        ..reference_eccentric()
    };
    for method in Method::ALL {
        let solve = |stiffness| {
            let tower = Tower::new(held(stiffness)).expect("a valid tower");
            solve(&tower, &of_method(method))
        };
        assert!(solve(1e12).is_ok(), "{}", method.name());
        for stiffness in [1e24, 1e28, 1e32] {
            let holds = solve(stiffness).is_err();
            assert!(holds, "{}, {stiffness:e}", method.name());
        }
    }
}

#[test]
fn weights_and_shear_together_keep_the_order_of_the_elements() {
    let mut description = haringx(9.81);
    description.materials[0].density_kg_per_m3 = 1000.0;
    let beam = all(&description, &of_method(Method::Spectral))[0];
    for method in [Method::RmjeExact, Method::Lumped, Method::CardanicExact] {
        let error = |segments| {
            let options = changed!(of_method(method), segments = Some(segments));
            all(&description, &options)[0] / beam - 1.0
        };
        let order = (error(20) / error(40)).log2();
        assert!((order - 2.0).abs() < 0.05, "{}: {order}", method.name());
    }
}

/// The zero of J₋₁⸝₃ at (2/3)√α: the self-weight m g L³/(EI) that buckles a clamped uniform column.
const CRITICAL: f64 = 7.83734743894348;

fn column(alpha: f64) -> TowerDescription {
    Uniform::new(0.01, None).under_gravity(alpha).description
}

#[test]
fn a_column_that_buckles_under_its_own_weight_is_refused_with_the_load() {
    let tower = Tower::new(column(8.0)).expect("a valid tower");
    for method in Method::ALL {
        let Err(SolveError::Buckles { load_factor }) = solve(&tower, &of_method(method)) else {
            panic!("{} does not buckle", method.name());
        };
        // 100 segments: (κl)²/12 with κ = 2/L is 3e-5.
        let tolerance = match method {
            Method::Spectral => 1e-8,
            _ => 2e-4,
        };
        assert_close(load_factor, CRITICAL / 8.0, tolerance, method.name());
    }
}

#[test]
fn a_column_close_to_buckling_is_solved() {
    let fast = |method| changed!(of_method(method), rotary_inertia = false);
    let solution = solved(&column(7.8), &fast(Method::Spectral));
    let factor = solution.buckling_load_factor.expect("weights press");
    assert_close(factor, CRITICAL / 7.8, 1e-9, "load factor");
    let unit = Uniform::new(0.01, None).unit_hz;
    let got = solution.modes[0].frequency_hz / unit;
    assert_close(got, 0.243259605, 1e-8, "λ");
    assert!(
        solved(&column(0.0), &fast(Method::Spectral))
            .buckling_load_factor
            .is_none()
    );
}

#[test]
fn the_load_factor_falls_as_the_inverse_of_gravity() {
    let factor = |gravity_m_per_s2| {
        let tower = changed!(reference_eccentric(), gravity_m_per_s2);
        solved(&tower, &spectral()).buckling_load_factor
    };
    let (one, two) = (
        factor(9.81).expect("it presses"),
        factor(19.62).expect("it presses"),
    );
    assert_close(one, 2.0 * two, 1e-9, "twice the gravity");
    // From an independent Ritz solution.
    assert_close(one, 22.11544391, 1e-8, "the reference tower");
}

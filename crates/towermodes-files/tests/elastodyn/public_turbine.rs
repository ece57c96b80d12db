//! The turning NREL 5 MW turbine of a public deck against the tables of an independent program:
//! full beams with ElastoDyn's tables, linear between the rows, quadratic and cubic curvatures of
//! which agree to 4e-8.

use towermodes::Blade;
use towermodes::turbine::{
    BladeMotion, Harmonic, TurbineDescription, TurbineMesh, TurbineModel, TurbinePart,
};
use towermodes_files::{ReadOptions, TowerInput};
use towermodes_testing::with;

use crate::elastodyn::public::{ONSHORE, peer_deck_with};
use crate::elastodyn::texts::close;

const SPEEDS_RPM: [f64; 4] = [0.0, 6.9, 9.0, 12.1];

/// Frequencies at these speeds, Hz, with the generator locked; the nacelle does not yaw, and there
/// is no weight.
const LOCKED: [[f64; 4]; 14] = [
    [0.317_444_414, 0.317_401_530, 0.317_359_056, 0.317_226_005],
    [0.319_706_760, 0.319_335_373, 0.319_080_591, 0.318_620_842],
    [0.614_628_177, 0.578_473_169, 0.555_941_130, 0.527_638_620],
    [0.670_753_104, 0.616_252_871, 0.616_908_575, 0.618_048_824],
    [0.677_729_327, 0.720_242_116, 0.732_031_563, 0.754_555_234],
    [0.705_371_149, 0.806_570_195, 0.852_849_294, 0.898_286_357],
    [1.085_480_568, 0.979_793_143, 0.946_623_471, 0.926_537_122],
    [1.100_853_230, 1.212_429_159, 1.249_742_346, 1.305_830_616],
    [1.872_331_255, 1.812_613_343, 1.793_161_670, 1.769_554_060],
    [1.953_740_425, 1.997_909_710, 2.011_392_281, 2.037_535_251],
    [1.978_603_796, 2.050_357_416, 2.095_330_559, 2.168_207_412],
    [2.743_505_617, 2.749_617_058, 2.753_859_352, 2.762_062_295],
    [2.874_462_463, 2.877_669_602, 2.880_007_310, 2.884_822_864],
    [3.071_362_661, 3.072_961_811, 3.074_115_160, 3.076_453_581],
];

/// The same with the generator free.
const FREE: [[f64; 4]; 14] = [
    [0.319_687_205, 0.319_261_688, 0.318_957_413, 0.318_352_748],
    [0.324_451_477, 0.324_459_557, 0.324_464_284, 0.324_471_522],
    [0.669_634_496, 0.578_585_487, 0.555_998_465, 0.527_671_496],
    [0.677_728_089, 0.714_206_748, 0.726_431_359, 0.749_593_991],
    [0.699_332_233, 0.806_565_032, 0.852_846_158, 0.898_129_107],
    [1.085_476_541, 0.979_680_017, 0.946_496_262, 0.926_534_992],
    [1.100_676_572, 1.212_352_030, 1.249_671_398, 1.305_767_470],
    [1.676_162_167, 1.678_318_188, 1.679_811_715, 1.682_694_429],
    [1.872_331_255, 1.812_678_297, 1.793_248_313, 1.769_679_973],
    [1.953_830_316, 1.997_913_523, 2.011_398_085, 2.037_547_668],
    [1.978_607_716, 2.050_401_721, 2.095_367_487, 2.168_236_521],
    [2.802_374_206, 2.806_179_571, 2.808_819_798, 2.813_922_836],
    [2.874_464_097, 2.877_712_838, 2.880_081_280, 2.884_960_613],
    [3.196_286_857, 3.198_800_903, 3.200_590_113, 3.204_157_966],
];

/// At rest with the generator locked, when the nacelle yaws on a spring of 9.02832e9 N m/rad
/// (NREL/TP-500-38060, table 4-1).
const YAWING: [f64; 13] = [
    0.317_442_4,
    0.319_706_7,
    0.614_441_5,
    0.668_134_9,
    0.670_770_3,
    0.705_361_8,
    1.084_937_8,
    1.099_592_8,
    1.872_331_3,
    1.896_985_5,
    1.978_603_9,
    2.743_492_2,
    2.874_462_5,
];

/// The same with the weight of all that the tower carries, and its own.
const HEAVY: [f64; 13] = [
    0.311_850_8,
    0.314_079_4,
    0.614_227_5,
    0.668_133_0,
    0.670_707_0,
    0.705_181_0,
    1.084_928_3,
    1.099_539_5,
    1.871_676_3,
    1.896_979_8,
    1.978_572_8,
    2.741_302_5,
    2.866_801_2,
];

/// The deck with a change of its turbine.
fn input(
    without_gravity: bool,
    change: impl FnOnce(&mut TurbineDescription),
) -> Option<TowerInput> {
    let options = with!(ReadOptions, without_gravity);
    let deck = peer_deck_with(ONSHORE, &options)?;
    let mut input = deck.unwrap_or_else(|error| panic!("{error}")).input;
    change(input.turbine.as_mut().expect("a turbine"));
    Some(input)
}

/// The model of the deck on a mesh whose error is below the last digit of the tables.
fn model(input: &TowerInput) -> TurbineModel {
    let turbine = input
        .whole_turbine()
        .unwrap_or_else(|error| panic!("{error}"));
    let mesh = TurbineMesh {
        tower_elements: 20,
        tower_degree: 6,
        blade_degree: 5,
    };
    TurbineModel::new(&turbine.expect("a turbine"), &mesh).expect("a mesh")
}

fn compare(model: &mut TurbineModel, rpm: f64, expected: &[f64], tolerance: f64) {
    let limit_hz = expected[expected.len() - 1] + 1e-3;
    let spectrum = model.frequencies(limit_hz, rpm);
    let spectrum = spectrum.expect("a spectrum");
    assert!(spectrum.is_complete);
    assert_eq!(spectrum.frequencies.len(), expected.len(), "{rpm} rpm");
    for (found, expected) in spectrum.frequencies.iter().zip(expected) {
        let found = found.frequency_hz;
        let is_close = (found / expected - 1.0).abs() < tolerance;
        assert!(is_close, "{rpm} rpm: {found} Hz instead of {expected} Hz");
    }
}

fn compare_table(input: &TowerInput, table: &[[f64; 4]]) {
    let mut model = model(input);
    for (column, rpm) in SPEEDS_RPM.into_iter().enumerate() {
        let expected: Vec<f64> = table.iter().map(|row| row[column]).collect();
        // The ninth digit of 0.3 Hz is rounded.
        compare(&mut model, rpm, &expected, 2e-9);
    }
}

#[test]
fn the_masses_are_the_published_ones() {
    let Some(input) = input(true, |_| {}) else {
        return;
    };
    let machine = input.turbine.clone().expect("a turbine");
    let blade = Blade::new(machine.blade.clone()).expect("a blade");
    close(blade.mass_kg(), 17_608.830, 5e-4);
    close(machine.rna().expect("a body").mass_kg, 349_606.49, 5e-3);
    close(input.tower().expect("a tower").mass_kg(), 347_460.23, 5e-3);
    assert!(!machine.generator.is_locked && machine.yaw_n_m_per_rad.is_infinite());
}

/// The body that the tower carries for all other commands is the turbine without its generator,
/// which is locked to the nacelle there.
#[test]
fn the_turbine_at_rest_is_the_lumped_assembly() {
    let Some(input) = input(true, |_| {}) else {
        return;
    };
    let machine = input.turbine.as_ref().expect("a turbine");
    let (rna, lumped) = (machine.rna().expect("a body"), input.description.rna);
    let (sine, cosine) = (-5f64).to_radians().sin_cos();
    let generator = machine.generator.inertia_kg_m2;
    let (own, all) = (rna.inertia_kg_m2, lumped.inertia_kg_m2);
    close(all.xx, own.xx + generator * cosine * cosine, 1e-5);
    close(all.yy, own.yy, 1e-5);
    close(all.zz, own.zz + generator * sine * sine, 1e-5);
    close(all.xz, own.xz + generator * sine * cosine, 1e-5);
    for axis in 0..3 {
        close(rna.center_m[axis], lumped.center_m[axis], 1e-12);
    }
}

#[test]
fn the_frequencies_with_a_locked_generator_are_those_of_the_tables() {
    let Some(input) = input(true, |turbine| turbine.generator.is_locked = true) else {
        return;
    };
    compare_table(&input, &LOCKED);
}

#[test]
fn the_frequencies_with_a_free_generator_are_those_of_the_tables() {
    let Some(input) = input(true, |_| {}) else {
        return;
    };
    compare_table(&input, &FREE);
}

#[test]
fn a_yawing_nacelle_and_the_weight_have_the_frequencies_of_the_tables() {
    // Seven digits of 0.3 Hz. That program has a weight of its own: both effects on the first
    // frequencies, 1.8 percent, differ by 0.03 percent.
    for (without_gravity, expected, tolerance) in [(true, YAWING, 2e-7), (false, HEAVY, 1e-5)] {
        let yawing = input(without_gravity, |turbine| {
            turbine.generator.is_locked = true;
            turbine.yaw_n_m_per_rad = 9.028_32e9;
        });
        let Some(input) = yawing else {
            return;
        };
        compare(&mut model(&input), 0.0, &expected, tolerance);
    }
}

/// The names of the rows of [`LOCKED`] from the shares of that program.
#[test]
fn the_names_with_a_locked_generator_are_those_of_the_dominant_parts() {
    let Some(input) = input(true, |turbine| turbine.generator.is_locked = true) else {
        return;
    };
    let names: [(f64, [&str; 14]); 3] = [
        (
            0.0,
            [
                "SS1", "FA1", "D1", "FB1", "FF1", "FC1", "EB1", "EF1", "FB2", "FF2", "FC2", "EC1",
                "FA2", "SS2",
            ],
        ),
        (
            6.9,
            [
                "SS1", "FA1", "FB1", "D1", "FC1", "FF1", "EB1", "EF1", "FB2", "FC2", "FF2", "EC1",
                "FA2", "SS2",
            ],
        ),
        (
            12.1,
            [
                "SS1", "FA1", "FB1", "D1", "FC1", "EB1", "FF1", "EF1", "FB2", "FC2", "FF2", "EC1",
                "FA2", "SS2",
            ],
        ),
    ];
    let mut model = model(&input);
    for (rpm, expected) in names {
        assert_eq!(short_names(&mut model, rpm)[..14], expected, "{rpm} rpm");
    }
    // Neighbours at 0.25 rpm that exchange their names, by the same program.
    let mut before = short_names(&mut model, 0.0);
    let mut exchanges = Vec::new();
    for step in 1..=60 {
        let rpm = 0.25 * f64::from(step);
        let names = short_names(&mut model, rpm);
        let places = before.windows(2).zip(names.windows(2));
        let exchanged = places.filter(|(a, b)| a[0] == b[1] && a[1] == b[0] && a != b);
        exchanges.extend(exchanged.map(|(_, b)| (rpm, b[0].clone(), b[1].clone())));
        before = names;
    }
    let expected = [
        (1.75, "FC1", "FF1"),
        (3.25, "FC2", "FF2"),
        (4.0, "FB1", "D1"),
        (11.5, "EB1", "FF1"),
    ];
    let exchanges: Vec<(f64, &str, &str)> = exchanges
        .iter()
        .map(|(rpm, a, b)| (*rpm, &a[..], &b[..]))
        .collect();
    assert_eq!(exchanges, expected);
}

/// "SS1", "FB2": tower side-side 1, flapwise backward whirl 2.
fn short_names(model: &mut TurbineModel, rpm: f64) -> Vec<String> {
    let modes = model.modes(3.0715 + 0.01, rpm).expect("modes");
    let short = |part: TurbinePart| match part {
        TurbinePart::TowerForeAft => "FA",
        TurbinePart::TowerSideSide => "SS",
        TurbinePart::Shaft => "D",
        TurbinePart::Blades(BladeMotion::Flap, Harmonic::Backward) => "FB",
        TurbinePart::Blades(BladeMotion::Flap, Harmonic::Forward) => "FF",
        TurbinePart::Blades(BladeMotion::Flap, Harmonic::Collective) => "FC",
        TurbinePart::Blades(BladeMotion::Edge, Harmonic::Backward) => "EB",
        TurbinePart::Blades(BladeMotion::Edge, Harmonic::Forward) => "EF",
        TurbinePart::Blades(BladeMotion::Edge, Harmonic::Collective) => "EC",
        other => panic!("{other}"),
    };
    let names = modes.modes.iter().map(|mode| mode.name);
    names
        .map(|name| format!("{}{}", short(name.part), name.order))
        .collect()
}

//! Floating platforms, with the matrices of their files.

use towermodes::mooring::MooringDescription;
use towermodes::tower::MooringLines;
use towermodes::{Buoyancy, FloatingPlatform, Inertia, ReferredMatrix};

use super::moorings::{hywind, oc4_semi, volturnus};

/// A symmetric matrix at the surface by entries on and above the diagonal.
fn matrix(entries: &[(usize, usize, f64)]) -> ReferredMatrix {
    let mut matrix = [[0.0; 6]; 6];
    for (i, j, value) in entries {
        (matrix[*i][*j], matrix[*j][*i]) = (*value, *value);
    }
    ReferredMatrix {
        matrix,
        height_m: 0.0,
    }
}

/// Lines between a platform and the ground.
fn lines(description: MooringDescription) -> Option<Box<MooringLines>> {
    Some(Box::new(MooringLines {
        description,
        still_water_m: 0.0,
    }))
}

/// Buoyancy with its centre on the tower axis.
fn buoyancy(force_n: f64) -> Option<Buoyancy> {
    let center_m = [0.0; 2];
    Some(Buoyancy { force_n, center_m })
}

/// OC3-Hywind, with its added mass at infinite frequency.
pub(super) fn hywind_platform() -> FloatingPlatform {
    FloatingPlatform {
        mass_kg: 7_466_330.0,
        center_m: [0.0, 0.0, -89.9155],
        inertia_kg_m2: Inertia::from([4.22923e9, 4.22923e9, 1.6423e8, 0.0, 0.0, 0.0]),
        added_mass: matrix(&[
            (0, 0, 7_759_111.625),
            (1, 1, 7_759_089.075),
            (2, 2, 241_254.865),
            (3, 3, 37_936_090_500.0),
            (4, 4, 37_936_182_750.0),
            (0, 4, -483_141_693.75),
            (1, 3, 483_140_412.5),
        ]),
        hydrostatic: matrix(&[
            (2, 2, 332_940.982_186_137_47),
            (3, 3, -4_999_184_366.317_75),
            (4, 4, -4_999_184_366.317_75),
            // The delta lines, which the model has as a spring against yaw.
            (5, 5, 98_340_000.0),
        ]),
        buoyancy: buoyancy(1025.0 * 9.80665 * 8029.21),
        mooring_lines: lines(hywind()),
        ..FloatingPlatform::default()
    }
}

/// The floater of OC4 with the ballast in its members, with its added mass at infinite frequency.
pub(super) fn oc4_semi_platform() -> FloatingPlatform {
    FloatingPlatform {
        mass_kg: 13_476_029.885_175_185,
        center_m: [2.380_485_936_526_888e-6, 0.0, -13.460_320_744_232_28],
        inertia_kg_m2: Inertia::from([
            7_099_695_559.357_918,
            7_099_695_524.311_949,
            12_805_371_291.807_281,
            0.0,
            61.654_407_277_277_876,
            0.0,
        ]),
        added_mass: matrix(&[
            (0, 0, 6_487_393.1),
            (1, 1, 6_487_457.675),
            (2, 2, 14_698_766.5),
            (3, 3, 7_211_705_250.0),
            (4, 4, 7_211_408_000.0),
            (5, 5, 4_869_131_300.0),
            (0, 2, -6.495_924_175),
            (0, 4, -85_107_369.5),
            (1, 3, 85_107_487.375),
            (1, 5, -771.264_478_75),
            (2, 4, 507.745_537_5),
            (3, 5, -19_272.171_462_5),
        ]),
        hydrostatic: matrix(&[
            (2, 2, 3_820_308.361_699_375_3),
            (3, 3, -381_160_110.233_243_47),
            (4, 4, -381_157_798.315_506),
            (2, 4, -154.105_299_592_212_5),
            (3, 5, -157.296_212_483_433_1),
        ]),
        buoyancy: buoyancy(1025.0 * 9.80665 * 13917.0),
        mooring_lines: lines(oc4_semi()),
        ..FloatingPlatform::default()
    }
}

/// VolturnUS-S, with its added mass at infinite frequency.
pub(super) fn volturnus_platform() -> FloatingPlatform {
    FloatingPlatform {
        mass_kg: 17_838_000.0,
        center_m: [0.0, 0.0, -14.4],
        inertia_kg_m2: Inertia::from([1.2507e10, 1.2507e10, 2.3667e10, 0.0, 0.0, 0.0]),
        added_mass: matrix(&[
            (0, 0, 9_642_416.9),
            (1, 1, 9_642_460.975),
            (2, 2, 24_821_717.75),
            (3, 3, 11_640_484_250.0),
            (4, 4, 11_639_859_000.0),
            (5, 5, 20_137_519_000.0),
            (0, 2, -28.901_755_875),
            (0, 4, -100_971_883.875),
            (1, 3, 100_969_864.625),
            (1, 5, -1_738.200_637_5),
            (2, 4, -18_388.725_5),
            (3, 5, -49_377.243),
        ]),
        hydrostatic: matrix(&[
            (2, 2, 4_454_964.435_15),
            (3, 3, 2_194_462_787.625),
            (4, 4, 2_194_222_467.15),
            (2, 4, -4_034.463_935_4),
        ]),
        buoyancy: buoyancy(1025.0 * 9.81 * 20_206.349),
        mooring_lines: lines(volturnus()),
        ..FloatingPlatform::default()
    }
}

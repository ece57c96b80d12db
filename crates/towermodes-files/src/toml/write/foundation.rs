//! `[foundation]`.

use towermodes::space::SpatialMatrix;
use towermodes::{
    FloatingPlatform, Foundation, FoundationSprings, HalfSpace, ReferredMatrix, StiffnessFoundation,
};

use super::Writing;
use super::bodies::{inertia_with, triple};
use super::text::number_rows;

const NONE: SpatialMatrix = [[0.0; 6]; 6];
const MOTION: &str = "x, y, z, rotation about x, y, z";

/// Left out where the base is clamped.
pub(super) fn foundation(foundation: &Foundation, writing: &mut Writing) {
    match foundation {
        Foundation::Clamped => {}
        Foundation::Stiffness(foundation) => match as_springs(foundation) {
            Some(foundation) => springs(&foundation, writing),
            None => stiffness(foundation, writing),
        },
        Foundation::Springs(foundation) => springs(foundation, writing),
        Foundation::HalfSpace(footing) => half_space(footing, writing),
        Foundation::Floating(platform) => floating(platform, writing),
    }
}

fn kind(kind: &str, writing: &mut Writing) {
    writing.section("[foundation]");
    writing.value("type", &format!("\"{kind}\""), "");
}

fn matrix(key: &str, matrix: &SpatialMatrix, comment: &str, writing: &mut Writing) {
    writing.line(format!("{key} = [  # {comment}"));
    number_rows(matrix, 6, writing);
    writing.line("]");
}

/// The springs that a stiffness with rigid motions is, which in a file only springs have; none if nothing is rigid, or if no springs say it.
fn as_springs(foundation: &StiffnessFoundation) -> Option<FoundationSprings> {
    let k = &foundation.stiffness;
    let is_rigid = |i: usize| k[i][i] == f64::INFINITY;
    let springs = FoundationSprings {
        lateral_n_per_m: k[0][0],
        rocking_n_m: k[4][4],
        coupling_n: if is_rigid(0) || is_rigid(4) {
            0.0
        } else {
            k[0][4]
        },
        vertical_n_per_m: k[2][2],
        torsion_n_m: k[5][5],
    };
    let mut of_springs = NONE;
    let diagonal = [k[0][0], k[0][0], k[2][2], k[4][4], k[4][4], k[5][5]];
    for (i, entry) in diagonal.into_iter().enumerate() {
        of_springs[i][i] = entry;
    }
    let coupling = springs.coupling_n;
    for (i, j, entry) in [(0, 4, coupling), (1, 3, -coupling)] {
        (of_springs[i][j], of_springs[j][i]) = (entry, entry);
    }
    // What a rigid motion has beside its diagonal means nothing.
    let matters = |i: usize, j: usize| i == j || !(is_rigid(i) || is_rigid(j));
    let mut entries = (0..6).flat_map(|i| (0..6).map(move |j| (i, j)));
    let is_said = entries.all(|(i, j)| !matters(i, j) || of_springs[i][j] == k[i][j]);
    let is_rigid_somewhere = (0..6).any(is_rigid);
    (is_rigid_somewhere && is_said && foundation.inertia == NONE).then_some(springs)
}

fn stiffness(foundation: &StiffnessFoundation, writing: &mut Writing) {
    if foundation
        .stiffness
        .iter()
        .flatten()
        .any(|entry| entry.is_infinite())
    {
        let message = "the foundation's stiffness has infinite entries, which a file has only in type = \"springs\"; these are none, \
            as they differ in the two planes or have an inertia";
        writing.note(message);
    }
    kind("stiffness", writing);
    let comment = format!("{MOTION}, of the base: N/m, N, N m");
    matrix("matrix", &foundation.stiffness, &comment, writing);
    if foundation.inertia != NONE {
        let comment = "what moves with it: kg, kg m, kg m2";
        matrix("mass", &foundation.inertia, comment, writing);
    }
}

fn springs(springs: &FoundationSprings, writing: &mut Writing) {
    kind("springs", writing);
    writing.number("lateral", springs.lateral_n_per_m, "N/m; inf is rigid");
    writing.number("rocking", springs.rocking_n_m, "N m");
    writing.number("vertical", springs.vertical_n_per_m, "N/m");
    writing.number("torsion", springs.torsion_n_m, "N m");
    if springs.coupling_n != 0.0 {
        let comment = "N, between x and rotation about y";
        writing.number("coupling", springs.coupling_n, comment);
    }
}

fn half_space(footing: &HalfSpace, writing: &mut Writing) {
    kind("half-space", writing);
    writing.number("radius", footing.radius_m, "m");
    if footing.embedment_m != 0.0 {
        writing.number("embedment", footing.embedment_m, "m");
    }
    writing.number("soil_shear_modulus", footing.shear_modulus_pa, "Pa");
    writing.number("soil_poissons_ratio", footing.poissons_ratio, "");
}

fn floating(platform: &FloatingPlatform, writing: &mut Writing) {
    kind("floating", writing);
    writing.number("mass", platform.mass_kg, "with ballast, kg");
    let comment = "of mass, m: x and y from the tower's axis, z in the datum of the stations";
    writing.value("center", &triple(platform.center_m), comment);
    inertia_with(&platform.inertia_kg_m2, &["xx", "yy", "zz"], writing);
    let matrices = [
        ("added_mass", &platform.added_mass, "kg, kg m, kg m2"),
        (
            "hydrostatic",
            &platform.hydrostatic,
            "of water plane and buoyancy: N/m, N, N m",
        ),
        ("mooring", &platform.mooring, "N/m, N, N m"),
    ];
    for (key, referred, units) in matrices {
        if *referred != ReferredMatrix::default() {
            let comment = "m, of the point that the matrix is about";
            writing.number(&format!("{key}_height"), referred.height_m, comment);
            matrix(
                key,
                &referred.matrix,
                &format!("{MOTION}: {units}"),
                writing,
            );
        }
    }
}

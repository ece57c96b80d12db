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
        Foundation::Stiffness(foundation) => stiffness(foundation, writing),
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

fn stiffness(foundation: &StiffnessFoundation, writing: &mut Writing) {
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

//! Exact section integrals over any part of a linear piece.
//!
//! Diameter and wall are linear, so A is a quadratic and I a quartic in height: three Gauss points give every mass integral
//! exactly. Compliances ∫ dx/EI are rational; five points on panels over which no dimension changes by more than 10 % leave
//! an error below 1e-15 (the nearest pole of the integrand is 20 half-panels away).

use super::piece::{Piece, Section};

/// Gauss-Legendre nodes and weights on [−1, 1] with three points: exact to degree 5.
const GAUSS_3: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 9.0),
    (0.0, 8.0 / 9.0),
    (0.774_596_669_241_483_4, 5.0 / 9.0),
];

/// Gauss-Legendre nodes and weights on [−1, 1] with five points: exact to degree 9.
const GAUSS_5: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
];

/// Mass integrals of a part of the tower about a reference height z₀.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MassIntegrals {
    /// ∫ ρA dz, kg.
    pub mass_kg: f64,
    /// ∫ ρA (z − z₀) dz, kg m.
    pub first_moment_kg_m: f64,
    /// ∫ ρA (z − z₀)² dz, kg m²; the section's own rotary inertia is not in it.
    pub second_moment_kg_m2: f64,
    /// ∫ ρI dz, kg m²: rotary inertia about a diameter; about the tower's axis it is twice this.
    pub rotary_inertia_kg_m2: f64,
}

/// Compliance integrals of a part of the tower, as a cantilever feels them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Compliance {
    /// ∫ dz/EI, rad/(N m): end rotation by a unit moment.
    pub bending_per_n_m: f64,
    /// Elastic centre z_c = ∫ z dz/EI ÷ ∫ dz/EI, m: a force there does not rotate the end.
    pub elastic_centre_m: f64,
    /// ∫ (z − z_c)² dz/EI, m/N: deflection of the elastic centre by a unit force there, from bending.
    pub deflection_m_per_n: f64,
    /// ∫ dz/(κGA), m/N: the same from shear.
    pub shear_m_per_n: f64,
    /// ∫ dz/EA, m/N.
    pub axial_m_per_n: f64,
    /// ∫ dz/GJ, rad/(N m).
    pub torsion_per_n_m: f64,
}

/// The mass integrals of `piece` between two heights (m) inside it, about `reference_m`.
pub fn mass_integrals(piece: &Piece, base_m: f64, top_m: f64, reference_m: f64) -> MassIntegrals {
    let (middle, half) = (0.5 * (base_m + top_m), 0.5 * (top_m - base_m));
    let mut sum = MassIntegrals::default();
    for (node, weight) in GAUSS_3 {
        let z = middle + half * node;
        let tube = piece.tube_at(z);
        let arm = z - reference_m;
        let density_weight = piece.material.density_kg_per_m3 * weight * half;
        let mass = density_weight * tube.area_m2();
        sum.mass_kg += mass;
        sum.first_moment_kg_m += mass * arm;
        sum.second_moment_kg_m2 += mass * arm * arm;
        sum.rotary_inertia_kg_m2 += density_weight * tube.second_moment_of_area_m4();
    }
    sum
}

/// The compliance integrals of `piece` between two heights (m) inside it.
pub fn compliance(piece: &Piece, base_m: f64, top_m: f64) -> Compliance {
    let middle = 0.5 * (base_m + top_m);
    let mut sum = Compliance::default();
    // Moments of 1/EI about the middle: the elastic centre is near it, so nothing cancels.
    let (mut first, mut second) = (0.0, 0.0);
    integrate(piece, base_m, top_m, &mut |z, weight, section| {
        let arm = z - middle;
        let bending = weight / section.bending_n_m2;
        sum.bending_per_n_m += bending;
        first += bending * arm;
        second += bending * arm * arm;
        sum.shear_m_per_n += weight * section.shear_flexibility_per_n;
        sum.axial_m_per_n += weight / section.axial_n;
        sum.torsion_per_n_m += weight / section.torsion_n_m2;
    });
    let offset = first / sum.bending_per_n_m;
    // Over a part too short for a number between its ends there is nothing left but rounding.
    let elastic_centre_m = if offset.is_finite() {
        (middle + offset).clamp(base_m, top_m)
    } else {
        middle
    };
    Compliance {
        elastic_centre_m,
        deflection_m_per_n: (second - first * (elastic_centre_m - middle)).max(0.0),
        ..sum
    }
}

/// A hinge that takes a part of a segment's bending.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hinge {
    /// Its height, m.
    pub height_m: f64,
    /// Its flexibility, rad/(N m).
    pub bending_per_n_m: f64,
}

/// The two-point Gauss rule of the measure dz/EI over a part of `piece` whose [`compliance`] is `whole`, lower point first: two hinges that give the same end rotations
/// and deflections under end forces and moments, and under any load that varies no faster than linearly, as the beam itself.
///
/// With mₖ = ∫ xᵏ dz/EI about the elastic centre (m₁ = 0) the points are the roots of x² − (m₃/m₂) x − m₂/m₀, the weights
/// m₀ x₂/(x₂ − x₁) and −m₀ x₁/(x₂ − x₁) (Golub & Welsch 1969). For a prismatic part: (1 ∓ 1/√3)/2 of the length, half each.
pub fn gauss_hinges(piece: &Piece, base_m: f64, top_m: f64, whole: &Compliance) -> [Hinge; 2] {
    let (centre, m0) = (whole.elastic_centre_m, whole.bending_per_n_m);
    let (m2, mut m3) = (whole.deflection_m_per_n, 0.0);
    integrate(piece, base_m, top_m, &mut |z, weight, section| {
        m3 += weight / section.bending_n_m2 * (z - centre).powi(3);
    });
    let hinge = |offset: f64, share: f64| Hinge {
        height_m: (centre + offset).clamp(base_m, top_m),
        bending_per_n_m: m0 * share,
    };
    let (half_sum, product) = (0.5 * m3 / m2, -m2 / m0);
    let root = (half_sum * half_sum - product).sqrt();
    let (lower, upper) = (half_sum - root, half_sum + root);
    if upper.partial_cmp(&lower) != Some(std::cmp::Ordering::Greater) {
        // Too short for a number between its ends: both hinges at the centre.
        return [hinge(0.0, 0.5), hinge(0.0, 0.5)];
    }
    let lower_share = upper / (upper - lower);
    [hinge(lower, lower_share), hinge(upper, 1.0 - lower_share)]
}

/// Tells `add` the points of a quadrature with their weights (m) and sections: five Gauss points on each of as many panels as keep the
/// change of every dimension over a panel below 10 %.
#[inline]
fn integrate(piece: &Piece, base_m: f64, top_m: f64, add: &mut impl FnMut(f64, f64, &Section)) {
    if steepness(piece, base_m, top_m) <= STEEPEST {
        integrate_panel(piece, base_m, top_m, add);
    } else {
        integrate_steep(piece, base_m, top_m, add);
    }
}

/// The largest ratio of a dimension at the ends of a panel.
const STEEPEST: f64 = 1.1;

#[inline]
fn integrate_panel(
    piece: &Piece,
    base_m: f64,
    top_m: f64,
    add: &mut (impl FnMut(f64, f64, &Section) + ?Sized),
) {
    let (middle, half) = (0.5 * (base_m + top_m), 0.5 * (top_m - base_m));
    for (node, weight) in GAUSS_5 {
        let z = middle + half * node;
        add(z, weight * half, &piece.section_at(z));
    }
}

/// Halves until every panel is flat enough, or has no number between its ends.
#[cold]
fn integrate_steep(
    piece: &Piece,
    base_m: f64,
    top_m: f64,
    add: &mut dyn FnMut(f64, f64, &Section),
) {
    let middle = 0.5 * (base_m + top_m);
    let divisible = base_m < middle && middle < top_m;
    if divisible && steepness(piece, base_m, top_m) > STEEPEST {
        integrate_steep(piece, base_m, middle, add);
        integrate_steep(piece, middle, top_m, add);
    } else {
        integrate_panel(piece, base_m, top_m, add);
    }
}

/// The larger of the ratios, thick end to thin end, of diameter and wall.
fn steepness(piece: &Piece, base_m: f64, top_m: f64) -> f64 {
    let (a, b) = (piece.tube_at(base_m), piece.tube_at(top_m));
    let ratio = |x: f64, y: f64| if x > y { x / y } else { y / x };
    ratio(a.outer_diameter_m, b.outer_diameter_m).max(ratio(a.wall_thickness_m, b.wall_thickness_m))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tower::{Material, Shear, Tube};

    fn cone() -> Piece {
        let rod = |d: f64| Tube {
            outer_diameter_m: d,
            wall_thickness_m: d / 2.0,
        };
        Piece {
            base_m: 0.0,
            top_m: 10.0,
            base_tube: rod(2.0),
            top_tube: rod(1.0),
            material: Material::from_shear_modulus(1.0, 1.0, 0.4),
            shear: Shear::Rigid,
        }
    }

    #[test]
    fn solid_cone_has_its_closed_form_integrals() {
        // d = 2 − z/10, I = π d⁴/64: ∫dz/EI = 640/(3π) (1 − 1/8); mass of a frustum π h (R² + Rr + r²)/3.
        let pi = std::f64::consts::PI;
        let c = compliance(&cone(), 0.0, 10.0);
        let exact = 640.0 / (3.0 * pi) * (1.0 - 1.0 / 8.0);
        assert!((c.bending_per_n_m / exact - 1.0).abs() < 1e-14);
        let m = mass_integrals(&cone(), 0.0, 10.0, 0.0);
        let exact = pi * 10.0 * (1.0 + 0.5 + 0.25) / 3.0;
        assert!((m.mass_kg / exact - 1.0).abs() < 1e-14);
    }

    #[test]
    fn hinges_are_a_gauss_rule_exact_to_the_third_power() {
        let piece = cone();
        let rule_of = |piece: &Piece| gauss_hinges(piece, 0.0, 10.0, &compliance(piece, 0.0, 10.0));
        let hinges = rule_of(&piece);
        for power in 0..4 {
            let (mut exact, rule) = (
                0.0,
                hinges.map(|h| h.bending_per_n_m * h.height_m.powi(power)),
            );
            integrate(&piece, 0.0, 10.0, &mut |z, weight, section| {
                exact += weight / section.bending_n_m2 * z.powi(power);
            });
            assert!(
                ((rule[0] + rule[1]) / exact - 1.0).abs() < 1e-13,
                "power {power}"
            );
        }
        let prismatic = Piece {
            top_tube: piece.base_tube,
            ..piece
        };
        let [lower, upper] = rule_of(&prismatic);
        let offset = 5.0 / 3.0_f64.sqrt();
        assert!((lower.height_m - (5.0 - offset)).abs() < 1e-13);
        assert!((upper.height_m - (5.0 + offset)).abs() < 1e-13);
        assert!((lower.bending_per_n_m / upper.bending_per_n_m - 1.0).abs() < 1e-13);
    }

    #[test]
    fn integrals_over_parts_add_up() {
        let piece = cone();
        let whole = compliance(&piece, 0.0, 10.0);
        let (a, b) = (compliance(&piece, 0.0, 3.7), compliance(&piece, 3.7, 10.0));
        let sum = a.bending_per_n_m + b.bending_per_n_m;
        assert!((sum / whole.bending_per_n_m - 1.0).abs() < 1e-14);
        // Steiner: the parts' own deflections plus their distances from the common centre.
        let steiner = |c: &Compliance| {
            let arm = c.elastic_centre_m - whole.elastic_centre_m;
            c.deflection_m_per_n + arm * arm * c.bending_per_n_m
        };
        let sum = steiner(&a) + steiner(&b);
        assert!((sum / whole.deflection_m_per_n - 1.0).abs() < 1e-13);
    }
}

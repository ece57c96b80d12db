//! Exact section integrals over any part of a linear piece.
//!
//! Diameter and wall of a tube are linear, so A is a quadratic and I a quartic in height, and the
//! masses of a table are quadratics at most: three Gauss points give every mass integral exactly.
//! Compliances ∫ dx/EI are rational; five points on panels over which no dimension of a tube and no
//! stiffness of a table changes by more than 10 % leave an error below 1e-15 (the nearest pole of
//! the integrand is 20 half-panels away).

use super::axisymmetric::Axisymmetric;
use super::piece::Piece;
use super::planes::{Plane, Planes};
use super::section::{Section, SectionMasses};

/// Gauss-Legendre nodes and weights on [−1, 1] with three points: exact to degree 5.
const GAUSS_3: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 9.0),
    (0.0, 8.0 / 9.0),
    (0.774_596_669_241_483_4, 5.0 / 9.0),
];

/// Gauss-Legendre nodes and weights on [−1, 1] with five points: exact to degree 9.
pub(crate) const GAUSS_5: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
];

/// Mass integrals of a part of the tower about a reference height z₀.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MassIntegrals {
    /// ∫ ρA dz, kg: of the tower alone.
    pub mass_kg: f64,
    /// ∫ ρA (z − z₀) dz, kg m: of the tower alone.
    pub structural_moment_kg_m: f64,
    /// ∫ ρA (z − z_base) dz, kg m: the same about the lower end of the part.
    pub moment_about_base_kg_m: f64,
    /// ∫ m dz, kg, with m = ρA and the water that moves transversely.
    pub transverse_kg: f64,
    /// ∫ m (z − z₀) dz, kg m.
    pub first_moment_kg_m: f64,
    /// ∫ m (z − z₀)² dz, kg m²; the section's own rotary inertia is not in it.
    pub second_moment_kg_m2: f64,
    /// ∫ ρI dz, kg m²: the sections' rotary inertia in each bending plane.
    pub rotary_inertia_kg_m2: Planes<f64>,
    /// The same about the tower's axis, kg m².
    pub polar_inertia_kg_m2: f64,
}

/// Compliance integrals of a part of the tower, as a cantilever feels them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Compliance {
    /// Each plane's own.
    pub bending: Planes<BendingCompliance>,
    /// ∫ dz/EA, m/N.
    pub axial_m_per_n: f64,
    /// ∫ dz/GJ, rad/(N m).
    pub torsion_per_n_m: f64,
}

/// Compliance integrals of a part of the tower in one bending plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BendingCompliance {
    /// ∫ dz/EI, rad/(N m): end rotation by a unit moment.
    pub bending_per_n_m: f64,
    /// Elastic centre z_c = ∫ z dz/EI ÷ ∫ dz/EI, m: a force there does not rotate the end.
    pub elastic_centre_m: f64,
    /// ∫ (z − z_c)² dz/EI, m/N: deflection of the centre of flexibility by a unit force there, from
    /// bending.
    pub deflection_m_per_n: f64,
    /// ∫ dz/(κGA), m/N: the same from shear.
    pub shear_m_per_n: f64,
}

/// The mass integrals of `piece` between two heights (m) inside it, about `reference_m`.
pub fn mass_integrals(piece: &Piece, base_m: f64, top_m: f64, reference_m: f64) -> MassIntegrals {
    let mut sum = MassIntegrals::default();
    integrate_masses(piece, base_m, top_m, |z, weight, masses| {
        let arm = z - reference_m;
        let own = weight * masses.mass_kg_per_m;
        let mass = own + weight * masses.water_kg_per_m;
        sum.mass_kg += own;
        sum.structural_moment_kg_m += own * arm;
        sum.moment_about_base_kg_m += own * (z - base_m);
        sum.transverse_kg += mass;
        sum.first_moment_kg_m += mass * arm;
        sum.second_moment_kg_m2 += mass * arm * arm;
        sum.rotary_inertia_kg_m2 = sum
            .rotary_inertia_kg_m2
            .zip(masses.rotary_inertia_kg_m, |sum, rotary| {
                sum + weight * rotary
            });
        sum.polar_inertia_kg_m2 += weight * masses.polar_inertia_kg_m;
    });
    sum
}

/// The mass of `piece` between two heights (m) inside it, kg, and its moment about `reference_m`,
/// kg m, without the masses that have no weight in [`mass_integrals`].
pub(crate) fn weight_integrals(
    piece: &Piece,
    base_m: f64,
    top_m: f64,
    reference_m: f64,
) -> (f64, f64) {
    let (mut mass_kg, mut moment_kg_m) = (0.0, 0.0);
    integrate_masses(piece, base_m, top_m, |z, weight, masses| {
        let own = weight * masses.mass_kg_per_m;
        mass_kg += own;
        moment_kg_m += own * (z - reference_m);
    });
    (mass_kg, moment_kg_m)
}

/// Calls `add` with each point of the quadrature of [`mass_integrals`], its weight (m) and masses.
pub(crate) fn for_each_mass_point(
    piece: &Piece,
    base_m: f64,
    top_m: f64,
    add: impl FnMut(f64, f64, &SectionMasses),
) {
    integrate_masses(piece, base_m, top_m, add);
}

/// Calls `add` with each point of the quadrature of [`compliance`], its weight (m) and section.
pub(crate) fn for_each_flexible_point(
    piece: &Piece,
    base_m: f64,
    top_m: f64,
    mut add: impl FnMut(f64, f64, &Section),
) {
    integrate(piece, base_m, top_m, &mut add);
}

/// Calls `add` with each point of the quadrature, its weight (m) and masses.
#[inline(always)]
fn integrate_masses(
    piece: &Piece,
    base_m: f64,
    top_m: f64,
    mut add: impl FnMut(f64, f64, &SectionMasses),
) {
    let (middle, half) = (0.5 * (base_m + top_m), 0.5 * (top_m - base_m));
    for (node, weight) in GAUSS_3 {
        let z = middle + half * node;
        add(z, weight * half, &piece.masses_at(z));
    }
}

impl MassIntegrals {
    /// As the inertia of a rigid body about the reference, with or without the sections' rotary
    /// inertia in bending.
    #[inline]
    pub fn axisymmetric(&self, rotary_inertia: bool) -> Axisymmetric {
        Axisymmetric {
            bending: self.rotary_inertia_kg_m2.map(|rotary| {
                let rotary = if rotary_inertia { rotary } else { 0.0 };
                let second = self.second_moment_kg_m2 + rotary;
                [self.transverse_kg, self.first_moment_kg_m, second]
            }),
            torsion: self.polar_inertia_kg_m2,
            axial: self.mass_kg,
        }
    }
}

/// What soil springs do to `piece` between two heights (m) inside it, as a rigid body about
/// `reference_m`: ∫ k dz, ∫ k (z − z₀) dz and ∫ (k (z − z₀)² + k_r) dz in each plane, ∫ k_t dz,
/// ∫ k_z dz.
/// None if there is no soil.
pub fn soil_integrals(
    piece: &Piece,
    base_m: f64,
    top_m: f64,
    reference_m: f64,
) -> Option<Axisymmetric> {
    piece.environment.soil?;
    let (middle, half) = (0.5 * (base_m + top_m), 0.5 * (top_m - base_m));
    let mut sum = Axisymmetric::default();
    // Linear springs times a quadratic function: three points are exact.
    for (node, weight) in GAUSS_3 {
        let z = middle + half * node;
        let (arm, weight) = (z - reference_m, weight * half);
        let soil = piece.soil_at(z);
        sum.bending = sum.bending.zip(soil.transverse(), |[a, b, c], k| {
            let k = weight * k;
            [a + k, b + k * arm, c + k * arm * arm]
        });
        sum.bending = sum
            .bending
            .zip(soil.rotation(), |[a, b, c], k| [a, b, c + weight * k]);
        sum.axial += weight * soil.z_n_per_m2;
        sum.torsion += weight * soil.torsion_n;
    }
    Some(sum)
}

/// Moments of 1/EI of one plane about the middle of a part: the centre of flexibility is near it,
/// so nothing cancels.
#[derive(Default)]
struct Moments {
    zeroth: f64,
    first: f64,
    second: f64,
    shear: f64,
}

impl Moments {
    #[inline]
    fn add(&mut self, section: &Section, plane: Plane, arm: f64, weight: f64) {
        let bending = weight / section.bending_n_m2.of(plane);
        self.zeroth += bending;
        self.first += bending * arm;
        self.second += bending * arm * arm;
        self.shear += weight * section.shear_flexibility_per_n.of(plane);
    }

    /// The compliance of the part between two heights (m).
    fn compliance(&self, base_m: f64, top_m: f64) -> BendingCompliance {
        let middle = 0.5 * (base_m + top_m);
        let offset = self.first / self.zeroth;
        // If the part is so short that no floating-point number lies between its ends, the result
        // would be only rounding.
        let elastic_centre_m = if offset.is_finite() {
            (middle + offset).clamp(base_m, top_m)
        } else {
            middle
        };
        let deflection = self.second - self.first * (elastic_centre_m - middle);
        BendingCompliance {
            bending_per_n_m: self.zeroth,
            elastic_centre_m,
            deflection_m_per_n: deflection.max(0.0),
            shear_m_per_n: self.shear,
        }
    }
}

/// The compliance integrals of `piece` between two heights (m) inside it.
pub fn compliance(piece: &Piece, base_m: f64, top_m: f64) -> Compliance {
    let middle = 0.5 * (base_m + top_m);
    let planes_differ = !piece.stiff_planes_are_equal();
    let (mut fore_aft, mut side_side) = (Moments::default(), Moments::default());
    let (mut axial_m_per_n, mut torsion_per_n_m) = (0.0, 0.0);
    integrate(piece, base_m, top_m, &mut |z, weight, section| {
        let arm = z - middle;
        fore_aft.add(section, Plane::ForeAft, arm, weight);
        if planes_differ {
            side_side.add(section, Plane::SideSide, arm, weight);
        }
        axial_m_per_n += weight / section.axial_n;
        torsion_per_n_m += weight / section.torsion_n_m2;
    });
    let mut bending = Planes::both(fore_aft.compliance(base_m, top_m));
    if planes_differ {
        bending.side_side = side_side.compliance(base_m, top_m);
    }
    Compliance {
        bending,
        axial_m_per_n,
        torsion_per_n_m,
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

/// The two-point Gauss rule of the measure dz/EI of one plane, over a part of `piece` whose
/// [`compliance`] there is `whole`, lower point first: two hinges that give the same end rotations
/// and deflections under end forces and moments, and under any load that varies no faster than
/// linearly, as the beam itself.
///
/// With mₖ = ∫ xᵏ dz/EI about the centre of flexibility (m₁ = 0) the points are the roots of x² −
/// (m₃/m₂) x − m₂/m₀, the weights m₀ x₂/(x₂ − x₁) and −m₀ x₁/(x₂ − x₁) (Golub & Welsch 1969). For a
/// prismatic part: (1 ∓ 1/√3)/2 of the length, half each.
pub fn gauss_hinges(
    piece: &Piece,
    base_m: f64,
    top_m: f64,
    plane: Plane,
    whole: &BendingCompliance,
) -> [Hinge; 2] {
    let (centre, m0) = (whole.elastic_centre_m, whole.bending_per_n_m);
    let (m2, mut m3) = (whole.deflection_m_per_n, 0.0);
    integrate(piece, base_m, top_m, &mut |z, weight, section| {
        m3 += weight / section.bending_n_m2.of(plane) * (z - centre).powi(3);
    });
    let hinge = |offset: f64, share: f64| Hinge {
        height_m: (centre + offset).clamp(base_m, top_m),
        bending_per_n_m: m0 * share,
    };
    let (half_sum, product) = (0.5 * m3 / m2, -m2 / m0);
    let root = (half_sum * half_sum - product).sqrt();
    let (lower, upper) = (half_sum - root, half_sum + root);
    if upper.partial_cmp(&lower) != Some(std::cmp::Ordering::Greater) {
        // If no floating-point number lies between the ends: both hinges are at the centre.
        return [hinge(0.0, 0.5), hinge(0.0, 0.5)];
    }
    let lower_share = upper / (upper - lower);
    [hinge(lower, lower_share), hinge(upper, 1.0 - lower_share)]
}

/// Calls `add` with each point of a quadrature, its weight (m) and section: five Gauss points per
/// panel, with so many panels that no dimension changes by 10 % or more over a panel.
#[inline]
fn integrate(piece: &Piece, base_m: f64, top_m: f64, add: &mut impl FnMut(f64, f64, &Section)) {
    if !piece.is_steeper(base_m, top_m, STEEPEST) {
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

/// Halves panels until no dimension changes too much, or no floating-point number lies between the
/// ends.
#[cold]
fn integrate_steep(
    piece: &Piece,
    base_m: f64,
    top_m: f64,
    add: &mut dyn FnMut(f64, f64, &Section),
) {
    let middle = 0.5 * (base_m + top_m);
    let divisible = base_m < middle && middle < top_m;
    if divisible && piece.is_steeper(base_m, top_m, STEEPEST) {
        integrate_steep(piece, base_m, middle, add);
        integrate_steep(piece, middle, top_m, add);
    } else {
        integrate_panel(piece, base_m, top_m, add);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tower::{Material, Profile, Shear, Tube};

    fn cone(top_diameter_m: f64) -> Piece {
        let rod = |d: f64| Tube {
            outer_diameter_m: d,
            wall_thickness_m: d / 2.0,
        };
        Piece {
            base_m: 0.0,
            top_m: 10.0,
            profile: Profile::Tube {
                base: rod(2.0),
                top: rod(top_diameter_m),
                material: Material::from_shear_modulus(1.0, 1.0, 0.4),
                shear: Shear::Rigid,
            },
            environment: crate::tower::Environment::default(),
        }
    }

    fn bending(piece: &Piece, base_m: f64, top_m: f64) -> BendingCompliance {
        compliance(piece, base_m, top_m).bending.fore_aft
    }

    #[test]
    fn solid_cone_has_its_closed_form_integrals() {
        // d = 2 − z/10, I = π d⁴/64: ∫dz/EI = 640/(3π) (1 − 1/8); mass of a frustum π h (R² + Rr +
        // r²)/3.
        let pi = std::f64::consts::PI;
        let c = bending(&cone(1.0), 0.0, 10.0);
        let exact = 640.0 / (3.0 * pi) * (1.0 - 1.0 / 8.0);
        assert!((c.bending_per_n_m / exact - 1.0).abs() < 1e-14);
        let m = mass_integrals(&cone(1.0), 0.0, 10.0, 0.0);
        let exact = pi * 10.0 * (1.0 + 0.5 + 0.25) / 3.0;
        assert!((m.mass_kg / exact - 1.0).abs() < 1e-14);
    }

    #[test]
    fn hinges_are_a_gauss_rule_exact_to_the_third_power() {
        let piece = cone(1.0);
        let rule_of = |piece: &Piece| {
            let whole = bending(piece, 0.0, 10.0);
            gauss_hinges(piece, 0.0, 10.0, Plane::ForeAft, &whole)
        };
        let hinges = rule_of(&piece);
        for power in 0..4 {
            let (mut exact, rule) = (
                0.0,
                hinges.map(|h| h.bending_per_n_m * h.height_m.powi(power)),
            );
            integrate(&piece, 0.0, 10.0, &mut |z, weight, section| {
                exact += weight / section.bending_n_m2.fore_aft * z.powi(power);
            });
            assert!(
                ((rule[0] + rule[1]) / exact - 1.0).abs() < 1e-13,
                "power {power}"
            );
        }
        let [lower, upper] = rule_of(&cone(2.0));
        let offset = 5.0 / 3.0_f64.sqrt();
        assert!((lower.height_m - (5.0 - offset)).abs() < 1e-13);
        assert!((upper.height_m - (5.0 + offset)).abs() < 1e-13);
        assert!((lower.bending_per_n_m / upper.bending_per_n_m - 1.0).abs() < 1e-13);
    }

    #[test]
    fn integrals_over_parts_add_up() {
        let piece = cone(1.0);
        let whole = bending(&piece, 0.0, 10.0);
        let (a, b) = (bending(&piece, 0.0, 3.7), bending(&piece, 3.7, 10.0));
        let sum = a.bending_per_n_m + b.bending_per_n_m;
        assert!((sum / whole.bending_per_n_m - 1.0).abs() < 1e-14);
        // Steiner: the parts' own deflections plus their distances from the common centre.
        let steiner = |c: &BendingCompliance| {
            let arm = c.elastic_centre_m - whole.elastic_centre_m;
            c.deflection_m_per_n + arm * arm * c.bending_per_n_m
        };
        let sum = steiner(&a) + steiner(&b);
        assert!((sum / whole.deflection_m_per_n - 1.0).abs() < 1e-13);
    }
}

//! A pile on springs k(z) that grow with a power of the depth, exactly.

use super::super::parts::foundation_springs::FoundationSprings;
use super::common::{TORSION, VERTICAL, at, deep, error};
use super::form::{Buried, ClosedForm, FormKind};
use super::head::HeadStiffness;
use super::pile_tube::PileTube;
use super::poulos_davis::Pile;
use super::soil_spring::SoilSpring;
use crate::inputs::{Input, Inputs, Limit, names};
use crate::space::SpatialMatrix;
use crate::tower::error::{Problem, TowerError};
use crate::tower::warning::Warning;

/// Over a depth of this reduced length ∫ (k/EI)^(1/4) dz the motion dies out to below the rounding
/// of doubles: exp(−√2 × 26) is 1e-16. Longer piles have the stiffness of this one.
const LONGEST: f64 = 26.0;
/// Limit of the number of terms of the series; the longest pile needs fewer.
const MOST_TERMS: usize = 200;

/// A pile below the base of the tower, which stands at the surface of the soil, on springs
/// k(z) = k_D (z/D)^m per metre of pile, with a free tip.
///
/// [`head`](Self::head) is the stiffness of the elastic beam on these springs, exact for any length
/// or by Poulos & Davis; the inertia of the pile and its shear deformation are neglected.
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
pub struct WinklerPile {
    /// The pile.
    #[inputs]
    pub tube: PileTube,
    /// The formula for its head stiffness.
    #[input(Input::choice("formula", "the formula").optional().quiet().note("exact or poulos-davis"))]
    pub formula: BeamFormula,
    /// Spring k_D at the depth of one diameter, per metre of pile, or the modulus of the soil that
    /// it follows from.
    #[inputs]
    pub soil_spring: SoilSpring,
    /// Exponent of the depth in the spring, or in the modulus that the spring follows from: 0 for
    /// constant, 1 for linear growth.
    #[input(Input::new(
        "exponent",
        "",
        Limit::Within([0.0, 4.0]),
        "the exponent of the depth in the soil spring, or in the modulus of the soil",
    )
    .note("of the depth in the spring or the modulus: 0 constant, 1 linear")
    .hint("of the depth: 0 for constant springs or modulus, 1 for linear growth"))]
    pub exponent: f64,
    /// Stiffness against translation in z, N/m; infinite: rigid.
    #[input(VERTICAL)]
    pub vertical_n_per_m: f64,
    /// Stiffness against rotation about z, N m; infinite: rigid.
    #[input(TORSION)]
    pub torsion_n_m: f64,
}

/// A formula for the head stiffness of a pile on springs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BeamFormula {
    /// The exact solution of the differential equation of the beam.
    Exact,
    /// Poulos & Davis (1980): rigid or flexible piles on springs that are constant or grow
    /// linearly. Its constants are not checked against the original.
    PoulosDavis,
}

names!(BeamFormula: Exact = "exact", PoulosDavis = "poulos-davis");

impl BeamFormula {
    /// Authors and year, or "the exact solution".
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "the exact solution",
            Self::PoulosDavis => "Poulos & Davis (1980)",
        }
    }
}

impl WinklerPile {
    /// Spring k_D at the depth of one diameter, per metre of pile, N/m².
    pub fn spring_n_per_m2(&self) -> f64 {
        self.soil_spring.of(&self.tube)
    }

    /// The exponent m of the depth in the springs.
    pub fn spring_exponent(&self) -> f64 {
        self.soil_spring.exponent(self.exponent)
    }

    /// Limits of the reduced length by Poulos & Davis: a pile is rigid up to the first and flexible
    /// from the second: 1.5 and 2.5 for constant springs, 2 and 4 for springs that grow linearly.
    pub fn limits_of_poulos_davis(&self) -> [f64; 2] {
        self.of_poulos_davis().limits()
    }

    fn of_poulos_davis(&self) -> Pile {
        Pile {
            is_linear: self.spring_exponent() > 0.5,
            bending_n_m2: self.tube.bending_n_m2(),
            length_m: self.tube.embedded_length_m,
            per_m: self.per_m(),
        }
    }

    /// Reduced length η L with η = (n/EI)^(1/(4+m)), where k = n z^m is the spring per metre of
    /// pile.
    pub fn reduced_length(&self) -> f64 {
        self.per_m() * self.tube.embedded_length_m
    }

    /// η, 1/m.
    fn per_m(&self) -> f64 {
        let (d, m) = (self.tube.diameter_m, self.spring_exponent());
        // (k_D D^-m/EI)^(1/(4+m)), without the overflow of D^m.
        let of_one_diameter = self.spring_n_per_m2() * d.powi(4) / self.tube.bending_n_m2();
        of_one_diameter.powf(1.0 / (4.0 + m)) / d
    }

    /// The stiffness of the pile's head at the surface of the soil: K_L = c₁ EI η³,
    /// K_LR = −c₂ EI η², K_R = c₃ EI η.
    ///
    /// - Exact: the factors follow from the four power series that solve y⁗ + ξ^m y = 0 and from
    ///   moment and shear force zero at the tip.
    /// - Poulos & Davis, constant springs: c = √2, 1, √2 for flexible piles; springs that grow
    ///   linearly: c = 1.074, 0.99, 1.48. Rigid piles: c = λ^(m+1)/(m+1), λ^(m+2)/(m+2),
    ///   λ^(m+3)/(m+3) with λ = ηL. Between the limits the form with the smaller K_R − K_LR²/K_L.
    ///
    /// Source: Poulos & Davis, *Pile Foundation Analysis and Design* (1980).
    pub fn head(&self) -> HeadStiffness {
        match self.formula {
            BeamFormula::Exact => self.exact_head(),
            BeamFormula::PoulosDavis => self.of_poulos_davis().head(),
        }
    }

    fn exact_head(&self) -> HeadStiffness {
        let bending_n_m2 = self.tube.bending_n_m2();
        let eta = self.per_m();
        let [lateral, coupling, rocking] = factors(self.spring_exponent(), self.reduced_length());
        HeadStiffness {
            lateral_n_per_m: lateral * bending_n_m2 * eta.powi(3),
            coupling_n: -coupling * bending_n_m2 * eta * eta,
            rocking_n_m: rocking * bending_n_m2 * eta,
        }
    }

    /// The springs at the base of the tower.
    pub fn springs(&self) -> FoundationSprings {
        self.head().with(self.vertical_n_per_m, self.torsion_n_m)
    }
}

impl ClosedForm for WinklerPile {
    fn kind(&self) -> &'static FormKind {
        &FormKind {
            name: "winkler-pile",
            synonyms: "winkler winkler_pile",
            nature: "the stiffness of the pile follows from its springs soil_spring (z/D)^exponent",
            in_words: "pile on springs along its length",
            contains_soil: true,
            decisive_key: "type",
        }
    }

    fn stiffness(&self) -> SpatialMatrix {
        self.springs().matrix()
    }

    fn check(&self) -> Result<(), TowerError> {
        self.tube.check()?;
        let exponent = self.spring_exponent();
        if self.formula == BeamFormula::Exact || exponent == 0.0 || exponent == 1.0 {
            return Ok(());
        }
        let formula = self.formula.name();
        let problem = Problem::ExponentWithoutFormula { formula, exponent };
        error("exponent", problem)
    }

    fn doubt(&self, base_diameter_m: Option<f64>, warnings: &mut Vec<Warning>) {
        self.tube.doubt(base_diameter_m, warnings);
        let [rigid_at_most, flexible_at_least] = self.limits_of_poulos_davis();
        let length = self.reduced_length();
        let is_between = rigid_at_most < length && length < flexible_at_least;
        if self.formula == BeamFormula::PoulosDavis && is_between {
            warnings.push(Warning::BetweenRigidAndFlexible {
                site: at("embedded_length"),
                formula: self.formula.name(),
                measure: "its reduced length (n/EI)^(1/(4+m)) L on springs n z^m",
                length,
                rigid_at_most,
                flexible_at_least,
            });
        }
    }

    fn caption(&self) -> String {
        let formula = self.formula.name();
        format!("Pile on springs along its length, by {formula}")
    }

    fn assumption(&self) -> String {
        let stiffness = match self.formula {
            BeamFormula::Exact => "exact for the static beam without shear deformation".to_owned(),
            BeamFormula::PoulosDavis => format!("by {}", self.formula.name()),
        };
        let springs = self.soil_spring.formula_name();
        let springs = springs.map_or_else(String::new, |name| {
            format!("; the springs follow from Young's modulus of the soil by {name}")
        });
        format!(
            "The base is the head of an elastic pile on springs along its length, {stiffness}{springs}; damping and inertia of pile and soil are neglected."
        )
    }

    fn derived(&self) -> Vec<(&'static str, f64, usize)> {
        let spring = "soil spring at the depth of one diameter (N/m²)";
        let exponent = "exponent of the depth in the springs (−)";
        let mut derived = Vec::new();
        if self.soil_spring.formula_name().is_some() {
            derived.push((spring, self.spring_n_per_m2(), 5));
        }
        if self.spring_exponent() != self.exponent {
            derived.push((exponent, self.spring_exponent(), 5));
        }
        derived.push(("reduced length ηL (−)", self.reduced_length(), 4));
        derived
    }

    fn neglects_shear_of_short_pile(&self) -> bool {
        true
    }

    fn buried(&self) -> Buried {
        deep("pile", self.tube.diameter_m, self.tube.embedded_length_m)
    }
}

/// c₁, c₂, c₃ of a beam of the given reduced length.
fn factors(exponent: f64, length: f64) -> [f64; 3] {
    let power = 1.0 + 0.25 * exponent;
    let end = length.min((LONGEST * power).powf(1.0 / power));
    // y = Σ c_s φ_s; c_0 is the displacement of the head and c_1 its slope.
    let tip: [[f64; 2]; 4] = std::array::from_fn(|s| moment_and_shear(s, exponent, end));
    let determinant = tip[2][0] * tip[3][1] - tip[3][0] * tip[2][1];
    let second_and_third = |head: [f64; 2]| {
        let second = (tip[3][0] * head[1] - tip[3][1] * head[0]) / determinant;
        let third = (tip[2][1] * head[0] - tip[2][0] * head[1]) / determinant;
        [second, third]
    };
    let [curvature, shear] = second_and_third(tip[0]);
    let [turned, _] = second_and_third(tip[1]);
    // The force is y‴(0) = 6 c_3. Depth counts downward, so the rotation about y is minus the slope
    // and its moment is y″(0) = 2 c_2.
    [6.0 * shear, -2.0 * curvature, -2.0 * turned]
}

/// Second and third derivative at ξ of the solution that begins with ξ^s.
fn moment_and_shear(s: usize, exponent: f64, end: f64) -> [f64; 2] {
    let mut power = s as f64;
    let mut term = end.powi(s as i32);
    let step = end.powf(4.0 + exponent);
    let mut sums = [0.0; 2];
    for _ in 0..MOST_TERMS {
        let second = term * power * (power - 1.0) / (end * end);
        let third = second * (power - 2.0) / end;
        sums[0] += second;
        sums[1] += third;
        power += 4.0 + exponent;
        term *= -step / (power * (power - 1.0) * (power - 2.0) * (power - 3.0));
        let is_small = term.abs() * power.powi(3) < f64::EPSILON * (sums[1] * end.powi(3)).abs();
        if is_small && power > end {
            break;
        }
    }
    sums
}

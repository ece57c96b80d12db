//! A rigid rectangular footing on or in an elastic half-space.

use super::common::{
    COUPLED, EMBEDMENT, SOIL_POISSONS_RATIO, SOIL_SHEAR_MODULUS, against_tower, coupling_n,
    footing, outside,
};
use super::form::{Buried, ClosedForm, FormKind, SoilBelow};
use crate::inputs::{Input, Inputs, Quantity, names};
use crate::space::SpatialMatrix;
use crate::tower::error::TowerError;
use crate::tower::warning::Warning;

/// A footing deeper than this, as a fraction of half its shorter side, is no footing.
const MOST_EMBEDMENT: f64 = 2.0;

/// A rigid rectangular footing on or in an elastic half-space. The tower's base is at the underside
/// of the footing, at its centre.
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
pub struct RectangularFooting {
    /// The formula.
    #[input(Input::choice("formula", "the formula").note("gazetas or pais-kausel"))]
    pub formula: FootingFormula,
    /// Length of the side along x, m.
    #[input(Input::length("length_x", "the side along x")
        .note("side along x")
        .also("length_fore_aft lx side_x"))]
    pub length_x_m: f64,
    /// Length of the side along y, m.
    #[input(Input::length("length_y", "the side along y")
        .note("side along y")
        .also("length_side_side width breadth ly side_y"))]
    pub length_y_m: f64,
    /// Depth of embedment e, m: depth of the underside below the surface of the soil, which touches
    /// the sides over this depth.
    #[input(EMBEDMENT)]
    pub embedment_m: f64,
    /// Shear modulus G of the soil, Pa.
    #[input(SOIL_SHEAR_MODULUS)]
    pub shear_modulus_pa: f64,
    /// Poisson's ratio ν of the soil.
    #[input(SOIL_POISSONS_RATIO)]
    pub poissons_ratio: f64,
    /// Whether the embedment couples sliding and rocking.
    #[input(COUPLED)]
    pub is_coupled: bool,
}

/// A formula for rectangular footings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FootingFormula {
    /// Gazetas (1991). Torsion and coupling are not checked against the original.
    Gazetas,
    /// Pais & Kausel (1988). Torsion and coupling are not checked against the original.
    PaisKausel,
}

names!(FootingFormula: Gazetas = "gazetas", PaisKausel = "pais-kausel");

impl FootingFormula {
    /// Authors and year.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gazetas => "Gazetas (1991)",
            Self::PaisKausel => "Pais & Kausel (1988)",
        }
    }
}

/// The stiffness of a footing whose longer side is along "long".
struct Stiffness {
    along_long: f64,
    along_short: f64,
    vertical: f64,
    about_long: f64,
    about_short: f64,
    torsion: f64,
}

/// G, ν, half of the longer side, half of the shorter side, embedment.
struct Sizes {
    g: f64,
    nu: f64,
    long: f64,
    short: f64,
    e: f64,
}

impl RectangularFooting {
    /// Half of the shorter side, m.
    pub fn half_short_side_m(&self) -> f64 {
        0.5 * self.length_x_m.min(self.length_y_m)
    }

    /// The static stiffness about the centre of the underside: x, y, z, rotation about x, y, z in
    /// N/m, N, N m.
    ///
    /// L is half of the longer side and B half of the shorter one; I is the second moment of the
    /// area 2B × 2L about the axis of the rotation, J that about z.
    ///
    /// | | Gazetas, on the surface |
    /// |---|---|
    /// | vertical | 2GL/(1−ν) (0.73 + 1.54 (B/L)^0.75) |
    /// | along B | 2GL/(2−ν) (2 + 2.5 (B/L)^0.85) |
    /// | along L | that along B − 0.2GL/(0.75−ν) (1 − B/L) |
    /// | about L | G/(1−ν) I^0.75 (L/B)^0.25 (2.4 + 0.5B/L) |
    /// | about B | 3G/(1−ν) I^0.75 (L/B)^0.15 |
    /// | torsion | G J^0.75 (4 + 11 (1 − B/L)^10) |
    ///
    /// | | times, for embedment e |
    /// |---|---|
    /// | vertical | (1 + e/(21B) (1 + 1.3B/L)) (1 + 0.2 (A/(4BL))^(2/3)) |
    /// | along B | (1 + 0.15 √(e/B)) (1 + 0.52 (eA/(2BL²))^0.4) |
    /// | along L | (1 + 0.15 √(e/B)) (1 + 0.52 (eA/(2LB²))^0.4) |
    /// | about L | 1 + 1.26 e/B (1 + e/B √(B/L)) |
    /// | about B | 1 + 0.92 (e/B)^0.6 (1.5 + (e/L)^1.9) |
    /// | torsion | 1 + 1.4 (1 + B/L) (e/B)^0.9 |
    ///
    /// with A = 4e (B + L), the area of the sides.
    ///
    /// | | Pais & Kausel, r = L/B | times, for embedment e |
    /// |---|---|---|
    /// | vertical | GB/(1−ν) (3.1 r^0.75 + 1.6) | 1 + (0.25 + 0.25/r) (e/B)^0.8 |
    /// | along B | GB/(2−ν) (6.8 r^0.65 + 0.8 r + 1.6) | 1 + (0.33 + 1.34/(1 + r)) (e/B)^0.8 |
    /// | along L | GB/(2−ν) (6.8 r^0.65 + 2.4) | the same |
    /// | about L | GB³/(1−ν) (3.2 r + 0.8) | 1 + e/B + 1.6/(0.35 + r) (e/B)² |
    /// | about B | GB³/(1−ν) (3.73 r^2.4 + 0.27) | 1 + e/B + 1.6/(0.35 + r⁴) (e/B)² |
    /// | torsion | GB³ (4.25 r^2.45 + 4.06) | 1 + (1.3 + 1.32/r) (e/B)^0.9 |
    ///
    /// The coupling, if [`is_coupled`](Self::is_coupled), is e/3 times the lateral stiffness,
    /// positive in row 1, column 5: the sides are held above the underside.
    ///
    /// Sources: Gazetas in *Foundation Engineering Handbook* (1991), ch. 15; Pais & Kausel,
    /// *Soil Dyn. Earthq. Eng.* 7 (1988) 213–227. Torsion and coupling are not checked against the
    /// originals, the others against a published program.
    pub fn stiffness(&self) -> SpatialMatrix {
        let half = [0.5 * self.length_x_m, 0.5 * self.length_y_m];
        let is_long_in_x = half[0] >= half[1];
        let sizes = Sizes {
            g: self.shear_modulus_pa,
            nu: self.poissons_ratio,
            long: half[0].max(half[1]),
            short: half[0].min(half[1]),
            e: self.embedment_m,
        };
        let k = match self.formula {
            FootingFormula::Gazetas => gazetas(&sizes),
            FootingFormula::PaisKausel => pais_kausel(&sizes),
        };
        let ([x, y], [about_x, about_y]) = match is_long_in_x {
            true => ([k.along_long, k.along_short], [k.about_long, k.about_short]),
            false => ([k.along_short, k.along_long], [k.about_short, k.about_long]),
        };
        let mut matrix = SpatialMatrix::default();
        let diagonal = [x, y, k.vertical, about_x, about_y, k.torsion];
        for (i, value) in diagonal.into_iter().enumerate() {
            matrix[i][i] = value;
        }
        for (translation, rotation, sign) in [(0, 4, 1.0), (1, 3, -1.0)] {
            let lateral = matrix[translation][translation];
            let coupling = sign * coupling_n(self.is_coupled, self.embedment_m, lateral);
            matrix[translation][rotation] = coupling;
            matrix[rotation][translation] = coupling;
        }
        matrix
    }
}

impl ClosedForm for RectangularFooting {
    fn kind(&self) -> &'static FormKind {
        &FormKind {
            name: "rectangular-footing",
            synonyms: "rectangle rectangular rectangular_foundation raft",
            nature: "the stiffness of a rectangular footing follows from its sides and the soil",
            in_words: "rectangular footing on an elastic half-space",
            contains_soil: false,
            decisive_key: "embedment",
        }
    }

    fn stiffness(&self) -> SpatialMatrix {
        Self::stiffness(self)
    }

    fn check(&self) -> Result<(), TowerError> {
        Ok(())
    }

    fn doubt(&self, base_diameter_m: Option<f64>, warnings: &mut Vec<Warning>) {
        let half_m = self.half_short_side_m();
        let key = match self.length_x_m <= self.length_y_m {
            true => "length_x",
            false => "length_y",
        };
        warnings.extend(against_tower(
            Quantity::FootingSide,
            key,
            half_m,
            base_diameter_m,
        ));
        warnings.extend(outside(
            "embedment",
            self.formula.name(),
            "the embedment of the footing, divided by half of its shorter side,",
            self.embedment_m / half_m,
            [f64::NEG_INFINITY, MOST_EMBEDMENT],
            "check the unit (m), or use a type for caissons or piles",
        ));
    }

    fn caption(&self) -> String {
        format!("Rigid rectangular footing, by {}", self.formula.name())
    }

    fn assumption(&self) -> String {
        let coupled = if self.is_coupled {
            "coupled"
        } else {
            "uncoupled"
        };
        format!(
            "The base is a rigid rectangular footing on an elastic half-space, modelled by static, {coupled} springs ({}) without damping and soil mass.",
            self.formula.name()
        )
    }

    fn buried(&self) -> Buried {
        Buried {
            is_round: false,
            soil: Some(SoilBelow {
                thickness_m: f64::INFINITY,
                shear_modulus_pa: self.shear_modulus_pa,
                poissons_ratio: self.poissons_ratio,
            }),
            ..footing(
                [0.5 * self.length_x_m, 0.5 * self.length_y_m],
                self.embedment_m,
            )
        }
    }
}

fn gazetas(sizes: &Sizes) -> Stiffness {
    let &Sizes { g, nu, e, .. } = sizes;
    let (l, b) = (sizes.long, sizes.short);
    let (ratio, deep) = (b / l, e / b);
    let [about_long, about_short] = [(l, b), (b, l)].map(|(a, c)| 4.0 / 3.0 * a * c.powi(3));
    let along_short = 2.0 * g * l / (2.0 - nu) * (2.0 + 2.5 * ratio.powf(0.85));
    let along_long = along_short - 0.2 * g * l / (0.75 - nu) * (1.0 - ratio);
    let sides = 4.0 * e * (b + l);
    let held = |volume: f64| {
        let sides = 1.0 + 0.52 * (0.5 * e * sides / volume).powf(0.4);
        (1.0 + 0.15 * deep.sqrt()) * sides
    };
    Stiffness {
        along_long: along_long * held(l * b * b),
        along_short: along_short * held(b * l * l),
        vertical: 2.0 * g * l / (1.0 - nu)
            * (0.73 + 1.54 * ratio.powf(0.75))
            * (1.0 + deep / 21.0 * (1.0 + 1.3 * ratio))
            * (1.0 + 0.2 * (sides / (4.0 * b * l)).powf(2.0 / 3.0)),
        about_long: g / (1.0 - nu)
            * about_long.powf(0.75)
            * ratio.powf(-0.25)
            * (2.4 + 0.5 * ratio)
            * (1.0 + 1.26 * deep * (1.0 + deep * ratio.sqrt())),
        about_short: 3.0 * g / (1.0 - nu)
            * about_short.powf(0.75)
            * ratio.powf(-0.15)
            * (1.0 + 0.92 * deep.powf(0.6) * (1.5 + (e / l).powf(1.9))),
        torsion: g
            * (about_long + about_short).powf(0.75)
            * (4.0 + 11.0 * (1.0 - ratio).powi(10))
            * (1.0 + 1.4 * (1.0 + ratio) * deep.powf(0.9)),
    }
}

fn pais_kausel(sizes: &Sizes) -> Stiffness {
    let &Sizes { g, nu, e, .. } = sizes;
    let b = sizes.short;
    let (r, deep) = (sizes.long / b, e / b);
    let lateral = 6.8 * r.powf(0.65);
    let held = 1.0 + (0.33 + 1.34 / (1.0 + r)) * deep.powf(0.8);
    let rocking = |of_sides: f64| 1.0 + deep + 1.6 / (0.35 + of_sides) * deep * deep;
    let cube = g * b.powi(3);
    Stiffness {
        along_long: g * b / (2.0 - nu) * (lateral + 2.4) * held,
        along_short: g * b / (2.0 - nu) * (lateral + 0.8 * r + 1.6) * held,
        vertical: g * b / (1.0 - nu)
            * (3.1 * r.powf(0.75) + 1.6)
            * (1.0 + (0.25 + 0.25 / r) * deep.powf(0.8)),
        about_long: cube / (1.0 - nu) * (3.2 * r + 0.8) * rocking(r),
        about_short: cube / (1.0 - nu) * (3.73 * r.powf(2.4) + 0.27) * rocking(r.powi(4)),
        torsion: cube * (4.25 * r.powf(2.45) + 4.06) * (1.0 + (1.3 + 1.32 / r) * deep.powf(0.9)),
    }
}

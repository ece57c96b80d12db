//! A monopile in an elastic continuum.

use super::super::parts::foundation_springs::FoundationSprings;
use super::carter_kulhawy::carter_kulhawy;
use super::common::{
    SOIL_POISSONS_RATIO, SOIL_PROFILE, SOIL_YOUNGS_MODULUS, SoilProfile, TORSION, VERTICAL, at,
    deep, error, outside,
};
use super::flexible_pile::{en_1998_5, randolph};
use super::form::{Buried, ClosedForm, FormKind};
use super::head::HeadStiffness;
use super::pile_tube::PileTube;
use super::shadlou;
use crate::inputs::{Input, Inputs, names};
use crate::space::SpatialMatrix;
use crate::tower::error::{Problem, TowerError};
use crate::tower::warning::Warning;

/// A monopile below the base of the tower, which stands at the surface of the soil. Its head
/// stiffness follows from the pile and an elastic soil by a formula.
///
/// # Example
/// The monopile of the DTU 10 MW turbine in a homogeneous soil of 30 MPa.
/// ```
/// use towermodes::{Monopile, PileBehaviour, PileFormula, PileTube, SoilProfile};
///
/// let pile = Monopile {
///     tube: PileTube {
///         diameter_m: 9.0,
///         wall_thickness_m: 0.11,
///         embedded_length_m: 42.0,
///         youngs_modulus_pa: 2.1e11,
///     },
///     formula: PileFormula::ShadlouBhattacharya,
///     soil_profile: SoilProfile::Homogeneous,
///     soil_youngs_modulus_pa: 3e7,
///     soil_poissons_ratio: 0.25,
///     vertical_n_per_m: f64::INFINITY,
///     torsion_n_m: f64::INFINITY,
/// };
/// assert_eq!(pile.slenderness().behaviour(), PileBehaviour::Between);
/// let head = pile.head();
/// assert!((head.lateral_n_per_m / 1.31e9 - 1.0).abs() < 1e-3);
/// assert!((head.coupling_n / -18.7e9 - 1.0).abs() < 2e-3);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
pub struct Monopile {
    /// The formula for its head stiffness.
    #[input(Input::choice("formula", "the formula")
        .note("shadlou-bhattacharya, randolph, en-1998-5 or carter-kulhawy"))]
    pub formula: PileFormula,
    /// The pile.
    #[inputs]
    pub tube: PileTube,
    /// How Young's modulus of the soil grows with depth.
    #[input(SOIL_PROFILE)]
    pub soil_profile: SoilProfile,
    /// Young's modulus E_SO of the soil at the depth of one diameter, Pa.
    #[input(SOIL_YOUNGS_MODULUS)]
    pub soil_youngs_modulus_pa: f64,
    /// Poisson's ratio ν of the soil.
    #[input(SOIL_POISSONS_RATIO)]
    pub soil_poissons_ratio: f64,
    /// Stiffness against translation in z, N/m, which the formulas do not give; infinite: rigid.
    #[input(VERTICAL)]
    pub vertical_n_per_m: f64,
    /// Stiffness against rotation about z, N m, which the formulas do not give; infinite: rigid.
    #[input(TORSION)]
    pub torsion_n_m: f64,
}

/// A formula for the head stiffness of a pile in an elastic continuum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PileFormula {
    /// Shadlou & Bhattacharya (2016), rigid and flexible piles, as given by Yu & Amdahl (2023),
    /// table 1.
    ShadlouBhattacharya,
    /// Randolph (1981), flexible piles in homogeneous soil or in soil whose modulus grows with z.
    /// Its constants are not checked against the original.
    Randolph,
    /// EN 1998-5:2004, Annex C, flexible piles. Its constants are not checked against the original.
    En1998,
    /// Carter & Kulhawy (1992), rigid piles and sockets in homogeneous soil or rock. Its constants
    /// are not checked against the original.
    CarterKulhawy,
}

/// Length over diameter of a pile with the limits of rigid and flexible behaviour by Randolph
/// (1981), for the stiffness ratio E_pe/G*, G* = G (1 + 3ν/4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slenderness {
    /// Embedded length over diameter, L/D.
    pub ratio: f64,
    /// Largest L/D of a rigid pile, 0.05 √(E_pe/G*).
    pub rigid_at_most: f64,
    /// Smallest L/D of a flexible pile, (E_pe/G*)^(2/7).
    pub flexible_at_least: f64,
}

/// How a pile moves under loads at its head.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PileBehaviour {
    /// It bends near its head; the tip does not move.
    Flexible,
    /// It rotates as a rigid body.
    Rigid,
    /// Neither flexible nor rigid: the formulas for both overestimate the stiffness.
    Between,
}

impl Slenderness {
    /// The behaviour that follows from the ratio and its limits.
    pub fn behaviour(&self) -> PileBehaviour {
        if self.ratio >= self.flexible_at_least {
            PileBehaviour::Flexible
        } else if self.ratio <= self.rigid_at_most {
            PileBehaviour::Rigid
        } else {
            PileBehaviour::Between
        }
    }
}

names!(
    PileFormula:
    ShadlouBhattacharya = "shadlou-bhattacharya",
    Randolph = "randolph",
    En1998 = "en-1998-5",
    CarterKulhawy = "carter-kulhawy",
);

impl PileFormula {
    /// Authors and year, or number of the standard.
    pub fn name(self) -> &'static str {
        match self {
            Self::ShadlouBhattacharya => "Shadlou & Bhattacharya (2016)",
            Self::Randolph => "Randolph (1981)",
            Self::En1998 => "EN 1998-5, Annex C",
            Self::CarterKulhawy => "Carter & Kulhawy (1992)",
        }
    }

    /// Whether the formula covers a profile of the soil.
    pub fn has(self, profile: SoilProfile) -> bool {
        match self {
            Self::ShadlouBhattacharya | Self::En1998 => true,
            Self::Randolph => profile != SoilProfile::Parabolic,
            Self::CarterKulhawy => profile == SoilProfile::Homogeneous,
        }
    }
}

impl Monopile {
    /// Its length over its diameter, with the limits of rigid and flexible behaviour.
    pub fn slenderness(&self) -> Slenderness {
        let ratio = self.tube.solid_modulus_pa() / self.soil_g_star_pa();
        Slenderness {
            ratio: self.tube.slenderness(),
            rigid_at_most: 0.05 * ratio.sqrt(),
            flexible_at_least: ratio.powf(2.0 / 7.0),
        }
    }

    /// G* = G (1 + 3ν/4) of the soil at the depth of one diameter, Pa.
    fn soil_g_star_pa(&self) -> f64 {
        let nu = self.soil_poissons_ratio;
        self.soil_youngs_modulus_pa / (2.0 * (1.0 + nu)) * (1.0 + 0.75 * nu)
    }

    /// The form of Shadlou & Bhattacharya that is used: flexible or rigid by the slenderness; in
    /// between the one with the smaller moment per rotation of a head that is free to move
    /// sideways, because each neglects one part of the motion and both are upper bounds.
    pub fn form(&self) -> PileBehaviour {
        match self.slenderness().behaviour() {
            PileBehaviour::Between => {
                let free = |form| self.shadlou(form).free_rocking_n_m();
                match free(PileBehaviour::Rigid) < free(PileBehaviour::Flexible) {
                    true => PileBehaviour::Rigid,
                    false => PileBehaviour::Flexible,
                }
            }
            clear => clear,
        }
    }

    /// The stiffness of the pile's head at the surface of the soil, by its formula.
    ///
    /// - Shadlou & Bhattacharya: K_L = f E_SO R a x^b, K_LR = −f E_SO R² a x^b, K_R = f E_SO R³ a
    ///   x^b with f = 1 + 0.6 abs(ν − 0.25); x is E_pe/E_SO for a flexible pile and L/D for a rigid
    ///   one.
    /// - Randolph: u = q (0.27 H/h + 0.30 M/h²), θ = q (0.30 H/h² + 0.80 √ρ_c M/h³), inverted, with
    ///   q = (E_pe/G_c)^(1/7)/(ρ_c G_c), h = l_c/2, l_c = D (E_pe/G_c)^(2/7), G_c the mean of G*
    ///   over l_c and ρ_c = G*(l_c/4)/G*(l_c/2).
    /// - EN 1998-5: K_L = a D E_SO x^b, K_LR = −a D² E_SO x^b, K_R = a D³ E_SO x^b with
    ///   x = E_pe/E_SO.
    /// - Carter & Kulhawy: u = 0.4 H/(G*D) x^(−1/3) + 0.3 M/(G*D²) x^(−7/8), θ = 0.3 H/(G*D²)
    ///   x^(−7/8) + 0.8 M/(G*D³) x^(−5/3), inverted, with x = 2L/D.
    ///
    /// Sources: Shadlou & Bhattacharya, *Soil Dyn. Earthq. Eng.* 88 (2016) 15–32, in the form of Yu
    /// & Amdahl, *Mar. Struct.* 92 (2023) 103482; Randolph, *Géotechnique* 31 (1981) 247–259;
    /// EN 1998-5:2004; Carter & Kulhawy, *J. Geotech. Eng.* 118 (1992) 839–855.
    pub fn head(&self) -> HeadStiffness {
        match self.formula {
            PileFormula::ShadlouBhattacharya => self.shadlou(self.form()),
            PileFormula::Randolph => randolph(&self.tube, self.soil_g_star_pa(), self.soil_profile),
            PileFormula::En1998 => {
                en_1998_5(&self.tube, self.soil_youngs_modulus_pa, self.soil_profile)
            }
            PileFormula::CarterKulhawy => carter_kulhawy(&self.tube, self.soil_g_star_pa()),
        }
    }

    /// Shadlou & Bhattacharya's stiffness of a flexible or a rigid pile.
    fn shadlou(&self, form: PileBehaviour) -> HeadStiffness {
        let modulus_pa = self.soil_youngs_modulus_pa;
        let soil = shadlou::Soil {
            profile: self.soil_profile,
            modulus_pa,
            poissons_ratio: self.soil_poissons_ratio,
        };
        match form {
            PileBehaviour::Rigid => shadlou::rigid(&self.tube, &soil),
            PileBehaviour::Flexible | PileBehaviour::Between => {
                shadlou::flexible(&self.tube, &soil)
            }
        }
    }

    /// The springs at the base of the tower.
    pub fn springs(&self) -> FoundationSprings {
        self.head().with(self.vertical_n_per_m, self.torsion_n_m)
    }
}

impl ClosedForm for Monopile {
    fn kind(&self) -> &'static FormKind {
        &FormKind {
            name: "monopile",
            synonyms: "pile mono_pile",
            nature: "the stiffness of a monopile follows from the pile and the elastic soil",
            in_words: "monopile in elastic soil, by a formula",
            contains_soil: true,
            decisive_key: "formula",
        }
    }

    fn stiffness(&self) -> SpatialMatrix {
        self.springs().matrix()
    }

    fn check(&self) -> Result<(), TowerError> {
        self.tube.check()?;
        if self.formula.has(self.soil_profile) {
            return Ok(());
        }
        let formula = self.formula.name();
        error("soil_profile", Problem::ProfileWithoutFormula { formula })
    }

    fn doubt(&self, base_diameter_m: Option<f64>, warnings: &mut Vec<Warning>) {
        self.tube.doubt(base_diameter_m, warnings);
        warnings.extend(self.outside_formula());
    }

    fn caption(&self) -> String {
        format!("Monopile in elastic soil, by {}", self.formula.name())
    }

    fn assumption(&self) -> String {
        format!(
            "The base is the head of a monopile in elastic soil; its static stiffness follows from {}, without damping and inertia of pile and soil.",
            self.formula.name()
        )
    }

    fn derived(&self) -> Vec<(&'static str, f64, usize)> {
        let slenderness = self.slenderness();
        vec![
            ("length/diameter (−)", slenderness.ratio, 4),
            ("rigid up to (−)", slenderness.rigid_at_most, 4),
            ("flexible from (−)", slenderness.flexible_at_least, 4),
        ]
    }

    fn buried(&self) -> Buried {
        deep("pile", self.tube.diameter_m, self.tube.embedded_length_m)
    }
}

impl Monopile {
    /// A warning of a pile for which its formula was not derived.
    fn outside_formula(&self) -> Option<Warning> {
        let Slenderness {
            ratio,
            rigid_at_most,
            flexible_at_least,
        } = self.slenderness();
        let (key, formula) = ("embedded_length", self.formula.name());
        let quantity = "the embedded length of the pile, divided by its diameter,";
        let softer = "a shorter pile is softer: model the pile by stations down to its tip with soil in layers ([ground])";
        let bends = "a longer pile bends: use type = \"winkler-pile\" or [[soil]] along the pile";
        match self.formula {
            PileFormula::ShadlouBhattacharya => {
                let is_between = self.slenderness().behaviour() == PileBehaviour::Between;
                is_between.then_some(Warning::BetweenRigidAndFlexible {
                    site: at(key),
                    formula,
                    measure: "its embedded length divided by its diameter",
                    length: ratio,
                    rigid_at_most,
                    flexible_at_least,
                })
            }
            PileFormula::Randolph | PileFormula::En1998 => {
                let range = [flexible_at_least, f64::INFINITY];
                outside(key, formula, quantity, ratio, range, softer)
            }
            PileFormula::CarterKulhawy => {
                let range = [f64::NEG_INFINITY, rigid_at_most];
                outside(key, formula, quantity, ratio, range, bends)
            }
        }
    }
}

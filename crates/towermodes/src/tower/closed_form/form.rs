//! The common interface of the foundations by closed form; the facts about each kind are in its own
//! file.

use std::fmt;

use crate::inputs::Inputs;
use crate::space::SpatialMatrix;
use crate::tower::error::TowerError;
use crate::tower::warning::Warning;

/// A foundation whose stiffness follows by a closed form from its dimensions and the soil.
///
/// A new kind is a file with a struct and this trait, a variant of
/// [`Foundation`](crate::Foundation), and its name in the list below that enum. The reader, the
/// writer and the schema of the tower file, the names of its numbers, checks, warnings, reports
/// and pictures follow.
pub trait ClosedForm: Inputs + fmt::Debug {
    /// The facts about its kind.
    fn kind(&self) -> &'static FormKind;

    /// The stiffness about the base for the motion (x, y, z, rotation about x, y, z), N/m, N, N m;
    /// infinite on the diagonal for a motion that is rigidly held.
    fn stiffness(&self) -> SpatialMatrix;

    /// Checks relations between two or more values; the limits of single values are checked
    /// elsewhere.
    ///
    /// # Errors
    /// [`TowerError`] at one of the values.
    fn check(&self) -> Result<(), TowerError>;

    /// Warns of dimensions that do not suit each other or a tower whose base has a diameter (m),
    /// and of values for which the formula was not derived. Single values have their usual range.
    fn doubt(&self, base_diameter_m: Option<f64>, warnings: &mut Vec<Warning>);

    /// The head of its table in a report, with the formula.
    fn caption(&self) -> String;

    /// What the formula assumes, in sentences.
    fn assumption(&self) -> String;

    /// Numbers that follow from its values, with their names and significant digits.
    fn derived(&self) -> Vec<(&'static str, f64, usize)> {
        Vec::new()
    }

    /// Whether it describes short piles too, and neglects their shear deformation.
    fn neglects_shear_of_short_pile(&self) -> bool {
        false
    }

    /// Its outline in the soil, for pictures.
    fn buried(&self) -> Buried;
}

/// The names and properties of a kind of foundation.
#[derive(Debug)]
pub struct FormKind {
    /// Its name in the tower file.
    pub name: &'static str,
    /// Other names of it, separated by blanks.
    pub synonyms: &'static str,
    /// Where its stiffness comes from, for hints on keys of other kinds.
    pub nature: &'static str,
    /// The foundation and its soil in a few words.
    pub in_words: &'static str,
    /// Whether its stiffness includes the soil around it, as for a pile or a caisson.
    pub contains_soil: bool,
    /// The key at which a warning about an implausible stiffness is shown.
    pub decisive_key: &'static str,
}

/// What is below the base, for pictures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Buried {
    /// What it is: "footing".
    pub noun: &'static str,
    /// Half of its extent in x and y, m.
    pub half_m: [f64; 2],
    /// Depth of its underside below the surface of the soil, m.
    pub depth_m: f64,
    /// Whether its outline is a circle.
    pub is_round: bool,
    /// Whether it is deep: a pile or a caisson, and not a footing.
    pub is_deep: bool,
    /// The elastic soil below a footing.
    pub soil: Option<SoilBelow>,
}

impl Buried {
    /// Height of the surface of the soil above the base of the tower, m: the base is at the
    /// underside of a footing, and at the head of a pile or a caisson.
    pub fn surface_above_base_m(&self) -> f64 {
        if self.is_deep { 0.0 } else { self.depth_m }
    }
}

/// The elastic soil below a footing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoilBelow {
    /// Thickness of the stratum, m; infinite for a half-space.
    pub thickness_m: f64,
    /// Shear modulus G, Pa.
    pub shear_modulus_pa: f64,
    /// Poisson's ratio ν.
    pub poissons_ratio: f64,
}

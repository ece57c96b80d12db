//! The distribution of the energy of a mode over the parts of the tower.

/// The fractions of a mode's strain and kinetic energy in the parts of the tower; each of the two
/// sums to 1. [`Options::energy_parts`](crate::Options::energy_parts) requests them.
///
/// The fraction of the strain energy in a part is d(ln λ)/d(ln k), with λ = (2πf)² and k a factor
/// of the part's stiffness; the fraction of the kinetic energy is −d(ln λ)/d(ln m), with m a factor
/// of its mass (Rayleigh's quotient; Hellmann 1937, Feynman 1939).
///
/// # Example A tower on a rocking spring: the fractions of tower and spring sum to 1.
/// ```
/// use towermodes::{Foundation, FoundationSprings, Material, Options, Rna, Station};
/// use towermodes::{Tower, TowerDescription, solve};
///
/// let tower = Tower::new(TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     foundation: Foundation::Springs(FoundationSprings {
///         rocking_n_m: 5e10,
///         ..FoundationSprings::RIGID
///     }),
///     ..TowerDescription::default()
/// })?;
/// let options = Options { energy_parts: true, ..Options::default() };
/// let solution = solve(&tower, &options)?;
/// let parts = solution.modes[0].energy_parts.as_ref().expect("requested");
/// let (steel, spring) = (parts.strain.materials[0], parts.strain.foundation);
/// assert!((steel + spring - 1.0).abs() < 1e-12);
/// assert!((spring - 0.18567).abs() < 1e-4, "{spring}");
/// assert!(parts.kinetic.rna > parts.kinetic.tower);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct EnergyParts {
    /// Strain energy.
    pub strain: StrainParts,
    /// Kinetic energy.
    pub kinetic: KineticParts,
}

/// The fractions of the strain energy, which sum to 1; all zero for a motion that nothing resists.
///
/// Self-weight lowers the energy, so its fraction is negative and the others sum to more than 1.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct StrainParts {
    /// Of the tower itself in each material, in the order of the materials of the description; one
    /// value for a table of properties.
    pub materials: Vec<f64>,
    /// Of the members of a substructure.
    pub substructure: f64,
    /// Of the foundation: springs, stiffness matrix, supports of a substructure; of a floating
    /// platform the buoyancy and the water plane.
    pub foundation: f64,
    /// Of the moorings.
    pub moorings: f64,
    /// Of the soil springs along the tower and along the piles of a substructure.
    pub soil: f64,
    /// Of the guy wires.
    pub wires: f64,
    /// Of self-weight; negative where it lowers the frequency.
    pub gravity: f64,
}

/// The fractions of the kinetic energy, which sum to 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct KineticParts {
    /// Of the tower itself, with its outfitting.
    pub tower: f64,
    /// Of the rotor-nacelle assembly.
    pub rna: f64,
    /// Of the point masses.
    pub point_masses: f64,
    /// Of the members of a substructure themselves, with the masses on its joints.
    pub substructure: f64,
    /// Of the marine growth on members.
    pub growth: f64,
    /// Of the water, or of another filling, inside members.
    pub filling: f64,
    /// Of the water around and inside the tower, of the tables of added mass, and of the water
    /// around members and around a floating platform.
    pub water: f64,
    /// Of the masses that move with the base: the inertia of the foundation or of supports, a
    /// floating platform with its ballast, a transition piece.
    pub foundation: f64,
}

/// A sum of energies below this fraction of their absolute sum is rounding.
const ROUNDING: f64 = 1e-9;

impl StrainParts {
    /// The fraction in the tower itself.
    pub fn tower(&self) -> f64 {
        self.materials.iter().sum()
    }

    /// Turns energies into fractions.
    pub(crate) fn into_fractions(mut self) -> Self {
        let others = [
            self.substructure,
            self.foundation,
            self.moorings,
            self.soil,
            self.wires,
            self.gravity,
        ];
        let all = self.materials.iter().chain(&others);
        let factor = one_over_sum(all);
        self.materials.iter_mut().for_each(|value| *value *= factor);
        Self {
            materials: self.materials,
            substructure: self.substructure * factor,
            foundation: self.foundation * factor,
            moorings: self.moorings * factor,
            soil: self.soil * factor,
            wires: self.wires * factor,
            gravity: self.gravity * factor,
        }
    }
}

impl KineticParts {
    /// Turns energies into fractions.
    pub(crate) fn into_fractions(self) -> Self {
        let Self {
            tower,
            rna,
            point_masses,
            substructure,
            growth,
            filling,
            water,
            foundation,
        } = self;
        let on_tower = [tower, rna, point_masses];
        let below = [substructure, growth, filling, water, foundation];
        let factor = one_over_sum(on_tower.iter().chain(&below));
        Self {
            tower: tower * factor,
            rna: rna * factor,
            point_masses: point_masses * factor,
            substructure: substructure * factor,
            growth: growth * factor,
            filling: filling * factor,
            water: water * factor,
            foundation: foundation * factor,
        }
    }
}

/// 1/Σ, or 0 if the sum is zero except for rounding.
fn one_over_sum<'a>(values: impl Iterator<Item = &'a f64> + Clone) -> f64 {
    let sum: f64 = values.clone().sum();
    let size: f64 = values.map(|value| value.abs()).sum();
    match sum > ROUNDING * size && sum.is_normal() {
        true => 1.0 / sum,
        false => 0.0,
    }
}

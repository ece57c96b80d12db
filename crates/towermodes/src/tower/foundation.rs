//! The foundation of a tower as its user describes it.

use super::closed_form::{
    CircularFooting, Monopile, RectangularFooting, SuctionCaisson, WinklerPile,
};
use super::inertia::Inertia;
use crate::space::SpatialMatrix;

/// The support of the lowest station.
///
/// # Example
/// A rocking spring of 50 GN m/rad lowers the first frequency.
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
/// let first_hz = solve(&tower, &Options::default())?.modes[0].frequency_hz;
/// assert!((0.270..0.280).contains(&first_hz), "clamped it is 0.300 Hz: {first_hz}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Foundation {
    /// It does not move.
    #[default]
    Clamped,
    /// A stiffness for all six motions, and possibly an inertia.
    Stiffness(Box<StiffnessFoundation>),
    /// Springs, any of which may be infinite.
    Springs(FoundationSprings),
    /// A rigid circular footing on elastic soil.
    HalfSpace(HalfSpace),
    /// A rigid circular footing in a stratum over rock or over another stratum.
    CircularFooting(Box<CircularFooting>),
    /// A rigid rectangular footing on or in elastic soil.
    RectangularFooting(Box<RectangularFooting>),
    /// A rigid suction caisson in an elastic continuum.
    SuctionCaisson(Box<SuctionCaisson>),
    /// A monopile in an elastic continuum, by a closed form.
    Monopile(Box<Monopile>),
    /// A pile on springs along its length, exactly.
    WinklerPile(Box<WinklerPile>),
    /// A rigid floating platform.
    Floating(Box<FloatingPlatform>),
}

impl Foundation {
    /// The stiffness that follows from the dimensions and the soil of a foundation that is given by
    /// these, as in [`StiffnessFoundation`]; none for the others.
    pub fn derived_stiffness(&self) -> Option<SpatialMatrix> {
        match self {
            Self::HalfSpace(footing) => Some(footing.springs().matrix()),
            Self::CircularFooting(footing) => Some(footing.springs().matrix()),
            Self::RectangularFooting(footing) => Some(footing.stiffness()),
            Self::SuctionCaisson(caisson) => Some(caisson.springs().matrix()),
            Self::Monopile(pile) => Some(pile.springs().matrix()),
            Self::WinklerPile(pile) => Some(pile.springs().matrix()),
            Self::Clamped | Self::Stiffness(_) | Self::Springs(_) | Self::Floating(_) => None,
        }
    }

    /// Whether it is a pile or a caisson by closed form, which contains the soil around it.
    pub(super) fn contains_soil(&self) -> bool {
        matches!(
            self,
            Self::Monopile(_) | Self::WinklerPile(_) | Self::SuctionCaisson(_)
        )
    }
}

/// Matrices for the motion (x, y, z, rotation about x, y, z) of the base: N/m, N, N m; kg, kg m, kg
/// m².
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StiffnessFoundation {
    /// Stiffness about the base, symmetric; infinite on the diagonal where the base is rigidly
    /// held; then the other entries of this row and column are ignored.
    pub stiffness: SpatialMatrix,
    /// Inertia about the base, symmetric; zero for none.
    pub inertia: SpatialMatrix,
}

/// Springs under the base, the same in both planes; infinity is a rigid one, zero none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FoundationSprings {
    /// Against translation x and y, N/m.
    pub lateral_n_per_m: f64,
    /// Against rotation about x and y, N m.
    pub rocking_n_m: f64,
    /// Between x and rotation about y, and with the opposite sign between y and rotation about x,
    /// N.
    pub coupling_n: f64,
    /// Against translation z, N/m.
    pub vertical_n_per_m: f64,
    /// Against rotation about z, N m.
    pub torsion_n_m: f64,
}

impl StiffnessFoundation {
    /// Which motions are possible, and the stiffness against these alone.
    pub(super) fn moving(&self) -> ([bool; 6], SpatialMatrix) {
        let moves: [bool; 6] = std::array::from_fn(|i| self.stiffness[i][i] != f64::INFINITY);
        let entry = |i: usize, j: usize| {
            if moves[i] && moves[j] {
                self.stiffness[i][j]
            } else {
                0.0
            }
        };
        let stiffness = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
        (moves, stiffness)
    }
}

impl FoundationSprings {
    /// Rigid in every direction.
    pub const RIGID: Self = Self {
        lateral_n_per_m: f64::INFINITY,
        rocking_n_m: f64::INFINITY,
        coupling_n: 0.0,
        vertical_n_per_m: f64::INFINITY,
        torsion_n_m: f64::INFINITY,
    };

    /// The stiffness for the motion (x, y, z, rotation about x, y, z) of the base; a rigid spring
    /// is infinite on its diagonal.
    pub(super) fn matrix(&self) -> SpatialMatrix {
        let mut matrix = SpatialMatrix::default();
        for (i, value) in self.diagonal().into_iter().enumerate() {
            matrix[i][i] = value;
        }
        for (translation, rotation, sign) in [(0, 4, 1.0), (1, 3, -1.0)] {
            matrix[translation][rotation] = sign * self.coupling_n;
            matrix[rotation][translation] = sign * self.coupling_n;
        }
        matrix
    }

    /// Along the diagonal of the stiffness: x, y, z, rotation about x, y, z.
    pub(super) fn diagonal(&self) -> [f64; 6] {
        let (lateral, rocking) = (self.lateral_n_per_m, self.rocking_n_m);
        [
            lateral,
            lateral,
            self.vertical_n_per_m,
            rocking,
            rocking,
            self.torsion_n_m,
        ]
    }
}

/// A rigid circular footing in an elastic half-space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfSpace {
    /// Radius R, m.
    pub radius_m: f64,
    /// Depth of embedment e, m.
    pub embedment_m: f64,
    /// Shear modulus G of the soil, Pa.
    pub shear_modulus_pa: f64,
    /// Poisson's ratio ν of the soil.
    pub poissons_ratio: f64,
}

impl HalfSpace {
    /// The springs of the footing, static and uncoupled:
    ///
    /// | | surface footing | times, for embedment e |
    /// |---|---|---|
    /// | vertical | 4GR/(1−ν) | 1 + 0.6 (1−ν) e/R |
    /// | lateral | 32(1−ν)GR/(7−8ν) | 1 + 0.55 (2−ν) e/R |
    /// | rocking | 8GR³/(3(1−ν)) | 1 + 1.2 (1−ν) e/R + 0.2 (2−ν) (e/R)³ |
    /// | torsion | 16GR³/3 | 1 |
    ///
    /// Source: Arya, O'Neill & Pincus, *Design of Structures and Foundations for Vibrating
    /// Machines* (1979), ch. 4, after Richart, Hall & Woods (1970) and Whitman (1972).
    pub fn springs(&self) -> FoundationSprings {
        let (g, r, nu) = (self.shear_modulus_pa, self.radius_m, self.poissons_ratio);
        let e = self.embedment_m / r;
        let vertical = 1.0 + 0.6 * (1.0 - nu) * e;
        let lateral = 1.0 + 0.55 * (2.0 - nu) * e;
        let rocking = 1.0 + 1.2 * (1.0 - nu) * e + 0.2 * (2.0 - nu) * e.powi(3);
        FoundationSprings {
            lateral_n_per_m: 32.0 * (1.0 - nu) * g * r / (7.0 - 8.0 * nu) * lateral,
            rocking_n_m: 8.0 * g * r.powi(3) / (3.0 * (1.0 - nu)) * rocking,
            coupling_n: 0.0,
            vertical_n_per_m: 4.0 * g * r / (1.0 - nu) * vertical,
            torsion_n_m: 16.0 * g * r.powi(3) / 3.0,
        }
    }
}

/// A matrix for the motion (x, y, z, rotation about x, y, z) of a point on the tower's axis.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ReferredMatrix {
    /// The matrix.
    pub matrix: SpatialMatrix,
    /// Height of the point in the datum of the stations, m.
    pub height_m: f64,
}

/// A rigid platform that floats and carries the tower's base.
///
/// Slightly asymmetric matrices are symmetrized, with a warning.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FloatingPlatform {
    /// Mass with ballast, kg.
    pub mass_kg: f64,
    /// Centre of mass, m: x and y from the tower's axis, z in the datum of the stations.
    pub center_m: [f64; 3],
    /// Inertia about the centre of mass, kg m².
    pub inertia_kg_m2: Inertia,
    /// Hydrodynamic added mass: kg, kg m, kg m².
    pub added_mass: ReferredMatrix,
    /// Hydrostatic stiffness of water plane and buoyancy: N/m, N, N m. The gravity part
    /// is that of gravity.
    pub hydrostatic: ReferredMatrix,
    /// Stiffness of the moorings: N/m, N, N m.
    pub mooring: ReferredMatrix,
}

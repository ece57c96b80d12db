//! Natural frequencies and mode shapes of wind turbine towers by the rigid multibody method, with
//! the proof that no mode is missing.
//!
//! # A tower
//!
//! A tower is described by stations, materials and masses, on a foundation, in soil and water
//! ([`TowerDescription`]), checked once ([`Tower::new`]) and solved ([`solve()`]):
//!
//! ```
//! use towermodes::{Material, Options, Rna, Station, Tower, TowerDescription, solve};
//!
//! let tower = Tower::new(TowerDescription {
//!     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
//!     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
//!     rna: Rna::point(350e3),
//!     ..TowerDescription::default()
//! })?;
//! let solution = solve(&tower, &Options::default())?;
//! let first = &solution.modes[0];
//! assert_eq!(first.label(), "1st fore-aft bending");
//! assert!((first.extrapolated_hz - 0.300206).abs() < 1e-6);
//! assert!(solution.certificate.complete);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Each frequency comes with a bound on its algebraic error, an estimate of its discretization
//! error and an extrapolated value; the list comes with a [`Certificate`], the proof that no mode
//! is missing. [`Options`] has the method (by default [`Method::RmjeExact`]), the mesh and the
//! number of modes.
//!
//! # Which numbers matter
//!
//! A [`Solver`] keeps options and memory from tower to tower. It also computes frequencies without
//! shapes, as many modes as a condition requires, modes of rotating blades, and derivatives of
//! frequencies:
//!
//! ```
//! use towermodes::{Change, Material, Rna, Solver, Station, TowerDescription};
//!
//! let description = TowerDescription {
//!     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
//!     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
//!     rna: Rna::point(350e3),
//!     ..TowerDescription::default()
//! };
//! let changes = Change::parse_all(["rna.mass", "scale(stations[*].wall)"], &description)?;
//! let found = Solver::default().sensitivities(&description, &changes)?;
//! // Percent of the first frequency for one percent of each:
//! let first = found.changes.iter().map(|of| of.elasticity(&found.modes, 0));
//! let rounded: Vec<f64> = first.flatten().map(|e| (100.0 * e).round() / 100.0).collect();
//! assert_eq!(rounded, [-0.45, 0.44]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A turbine that turns
//!
//! With its nacelle, drivetrain and flexible blades ([`turbine`]) a tower is solved at any speed of
//! the rotor; counts prove each frequency and that none is missing:
//!
//! ```
//! use towermodes::turbine::{Turbine, TurbineDescription};
//! use towermodes::{BladeDescription, BladeSection, Material, RigidBody, Station};
//! # use towermodes::TowerDescription;
//!
//! let tower = TowerDescription {
//!     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
//!     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
//!     ..TowerDescription::default()
//! };
//! let root = BladeSection { mass_kg_per_m: 200.0, flap_n_m2: 2e9, edge_n_m2: 5e9,
//!     torsion_n_m2: f64::INFINITY, axial_n: f64::INFINITY, ..BladeSection::default() };
//! let sections = vec![root, BladeSection { span: 1.0, ..root }];
//! let borders = vec![0.0, 0.5, 1.0];
//! let turbine = Turbine::new(tower, TurbineDescription {
//!     nacelle: RigidBody::point(240e3, [1.9, 0.0, 1.75]),
//!     overhang_m: -5.0,
//!     blade: BladeDescription { tip_radius_m: 52.0, sections, borders, ..Default::default() },
//!     ..TurbineDescription::default()
//! })?;
//! let modes = turbine.modes(2.0, 12.1)?;
//! assert!(modes.is_complete);
//! assert_eq!(modes.modes[0].label(), "1st tower fore-aft");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! With the feature `serde` results can be serialized, with `schema` they have JSON schemas.
//!
//! # The steps and their modules
//!
//! | step | module |
//! |---|---|
//! | the values of a tower file: keys, limits, units | [`inputs`] |
//! | towers and blades, integrals of sections, coupled motions | [`tower`], [`blade`] |
//! | the numbers of a tower by name | [`parameter`] |
//! | the mesh and the elements; that of the paper is `elements/rmje.rs` | `elements` |
//! | rigid bodies and elastic joints, the paper's eq. (17) in O(n) | `chain` |
//! | beams of flexible elements: BModes, the spectral method, rotating blades | `beam` |
//! | rotors of equal blades in multiblade coordinates | `rotor` |
//! | a turning turbine on its tower: frequencies by counts | [`turbine`] |
//! | mooring lines: force and stiffness on a platform | [`mooring`] |
//! | uncoupled groups of motions, each as an eigenvalue problem | `subsystem` |
//! | Lanczos process for the lowest eigenvalues, error bounds, eigenvalue count | `eigen` |
//! | family, shape, energy, discretization error of a mode | [`modes`] |
//! | options, spectrum of the tower, certificate, error estimates, warnings | [`solve()`] |
//!
//! Data flows only in this order. SI units throughout; heights use the datum of the user; x is
//! fore-aft (downwind), y side-side, z up.

mod beam;
pub mod blade;
mod chain;
mod eigen;
mod elements;
pub mod frame;
pub mod inputs;
mod lanes;
mod method;
pub mod modes;
pub mod mooring;
pub mod number;
pub mod parameter;
mod rotor;
mod scalar;
pub mod sensitivity;
mod solve;
pub mod space;
mod subsystem;
mod symmetric;
pub mod tower;
pub mod turbine;

pub use blade::{Blade, BladeDescription, BladeError, BladeSection};
pub use eigen::{EigenError, Statistics};
pub use elements::GAUSS_HINGE_POSITION;
pub use method::Method;
pub use modes::{
    ByMotion, Energy, EnergyParts, Family, KineticParts, ModeName, ModeNameError, SecondFamily,
    ShapePoint, Shares, StrainParts,
};
pub use number::Plain;
pub use parameter::{Change, Operation, Parameter, ParameterError};
pub use sensitivity::{
    ChangeSensitivity, Derivative, NoDerivative, Sensitivities, SensitivityError,
};
pub use solve::{
    AddedMassAt, BladeFamily, BladeMode, BladeSolution, Certificate, DEFAULT_MODES, DEFAULT_POINTS,
    DEFAULT_SEGMENTS, ErrorBasis, Frequencies, MAX_BYTES, MAX_DEGREE, MAX_POINTS, MAX_SECONDS,
    MAX_SEGMENTS, MAX_SPECTRAL_ELEMENTS, Mode, ModeFrequency, ModeKey, Options, Progress, Solution,
    SolveError, Solver, Stage, TooManyModes, solve,
};
pub use tower::{
    AddedMassRow, AddedMassTable, ApiEdition, AxialModel, BeamFormula, Buoyancy, Buried,
    CircularFooting, Clay, ClosedForm, Damping, Drivetrain, EquilibriumError, EquilibriumPose,
    FloatingPlatform, FootingFormula, FormKind, Foundation, FoundationHead, FoundationSprings,
    Ground, GroundLayer, HalfSpace, HeadStiffness, Ineffective, Inertia, LayerSoil, LossFactors,
    Material, MissingPart, MissingParts, Monopile, MooringLines, PartNames, PileBehaviour,
    PileFormula, PileTube, Place, Plane, Planes, PointMass, Problem, Properties, PropertyStation,
    PyRow, Quantity, RectangularFooting, ReferredMatrix, RigidBody, Rna, Rock, Rotor,
    RotorAerodynamics, Sand, Scour, Shear, ShearModulus, Site, Slenderness, SoilBelow, SoilModel,
    SoilProfile, SoilRow, SoilSpring, SoilStiffness, SpringsAt, SpringsOfMember, StaticBalance,
    Station, StiffnessFoundation, SuctionCaisson, Support, TipSprings, Tower, TowerDescription,
    TowerError, Warning, Water, WinklerPile, Wires, is_printable, printable,
};

/// The rooms of the solver, for its own tests and benchmarks: nothing here is promised.
#[doc(hidden)]
pub mod internal {
    pub mod beam {
        pub use crate::beam::*;
    }
    pub mod chain {
        pub use crate::chain::*;
    }
    pub mod eigen {
        pub use crate::eigen::*;
    }
    pub mod elements {
        pub use crate::elements::*;
    }
    pub mod frame {
        pub use crate::frame::below::*;
    }
    pub mod rotor {
        pub use crate::rotor::*;
    }
    pub mod subsystem {
        pub use crate::subsystem::*;
    }
}

//! The tower: geometry, materials, masses, foundation and surroundings; validated once,
//! constant afterwards.

mod attachment;
mod closed_form;
mod description;
mod error;
mod floating;
mod foundation;
pub(crate) mod frame;
mod ground;
mod make;
mod model;
mod name;
mod nearby;
mod parts;
mod pieces;
mod plausibility;
mod support;
mod validate;
mod warning;

pub use attachment::Attachment;
pub(crate) use attachment::spatial_inertia;
pub use closed_form::*;
pub use description::{
    PointMass, PropertyStation, Rna, STANDARD_GRAVITY_M_PER_S2, Station, TowerDescription,
};
pub use error::{FreeMotions, Place, Problem, TowerError};
pub use floating::balance::{EquilibriumPose, StaticBalance};
pub use floating::mistake::EquilibriumError;
pub use foundation::{Foundation, StiffnessFoundation, Support};
pub use ground::{
    ApiEdition, AxialModel, Clay, Ground, GroundLayer, LayerSoil, PyRow, Rock, Sand, Scour,
    ShearModulus, SoilModel,
};
pub use model::Tower;
pub use name::{is_printable, printable};
pub use parts::added_mass::AddedMassTable;
pub use parts::damping::{Damping, LossFactors, RotorAerodynamics};
pub use parts::drivetrain::Drivetrain;
pub use parts::floating_platform::{Buoyancy, FloatingPlatform, ReferredMatrix};
pub use parts::foundation_springs::FoundationSprings;
pub use parts::inertia::Inertia;
pub use parts::material::Material;
pub use parts::missing::{MissingPart, MissingParts};
pub use parts::mooring_lines::MooringLines;
pub use parts::part_names::PartNames;
pub use parts::properties::Properties;
pub use parts::rigid_body::RigidBody;
pub use parts::rotor::{FASTEST_RPM, MOST_BLADES, Rotor, Rpm};
pub use parts::surroundings::{AddedMassRow, SoilRow, SoilStiffness, Water, Wires};
pub use pieces::axisymmetric::Axisymmetric;
pub use pieces::environment::Environment;
pub use pieces::integrals::{
    BendingCompliance, Compliance, Hinge, MassIntegrals, compliance, gauss_hinges, mass_integrals,
    soil_integrals,
};
pub(crate) use pieces::integrals::{for_each_flexible_point, for_each_mass_point};
pub use pieces::piece::{Piece, Profile};
pub use pieces::planes::{Plane, Planes};
pub use pieces::section::{Section, SectionMasses, Tube};
pub use pieces::shear::Shear;
pub(crate) use support::added_mass::InertiaByFrequency;
pub use support::base::Base;
pub use support::foundation_head::FoundationHead;
pub use support::independent::{Component, Motion, Motions};
pub use support::soil_springs::{SpringsAt, SpringsOfMember, TipSprings};
pub use warning::{Ineffective, Site, Warning};

pub use crate::inputs::Quantity;

pub(crate) use nearby::neighbour::{Neighbour, Neighbours};
pub(crate) use nearby::numbers::{Place as NumberPlace, Places};
pub(crate) use nearby::stripped::Strippable;
pub(crate) use pieces::slopes::{FlexibilitySlopes, MassSlopes};
pub(crate) use plausibility::inertia_plausibility;

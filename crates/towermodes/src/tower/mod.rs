//! The tower: geometry, materials, masses, foundation and surroundings; validated once,
//! constant afterwards.

mod attachment;
mod axisymmetric;
mod base;
mod closed_form;
mod damping;
mod description;
mod drivetrain;
mod environment;
mod error;
mod foundation;
mod foundation_springs;
mod fronts;
mod ground;
mod immersion;
mod independent;
mod inertia;
mod integrals;
mod make;
mod material;
mod missing;
mod model;
mod name;
mod neighbour;
mod numbers;
mod part_names;
mod piece;
mod pile_head;
mod planes;
mod plausibility;
mod properties;
mod rigid;
mod rigid_body;
mod rigid_body_modes;
mod rotor;
mod section;
mod shear;
mod slopes;
mod soil_factor;
mod stripped;
mod surroundings;
mod validate;
mod warning;
mod weight;

pub use attachment::Attachment;
pub(crate) use attachment::spatial_inertia;
pub use axisymmetric::Axisymmetric;
pub use base::Base;
pub use closed_form::{
    BeamFormula, Buried, CircularFooting, ClosedForm, FootingFormula, FormKind, HalfSpace,
    HeadStiffness, Monopile, PileBehaviour, PileFormula, PileTube, RectangularFooting, Slenderness,
    SoilBelow, SoilProfile, SoilSpring, SuctionCaisson, WinklerPile,
};
pub use damping::{Damping, LossFactors, RotorAerodynamics};
pub use description::{PointMass, PropertyStation, Rna, Station, TowerDescription};
pub use drivetrain::Drivetrain;
pub use environment::Environment;
pub use error::{FreeMotions, Place, Problem, TowerError};
pub use foundation::{FloatingPlatform, Foundation, ReferredMatrix, StiffnessFoundation, Support};
pub use foundation_springs::FoundationSprings;
pub use ground::{
    ApiEdition, AxialModel, Clay, Ground, GroundLayer, LayerSoil, PyRow, Rock, Sand, Scour,
    ShearModulus, SoilModel,
};
pub use independent::{Component, Motion, Motions};
pub use inertia::Inertia;
pub use integrals::{
    BendingCompliance, Compliance, Hinge, MassIntegrals, compliance, gauss_hinges, mass_integrals,
    soil_integrals,
};
pub(crate) use integrals::{for_each_flexible_point, for_each_mass_point};
pub use material::Material;
pub use missing::{MissingPart, MissingParts};
pub use model::Tower;
pub use name::{is_printable, printable};
pub use part_names::PartNames;
pub use piece::{Piece, Profile};
pub use pile_head::SpringsAt;
pub use planes::{Plane, Planes};
pub use properties::Properties;
pub use rigid_body::RigidBody;
pub use rotor::{FASTEST_RPM, MOST_BLADES, Rotor, Rpm};
pub use section::{Section, SectionMasses, Tube};
pub use shear::Shear;
pub use surroundings::{AddedMassRow, SoilRow, SoilStiffness, Water, Wires};
pub use warning::{Ineffective, Site, Warning};

pub use crate::inputs::Quantity;

pub(crate) use neighbour::{Neighbour, Neighbours};
pub(crate) use numbers::{Place as NumberPlace, Places};
pub(crate) use plausibility::inertia_plausibility;
pub(crate) use slopes::{FlexibilitySlopes, MassSlopes};
pub(crate) use stripped::Strippable;

//! The parts of a tower with their loss factors and their fractions of a mode's energy.

use std::fmt;

use towermodes::frame::{CoatKind, FrameFoundation, FrameMember};
use towermodes::space::SpatialMatrix;
use towermodes::tower::Support;
use towermodes::{EnergyParts, TowerDescription, printable};

/// A part of a tower that dissipates energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum DampedPart {
    /// The tower itself in one of its materials, or a table of properties.
    Tower,
    /// The members of the substructure.
    Substructure,
    /// The foundation, or the supports of the substructure.
    Foundation,
    /// The soil springs along the tower and along the piles of the substructure.
    Soil,
    /// The guy wires.
    Wires,
    /// The water, by its kinetic energy.
    Water,
}

impl fmt::Display for DampedPart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Tower => "tower",
            Self::Substructure => "substructure",
            Self::Foundation => "foundation",
            Self::Soil => "soil",
            Self::Wires => "wires",
            Self::Water => "water",
        })
    }
}

/// The damping of a mode by one part.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PartDamping {
    /// The part.
    pub part: DampedPart,
    /// The name of the material; empty for other parts and for a material without a name.
    pub material: String,
    /// Its loss factor; none if it is not given.
    pub loss_factor: Option<f64>,
    /// Fraction of the strain energy of the mode in the part; for water, of the kinetic energy.
    pub energy_fraction: f64,
    /// ½ loss factor × fraction; none if the loss factor is not given.
    pub damping_ratio: Option<f64>,
}

impl PartDamping {
    fn new(part: DampedPart, loss_factor: Option<f64>, energy_fraction: f64) -> Self {
        Self {
            part,
            material: String::new(),
            loss_factor,
            energy_fraction,
            damping_ratio: loss_factor.map(|eta| 0.5 * eta * energy_fraction),
        }
    }

    /// Its name in tables: the name of the material, if it has one.
    pub fn name(&self) -> String {
        match self.material.is_empty() {
            true => self.part.to_string(),
            false => printable(&self.material),
        }
    }
}

/// The parts that a tower has, with their fractions of the energy of a mode.
pub(super) fn parts(description: &TowerDescription, energy: &EnergyParts) -> Vec<PartDamping> {
    let factors = &description.damping.loss_factors;
    let (strain, kinetic) = (&energy.strain, &energy.kinetic);
    let materials = strain.materials.iter().enumerate();
    let mut parts: Vec<PartDamping> = materials
        .filter(|(index, _)| is_used(description, *index))
        .map(|(index, fraction)| {
            let name = description.part_names.materials.get(index);
            PartDamping {
                material: name.cloned().unwrap_or_default(),
                ..PartDamping::new(DampedPart::Tower, factors.of_material(index), *fraction)
            }
        })
        .collect();
    let others = [
        (
            DampedPart::Substructure,
            factors.substructure,
            strain.substructure,
        ),
        (
            DampedPart::Foundation,
            factors.foundation,
            strain.foundation,
        ),
        (DampedPart::Soil, factors.soil, strain.soil),
        (DampedPart::Wires, factors.wires, strain.wires),
        (DampedPart::Water, factors.water, kinetic.water),
    ];
    let others = others
        .into_iter()
        .filter(|(part, ..)| has(description, *part));
    parts.extend(others.map(|(part, factor, fraction)| PartDamping::new(part, factor, fraction)));
    parts
}

/// Whether a tower has a part.
pub(super) fn has(description: &TowerDescription, part: DampedPart) -> bool {
    let frame = description.foundation.frame();
    match part {
        DampedPart::Tower => true,
        DampedPart::Substructure => frame.is_some(),
        // Soil in layers has springs at the tip of the pile, which are part of the foundation.
        // Water plane and moorings are no material, and the energy of buoyancy may be negative.
        DampedPart::Foundation => match description.foundation.support() {
            Support::Clamped => description.ground.is_some(),
            Support::Floating(_) => false,
            Support::Frame(frame) => description.ground.is_some() || has_springs(frame),
            Support::Stiffness(_) | Support::Springs(_) | Support::Form(_) => true,
        },
        DampedPart::Soil => {
            let mut members = members(frame);
            !description.soil.is_empty()
                || description.ground.is_some()
                || members.any(|member| !member.soil.is_empty())
        }
        DampedPart::Wires => !description.wires.is_empty(),
        DampedPart::Water => {
            let platform = description.foundation.floating();
            description.water.is_some()
                || !description.added_mass.is_empty()
                || frame.is_some_and(has_water)
                || platform.is_some_and(|platform| {
                    platform.added_mass_at(0.0).matrix != SpatialMatrix::default()
                })
        }
    }
}

fn members(frame: Option<&FrameFoundation>) -> impl Iterator<Item = &FrameMember> {
    frame
        .into_iter()
        .flat_map(|frame| &frame.frame.description().members)
}

/// Whether a support has springs.
fn has_springs(foundation: &FrameFoundation) -> bool {
    let mut supports = foundation.frame.description().supports.iter();
    supports.any(|support| support.stiffness != SpatialMatrix::default())
}

/// Whether members or joints have added mass of water.
fn has_water(foundation: &FrameFoundation) -> bool {
    let description = foundation.frame.description();
    let mut coats = members(Some(foundation)).flat_map(|member| &member.coats);
    !(description.added_masses.is_empty() && description.riders.is_empty())
        || coats.any(|coat| matches!(coat.kind, CoatKind::AddedMass { .. }))
}

/// Whether any piece of the tower consists of a material. The material of the top row has no piece
/// above it.
fn is_used(description: &TowerDescription, index: usize) -> bool {
    let mut pieces = description.stations.windows(2);
    description.stations.is_empty()
        || pieces.any(|ends| ends[0].material == index && ends[0].height_m < ends[1].height_m)
}

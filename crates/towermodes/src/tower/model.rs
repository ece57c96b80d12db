//! The tower itself: constant once it is made.

use std::sync::Arc;

use super::attachment::Attachment;
use super::description::{PointMass, PropertyStation, Rna, Station};
use super::floating::afloat::Afloat;
use super::frame::FrameFoundation;
use super::parts::missing::MissingParts;
use super::parts::rotor::Rotor;
use super::pieces::environment::Environment;
use super::pieces::integrals::weight_integrals;
use super::pieces::piece::Piece;
use super::pieces::weight::Above;
use super::support::added_mass::InertiaByFrequency;
use super::support::base::Base;
use super::support::independent::{Motion, Motions};
use crate::space::SpatialMatrix;
use crate::tower::Warning;

/// A valid tower: every property is finite and positive, every wall fits its tube, and the tower is
/// supported or floats.
///
/// [`Tower::new`] makes it from a [`TowerDescription`](super::TowerDescription); it cannot be
/// changed.
#[derive(Debug, Clone, PartialEq)]
pub struct Tower {
    pub(super) name: String,
    pub(super) stations: Vec<Station>,
    pub(super) properties: Vec<PropertyStation>,
    pub(super) pieces: Vec<Piece>,
    pub(super) rna: Rna,
    pub(super) point_masses: Vec<PointMass>,
    pub(super) attachments: Vec<Attachment>,
    pub(super) base: Base,
    pub(super) inertia_by_frequency: Option<Box<InertiaByFrequency>>,
    pub(super) gravity_m_per_s2: f64,
    pub(super) rotor: Option<Rotor>,
    pub(super) above: Above,
    pub(super) independent: Vec<Motions>,
    pub(super) planes_are_equal: bool,
    /// Whether both bending planes have separate joints, even if they are equal.
    pub(super) planes_are_apart: bool,
    pub(super) outfitting_factor: f64,
    pub(super) mass_kg: f64,
    pub(super) ground: Option<InGround>,
    pub(super) frame: Option<Box<FrameFoundation>>,
    pub(super) afloat: Option<Arc<Afloat>>,
    pub(super) missing: Option<MissingParts>,
    pub(super) warnings: Vec<Warning>,
}

/// The data of soil in layers that a tower keeps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct InGround {
    /// Height of the surface, or of the bottom of the hole of local scour, m.
    pub(super) surface_m: f64,
    /// The springs of the soil under the tip of the pile, in the order of motions; zero on a frame.
    pub(super) at_tip: [f64; 6],
    /// See [`Tower::soil_error`].
    pub(super) soil_error: f64,
}

impl Tower {
    /// Name given by the user; may be empty. Characters that are not
    /// [printable](super::printable) are replaced by spaces.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The stations as they were given; none if the tower is a table of properties.
    pub fn stations(&self) -> &[Station] {
        &self.stations
    }

    /// The rows of the property table as they were given; none if the tower is made of tubes.
    pub fn properties(&self) -> &[PropertyStation] {
        &self.properties
    }

    /// The heights of the stations or rows as they were given, m.
    pub fn station_heights_m(&self) -> Vec<f64> {
        let stations = self.stations.iter().map(|station| station.height_m);
        let rows = self.properties.iter().map(|row| row.height_m);
        stations.chain(rows).collect()
    }

    /// The number of stations or rows as they were given.
    pub(crate) fn station_count(&self) -> usize {
        self.stations.len() + self.properties.len()
    }

    /// The linear pieces from the base to the top; consecutive ones share a height.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The rotor-nacelle assembly.
    pub fn rna(&self) -> &Rna {
        &self.rna
    }

    /// The point masses as they were given.
    pub fn point_masses(&self) -> &[PointMass] {
        &self.point_masses
    }

    /// Point masses, wires and the rotor-nacelle assembly by increasing height.
    pub fn attachments(&self) -> &[Attachment] {
        &self.attachments
    }

    /// The attachments, with the weight of the rotor-nacelle assembly but without its inertia: for
    /// a turbine model, whose parts contain this inertia.
    pub(crate) fn attachments_but_inertia_of_rna(&self) -> Vec<Attachment> {
        let mut attachments = self.attachments.clone();
        // Attachments are sorted by height, and the assembly is the last one at the top.
        if let Some(rna) = attachments.last_mut() {
            rna.inertia = [[0.0; 6]; 6];
        }
        attachments
    }

    /// The base with its support.
    pub fn base(&self) -> &Base {
        &self.base
    }

    /// Acceleration of gravity, m/s²; 0 if gravity is neglected.
    pub fn gravity_m_per_s2(&self) -> f64 {
        self.gravity_m_per_s2
    }

    /// The rotor, if it is known.
    pub fn rotor(&self) -> Option<&Rotor> {
        self.rotor.as_ref()
    }

    /// Estimate of the relative error of a frequency that arises because linear springs between
    /// depths replace the curved springs of [`ground`](super::TowerDescription::ground); usually
    /// larger than the error, and 0 without ground. The error of every mode contains it.
    pub fn soil_error(&self) -> f64 {
        self.ground.map_or(0.0, |ground| ground.soil_error)
    }

    /// Where the pile ends and the free tower begins, if the tower stands in
    /// [`ground`](super::TowerDescription::ground): the height of the bottom of the scour, m.
    pub fn ground_surface_m(&self) -> Option<f64> {
        self.ground.map(|ground| ground.surface_m)
    }

    /// The smallest sets of motions that are coupled with each other and with no other, by the
    /// structure of the tower.
    pub fn independent_motions(&self) -> &[Motions] {
        &self.independent
    }

    /// The factor by which the density of the tower was multiplied.
    pub fn outfitting_factor(&self) -> f64 {
        self.outfitting_factor
    }

    /// The piece that a height (m) on the tower lies in; of two that meet there the lower one.
    pub fn piece_at(&self, height_m: f64) -> &Piece {
        &self.pieces[self.piece_index_at(height_m)]
    }

    fn piece_index_at(&self, height_m: f64) -> usize {
        let index = self.pieces.partition_point(|piece| piece.top_m < height_m);
        index.min(self.pieces.len() - 1)
    }

    /// Whether the tower is rigid in a motion: its table of properties has an infinite stiffness.
    pub fn is_rigid_in(&self, motion: Motion) -> bool {
        self.pieces[0].is_rigid_in(motion)
    }

    /// Whether the tower deforms in shear.
    pub fn shears(&self) -> bool {
        self.pieces[0].shears()
    }

    /// Whether any section has rotary inertia in bending: tubes have, the rows of a table may not.
    pub fn has_rotary_inertia(&self) -> bool {
        let inertias = self
            .properties
            .iter()
            .map(|row| row.properties.rotary_inertia_kg_m);
        !self.stations.is_empty()
            || inertias
                .into_iter()
                .any(|i| i.fore_aft != 0.0 || i.side_side != 0.0)
    }

    /// Height z of the base in the user's datum, m.
    pub fn base_m(&self) -> f64 {
        self.pieces[0].base_m
    }

    /// Height z of the top in the user's datum, m.
    pub fn top_m(&self) -> f64 {
        self.pieces[self.pieces.len() - 1].top_m
    }

    /// Height of the tower from its base to its top, m.
    pub fn height_m(&self) -> f64 {
        self.top_m() - self.base_m()
    }

    /// Mass of the tower with its outfitting and point masses, without the rotor-nacelle assembly,
    /// kg.
    pub fn mass_kg(&self) -> f64 {
        self.mass_kg
    }

    /// Whether the lowest piece of the tower stands in soil or water, or has added mass: then the
    /// tower reaches down into its substructure.
    pub fn begins_in_soil_or_water(&self) -> bool {
        let lowest = self.pieces.first();
        lowest.is_some_and(|piece| piece.environment != Environment::default())
    }

    /// Mass of the tower and of the members of the substructure below it, kg: the mass of steel
    /// that has to be bought. Water, growth, and masses on joints are not part of it.
    pub fn structure_mass_kg(&self) -> f64 {
        let members_kg = self.frame().map(|below| below.frame.masses().members_kg);
        self.mass_kg + members_kg.unwrap_or_default()
    }

    /// The axial compression N at a height (m) by the weight of everything above, N. An attachment
    /// at the height itself counts as above it.
    ///
    /// Water has no weight here: its pressure on the wall and its buoyancy are neglected.
    pub fn compression_n(&self, height_m: f64) -> f64 {
        let index = self.piece_index_at(height_m);
        let attached = self.attachments.partition_point(|a| a.height_m < height_m);
        let piece = &self.pieces[index];
        self.gravity_m_per_s2 * self.above.mass_kg(piece, index, height_m, attached)
    }

    /// ∫ N dz between two heights (m) of one piece with no attachment between them, N m.
    ///
    /// A rigid piece that rotates by θ lowers itself and all it carries: its potential energy is
    /// −½ θ² times this integral.
    pub fn compression_integral_n_m(&self, base_m: f64, top_m: f64) -> f64 {
        let piece = self.piece_at(0.5 * (base_m + top_m));
        let (_, moment_kg_m) = weight_integrals(piece, base_m, top_m, base_m);
        self.compression_n(top_m) * (top_m - base_m) + self.gravity_m_per_s2 * moment_kg_m
    }

    /// The frame that carries the tower, if there is one.
    pub fn frame(&self) -> Option<&FrameFoundation> {
        self.frame.as_deref()
    }

    /// Whether both bending planes are equal and nothing couples them, so that each bending
    /// frequency occurs twice.
    pub fn planes_are_equal(&self) -> bool {
        self.planes_are_equal
    }

    /// Whether both bending planes have separate joints, even if they are equal.
    pub(crate) fn planes_are_apart(&self) -> bool {
        self.planes_are_apart
    }

    /// The parts of the structure that the source of the description has and the tower lacks; none
    /// if it is complete.
    pub fn missing_parts(&self) -> Option<&MissingParts> {
        self.missing.as_ref()
    }

    /// Probable mistakes in the input.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// The added mass of the platform by frequency, with the inertia of the base; none if it does
    /// not depend on frequency.
    pub(crate) fn inertia_by_frequency(&self) -> Option<&InertiaByFrequency> {
        self.inertia_by_frequency.as_deref()
    }

    /// Whether the added mass of its platform depends on frequency.
    pub fn has_added_mass_by_frequency(&self) -> bool {
        self.inertia_by_frequency.is_some()
    }

    /// The same tower on a platform with the constant added mass that it has at an angular
    /// frequency (rad/s); the same tower if it depends on no frequency.
    #[must_use]
    pub fn with_added_mass_at(&self, frequency: f64) -> Self {
        match &self.inertia_by_frequency {
            Some(by_frequency) => self.with_base_inertia(by_frequency.at(frequency)),
            None => self.clone(),
        }
    }

    /// The same tower under another gravity, m/s². A floating tower keeps its own: the stiffness of
    /// its water and lines contains it.
    #[must_use]
    pub fn with_gravity(&self, gravity_m_per_s2: f64) -> Self {
        match self.afloat.is_some() {
            true => self.clone(),
            false => Self {
                gravity_m_per_s2,
                ..self.clone()
            },
        }
    }

    /// The same tower with a constant inertia of its base.
    pub(crate) fn with_base_inertia(&self, inertia: SpatialMatrix) -> Self {
        let mut tower = self.clone();
        tower.inertia_by_frequency = None;
        tower.base.inertia = inertia;
        tower
    }
}

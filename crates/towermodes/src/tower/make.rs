//! Makes a tower from a description: checks, linear pieces, independent motions.

use super::attachment::Attachment;
use super::description::TowerDescription;
use super::error::{Place, Problem, TowerError};
use super::floating::afloat::Afloat;
use super::foundation::Foundation;
use super::frame::FrameFoundation;
use super::ground::{GroundPlan, with_rows};
use super::model::{InGround, Tower};
use super::name::printable;
use super::parts::missing::MissingParts;
use super::parts::rotor::Rotor;
use super::pieces::immersion::in_environment;
use super::pieces::piece;
use super::pieces::piece::{Piece, Rows};
use super::pieces::weight::Above;
use super::plausibility::{self, Given, rotor_plausibility};
use super::support::added_mass::InertiaByFrequency;
use super::support::base::Base;
use super::support::independent;
use super::support::independent::{Motion, Motions};
use super::support::rigid_body_modes;
use super::validate;
use crate::tower::Warning;
use std::mem::take;
use std::sync::Arc;

impl Tower {
    /// Checks a description and makes the tower of it.
    ///
    /// # Errors
    /// [`TowerError`] for the first invalid value, with its place and its numbers.
    pub fn new(description: TowerDescription) -> Result<Self, TowerError> {
        validate::validate(&description)?;
        let description = description.with_complete_frame();
        if description.ground.is_some() {
            return Self::in_ground(&description);
        }
        let mut description = description;
        let mut tower = Self::supported(&mut description)?;
        tower.warnings = plausibility::plausibility(&tower, &Given::of(&description));
        Ok(tower)
    }

    /// The tower of a checked description with soil in layers.
    fn in_ground(description: &TowerDescription) -> Result<Self, TowerError> {
        let plan = GroundPlan::of(description);
        let mut rows = with_rows(description.clone(), &plan);
        validate::check_springs_of_ground(&rows, description.soil.len())?;
        let mut tower = Self::supported(&mut rows)?;
        tower.ground = description.ground.as_ref().map(|ground| InGround {
            surface_m: ground.scoured_surface_m(),
            at_tip: plan.at_tip(description).unwrap_or_default(),
            soil_error: plan.error(),
        });
        tower.warnings = plausibility::plausibility(&tower, &Given::of(description));
        Ok(tower)
    }

    /// The tower of a checked description, if it is supported.
    fn supported(description: &mut TowerDescription) -> Result<Self, TowerError> {
        let pieces = pieces_of(description, Rows::Fewest);
        let mut tower = Self::made_of(description, pieces);
        rigid_body_modes::check(&tower)?;
        tower.check_equilibrium()?;
        tower.base.units = tower.base_units();
        Ok(tower)
    }

    /// Refuses mooring lines for which no equilibrium exists.
    fn check_equilibrium(&self) -> Result<(), TowerError> {
        let mistake = self.afloat.as_ref().and_then(|afloat| afloat.mistake());
        mistake.map_or(Ok(()), |mistake| {
            let place = Place::Foundation {
                key: "at_equilibrium",
            };
            let problem = Problem::Equilibrium(mistake);
            Err(TowerError { place, problem })
        })
    }

    /// The tower of a checked description, or of a slightly changed one, with these linear pieces.
    /// Parts that the tower keeps are removed from the description.
    pub(super) fn made_of(description: &mut TowerDescription, pieces: Vec<Piece>) -> Self {
        let pieces = in_environment(pieces, description);
        Self::made_of_parts(description, pieces)
    }

    /// As [`made_of`](Self::made_of), with pieces that already have their soil and water.
    pub(super) fn made_of_parts(description: &mut TowerDescription, pieces: Vec<Piece>) -> Self {
        let (base_m, top_m) = (pieces[0].base_m, pieces[pieces.len() - 1].top_m);
        let mut attachments = attachments_of(description, top_m);
        attachments.sort_by(|a, b| a.height_m.total_cmp(&b.height_m));
        let above = Above::new(&pieces, &attachments);
        let masses = description.point_masses.iter();
        let mass_kg = above.tower_kg + masses.map(|m| m.mass_kg).sum::<f64>();
        let carried_kg = mass_kg + description.rna.mass_kg;
        let afloat = Afloat::at_rest(description, &pieces);
        let linear = afloat.as_ref().and_then(|afloat| afloat.linear.as_ref());
        let frame = held_frame(description, afloat.as_ref());
        let platform = linear.or(description.foundation.floating());
        // On a floating frame the joints have everything except this.
        let riding = platform.map(|platform| match &frame {
            Some(_) => platform.added_mass_alone(),
            None => platform.clone(),
        });
        let base = match &riding {
            Some(platform) => Base {
                on_frame: frame.is_some(),
                ..Base::afloat(platform, base_m, carried_kg)
            },
            None => Base::new(&description.foundation, base_m, carried_kg),
        };
        let inertia_by_frequency = riding
            .and_then(|platform| InertiaByFrequency::of(&platform, base_m))
            .map(Box::new);
        let by_frequency = inertia_by_frequency.iter();
        let by_frequency = by_frequency.flat_map(|by_frequency| by_frequency.matrices());
        let of_base = [&base.stiffness, &base.inertia];
        let matrices = attachments
            .iter()
            .flat_map(Attachment::matrices)
            .chain(of_base)
            .chain(by_frequency);
        let planes_are_equal = pieces.iter().all(Piece::planes_are_equal)
            && base.moves[0] == base.moves[1]
            && base.moves[3] == base.moves[4]
            && matrices.clone().all(independent::planes_are_equal);
        let independent = independent::independent_motions(matrices);
        let is_uncoupled = independent.len() == Motion::ALL.len();
        let independent = match &frame {
            Some(_) => vec![Motions::all()],
            None => possible(independent, &pieces, &base),
        };
        Self {
            planes_are_equal: planes_are_equal && is_uncoupled && frame.is_none(),
            planes_are_apart: false,
            independent,
            frame,
            afloat: afloat.map(Arc::new),
            name: printable(&description.name),
            stations: take(&mut description.stations),
            properties: take(&mut description.properties),
            rna: description.rna,
            point_masses: take(&mut description.point_masses),
            pieces,
            attachments,
            base,
            inertia_by_frequency,
            gravity_m_per_s2: description.gravity_m_per_s2,
            rotor: description.rotor.take(),
            above,
            outfitting_factor: description.outfitting_factor,
            mass_kg,
            ground: None,
            missing: (!description.missing_parts.is_empty()).then(|| {
                let is_clamped = description.foundation == Foundation::Clamped;
                let missing = MissingParts::of(&description.missing_parts, is_clamped);
                MissingParts {
                    is_requested: missing.is_clamped && description.is_clamped_by_request,
                    ..missing
                }
            }),
            warnings: Vec::new(),
        }
    }

    /// Probable mistakes in the values of a rotor on this tower. They matter only for the resonance
    /// check, so [`warnings`](Self::warnings) does not contain them.
    pub fn rotor_warnings(&self, rotor: &Rotor) -> Vec<Warning> {
        rotor_plausibility(self, rotor)
    }
}

/// The frame of a tower; if it floats, with hydrostatic and mooring stiffness.
fn held_frame(
    description: &TowerDescription,
    afloat: Option<&Afloat>,
) -> Option<Box<FrameFoundation>> {
    let mut frame = description.foundation.frame()?.clone();
    if let Some(afloat) = afloat {
        afloat.hold(&mut frame);
    }
    Some(Box::new(frame))
}

/// The sets without the motions that are impossible because the tower is rigid in them and its base
/// is fixed.
fn possible(sets: Vec<Motions>, pieces: &[Piece], base: &Base) -> Vec<Motions> {
    let is_held = |motion: &Motion| {
        let components = motion.components();
        pieces[0].is_rigid_in(*motion) && components.iter().all(|(i, _)| !base.moves[*i])
    };
    let held = Motion::ALL.into_iter().filter(is_held);
    let held: Vec<Motion> = held.collect();
    let without = |set: Motions| held.iter().fold(set, |set, motion| set.without(*motion));
    let sets = sets.into_iter().map(without);
    sets.filter(|set| set.iter().next().is_some()).collect()
}

pub(super) fn pieces_of(description: &TowerDescription, rows: Rows) -> Vec<Piece> {
    let factor = description.outfitting_factor;
    if description.stations.is_empty() {
        return piece::table_pieces(&description.properties, factor, rows);
    }
    let (stations, materials) = (&description.stations, &description.materials);
    piece::tube_pieces(stations, materials, factor, description.shear, rows)
}

/// The attachments of a tower, in the order of the description.
pub(super) fn attachments_of(description: &TowerDescription, top_m: f64) -> Vec<Attachment> {
    let masses = description.point_masses.iter();
    let wires = description.wires.iter();
    let mut attachments: Vec<Attachment> = masses.map(Attachment::of_point_mass).collect();
    attachments.extend(wires.map(Attachment::of_wires));
    attachments.push(Attachment::of_rna(&description.rna, top_m));
    attachments
}

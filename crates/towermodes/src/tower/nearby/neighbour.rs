//! Towers near a tower, assembled alike, so that a derivative can be taken between them.

use super::super::attachment::Attachment;
use super::super::description::TowerDescription;
use super::super::error::TowerError;
use super::super::ground::{GroundPlan, with_rows};
use super::super::make::{attachments_of, pieces_of};
use super::super::model::Tower;
use super::super::pieces::fronts::{Fronts, Sliver};
use super::super::pieces::immersion::cut_in_environment;
use super::super::pieces::piece::{Profile, Rows};
use super::super::pieces::weight::Above;
use super::super::support::independent::Motions;
use crate::space::transform_matrix;

/// A tower and the towers near it, which differ in numbers and never in structure: the same linear
/// pieces, attachments at the same borders, the same sets of coupled motions.
///
/// Every two rows are a piece of their own, and the bending planes are separate even if they are
/// equal: a neighbour's row may leave the line of its neighbours, and its planes may differ.
#[derive(Debug, Clone)]
pub(crate) struct Neighbours {
    description: TowerDescription,
    tower: Tower,
    /// Where each attachment of the description is in the tower's list.
    places: Vec<usize>,
    /// Where the springs of the ground are cut into rows.
    plan: GroundPlan,
    /// The cuts of the tower by soil and water.
    fronts: Fronts,
}

/// A tower near another one.
#[derive(Debug, Clone)]
pub(crate) struct Neighbour {
    /// With the sets of coupled motions of the first tower.
    pub(crate) tower: Tower,
    /// The sets that it really has.
    pub(crate) coupled: Vec<Motions>,
    /// Soil and water that begin or end a little off the border between pieces that they have on
    /// the first tower.
    pub(crate) slivers: Vec<Sliver>,
    /// How far (m) each attachment is above the end of a piece that carries it; empty if all are
    /// where they are carried.
    pub(crate) arms_m: Vec<f64>,
}

impl Neighbours {
    /// Of a tower that is checked.
    ///
    /// # Errors
    /// [`TowerError`], as [`Tower::new`].
    pub(crate) fn of(description: &TowerDescription) -> Result<Self, TowerError> {
        let checked = Tower::new(description.clone())?;
        let complete = description.clone().with_complete_frame();
        let plan = GroundPlan::of(&complete);
        let rows = with_rows(complete, &plan);
        let pieces = pieces_of(&rows, Rows::Each);
        let mut tower = Tower::made_of(&mut rows.clone(), pieces);
        tower.base.units = checked.base.units;
        tower.planes_are_equal = false;
        tower.planes_are_apart = true;
        Ok(Self {
            places: places(&attachments_of(&rows, tower.top_m())),
            fronts: Fronts::of(&rows, &tower),
            plan,
            description: description.clone(),
            tower,
        })
    }

    /// The description of the tower.
    pub(crate) fn description(&self) -> &TowerDescription {
        &self.description
    }

    /// The tower itself.
    pub(crate) fn tower(&self) -> &Tower {
        &self.tower
    }

    /// The tower of a description near that of the first; none if its structure is another one.
    /// It is not checked.
    pub(crate) fn near(&self, description: &TowerDescription) -> Option<Neighbour> {
        let complete;
        let description = match description.foundation.frame() {
            Some(_) => {
                complete = description.clone().with_complete_frame();
                &complete
            }
            None => description,
        };
        let in_rows;
        let description = match description.ground {
            Some(_) => {
                in_rows = with_rows(description.clone(), &self.plan);
                &in_rows
            }
            None => description,
        };
        let pieces = pieces_of(description, Rows::Each);
        if pieces.is_empty() {
            return None;
        }
        let cuts_m = self.fronts.cuts_m(description, &pieces);
        let pieces = cut_in_environment(pieces, description, &cuts_m);
        let mut tower = Tower::made_of_parts(&mut without_rows(description), pieces);
        let own = &self.tower;
        // The trees that carry the joints of a frame follow from its numbers, but for springs.
        let without_springs = |tower: &Tower| {
            tower.frame.clone().map(|mut frame| {
                frame.remove_springs();
                frame
            })
        };
        if own.frame != tower.frame && without_springs(own) != without_springs(&tower) {
            return None;
        }
        let base = &mut tower.base;
        if base.moves != own.base.moves || tower.pieces.len() != own.pieces.len() {
            return None;
        }
        base.units = own.base.units;
        let arms_m = self.attach(description, &mut tower)?;
        tower.planes_are_equal = false;
        tower.planes_are_apart = true;
        let coupled = std::mem::replace(&mut tower.independent, own.independent.clone());
        let slivers = self.fronts.slivers(description, &tower, &cuts_m);
        self.is_alike(&tower).then_some(Neighbour {
            tower,
            coupled,
            slivers,
            arms_m,
        })
    }

    /// Puts the attachments of a neighbour in the order of the first tower. What is at the end of a
    /// piece there is carried by the end of this piece. The result is how far (m) above it each is,
    /// if one is not there.
    fn attach(&self, description: &TowerDescription, tower: &mut Tower) -> Option<Vec<f64>> {
        let attached = attachments_of(description, tower.top_m());
        if attached.len() != self.places.len() {
            return None;
        }
        let mut arms_m = Vec::new();
        for (attachment, &place) in attached.iter().zip(&self.places) {
            let height_m = self.tower.attachments[place].height_m;
            let ends = self
                .tower
                .border_of(height_m)
                .map(|end| tower.border_m(end));
            if let Some(border_m) = ends.filter(|border_m| *border_m != attachment.height_m) {
                arms_m.resize(attached.len(), 0.0);
                arms_m[place] = attachment.height_m - border_m;
            }
            tower.attachments[place] = match ends {
                Some(border_m) => attachment.carried_at(border_m),
                None => *attachment,
            };
        }
        tower.weigh_again();
        Some(arms_m)
    }

    /// Whether a tower has the structure of the first.
    fn is_alike(&self, tower: &Tower) -> bool {
        let kind = |profile: &Profile| std::mem::discriminant(profile);
        let mut pieces = self.tower.pieces.iter().zip(&tower.pieces);
        let pieces_are = pieces.all(|(own, other)| {
            let soil = own.environment.soil.is_some() == other.environment.soil.is_some();
            soil && kind(&own.profile) == kind(&other.profile) && other.length_m() > 0.0
        });
        let rises = |pair: (&[Attachment], &[Attachment])| {
            let order = |pair: &[Attachment]| pair[0].height_m.partial_cmp(&pair[1].height_m);
            order(pair.0) == order(pair.1)
        };
        let own = self.tower.attachments.windows(2);
        pieces_are && own.zip(tower.attachments.windows(2)).all(rises)
    }

    /// The height (m) of a neighbour that each height (m) of the first tower becomes: ends of
    /// pieces and attachments move to their new heights, what is between them in proportion.
    pub(crate) fn moves(&self, neighbour: &Tower) -> impl Fn(f64) -> f64 + use<> {
        let (own, new) = (knots(&self.tower), knots(neighbour));
        move |height_m| {
            let above = own.partition_point(|knot| *knot < height_m);
            match (own.get(above), above.checked_sub(1)) {
                (Some(knot), _) if *knot == height_m => new[above],
                (Some(_), Some(below)) => {
                    let share = (height_m - own[below]) / (own[above] - own[below]);
                    new[below] + share * (new[above] - new[below])
                }
                _ => height_m,
            }
        }
    }
}

/// What a description has besides the rows of the tower and its surroundings. Every field is named
/// here, so that a new one is a decision.
fn without_rows(description: &TowerDescription) -> TowerDescription {
    let TowerDescription {
        // The pieces are made of these.
        materials: _,
        stations: _,
        properties: _,
        shear: _,
        soil: _,
        ground: _,
        added_mass: _,
        water: _,
        outfitting_factor,
        rna,
        point_masses,
        wires,
        foundation,
        gravity_m_per_s2,
        // No frequency depends on these.
        name: _,
        rna_is_point: _,
        rna_inertia_is_partial: _,
        mooring_is_computed: _,
        rotor: _,
        damping: _,
        drivetrain: _,
        part_names: _,
        missing_parts: _,
        is_clamped_by_request: _,
    } = description;
    TowerDescription {
        outfitting_factor: *outfitting_factor,
        rna: *rna,
        point_masses: point_masses.clone(),
        wires: wires.clone(),
        foundation: foundation.clone(),
        gravity_m_per_s2: *gravity_m_per_s2,
        ..TowerDescription::default()
    }
}

/// The ends of pieces and the attachments of a tower, m, rising.
fn knots(tower: &Tower) -> Vec<f64> {
    let ends = tower.pieces.iter().map(|piece| piece.top_m);
    let attached = tower.attachments.iter().map(|a| a.height_m);
    let mut knots: Vec<f64> = ends.chain(attached).chain([tower.base_m()]).collect();
    knots.sort_by(f64::total_cmp);
    knots.dedup();
    knots
}

/// The place of each attachment by height.
fn places(attached: &[Attachment]) -> Vec<usize> {
    let mut by_height: Vec<usize> = (0..attached.len()).collect();
    by_height.sort_by(|&a, &b| attached[a].height_m.total_cmp(&attached[b].height_m));
    let mut places = vec![0; attached.len()];
    for (place, index) in by_height.into_iter().enumerate() {
        places[index] = place;
    }
    places
}

impl Attachment {
    /// The same body or spring, carried by the tower at another height (m) through a rigid arm.
    fn carried_at(&self, height_m: f64) -> Self {
        let rise_m = self.height_m - height_m;
        let mut carried = Self {
            height_m,
            overturning_kg_m: self.overturning_kg_m + self.mass_kg * rise_m,
            ..*self
        };
        transform_matrix(&mut carried.inertia, rise_m);
        transform_matrix(&mut carried.stiffness, rise_m);
        carried
    }
}

impl Tower {
    /// Sums the weights after a change of the attachments.
    fn weigh_again(&mut self) {
        self.above = Above::new(&self.pieces, &self.attachments);
    }

    /// The number of the border between pieces that is at a height (m): 0 for the base.
    pub(crate) fn border_of(&self, height_m: f64) -> Option<usize> {
        let borders = self.pieces.len() + 1;
        (0..borders).find(|&border| self.border_m(border) == height_m)
    }

    /// The height of a border between pieces, m.
    fn border_m(&self, border: usize) -> f64 {
        match border.checked_sub(1) {
            None => self.base_m(),
            Some(piece) => self.pieces[piece].top_m,
        }
    }
}

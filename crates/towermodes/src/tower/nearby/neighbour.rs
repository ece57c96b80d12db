//! Slightly changed towers with the same structure, so that a difference quotient with the original
//! tower is a derivative.

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
    /// Index of each attachment of the description in the tower's list.
    places: Vec<usize>,
    /// The heights at which the springs of the ground are computed.
    plan: GroundPlan,
    /// The borders due to soil and water.
    fronts: Fronts,
}

/// A slightly changed tower.
#[derive(Debug, Clone)]
pub(crate) struct Neighbour {
    /// The changed tower, with the sets of coupled motions of the original tower.
    pub(crate) tower: Tower,
    /// Its own sets of coupled motions.
    pub(crate) coupled: Vec<Motions>,
    /// Soil and water that begin or end at a small distance from the border of the original tower.
    pub(crate) slivers: Vec<Sliver>,
    /// Distance (m) of each attachment above the end of the piece that carries it; empty if all
    /// distances are zero.
    pub(crate) arms_m: Vec<f64>,
}

impl Neighbours {
    /// The neighbours of a checked tower.
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

    /// The tower of a slightly changed description; none if its structure is different. It is not
    /// checked.
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
        // The trees that carry the joints of a frame depend on its values, except springs.
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

    /// Sorts the attachments of a changed tower in the order of the original one. An attachment at
    /// the end of a piece of the original tower is carried by the end of the same piece. Returns
    /// the distance (m) of each above this end, if any distance is not zero.
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

    /// Whether a tower has the structure of the original one.
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

    /// The height (m) on a changed tower for each height (m) on the original one: ends of pieces
    /// and attachments move to their new heights, other heights in proportion.
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

/// All fields of a description except the rows of the tower and its surroundings. Every field is
/// named here, so that a new field needs a decision.
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

/// The index of each attachment by height.
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

    /// The index of the border between pieces at a height (m): 0 for the base.
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

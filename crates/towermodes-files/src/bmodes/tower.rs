//! A tower from a deck.

use towermodes::{
    Inertia, Method, Place, Planes, Properties, PropertyStation, Rna, TowerDescription,
};

use super::Sources;
use super::deck::{Deck, Section};
use super::foundation::foundation;
use super::notes::{Notes, tower_notes};
use super::reader::Value;
use crate::diagnostic::Diagnostic;
use crate::input::{FileFormat, InputError, OutLayout, RotorNotes, TowerInput};
use crate::places::{Places, TABLE};

/// The places of the main file and of the section file among a deck's files.
pub(super) const MAIN: usize = 0;
const SECTIONS: usize = 1;

/// A tower's description as it grows, with the places of its values.
pub(super) struct Building {
    pub(super) description: TowerDescription,
    pub(super) places: Places,
    pub(super) ends: Ends,
}

/// Heights of a tower's flexible base and its top above ground or sea level, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ends {
    pub(super) base_m: f64,
    pub(super) top_m: f64,
}

impl Ends {
    fn of(deck: &Deck) -> Result<Self, Diagnostic> {
        let general = &deck.general;
        let draft = deck.support.offshore.as_ref().map(|block| &block.draft_m);
        let ends = Self {
            base_m: general.root_m.value - draft.map_or(0.0, |draft| draft.value),
            top_m: general.radius_m.value,
        };
        let length_m = ends.top_m - ends.base_m;
        if length_m > 0.0 && length_m.is_finite() {
            return Ok(ends);
        }
        let message = format!(
            "the tower reaches from {} m (hub_rad - draft) to {} m (radius): it has no length",
            ends.base_m, ends.top_m
        );
        Err(draft.unwrap_or(&general.radius_m).wrong(message))
    }

    /// The height at a share of the flexible length, m; that of its ends exactly.
    fn at(self, share: f64) -> f64 {
        if share == 1.0 {
            return self.top_m;
        }
        self.base_m + share * (self.top_m - self.base_m)
    }
}

/// What a deck says of a tower; with `quirks` as BModes 3.00 understands it.
pub(super) fn tower(deck: &Deck, sources: Sources, quirks: bool) -> Result<TowerInput, InputError> {
    let in_main = |mistake| InputError::mistake(&sources.main, mistake);
    let ends = Ends::of(deck).map_err(in_main)?;
    let mut notes = Notes::default();
    let mut building = Building {
        description: TowerDescription {
            name: deck.title.clone(),
            ..TowerDescription::default()
        },
        places: Places::default(),
        ends,
    };
    building
        .stations(deck, quirks)
        .map_err(|mistake| InputError::mistake(&sources.sections, mistake))?;
    building.top_body(deck, quirks);
    let borders_m: Vec<f64> = deck
        .borders
        .iter()
        .map(|border| ends.at(border.value))
        .collect();
    building.wires(&deck.support.wires, &borders_m, quirks);
    building.surroundings(deck, &mut notes).map_err(in_main)?;
    foundation(deck, &mut building, &mut notes).map_err(in_main)?;
    let modes = tower_notes(deck, quirks, &mut notes).map_err(in_main)?;
    let offshore = deck.support.offshore.as_ref();
    let draft_m = offshore.map_or(0.0, |block| block.draft_m.value);
    let Building {
        description,
        places,
        ..
    } = building;
    Ok(TowerInput {
        format: FileFormat::Bmodes,
        description,
        borders_m: Some(borders_m),
        method: Some(Method::Bmodes),
        modes: Some(modes),
        blades: None,
        blade: None,
        joint_m: None,
        layout: OutLayout {
            radius_m: Some(deck.general.radius_m.value + draft_m),
            ..deck.general.layout
        },
        notes: notes.of(&sources),
        rotor_notes: RotorNotes::default(),
        sources: sources.into_list(),
        places,
    })
}

/// A value times its factor, where a number has room for it.
pub(super) fn scaled(value: &Value<f64>, factor: &Value<f64>) -> Result<f64, Diagnostic> {
    let product = value.value * factor.value;
    let is_lost = product == 0.0 && value.value != 0.0 && factor.value != 0.0;
    if product.is_finite() && !is_lost {
        return Ok(product);
    }
    let message = format!(
        "{} times its factor {} has no room in a number",
        value.value, factor.value
    );
    Err(value.wrong(message))
}

impl Building {
    fn stations(&mut self, deck: &Deck, quirks: bool) -> Result<(), Diagnostic> {
        let first = deck
            .sections
            .first()
            .map_or(0..0, |row| row.location.span.clone());
        self.places.remember(Place::Stations, SECTIONS, first);
        for (index, section) in deck.sections.iter().enumerate() {
            self.remember_station(index, section);
            let row = PropertyStation {
                height_m: self.ends.at(section.location.value),
                properties: properties(section, deck, quirks)?,
            };
            self.description.properties.push(row);
        }
        Ok(())
    }

    fn remember_station(&mut self, index: usize, section: &Section) {
        let columns = [
            ("height", &section.location),
            ("mass_kg_per_m", &section.mass_kg_per_m),
            ("ei_fore_aft_n_m2", &section.flap_n_m2),
            ("ei_side_side_n_m2", &section.flap_n_m2),
            ("gj_n_m2", &section.torsion_n_m2),
            ("ea_n", &section.axial_n),
            ("polar_inertia_kg_m", &section.flap_inertia_kg_m),
            ("rotary_inertia_fore_aft_kg_m", &section.flap_inertia_kg_m),
            ("rotary_inertia_side_side_kg_m", &section.flap_inertia_kg_m),
            (TABLE, &section.location),
        ];
        for (key, value) in columns {
            let place = Place::Station { index, key };
            self.places.remember(place, SECTIONS, value.span.clone());
        }
    }

    fn top_body(&mut self, deck: &Deck, quirks: bool) {
        let tip = &deck.tip;
        let [xx, yy, zz, xy, xz, yz] = tip.inertia_kg_m2.each_ref().map(|entry| entry.value);
        self.description.rna = Rna {
            mass_kg: tip.mass_kg.value,
            center_m: tip_center(deck, quirks),
            inertia_kg_m2: Inertia {
                xx,
                yy,
                zz,
                xy,
                xz,
                yz,
            },
        };
        let spans = [
            ("mass", &tip.mass_kg),
            ("center", &tip.cm_loc_m),
            ("inertia", &tip.inertia_kg_m2[0]),
            (TABLE, &tip.mass_kg),
        ];
        for (key, value) in spans {
            self.places
                .remember(Place::Rna { key }, MAIN, value.span.clone());
        }
    }
}

/// Where the centre of the body on the top lies.
fn tip_center(deck: &Deck, quirks: bool) -> [f64; 3] {
    let lateral_m = deck.tip.cm_loc_m.value;
    match &deck.tip.cm_axial_m {
        None => [lateral_m, 0.0, 0.0],
        // Version 3.00 takes the value of this line for the lateral offset.
        Some(axial) if quirks => [axial.value, 0.0, 0.0],
        Some(axial) => [lateral_m, 0.0, axial.value],
    }
}

/// A row in the library's terms. A tower's `edge_` columns are not read.
fn properties(section: &Section, deck: &Deck, quirks: bool) -> Result<Properties, Diagnostic> {
    let factors = &deck.multipliers;
    let named = Planes {
        fore_aft: &factors.flap,
        side_side: &factors.edge,
    };
    let bending = if quirks {
        Planes {
            fore_aft: named.side_side,
            side_side: named.fore_aft,
        }
    } else {
        named
    };
    let rotary = Planes {
        fore_aft: scaled(&section.flap_inertia_kg_m, &factors.flap_inertia)?,
        side_side: scaled(&section.flap_inertia_kg_m, &factors.edge_inertia)?,
    };
    Ok(Properties {
        mass_kg_per_m: scaled(&section.mass_kg_per_m, &factors.mass)?,
        rotary_inertia_kg_m: rotary,
        polar_inertia_kg_m: rotary.fore_aft + rotary.side_side,
        bending_n_m2: Planes {
            fore_aft: scaled(&section.flap_n_m2, bending.fore_aft)?,
            side_side: scaled(&section.flap_n_m2, bending.side_side)?,
        },
        torsion_n_m2: scaled(&section.torsion_n_m2, &factors.torsion)?,
        axial_n: scaled(&section.axial_n, &factors.axial)?,
        shear_n: None,
    })
}

//! The tower of a deck.

use towermodes::{
    Inertia, Method, Place, Planes, Properties, PropertyStation, Rna, TowerDescription,
};

use super::Sources;
use super::building::{Building, Ends, MAIN, SECTIONS};
use super::deck::{Deck, Section, scaled};
use super::foundation::foundation;
use super::notes::{Notes, tower_notes};
use crate::diagnostic::Diagnostic;
use crate::error::ReadError;
use crate::input::{FileFormat, OutLayout, TowerInput};
use crate::note::RotorNotes;
use crate::places::{Places, TABLE};

/// The tower of a deck; with `compatible` as BModes 3.00 understands it.
pub(super) fn tower(
    deck: &Deck,
    sources: Sources,
    compatible: bool,
) -> Result<TowerInput, ReadError> {
    let in_main = |mistake| ReadError::mistake(&sources.main, mistake);
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
        .stations(deck, compatible)
        .map_err(|mistake| ReadError::mistake(&sources.sections, mistake))?;
    building.top_body(deck, compatible);
    let borders_m: Vec<f64> = deck
        .borders
        .iter()
        .map(|border| ends.at(border.value))
        .collect();
    building.wires(&deck.support.wires, &borders_m, compatible);
    building.surroundings(deck, &mut notes).map_err(in_main)?;
    foundation(deck, &mut building, &mut notes).map_err(in_main)?;
    let modes = tower_notes(deck, compatible, &mut notes).map_err(in_main)?;
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

impl Building {
    fn stations(&mut self, deck: &Deck, compatible: bool) -> Result<(), Diagnostic> {
        let first = deck
            .sections
            .first()
            .map_or(0..0, |row| row.location.span.clone());
        self.places.remember(Place::Stations, SECTIONS, first);
        for (index, section) in deck.sections.iter().enumerate() {
            self.remember_station(index, section);
            let row = PropertyStation {
                height_m: self.ends.at(section.location.value),
                properties: properties(section, deck, compatible)?,
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

    fn top_body(&mut self, deck: &Deck, compatible: bool) {
        let tip = &deck.tip;
        let [xx, yy, zz, xy, xz, yz] = tip.inertia_kg_m2.each_ref().map(|entry| entry.value);
        self.description.rna = Rna {
            mass_kg: tip.mass_kg.value,
            center_m: tip_center(deck, compatible),
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

/// The centre of mass of the body on the tower top.
fn tip_center(deck: &Deck, compatible: bool) -> [f64; 3] {
    let lateral_m = deck.tip.cm_loc_m.value;
    match &deck.tip.cm_axial_m {
        None => [lateral_m, 0.0, 0.0],
        // Version 3.00 uses the value of this record as the lateral offset.
        Some(axial) if compatible => [axial.value, 0.0, 0.0],
        Some(axial) => [lateral_m, 0.0, axial.value],
    }
}

/// A row in the library's terms. The `edge_` columns are not used for towers.
fn properties(section: &Section, deck: &Deck, compatible: bool) -> Result<Properties, Diagnostic> {
    let factors = &deck.multipliers;
    let named = Planes {
        fore_aft: &factors.flap,
        side_side: &factors.edge,
    };
    let bending = if compatible {
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

//! The tower of a deck.

use towermodes::{Method, Place, Planes, Properties, PropertyStation, Rna};

use super::super::Sources;
use super::super::records::deck::{Deck, Section, scaled};
use super::super::records::parameters::Column;
use super::building::{Building, MAIN, SECTIONS};
use super::foundation::foundation;
use super::notes::{Notes, tower_notes};
use crate::diagnostic::Diagnostic;
use crate::error::ReadError;
use crate::input::{FileFormat, OutLayout, TowerInput};
use crate::places::TABLE;
use crate::prescribed::Prescribed;

/// The tower of a deck; with `compatible` as interpreted by BModes 3.00.
pub(crate) fn tower(
    deck: &Deck,
    sources: Sources,
    compatible: bool,
) -> Result<TowerInput, ReadError> {
    let in_main = |mistake| ReadError::mistake(&sources.main, mistake);
    let in_sections = |mistake| ReadError::mistake(&sources.sections, mistake);
    let mut building = Building::of(deck).map_err(in_main)?;
    let mut notes = Notes::default();
    building.stations(deck, compatible).map_err(in_sections)?;
    building.top_body(deck, compatible);
    let borders = deck.borders.iter();
    let borders_m: Vec<f64> = borders
        .map(|border| building.ends.at(border.value))
        .collect();
    building.wires(&deck.support.wires, &borders_m, compatible);
    building.surroundings(deck, &mut notes);
    foundation(deck, &mut building, &mut notes).map_err(in_main)?;
    let modes = tower_notes(deck, compatible, &mut notes).map_err(in_main)?;
    Ok(TowerInput {
        prescribed: Prescribed {
            method: Some(Method::Bmodes),
            borders_m: Some(borders_m),
            modes: Some(modes),
        },
        layout: out_layout(deck),
        notes: notes.of(&sources),
        places: building.places,
        ..TowerInput::new(
            FileFormat::Bmodes,
            building.description,
            sources.into_list(),
        )
    })
}

/// The layout of the results: BModes divides deflections by the radius plus the draft.
fn out_layout(deck: &Deck) -> OutLayout {
    let offshore = deck.support.offshore.as_ref();
    let draft_m = offshore.map_or(0.0, |block| block.draft_m.value);
    OutLayout {
        radius_m: Some(deck.general.radius_m.value + draft_m),
        ..deck.general.layout
    }
}

impl Building {
    fn stations(&mut self, deck: &Deck, compatible: bool) -> Result<(), Diagnostic> {
        let first = deck.sections.first();
        let first = first.map_or(0..0, |row| row[Column::Location].span.clone());
        self.places.remember(Place::Stations, SECTIONS, first);
        for (index, section) in deck.sections.iter().enumerate() {
            self.remember_station(index, section);
            let row = PropertyStation {
                height_m: self.ends.at(section[Column::Location].value),
                properties: properties(section, deck, compatible)?,
            };
            self.description.properties.push(row);
        }
        Ok(())
    }

    fn remember_station(&mut self, index: usize, section: &Section) {
        let columns = [
            ("height", &section[Column::Location]),
            ("mass_kg_per_m", &section[Column::Mass]),
            ("ei_fore_aft_n_m2", &section[Column::Flap]),
            ("ei_side_side_n_m2", &section[Column::Flap]),
            ("gj_n_m2", &section[Column::Torsion]),
            ("ea_n", &section[Column::Axial]),
            ("polar_inertia_kg_m", &section[Column::FlapInertia]),
            (
                "rotary_inertia_fore_aft_kg_m",
                &section[Column::FlapInertia],
            ),
            (
                "rotary_inertia_side_side_kg_m",
                &section[Column::FlapInertia],
            ),
            (TABLE, &section[Column::Location]),
        ];
        for (key, value) in columns {
            let place = Place::Station { index, key };
            self.places.remember(place, SECTIONS, value.span.clone());
        }
    }

    fn top_body(&mut self, deck: &Deck, compatible: bool) {
        let tip = &deck.tip;
        let inertia = tip.inertia_kg_m2.each_ref().map(|entry| entry.value);
        self.description.rna = Rna {
            mass_kg: tip.mass_kg.value,
            center_m: tip_center(deck, compatible),
            inertia_kg_m2: inertia.into(),
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

/// A row as a section of the library. The `edge_` columns are not used for towers.
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
        fore_aft: scaled(&section[Column::FlapInertia], &factors.flap_inertia)?,
        side_side: scaled(&section[Column::FlapInertia], &factors.edge_inertia)?,
    };
    Ok(Properties {
        mass_kg_per_m: scaled(&section[Column::Mass], &factors.mass)?,
        rotary_inertia_kg_m: rotary,
        polar_inertia_kg_m: rotary.fore_aft + rotary.side_side,
        bending_n_m2: Planes {
            fore_aft: scaled(&section[Column::Flap], bending.fore_aft)?,
            side_side: scaled(&section[Column::Flap], bending.side_side)?,
        },
        torsion_n_m2: scaled(&section[Column::Torsion], &factors.torsion)?,
        axial_n: scaled(&section[Column::Axial], &factors.axial)?,
        shear_n: None,
    })
}

//! `[ground]` and `[[ground.layer]]`: soil in layers around the embedded part of the tower.

mod layer;
mod profile;
mod shear_modulus;
mod soil;

use towermodes::inputs::Inputs;
use towermodes::{AxialModel, Foundation, FoundationSprings, Ground, Place, SoilModel};

use super::inputs::read;
use super::schema;
use super::text::choice::{choices, choices_hint, chosen};
use super::text::reading::Reading;
use super::text::table::{Table, every_table, with_names};
use crate::places::TABLE;
use profile::layers;

pub(super) use profile::profile_files;

const NO_FOUNDATION: &str = "there is no [foundation]: the tip of the pile, the lowest station, is free to translate in x and y and to rotate about x and y";
const RIGID_AXIS: &str = "there is no [foundation] and no axial model in [ground]: the tip of the pile, the lowest station, is free to translate in x and y and to rotate about x and y; translation in z and rotation about z are fixed";

const MODULUS_BY_EDITION: &str = "the modulus of sand follows API RP 2GEO; edition = \"rp-2a\" in [ground] selects API RP 2A, whose modulus is up to 38 % smaller";
const AXIAL_BY_EDITION: &str = "the axial springs of sand follow API RP 2GEO; edition = \"rp-2a\" in [ground] selects API RP 2A";
const BOTH_BY_EDITION: &str = "the modulus and the axial springs of sand follow API RP 2GEO; edition = \"rp-2a\" in [ground] selects API RP 2A, whose modulus is up to 38 % smaller";
const NO_EDITION: &str = "edition has no effect: no layer is sand whose modulus follows from its friction angle, or that has the axial springs of API";

fn at(key: &'static str) -> Place {
    Place::Ground { key }
}

/// The ground with the names of its layers: `Some(None)` if there is none, `None` after a mistake.
pub(super) fn ground(
    root: &Table<'_>,
    reading: &mut Reading,
) -> Option<Option<(Ground, Vec<String>)>> {
    let Some(value) = root.get("ground") else {
        return Some(None);
    };
    reading.remember(at(TABLE), value.span());
    let table = Table::of(value, "[ground]", &schema::GROUND, reading)?;
    let ground = read(Ground::blank(), &table, at, reading);
    let surface = ground.as_ref().map(|ground| ground.surface_m);
    let hint = "write [[ground.layer]] once for each layer, from the surface down";
    let layers = table.require("layer", hint, reading).and_then(|_| {
        let mut next = 0;
        let every = every_table(&table, "layer", "layer", reading, |_, value, reading| {
            let found = layers(next, value, surface, reading);
            next += found.as_ref().map_or(1, Vec::len);
            found
        });
        with_names(every.map(|every| every.into_iter().flatten().collect()))
    });
    let model = model(&table, reading);
    let (layers, names) = layers?;
    let ground = Ground {
        layers: layer::with_models(layers, model?, &table, reading)?,
        ..ground?
    };
    note_edition(&table, &ground, reading);
    Some(Some((ground, names)))
}

/// The note on the edition of the standard that is used if the file names none, or that a given
/// edition has no effect.
fn note_edition(table: &Table<'_>, ground: &Ground, reading: &mut Reading) {
    let (modulus, axial) = (
        ground.modulus_depends_on_edition(),
        ground.axial_depends_on_edition(),
    );
    match (table.get("edition"), modulus, axial) {
        (Some(value), false, false) => reading.note(value.span().start, NO_EDITION),
        (None, true, true) => reading.note(table.span.start, BOTH_BY_EDITION),
        (None, true, false) => reading.note(table.span.start, MODULUS_BY_EDITION),
        (None, false, true) => reading.note(table.span.start, AXIAL_BY_EDITION),
        (None, false, false) | (Some(_), _, _) => {}
    }
}

/// The support of the tip of a pile in ground, if the file has neither `[foundation]` nor
/// `[substructure]`; piles of a substructure have only the springs of the soil.
pub(super) fn default_foundation(
    root: &Table<'_>,
    ground: &Ground,
    reading: &mut Reading,
) -> Option<Foundation> {
    if root.get("foundation").is_some() || root.get("substructure").is_some() {
        return None;
    }
    let place = root.get("ground").map_or(0, |value| value.span().start);
    let (message, vertical_n_per_m) = match ground.axial {
        Some(_) => (NO_FOUNDATION, 0.0),
        None => (RIGID_AXIS, f64::INFINITY),
    };
    reading.note(place, message);
    let torsion_n_m = match ground.axial.is_some_and(AxialModel::resists_torsion) {
        true => 0.0,
        false => f64::INFINITY,
    };
    Some(Foundation::Springs(FoundationSprings {
        lateral_n_per_m: 0.0,
        rocking_n_m: 0.0,
        coupling_n: 0.0,
        vertical_n_per_m,
        torsion_n_m,
    }))
}

/// The model of the layers that give none.
fn model(table: &Table<'_>, reading: &mut Reading) -> Option<Option<SoilModel>> {
    let Some(value) = table.get("model") else {
        return Some(None);
    };
    chosen(value, "soil model", &choices(), reading).map(Some)
}

/// The hint on a missing model.
fn model_hint() -> String {
    choices_hint("model", &choices::<SoilModel>())
}

//! Keys that are similar to a key that is read: a misspelled key would be ignored without a
//! message.
//!
//! The known keys are in `known_keys.txt`: those of the schemas of windIO 1.0 and 2.x, whether read
//! or not, and those that WISDEM adds. They get no note.

use super::outline::{Components, Outline};
use super::reading::Reading;
use super::yaml::{Node, Value};
use crate::input::TowerPart;
use crate::note::Note;

/// The table of all kinds of mapping.
const TABLE: &str = include_str!("known_keys.txt");

/// The keys of a kind of mapping, separated by blanks.
#[derive(Debug, Clone, Copy)]
struct Keys {
    /// The keys that are read.
    read: &'static str,
    /// Other keys of this format.
    others: &'static str,
}

impl Keys {
    /// The keys of a kind of mapping, by its name in the table.
    fn of(kind: &str) -> Self {
        let mut lines = TABLE.lines();
        let found = lines.find_map(|line| line.strip_prefix(kind)?.strip_prefix(": "));
        let keys = found.and_then(|keys| keys.split_once('|'));
        debug_assert!(keys.is_some(), "{kind}");
        let (read, others) = keys.unwrap_or_default();
        Self { read, others }
    }

    fn read(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.read.split_whitespace()
    }

    fn others(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.others.split_whitespace()
    }

    fn has(&self, key: &str) -> bool {
        self.read().chain(self.others()).any(|known| known == key)
    }
}

/// Notes unknown keys, in all parts that are read, that are similar to a key that is read.
pub(crate) fn note_lookalikes(outline: &Outline, part: TowerPart, reading: &mut Reading<'_>) {
    note_names(&outline.unknown, "root", "the file", reading);
    let nodes = [
        (outline.assembly.as_ref(), "assembly"),
        (outline.environment.as_ref(), "environment"),
        (outline.control.as_ref(), "control"),
    ];
    for (node, kind) in nodes {
        note_keys(node, kind, kind, reading);
    }
    let control = outline.control.as_ref();
    let torque = control.and_then(|control| control.get("torque"));
    note_keys(torque, "torque", "control.torque", reading);
    if let Some(components) = &outline.components {
        note_names(&components.unknown, "components", "components", reading);
        note_structure(components, part, reading);
        if part != TowerPart::Monopile {
            note_assembly(components, reading);
        }
    }
}

/// Notes such keys of materials; only materials of walls are checked.
pub(crate) fn note_material(node: &Node, what: &str, reading: &mut Reading<'_>) {
    note_keys(Some(node), "material", what, reading);
}

/// Notes such keys of a jacket.
pub(crate) fn note_jacket(node: &Node, reading: &mut Reading<'_>) {
    note_keys(Some(node), "jacket", "jacket", reading);
}

fn note_structure(components: &Components, part: TowerPart, reading: &mut Reading<'_>) {
    let (tower, monopile) = (components.tower.as_ref(), components.monopile.as_ref());
    let parts = [
        (tower, TowerPart::Tower, "tower"),
        (monopile, TowerPart::Monopile, "monopile"),
    ];
    for (node, own, what) in parts {
        let Some(node) = node.filter(|_| part == own || part == TowerPart::All) else {
            continue;
        };
        note_keys(Some(node), "part", what, reading);
        for (key, kind) in [
            ("outer_shape", "shape"),
            ("outer_shape_bem", "shape"),
            ("structure", "structure"),
            ("internal_structure_2d_fem", "structure"),
            ("reference_axis", "axis"),
        ] {
            note_keys(node.get(key), kind, &format!("{what}.{key}"), reading);
        }
        note_curves(node, what, reading);
    }
}

/// Notes such keys of diameters, axes and layers.
fn note_curves(part: &Node, what: &str, reading: &mut Reading<'_>) {
    let shapes = [
        "outer_shape",
        "outer_shape_bem",
        "internal_structure_2d_fem",
    ];
    for shape in shapes.into_iter().filter_map(|key| part.get(key)) {
        for (key, kind) in [("outer_diameter", "curve"), ("reference_axis", "axis")] {
            note_keys(
                shape.get(key),
                kind,
                &format!("{key} of the {what}"),
                reading,
            );
        }
    }
    let structures = ["structure", "internal_structure_2d_fem"].into_iter();
    let lists = structures.filter_map(|key| part.get(key)?.get("layers"));
    for layer in lists.filter_map(|list| list.list("").ok()).flatten() {
        let of = format!("a layer of the {what}");
        note_keys(Some(layer), "layer", &of, reading);
        let of = format!("thickness of {of}");
        note_keys(layer.get("thickness"), "curve", &of, reading);
    }
}

/// Notes such keys of the parts from which the rotor-nacelle assembly is read.
fn note_assembly(components: &Components, reading: &mut Reading<'_>) {
    let (hub, nacelle) = (components.hub.as_ref(), components.nacelle.as_ref());
    let (drivetrain, yaw) = (components.drivetrain.as_ref(), components.yaw.as_ref());
    let nodes = [
        (hub, "hub", "hub"),
        (nacelle, "nacelle", "nacelle"),
        (drivetrain, "drivetrain", "drivetrain"),
        (yaw, "drivetrain", "yaw"),
    ];
    for (node, kind, what) in nodes {
        note_keys(node, kind, what, reading);
        for key in ["elastic_properties", "elastic_properties_mb"] {
            let body = node.and_then(|node| node.get(key));
            note_keys(body, "body", &format!("{what}.{key}"), reading);
        }
    }
    let hub_shape = hub.and_then(|hub| hub.get("outer_shape_bem"));
    note_keys(hub_shape, "hub", "hub.outer_shape_bem", reading);
    let shaft = nacelle.and_then(|nacelle| nacelle.get("drivetrain"));
    note_keys(shaft, "shaft", "nacelle.drivetrain", reading);
    let shaft = drivetrain.and_then(|drivetrain| drivetrain.get("outer_shape"));
    note_keys(shaft, "shaft", "drivetrain.outer_shape", reading);
}

fn note_keys(node: Option<&Node>, kind: &str, what: &str, reading: &mut Reading<'_>) {
    let Some(Value::Map(entries)) = node.map(|node| &node.value) else {
        return;
    };
    let keys = Keys::of(kind);
    for (key, value) in entries {
        note_key(key, value.span.start, keys, what, reading);
    }
}

/// Notes such keys whose values are not stored.
fn note_names(names: &[String], kind: &str, what: &str, reading: &mut Reading<'_>) {
    let end = reading.source.text.len();
    for name in names {
        note_key(name, end, Keys::of(kind), what, reading);
    }
}

fn note_key(key: &str, value_at: usize, keys: Keys, what: &str, reading: &mut Reading<'_>) {
    if keys.has(key) {
        return;
    }
    let Some(meant) = lookalike(key, keys) else {
        return;
    };
    let at = place_of(key, value_at, &reading.source.text);
    let message = format!("`{key}` of {what} is not read: did you mean `{meant}`?");
    reading.note_at(at, Note::suspicious(message));
}

/// The key that is read and is similar to another one, unless a key that is not read is equally
/// similar.
fn lookalike(key: &str, keys: Keys) -> Option<&'static str> {
    /// Largest length of a compared key; no key of the format is half as long.
    const LONGEST: usize = 80;
    if key.len() > LONGEST {
        return None;
    }
    let plain = |key: &str| -> String {
        let letters = key.chars().filter(|c| c.is_alphanumeric());
        letters.flat_map(char::to_lowercase).collect()
    };
    let written = plain(key);
    let distance = |known: &str| strsim::damerau_levenshtein(&written, &plain(known));
    let nearest = keys.read().min_by_key(|known| distance(known))?;
    let allowed = match nearest.len() {
        0..=3 => 0,
        4..=8 => 1,
        _ => 2,
    };
    let other = keys.others().map(distance).min();
    let found = distance(nearest);
    (found <= allowed && other.is_none_or(|other| found < other)).then_some(nearest)
}

/// The place of the key whose value begins at a byte: the nearest occurrence before it, or the
/// first in the file.
fn place_of(key: &str, value_at: usize, text: &str) -> usize {
    let before = text.get(..value_at).unwrap_or(text);
    let is_key = |at: usize| {
        let rest = text[at + key.len()..].trim_start_matches(['"', '\'', ' ']);
        let starts = before[..at].chars().next_back();
        rest.starts_with(':') && !starts.is_some_and(|c| c.is_alphanumeric() || c == '_')
    };
    let found = before
        .rmatch_indices(key)
        .map(|(at, _)| at)
        .find(|at| is_key(*at));
    found.or_else(|| text.find(key)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn misspelled_keys_look_like_those_that_are_read() {
        assert_eq!(
            lookalike("outfiting_factor", Keys::of("structure")),
            Some("outfitting_factor")
        );
        assert_eq!(
            lookalike("transition_peice_mass", Keys::of("part")),
            Some("transition_piece_mass")
        );
        assert_eq!(
            lookalike("Outer Diameter", Keys::of("shape")),
            Some("outer_diameter")
        );
        assert_eq!(lookalike("Rho", Keys::of("material")), Some("rho"));
        assert_eq!(lookalike("up_tilt", Keys::of("shaft")), Some("uptilt"));
    }

    #[test]
    fn other_keys_do_not() {
        for (key, kind) in [
            ("rated_power_user", "assembly"),
            ("cost", "material"),
            ("rpm", "control"),
            ("E1", "material"),
            ("height", "part"),
            ("transition_piece_costs", "part"),
            ("system_inertia_tt2", "body"),
        ] {
            assert_eq!(lookalike(key, Keys::of(kind)), None, "{key}");
        }
    }

    #[test]
    fn a_key_is_found_before_its_value() {
        let text = "a: {mas: 1}\nb:\n  \"mas\" : 2\n  mas_x: 3\n";
        let at = |needle: &str| text.find(needle).expect("in the text");
        assert_eq!(place_of("mas", at("1}"), text), at("mas:"));
        assert_eq!(place_of("mas", at("2\n"), text), at("mas\" :"));
        assert_eq!(place_of("mas", text.len(), text), at("mas\" :"));
    }
}

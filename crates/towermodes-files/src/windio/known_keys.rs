//! Keys that look like a key that is read: a misspelled key would be ignored without a message.
//!
//! Known are the keys of the schemas of windIO 1.0 and 2.x, read or not, and those that WISDEM
//! adds. They get no note.

use super::outline::{Components, Outline};
use super::reading::Reading;
use super::yaml::{Node, Value};
use crate::input::TowerPart;
use crate::note::Note;

/// The keys of a mapping.
struct Keys {
    /// Those that are read, separated by blanks.
    read: &'static str,
    /// Others that files of this format have.
    others: &'static str,
}

impl Keys {
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

const ROOT: Keys = Keys {
    read: "windIO_version name assembly components materials environment control",
    others: "comments airfoils outputs bos costs TMDs",
};
const COMPONENTS: Keys = Keys {
    read: "tower monopile jacket floating_platform hub nacelle drivetrain yaw blade",
    others: "mooring",
};
const ASSEMBLY: Keys = Keys {
    read: "rotor_orientation number_of_blades rotor_diameter",
    others: "turbine_class turbulence_class drivetrain hub_height rated_power lifetime \
        cut_in_wind_speed cut_out_wind_speed marine_hydro",
};
const ENVIRONMENT: Keys = Keys {
    read: "water_depth soil_shear_modulus soil_poisson",
    others: "gravity air_density air_dyn_viscosity air_pressure air_vapor_pressure \
        weib_shape_parameter air_speed_sound shear_exp water_density water_dyn_viscosity \
        V_mean significant_wave_height significant_wave_period",
};
const CONTROL: Keys = Keys {
    read: "min_rotor_speed rated_rotor_speed max_rotor_speed torque",
    others: "supervisory pitch setpoint_smooth shutdown rated_power",
};
const TORQUE: Keys = Keys {
    read: "VS_minspd VS_maxspd",
    others: "max_torque_rate tsr VS_ControlMode control_type",
};
const PART: Keys = Keys {
    read: "reference_axis outer_shape outer_shape_bem structure internal_structure_2d_fem \
        elastic_properties_mb transition_piece_mass gravity_foundation_mass",
    others: "transition_piece_cost transition_piece_height loading",
};
const SHAPE: Keys = Keys {
    read: "outer_diameter reference_axis",
    others: "drag_coefficient cd ca side_length_a side_length_b shape",
};
const STRUCTURE: Keys = Keys {
    read: "outfitting_factor layers elastic_properties reference_axis",
    others: "webs joint anchors",
};
const LAYER: Keys = Keys {
    read: "material thickness",
    others: "name n_plies fiber_orientation",
};
const CURVE: Keys = Keys {
    read: "grid values",
    others: "",
};
const AXIS: Keys = Keys {
    read: "x y z",
    others: "",
};
const BODY: Keys = Keys {
    read: "system_mass system_inertia system_center_mass above_yaw_mass yaw_mass mass \
        inertia location",
    others: "system_inertia_tt system_center_mass_tt spring_stiffness damping",
};
const HUB: Keys = Keys {
    read: "diameter cone_angle outer_shape_bem elastic_properties_mb elastic_properties",
    others: "cd drag_coefficient hub spinner pitch_system flange_t2shell_t",
};
const NACELLE: Keys = Keys {
    read: "drivetrain elastic_properties_mb",
    others: "generator outer_shape_bem",
};
const DRIVETRAIN: Keys = Keys {
    read: "outer_shape elastic_properties",
    others: "gearbox lss hss nose bedplate other_components generator brake converter \
        transformer",
};
const SHAFT: Keys = Keys {
    read: "uptilt overhang distance_tt_hub",
    others: "distance_hub_mb distance_mb_mb cd generator_length generator_radius_user \
        gear_ratio gearbox_efficiency damping_ratio",
};
const MATERIAL: Keys = Keys {
    read: "name rho E G nu",
    others: "description source orth alpha Xt Xc Xy S A m R N ply_t unit_cost fvf fwf waste \
        fiber_density roll_mass component_id GIc GIIc alp0",
};

/// Notes the keys of everything that is read of the file that look like a key that is read.
pub(super) fn note_lookalikes(outline: &Outline, part: TowerPart, reading: &mut Reading<'_>) {
    note_names(&outline.unknown, &ROOT, "the file", reading);
    let nodes = [
        (outline.assembly.as_ref(), &ASSEMBLY, "assembly"),
        (outline.environment.as_ref(), &ENVIRONMENT, "environment"),
        (outline.control.as_ref(), &CONTROL, "control"),
    ];
    for (node, keys, what) in nodes {
        note_keys(node, keys, what, reading);
    }
    let torque = outline
        .control
        .as_ref()
        .and_then(|control| control.get("torque"));
    note_keys(torque, &TORQUE, "control.torque", reading);
    if let Some(components) = &outline.components {
        note_names(&components.unknown, &COMPONENTS, "components", reading);
        note_structure(components, part, reading);
        if part != TowerPart::Monopile {
            note_assembly(components, reading);
        }
    }
}

/// The same of materials, of which only those are looked at that walls are made of.
pub(super) fn note_material(node: &Node, what: &str, reading: &mut Reading<'_>) {
    note_keys(Some(node), &MATERIAL, what, reading);
}

fn note_structure(components: &Components, part: TowerPart, reading: &mut Reading<'_>) {
    let parts = [
        (components.tower.as_ref(), TowerPart::Tower, "tower"),
        (
            components.monopile.as_ref(),
            TowerPart::Monopile,
            "monopile",
        ),
    ];
    for (node, own, what) in parts {
        let Some(node) = node.filter(|_| part == own || part == TowerPart::All) else {
            continue;
        };
        note_keys(Some(node), &PART, what, reading);
        for (key, keys) in [
            ("outer_shape", &SHAPE),
            ("outer_shape_bem", &SHAPE),
            ("structure", &STRUCTURE),
            ("internal_structure_2d_fem", &STRUCTURE),
            ("reference_axis", &AXIS),
        ] {
            note_keys(node.get(key), keys, &format!("{what}.{key}"), reading);
        }
        note_curves(node, what, reading);
    }
}

/// Diameters, axes and layers.
fn note_curves(part: &Node, what: &str, reading: &mut Reading<'_>) {
    let shapes = [
        "outer_shape",
        "outer_shape_bem",
        "internal_structure_2d_fem",
    ];
    for shape in shapes.into_iter().filter_map(|key| part.get(key)) {
        note_keys(
            shape.get("outer_diameter"),
            &CURVE,
            &format!("outer_diameter of the {what}"),
            reading,
        );
        note_keys(
            shape.get("reference_axis"),
            &AXIS,
            &format!("reference_axis of the {what}"),
            reading,
        );
    }
    let structures = ["structure", "internal_structure_2d_fem"];
    let lists = structures
        .into_iter()
        .filter_map(|key| part.get(key)?.get("layers"));
    for layer in lists.filter_map(|list| list.list("").ok()).flatten() {
        note_keys(
            Some(layer),
            &LAYER,
            &format!("a layer of the {what}"),
            reading,
        );
        note_keys(
            layer.get("thickness"),
            &CURVE,
            &format!("thickness of a layer of the {what}"),
            reading,
        );
    }
}

/// What the rotor-nacelle assembly is read from.
fn note_assembly(components: &Components, reading: &mut Reading<'_>) {
    let (hub, nacelle) = (components.hub.as_ref(), components.nacelle.as_ref());
    let (drivetrain, yaw) = (components.drivetrain.as_ref(), components.yaw.as_ref());
    let nodes = [
        (hub, &HUB, "hub"),
        (nacelle, &NACELLE, "nacelle"),
        (drivetrain, &DRIVETRAIN, "drivetrain"),
        (yaw, &DRIVETRAIN, "yaw"),
    ];
    for (node, keys, what) in nodes {
        note_keys(node, keys, what, reading);
        for key in ["elastic_properties", "elastic_properties_mb"] {
            let body = node.and_then(|node| node.get(key));
            note_keys(body, &BODY, &format!("{what}.{key}"), reading);
        }
    }
    let hub_shape = hub.and_then(|hub| hub.get("outer_shape_bem"));
    note_keys(hub_shape, &HUB, "hub.outer_shape_bem", reading);
    let shaft = nacelle.and_then(|nacelle| nacelle.get("drivetrain"));
    note_keys(shaft, &SHAFT, "nacelle.drivetrain", reading);
    let shaft = drivetrain.and_then(|drivetrain| drivetrain.get("outer_shape"));
    note_keys(shaft, &SHAFT, "drivetrain.outer_shape", reading);
}

fn note_keys(node: Option<&Node>, keys: &Keys, what: &str, reading: &mut Reading<'_>) {
    let Some(Node {
        value: Value::Map(entries),
        ..
    }) = node
    else {
        return;
    };
    for (key, value) in entries {
        note_key(key, value.span.start, keys, what, reading);
    }
}

/// The same of keys whose values are not kept.
fn note_names(names: &[String], keys: &Keys, what: &str, reading: &mut Reading<'_>) {
    for name in names {
        let end = reading.source.text.len();
        note_key(name, end, keys, what, reading);
    }
}

fn note_key(key: &str, value_at: usize, keys: &Keys, what: &str, reading: &mut Reading<'_>) {
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

/// The key that is read and that another looks like, unless it looks as much like one that is not
/// read.
fn lookalike(key: &str, keys: &Keys) -> Option<&'static str> {
    /// No key of the format is half as long.
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

/// Where a key stands that has its value at a byte: the nearest place before it, or the first in
/// the file.
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
            lookalike("outfiting_factor", &STRUCTURE),
            Some("outfitting_factor")
        );
        assert_eq!(
            lookalike("transition_peice_mass", &PART),
            Some("transition_piece_mass")
        );
        assert_eq!(lookalike("Outer Diameter", &SHAPE), Some("outer_diameter"));
        assert_eq!(lookalike("Rho", &MATERIAL), Some("rho"));
        assert_eq!(lookalike("up_tilt", &SHAFT), Some("uptilt"));
    }

    #[test]
    fn other_keys_do_not() {
        for (key, keys) in [
            ("rated_power_user", &ASSEMBLY),
            ("cost", &MATERIAL),
            ("rpm", &CONTROL),
            ("E1", &MATERIAL),
            ("height", &PART),
            ("transition_piece_costs", &PART),
            ("system_inertia_tt2", &BODY),
        ] {
            assert_eq!(lookalike(key, keys), None, "{key}");
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

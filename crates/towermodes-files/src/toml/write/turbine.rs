//! `[turbine]`.

use towermodes::turbine::TurbineDescription;
use towermodes::{BladeDescription, BladeSection, Inertia, RigidBody};

use super::bodies::inertia_with;
use super::text::{quoted, triple};
use super::writing::Writing;
use crate::toml::schema;
use crate::toml::turbine::GENERATORS;
use crate::turbine::blade_borders;

pub(super) fn turbine(turbine: &TurbineDescription, writing: &mut Writing) {
    writing.section(&schema::TURBINE);
    writing.number("overhang", turbine.overhang_m);
    writing.number("tower_to_shaft", turbine.tower_to_shaft_m);
    writing.value("blades", &turbine.blades.to_string());
    let angles = [
        ("tilt_deg", turbine.tilt_rad),
        ("cone_deg", turbine.cone_rad),
        ("pitch_deg", turbine.blade.pitch_rad),
    ];
    for (key, angle_rad) in angles {
        unless(0.0, key, degrees(angle_rad), writing);
    }
    unless(
        f64::INFINITY,
        "shaft_stiffness",
        turbine.shaft_n_m_per_rad,
        writing,
    );
    let generator = &turbine.generator;
    let mut names = GENERATORS.iter();
    let name = names.find(|(_, is_locked)| *is_locked == generator.is_locked);
    let name = name.map_or("locked", |(name, _)| name);
    writing.value("generator", &quoted(name));
    unless(0.0, "generator_inertia", generator.inertia_kg_m2, writing);
    unless(1.0, "gear_ratio", generator.gear_ratio, writing);
    unless(
        f64::INFINITY,
        "yaw_stiffness",
        turbine.yaw_n_m_per_rad,
        writing,
    );
    unless(
        0.0,
        "yaw_bearing_mass",
        turbine.yaw_bearing_mass_kg,
        writing,
    );
    nacelle(&turbine.nacelle, writing);
    writing.section(&schema::HUB);
    let hub = &turbine.hub;
    writing.number("mass", hub.mass_kg);
    unless(0.0, "offset", hub.center_m, writing);
    unless(0.0, "polar_inertia", hub.polar_inertia_kg_m2, writing);
    unless(
        0.0,
        "transverse_inertia",
        hub.transverse_inertia_kg_m2,
        writing,
    );
    blade(&turbine.blade, writing);
}

/// Writes a number if it is not the default.
fn unless(default: f64, key: &str, value: f64, writing: &mut Writing) {
    if value != default {
        writing.number(key, value);
    }
}

fn nacelle(nacelle: &RigidBody, writing: &mut Writing) {
    writing.section(&schema::NACELLE);
    writing.number("mass", nacelle.mass_kg);
    if nacelle.center_m != [0.0; 3] {
        writing.value("center", &triple(nacelle.center_m));
    }
    if nacelle.inertia_kg_m2 != Inertia::default() {
        inertia_with(&nacelle.inertia_kg_m2, &[], writing);
    }
}

fn blade(blade: &BladeDescription, writing: &mut Writing) {
    writing.section(&schema::BLADE);
    writing.number("hub_radius", blade.hub_radius_m);
    writing.number("tip_radius", blade.tip_radius_m);
    unless(0.0, "tip_mass", blade.tip.mass_kg, writing);
    if blade.tip != RigidBody::point(blade.tip.mass_kg, [0.0; 3]) {
        writing.note("the offset and the inertia of the body at the blades' tips are left out");
    }
    if blade.borders != blade_borders(&blade.sections) {
        writing.note("the borders of the blade's elements are left out: they are its sections");
    }
    columns(&blade.sections, writing);
}

/// Writes the lists of the sections, each with a comment; lists with default values are omitted.
fn columns(sections: &[BladeSection], writing: &mut Writing) {
    type Column = (&'static str, Option<f64>, fn(&BladeSection) -> f64);
    let all: [Column; 11] = [
        ("span", None, |s| s.span),
        ("mass_kg_per_m", None, |s| s.mass_kg_per_m),
        ("ei_flap_n_m2", None, |s| s.flap_n_m2),
        ("ei_edge_n_m2", None, |s| s.edge_n_m2),
        ("twist_deg", Some(0.0), |s| degrees(s.twist_rad)),
        ("gj_n_m2", Some(f64::INFINITY), |s| s.torsion_n_m2),
        ("ea_n", Some(f64::INFINITY), |s| s.axial_n),
        ("flap_inertia_kg_m", Some(0.0), |s| s.flap_inertia_kg_m),
        ("edge_inertia_kg_m", Some(0.0), |s| s.edge_inertia_kg_m),
        ("center_of_mass_m", Some(0.0), |s| s.center_of_mass_m),
        ("tension_center_m", Some(0.0), |s| s.tension_center_m),
    ];
    for (key, default, value) in all {
        if sections
            .iter()
            .any(|section| Some(value(section)) != default)
        {
            let comment = writing.comment(key);
            writing.line(format!("# {comment}"));
            writing.list(key, sections.iter().map(value));
        }
    }
}

/// The shortest number of degrees that is read back as this angle; the nearest if there is none.
fn degrees(angle_rad: f64) -> f64 {
    let nearest = angle_rad.to_degrees();
    let is_read_back = |degrees: &f64| degrees.to_radians() == angle_rad;
    let shorter = (0..17).filter_map(|digits| format!("{nearest:.digits$e}").parse().ok());
    let beside = [nearest.next_up(), nearest.next_down()];
    let mut all = shorter.chain([nearest]).chain(beside);
    all.find(is_read_back).unwrap_or(nearest)
}

#[cfg(test)]
mod tests {
    use super::degrees;
    use crate::toml::write::number;

    #[test]
    fn angles_are_read_back_and_short() {
        for written in ["-5.0", "13.308", "0.1", "-2.5", "90.0", "1e-7"] {
            let angle: f64 = written.parse().expect("a number");
            assert_eq!(number(degrees(angle.to_radians())), written);
        }
        let mut angle = 0.001_f64;
        while angle < 90.0 {
            assert_eq!(degrees(angle.to_radians()).to_radians(), angle.to_radians());
            angle *= 1.01;
        }
    }
}

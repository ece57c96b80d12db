//! Names of the keys of a tower file in other programs and on drawings. For a key that is described
//! beside its field, these names are there.

use towermodes::Foundation;

use super::schema::tower_file_schema;

/// Names and the keys that they may mean, the most probable first, each separated by blanks. Names
/// are in lower case and without a unit at their end. The types of a foundation are also included.
const SYNONYMS: [(&str, &str); 41] = [
    (
        "cg cog com cm centre centroid center_of_mass centre_of_mass center_of_gravity centre_of_gravity cg_offset position location offset",
        "center",
    ),
    ("z h elevation altitude heights el at", "height z_m level"),
    (
        "outfitting outfit mass_factor density_factor secondary_steel",
        "outfitting_factor",
    ),
    (
        "diameter diameters d dia od outer_diameter thickness wall walls wall_thickness t wt sections section cans nodes station table geometry file csv",
        "stations",
    ),
    ("rho ro mass_density unit_mass specific_mass", "density"),
    (
        "e young youngs elastic_modulus modulus_of_elasticity young_modulus young's_modulus modulus",
        "youngs_modulus",
    ),
    (
        "g shear modulus_of_rigidity",
        "shear_modulus soil_shear_modulus acceleration",
    ),
    (
        "nu poisson poissons poisson_ratio poisson's_ratio v",
        "poissons_ratio soil_poissons_ratio",
    ),
    ("m weight masses", "mass mass_kg_per_m rows"),
    (
        "i j moment_of_inertia moments_of_inertia inertias inertia_tensor",
        "inertia",
    ),
    ("ixx i_xx jxx", "xx inertia"),
    ("iyy i_yy jyy", "yy inertia"),
    ("izz i_zz jzz", "zz inertia"),
    ("ixy i_xy", "xy inertia"),
    ("ixz i_xz izx", "xz inertia"),
    ("iyz i_yz", "yz inertia"),
    ("k spring spring_stiffness ea", "stiffness matrix ea_n"),
    ("azimuth heading direction", "azimuth_deg"),
    ("gravity grav value", "acceleration"),
    ("speed speeds rotor_speed omega rpm_range range", "rpm"),
    ("n_blades number_of_blades blade_count numbl b", "blades"),
    ("water_level sea_level msl swl surface waterline", "water"),
    ("hydro_m hydrodynamic a_inf", "added_mass"),
    ("hydro_k hydro buoyancy hydrostatics", "hydrostatic"),
    ("mooring_k moorings lines", "mooring"),
    ("kind model support", "type"),
    (
        "ei bending bending_stiffness ei_fore_aft ei_fa twfastif",
        "ei_fore_aft_n_m2",
    ),
    ("ei_side_side ei_ss twssstif", "ei_side_side_n_m2"),
    ("gj torsional_stiffness", "gj_n_m2"),
    ("ea axial_stiffness", "ea_n"),
    (
        "mass_per_length mass_den mu linear_mass tmassden",
        "mass_kg_per_m",
    ),
    (
        "rotary_inertia rotational_inertia",
        "rotary_inertia_fore_aft_kg_m",
    ),
    ("polar_inertia torsional_inertia", "polar_inertia_kg_m"),
    ("shear_stiffness ga kappa_ga", "shear_stiffness_fore_aft_n"),
    (
        "machine nacelle top_mass tower_top head rotor_nacelle_assembly turbine rna_mass tip_mass",
        "rna",
    ),
    (
        "point_masses lumped_mass lumped_masses concentrated_mass concentrated_masses masses flange flanges",
        "point_mass",
    ),
    (
        "base support boundary ssi foundation_stiffness",
        "foundation",
    ),
    ("title label description id", "name"),
    (
        "fixed rigid cantilever clamp encastre fixed_base",
        "clamped",
    ),
    ("matrix stiffness_matrix 6x6", "stiffness"),
    (
        "floater spar semi_submersible platform floating_platform",
        "floating",
    ),
];

/// Units at the end of a key.
const UNITS: [&str; 14] = [
    "_kg_per_m3",
    "_kg_m2",
    "_n_per_m",
    "_n_m",
    "_m_s2",
    "_deg",
    "_rpm",
    "_pa",
    "_kg",
    "_mm",
    "_t",
    "_m",
    "_n",
    "_hz",
];

/// The known key that a name means as a synonym, if any.
pub(super) fn meant<'k>(name: &str, known: &[&'k str]) -> Option<&'k str> {
    let lower = name.to_lowercase().replace(['-', ' '], "_");
    let bare = UNITS.iter().find_map(|unit| lower.strip_suffix(unit));
    let candidates = [Some(&*lower), bare];
    candidates.into_iter().flatten().find_map(|name| {
        let same = known.iter().copied().find(|key| *key == name);
        same.or_else(|| by_table(name, known))
    })
}

fn by_table<'k>(name: &str, known: &[&'k str]) -> Option<&'k str> {
    let tables = tower_file_schema().iter();
    let described = tables.flat_map(|table| table.keys);
    let described = described.map(|key| (key.synonyms, key.name));
    let blanks = Foundation::blank_forms();
    let kinds = blanks.iter().filter_map(|blank| Some(blank.form()?.kind()));
    let kinds = kinds.map(|kind| (kind.synonyms, kind.name));
    let rows = SYNONYMS.iter().copied().chain(kinds).chain(described);
    let of_name = rows.filter(|(names, _)| names.split(' ').any(|other| other == name));
    let mut keys = of_name.flat_map(|(_, keys)| keys.split(' '));
    keys.find_map(|key| known.iter().copied().find(|known| *known == key))
}

#[cfg(test)]
mod tests {
    use super::{SYNONYMS, UNITS, meant};

    #[test]
    fn names_of_other_programs_mean_keys() {
        let rna = ["mass", "center", "inertia"];
        for (name, key) in [
            ("cg", "center"),
            ("CoG", "center"),
            ("m", "mass"),
            ("mass_kg", "mass"),
            ("Ixx", "inertia"),
        ] {
            assert_eq!(meant(name, &rna), Some(key), "{name}");
        }
        assert_eq!(meant("z", &["height", "mass"]), Some("height"));
        assert_eq!(meant("z", &["level", "bed"]), Some("level"));
        assert_eq!(meant("z", &rna), None);
        assert_eq!(
            meant("E", &["density", "youngs_modulus"]),
            Some("youngs_modulus")
        );
        assert_eq!(meant("g", &["acceleration"]), Some("acceleration"));
        assert_eq!(meant("height_mm", &["height"]), Some("height"));
        assert_eq!(meant("fixed", &["clamped", "springs"]), Some("clamped"));
        assert_eq!(
            meant("half space", &["half-space", "springs"]),
            Some("half-space")
        );
        assert_eq!(
            meant("outfitting", &["stations", "outfitting_factor"]),
            Some("outfitting_factor")
        );
    }

    #[test]
    fn the_table_is_in_small_letters_and_its_units_are_told_apart() {
        for (names, keys) in &SYNONYMS {
            assert!(!keys.is_empty());
            assert_eq!(names.to_lowercase(), *names);
        }
        for (i, unit) in UNITS.iter().enumerate() {
            let hidden = UNITS[..i].iter().any(|before| unit.ends_with(before));
            assert!(!hidden, "{unit}");
        }
    }
}

//! The schema of the tower file: all tables and keys with their types, units and meanings.
//!
//! The reader takes the known keys from it and the writer the comments; tests check that the help of
//! `solve` and the book name each key.

/// A table of the tower file.
#[derive(Debug)]
pub struct TableSchema {
    /// Its name in messages, such as `[rna]`; of a foundation with its type.
    pub name: &'static str,
    /// Its keys, in the order in which they are written.
    pub keys: &'static [KeySchema],
}

/// A key of a table.
#[derive(Debug)]
pub struct KeySchema {
    /// The key.
    pub name: &'static str,
    /// The type of its value.
    pub kind: ValueKind,
    /// Whether the table must have it.
    pub is_required: bool,
    /// The unit of its numbers; empty for none.
    pub unit: &'static str,
    /// What it is.
    pub meaning: &'static str,
}

/// The type of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ValueKind {
    /// A number.
    Number,
    /// `true` or `false`.
    Flag,
    /// A text in quotation marks.
    Text,
    /// A list of numbers.
    Numbers,
    /// A list of rows.
    Rows,
    /// A 6x6 matrix.
    Matrix,
    /// A table with keys of its own.
    Table,
    /// Several types; the meaning lists them.
    Any,
}

use ValueKind::{Any, Flag, Matrix, Number, Numbers, Rows, Table, Text};

impl TableSchema {
    /// The names of its keys.
    pub fn key_names(&self) -> impl Iterator<Item = &'static str> {
        self.keys.iter().map(|key| key.name)
    }

    /// A key by its name.
    pub fn key(&self, name: &str) -> Option<&'static KeySchema> {
        self.keys.iter().find(|key| key.name == name)
    }
}

impl KeySchema {
    /// Its comment in written files: the meaning and the unit.
    pub(super) fn comment(&self) -> String {
        match (self.meaning, self.unit) {
            (meaning, "") => meaning.to_owned(),
            ("", unit) => unit.to_owned(),
            (meaning, unit) => format!("{meaning}, {unit}"),
        }
    }
}

const fn required(
    name: &'static str,
    kind: ValueKind,
    unit: &'static str,
    meaning: &'static str,
) -> KeySchema {
    let is_required = true;
    KeySchema {
        name,
        kind,
        is_required,
        unit,
        meaning,
    }
}

const fn optional(
    name: &'static str,
    kind: ValueKind,
    unit: &'static str,
    meaning: &'static str,
) -> KeySchema {
    KeySchema {
        is_required: false,
        ..required(name, kind, unit, meaning)
    }
}

const fn name_of(what: &'static str) -> KeySchema {
    optional("name", Text, "", what)
}

const TYPE: KeySchema = required("type", Text, "", "type of the foundation");
const INERTIA_MEANING: &str = "about the centre of mass";
const MOTION: &str = "x, y, z, rotation about x, y, z";

/// The whole file.
pub static FILE: TableSchema = TableSchema {
    name: "the file",
    keys: &[
        name_of("name of the tower"),
        optional(
            "material",
            Table,
            "",
            "the material of stations without a name of one",
        ),
        optional("materials", Table, "", "materials by their names"),
        required(
            "tower",
            Table,
            "",
            "the stations or properties of the tower",
        ),
        optional("rna", Table, "", "the rotor-nacelle assembly"),
        optional("rotor", Table, "", "the rotor"),
        optional("point_mass", Table, "", "a point mass, as often as needed"),
        optional(
            "foundation",
            Table,
            "",
            "the foundation; without it the base is clamped",
        ),
        optional(
            "soil",
            Table,
            "",
            "a layer of soil springs, as often as needed",
        ),
        optional(
            "added_mass",
            Table,
            "",
            "a table of added mass, as often as needed",
        ),
        optional("water", Table, "", "the water around the tower"),
        optional("wires", Table, "", "a set of guy wires, as often as needed"),
        optional("gravity", Table, "", "gravity, which softens the tower"),
    ],
};

/// `[material]` and `[materials.NAME]`.
pub static MATERIAL: TableSchema = TableSchema {
    name: "[material]",
    keys: &[
        required("density", Number, "kg/m3", ""),
        required("youngs_modulus", Number, "Pa", ""),
        optional("shear_modulus", Number, "Pa", ""),
        optional("poissons_ratio", Number, "", "in place of shear_modulus"),
    ],
};

/// `[tower]`.
pub static TOWER: TableSchema = TableSchema {
    name: "[tower]",
    keys: &[
        optional(
            "stations",
            Rows,
            "",
            "height, outer diameter, wall thickness, all in m",
        ),
        optional(
            "properties",
            Table,
            "",
            "in place of stations: properties per length",
        ),
        optional(
            "outfitting_factor",
            Number,
            "",
            "multiplies the tower's masses per length",
        ),
        optional(
            "shear",
            Any,
            "",
            "shear deformation: true, false or a shear coefficient",
        ),
    ],
};

/// `[tower.properties]`.
pub static PROPERTIES: TableSchema = TableSchema {
    name: "[tower.properties]",
    keys: &[
        required("z_m", Numbers, "m", "heights of the rows"),
        required("mass_kg_per_m", Numbers, "kg/m", "mass per length"),
        required("ei_fore_aft_n_m2", Numbers, "N m2", "bending stiffness EI"),
        optional(
            "ei_side_side_n_m2",
            Numbers,
            "N m2",
            "bending stiffness EI, if it differs",
        ),
        required(
            "gj_n_m2",
            Numbers,
            "N m2",
            "torsional stiffness GJ; inf is rigid",
        ),
        required("ea_n", Numbers, "N", "axial stiffness EA; inf is rigid"),
        required(
            "polar_inertia_kg_m",
            Numbers,
            "kg m",
            "inertia per length about the axis",
        ),
        optional(
            "rotary_inertia_fore_aft_kg_m",
            Numbers,
            "kg m",
            "inertia per length in bending",
        ),
        optional(
            "rotary_inertia_side_side_kg_m",
            Numbers,
            "kg m",
            "the same, if it differs",
        ),
        optional(
            "shear_stiffness_fore_aft_n",
            Numbers,
            "N",
            "shear stiffness kappa GA",
        ),
        optional(
            "shear_stiffness_side_side_n",
            Numbers,
            "N",
            "the same, if it differs",
        ),
    ],
};

/// `inertia` of a body.
pub static INERTIA: TableSchema = TableSchema {
    name: "inertia",
    keys: &[
        optional("xx", Number, "kg m2", ""),
        optional("yy", Number, "kg m2", ""),
        optional("zz", Number, "kg m2", ""),
        optional("xy", Number, "kg m2", ""),
        optional("xz", Number, "kg m2", ""),
        optional("yz", Number, "kg m2", ""),
    ],
};

/// `[rna]`.
pub static RNA: TableSchema = TableSchema {
    name: "[rna]",
    keys: &[
        required("mass", Number, "kg", ""),
        optional(
            "center",
            Numbers,
            "m",
            "centre of mass from the tower top: downwind, side-side, up",
        ),
        optional("inertia", Table, "kg m2", INERTIA_MEANING),
    ],
};

/// `[rotor]`.
pub static ROTOR: TableSchema = TableSchema {
    name: "[rotor]",
    keys: &[
        required("blades", Number, "", "number of blades"),
        required(
            "rpm",
            Any,
            "",
            "lowest and highest operating speed, or one constant speed",
        ),
    ],
};

/// `[[point_mass]]`.
pub static POINT_MASS: TableSchema = TableSchema {
    name: "[[point_mass]]",
    keys: &[
        name_of(""),
        required("height", Number, "m", ""),
        required("mass", Number, "kg", ""),
        optional("inertia", Table, "kg m2", INERTIA_MEANING),
    ],
};

/// `[foundation]` of type `clamped`.
pub static CLAMPED: TableSchema = TableSchema {
    name: "[foundation] of type \"clamped\"",
    keys: &[TYPE],
};

/// `[foundation]` of type `stiffness`.
pub static STIFFNESS: TableSchema = TableSchema {
    name: "[foundation] of type \"stiffness\"",
    keys: &[
        TYPE,
        required("matrix", Matrix, "N/m, N, N m", MOTION),
        optional("mass", Matrix, "kg, kg m, kg m2", "mass at the base"),
    ],
};

/// `[foundation]` of type `springs`.
pub static SPRINGS: TableSchema = TableSchema {
    name: "[foundation] of type \"springs\"",
    keys: &[
        TYPE,
        required("lateral", Number, "N/m", "inf is rigid"),
        required("rocking", Number, "N m", ""),
        required("vertical", Number, "N/m", ""),
        required("torsion", Number, "N m", ""),
        optional("coupling", Number, "N", "between x and rotation about y"),
    ],
};

/// `[foundation]` of type `half-space`.
pub static HALF_SPACE: TableSchema = TableSchema {
    name: "[foundation] of type \"half-space\"",
    keys: &[
        TYPE,
        required("radius", Number, "m", ""),
        optional("embedment", Number, "m", ""),
        required("soil_shear_modulus", Number, "Pa", ""),
        required("soil_poissons_ratio", Number, "", ""),
    ],
};

/// `[foundation]` of type `floating`.
pub static FLOATING: TableSchema = TableSchema {
    name: "[foundation] of type \"floating\"",
    keys: &[
        TYPE,
        required("mass", Number, "kg", "with ballast"),
        required(
            "center",
            Numbers,
            "m",
            "centre of mass: x and y from the tower axis, z in the datum of the stations",
        ),
        required("inertia", Table, "kg m2", INERTIA_MEANING),
        optional(
            "added_mass_height",
            Number,
            "m",
            "of the reference point of the matrix",
        ),
        optional("added_mass", Matrix, "kg, kg m, kg m2", MOTION),
        optional(
            "hydrostatic_height",
            Number,
            "m",
            "of the reference point of the matrix",
        ),
        optional(
            "hydrostatic",
            Matrix,
            "N/m, N, N m",
            "of water plane and buoyancy",
        ),
        optional(
            "mooring_height",
            Number,
            "m",
            "of the reference point of the matrix",
        ),
        optional("mooring", Matrix, "N/m, N, N m", MOTION),
    ],
};

/// `[[soil]]`.
pub static SOIL: TableSchema = TableSchema {
    name: "[[soil]]",
    keys: &[
        name_of(""),
        required(
            "rows",
            Rows,
            "",
            "height in m, springs in x, in y (N/m2), in z (N/m2), in torsion (N)",
        ),
    ],
};

/// `[[added_mass]]`.
pub static ADDED_MASS: TableSchema = TableSchema {
    name: "[[added_mass]]",
    keys: &[
        name_of(""),
        required(
            "rows",
            Rows,
            "",
            "height in m, added mass in x and y in kg/m",
        ),
    ],
};

/// `[water]`.
pub static WATER: TableSchema = TableSchema {
    name: "[water]",
    keys: &[
        required("level", Number, "m", ""),
        optional("bed", Number, "m", ""),
        optional("density", Number, "kg/m3", ""),
        optional("added_mass_coefficient", Number, "", ""),
        optional("flooded", Flag, "", "whether there is water inside"),
    ],
};

/// `[[wires]]`.
pub static WIRES: TableSchema = TableSchema {
    name: "[[wires]]",
    keys: &[
        name_of(""),
        required("height", Number, "m", "of their upper ends"),
        required("count", Number, "", "number of wires, equally spaced"),
        required("stiffness", Number, "N/m", "EA/L of each wire"),
        required("angle_deg", Number, "degrees", "from the horizontal"),
        optional(
            "azimuth_deg",
            Number,
            "degrees",
            "of the first wire; it has no effect",
        ),
    ],
};

/// `[gravity]`.
pub static GRAVITY: TableSchema = TableSchema {
    name: "[gravity]",
    keys: &[optional("acceleration", Number, "m/s2", "")],
};

/// The types of foundation with their names.
pub(super) static FOUNDATIONS: [&TableSchema; 5] =
    [&CLAMPED, &STIFFNESS, &SPRINGS, &HALF_SPACE, &FLOATING];

/// All tables of the tower file.
///
/// # Example
/// ```
/// use towermodes_files::tower_file_schema;
///
/// let rna = tower_file_schema().iter().find(|table| table.name == "[rna]").expect("a table");
/// assert_eq!(rna.key("mass").expect("a key").unit, "kg");
/// ```
pub fn tower_file_schema() -> &'static [&'static TableSchema] {
    static ALL: [&TableSchema; 18] = [
        &FILE,
        &MATERIAL,
        &TOWER,
        &PROPERTIES,
        &INERTIA,
        &RNA,
        &ROTOR,
        &POINT_MASS,
        &CLAMPED,
        &STIFFNESS,
        &SPRINGS,
        &HALF_SPACE,
        &FLOATING,
        &SOIL,
        &ADDED_MASS,
        &WATER,
        &WIRES,
        &GRAVITY,
    ];
    &ALL
}

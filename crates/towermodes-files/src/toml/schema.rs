//! The schema of the tower file: all tables and keys with their types, units and meanings.
//!
//! The reader takes the known keys from it and the writer the comments; tests check that the help
//! of `solve` and the book name each key. Tables whose values are described beside their fields
//! ([`towermodes::inputs`]) are made from these descriptions.

use std::sync::LazyLock;

use towermodes::frame::MarineGrowth;
use towermodes::inputs::{Given, Input, Inputs, every_input};
use towermodes::{
    Damping, Drivetrain, Foundation, FoundationSprings, Ground, GroundLayer, LayerSoil, PointMass,
    Rna, Water, Wires,
};

/// A table of the tower file.
#[derive(Debug)]
pub struct TableSchema {
    /// Its name in messages, such as `[rna]`; for a foundation with its type.
    pub name: &'static str,
    /// Its keys, in the order in which they are written.
    pub keys: &'static [KeySchema],
}

/// A key of a table.
#[derive(Debug, Clone, Copy)]
pub struct KeySchema {
    /// The key.
    pub name: &'static str,
    /// The type of its value.
    pub kind: ValueKind,
    /// Whether the table must contain it.
    pub is_required: bool,
    /// The unit of its numbers; empty for none.
    pub unit: &'static str,
    /// Its meaning.
    pub meaning: &'static str,
    /// Its other names in other programs and on drawings, separated by blanks.
    pub synonyms: &'static str,
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
    /// A table with its own keys.
    Table,
    /// Several types; the meaning lists them.
    Any,
}

impl TableSchema {
    /// A table of these keys with the keys that are described beside their fields between the first
    /// and the last ones. It is made once and kept until the program ends.
    pub(super) fn described(
        name: impl Into<String>,
        first: &[KeySchema],
        inputs: &[(&'static Input, Given)],
        last: &[KeySchema],
    ) -> Self {
        let mut keys = first.to_vec();
        for &(input, given) in inputs {
            let key = match input.key.split_once('.') {
                Some((group, _)) if keys.iter().chain(last).any(|key| key.name == group) => {
                    continue;
                }
                Some((group, _)) => KeySchema::group(group),
                None => KeySchema::described(input, given),
            };
            keys.push(key);
        }
        keys.extend(last);
        Self {
            name: name.into().leak(),
            keys: keys.leak(),
        }
    }

    /// The tables within a table whose keys are described beside their fields: `scour` of
    /// `[ground]`.
    fn groups(inputs: &[(&'static Input, Given)]) -> Vec<Self> {
        let mut groups: Vec<(&'static str, Vec<KeySchema>)> = Vec::new();
        for &(input, given) in inputs {
            let Some((group, name)) = input.key.split_once('.') else {
                continue;
            };
            let described = KeySchema::described(input, given);
            let key = KeySchema { name, ..described };
            match groups.iter_mut().find(|(other, _)| *other == group) {
                Some((_, keys)) => keys.push(key),
                None => groups.push((group, vec![key])),
            }
        }
        let table = |(name, keys): (&'static str, Vec<KeySchema>)| Self {
            name,
            keys: keys.leak(),
        };
        groups.into_iter().map(table).collect()
    }

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
    /// A key that is described beside its field.
    fn described(input: &'static Input, given: Given) -> Self {
        let meaning = match (given, input.note) {
            (Given::Pair(_), "") => PAIR,
            (Given::Pair(_), note) => format!("{note}; {PAIR}").leak(),
            (_, note) => note,
        };
        Self {
            name: input.key,
            kind: match given {
                Given::Number(_) | Given::Optional(_) | Given::Count(_) => ValueKind::Number,
                Given::Pair(_) => ValueKind::Any,
                Given::Triple(_) => ValueKind::Numbers,
                Given::Flag(_) => ValueKind::Flag,
                Given::Name(..) => ValueKind::Text,
            },
            is_required: input.is_required,
            unit: input.unit(),
            meaning,
            synonyms: input.synonyms,
        }
    }

    /// A table of keys that are described beside their fields.
    fn group(name: &'static str) -> Self {
        Self {
            name,
            kind: ValueKind::Table,
            is_required: false,
            unit: "",
            meaning: "",
            synonyms: "",
        }
    }

    /// Its comment in written files: the meaning and the unit.
    pub(super) fn comment(&self) -> String {
        match (self.meaning, self.unit) {
            (meaning, "") => meaning.to_owned(),
            ("", unit) => unit.to_owned(),
            (meaning, unit) => format!("{meaning}, {unit}"),
        }
    }
}

/// The ways to write a value at the top and at the bottom of a layer.
const PAIR: &str = "one number or [top, bottom]";

/// The number of keys of all parts.
pub(super) const fn count(parts: &[&[KeySchema]]) -> usize {
    let (mut count, mut part) = (0, 0);
    while part < parts.len() {
        count += parts[part].len();
        part += 1;
    }
    count
}

/// The keys of all parts in one list.
pub(super) const fn joined<const N: usize>(parts: &[&[KeySchema]]) -> [KeySchema; N] {
    let mut keys = [parts[0][0]; N];
    let (mut key, mut part) = (0, 0);
    while part < parts.len() {
        let mut own = 0;
        while own < parts[part].len() {
            keys[key] = parts[part][own];
            (key, own) = (key + 1, own + 1);
        }
        part += 1;
    }
    keys
}

/// A line for each key: whether it is required, its name, type, unit and meaning.
macro_rules! keys {
    ($($need:ident $key:literal $kind:ident $unit:literal $meaning:literal;)*) => {
        &[$($crate::toml::schema::KeySchema {
            name: $key,
            kind: $crate::toml::schema::ValueKind::$kind,
            is_required: $crate::toml::schema::keys!(@is_required $need),
            unit: $unit,
            meaning: $meaning,
            synonyms: "",
        }),*]
    };
    (@is_required required) => { true };
    (@is_required optional) => { false };
}

/// Defines the function that gives all tables, and the tables with their keys; `with` names keys
/// that precede them, and `+` keys that follow them.
macro_rules! tables {
    ($(#[$all_doc:meta])+ $all:ident => $($(#[$doc:meta])+ $id:ident = $table:literal $(with $first:ident)?: $($need:ident $key:literal $kind:ident $unit:literal $meaning:literal;)* $(+ $more:ident;)*)+) => {
        $($(#[$doc])+ pub static $id: TableSchema = TableSchema {
            name: $table,
            keys: {
                const PARTS: &[&[KeySchema]] = &[
                    $($first,)?
                    $crate::toml::schema::keys!($($need $key $kind $unit $meaning;)*),
                    $($more),*
                ];
                const KEYS: [KeySchema; $crate::toml::schema::count(PARTS)] =
                    $crate::toml::schema::joined(PARTS);
                &KEYS
            },
        };)+

        $(#[$all_doc])+
        pub fn $all() -> &'static [&'static TableSchema] {
            static ALL: &[&TableSchema] = &[$(&$id),+];
            ALL
        }
    };
}

/// All tables of the tower file.
///
/// # Example
/// ```
/// use towermodes_files::tower_file_schema;
///
/// let mut tables = tower_file_schema().iter();
/// let rna = tables.find(|table| table.name == "[rna]").expect("a table");
/// assert_eq!(rna.key("mass").expect("a key").unit, "kg");
/// ```
pub fn tower_file_schema() -> &'static [&'static TableSchema] {
    static ALL: LazyLock<Vec<&TableSchema>> = LazyLock::new(|| {
        let described: [&TableSchema; 9] = [
            &SUBSTRUCTURE_GROWTH,
            &RNA,
            &POINT_MASS,
            &WATER,
            &WIRES,
            &DRIVETRAIN,
            &DAMPING,
            &GROUND,
            &SPRINGS,
        ];
        listed()
            .iter()
            .copied()
            .chain(CLOSED_FORMS.iter())
            .chain(described)
            .chain(SCOUR.iter())
            .chain(LAYERS.iter())
            .collect()
    });
    &ALL
}

/// The first key of each `[foundation]`.
const TYPE: &[KeySchema] = keys! {
    required "type" Text "" "type of the foundation";
};

/// `[foundation]` of type `springs`.
pub static SPRINGS: LazyLock<TableSchema> = LazyLock::new(|| {
    let inputs = every_input(&FoundationSprings::blank());
    TableSchema::described("[foundation] of type \"springs\"", TYPE, &inputs, &[])
});

/// `[foundation]` of each type that is a closed form.
pub static CLOSED_FORMS: LazyLock<Vec<TableSchema>> = LazyLock::new(|| {
    let blanks = Foundation::blank_forms();
    let forms = blanks.iter().filter_map(Foundation::form);
    let name = |kind: &str| format!("[foundation] of type \"{kind}\"");
    forms
        .map(|form| TableSchema::described(name(form.kind().name), TYPE, &every_input(form), &[]))
        .collect()
});

/// `[foundation]` of a type that is a closed form.
pub(super) fn closed_form(kind: &str) -> &'static TableSchema {
    let blanks = Foundation::blank_forms();
    let is_it = |blank: &Foundation| blank.form().is_some_and(|form| form.kind().name == kind);
    &CLOSED_FORMS[blanks.iter().position(is_it).unwrap_or(0)]
}

/// `[water]`.
pub static WATER: LazyLock<TableSchema> =
    LazyLock::new(|| TableSchema::described("[water]", &[], &every_input(&Water::blank()), &[]));

/// The key of the inertia of a body.
const INERTIA_OF_BODY: &[KeySchema] = keys! {
    optional "inertia" Table "kg m2" "inertia tensor about the centre of mass";
};

/// The key of the name of a part that may occur several times.
const NAME: &[KeySchema] = keys! {
    optional "name" Text "" "";
};

/// `[rna]`.
pub static RNA: LazyLock<TableSchema> = LazyLock::new(|| {
    TableSchema::described("[rna]", &[], &every_input(&Rna::blank()), INERTIA_OF_BODY)
});

/// `[[point_mass]]`.
pub static POINT_MASS: LazyLock<TableSchema> = LazyLock::new(|| {
    let inputs = every_input(&PointMass::blank());
    TableSchema::described("[[point_mass]]", NAME, &inputs, INERTIA_OF_BODY)
});

/// `[[substructure.growth]]`.
pub static SUBSTRUCTURE_GROWTH: LazyLock<TableSchema> = LazyLock::new(|| {
    let inputs = every_input(&MarineGrowth::blank());
    TableSchema::described("[[substructure.growth]]", &[], &inputs, &[])
});

/// `[[wires]]`.
pub static WIRES: LazyLock<TableSchema> = LazyLock::new(|| {
    let azimuth: &[KeySchema] = keys! {
        optional "azimuth_deg" Number "degrees" "direction of the first wire; it has no effect";
    };
    TableSchema::described("[[wires]]", NAME, &every_input(&Wires::blank()), azimuth)
});

/// `[drivetrain]`.
pub static DRIVETRAIN: LazyLock<TableSchema> = LazyLock::new(|| {
    TableSchema::described("[drivetrain]", &[], &every_input(&Drivetrain::blank()), &[])
});

/// `[damping]`.
pub static DAMPING: LazyLock<TableSchema> = LazyLock::new(|| {
    let materials: &[KeySchema] = keys! {
        optional "material_loss_factors" Table "" "loss factors of named materials, in place of tower_loss_factor";
    };
    TableSchema::described("[damping]", &[], &every_input(&Damping::blank()), materials)
});

/// `[ground]`.
pub static GROUND: LazyLock<TableSchema> = LazyLock::new(|| {
    let inputs = every_input(&Ground::blank());
    let names: Vec<&str> = LayerSoil::models().map(|model| model.name()).collect();
    let (last, others) = names.split_last().unwrap_or((&"", &[]));
    let model = format!("of the springs: {} or {last}", others.join(", "));
    let by_layers: [KeySchema; 2] = [
        KeySchema {
            kind: ValueKind::Text,
            meaning: model.leak(),
            ..KeySchema::group("model")
        },
        KeySchema {
            is_required: true,
            meaning: "a layer of soil, as often as needed, from the surface down",
            ..KeySchema::group("layer")
        },
    ];
    TableSchema::described("[ground]", &[], &inputs, &by_layers)
});

/// `scour` of `[ground]`.
static SCOUR: LazyLock<Vec<TableSchema>> =
    LazyLock::new(|| TableSchema::groups(&every_input(&Ground::blank())));

/// `[[ground.layer]]` of each type of soil.
static LAYERS: LazyLock<Vec<TableSchema>> = LazyLock::new(|| {
    let first: &[KeySchema] = keys! {
        optional "name" Text "" "";
        required "type" Text "" "kind of soil: sand, clay, elastic, rock or py";
    };
    let rows: &[KeySchema] = keys! {
        required "rows" Rows "" "height in m, displacement in m, reaction in N/m";
    };
    let profile: &[KeySchema] = keys! {
        optional "profile" Text "" "a table in CSV: depth or height, and values marked [top, bottom] in columns";
    };
    let table = |soil: LayerSoil| {
        let name = format!("[[ground.layer]] of type \"{}\"", soil.kind());
        let last = match &soil {
            LayerSoil::Table(_) => rows,
            LayerSoil::Sand(_) | LayerSoil::Clay(_) | LayerSoil::Elastic | LayerSoil::Rock(_) => {
                profile
            }
        };
        TableSchema::described(name, first, &GroundLayer::every_input(&[soil]), last)
    };
    LayerSoil::blanks().map(table).into()
});

/// `[[ground.layer]]` of a type of soil.
pub(super) fn layer(soil: &LayerSoil) -> &'static TableSchema {
    let blanks = LayerSoil::blanks();
    let mut kinds = blanks.iter().map(LayerSoil::kind);
    &LAYERS[kinds.position(|kind| kind == soil.kind()).unwrap_or(0)]
}

pub(super) use keys;
pub(super) use tables;

tables! {
    /// The tables of the tower file that are listed here.
    listed =>

    /// The whole file.
    FILE = "the file":
        optional "name" Text "" "name of the tower";
        optional "missing_parts" Any "" "parts of the structure that are not in this file";
        optional "material" Table "" "material of the stations that do not name a material";
        optional "materials" Table "" "materials by their names";
        required "tower" Table "" "the stations or properties of the tower";
        optional "rna" Table "" "the rotor-nacelle assembly";
        optional "turbine" Table "" "nacelle, drivetrain and flexible blades, in place of rna";
        optional "rotor" Table "" "the rotor";
        optional "drivetrain" Table "" "rotor and generator, for a rotor that rotates freely";
        optional "point_mass" Table "" "a point mass, as often as needed";
        optional "foundation" Table "" "the foundation; without it the base is clamped";
        optional "mooring" Table "" "mooring lines of a floating foundation";
        optional "substructure" Table "" "joints and members under the tower, in place of the foundation";
        optional "soil" Table "" "a layer of soil springs, as often as needed";
        optional "ground" Table "" "soil in layers around the embedded pile";
        optional "added_mass" Table "" "a table of added mass, as often as needed";
        optional "water" Table "" "the water around the tower";
        optional "wires" Table "" "a set of guy wires, as often as needed";
        optional "gravity" Table "" "gravity, which softens the tower";
        optional "damping" Table "" "loss factors and rotor aerodynamics, for `towermodes damping`";

    /// `[material]` and `[materials.NAME]`.
    MATERIAL = "[material]":
        required "density" Number "kg/m3" "";
        required "youngs_modulus" Number "Pa" "";
        optional "shear_modulus" Number "Pa" "";
        optional "poissons_ratio" Number "" "Poisson's ratio, in place of shear_modulus";

    /// `[tower]`.
    TOWER = "[tower]":
        optional "stations" Rows "" "height, outer diameter, wall thickness, all in m";
        optional "properties" Table "" "in place of stations: properties per length";
        optional "outfitting_factor" Number "" "multiplies the tower's masses per length";
        optional "shear" Any "" "shear deformation: true, false or a shear coefficient";

    /// `[tower.properties]`.
    PROPERTIES = "[tower.properties]":
        required "z_m" Numbers "m" "heights of the rows";
        required "mass_kg_per_m" Numbers "kg/m" "mass per length";
        required "ei_fore_aft_n_m2" Numbers "N m2" "bending stiffness EI";
        optional "ei_side_side_n_m2" Numbers "N m2" "bending stiffness EI, if it differs";
        required "gj_n_m2" Numbers "N m2" "torsional stiffness GJ; inf is rigid";
        required "ea_n" Numbers "N" "axial stiffness EA; inf is rigid";
        required "polar_inertia_kg_m" Numbers "kg m" "inertia per length about the axis";
        optional "rotary_inertia_fore_aft_kg_m" Numbers "kg m" "inertia per length in bending";
        optional "rotary_inertia_side_side_kg_m" Numbers "kg m" "inertia per length in side-side bending, if it differs";
        optional "shear_stiffness_fore_aft_n" Numbers "N" "shear stiffness kappa GA";
        optional "shear_stiffness_side_side_n" Numbers "N" "side-side shear stiffness kappa GA, if it differs";

    /// `inertia` of a body.
    INERTIA = "inertia":
        optional "xx" Number "kg m2" "";
        optional "yy" Number "kg m2" "";
        optional "zz" Number "kg m2" "";
        optional "xy" Number "kg m2" "";
        optional "xz" Number "kg m2" "";
        optional "yz" Number "kg m2" "";

    /// `[turbine]`.
    TURBINE = "[turbine]":
        required "overhang" Number "m" "distance from the tower axis to the rotor apex along the shaft, negative upwind";
        required "tower_to_shaft" Number "m" "height of the shaft above the tower top, at the tower's axis";
        optional "tilt_deg" Number "degrees" "tilt of the shaft; a negative tilt lifts the hub of an upwind rotor";
        optional "blades" Number "" "number of blades, 3 by default";
        optional "cone_deg" Number "degrees" "cone angle of the blades, positive downwind";
        optional "pitch_deg" Number "degrees" "pitch angle of the blades, positive to feather";
        optional "shaft_stiffness" Number "N m" "torsional stiffness, referred to the low-speed shaft; inf, the default, is rigid";
        optional "generator" Text "" "locked (fixed speed, the default) or free";
        optional "generator_inertia" Number "kg m2" "inertia of the generator about its own shaft";
        optional "gear_ratio" Number "" "generator speed divided by rotor speed; 1 by default";
        optional "yaw_stiffness" Number "N m" "torsional stiffness of the yaw drive; inf, the default, is rigid";
        optional "yaw_bearing_mass" Number "kg" "mass at the tower top that does not yaw";
        required "nacelle" Table "" "all parts that yaw and do not rotate with the rotor";
        required "hub" Table "" "";
        required "blade" Table "" "one blade; all are equal";

    /// `[turbine.nacelle]`.
    NACELLE = "[turbine.nacelle]":
        required "mass" Number "kg" "";
        optional "center" Numbers "m" "centre of mass from the tower top: downwind, side-side, up";
        optional "inertia" Table "kg m2" "inertia tensor about the centre of mass";

    /// `[turbine.hub]`.
    HUB = "[turbine.hub]":
        required "mass" Number "kg" "";
        optional "offset" Number "m" "distance from the apex to the centre of mass of the hub along the shaft, positive downwind";
        optional "polar_inertia" Number "kg m2" "inertia of the hub about the shaft";
        optional "transverse_inertia" Number "kg m2" "inertia about an axis normal to the shaft through the centre of mass of the hub";

    /// `[turbine.blade]`.
    BLADE = "[turbine.blade]":
        required "hub_radius" Number "m" "radius of the root";
        required "tip_radius" Number "m" "radius of the tip, along the blade";
        optional "tip_mass" Number "kg" "mass at the tip";
        optional "file" Text "" "blade file of ElastoDyn, in place of the lists";
        optional "span" Numbers "" "positions of the sections, 0 at the root to 1 at the tip";
        optional "mass_kg_per_m" Numbers "kg/m" "mass per length";
        optional "ei_flap_n_m2" Numbers "N m2" "bending stiffness in flap";
        optional "ei_edge_n_m2" Numbers "N m2" "bending stiffness in edge";
        optional "twist_deg" Numbers "degrees" "structural twist, positive to feather";
        optional "gj_n_m2" Numbers "N m2" "torsional stiffness; inf is rigid";
        optional "ea_n" Numbers "N" "axial stiffness; inf is rigid";
        optional "flap_inertia_kg_m" Numbers "kg m" "flapwise rotary inertia per length about the blade axis: integral of y^2 dm, y normal to the chord";
        optional "edge_inertia_kg_m" Numbers "kg m" "edgewise rotary inertia per length about the blade axis: integral of x^2 dm, x along the chord; at least mass times center_of_mass squared";
        optional "center_of_mass_m" Numbers "m" "offset of the centre of mass from the blade axis, positive towards the leading edge";
        optional "tension_center_m" Numbers "m" "offset of the tension centre from the blade axis, positive towards the leading edge";

    /// `[rotor]`.
    ROTOR = "[rotor]":
        required "blades" Number "" "number of blades";
        required "rpm" Any "" "lowest and highest operating speed, or one constant speed";

    /// `[foundation]` of type `clamped`.
    CLAMPED = "[foundation] of type \"clamped\"":
        required "type" Text "" "type of the foundation";

    /// `[foundation]` of type `stiffness`.
    STIFFNESS = "[foundation] of type \"stiffness\"":
        required "type" Text "" "type of the foundation";
        required "matrix" Matrix "N/m, N, N m" "x, y, z, rotation about x, y, z";
        optional "mass" Matrix "kg, kg m, kg m2" "mass at the base";

    /// `[foundation]` of type `floating`.
    FLOATING = "[foundation] of type \"floating\"":
        required "type" Text "" "type of the foundation";
        required "mass" Number "kg" "mass including ballast";
        required "center" Numbers "m" "centre of mass: x and y from the tower axis, z in the datum of the stations";
        required "inertia" Table "kg m2" "inertia tensor about the centre of mass";
        optional "added_mass_height" Number "m" "height of the reference point of the matrix";
        optional "added_mass" Matrix "kg, kg m, kg m2" "x, y, z, rotation about x, y, z";
        optional "added_mass_by_frequency" Rows "" "angular frequency in rad/s from 0 to inf, upper triangle of the matrix row by row (21 numbers)";
        optional "hydrostatic_height" Number "m" "height of the reference point of the matrix";
        optional "hydrostatic" Matrix "N/m, N, N m" "stiffness of water plane and buoyancy";
        optional "buoyancy" Number "N" "upward force of the water at the reference position, for the static balance";
        optional "buoyancy_center" Numbers "m" "centre of buoyancy, x and y from the tower axis, 0 by default";
        optional "at_equilibrium" Flag "" "whether mooring lines have their stiffness at the equilibrium; false by default";
        optional "mooring_height" Number "m" "height of the reference point of the matrix";
        optional "mooring" Matrix "N/m, N, N m" "x, y, z, rotation about x, y, z";

    /// `[mooring]`.
    MOORING = "[mooring]":
        required "depth" Number "m" "depth of the seabed below still water";
        optional "still_water" Number "m" "height of still water in the datum of the stations, 0 by default";
        optional "water_density" Number "kg/m3" "1025 by default";
        optional "gravity" Number "m/s2" "default: the value of [gravity], or 9.80665";
        required "line_type" Table "" "a chain or rope, as often as needed";
        required "point" Table "" "a point where mooring lines end, as often as needed";
        required "line" Table "" "a line, as often as needed";
        optional "body" Table "" "a body that is held by lines or fixed to the platform, as often as needed";
        optional "rod" Table "" "a rod that is held by lines or fixed to the platform, as often as needed";

    /// `[[mooring.line_type]]`.
    MOORING_LINE_TYPE = "[[mooring.line_type]]":
        required "name" Text "" "";
        required "diameter" Number "m" "outer diameter of a cylinder with the same displaced volume";
        required "mass_per_length" Number "kg/m" "mass per length in air";
        required "axial_stiffness" Number "N" "EA";
        optional "seabed_friction" Number "" "coefficient of friction on the seabed, 0 by default";

    /// `[[mooring.point]]`.
    MOORING_POINT = "[[mooring.point]]":
        required "name" Text "" "";
        required "kind" Text "" "anchor, fairlead, free, body or rod";
        optional "position" Numbers "m" "x and y from the tower axis, z from still water; on a body from the origin of the body";
        optional "mass" Number "kg" "";
        optional "volume" Number "m3" "displaced volume of water";
        optional "body" Text "" "the body that it is on";
        optional "rod" Text "" "the rod that it is on";
        optional "end" Text "" "end of the rod: a or b";

    /// `[[mooring.line]]`.
    MOORING_LINE = "[[mooring.line]]":
        required "name" Text "" "";
        required "line_type" Text "" "its line_type";
        required "length" Number "m" "length without tension";
        required "points" Any "" "the names of its two points";

    /// `[[mooring.body]]`.
    MOORING_BODY = "[[mooring.body]]":
        required "name" Text "" "";
        required "carrier" Text "" "fixed, platform or free";
        required "position" Numbers "m" "position of the origin, z from still water";
        optional "angles" Numbers "rad" "rotations about the body-fixed x, y and z axes, in this order";
        required "mass" Number "kg" "";
        optional "center" Numbers "m" "centre of mass from the origin of the body, in body axes";
        optional "principal_inertia" Numbers "kg m2" "moments of inertia about the body axes through the centre of mass";
        required "volume" Number "m3" "displaced volume of water";

    /// `[[mooring.rod]]`.
    MOORING_ROD = "[[mooring.rod]]":
        required "name" Text "" "";
        required "carrier" Text "" "fixed, platform or free";
        required "ends" Rows "" "positions of its ends a and b in m, z from still water";
        required "diameter" Number "m" "";
        required "mass_per_length" Number "kg/m" "";

    /// `[substructure]`.
    SUBSTRUCTURE = "[substructure]":
        optional "file" Text "" "input file of SubDyn, in place of joints and members";
        required "reference" Numbers "m" "reference point of the transition piece, where the tower stands";
        optional "interface" Any "" "the names of the joints that carry the tower";
        optional "clamped" Any "" "the names of the joints that do not move";
        optional "weight_on_members" Flag "" "whether the forces of the weight at rest change the stiffness of members, true by default";
        optional "buoyancy_on_members" Flag "" "whether buoyancy reduces this weight, false by default";
        optional "flooded" Any "" "the names of the members with water inside, up to the level of [water]";
        optional "platform" Table "" "the transition piece as a rigid body";
        optional "growth" Table "" "marine growth between two heights, as often as needed";
        optional "joint" Table "" "a joint, as often as needed";
        optional "member" Table "" "a member, as often as needed";
        optional "support" Table "" "a joint with fixed motions or springs, as often as needed";
        optional "mass" Table "" "a rigid body on a joint, as often as needed";
        optional "added_mass" Table "" "inertia without weight on a joint, as often as needed";
        optional "rider" Table "" "inertia without weight on a member, as often as needed";
        optional "water_plane" Table "" "the part of the hydrostatic stiffness of a floating foundation that acts on a joint, as often as needed";

    /// `platform` of `[substructure]`.
    SUBSTRUCTURE_PLATFORM = "[substructure.platform]":
        required "mass" Number "kg" "";
        optional "center" Numbers "m" "centre of mass from the reference point";
        optional "inertia" Table "kg m2" "inertia tensor about the centre of mass";

    /// `[[substructure.joint]]`.
    SUBSTRUCTURE_JOINT = "[[substructure.joint]]":
        required "name" Text "" "";
        required "position" Numbers "m" "x, y, z in the datum of the stations";
        optional "kind" Text "" "welded, the default, pin, universal or ball";
        optional "axis" Numbers "" "direction of the axis of a pin";
        optional "stiffness" Number "N m" "stiffness per radian of the springs of a pin, universal or ball joint";

    /// `[[substructure.member]]`.
    SUBSTRUCTURE_MEMBER = "[[substructure.member]]":
        required "name" Text "" "";
        required "joints" Any "" "the names of its two joints";
        optional "kind" Text "" "tube, the default, rectangle, section, cable, rigid or spring";
        optional "outer_diameter" Any "m" "one number or [at the first joint, at the second joint]";
        optional "wall_thickness" Any "m" "one number or [at the first joint, at the second joint]";
        optional "material" Text "" "name of one of [materials]; without it [material]";
        optional "shear" Flag "" "whether it deforms in shear, true by default";
        optional "spin" Number "degrees" "rotation of the section about the axis";
        optional "sides" Any "m" "sides of a rectangle along its axes x and y";
        optional "area" Number "m2" "area of a section";
        optional "shear_areas" Numbers "m2" "shear areas of a section in x and y";
        optional "second_moments" Numbers "m4" "second moments of area of a section about x and y";
        optional "polar_moment" Number "m4" "polar moment of a section, for its inertia about the axis";
        optional "torsion_constant" Number "m4" "of a section";
        optional "axial_stiffness" Number "N" "EA of a cable";
        optional "mass_per_length" Number "kg/m" "of a cable or a rigid link";
        optional "pretension" Number "N" "of a cable";
        optional "stiffness" Matrix "N/m, N, N m" "stiffness of a spring: x, y, z, rotation about x, y, z";
        optional "axes" Rows "" "axes of a spring: three unit vectors; by default the axes of the member";
        optional "coats" Table "" "growth, water inside or added mass, in place of the added mass of [water]";

    /// `coats` of a member.
    SUBSTRUCTURE_COAT = "coats":
        required "kind" Text "" "solid or added-mass";
        optional "range" Numbers "" "start and end as fractions of the length from the first joint; [0, 1] by default";
        required "density" Any "kg/m3" "one number or [where it begins, where it ends]";
        optional "outer_radius" Any "m" "of a solid";
        optional "inner_radius" Any "m" "of a solid, 0 by default";
        optional "radius" Any "m" "for the added mass";
        optional "across" Any "" "coefficient of added mass across the axis, 1 by default";
        optional "along" Any "" "coefficient of added mass along the axis, 0 by default";

    /// `[[substructure.support]]`.
    SUBSTRUCTURE_SUPPORT = "[[substructure.support]]":
        required "joint" Text "" "its name";
        optional "fixed" Any "" "which motions are fixed: x, y, z, rotation about x, y, z, each true or false";
        optional "stiffness" Matrix "N/m, N, N m" "x, y, z, rotation about x, y, z";
        optional "inertia" Matrix "kg, kg m, kg m2" "inertia of soil that moves with the joint";

    /// `[[substructure.mass]]`.
    SUBSTRUCTURE_MASS = "[[substructure.mass]]":
        required "joint" Text "" "its name";
        required "mass" Number "kg" "";
        optional "center" Numbers "m" "centre of mass from the joint";
        optional "inertia" Table "kg m2" "inertia tensor about the centre of mass";

    /// `[[substructure.added_mass]]`.
    SUBSTRUCTURE_ADDED_MASS = "[[substructure.added_mass]]":
        required "joint" Text "" "its name";
        required "matrix" Matrix "kg, kg m, kg m2" "x, y, z, rotation about x, y, z";

    /// `[[substructure.rider]]`.
    SUBSTRUCTURE_RIDER = "[[substructure.rider]]":
        required "member" Text "" "its name";
        required "fraction" Number "" "distance from the first joint as a fraction of the member length";
        required "matrix" Matrix "kg, kg m, kg m2" "x, y, z, rotation about x, y, z";

    /// `[[substructure.water_plane]]`.
    SUBSTRUCTURE_WATER_PLANE = "[[substructure.water_plane]]":
        required "joint" Text "" "its name";
        required "matrix" Matrix "N/m, N, N m" "x, y, z, rotation about x, y, z";

    /// `[[soil]]`.
    SOIL = "[[soil]]":
        optional "name" Text "" "";
        required "rows" Rows "" "height in m, springs in x, in y (N/m2), in z (N/m2), in torsion, against rotation about x and y (N)";

    /// `[[added_mass]]`.
    ADDED_MASS = "[[added_mass]]":
        optional "name" Text "" "";
        required "rows" Rows "" "height in m, added mass in x and y in kg/m";

    /// `[gravity]`.
    GRAVITY = "[gravity]":
        optional "acceleration" Number "m/s2" "";
}

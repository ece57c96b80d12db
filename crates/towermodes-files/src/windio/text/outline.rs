//! The parts of a windIO file that are read, and the names of the keys that are not read.

use super::yaml::{Node, Value};
use crate::diagnostic::Diagnostic;

/// The parts of the file.
#[derive(Debug)]
pub(crate) struct Outline {
    pub(crate) version: Option<Node>,
    pub(crate) name: Option<Node>,
    pub(crate) assembly: Option<Node>,
    pub(crate) components: Option<Components>,
    pub(crate) materials: Option<Node>,
    pub(crate) environment: Option<Node>,
    pub(crate) control: Option<Node>,
    /// Keys that are not read.
    pub(crate) unknown: Vec<String>,
}

/// The parts of the turbine.
#[derive(Debug)]
pub(crate) struct Components {
    pub(crate) tower: Option<Node>,
    pub(crate) monopile: Option<Node>,
    pub(crate) jacket: Option<Node>,
    pub(crate) floating_platform: Option<Node>,
    pub(crate) mooring: Option<Node>,
    /// The whole rotor-nacelle assembly, in the first files of version 1.
    pub(crate) rna: Option<Node>,
    pub(crate) hub: Option<Node>,
    /// The nacelle, in version 1.
    pub(crate) nacelle: Option<Node>,
    /// The drivetrain, in version 2.
    pub(crate) drivetrain: Option<Node>,
    /// The yaw system, in version 2.
    pub(crate) yaw: Option<Node>,
    pub(crate) blade: Option<Blade>,
    /// Keys that are not read.
    pub(crate) unknown: Vec<String>,
}

/// A blade, with the parts that give its mass and its chords.
#[derive(Debug)]
pub(crate) struct Blade(Node);

/// The entries of a map, each of which can be taken once.
struct Entries(Vec<(String, Node)>);

impl Entries {
    fn of(node: Node, what: &str) -> Result<Self, Diagnostic> {
        match node.value {
            Value::Map(entries) => Ok(Self(entries)),
            Value::Null => Ok(Self(Vec::new())),
            _ => Err(node.wrong(what, "a map")),
        }
    }

    /// The value of a key; an empty value counts as missing.
    fn take(&mut self, key: &str) -> Option<Node> {
        let index = self.0.iter().position(|(name, _)| name == key)?;
        let (_, node) = self.0.remove(index);
        (node.value != Value::Null).then_some(node)
    }

    /// The keys that were not taken.
    fn unknown(self) -> Vec<String> {
        self.0.into_iter().map(|(key, _)| key).collect()
    }
}

impl Outline {
    /// Divides the keys of a file into those that are read and the others.
    ///
    /// # Errors
    /// The file or its components are not a map.
    pub(crate) fn of(file: Node) -> Result<Self, Diagnostic> {
        let mut file = Entries::of(file, "the file")?;
        Ok(Self {
            version: file.take("windIO_version"),
            name: file.take("name"),
            assembly: file.take("assembly"),
            components: file.take("components").map(Components::of).transpose()?,
            materials: file.take("materials"),
            environment: file.take("environment"),
            control: file.take("control"),
            unknown: file.unknown(),
        })
    }
}

impl Components {
    fn of(node: Node) -> Result<Self, Diagnostic> {
        let mut own = Entries::of(node, "`components`")?;
        Ok(Self {
            tower: own.take("tower"),
            monopile: own.take("monopile"),
            jacket: own.take("jacket"),
            floating_platform: own.take("floating_platform"),
            mooring: own.take("mooring"),
            rna: own.take("RNA"),
            hub: own.take("hub"),
            nacelle: own.take("nacelle"),
            drivetrain: own.take("drivetrain"),
            yaw: own.take("yaw"),
            blade: own.take("blade").map(Blade::of).transpose()?,
            unknown: own.unknown(),
        })
    }
}

impl Blade {
    fn of(node: Node) -> Result<Self, Diagnostic> {
        let parts: [&[&str]; 7] = [
            &[],
            &["outer_shape"],
            &["outer_shape_bem"],
            &["structure"],
            &["structure", "elastic_properties"],
            &["elastic_properties_mb"],
            &["elastic_properties_mb", "six_x_six"],
        ];
        for path in parts {
            let part = node.find(path);
            if let Some(part) = part.filter(|part| !matches!(part.value, Value::Map(_))) {
                let what = path.last().copied().unwrap_or("blade");
                return Err(part.wrong(&format!("`{what}`"), "a map"));
            }
        }
        Ok(Self(node))
    }

    /// The axis, in version 2 a key of the blade, in version 1 of its shape.
    pub(crate) fn axis(&self) -> Option<&Node> {
        let older = || self.0.find(&["outer_shape_bem", "reference_axis"]);
        self.0.get("reference_axis").or_else(older)
    }

    /// The chords along the blade.
    pub(crate) fn chord(&self) -> Option<&Node> {
        let older = || self.0.find(&["outer_shape_bem", "chord"]);
        self.0.find(&["outer_shape", "chord"]).or_else(older)
    }

    /// Mass and inertia along the blade.
    pub(crate) fn inertia_matrix(&self) -> Option<&Node> {
        self.matrices()?.get("inertia_matrix")
    }

    /// Stiffness along the blade.
    pub(crate) fn stiffness_matrix(&self) -> Option<&Node> {
        let matrices = self.matrices()?;
        let newer = matrices.get("stiffness_matrix");
        newer.or_else(|| matrices.get("stiff_matrix"))
    }

    fn matrices(&self) -> Option<&Node> {
        match self.0.get("structure") {
            Some(structure) => structure.get("elastic_properties"),
            None => self.0.find(&["elastic_properties_mb", "six_x_six"]),
        }
    }
}

/// The two generations of the format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Version {
    /// 1.x: `outer_shape_bem`, angles in radians.
    One,
    /// 2.x: `outer_shape`, angles in degrees.
    Two,
}

impl Version {
    /// An angle of the file in radians.
    pub(crate) fn radians(self, angle: f64) -> f64 {
        match self {
            Self::One => angle,
            Self::Two => angle.to_radians(),
        }
    }

    /// The unit of angles in this version.
    pub(crate) fn angle_unit(self) -> &'static str {
        match self {
            Self::One => "rad",
            Self::Two => "degrees",
        }
    }

    /// The number of the version, as in the key `windIO_version`.
    pub(crate) fn number(self) -> u8 {
        match self {
            Self::One => 1,
            Self::Two => 2,
        }
    }

    /// The other version of windIO.
    pub(crate) fn other(self) -> Self {
        match self {
            Self::One => Self::Two,
            Self::Two => Self::One,
        }
    }
}

impl Outline {
    /// The version that the file gives, otherwise the version of its keys.
    pub(crate) fn version(&self, text: &str) -> Version {
        let said = self.version.as_ref().map(|node| node.name(text));
        match said.and_then(|version| version.trim().chars().next()) {
            Some('1') => Version::One,
            Some('2'..='9') => Version::Two,
            _ if self.has_old_keys() => Version::One,
            _ => Version::Two,
        }
    }

    fn has_old_keys(&self) -> bool {
        let Some(components) = &self.components else {
            return false;
        };
        let parts = [&components.tower, &components.monopile];
        let old = ["outer_shape_bem", "internal_structure_2d_fem"];
        let mut parts = parts.into_iter().flatten();
        parts.any(|part| old.iter().any(|key| part.get(key).is_some()))
            || components.nacelle.is_some()
    }
}

//! The parts of a windIO file that are read; all else, such as the tables of airfoils, is skipped.

use serde::Deserialize;
use serde::de::IgnoredAny;

use super::yaml::Node;

/// The file.
#[derive(Debug, Default)]
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
#[derive(Debug, Default)]
pub(crate) struct Components {
    pub(crate) tower: Option<Node>,
    pub(crate) monopile: Option<Node>,
    pub(crate) jacket: Option<IgnoredAny>,
    pub(crate) floating_platform: Option<IgnoredAny>,
    pub(crate) mooring: Option<IgnoredAny>,
    /// The whole rotor-nacelle assembly, in the first files of version 1.
    pub(crate) rna: Option<Node>,
    pub(crate) hub: Option<Node>,
    /// Version 1.
    pub(crate) nacelle: Option<Node>,
    /// Version 2.
    pub(crate) drivetrain: Option<Node>,
    /// Version 2.
    pub(crate) yaw: Option<Node>,
    pub(crate) blade: Option<Blade>,
    /// Keys that are not read.
    pub(crate) unknown: Vec<String>,
}

/// The parts of a blade that give its mass and its chords.
#[derive(Debug, Default, Deserialize)]
pub(crate) struct Blade {
    /// Version 2.
    reference_axis: Option<Node>,
    /// Version 1.
    outer_shape_bem: Option<BladeShape>,
    /// Version 2.
    outer_shape: Option<BladeShape>,
    /// Version 2.
    structure: Option<BladeStructure>,
    /// Version 1.
    elastic_properties_mb: Option<BladeTables>,
}

#[derive(Debug, Default, Deserialize)]
struct BladeShape {
    reference_axis: Option<Node>,
    chord: Option<Node>,
}

#[derive(Debug, Default, Deserialize)]
struct BladeStructure {
    elastic_properties: Option<BladeMatrices>,
}

#[derive(Debug, Default, Deserialize)]
struct BladeTables {
    six_x_six: Option<BladeMatrices>,
}

#[derive(Debug, Default, Deserialize)]
struct BladeMatrices {
    inertia_matrix: Option<Node>,
    /// Version 1.
    stiff_matrix: Option<Node>,
    /// Version 2.
    stiffness_matrix: Option<Node>,
}

impl Blade {
    pub(crate) fn axis(&self) -> Option<&Node> {
        let shape = self.outer_shape_bem.as_ref();
        let older = shape.and_then(|shape| shape.reference_axis.as_ref());
        self.reference_axis.as_ref().or(older)
    }

    /// The chords along the blade.
    pub(crate) fn chord(&self) -> Option<&Node> {
        let shapes = [&self.outer_shape, &self.outer_shape_bem];
        let mut chords = shapes.into_iter().flatten().map(|shape| &shape.chord);
        chords.find_map(Option::as_ref)
    }

    /// Mass and inertia along the blade.
    pub(crate) fn inertia_matrix(&self) -> Option<&Node> {
        self.matrices()
            .and_then(|matrices| matrices.inertia_matrix.as_ref())
    }

    /// Stiffness along the blade.
    pub(crate) fn stiffness_matrix(&self) -> Option<&Node> {
        let matrices = self.matrices()?;
        let newer = matrices.stiffness_matrix.as_ref();
        newer.or(matrices.stiff_matrix.as_ref())
    }

    fn matrices(&self) -> Option<&BladeMatrices> {
        let newer = self.structure.as_ref().map(|s| &s.elastic_properties);
        let older = self.elastic_properties_mb.as_ref().map(|e| &e.six_x_six);
        newer.or(older).and_then(Option::as_ref)
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
}

impl Outline {
    /// Its version, or that of its keys if it is not given.
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

//! The file and its components as far as they are read, and the names of the keys that are not.

use std::fmt;

use serde::de::{IgnoredAny, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::outline::{Components, Outline};

/// A mapping some of whose keys are read.
pub(super) trait Fields<'de>: Default {
    /// Reads the value of a key; false if the key is not read, and its value is still to come.
    ///
    /// # Errors
    /// The error of the value.
    fn take<A: MapAccess<'de>>(&mut self, key: &str, map: &mut A) -> Result<bool, A::Error>;

    /// Remembers a key that is not read.
    fn unknown(&mut self, key: String);
}

/// The visitor of such a mapping.
struct OfFields<T>(T);

impl<'de, T: Fields<'de>> Visitor<'de> for OfFields<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a map")
    }

    fn visit_unit<E>(self) -> Result<T, E> {
        Ok(self.0)
    }

    fn visit_map<A: MapAccess<'de>>(mut self, mut map: A) -> Result<T, A::Error> {
        while let Some(key) = map.next_key::<String>()? {
            if !self.0.take(&key, &mut map)? {
                map.next_value::<IgnoredAny>()?;
                self.0.unknown(key);
            }
        }
        Ok(self.0)
    }
}

/// Reads the value of a field by its key.
macro_rules! fields {
    ($self:ident, $key:ident, $map:ident, $($name:literal => $field:ident),+ $(,)?) => {
        match $key {
            $($name => $self.$field = $map.next_value()?,)+
            _ => return Ok(false),
        }
    };
}

impl<'de> Fields<'de> for Outline {
    fn take<A: MapAccess<'de>>(&mut self, key: &str, map: &mut A) -> Result<bool, A::Error> {
        fields!(self, key, map,
            "windIO_version" => version,
            "name" => name,
            "assembly" => assembly,
            "components" => components,
            "materials" => materials,
            "environment" => environment,
            "control" => control,
        );
        Ok(true)
    }

    fn unknown(&mut self, key: String) {
        self.unknown.push(key);
    }
}

impl<'de> Fields<'de> for Components {
    fn take<A: MapAccess<'de>>(&mut self, key: &str, map: &mut A) -> Result<bool, A::Error> {
        fields!(self, key, map,
            "tower" => tower,
            "monopile" => monopile,
            "jacket" => jacket,
            "floating_platform" => floating_platform,
            "mooring" => mooring,
            "RNA" => rna,
            "hub" => hub,
            "nacelle" => nacelle,
            "drivetrain" => drivetrain,
            "yaw" => yaw,
            "blade" => blade,
        );
        Ok(true)
    }

    fn unknown(&mut self, key: String) {
        self.unknown.push(key);
    }
}

impl<'de> Deserialize<'de> for Outline {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(OfFields(Self::default()))
    }
}

impl<'de> Deserialize<'de> for Components {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(OfFields(Self::default()))
    }
}

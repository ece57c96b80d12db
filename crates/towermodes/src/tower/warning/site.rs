//! The site of the value that a warning is about.

use std::fmt;

use super::super::pieces::planes::Plane;
use crate::number::Plain;
use crate::tower::error::Place;

/// The site of the value that a warning is about: in the description, and on the tower.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Site {
    /// Its place in the description; none if it is of the tower as a whole.
    pub place: Option<Place>,
    /// Height on the tower, m, in the user's datum.
    pub height_m: Option<f64>,
    /// The bending plane, if the value is of one.
    pub plane: Option<Plane>,
}

impl Site {
    /// A place in the description.
    pub(crate) fn at(place: Place) -> Self {
        Self {
            place: Some(place),
            ..Self::default()
        }
    }

    /// The same site with a height (m) on the tower.
    pub(crate) fn high(self, height_m: f64) -> Self {
        Self {
            height_m: Some(height_m),
            ..self
        }
    }

    /// The same site in one plane.
    pub(crate) fn in_plane(self, plane: Plane) -> Self {
        Self {
            plane: Some(plane),
            ..self
        }
    }

    /// "station 4: ", or nothing.
    pub(crate) fn before(self) -> impl fmt::Display {
        Words(move |f: &mut fmt::Formatter<'_>| match self.place {
            Some(place) => write!(f, "{place}: "),
            None => Ok(()),
        })
    }

    /// " in the side-side plane at z = 45 m", or the known part of this.
    pub(crate) fn after(self) -> impl fmt::Display {
        Words(move |f: &mut fmt::Formatter<'_>| {
            match self.plane {
                Some(Plane::ForeAft) => write!(f, " in the fore-aft plane")?,
                Some(Plane::SideSide) => write!(f, " in the side-side plane")?,
                None => {}
            }
            match self.height_m {
                Some(height_m) => write!(f, " at z = {} m", Plain(height_m)),
                None => Ok(()),
            }
        })
    }
}

/// A text that a function writes.
struct Words<W>(W);

impl<W: Fn(&mut fmt::Formatter<'_>) -> fmt::Result> fmt::Display for Words<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0(f)
    }
}

//! The structure of a case.

use towermodes::TowerDescription;
use towermodes::frame::{FrameDescription, FrameRecipe};
use towermodes::mooring::MooringDescription;

use crate::turning::Turning;

/// The structure of a case.
#[derive(Debug, Clone)]
pub enum Subject {
    /// A tower, solved by each method.
    Tower(Box<TowerDescription>),
    /// A turbine with rotating rotor on a tower.
    Turbine(Box<TowerDescription>, Box<Turning>),
    /// A frame without a tower, with elements of this kind; none means exact beams.
    Frame(Box<FrameDescription>, Option<FrameRecipe>),
    /// A mooring system at its reference pose.
    Mooring(Box<MooringDescription>),
}

impl Subject {
    /// A tower.
    pub fn tower(description: TowerDescription) -> Self {
        Self::Tower(Box::new(description))
    }

    /// The tower, if it is one.
    pub fn as_tower(&self) -> Option<&TowerDescription> {
        match self {
            Self::Tower(tower) | Self::Turbine(tower, _) => Some(tower),
            Self::Frame(..) | Self::Mooring(_) => None,
        }
    }
}

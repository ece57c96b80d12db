//! The script that draws a tower in three dimensions.

/// A script that defines the global `towermodesView`: a tower in three dimensions, drawn by WebGL
/// from [`AnimationData`](crate::figures::AnimationData) as JSON.
///
/// It is built from the folder `page/` of the repository, contains the library three.js with its
/// licence, and loads nothing.
pub static VIEW_SCRIPT: &str = include_str!("built/view.js");

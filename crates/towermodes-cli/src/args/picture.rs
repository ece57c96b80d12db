//! The file of a picture that a command draws beside its result.

use std::path::Path;

/// The format of such a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PictureFile {
    /// Lines and text, for any size.
    Svg,
    /// Pixels.
    Png,
}

impl PictureFile {
    /// The message for another file extension.
    pub(super) const UNKNOWN: &str =
        "unknown file extension for a picture; use --plot FILE.svg or FILE.png";

    /// By the file extension.
    pub(super) fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_ascii_lowercase();
        match ending.to_str() {
            Some("svg") => Some(Self::Svg),
            Some("png") => Some(Self::Png),
            _ => None,
        }
    }
}

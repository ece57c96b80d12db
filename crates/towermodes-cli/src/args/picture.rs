//! The file of a picture that a command draws in addition to its result.

use std::path::Path;

/// The format of such a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PictureFile {
    /// SVG: lines and text, for any size.
    Svg,
    /// PNG: pixels.
    Png,
}

impl PictureFile {
    /// The message for an unknown file extension.
    pub(crate) const UNKNOWN: &str =
        "unknown file extension for a picture; use --plot FILE.svg or FILE.png";

    /// The path of a picture with its format, if a picture is requested.
    ///
    /// # Errors
    /// The message for an unknown file extension.
    pub(crate) fn requested(path: Option<&Path>) -> Result<Option<(&Path, Self)>, &'static str> {
        let with_format = |path| Ok((path, Self::of(path).ok_or(Self::UNKNOWN)?));
        path.map(with_format).transpose()
    }

    /// The format that a file extension selects.
    pub(crate) fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_ascii_lowercase();
        match ending.to_str() {
            Some("svg") => Some(Self::Svg),
            Some("png") => Some(Self::Png),
            _ => None,
        }
    }
}

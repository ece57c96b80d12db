//! The yaw spring of a model, which is in the file of ServoDyn that an `.fst` file names.

use super::super::fst::switch;
use super::super::names::line_of;
use super::super::positional::Parameter;
use super::super::record::{NON_NEGATIVE, Record, record};
use crate::note::Note;
use crate::resolver::FileResolver;
use crate::source::Source;

const YAW_SPRING: Record = record(
    "YawSpr",
    "stiffness of the yaw drive, N m/rad",
    NON_NEGATIVE,
);

/// The data of the yaw spring.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum YawSpring {
    /// The stiffness, N m/rad.
    Given(f64),
    /// No file contains it, for this reason.
    Unknown(Note),
    /// The value is impossible, for this reason.
    Impossible(Note),
}

/// The yaw spring in the files of an `.fst` file.
pub(crate) fn yaw_spring(fst: &Source, files: &dyn FileResolver) -> YawSpring {
    if let Some((0, at)) = switch(fst, "CompServo") {
        let message = "YawDOF is True, but CompServo is 0, and the spring YawSpr of the yaw drive is in the file of ServoDyn: the nacelle does not yaw on the tower";
        return YawSpring::Unknown(Note::assumption(message).at(fst, at));
    }
    let Some(name) = line_of(&fst.text, "ServoFile").and_then(|line| line.first()) else {
        let message = "YawDOF is True, but the .fst file has no ServoFile, whose file has the spring YawSpr of the yaw drive: the nacelle does not yaw on the tower";
        return YawSpring::Unknown(Note::assumption(message));
    };
    match files.read(name.text.trim()) {
        Ok(servo) => in_file(&servo),
        Err(error) => {
            let message = format!(
                "YawDOF is True, but the file with the spring YawSpr of the yaw drive cannot be read ({error}): the nacelle does not yaw on the tower"
            );
            YawSpring::Unknown(Note::assumption(message).at(fst, name.span.start))
        }
    }
}

/// The yaw spring in a file of ServoDyn.
fn in_file(servo: &Source) -> YawSpring {
    let Some(line) = line_of(&servo.text, YAW_SPRING.name) else {
        let message = format!(
            "YawDOF is True, but {} has no YawSpr: the nacelle does not yaw on the tower",
            servo.name
        );
        return YawSpring::Unknown(Note::assumption(message));
    };
    let value = Parameter::of(&line, &YAW_SPRING).and_then(|parameter| parameter.number());
    let message = match value {
        Ok(stiffness) if stiffness > 0.0 => return YawSpring::Given(stiffness),
        Ok(_) => "YawSpr is 0 N m/rad although YawDOF is True: nothing holds the nacelle in yaw; YawSpr must be greater than 0, or YawDOF False".to_owned(),
        Err(mistake) => mistake.message(),
    };
    let at = line.first().map_or(line.start, |token| token.span.start);
    YawSpring::Impossible(Note::missing_part(message).at(servo, at))
}

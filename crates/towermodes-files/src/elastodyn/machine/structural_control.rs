//! The structural controls of ServoDyn (StC): masses on springs, liquid columns and forces in
//! blades, nacelle, tower and platform.
//!
//! A mass on springs moves rigidly with its part of the turbine, as a locked damper. Controls
//! without such a mass, and those in the blades, are omitted.

use std::ops::Range;

use towermodes::RigidBody;
use towermodes::number::{Plain, Rounded};

use super::super::fst::{is_on, switch};
use super::super::main_input::main_file::MainFile;
use super::super::names::line_of;
use super::damper::{Control, Damper};
use crate::note::Note;
use crate::records::{Lines, Token};
use crate::resolver::{FileResolver, beside, folder_of};
use crate::source::Source;

/// The part of the turbine that carries structural controls.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Part {
    Blades,
    Nacelle,
    Tower,
    Platform,
}

impl Part {
    fn name(self) -> &'static str {
        match self {
            Self::Blades => "blades",
            Self::Nacelle => "nacelle",
            Self::Tower => "tower",
            Self::Platform => "platform or the substructure",
        }
    }

    /// The reference point of the positions of its structural controls.
    fn origin(self) -> &'static str {
        match self {
            Self::Blades => "the root of the blade",
            Self::Nacelle => "the tower top",
            Self::Tower => "the tower base",
            Self::Platform => "the reference point of the platform",
        }
    }
}

/// The number of structural controls with the name of the line of their files (since OpenFAST 3.0),
/// or whether there is one (before), in a file of ServoDyn. The files of blades are not read.
const CONTROLS: [(&str, Option<&str>, Part); 6] = [
    ("NumBStC", None, Part::Blades),
    ("NumNStC", Some("NStCfiles"), Part::Nacelle),
    ("NumTStC", Some("TStCfiles"), Part::Tower),
    ("NumSStC", Some("SStCfiles"), Part::Platform),
    ("CompNTMD", None, Part::Nacelle),
    ("CompTTMD", None, Part::Tower),
];

/// The masses of structural controls by the part of the turbine that carries them, and notes.
#[derive(Debug, Clone, Default)]
pub(crate) struct Controls {
    /// On the nacelle, measured from the tower top.
    pub(crate) nacelle: Vec<RigidBody>,
    /// On the tower, measured from its base; z is along the tower.
    pub(crate) tower: Vec<RigidBody>,
    /// On the platform or the transition piece, measured from the platform's reference point.
    pub(crate) platform: Vec<RigidBody>,
    pub(crate) notes: Vec<Note>,
}

/// A body with masses on it.
pub(crate) fn with_masses(body: RigidBody, masses: &[RigidBody]) -> RigidBody {
    match masses {
        [] => body,
        masses => RigidBody::combined(&[&[body], masses].concat()),
    }
}

/// The structural controls of the ServoDyn file that an `.fst` file names. If this file cannot be
/// read, there is a note if its other values matter.
pub(crate) fn structural_controls(
    fst: &Source,
    main: &MainFile,
    files: &dyn FileResolver,
) -> Controls {
    let mut controls = Controls::default();
    if !is_on(fst, "CompServo") {
        return controls;
    }
    let named = line_of(&fst.text, "ServoFile").and_then(|line| line.first());
    let Some(path) = named.map(|named| named.text.trim()) else {
        return controls;
    };
    let Ok(servo) = files.read(path) else {
        return controls;
    };
    let servo = Servo {
        folder: folder_of(path, &servo),
        source: &servo,
        files,
    };
    for (name, file_names, part) in CONTROLS {
        let Some((count, at)) = switch(servo.source, name).filter(|(count, _)| *count > 0) else {
            continue;
        };
        match file_names {
            Some(file_names) => {
                for path in servo.paths(file_names, count as usize) {
                    controls.add(part, &servo, &path, main);
                }
            }
            None => controls.notes.push(left_out(&servo, name, part, count, at)),
        }
    }
    controls
}

/// The note on the structural controls of a part of the turbine that are omitted.
fn left_out(servo: &Servo<'_>, name: &str, part: Part, count: i64, at: usize) -> Note {
    let place = part.name();
    let what = match count {
        1 => format!("the structural control of the {place} ({name}) is"),
        _ => format!("the {count} structural controls of the {place} ({name}) are"),
    };
    let message = format!(
        "{what} left out, with the mass: this model has no masses on springs, liquid columns or control forces there; without the mass the frequencies are too high"
    );
    Note::missing_part(message).at(servo.source, at)
}

/// A file of ServoDyn.
struct Servo<'a> {
    source: &'a Source,
    /// Its folder as seen from the `.fst` file.
    folder: &'a str,
    files: &'a dyn FileResolver,
}

impl Servo<'_> {
    /// The first paths on a line, before its name.
    fn paths(&self, name: &str, count: usize) -> Vec<Token<'_>> {
        let is_name = |token: &Token<'_>| token.text.eq_ignore_ascii_case(name);
        let mut lines = Lines::new(&self.source.text);
        let line = lines.find(|line| line.tokens().any(|token| is_name(&token)));
        let tokens = line.into_iter().flat_map(|line| line.tokens());
        tokens
            .take_while(|token| !is_name(token))
            .take(count)
            .collect()
    }
}

impl Controls {
    /// Adds the structural control in a file.
    fn add(&mut self, part: Part, servo: &Servo<'_>, path: &Token<'_>, main: &MainFile) {
        let name = path.text.trim();
        let on_servo =
            |message: String| Note::missing_part(message).at(servo.source, path.span.start);
        let source = match servo.files.read(&beside(servo.folder, name)) {
            Ok(source) => source,
            Err(error) => {
                let message = format!(
                    "the structural control of the {} in {name} is left out, with the mass, because the file cannot be read ({error}): without the mass the frequencies are too high",
                    part.name()
                );
                self.notes.push(on_servo(message));
                return;
            }
        };
        match Control::of(&source) {
            Ok(Control::Damper(damper)) => self.carry(part, &damper, &source, main),
            Ok(Control::Other(mode)) => self.notes.push(no_mass(part, mode, &source)),
            Err(mistake) => {
                let message = format!(
                    "the structural control of the {} in {name} is left out, with the mass: {}; without the mass the frequencies are too high",
                    part.name(),
                    mistake.message()
                );
                self.notes.push(on_servo(message));
            }
        }
    }

    /// Adds the mass of a damper to the part that carries it.
    fn carry(&mut self, part: Part, damper: &Damper, source: &Source, main: &MainFile) {
        let body = RigidBody::point(damper.mass_kg, damper.position_m);
        let note = match part {
            Part::Tower if !is_on_tower(damper, main) => outside(damper, main),
            Part::Nacelle | Part::Tower | Part::Platform => locked(part, damper),
            Part::Blades => return,
        };
        let at = line_of(&source.text, "StC_DOF_MODE").map_or(0, |line| line.start);
        let is_left_out = note.is_on_missing_part();
        self.notes.push(note.at(source, at));
        if is_left_out || damper.mass_kg == 0.0 {
            return;
        }
        match part {
            Part::Nacelle => self.nacelle.push(body),
            Part::Tower => self.tower.push(body),
            Part::Platform => self.platform.push(body),
            Part::Blades => {}
        }
    }
}

/// The range of the tower between base and top, along z from the base, m.
fn tower_m(main: &MainFile) -> Range<f64> {
    let length_m = main.tower_top_m - main.tower_base_m;
    length_m.min(0.0)..length_m.max(0.0)
}

fn is_on_tower(damper: &Damper, main: &MainFile) -> bool {
    let Range { start, end } = tower_m(main);
    (start..=end).contains(&damper.position_m[2])
}

/// The note on a damper that is not on the tower.
fn outside(damper: &Damper, main: &MainFile) -> Note {
    let Range { start, end } = tower_m(main);
    Note::missing_part(format!(
        "the structural control of the tower is left out, with its mass of {} kg: StC_P_Z is {} m, but the tower is from {} to {} m above its base",
        Rounded(damper.mass_kg),
        Plain(damper.position_m[2]),
        Rounded(start),
        Rounded(end)
    ))
}

/// The note on the mass of a damper that moves rigidly with its part.
fn locked(part: Part, damper: &Damper) -> Note {
    let [x, y, z] = damper.position_m.map(Plain);
    let origin = part.origin();
    let own = match &damper.frequencies_hz[..] {
        [] => String::new(),
        all => {
            let all = all.iter();
            let all = all.map(|(along, hz)| format!("{} Hz along {along}", Rounded(*hz)));
            let all: Vec<String> = all.collect();
            format!("; its own frequency is {}", all.join(", "))
        }
    };
    let axis = match part {
        Part::Tower if damper.position_m[..2] != [0.0; 2] => ", taken on the axis of the tower",
        Part::Blades | Part::Nacelle | Part::Tower | Part::Platform => "",
    };
    Note::approximation(format!(
        "the damper of the {} is locked: its mass of {} kg moves rigidly, at ({x}, {y}, {z}) m from {origin}{axis}{own}; a moving damper would change the modes",
        part.name(),
        Rounded(damper.mass_kg)
    ))
}

/// The note on a structural control without a mass on springs.
fn no_mass(part: Part, mode: i64, source: &Source) -> Note {
    let place = part.name();
    let message = match mode {
        0 => format!("the structural control of the {place} is off (StC_DOF_MODE 0)"),
        _ => format!(
            "the structural control of the {place} is left out: with StC_DOF_MODE {mode} it is a liquid column, whose mass is missing, or a force, which has none"
        ),
    };
    let at = line_of(&source.text, "StC_DOF_MODE").map_or(0, |line| line.start);
    Note::left_out(message).at(source, at)
}

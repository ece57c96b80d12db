//! Writing to each format and reading back as a user's program would.

use crate::sources::source;
use towermodes::{Tower, TowerDescription};
use towermodes_analysis::elastodyn::MakeOptions;
use towermodes_files::elastodyn::{left_out, make_tower_file, write_tower_file};
use towermodes_files::{
    BmodesWriteError, BmodesWriteOptions, InMemory, Input, Note, ReadOptions, Source, TowerInput,
    read_source, write_bmodes, write_toml, write_windio,
};
use towermodes_testing::with;

/// A format that towers are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    Toml,
    Bmodes,
    ElastoDyn,
    WindIo,
}

impl Target {
    pub const ALL: [Self; 4] = [Self::Toml, Self::Bmodes, Self::ElastoDyn, Self::WindIo];
}

/// What a writer makes.
pub struct Written {
    pub source: Source,
    pub companions: InMemory,
    pub notes: Vec<Note>,
}

impl Written {
    /// A file alone, by a name that must not be needed to know its format.
    fn alone(name: &str, text: String, notes: Vec<Note>) -> Self {
        Self {
            source: source(name, text),
            companions: InMemory::default(),
            notes,
        }
    }

    /// The tower in it.
    #[track_caller]
    pub fn read(&self) -> TowerInput {
        let expected = self.source.clone();
        let read = read_source(expected, &self.companions, &ReadOptions::default());
        match read {
            Ok(Input::Tower(input)) => *input,
            other => panic!("no tower: {other:?}\n{}", self.source.text),
        }
    }
}

pub fn tower(description: &TowerDescription) -> Tower {
    Tower::new(description.clone()).expect("a tower")
}

#[track_caller]
pub fn written(description: &TowerDescription, target: Target) -> Written {
    match target {
        Target::Toml => {
            let (text, notes) = write_toml(description);
            Written::alone("toml", text, notes)
        }
        Target::Bmodes => bmodes(description).expect("a deck"),
        Target::ElastoDyn => elastodyn(description, &with_masses_listed()),
        Target::WindIo => {
            let (text, notes) = write_windio(&tower(description), description).expect("a file");
            Written::alone("windio", text, notes)
        }
    }
}

pub fn bmodes(description: &TowerDescription) -> Result<Written, BmodesWriteError> {
    let options = BmodesWriteOptions::default();
    let files = write_bmodes(&tower(description), description, &options)?;
    let mut written = Written::alone("bmodes", files.deck, files.notes);
    let companions = &mut written.companions.files;
    companions.insert(options.sections_file, files.sections);
    Ok(written)
}

/// As for OpenFAST 4.2 and newer.
pub fn with_masses_listed() -> MakeOptions {
    with!(MakeOptions, has_concentrated_masses = true)
}

#[track_caller]
pub fn elastodyn(description: &TowerDescription, options: &MakeOptions) -> Written {
    let made = make_tower_file(&tower(description), options).expect("a tower file");
    let has_masses = !made.content.concentrated_masses.is_empty();
    let text = write_tower_file(&made.content, has_masses).expect("a tower file");
    let mut notes = made.notes;
    notes.extend(left_out(description));
    Written::alone("elastodyn", text, notes)
}

/// Writes and reads back.
#[track_caller]
pub fn there_and_back(description: &TowerDescription, target: Target) -> TowerInput {
    written(description, target).read()
}

//! Density, depth and level of the water of a model, which are given in several files.

use crate::diagnostic::line_and_column;
use crate::error::ReadError;
use crate::hydrodyn::{GivenWater, WaterDefaults, given_in, read_water, water_of_fst};
use crate::note::Note;
use crate::source::Source;

/// Two values that differ by less than this fraction count as equal.
const SAME: f64 = 1e-3;

/// The files that give the water, in this order: the `.fst` file, the SeaState file, the HydroDyn
/// file. If several files give a value, the last file is used.
#[derive(Debug, Default)]
pub(super) struct Sea {
    files: Vec<Source>,
}

impl Sea {
    pub(super) fn add(&mut self, file: Source) {
        self.files.push(file);
    }

    /// The values of the files added so far, which are the defaults for the next file.
    pub(super) fn defaults(&self) -> Result<WaterDefaults, ReadError> {
        let Some((fst, others)) = self.files.split_first() else {
            return Ok(WaterDefaults::default());
        };
        let of_fst = water_of_fst(fst)?;
        let mut others = others.iter();
        others.try_fold(of_fst, |before, file| read_water(file, before))
    }

    /// The depth that is used, and the file that gives it.
    pub(super) fn depth(&self) -> Option<(&Source, GivenWater)> {
        let mut given = self.given().filter(|(_, given)| given.name == "WtrDpth");
        given.next_back()
    }

    fn given(&self) -> impl DoubleEndedIterator<Item = (&Source, GivenWater)> {
        let files = self.files.iter();
        files.flat_map(|file| given_in(file).into_iter().map(move |given| (file, given)))
    }

    /// Notes on values that differ between the files.
    pub(super) fn notes(&self) -> Vec<Note> {
        let mut notes = Vec::new();
        let all: Vec<_> = self.given().collect();
        for (index, (file, own)) in all.iter().enumerate() {
            let mut before = all[..index].iter().rev();
            let Some((other_file, other)) = before.find(|(_, other)| other.name == own.name) else {
                continue;
            };
            let largest = own.value.abs().max(other.value.abs());
            if (own.value - other.value).abs() > SAME * largest {
                let message = format!(
                    "{} is {} here, but {} in {}: the value here is used; make both equal, or write \"default\" here",
                    own.name,
                    own.value,
                    other.value,
                    place(other_file, other.at)
                );
                notes.push(Note::suspicious(message).at(file, own.at));
            }
        }
        notes
    }
}

/// The text for a place: the file and the line of one of its bytes.
pub(super) fn place(file: &Source, byte: usize) -> String {
    let (line, _) = line_and_column(&file.text, byte);
    format!("{}:{line}", file.name)
}

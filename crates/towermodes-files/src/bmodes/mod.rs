//! Decks of BModes, the finite-element program of NREL for towers and blades: a main file (.bmi)
//! and a section file.
//!
//! Sources of the records and their meaning: BModes 3.00 (Bir, NREL, 2008), its sample files, and
//! the decks that later versions and other programs write.

mod description;
mod records;
mod results;
mod write;

pub use results::norm::euclidean;
pub use results::out::{OutHeader, OutMode, OutRow, write_bmodes_out};
pub use results::out_nodes::OutNodes;
pub use write::{BmodesFiles, BmodesWriteError, BmodesWriteOptions, write_bmodes};

use crate::diagnostic::DiagnosticKind;
use crate::error::ReadError;
use crate::input::{BladeInput, ReadOptions, TowerInput};
use crate::records::{Line, Lines};
use crate::resolver::FileResolver;
use crate::source::Source;
use records::deck::{Beam, Deck};
use records::parameters::{Kind, Parameter};
use records::reader::Reader;

/// The tower or blade of a deck.
#[derive(Debug, Clone)]
pub enum BmodesInput {
    /// A tower.
    Tower(Box<TowerInput>),
    /// A blade.
    Blade(Box<BladeInput>),
}

/// The files of a deck, the main one first.
struct Sources {
    main: Source,
    sections: Source,
}

impl Sources {
    fn into_list(self) -> Vec<Source> {
        vec![self.main, self.sections]
    }
}

/// Reads a deck from its main file; `files` gives the section file that it names.
///
/// # Errors
/// [`ReadError::Unreadable`] if there is no section file, [`ReadError::Mistakes`] for input that
/// BModes does not accept or that is physically impossible.
pub fn read_bmodes(
    source: Source,
    files: &dyn FileResolver,
    options: &ReadOptions,
) -> Result<BmodesInput, ReadError> {
    let (deck, sources) = read_deck(source, files)?;
    let compatible = options.bmodes_quirks;
    Ok(match deck.beam {
        Beam::Tower => BmodesInput::Tower(Box::new(description::tower::tower(
            &deck, sources, compatible,
        )?)),
        Beam::Blade => BmodesInput::Blade(Box::new(description::blade::blade(
            &deck, sources, compatible,
        )?)),
    })
}

fn read_deck(source: Source, files: &dyn FileResolver) -> Result<(Deck, Sources), ReadError> {
    let mut reader = Reader::new(&source.text);
    let in_main = |mistake| ReadError::mistake(&source, mistake);
    let (mut deck, sections_file) = records::main_file::main_file(&mut reader).map_err(in_main)?;
    if deck.beam == Beam::Tower {
        let nodes = deck.borders.len();
        let support = records::support::support(&mut reader, deck.dialect, nodes);
        (deck.dialect, deck.support) = support.map_err(in_main)?;
    }
    let file = files.read(sections_file.value).map_err(|error| {
        let kind = DiagnosticKind::unreadable("the section file", &error);
        let hint = "it is looked for in the folder of the .bmi file; names may be case-sensitive";
        in_main(sections_file.wrong(kind).with_hint(hint))
    })?;
    let sections = records::sections::sections(&file.text, deck.beam);
    let sections = sections.map_err(|mistakes| ReadError::mistakes(&file, mistakes))?;
    (deck.sections, deck.extra_columns) = (sections.rows, sections.extra_columns);
    let sources = Sources {
        main: source,
        sections: file,
    };
    Ok((deck, sources))
}

/// Largest number of lines used to recognize a deck.
const LOOKED_AT: usize = 60;

/// Whether a text is the main file of a deck: lines with the names of its parameters after a value
/// or, without names, values of the types of its general parameters.
pub(crate) fn is_deck(text: &str) -> bool {
    let lines: Vec<Line<'_>> = Lines::new(text).take(LOOKED_AT).collect();
    let names = [
        &records::parameters::BEAM_TYPE,
        &records::parameters::HUB_CONN,
        &records::parameters::MODEPR,
        &records::parameters::ID_MAT,
        &records::parameters::SEC_PROPS_FILE,
        &records::parameters::NSELT,
    ];
    let is_named = |line: &&Line<'_>| {
        let label = line
            .tokens()
            .skip(1)
            .find(|t| t.text.contains(char::is_alphanumeric));
        let parameter = label.and_then(|label| Parameter::called(label.text));
        parameter.is_some_and(|parameter| names.contains(&parameter))
    };
    lines.iter().filter(is_named).count() >= 2 || has_general_parameters(&lines)
}

/// Whether the values of lines 5 to 16 have the types of the general parameters.
fn has_general_parameters(lines: &[Line<'_>]) -> bool {
    let values = lines.iter().skip(4).filter(|line| !line.is_blank());
    let mut count = 0;
    let fits = |(line, parameter): (&Line<'_>, &Parameter)| {
        count += 1;
        line.first().is_some_and(|token| match parameter.kind {
            Kind::Flag => token.logical("").is_ok(),
            Kind::Whole(_) => token.integer("").is_ok(),
            _ => token.is_number(),
        })
    };
    let all_fit = values.zip(records::parameters::GENERAL).all(fits);
    all_fit && count == records::parameters::GENERAL.len()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::records::deck::Dialect;
    use super::{is_deck, read_deck};
    use crate::resolver::SiblingFiles;
    use crate::source::Source;

    #[test]
    fn decks_are_recognized_by_their_lines() {
        let named = "a\nb\n\nc\nf Echo\n2 beam_type\n0. romg:\n1 hub_conn: x\n";
        assert!(is_deck(named));
        let bare = "a\nb\n\nc\nf\n2\n0.\n1.\n87.6\n0.\n0.\n0.\n1\n10\nt\nf\n";
        assert!(is_deck(bare));
        assert!(!is_deck(
            "[tower]\nbeam_type = 2\nhub_conn = 1\nid_mat = 3\n"
        ));
        assert!(!is_deck(
            "------- ELASTODYN -------\nfile\nFalse Echo\n\"default\" DT\n"
        ));
        assert!(!is_deck(""));
    }

    #[test]
    fn the_sample_decks_show_their_dialects() {
        let Some(folder) = std::env::var_os("TOWERMODES_PEER_DATA") else {
            eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
            return;
        };
        let samples = [
            ("Test01_nonunif_blade.bmi", Dialect::V3),
            ("Test02_blade_with_tip_mass.bmi", Dialect::V3),
            ("Test03_tower.bmi", Dialect::V3),
            ("Test04_wires_supported_tower.bmi", Dialect::V3),
            ("CS_Monopile.bmi", Dialect::Later),
            ("OC3Hywind.bmi", Dialect::Later),
        ];
        for (name, dialect) in samples {
            let path = Path::new(&folder).join("bmodes").join(name);
            let source = Source::from_path(&path).expect("the sample is there");
            assert!(is_deck(&source.text), "{name}");
            let (deck, _) = read_deck(source, &SiblingFiles::of(&path)).expect("a deck");
            assert_eq!(deck.dialect, dialect, "{name}");
        }
    }
}

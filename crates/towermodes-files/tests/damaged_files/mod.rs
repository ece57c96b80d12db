//! Files of every format with lines, numbers and bytes damaged: read or refused at a place inside
//! one of their files, never a panic.

mod damage;
mod offshore;
mod own_files;
mod peer_files;

use proptest::test_runner::TestCaseError;
use proptest::{prop_assert, prop_assert_eq};
use towermodes_files::{FileResolver, Input, ReadError, ReadOptions, Source, read_source};

use damage::{Damage, Damaged};

/// Where the damage is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Where {
    Main,
    Companions,
}

/// Reads a file, or those that it names, damaged: what comes out is a tower or a mistake inside a
/// file.
fn survives(
    source: &Source,
    companions: &dyn FileResolver,
    place: Where,
    damages: &[Damage],
    options: &ReadOptions,
) -> Result<(), TestCaseError> {
    let mut main = source.clone();
    let damaged = Damaged {
        companions,
        damages,
    };
    let result = match place {
        Where::Main => {
            main.text = damage::all(&main.text, damages);
            read_source(main, companions, options)
        }
        Where::Companions => read_source(main, &damaged, options),
    };
    let error = match result {
        Ok(Input::Tower(input)) => input.tower().err(),
        Ok(Input::Blade(_) | Input::Substructure(_) | Input::Mooring(_)) => None,
        Err(error) => Some(error),
    };
    error.map_or(Ok(()), |error| is_inside_its_file(&error))
}

/// Whether an error names something that cannot be read, or mistakes at bytes that its file has.
fn is_inside_its_file(error: &ReadError) -> Result<(), TestCaseError> {
    prop_assert!(!error.to_string().is_empty());
    let ReadError::Mistakes {
        source_file,
        mistakes,
    } = error
    else {
        return Ok(());
    };
    prop_assert!(!mistakes.is_empty());
    for mistake in mistakes {
        let span = mistake.span.clone();
        prop_assert!(!mistake.message().is_empty(), "{mistake:?}");
        prop_assert!(source_file.text.get(span.clone()).is_some(), "{mistake:?}");
        let (line, column) = mistake.line_and_column(&source_file.text);
        let before = &source_file.text[..span.start];
        prop_assert_eq!(line, before.split('\n').count());
        prop_assert!(column >= 1);
    }
    Ok(())
}

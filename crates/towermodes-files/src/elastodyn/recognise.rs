//! Which of the files of OpenFAST a text is, by the names on its lines.

use super::names::name_on;
use crate::records::{Line, Lines};

/// Names stand among the first lines of every file.
const LOOKED_AT: usize = 400;

/// Whether it is a main file of ElastoDyn, or of FAST 7, which is refused with a reason.
pub(crate) fn is_main_file(text: &str) -> bool {
    has_all(text, &["twrfile", "numbl", "tiprad"])
}

/// Whether it is a tower file of ElastoDyn or FAST 7.
pub(crate) fn is_tower_file(text: &str) -> bool {
    let first: Vec<Line<'_>> = Lines::new(text).take(12).collect();
    first
        .iter()
        .any(|line| name_on(line).as_deref() == Some("ntwinpst"))
}

/// Whether it is a blade file of ElastoDyn or FAST 7.
pub(super) fn is_blade_file(text: &str) -> bool {
    let first: Vec<Line<'_>> = Lines::new(text).take(12).collect();
    first
        .iter()
        .any(|line| name_on(line).as_deref() == Some("nblinpst"))
}

/// Whether it is the `.fst` file that names the files of all modules of OpenFAST.
pub(crate) fn is_fst(text: &str) -> bool {
    has_all(text, &["edfile"])
}

/// The line of a file that has a name.
pub(super) fn line_of<'a>(text: &'a str, name: &str) -> Option<Line<'a>> {
    let mut lines = Lines::new(text).take(LOOKED_AT);
    lines.find(|line| name_on(line).as_deref() == Some(name))
}

fn has_all(text: &str, names: &[&str]) -> bool {
    names.iter().all(|name| line_of(text, name).is_some())
}

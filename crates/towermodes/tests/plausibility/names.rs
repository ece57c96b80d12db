//! Names that could make a line on a terminal read as another.

use super::towers::reference;
use towermodes::{Tower, is_printable};

#[test]
fn names_have_no_marks_that_turn_the_writing() {
    let mut description = reference();
    description.name = "Ge\u{202e}WM 5\u{2066}\u{1b}[31m\u{200f}\u{2028}Grüße ✓".into();
    let tower = Tower::new(description).expect("a tower");
    assert_eq!(tower.name(), "Ge WM 5  [31m  Grüße ✓");
    assert!(tower.name().chars().all(is_printable));
}

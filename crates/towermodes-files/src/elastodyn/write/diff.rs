//! The difference of two texts in the format that the program `patch` reads.

use std::ops::Range;

/// Unchanged lines shown around a change.
const CONTEXT: usize = 3;

/// A block of lines that differs in the new text.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Change {
    old: Range<usize>,
    new: Range<usize>,
}

/// The unified difference of two texts; empty if they are the same.
///
/// Made for texts whose lines changed in place: if the numbers of lines differ, everything between
/// the first and the last change is one change. Line ends are shown as they are.
pub fn unified_diff(old_name: &str, new_name: &str, old: &str, new: &str) -> String {
    let old: Vec<&str> = old.split_inclusive('\n').collect();
    let new: Vec<&str> = new.split_inclusive('\n').collect();
    let changes = changes(&old, &new);
    if changes.is_empty() {
        return String::new();
    }
    let mut diff = format!("--- {}\n+++ {}\n", one_line(old_name), one_line(new_name));
    let near = |a: &Change, b: &Change| b.old.start - a.old.end <= 2 * CONTEXT;
    for hunk in changes.chunk_by(near) {
        write_hunk(hunk, &old, &new, &mut diff);
    }
    diff
}

fn changes(old: &[&str], new: &[&str]) -> Vec<Change> {
    if old.len() == new.len() {
        return changed_in_place(old, new);
    }
    let same = |(a, b): &(&&str, &&str)| a == b;
    let head = old.iter().zip(new).take_while(same).count();
    let (old_rest, new_rest) = (&old[head..], &new[head..]);
    let pairs = old_rest.iter().rev().zip(new_rest.iter().rev());
    let tail = pairs.take_while(same).count();
    vec![Change {
        old: head..old.len() - tail,
        new: head..new.len() - tail,
    }]
}

fn changed_in_place(old: &[&str], new: &[&str]) -> Vec<Change> {
    let mut changes: Vec<Change> = Vec::new();
    for line in (0..old.len()).filter(|&line| old[line] != new[line]) {
        match changes.last_mut().filter(|last| last.old.end == line) {
            Some(last) => (last.old.end, last.new.end) = (line + 1, line + 1),
            None => changes.push(Change {
                old: line..line + 1,
                new: line..line + 1,
            }),
        }
    }
    changes
}

fn write_hunk(hunk: &[Change], old: &[&str], new: &[&str], diff: &mut String) {
    let (Some(first), Some(last)) = (hunk.first(), hunk.last()) else {
        return;
    };
    let before = first.old.start.min(CONTEXT);
    let after = (old.len() - last.old.end).min(CONTEXT);
    let old_lines = first.old.start - before..last.old.end + after;
    let new_lines = first.new.start - before..last.new.end + after;
    let (from, to) = (position(&old_lines), position(&new_lines));
    diff.push_str(&format!("@@ -{from} +{to} @@\n"));
    let mut next = old_lines.start;
    for change in hunk {
        write_lines(' ', &old[next..change.old.start], diff);
        write_lines('-', &old[change.old.clone()], diff);
        write_lines('+', &new[change.new.clone()], diff);
        next = change.old.end;
    }
    write_lines(' ', &old[next..old_lines.end], diff);
}

/// The first line, from 1, and the number of lines; for no lines the line before them.
fn position(lines: &Range<usize>) -> String {
    let first = lines.start + usize::from(!lines.is_empty());
    format!("{first},{}", lines.len())
}

fn write_lines(sign: char, lines: &[&str], diff: &mut String) {
    for line in lines {
        diff.push(sign);
        diff.push_str(line);
        if !line.ends_with('\n') {
            diff.push_str("\n\\ No newline at end of file\n");
        }
    }
}

fn one_line(name: &str) -> String {
    let plain = |c: char| if c.is_control() { '?' } else { c };
    name.chars().map(plain).collect()
}

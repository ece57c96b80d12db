//! The sets and subsets of a structural file of HAWC2, with their places.

use std::collections::HashSet;
use std::ops::Range;

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::records::{Line, Lines, Token};

/// Largest number of subsets: real files have only a few.
const MAX_SUBSETS: usize = 1000;

/// A set: the lines after a line `#1 name`.
#[derive(Debug)]
pub(super) struct Set<'a> {
    /// Its number.
    pub(super) number: usize,
    /// The rest of its line.
    pub(super) name: &'a str,
    /// The bytes of its line.
    pub(super) span: Range<usize>,
}

/// A subset: a line `$1 20 name` and the rows after it.
#[derive(Debug)]
pub(super) struct Subset<'a> {
    /// The number of its set.
    pub(super) set: usize,
    /// Its number.
    pub(super) number: usize,
    /// The number of rows that its line announces; memory must not be allocated according to it.
    pub(super) announced: usize,
    /// The rest of its line.
    pub(super) name: &'a str,
    /// The bytes of its line.
    pub(super) span: Range<usize>,
    /// The lines after its line, to the end of the file.
    pub(super) after: Lines<'a>,
}

impl Subset<'_> {
    /// Its name in messages: `set 1, subset 2`.
    pub(super) fn label(&self) -> String {
        format!("set {}, subset {}", self.set, self.number)
    }
}

/// All sets and subsets of a file, in its order.
#[derive(Debug, Default)]
pub(super) struct Layout<'a> {
    pub(super) sets: Vec<Set<'a>>,
    pub(super) subsets: Vec<Subset<'a>>,
}

impl<'a> Layout<'a> {
    /// Finds the headers; rows are not read.
    pub(super) fn of(text: &'a str) -> Result<Self, Diagnostic> {
        let mut layout = Self::default();
        let mut numbers = HashSet::new();
        let mut lines = Lines::new(text);
        while let Some(line) = lines.next() {
            if let Some(set) = set_of(&line) {
                layout.sets.push(set);
            } else if line.text.trim_start().starts_with('$') {
                let subset = layout.subset(&line, lines.clone())?;
                if !numbers.insert((subset.set, subset.number)) {
                    return Err(repeated(&subset));
                }
                layout.subsets.push(subset);
            }
            let found = layout.sets.len().max(layout.subsets.len());
            if found > MAX_SUBSETS {
                let (what, limit) = ("sets or subsets".to_owned(), MAX_SUBSETS);
                let kind = DiagnosticKind::TooMany { what, found, limit };
                return Err(Diagnostic::new(line.span(), kind));
            }
        }
        if layout.subsets.is_empty() {
            let what = "a line `$1 n` (subset 1 with n rows)";
            return Err(lines.ended(what));
        }
        Ok(layout)
    }

    /// The subset that a line `$1 20 name` begins.
    fn subset(&self, line: &Line<'a>, after: Lines<'a>) -> Result<Subset<'a>, Diagnostic> {
        let set = self.sets.last().ok_or_else(|| {
            let kind = DiagnosticKind::misplaced("a set", "a subset");
            Diagnostic::new(line.span(), kind).with_hint("a set begins with a line `#1 name`")
        })?;
        let hint = "a subset begins with `$1 20 name`: its number and its number of rows";
        let mut tokens = header_tokens(line, '$');
        let mut count = |what: &str| {
            let found = header_count(tokens.next(), line, what);
            found.map_err(|mistake| mistake.with_hint(hint))
        };
        Ok(Subset {
            set: set.number,
            number: count("the number of the subset")?,
            announced: count("the number of rows of the subset")?,
            name: rest_after(line, '$', 2),
            span: line.span(),
            after,
        })
    }

    /// The requested (set, subset), otherwise the first.
    pub(super) fn choose(
        &self,
        requested: Option<(usize, usize)>,
    ) -> Result<&Subset<'a>, Diagnostic> {
        let Some((set, number)) = requested else {
            // There is one: a layout without subsets is refused.
            return Ok(&self.subsets[0]);
        };
        let mut subsets = self.subsets.iter();
        subsets
            .find(|subset| (subset.set, subset.number) == (set, number))
            .ok_or_else(|| {
                let listed = self.subsets.iter().take(12).map(Subset::label);
                let there: Vec<String> = listed.collect();
                let more = if self.subsets.len() > 12 { "; …" } else { "" };
                let what = format!("set {set}, subset {number}");
                let span = self.sets.first().map_or(0..0, |set| set.span.clone());
                Diagnostic::new(span, DiagnosticKind::Missing { what })
                    .with_hint(format!("the file has {}{more}", there.join("; ")))
            })
    }

    /// The name of the set of a subset; may be empty.
    pub(super) fn name_of(&self, subset: &Subset<'_>) -> &'a str {
        let mut sets = self.sets.iter().rev();
        sets.find(|set| set.span.start < subset.span.start)
            .map_or("", |set| set.name)
    }
}

fn repeated(subset: &Subset<'_>) -> Diagnostic {
    let (what, times) = (subset.label(), 2);
    let kind = DiagnosticKind::Repeated { what, times };
    Diagnostic::new(subset.span.clone(), kind).with_hint("give each subset of a set its own number")
}

/// The set that a line `#1 name` begins; a `#` without a number is a comment.
fn set_of<'a>(line: &Line<'a>) -> Option<Set<'a>> {
    if !line.text.trim_start().starts_with('#') {
        return None;
    }
    let number = header_tokens(line, '#').next()?.text.parse().ok()?;
    Some(Set {
        number,
        name: rest_after(line, '#', 1),
        span: line.span(),
    })
}

/// A count in a header, at least 1.
fn header_count(
    token: Option<Token<'_>>,
    line: &Line<'_>,
    what: &str,
) -> Result<usize, Diagnostic> {
    let Some(token) = token else {
        let (end, what) = (line.span().end, what.to_owned());
        return Err(Diagnostic::new(end..end, DiagnosticKind::Missing { what }));
    };
    let value = token.integer(what)?;
    let count = usize::try_from(value).ok().filter(|count| *count > 0);
    count.ok_or_else(|| {
        token.wrong(DiagnosticKind::out_of_range(
            what,
            value as f64,
            "at least 1",
        ))
    })
}

/// The values of a header after its sign.
fn header_tokens<'a>(line: &Line<'a>, sign: char) -> impl Iterator<Item = Token<'a>> + use<'a> {
    after_sign(line, sign).tokens()
}

/// A header after its sign.
fn after_sign<'a>(line: &Line<'a>, sign: char) -> Line<'a> {
    let rest = line.text.trim_start().trim_start_matches(sign);
    Line {
        text: rest,
        start: line.start + (line.text.len() - rest.len()),
    }
}

/// The text after the first `values` values of a header.
fn rest_after<'a>(line: &Line<'a>, sign: char, values: usize) -> &'a str {
    let rest = after_sign(line, sign);
    let last = rest.tokens().take(values).last();
    let from = last.map_or(0, |token| token.span.end - rest.start);
    rest.text.get(from..).unwrap_or_default().trim()
}

/// Whether a text has the header of a set, and after it one of a subset.
pub(super) fn headers(text: &str) -> (bool, bool) {
    let mut has_set = false;
    for line in Lines::new(text) {
        has_set = has_set || set_of(&line).is_some();
        let begins = has_set && line.text.trim_start().starts_with('$');
        let is_count = |token: &Token<'_>| token.integer("").is_ok();
        if begins && header_tokens(&line, '$').take(2).filter(is_count).count() == 2 {
            return (true, true);
        }
    }
    (has_set, false)
}

#[cfg(test)]
mod tests {
    use super::Layout;

    #[test]
    fn sets_and_subsets_are_found_with_their_names() {
        let text =
            "2 sets\n#1 Tower, made by hand\nr m\n$1 2 Flexible\n0 1\n1 1\n$2 2\n#2\n$1 3 x\n";
        let layout = Layout::of(text).expect("a layout");
        let labels: Vec<String> = layout.subsets.iter().map(super::Subset::label).collect();
        assert_eq!(
            labels,
            ["set 1, subset 1", "set 1, subset 2", "set 2, subset 1"]
        );
        assert_eq!(layout.sets[0].name, "Tower, made by hand");
        assert_eq!(layout.subsets[0].name, "Flexible");
        assert_eq!(layout.subsets[2].announced, 3);
        assert_eq!(layout.name_of(&layout.subsets[2]), "");
        assert_eq!(layout.choose(Some((2, 1))).expect("there").announced, 3);
    }
}

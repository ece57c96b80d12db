//! Skips the tables of airfoils before parsing: they are half of a file, and a tower does not need
//! them.

use std::borrow::Cow;

/// The text with the list under `airfoils:` replaced by blanks, so that all other text keeps its
/// position.
///
/// The text is unchanged if the value is possibly not a list, or if another part of the file may
/// refer to an anchor in it.
pub(crate) fn without_airfoils(text: &str) -> Cow<'_, str> {
    let Some(range) = section(text) else {
        return Cow::Borrowed(text);
    };
    let list = &text[range.clone()];
    let is_list = list.trim_start().starts_with("- ");
    let is_tied = list.contains(['&', '*']) || list.contains("\n---") || list.contains("\n...");
    if !is_list || is_tied {
        return Cow::Borrowed(text);
    }
    let mut blank = String::with_capacity(text.len());
    blank.push_str(&text[..range.start]);
    blank.extend(list.bytes().map(|b| if b == b'\n' { '\n' } else { ' ' }));
    blank.push_str(&text[range.end..]);
    Cow::Owned(blank)
}

/// The text from the line `airfoils:` to the next key without indentation.
fn section(text: &str) -> Option<std::ops::Range<usize>> {
    let key = "\nairfoils:";
    let start = text.find(key)? + key.len();
    let rest = &text[start..];
    let first = rest.find('\n')?;
    if !rest[..first].trim().is_empty() {
        return None;
    }
    let is_key = |at: &usize| {
        let next = rest.as_bytes().get(at + 1);
        next.is_some_and(|b| !b" -#\r\n\t".contains(b))
    };
    let mut ends = rest.match_indices('\n').map(|(at, _)| at);
    let end = ends.find(is_key).unwrap_or(rest.len());
    Some(start + first..start + end)
}

#[cfg(test)]
mod tests {
    use super::without_airfoils;

    #[test]
    fn all_else_stays_where_it_is() {
        let text = "a: 1\nairfoils:\n   - name: \u{e4}\n# x\n   - polars: [1,\n     2]\nb: 2\n";
        let blank = without_airfoils(text);
        assert_eq!(blank.len(), text.len());
        assert_eq!(blank.find("b: 2"), text.find("b: 2"));
        assert_eq!(blank.matches('\n').count(), text.matches('\n').count());
        assert!(!blank.contains("polars"));
        let last = "a: 1\nairfoils:\n- x: 1\n";
        assert_eq!(without_airfoils(last).trim(), "a: 1\nairfoils:");
    }

    #[test]
    fn what_is_no_plain_list_is_left_alone() {
        let texts = [
            "a: 1\nairfoils: [1]\nb: 2\n",
            "a: 1\nairfoils:\n   - &x 1\nb: *x\n",
            "a: 1\nairfoils:\n  x: 1\nb: 2\n",
            "a: 1\nairfoils:",
            "a: 1\n",
        ];
        for text in texts {
            assert_eq!(without_airfoils(text), text);
        }
    }
}

//! A page taken apart: its elements, as far as tests need them.

/// A start or an end of an element, or a text between them.
#[derive(Debug, Clone, PartialEq)]
pub enum Piece<'a> {
    Start(&'a str, &'a str),
    End(&'a str),
    Text(&'a str),
}

/// Elements that hold nothing.
const EMPTY: [&str; 3] = ["meta", "input", "br"];

/// The pieces of a page; what scripts and styles hold is one text each.
pub fn pieces(page: &str) -> Vec<Piece<'_>> {
    let mut pieces = Vec::new();
    let mut rest = page.strip_prefix("<!DOCTYPE html>").expect("a doctype");
    while !rest.is_empty() {
        let raw = match pieces.last() {
            Some(Piece::Start(name @ ("script" | "style"), _)) => Some(format!("</{name}>")),
            _ => None,
        };
        let end = match raw {
            Some(end) => rest.find(&end).expect("its end"),
            None => rest.find('<').unwrap_or(rest.len()),
        };
        let (text, tag) = rest.split_at(end);
        if !text.is_empty() || matches!(pieces.last(), Some(Piece::Start("script" | "style", _))) {
            pieces.push(Piece::Text(text));
        }
        let Some(end) = tag.find('>') else { break };
        let inside = &tag[1..end];
        rest = &tag[end + 1..];
        if let Some(name) = inside.strip_prefix('/') {
            pieces.push(Piece::End(name));
            continue;
        }
        let closed = inside.ends_with('/');
        let inside = inside.trim_end_matches('/');
        let (name, attributes) = inside.split_once([' ', '\n']).unwrap_or((inside, ""));
        pieces.push(Piece::Start(name, attributes));
        if closed || EMPTY.contains(&name) {
            pieces.push(Piece::End(name));
        }
    }
    pieces
}

/// The value of an attribute.
pub fn attribute<'a>(attributes: &'a str, name: &str) -> Option<&'a str> {
    let start = format!("{name}=\"");
    let mut places = attributes.match_indices(&start);
    let (at, _) = places.find(|(at, _)| *at == 0 || attributes.as_bytes()[at - 1] == b' ')?;
    let value = &attributes[at + start.len()..];
    value.find('"').map(|end| &value[..end])
}

/// All that a reader reads: texts, with what was escaped as it was meant.
pub fn read(page: &str) -> String {
    let mut text = String::new();
    let pieces = pieces(page);
    for (index, piece) in pieces.iter().enumerate() {
        let is_raw = index > 0 && matches!(pieces[index - 1], Piece::Start("script" | "style", _));
        if let (Piece::Text(part), false) = (piece, is_raw) {
            text.push_str(part);
        }
    }
    let entities = [
        ("&lt;", "<"),
        ("&gt;", ">"),
        ("&quot;", "\""),
        ("&#x27;", "'"),
        ("&#39;", "'"),
        ("&#x2f;", "/"),
        ("&amp;", "&"),
    ];
    entities
        .into_iter()
        .fold(text, |text, (from, to)| text.replace(from, to))
}

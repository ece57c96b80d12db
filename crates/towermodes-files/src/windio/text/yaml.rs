//! YAML as a tree of values with their places.

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use granit_parser::{Event, Options, Parser, ScalarStyle, Span, Tag};

use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// A value and its byte range in the file; for a list or a map, where it begins. The place of an
/// alias is that of its definition.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Node {
    pub(crate) value: Value,
    pub(crate) span: Range<usize>,
}

/// The content of a value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    Null,
    Bool(bool),
    Number(f64),
    Text(String),
    List(Vec<Node>),
    Map(Vec<(String, Node)>),
}

/// Largest number of values, lists and maps, with aliases expanded. A small file with aliases of
/// aliases would otherwise become a large tree.
const MOST_NODES: usize = 1_000_000;
/// Largest depth of nesting.
const MOST_DEPTH: usize = 64;
/// The key whose maps are merged into the map that contains it.
const MERGE: &str = "<<";

/// Reads a text as YAML; null if it contains no document.
///
/// # Errors
/// [`DiagnosticKind::Syntax`].
pub(crate) fn parse(text: &str) -> Result<Node, Diagnostic> {
    let mut tree = Tree::default();
    for event in Parser::new_from_str_with_options(text, Options::default()) {
        let (event, span) = event.map_err(|error| {
            let at = error.marker().byte_offset().unwrap_or(0);
            mistake(at..at, &error.info().to_string(), text)
        })?;
        let span = bytes(&span);
        let taken = tree.take(event, span.clone(), text);
        taken.map_err(|reason| mistake(span, &reason, text))?;
    }
    let empty = || Node {
        value: Value::Null,
        span: 0..0,
    };
    Ok(tree.root.unwrap_or_else(empty))
}

/// A tree that is not yet complete.
#[derive(Default)]
struct Tree {
    root: Option<Node>,
    /// The lists and maps that are not yet closed.
    open: Vec<Open>,
    /// The nodes with an anchor, and the number of nodes in each.
    anchors: HashMap<usize, (Node, usize)>,
    nodes: usize,
}

/// A list or a map that is not yet closed.
struct Open {
    node: Node,
    anchor: usize,
    /// The keys of a map that were read.
    keys: HashSet<String>,
    /// The key whose value has not been read.
    waiting: Option<String>,
}

impl Tree {
    fn take(&mut self, event: Event<'_>, span: Range<usize>, text: &str) -> Result<(), String> {
        let (value, anchor) = match event {
            Event::Scalar(value, style, anchor, tag) => {
                (scalar(&value, style, tag.as_deref())?, anchor)
            }
            Event::SequenceStart(_, anchor, _) => {
                return self.begin(Value::List(Vec::new()), span, anchor);
            }
            Event::MappingStart(_, anchor, _) => {
                return self.begin(Value::Map(Vec::new()), span, anchor);
            }
            Event::SequenceEnd | Event::MappingEnd => {
                let Some(open) = self.open.pop() else {
                    return Ok(());
                };
                return self.place(merged(open.node, open.keys)?, open.anchor, text);
            }
            Event::Alias(anchor) => {
                let defined = self.anchors.get(&anchor);
                let (node, nodes) = defined.ok_or("an alias is used inside its own definition")?;
                self.nodes += nodes;
                let node = node.clone();
                return self.place(node, 0, text);
            }
            Event::DocumentStart(..) if self.root.is_some() => {
                return Err("the file has several documents".to_owned());
            }
            _ => return Ok(()),
        };
        self.place(Node { value, span }, anchor, text)
    }

    fn begin(&mut self, value: Value, span: Range<usize>, anchor: usize) -> Result<(), String> {
        if self.open.len() == MOST_DEPTH {
            return Err(TOO_LARGE.to_owned());
        }
        self.open.push(Open {
            node: Node { value, span },
            anchor,
            keys: HashSet::new(),
            waiting: None,
        });
        Ok(())
    }

    /// Adds a complete node to its parent. The copy of a node with an anchor counts too.
    fn place(&mut self, node: Node, anchor: usize, text: &str) -> Result<(), String> {
        self.nodes += 1;
        if anchor != 0 {
            let nodes = node.count();
            self.nodes += nodes;
            self.anchors.insert(anchor, (node.clone(), nodes));
        }
        if self.nodes > MOST_NODES {
            return Err(TOO_LARGE.to_owned());
        }
        let Some(open) = self.open.last_mut() else {
            self.root = Some(node);
            return Ok(());
        };
        match (&mut open.node.value, open.waiting.take()) {
            (Value::Map(entries), Some(key)) => entries.push((key, node)),
            (Value::Map(_), None) => {
                let key = node.key(text)?;
                if !open.keys.insert(key.clone()) && key != MERGE {
                    return Err(format!("the key `{key}` occurs twice in the same map"));
                }
                open.waiting = Some(key);
            }
            (Value::List(list), _) => list.push(node),
            _ => {}
        }
        Ok(())
    }
}

const TOO_LARGE: &str = "it is larger or more deeply nested than any turbine";

impl Node {
    /// The number of nodes in it, including itself.
    fn count(&self) -> usize {
        1 + match &self.value {
            Value::List(list) => list.iter().map(Self::count).sum(),
            Value::Map(entries) => entries.iter().map(|(_, node)| node.count()).sum(),
            _ => 0,
        }
    }

    /// The node as a key, as written.
    fn key(self, text: &str) -> Result<String, String> {
        match self.value {
            Value::Text(key) => Ok(key),
            Value::List(_) | Value::Map(_) => Err("a key is a list or a map".to_owned()),
            _ => Ok(text.get(self.span).unwrap_or_default().to_owned()),
        }
    }
}

/// A map with the entries of the maps under `<<` whose keys it does not contain itself.
fn merged(mut node: Node, mut keys: HashSet<String>) -> Result<Node, String> {
    let Value::Map(entries) = &mut node.value else {
        return Ok(node);
    };
    if !keys.remove(MERGE) {
        return Ok(node);
    }
    for (key, node) in std::mem::take(entries) {
        if key != MERGE {
            entries.push((key, node));
            continue;
        }
        let maps = match node.value {
            Value::List(list) => list,
            _ => vec![node],
        };
        for map in maps {
            let Value::Map(others) = map.value else {
                return Err("the value of the key `<<` is not a map".to_owned());
            };
            entries.extend(
                others
                    .into_iter()
                    .filter(|(key, _)| keys.insert(key.clone())),
            );
        }
    }
    Ok(node)
}

/// The value of a scalar by the core schema of YAML 1.2: text if it is quoted or has a tag for
/// text.
fn scalar(text: &str, style: ScalarStyle, tag: Option<&Tag>) -> Result<Value, String> {
    let tag = tag.and_then(Tag::core_suffix);
    let is_plain = style == ScalarStyle::Plain;
    let wrong = |what: &str| format!("`{text}` is not {what}, as its tag says");
    match tag {
        Some("str") => return Ok(Value::Text(text.to_owned())),
        Some("null") => return Ok(Value::Null),
        Some("int" | "float") => {
            return number(text)
                .map(Value::Number)
                .ok_or_else(|| wrong("a number"));
        }
        Some("bool") => return truth(text).ok_or_else(|| wrong("true or false")),
        _ if !is_plain => return Ok(Value::Text(text.to_owned())),
        _ => {}
    }
    Ok(match text {
        "" | "~" | "null" | "Null" | "NULL" => Value::Null,
        _ => {
            let number = || number(text).map(Value::Number);
            let value = truth(text).or_else(number);
            value.unwrap_or_else(|| Value::Text(text.to_owned()))
        }
    })
}

fn truth(text: &str) -> Option<Value> {
    match text {
        "true" | "True" | "TRUE" => Some(Value::Bool(true)),
        "false" | "False" | "FALSE" => Some(Value::Bool(false)),
        _ => None,
    }
}

/// A number: digits with point and exponent, `0x` and `0o`, `.inf` and `.nan`.
fn number(text: &str) -> Option<f64> {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let sign = if text.starts_with('-') { -1.0 } else { 1.0 };
    let of_radix =
        |digits: &str, radix| Some(sign * u64::from_str_radix(digits, radix).ok()? as f64);
    match unsigned {
        ".inf" | ".Inf" | ".INF" => return Some(sign * f64::INFINITY),
        ".nan" | ".NaN" | ".NAN" => return Some(f64::NAN),
        _ => {}
    }
    if let Some(digits) = unsigned.strip_prefix("0x") {
        return of_radix(digits, 16);
    }
    if let Some(digits) = unsigned.strip_prefix("0o") {
        return of_radix(digits, 8);
    }
    let begins = unsigned.strip_prefix('.').unwrap_or(unsigned);
    let is_number = begins.starts_with(|c: char| c.is_ascii_digit());
    is_number.then(|| text.parse().ok())?
}

fn bytes(span: &Span) -> Range<usize> {
    span.byte_range().unwrap_or(0..0)
}

fn mistake(span: Range<usize>, reason: &str, text: &str) -> Diagnostic {
    let span = span.start.min(text.len())..span.end.min(text.len());
    let (format, reason) = ("YAML", reason.to_owned());
    let diagnostic = Diagnostic::new(span, DiagnosticKind::Syntax { format, reason });
    if diagnostic.span.start >= text.trim_end().len() {
        return diagnostic.with_hint("the file ends here; is it complete?");
    }
    diagnostic
}

#[cfg(test)]
mod tests {
    use super::{Node, Value, parse};

    fn value(text: &str) -> Value {
        parse(text).expect(text).value
    }

    #[test]
    fn scalars_are_those_of_the_core_schema() {
        let numbers = [
            ("1", 1.0),
            ("-2.5e-3", -2.5e-3),
            ("1e9", 1e9),
            (".5", 0.5),
            ("+3.", 3.0),
            ("0x1F", 31.0),
            ("0o17", 15.0),
            ("-.inf", f64::NEG_INFINITY),
            ("!!float '4'", 4.0),
        ];
        for (text, number) in numbers {
            assert_eq!(value(text), Value::Number(number), "{text}");
        }
        for text in ["inf", "nan", "1.0.0", "'1'", "\"x\"", "!!str 1", "e5"] {
            assert!(matches!(value(text), Value::Text(_)), "{text}");
        }
        for text in ["~", "null", "", "# nothing"] {
            assert_eq!(value(text), Value::Null, "{text}");
        }
        assert_eq!(value("True"), Value::Bool(true));
    }

    #[test]
    fn merged_maps_give_the_keys_that_a_map_lacks() {
        let text = "a: &a {x: 1, y: 2}\nb: {<<: *a, x: 3}\nc: {<<: [{z: 4}, *a]}";
        let find = |path: &[&str]| parse(text).expect(text).find(path).map(|n| n.value.clone());
        assert_eq!(find(&["b", "x"]), Some(Value::Number(3.0)));
        assert_eq!(find(&["b", "y"]), Some(Value::Number(2.0)));
        assert_eq!(find(&["c", "z"]), Some(Value::Number(4.0)));
        assert_eq!(find(&["c", "x"]), Some(Value::Number(1.0)));
    }

    #[test]
    fn what_is_no_tree_is_refused_at_its_place() {
        let nested = "[".repeat(100) + &"]".repeat(100);
        let mut laughs = "l0: &l0 [x, x, x, x, x, x, x, x, x, x]\n".to_owned();
        for n in 1..9 {
            let again = vec![format!("*l{}", n - 1); 10].join(", ");
            laughs += &format!("l{n}: &l{n} [{again}]\n");
        }
        let anchored = (0..60).map(|n| format!("&n{n} [")).collect::<String>()
            + &"x, ".repeat(50_000)
            + &"]".repeat(60);
        let rows = [
            ("a: 1\nb: 2\na: 3\n", 10, "the key `a` occurs twice"),
            ("a: 1\n---\nb: 2\n", 5, "several documents"),
            ("{[1]: 2}", 0, "a key is a list"),
            ("a: *b", 3, ""),
            ("a: [1, 2", 3, "unclosed bracket"),
            ("x: !!int y", 9, "`y` is not a number"),
            (&nested, 64, "more deeply nested"),
            (&laughs, 0, "it is larger"),
            (&anchored, 0, "it is larger"),
        ];
        for (text, place, words) in rows {
            let mistake = parse(text).expect_err(text);
            assert!(mistake.to_string().contains(words), "{mistake}");
            assert!(
                place == 0 || mistake.span.start == place,
                "{mistake} {:?}",
                mistake.span
            );
        }
    }

    #[test]
    fn many_keys_cost_no_more_than_their_number() {
        let keys: String = (0..200_000).map(|n| format!("k{n}: 1\n")).collect();
        let text = format!("all: &all\n  x: 1\nagain:\n  <<: *all\n{keys}");
        assert!(matches!(value(&text), Value::Map(entries) if entries.len() == 200_002));
    }

    #[test]
    fn a_byte_order_mark_is_no_part_of_a_key() {
        let file = parse("\u{feff}a: 1").expect("a map");
        assert_eq!(
            file.find(&["a"]).map(|node| &node.value),
            Some(&Value::Number(1.0))
        );
    }

    #[test]
    fn places_are_bytes() {
        let text = "\u{e4}: {b: [10, 20]}";
        let list = parse(text).expect(text);
        let Some(Node {
            value: Value::List(list),
            ..
        }) = list.find(&["\u{e4}", "b"])
        else {
            panic!("a list");
        };
        assert_eq!(&text[list[1].span.clone()], "20");
    }
}

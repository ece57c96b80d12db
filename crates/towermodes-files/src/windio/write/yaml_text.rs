//! YAML as text: maps, lists of maps, numbers and lists of them.

use std::fmt::Write;

/// A value to be written.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Yaml {
    Number(f64),
    Count(usize),
    Numbers(Vec<f64>),
    Text(String),
    Map(Vec<(&'static str, Yaml)>),
    List(Vec<Yaml>),
}

impl Yaml {
    /// Values at positions along an axis.
    pub(super) fn curve(grid: Vec<f64>, values: Vec<f64>) -> Self {
        Self::Map(vec![
            ("grid", Self::Numbers(grid)),
            ("values", Self::Numbers(values)),
        ])
    }

    /// Zero along the whole axis.
    pub(super) fn zero() -> Self {
        Self::curve(vec![0.0, 1.0], vec![0.0, 0.0])
    }
}

/// The text of a map.
pub(super) fn text(entries: &[(&'static str, Yaml)]) -> String {
    let mut out = String::new();
    write_map(&mut out, entries, 0);
    out
}

fn write_map(out: &mut String, entries: &[(&'static str, Yaml)], indent: usize) {
    for (i, (key, value)) in entries.iter().enumerate() {
        // The first key of a map in a list stands behind its dash.
        if i > 0 || !out.ends_with("- ") {
            out.push_str(&" ".repeat(indent));
        }
        out.push_str(key);
        out.push(':');
        write_value(out, value, indent + 2);
    }
}

fn write_value(out: &mut String, value: &Yaml, indent: usize) {
    match value {
        Yaml::Number(value) => line(out, &number(*value)),
        Yaml::Count(count) => line(out, &count.to_string()),
        Yaml::Numbers(values) => {
            let values: Vec<String> = values.iter().map(|v| number(*v)).collect();
            line(out, &format!("[{}]", values.join(", ")));
        }
        Yaml::Text(text) => line(out, &quoted(text)),
        Yaml::Map(entries) if entries.is_empty() => line(out, "{}"),
        Yaml::Map(entries) => {
            out.push('\n');
            write_map(out, entries, indent);
        }
        Yaml::List(items) => {
            out.push('\n');
            for item in items {
                out.push_str(&" ".repeat(indent));
                out.push_str("- ");
                if let Yaml::Map(entries) = item {
                    write_map(out, entries, indent + 2);
                }
            }
        }
    }
}

/// The rest of the line of a key.
fn line(out: &mut String, value: &str) {
    out.push(' ');
    out.push_str(value);
    out.push('\n');
}

/// The shortest decimal form that is read back as the same number; always with a point and a signed
/// exponent, which older readers of YAML need.
fn number(value: f64) -> String {
    let text = format!("{value:?}");
    match text.split_once('e') {
        None => text,
        Some((digits, exponent)) => {
            let point = if digits.contains('.') { "" } else { ".0" };
            let sign = if exponent.starts_with('-') { "" } else { "+" };
            format!("{digits}{point}e{sign}{exponent}")
        }
    }
}

/// A text in double quotes; invisible characters are escaped.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => {
                out.push('\\');
                out.push(c);
            }
            _ if !towermodes::is_printable(c) || c == '\u{feff}' => {
                let _ = write!(out, "\\u{:04x}", u32::from(c));
            }
            _ => out.push(c),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_numbers_to_every_reader() {
        let texts = [0.1, -3.0, 2e11, 1e16, 1.5e-7, 1e300].map(number);
        let expected = [
            "0.1",
            "-3.0",
            "200000000000.0",
            "1.0e+16",
            "1.5e-7",
            "1.0e+300",
        ];
        assert_eq!(texts, expected);
    }

    #[test]
    fn maps_are_indented_and_lists_have_dashes() {
        let item = |name: &str| {
            Yaml::Map(vec![
                ("name", Yaml::Text(name.to_owned())),
                (
                    "of",
                    Yaml::Map(vec![("grid", Yaml::Numbers(vec![0.0, 1.0]))]),
                ),
            ])
        };
        let all = [
            ("empty", Yaml::Map(Vec::new())),
            ("list", Yaml::List(vec![item("a \"b\"\n"), item("c")])),
        ];
        let expected = concat!(
            "empty: {}\n",
            "list:\n",
            "  - name: \"a \\\"b\\\"\\u000a\"\n",
            "    of:\n",
            "      grid: [0.0, 1.0]\n",
            "  - name: \"c\"\n",
            "    of:\n",
            "      grid: [0.0, 1.0]\n",
        );
        assert_eq!(text(&all), expected);
    }
}

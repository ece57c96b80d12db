//! Numbers and texts as TOML.

/// The shortest decimal form that is read back as the same number.
pub(in crate::toml) fn number(value: f64) -> String {
    let size = value.abs();
    if value.is_nan() {
        "nan".into()
    } else if value.is_infinite() || size == 0.0 || (1e-3..1e7).contains(&size) {
        format!("{value:?}")
    } else {
        format!("{value:e}")
    }
}

/// A basic string: quotes, backslashes and all invisible characters are escaped.
pub(super) fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            '\n' => quoted.push_str("\\n"),
            '\t' => quoted.push_str("\\t"),
            c if !towermodes::is_printable(c) => {
                quoted.push_str(&format!("\\u{:04X}", u32::from(c)));
            }
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

/// `[x, y, z]`.
pub(super) fn triple(values: [f64; 3]) -> String {
    format!("[{}]", values.map(number).join(", "))
}

#[cfg(test)]
mod tests {
    use super::{number, quoted};

    #[test]
    fn numbers_are_short_and_exact() {
        let written = [87.6, 350e3, 2.1e11, 0.0, -0.0, 5e-324, 1e-9, f64::INFINITY].map(number);
        let expected = [
            "87.6", "350000.0", "2.1e11", "0.0", "-0.0", "5e-324", "1e-9", "inf",
        ];
        assert_eq!(written, expected);
        assert_eq!(number(0.1 + 0.2), "0.30000000000000004");
        assert_eq!(
            (number(f64::NAN), number(f64::NEG_INFINITY)),
            ("nan".into(), "-inf".into())
        );
    }

    #[test]
    fn texts_are_escaped() {
        assert_eq!(
            quoted("a\"b\\c\nd\te\u{7f}\u{0}\r"),
            r#""a\"b\\c\nd\te\u007F\u0000\u000D""#
        );
        assert_eq!(quoted("Turm Süd, 87 m ✓"), "\"Turm Süd, 87 m ✓\"");
    }
}

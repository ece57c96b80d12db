//! Structs with some fields set by a test case.

/// A struct with these fields; the others have their defaults: `with!(Options, method, modes = 4)`.
#[macro_export]
macro_rules! with {
    (@ $field:ident) => { $field };
    (@ $field:ident = $value:expr) => { $value };
    ($of:ident, $($field:ident $(= $value:expr)?),+ $(,)?) => {
        $of { $($field: $crate::with!(@ $field $(= $value)?),)+ ..$of::default() }
    };
}

/// A value with changed fields: `changed!(tower(), foundation, gravity_m_per_s2 = 9.81)`.
#[macro_export]
macro_rules! changed {
    (@ $field:ident) => { $field };
    (@ $field:ident = $value:expr) => { $value };
    ($base:expr, $($field:ident $(= $value:expr)?),+ $(,)?) => {{
        let mut changed = $base;
        $(changed.$field = $crate::changed!(@ $field $(= $value)?);)+
        changed
    }};
}

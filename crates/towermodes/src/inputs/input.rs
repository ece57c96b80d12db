//! The description of one value of the tower file.

use super::{Given, Limit, Nature, Quantity};

/// The description of one value of the tower file. Constant functions make it, beside the field
/// that contains the value.
#[derive(Debug)]
pub struct Input {
    /// Its key in the tower file.
    pub key: &'static str,
    /// Its name in messages: "the diameter of the caisson".
    pub name: &'static str,
    /// Its unit after a space; empty for none.
    pub spaced_unit: &'static str,
    /// More about it in the comment of a written file and in the schema; may be empty.
    pub note: &'static str,
    /// The hint for a file without the key; if empty, name and unit are shown.
    pub hint: &'static str,
    /// Other names of the key, in other programs and on drawings, separated by blanks.
    pub synonyms: &'static str,
    /// What is used if the key is absent: "the lowest station"; may be empty.
    pub otherwise: &'static str,
    /// The limits of its values.
    pub limit: Limit,
    /// The hint for a value outside the limits; may be empty.
    pub remedy: &'static str,
    /// The value if the key is absent; NaN if the key must be given.
    pub default: f64,
    /// Whether the key must be given.
    pub is_required: bool,
    /// Whether written files omit it if it has its default value.
    pub is_quiet: bool,
    /// Whether infinity may be given, for what is rigid or endless.
    pub may_be_infinite: bool,
    /// Whether it is proportional to the stiffness of the soil.
    pub is_of_soil: bool,
    /// The usual range of towers.
    pub usual: Option<(Quantity, [f64; 2])>,
    /// The symbol, the factor to the unit and the unit for a short list of values; if none, the
    /// list shows its name.
    pub symbol: Option<(&'static str, f64, &'static str)>,
    /// Another key; if this is given, the value has no effect.
    pub yields_to: Option<&'static str>,
    /// Another key, without which the value has no effect, and the remedy.
    pub needs: Option<(&'static str, &'static str)>,
}

impl Input {
    /// A value of any type; its unit is written after a space.
    pub const fn new(
        key: &'static str,
        spaced_unit: &'static str,
        limit: Limit,
        name: &'static str,
    ) -> Self {
        Self {
            key,
            name,
            spaced_unit,
            note: "",
            hint: "",
            synonyms: "",
            otherwise: "",
            limit,
            remedy: "",
            default: f64::NAN,
            is_required: true,
            is_quiet: false,
            may_be_infinite: false,
            is_of_soil: false,
            usual: None,
            symbol: None,
            yields_to: None,
            needs: None,
        }
    }

    /// A length in m.
    pub const fn length(key: &'static str, name: &'static str) -> Self {
        Self::new(key, " m", Limit::Length, name)
    }

    /// A height in the datum of the stations, m.
    pub const fn height(key: &'static str, name: &'static str) -> Self {
        Self::new(key, " m", Limit::Height, name)
    }

    /// One of several names.
    pub const fn choice(key: &'static str, name: &'static str) -> Self {
        Self::new(key, "", Limit::Elsewhere, name)
    }

    /// Yes or no; no if it is left out.
    pub const fn flag(key: &'static str, name: &'static str) -> Self {
        Self::new(key, "", Limit::Elsewhere, name).optional()
    }

    /// The number where the key is left out; infinity may be given if it is infinite.
    #[must_use]
    pub const fn or(mut self, default: f64) -> Self {
        self.default = default;
        self.may_be_infinite |= default == f64::INFINITY;
        self.optional()
    }

    /// The key may be omitted.
    #[must_use]
    pub const fn optional(mut self) -> Self {
        self.is_required = false;
        self
    }

    /// Written files omit it if it has its default value.
    #[must_use]
    pub const fn quiet(mut self) -> Self {
        self.is_quiet = true;
        self
    }

    /// Infinity may be given.
    #[must_use]
    pub const fn or_infinite(mut self) -> Self {
        self.may_be_infinite = true;
        self
    }

    /// The value is proportional to the stiffness of the soil.
    #[must_use]
    pub const fn of_soil(mut self) -> Self {
        self.is_of_soil = true;
        self
    }

    /// More about it in the comment of a written file and in the schema.
    #[must_use]
    pub const fn note(mut self, note: &'static str) -> Self {
        self.note = note;
        self
    }

    /// The hint for a file without the key.
    #[must_use]
    pub const fn hint(mut self, hint: &'static str) -> Self {
        self.hint = hint;
        self
    }

    /// The hint for a value outside the limits.
    #[must_use]
    pub const fn remedy(mut self, remedy: &'static str) -> Self {
        self.remedy = remedy;
        self
    }

    /// Other names of the key, separated by blanks.
    #[must_use]
    pub const fn also(mut self, synonyms: &'static str) -> Self {
        self.synonyms = synonyms;
        self
    }

    /// What is used if the key is absent.
    #[must_use]
    pub const fn otherwise(mut self, otherwise: &'static str) -> Self {
        self.otherwise = otherwise;
        self.optional()
    }

    /// The usual range of towers; typical values, and the likely reason of one outside the range.
    #[must_use]
    pub const fn usual(self, range: [f64; 2], likely_slip: &'static str) -> Self {
        let (name, unit) = (self.name, self.spaced_unit);
        let quantity = Quantity::Value {
            name,
            unit,
            likely_slip,
        };
        self.usual_of(quantity, range)
    }

    /// The usual range of a quantity that is common to several values.
    #[must_use]
    pub const fn usual_of(mut self, quantity: Quantity, range: [f64; 2]) -> Self {
        self.usual = Some((quantity, range));
        self
    }

    /// Its symbol in a short list of values, and the factor to the unit that it has there.
    #[must_use]
    pub const fn symbol(mut self, symbol: &'static str, factor: f64, unit: &'static str) -> Self {
        self.symbol = Some((symbol, factor, unit));
        self
    }

    /// It has no effect where another key is absent; `remedy` is what to do then. A tower with such
    /// a value has a warning.
    #[must_use]
    pub const fn needs(mut self, key: &'static str, remedy: &'static str) -> Self {
        self.needs = Some((key, remedy));
        self
    }

    /// It has no effect if another key is given.
    #[must_use]
    pub const fn yields_to(mut self, key: &'static str) -> Self {
        self.yields_to = Some(key);
        self
    }

    /// Whether a value is equal to the default of an omitted key. The first of several names is the
    /// default of a choice that is always there.
    pub fn is_default(&self, given: Given) -> bool {
        match given {
            Given::Number(value) => value == self.default,
            Given::Triple(triple) => triple == [self.default; 3],
            Given::Flag(flag) => !flag,
            Given::Name(place, _) => place.unwrap_or(0) == 0,
            Given::Optional(None) | Given::Pair(None) => true,
            Given::Optional(Some(_)) | Given::Pair(Some(_)) | Given::Count(_) => false,
        }
    }

    /// The key of the table of the tower file that it stands in: its own, or that of a table in the
    /// table, such as `inertia` of `inertia.xx`.
    pub fn outer_key(&self) -> &'static str {
        self.key
            .split_once('.')
            .map_or(self.key, |(outer, _)| outer)
    }

    /// Its unit, without the leading space.
    pub fn unit(&self) -> &'static str {
        self.spaced_unit.trim_start()
    }

    /// Its name without the article.
    pub fn meaning(&self) -> &'static str {
        self.name.strip_prefix("the ").unwrap_or(self.name)
    }

    /// Whether it is a height in the datum of the tower file.
    pub fn is_height(&self) -> bool {
        self.limit.nature() == Nature::Height
    }
}

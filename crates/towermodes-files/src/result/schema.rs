//! The JSON schemas of the results, as files that are part of the program.
//!
//! They are generated from the types of the results ([`generated_schema`](super::generated_schema),
//! feature `schema`), and a test compares both: the program needs no generator.

/// A result that is written as JSON.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ResultKind {
    /// Of `towermodes solve`.
    Solution,
    /// Of `towermodes solve` for several files.
    Several,
    /// Of `towermodes solve` for a rotating blade.
    Blade,
    /// Of `towermodes parameters`.
    Parameters,
    /// Of `towermodes sensitivities`.
    Sensitivities,
    /// Of `towermodes design`.
    Design,
    /// Of `towermodes calibrate`.
    Calibration,
    /// Of `towermodes sweep --first-order`.
    FirstOrder,
    /// Of `towermodes campbell`.
    Campbell,
    /// Of `towermodes campbell` for a turbine with flexible blades.
    CoupledCampbell,
    /// Of `towermodes damping`.
    Damping,
    /// Of `towermodes compare`.
    Comparison,
    /// Of `towermodes converge`.
    Convergence,
    /// Of `towermodes check` for two descriptions.
    Agreement,
    /// Of `towermodes check` for one description.
    Examination,
    /// Of `towermodes elastodyn validate`.
    ShapeValidation,
}

impl ResultKind {
    /// All kinds.
    pub const ALL: [Self; 16] = [
        Self::Solution,
        Self::Several,
        Self::Blade,
        Self::Parameters,
        Self::Sensitivities,
        Self::Design,
        Self::Calibration,
        Self::FirstOrder,
        Self::Campbell,
        Self::CoupledCampbell,
        Self::Damping,
        Self::Comparison,
        Self::Convergence,
        Self::Agreement,
        Self::Examination,
        Self::ShapeValidation,
    ];

    /// Its name for `towermodes schema`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Solution => "solve",
            Self::Several => "solve-several",
            Self::Blade => "blade",
            Self::Parameters => "parameters",
            Self::Sensitivities => "sensitivities",
            Self::Design => "design",
            Self::Calibration => "calibrate",
            Self::FirstOrder => "first-order",
            Self::Campbell => "campbell",
            Self::CoupledCampbell => "campbell-turbine",
            Self::Damping => "damping",
            Self::Comparison => "compare",
            Self::Convergence => "converge",
            Self::Agreement => "check",
            Self::Examination => "check-one",
            Self::ShapeValidation => "validate",
        }
    }

    /// The kind with a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Its JSON schema (draft 2020-12), indented, with a newline at the end.
    pub fn json_schema(self) -> &'static str {
        match self {
            Self::Solution => include_str!("../../schemas/solve.json"),
            Self::Several => include_str!("../../schemas/solve-several.json"),
            Self::Blade => include_str!("../../schemas/blade.json"),
            Self::Parameters => include_str!("../../schemas/parameters.json"),
            Self::Sensitivities => include_str!("../../schemas/sensitivities.json"),
            Self::Design => include_str!("../../schemas/design.json"),
            Self::Calibration => include_str!("../../schemas/calibrate.json"),
            Self::FirstOrder => include_str!("../../schemas/first-order.json"),
            Self::Campbell => include_str!("../../schemas/campbell.json"),
            Self::CoupledCampbell => include_str!("../../schemas/campbell-turbine.json"),
            Self::Damping => include_str!("../../schemas/damping.json"),
            Self::Comparison => include_str!("../../schemas/compare.json"),
            Self::Convergence => include_str!("../../schemas/converge.json"),
            Self::Agreement => include_str!("../../schemas/check.json"),
            Self::Examination => include_str!("../../schemas/check-one.json"),
            Self::ShapeValidation => include_str!("../../schemas/validate.json"),
        }
    }
}

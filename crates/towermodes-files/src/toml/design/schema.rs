//! The schema of the design file: all tables and keys with their types, units and meanings.

use super::super::schema::{KeySchema, TableSchema, tables};

tables! {
    /// All tables of the design file.
    ///
    /// # Example
    /// ```
    /// use towermodes_files::design_study_schema;
    ///
    /// let mut tables = design_study_schema().iter();
    /// let design = tables.find(|table| table.name == "[design]").expect("a table");
    /// assert!(design.key("variables").expect("a key").is_required);
    /// ```
    design_study_schema =>

    /// The whole file.
    STUDY = "the file":
        required "design" Table "" "the design";

    /// `[design]`.
    DESIGN = "[design]":
        required "variables" Table "" "design variables: names of input values with their bounds";
        required "frequencies" Table "" "frequency targets: names of modes with their bands";
        optional "limits" Table "" "limits of the shape of the tower";
        optional "segments" Number "" "number of segments or elements; default as in solve";
        optional "method" Text "" "the method of computation; default as in solve";
        optional "rotary_inertia" Flag "" "whether sections have rotary inertia in bending; default true";

    /// A value of `[design.variables]`.
    VARIABLE = "[design.variables]":
        required "between" Numbers "" "lowest and highest value";
        optional "step" Number "" "the values are multiples of this step, for example of a difference of plate thicknesses";
        optional "each" Text "" "which input values of a list are separate variables: number (each one), height (one value for all stations at a height) or can (one value for both ends of a can); without each, all have the same value";
        optional "order" Text "" "with each: falling (no value exceeds the one below it) or free, the default";

    /// A value of `[design.frequencies]`.
    FREQUENCY = "[design.frequencies]":
        optional "min" Number "Hz" "lowest frequency";
        optional "max" Number "Hz" "highest frequency";
        optional "between" Any "Hz" "lowest and highest frequency, or two multiples of the rotor speed, for example \"1P-3P\"";
        optional "margin" Number "" "with multiples: least distance as a fraction of the frequency, as in campbell; default 0.05";

    /// `[design.limits]`.
    LIMITS = "[design.limits]":
        optional "diameter_to_wall" Any "" "highest ratio of outer diameter to wall thickness at every station, or lowest and highest";
        optional "cone_angle" Number "degrees" "largest angle between wall and axis";
}

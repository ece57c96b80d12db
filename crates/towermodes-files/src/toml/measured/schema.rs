//! The schema of the calibration file: all tables and keys with their types, units and meanings.

use super::super::schema::{KeySchema, TableSchema, tables};

tables! {
    /// All tables of a calibration file.
    ///
    /// # Example
    /// ```
    /// use towermodes_files::measured_schema;
    ///
    /// let mut tables = measured_schema().iter();
    /// let measured = tables.find(|table| table.name == "[[measured]]").expect("a table");
    /// assert_eq!(measured.key("frequency").expect("a key").unit, "Hz");
    /// ```
    measured_schema =>

    /// The whole file.
    MEASURED_FILE = "the file":
        optional "calibrate" Table "" "the input values to be fitted to the measurements";
        required "measured" Any "" "the measured frequencies";

    /// `[calibrate]`.
    CALIBRATE = "[calibrate]":
        optional "unknowns" Table "" "names of input values in quotation marks, each with its prior or bounds";

    /// A value of `[calibrate.unknowns]`.
    UNKNOWN = "[calibrate.unknowns]":
        optional "prior" Numbers "" "mean and standard deviation, known without the measurements";
        optional "bounds" Numbers "" "lowest and highest value";

    /// `[[measured]]`.
    MEASURED = "[[measured]]":
        optional "mode" Text "" "the mode, for example fore-aft 1; without it the mode is found by shape and frequency";
        required "frequency" Number "Hz" "measured natural frequency";
        required "deviation" Number "Hz" "its standard deviation";
        optional "shape" Any "" "rows of height, fore-aft and side-side displacement, used to identify the mode";
}

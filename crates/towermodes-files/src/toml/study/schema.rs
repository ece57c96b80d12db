//! The schema of the sweep study: all tables and keys with their types, units and meanings.

use super::super::schema::{KeySchema, TableSchema, tables};

tables! {
    /// All tables of the sweep study.
    ///
    /// # Example
    /// ```
    /// use towermodes_files::sweep_study_schema;
    ///
    /// let mut tables = sweep_study_schema().iter();
    /// let sweep = tables.find(|table| table.name == "[sweep]").expect("a table");
    /// assert!(sweep.key("base").expect("a key").is_required);
    /// ```
    sweep_study_schema =>

    /// The whole file.
    STUDY = "the file":
        required "sweep" Table "" "the sweep";

    /// `[sweep]`.
    SWEEP = "[sweep]":
        required "base" Text "" "file with the base tower, in any format, relative to the study";
        optional "table" Text "" "file with the values, a column for each name: CSV or Parquet";
        optional "sampling" Text "" "in place of table: grid, latin-hypercube, random or sobol";
        optional "rows" Number "" "number of rows; omit it for a grid: the number of rows is the product of the numbers of levels";
        optional "seed" Number "" "another seed gives other values; default 0";
        optional "vary" Table "" "what varies: names of input values with their distributions";
        optional "correlation" Any "" "list of tables, one for each pair of correlated inputs";
        optional "results" Table "" "what is computed and written for each row";
        optional "reading" Table "" "how the file of the tower is read: the options of the command line with the same names, with _ for -";

    /// A value of `[sweep.vary]`.
    VARY = "[sweep.vary]":
        optional "uniform" Numbers "" "uniform distribution between lowest and highest value";
        optional "normal" Numbers "" "mean and standard deviation";
        optional "lognormal" Numbers "" "mean and standard deviation of the value, not of its logarithm";
        optional "values" Numbers "" "a list; each value is equally probable";
        optional "truncated" Numbers "" "with normal and lognormal: lowest and highest value";
        optional "levels" Number "" "of a grid with uniform: number of equally spaced values, both ends included";

    /// `[[sweep.correlation]]`.
    CORRELATION = "[[sweep.correlation]]":
        required "between" Any "" "a list of two names of [sweep.vary]";
        optional "coefficient" Number "" "correlation coefficient of two normally distributed inputs without limits, from -1 to 1";
        optional "score_coefficient" Number "" "correlation coefficient of the normal scores of two inputs with any distributions, from -1 to 1";

    /// `[sweep.results]`.
    RESULTS = "[sweep.results]":
        optional "modes" Any "" "number of lowest modes of the original tower, or a list of names; default 4";
        optional "segments" Number "" "number of segments or elements; default 20; with spectral chosen by the method, with bmodes the elements of a BModes deck";
        optional "method" Text "" "the method of computation; default as in solve";
        optional "rotary_inertia" Flag "" "whether sections have rotary inertia in bending; default true";
        optional "inputs" Flag "" "whether the varied values are columns of the results; default true";

    /// `[sweep.reading]`.
    READING = "[sweep.reading]":
        optional "no_rna" Flag "" "omit the rotor-nacelle assembly";
        optional "no_gravity" Flag "" "omit gravity";
        optional "clamped" Flag "" "clamp a tower of OpenFAST at its base, without the structure below it";
        optional "equilibrium" Flag "" "give the mooring lines of a floating platform their stiffness at the equilibrium";
        optional "rotor" Text "" "locked or free, of an ElastoDyn model";
        optional "bmodes_quirks" Flag "" "interpret a BModes deck exactly as BModes 3.00 does";
        optional "part" Text "" "all, tower or monopile of a windIO turbine";
        optional "member_ends" Text "" "balance, cut or whole: where members of the floating platform of a windIO turbine end";
        optional "tower_height" Number "m" "top of an ElastoDyn tower file without its main file";
        optional "tower_base" Number "m" "base of an ElastoDyn tower file without its main file, or of a HAWC2 file";
        optional "subset" Numbers "" "set and subset of a HAWC2 file";
}

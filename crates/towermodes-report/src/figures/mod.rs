//! The pictures, one a file: each from results of the library alone.

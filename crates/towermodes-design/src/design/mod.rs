//! The lightest tower whose frequencies are in given bands.

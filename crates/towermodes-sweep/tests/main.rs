//! All tests of the sweeps.

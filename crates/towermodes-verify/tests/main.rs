//! All tests of the manual and of the random study, in one program.

mod coverage;
mod manual;

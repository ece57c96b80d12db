//! All tests of the manual, in one program.

mod manual;

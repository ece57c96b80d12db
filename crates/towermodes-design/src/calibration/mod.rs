//! Numbers of a tower that explain measured frequencies.

//! Questions asked of the natural modes of wind turbine towers.
//!
//! Every answer is computed from towers and their solutions alone: this crate reads no files and
//! prints nothing, so the program, a report and a web page ask the same questions in the same way.
//!
//! | question | function | module |
//! |---|---|---|
//! | How far are the methods from each other? | [`compare`] | [`study`] |
//! | How do frequencies converge as the number of segments increases? | [`converge`] | [`study`] |
//! | Does the rotor excite the tower? | [`campbell`] | [`resonance`] |
//! | Do two files describe the same tower? | [`agree`] | [`agreement`] |
//! | Which mode shapes does ElastoDyn need? | [`tower_shapes`] | [`elastodyn`] |

pub mod agreement;
pub mod elastodyn;
mod mac;
pub mod resonance;
pub mod study;
mod verdict;

pub use agreement::agree;
pub use elastodyn::tower_shapes;
pub use mac::mac;
pub use resonance::campbell;
pub use study::{compare, converge};
pub use verdict::Verdict;

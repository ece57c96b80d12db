//! The interactive explorer: the input values of a tower have sliders, and the tower is solved
//! again for every frame.
//!
//! An [`Explorer`] contains a tower as its file describes it and answers the requests of a page:
//! the input values and their ranges, the modes for changed input values, elasticities, files to
//! download. It keeps no state of the page: each request contains all input values that differ from
//! the file. The page is in `page`, its scripts are built from the folder `page/` of the
//! repository; `server` serves it on this machine.

mod answer;
mod band;
mod elasticity;
mod explorer;
mod linked;
mod page;
mod question;
mod refusal;
mod reproduction;
mod resonance;
#[cfg(feature = "server")]
pub mod server;
mod sheet;
mod slider;
mod state;
mod take;
mod target;
mod turbine;

pub use answer::{Answer, AnsweredMode, Fact, Remark, Timed};
pub use elasticity::{Elasticities, ElasticityQuestion, NoElasticity};
pub use explorer::{Exploration, Explorer, POINTS, Reporter, Wanted};
pub use page::{PageFile, page_files};
pub use question::{Question, Reply};
pub use refusal::{Refusal, Refused};
pub use reproduction::Reproduction;
pub use resonance::{DiagramLine, DiagramRow, Resonance, Verdicted};
pub use sheet::{Dragged, Group, OtherSheet, Sheet, SheetParameter};
pub use state::State;
pub use take::{PictureFormat, Take, TakeError, Taken, What};
pub use target::{Found, TargetQuestion, TargetVariable};
pub use turbine::{Coupled, SPEEDS, TowerMode, Whirl, WhirlMode, WhirlQuestion};

//! The cases of the manual, one file per chapter.

mod bmodes;
mod elements;
mod gravity;
mod ground;
mod offshore;
mod paper;
mod real;
mod springs;
mod tapers;
mod tips;
mod tower;
mod turbine;
mod uniform;
mod winkler;

use crate::case::Case;
use crate::chapter::Chapter;

/// The chapters in their order.
pub const CHAPTERS: [Chapter; 14] = [
    paper::CHAPTER,
    elements::CHAPTER,
    bmodes::CHAPTER,
    uniform::CHAPTER,
    tips::CHAPTER,
    tapers::CHAPTER,
    tower::CHAPTER,
    springs::CHAPTER,
    winkler::CHAPTER,
    ground::CHAPTER,
    gravity::CHAPTER,
    real::CHAPTER,
    turbine::CHAPTER,
    offshore::CHAPTER,
];

/// Every case in the order of the chapters.
pub fn manual() -> Vec<Case> {
    let chapters = [
        paper::cases(),
        elements::cases(),
        bmodes::cases(),
        uniform::cases(),
        tips::cases(),
        tapers::cases(),
        tower::cases(),
        springs::cases(),
        winkler::cases(),
        ground::cases(),
        gravity::cases(),
        real::cases(),
        turbine::cases(),
        offshore::cases(),
    ];
    chapters.into_iter().flatten().collect()
}

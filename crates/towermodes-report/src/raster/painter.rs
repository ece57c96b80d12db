//! Paints shapes as pixels.

use tiny_skia::{
    Color, FillRule, LineJoin, Mask, Paint as Ink, Path, PathBuilder, Pixmap, Rect, Stroke as Pen,
    StrokeDash, Transform,
};

use super::letters::outlines;
use crate::svg::{Area, Colour, Paint, Point, Shape, Stroke, Theme};

/// The pixels, with the state that applies to the next shape.
pub(super) struct Painter {
    pub(super) pixmap: Pixmap,
    theme: Theme,
    /// From the units of the drawing to pixels.
    transform: Transform,
    /// The area in which shapes are visible; everywhere if none.
    mask: Option<Mask>,
}

impl Painter {
    /// Paper of a theme with this number of pixels, `scale` of them for each unit of the drawing;
    /// none if there is not enough memory.
    pub(super) fn new(width: u32, height: u32, theme: Theme, scale: f64) -> Option<Self> {
        let mut pixmap = Pixmap::new(width, height)?;
        pixmap.fill(colour(Colour::Paper, theme));
        let scale = scale as f32;
        Some(Self {
            pixmap,
            theme,
            transform: Transform::from_scale(scale, scale),
            mask: None,
        })
    }

    /// Paints shapes, each over the previous ones.
    pub(super) fn paint(&mut self, shapes: &[Shape]) {
        for shape in shapes {
            self.paint_shape(shape);
        }
    }

    fn paint_shape(&mut self, shape: &Shape) {
        match shape {
            Shape::Lines { runs, stroke } => self.stroke(through(runs, false), stroke),
            Shape::Surface { runs, paint } => self.surface(through(runs, true), paint),
            Shape::Rectangle { area, paint } => self.surface(rectangle(area), paint),
            Shape::Disc {
                centre: (x, y),
                radius,
                paint,
            } => {
                let disc = PathBuilder::from_circle(*x as f32, *y as f32, *radius as f32);
                self.surface(disc, paint);
            }
            Shape::Text { at, text, style } => {
                let turn = if style.is_turned { -90.0 } else { 0.0 };
                let placed = translation(*at).pre_rotate(turn);
                self.with_transform(placed, |painter| {
                    painter.fill(outlines(text, style), style.colour);
                });
            }
            Shape::Clipped { area, shapes, .. } => self.clipped(area, shapes),
            Shape::Lowered { by, shapes } => {
                self.with_transform(translation((0.0, *by)), |painter| painter.paint(shapes));
            }
        }
    }

    fn with_transform(&mut self, placed: Transform, paint: impl FnOnce(&mut Self)) {
        let before = self.transform;
        self.transform = before.pre_concat(placed);
        paint(self);
        self.transform = before;
    }

    /// Paints shapes inside a rectangle, which may itself be inside another.
    fn clipped(&mut self, area: &Area, shapes: &[Shape]) {
        let before = self.mask.clone();
        if let Some(path) = rectangle(area) {
            self.mask = self.mask_of(&path);
            self.paint(shapes);
        }
        self.mask = before;
    }

    /// The present mask without the area outside a path.
    fn mask_of(&self, path: &Path) -> Option<Mask> {
        if let Some(mut mask) = self.mask.clone() {
            mask.intersect_path(path, FillRule::Winding, true, self.transform);
            return Some(mask);
        }
        let mut mask = Mask::new(self.pixmap.width(), self.pixmap.height())?;
        mask.fill_path(path, FillRule::Winding, true, self.transform);
        Some(mask)
    }

    fn surface(&mut self, path: Option<Path>, paint: &Paint) {
        self.fill(path.clone(), paint.fill);
        if let Some(edge) = &paint.edge {
            self.stroke(path, edge);
        }
    }

    /// Fills a path; a path without an area is not painted.
    fn fill(&mut self, path: Option<Path>, fill: Colour) {
        let Some(path) = path else { return };
        let (ink, rule) = (ink(fill, self.theme), FillRule::Winding);
        let mask = self.mask.as_ref();
        self.pixmap
            .fill_path(&path, &ink, rule, self.transform, mask);
    }

    fn stroke(&mut self, path: Option<Path>, stroke: &Stroke) {
        let Some(path) = path else { return };
        let pen = Pen {
            width: stroke.width as f32,
            line_join: LineJoin::Round,
            dash: StrokeDash::new(stroke.dash.lengths().to_vec(), 0.0),
            ..Pen::default()
        };
        let ink = ink(stroke.colour, self.theme);
        let mask = self.mask.as_ref();
        self.pixmap
            .stroke_path(&path, &ink, &pen, self.transform, mask);
    }
}

fn translation((x, y): Point) -> Transform {
    Transform::from_translate(x as f32, y as f32)
}

/// The path through points; if `is_closed`, the last run is closed.
fn through(runs: &[Vec<Point>], is_closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    for run in runs {
        for (index, (x, y)) in run.iter().enumerate() {
            let (x, y) = (*x as f32, *y as f32);
            match index {
                0 => path.move_to(x, y),
                _ => path.line_to(x, y),
            }
        }
    }
    if is_closed {
        path.close();
    }
    path.finish()
}

fn rectangle(area: &Area) -> Option<Path> {
    let ((x, y), (width, height)) = (area.left_top, area.size);
    let rect = Rect::from_xywh(x as f32, y as f32, width as f32, height as f32)?;
    Some(PathBuilder::from_rect(rect))
}

fn ink(role: Colour, theme: Theme) -> Ink<'static> {
    let mut ink = Ink::default();
    ink.set_color(colour(role, theme));
    ink
}

/// The colour of a role; all colours are opaque.
fn colour(role: Colour, theme: Theme) -> Color {
    let [red, green, blue] = role.rgb(theme);
    Color::from_rgba8(red, green, blue, u8::MAX)
}

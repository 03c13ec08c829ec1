//! The page on which things are made of ground: what the player carries of it, and what can come of that.

use std::sync::Arc;

use antipode_language::{Texts, Value};
use egui::style::ScrollAnimation;
use egui::{
    Color32, EventFilter, FontId, Galley, Id, Key, Painter, Pos2, Rect, Response, Role, Sense, Ui,
    UiBuilder, Vec2, WidgetInfo, vec2,
};

use super::item_name;
use crate::hud::{SlotView, Tint, dot};
use crate::icons;
use crate::layout::{Stops, scroll};
use crate::theme::{BAD, TEXT, WEAK, small};
use crate::widgets::{focus_ring, paint_card};

/// What the page shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MakingModel {
    /// What can be made, in the order in which it stands.
    pub recipes: Vec<RecipeView>,
    /// What the player carries of ground.
    pub earth: Vec<EarthView>,
}

/// A thing that can be made.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecipeView {
    /// What comes of it.
    pub made: SlotView,
    /// What it takes.
    pub parts: Vec<PartView>,
    /// Whether it can be made now.
    pub possible: bool,
}

/// Ground of one kind that a thing takes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PartView {
    /// The kind, e.g. "coal".
    pub label: String,
    /// Its colour.
    pub tint: Tint,
    /// How much it takes, in cubic metres.
    pub needs_m3: f64,
    /// How much the player has, in cubic metres.
    pub has_m3: f64,
}

/// Ground of one kind that the player carries.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EarthView {
    /// The kind, e.g. "coal".
    pub label: String,
    /// Its colour.
    pub tint: Tint,
    /// How much, in cubic metres.
    pub m3: f64,
}

/// Largest side of the picture of a thing, in points, and the width of a row that has room for it.
const ICON: f32 = 40.0;
const ICON_FROM: f32 = 200.0;
/// Between what is in a row and its edge, in points.
const MARGIN: Vec2 = vec2(10.0, 6.0);
/// Room for a swatch before its words, and between words and the next swatch, in points.
const SWATCH: f32 = 16.0;
const BETWEEN: f32 = 12.0;
/// Between lines, in points.
const LINE: f32 = 2.0;

/// Draws it within `page`; `fresh`: it has come up in this frame. Returns what can hold the focus, and the index of the
/// recipe that was asked for.
pub(super) fn show(
    ui: &mut Ui,
    page: Rect,
    texts: &Texts,
    model: &MakingModel,
    fresh: bool,
) -> (Stops, Option<usize>) {
    let builder = UiBuilder::new().id_salt("making").max_rect(page);
    let mut ui = ui.new_child(builder);
    Stops::take_step(ui.ctx());
    let mut stops = Stops::default();
    let mut asked = None;
    let lost = is_lost(&ui);
    let possible = model.recipes.iter().position(|recipe| recipe.possible);
    if fresh || lost {
        // Before it is drawn, to come into view then.
        ui.memory_mut(|memory| {
            memory.move_focus(egui::FocusDirection::None);
            memory.request_focus(id(possible.unwrap_or(0)));
        });
    }
    scroll(&mut ui, page.height(), |ui| {
        turn_by_wheel(ui, page);
        let carried = carried(ui, texts, &model.earth);
        for (index, recipe) in model.recipes.iter().enumerate() {
            let response = row(ui, texts, index, recipe);
            // The arrow that brings the focus back does not move it on.
            if !lost {
                stops.add(&response);
            }
            let top = response.rect.union(carried);
            if index == 0 && response.gained_focus() && top.height() < page.height() {
                // What lies over the first row cannot hold the focus, and would not come into view again.
                ui.scroll_to_rect(top, None);
            }
            if response.clicked() && recipe.possible {
                asked = Some(index);
            }
        }
    });
    (stops, asked)
}

/// Scrolls by the wheel over the page, which lies on a layer that scroll areas do not take for the topmost.
fn turn_by_wheel(ui: &Ui, page: Rect) {
    let (at, turned) = ui.input(|input| (input.pointer.hover_pos(), input.smooth_scroll_delta()));
    if at.is_some_and(|at| page.contains(at)) && turned.y != 0.0 {
        ui.scroll_with_delta_animation(vec2(0.0, turned.y), ScrollAnimation::none());
    }
}

fn id(recipe: usize) -> Id {
    Id::unique(("antipode-recipe", recipe))
}

/// Whether an arrow asks for something to have the focus while nothing has it: egui only moves it on.
fn is_lost(ui: &Ui) -> bool {
    let arrows = [Key::ArrowUp, Key::ArrowDown];
    let asks = ui.input(|input| arrows.iter().any(|key| input.key_pressed(*key)));
    asks && ui.ctx().memory(egui::Memory::focused).is_none()
}

/// What the player carries of ground; what that covers.
fn carried(ui: &mut Ui, texts: &Texts, earth: &[EarthView]) -> Rect {
    let amount = |it: &EarthView| {
        let values = [
            ("kind", it.label.as_str().into()),
            ("volume", Value::decimals_of_stock(it.m3, 1)),
        ];
        (Some(it.tint), texts.say_with("making-earth", &values), TEXT)
    };
    let head = if earth.is_empty() {
        texts.say("making-nothing")
    } else {
        texts.say("making-carried")
    };
    let mut words = vec![(None, head, WEAK)];
    words.extend(earth.iter().map(amount));
    words.push((None, texts.say("making-where"), WEAK));
    let spoken: Vec<_> = words.iter().map(|(_, words, _)| words.as_str()).collect();
    let spoken = spoken.join(" · ");
    let width = ui.available_width().max(1.0);
    let flow = Flow::new(ui.painter(), width, words);
    let (rect, response) = ui.allocate_exact_size(vec2(width, flow.size.y), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &spoken));
    flow.paint(ui.painter(), rect.min);
    rect
}

/// A thing that can be made as one wide button.
fn row(ui: &mut Ui, texts: &Texts, index: usize, recipe: &RecipeView) -> Response {
    let width = ui.available_width().max(1.0);
    let left = if width < ICON_FROM {
        MARGIN.x
    } else {
        ICON + 2.0 * MARGIN.x
    };
    let inner = (width - left - MARGIN.x).max(1.0);
    let painter = ui.painter().clone();
    let colour = if recipe.possible { TEXT } else { WEAK };
    let name = item_name(texts, &recipe.made);
    let title = painter.layout(name.clone(), FontId::proportional(16.0), colour, inner);
    let words = recipe.parts.iter().map(|part| part_words(texts, part));
    let mut words: Vec<_> = words.collect();
    let spoken: Vec<_> = words.iter().map(|(_, words, _)| words.as_str()).collect();
    let values = [("item", name.into()), ("parts", spoken.join(" · ").into())];
    let spoken = texts.say_with("making-recipe", &values);
    if let Some(item) = recipe
        .made
        .item
        .filter(|item| item.brush_strength_per_s().is_some())
    {
        // What a tool digs is what it is made for.
        let about = texts.say(&format!("item-{}-about", item.id()));
        words.push((None, about, WEAK));
    }
    let flow = Flow::new(&painter, inner, words);
    let least = if width < ICON_FROM { 0.0 } else { ICON };
    let high = (title.size().y + LINE + flow.size.y).max(least) + 2.0 * MARGIN.y;
    let (_, rect) = ui.allocate_space(vec2(width, high));
    let response = ui.interact(rect, id(index), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, recipe.possible, &spoken));
    lock(ui, &response);
    if !ui.is_rect_visible(rect) {
        focus_ring(ui, &response);
        return response;
    }
    paint_card(ui, &response, false);
    if let Some(item) = recipe.made.item.filter(|_| least > 0.0) {
        let mut faint = painter.clone();
        faint.multiply_opacity(if recipe.possible { 1.0 } else { 0.5 });
        let middle = Pos2::new(rect.min.x + MARGIN.x + 0.5 * ICON, rect.center().y);
        icons::paint(
            &faint,
            item,
            Rect::from_center_size(middle, Vec2::splat(ICON)),
        );
    }
    let at = rect.min + vec2(left, MARGIN.y);
    flow.paint(&painter, at + vec2(0.0, title.size().y + LINE));
    painter.galley(at, title, colour);
    response
}

/// A row is as wide as the list: sideways there is nothing to go to.
fn lock(ui: &Ui, response: &Response) {
    let sideways = EventFilter {
        horizontal_arrows: true,
        ..Default::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, sideways));
}

/// How much of a kind is needed and there, in the colour of whether it is enough.
fn part_words(texts: &Texts, part: &PartView) -> Words {
    let digits = digits(part.needs_m3);
    let values = [
        ("kind", part.label.as_str().into()),
        ("needs", Value::decimals(part.needs_m3, digits)),
        ("has", Value::decimals_of_stock(part.has_m3, digits)),
    ];
    let words = texts.say_with("making-part", &values);
    let enough = part.has_m3 >= part.needs_m3;
    (Some(part.tint), words, if enough { WEAK } else { BAD })
}

/// Digits after the mark that an amount is written with.
fn digits(amount: f64) -> usize {
    let tenths = 10.0 * amount;
    if (tenths - tenths.round()).abs() < 1e-6 {
        1
    } else {
        2
    }
}

/// Words, the colour of ground before them if they are about one, and their own colour.
type Words = (Option<Tint>, String, Color32);

/// Words one after another in lines of some width.
struct Flow {
    parts: Vec<(Vec2, Option<Tint>, Arc<Galley>)>,
    size: Vec2,
}

impl Flow {
    fn new(painter: &Painter, width: f32, words: Vec<Words>) -> Self {
        let (mut at, mut size) = (Vec2::ZERO, Vec2::ZERO);
        let mut parts = Vec::with_capacity(words.len());
        for (tint, words, colour) in words {
            let before = tint.map_or(0.0, |_| SWATCH);
            let wrap = (width - before).max(1.0);
            let galley = painter.layout(words, small(), colour, wrap);
            let own = vec2(before + galley.size().x, galley.size().y);
            if at.x > 0.0 && at.x + own.x > width {
                at = vec2(0.0, size.y + LINE);
            }
            size = size.max(at + own);
            parts.push((at, tint, galley));
            at.x += own.x + BETWEEN;
        }
        Self { parts, size }
    }

    fn paint(self, painter: &Painter, corner: Pos2) {
        for (at, tint, galley) in self.parts {
            let mut at = corner + at;
            if let Some(tint) = tint {
                dot(painter, at + vec2(6.0, 0.5 * galley.size().y), tint);
                at.x += SWATCH;
            }
            painter.galley(at, galley, WEAK);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_too_little_is_never_written_as_enough() {
        let texts = Texts::default();
        for (needs_m3, has_m3, words) in [
            (0.5, 2.34, "coal 2.3 of 0.5 m³"),
            (0.5, 0.499, "coal 0.4 of 0.5 m³"),
            (0.3, 0.3, "coal 0.3 of 0.3 m³"),
            (0.25, 0.2499, "coal 0.24 of 0.25 m³"),
            (2.0, 0.0, "coal 0.0 of 2.0 m³"),
        ] {
            let part = PartView {
                label: "coal".to_owned(),
                needs_m3,
                has_m3,
                ..PartView::default()
            };
            let (_, said, colour) = part_words(&texts, &part);
            assert_eq!(said, words);
            assert_eq!(colour == BAD, has_m3 < needs_m3, "{words}");
        }
    }
}

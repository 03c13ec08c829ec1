//! The list of worlds or rooms, each as a row.

use antipode_language::Texts;
use egui::{FontId, Rect, Response, Role, Sense, Ui, WidgetInfo, vec2};

use super::{Kind, edits, facts, picture};
use crate::layout::{Stops, pane, steady};
use crate::model::{Screen, WorldRow};
use crate::shell::Pass;
use crate::theme::{ACCENT, BAD, GRID, TEXT, WEAK, small};
use crate::widgets::{button, column_button, focus_ring, one_line, paint_card};

/// Below this width of a row the picture makes room for the words, in points.
const PICTURE_FROM: f32 = 360.0;
/// Height of the pictures, in points.
const PICTURE_HEIGHT: f32 = 54.0;
/// Width of the button beside a row, in points.
const MANAGE_WIDTH: f32 = 40.0;

/// What the list is shown for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    Load,
    Delete,
}

/// What was chosen in the list.
pub(super) enum Choice<'a> {
    /// The row itself.
    Row(&'a WorldRow),
    /// The button beside it.
    Manage(&'a WorldRow),
    /// A button under the list: one from a file.
    Import,
    /// The button at the end of the list of rooms: a new one.
    New,
}

/// What is shown, and what for.
#[derive(Clone, Copy)]
struct Shown {
    kind: Kind,
    purpose: Purpose,
}

/// A line under a row, and whether it tells of something bad.
type Remark = (Option<String>, bool);

/// Draws the list; returns what was chosen.
pub(super) fn show<'a>(
    ui: &mut Ui,
    pass: &mut Pass<'a>,
    kind: Kind,
    purpose: Purpose,
) -> Option<Choice<'a>> {
    let model = pass.model;
    let regions = pass.regions;
    let rows = kind.rows(model);
    let (mut chosen, mut to_shipped) = (None, false);
    let body = |ui: &mut Ui, stops: &mut Stops| {
        if let Some(work) = &kind.files(model).work {
            ui.label(egui::RichText::new(work).font(small()).color(ACCENT));
        }
        if rows.is_empty() {
            ui.label(kind.say(model.texts, "none"));
        }
        let shown = Shown { kind, purpose };
        for row in rows {
            let choice = steady(ui, &row.slug, |ui| self::row(ui, pass, stops, row, shown));
            chosen = choice.or(chosen.take());
        }
        if kind != Kind::World && column(ui, stops, (model.texts, "rooms-new")) {
            chosen = Some(Choice::New);
        }
        to_shipped =
            kind == Kind::Own && column(ui, stops, (model.texts, "workshop-rooms-shipped"));
    };
    let title = model.texts.say(match (kind, purpose) {
        (Kind::Room, _) => "menu-rooms",
        (Kind::Own, _) => "menu-workshop",
        (_, Purpose::Load) => "menu-load",
        (_, Purpose::Delete) => "menu-delete",
    });
    let (mut back, mut import) = (None, None);
    pane(ui, regions.pane, &title, body, |ui| {
        back = Some(button(ui, &model.texts.say("back")));
        if purpose == Purpose::Load {
            import = Some(button(ui, &model.texts.say("worlds-import")));
        }
    });
    if let Some(back) = back {
        if rows.is_empty() {
            pass.offer_focus(&back);
        }
        if back.clicked() {
            pass.go = Some(Screen::Main);
        }
    }
    if to_shipped {
        pass.go = Some(Screen::Rooms);
    }
    if import.is_some_and(|import| import.clicked()) {
        chosen = Some(Choice::Import);
    }
    chosen
}

/// A button under the list, as wide as that. Returns whether it was clicked.
fn column(ui: &mut Ui, stops: &mut Stops, (texts, key): (&Texts, &str)) -> bool {
    let label = texts.say(key);
    let response = steady(ui, key, |ui| column_button(ui, &label, false));
    stops.add(&response);
    response.clicked()
}

/// One of them: a wide button, and beside it, where they are loaded, one for its page.
fn row<'a>(
    ui: &mut Ui,
    pass: &mut Pass<'_>,
    stops: &mut Stops,
    row: &'a WorldRow,
    shown: Shown,
) -> Option<Choice<'a>> {
    let manageable = shown.purpose == Purpose::Load;
    let width = ui.available_width();
    let card_width = if manageable {
        (width - MANAGE_WIDTH - GRID).max(1.0)
    } else {
        width
    };
    let mut choice = None;
    ui.horizontal(|ui| {
        let response = card(ui, pass, row, shown, card_width);
        stops.add(&response);
        pass.offer_focus(&response);
        if response.clicked() {
            choice = Some(Choice::Row(row));
        }
        if manageable && ui.available_width() >= 1.0 {
            let response = manage_button(ui, pass, row, response.rect.height());
            stops.add(&response);
            if response.clicked() {
                choice = Some(Choice::Manage(row));
            }
        }
    });
    choice
}

/// The button that leads to a world's page: three dots, drawn.
fn manage_button(ui: &mut Ui, pass: &Pass<'_>, row: &WorldRow, height: f32) -> Response {
    let width = MANAGE_WIDTH.min(ui.available_width());
    let (rect, response) = ui.allocate_exact_size(vec2(width, height), Sense::click());
    let values = [("name", row.name.as_str().into())];
    let label = pass.model.texts.say_with("worlds-manage", &values);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &label));
    if ui.is_rect_visible(rect) {
        paint_card(ui, &response, false);
        for step in [-1.0, 0.0, 1.0] {
            let centre = rect.center() + vec2(0.0, step * 7.0);
            ui.painter().circle_filled(centre, 2.0, TEXT);
        }
    } else {
        focus_ring(ui, &response);
    }
    response
}

fn remark(pass: &Pass<'_>, row: &WorldRow, shown: Shown) -> Remark {
    let texts = pass.model.texts;
    let Shown { kind, purpose } = shown;
    match &row.problem {
        _ if row.running && purpose == Purpose::Delete => {
            (Some(texts.say("worlds-running-no-delete")), true)
        }
        _ if row.running => (Some(kind.say(texts, "running")), false),
        Some(problem) => (Some(problem.clone()), true),
        None => (None, false),
    }
}

/// One of them as one wide button, called "Load “name”" by screen readers.
fn card(ui: &mut Ui, pass: &Pass<'_>, row: &WorldRow, shown: Shown, width: f32) -> Response {
    let Shown { kind, purpose } = shown;
    let pictured = width >= PICTURE_FROM;
    let left = if pictured {
        picture::size(PICTURE_HEIGHT).x + 20.0
    } else {
        12.0
    };
    let inner = (width - left - 12.0).max(1.0);
    let painter = ui.painter().clone();
    let mut lines =
        vec![painter.layout_job(one_line(&row.name, FontId::proportional(16.0), TEXT, inner))];
    lines.push(painter.layout(facts(pass, row), small(), WEAK, inner));
    if purpose == Purpose::Delete && row.edits.is_some() {
        lines.push(painter.layout(edits(pass, kind, row), small(), WEAK, inner));
    }
    let (words, bad) = remark(pass, row, shown);
    if let Some(words) = words {
        let colour = if bad { BAD } else { ACCENT };
        lines.push(painter.layout(words, small(), colour, inner));
    }
    let words_height = lines.iter().map(|line| line.size().y + 2.0).sum::<f32>() + 14.0;
    let height = if pictured {
        words_height.max(PICTURE_HEIGHT + 12.0)
    } else {
        words_height
    };
    let (rect, response) = ui.allocate_exact_size(vec2(width, height), Sense::click());
    let values = [("name", row.name.as_str().into())];
    let key = match purpose {
        Purpose::Load => "load-named",
        Purpose::Delete => "delete-named",
    };
    let label = kind.say_with(pass.model.texts, key, &values);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &label));
    if !ui.is_rect_visible(rect) {
        focus_ring(ui, &response);
        return response;
    }
    paint_card(ui, &response, false);
    if pictured {
        let at = rect.min + vec2(6.0, 6.0);
        picture::paint(
            &painter,
            Rect::from_min_size(at, picture::size(PICTURE_HEIGHT)),
            kind,
            row,
        );
    }
    let mut at = rect.min + vec2(left, 8.0);
    for line in lines {
        let step = line.size().y + 2.0;
        painter.galley(at, line, TEXT);
        at.y += step;
    }
    response
}

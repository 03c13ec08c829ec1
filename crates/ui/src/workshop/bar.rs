//! The bar at the top: what is done most, with the keys that do it.

use antipode_language::Value;
use egui::{Rect, Response, Ui, UiBuilder};

use super::keys::shortcut_label;
use super::lesson::{self, LessonChoice};
use super::model::{LessonTarget, ToolChoice, ViewSide, WorkshopModel, WorkshopWish};
use crate::layout::inset;
use crate::theme::{GRID, PANEL};
use crate::widgets::focus_ring;

/// Steps of the grid that one can choose, metres.
const GRIDS_M: [f64; 2] = [0.25, 1.0];

/// Draws it; returns where it ends. `examples`: whether the page of what is possible is up.
pub(super) fn show(
    ui: &mut Ui,
    screen: Rect,
    model: &WorkshopModel<'_>,
    wishes: &mut Vec<WorkshopWish>,
    examples: &mut bool,
) -> f32 {
    let painter = ui.painter().clone();
    let background = painter.add(egui::Shape::Noop);
    let inner = inset(screen, GRID / 2.0);
    let mut ui = ui.new_child(UiBuilder::new().id_salt("bar").max_rect(inner));
    let bottom =
        ui.horizontal_wrapped(|ui| {
            buttons(ui, model, wishes, examples);
        })
        .response
        .rect
        .max
        .y + GRID / 2.0;
    let shape = egui::Shape::rect_filled(screen.with_max_y(bottom), 0, PANEL);
    painter.set(background, shape);
    bottom
}

fn buttons(
    ui: &mut Ui,
    model: &WorkshopModel<'_>,
    wishes: &mut Vec<WorkshopWish>,
    examples: &mut bool,
) {
    room_menu(ui, model, wishes);
    let (texts, bar) = (model.texts, model.bar);
    let mut push = |clicked: bool, wish: WorkshopWish| {
        if clicked {
            wishes.push(wish);
        }
    };
    push(
        entry(ui, model, "play", (false, true)).clicked(),
        WorkshopWish::Play,
    );
    ui.separator();
    push(
        entry(ui, model, "undo", (false, bar.can_undo)).clicked(),
        WorkshopWish::Undo,
    );
    push(
        entry(ui, model, "redo", (false, bar.can_redo)).clicked(),
        WorkshopWish::Redo,
    );
    ui.separator();
    for tool in ToolChoice::ALL {
        let response = entry(ui, model, tool.id(), (bar.tool == tool, true));
        push(response.clicked(), WorkshopWish::Tool(tool));
    }
    ui.separator();
    let response = entry(ui, model, "own-axes", (bar.own_axes, true));
    push(response.clicked(), WorkshopWish::OwnAxes(!bar.own_axes));
    let response = entry(ui, model, "snaps", (bar.snaps, true));
    push(response.clicked(), WorkshopWish::Snaps(!bar.snaps));
    let next = if bar.grid_m == GRIDS_M[0] {
        GRIDS_M[1]
    } else {
        GRIDS_M[0]
    };
    let decimals = if bar.grid_m.fract() == 0.0 { 0 } else { 2 };
    let label = texts.say_with(
        "workshop-grid",
        &[("metres", Value::decimals(bar.grid_m, decimals))],
    );
    let response = ui.add_enabled(bar.snaps, egui::Button::new(label));
    focus_ring(ui, &response);
    push(response.clicked(), WorkshopWish::Grid(next));
    let response = entry(ui, model, "on-surfaces", (bar.on_surfaces, true));
    push(
        response.clicked(),
        WorkshopWish::OnSurfaces(!bar.on_surfaces),
    );
    ui.separator();
    menus(ui, model, wishes, examples);
}

/// What is not asked for at every moment.
fn menus(
    ui: &mut Ui,
    model: &WorkshopModel<'_>,
    wishes: &mut Vec<WorkshopWish>,
    examples: &mut bool,
) {
    let texts = model.texts;
    ui.menu_button(texts.say("workshop-menu-edit"), |ui| {
        edit_menu(ui, model, wishes);
    });
    ui.menu_button(texts.say("workshop-menu-view"), |ui| {
        view_menu(ui, model, wishes);
    });
    ui.menu_button(texts.say("workshop-menu-help"), |ui| {
        for (id, lesson) in [
            ("lesson", LessonChoice::House),
            ("lesson-doors", LessonChoice::Doors),
        ] {
            if line(ui, model, id, (false, true)).clicked() {
                wishes.push(WorkshopWish::BeginLesson(lesson));
                ui.close();
            }
        }
        if line(ui, model, "examples", (false, true)).clicked() {
            *examples = true;
            ui.close();
        }
    });
}

/// What is done with the room as a whole.
fn room_menu(ui: &mut Ui, model: &WorkshopModel<'_>, wishes: &mut Vec<WorkshopWish>) {
    ui.menu_button(model.texts.say("workshop-menu-room"), |ui| {
        for (id, wish) in [
            ("keep", WorkshopWish::Keep),
            ("from-file", WorkshopWish::ChooseFile),
            ("leave", WorkshopWish::Leave),
        ] {
            if line(ui, model, id, (false, true)).clicked() {
                wishes.push(wish);
                ui.close();
            }
        }
    });
}

fn edit_menu(ui: &mut Ui, model: &WorkshopModel<'_>, wishes: &mut Vec<WorkshopWish>) {
    let bar = model.bar;
    let chosen = bar.has_chosen;
    for (id, enabled, wish) in [
        ("copy", chosen, WorkshopWish::Copy),
        ("cut", chosen, WorkshopWish::Cut),
        ("paste", bar.has_copied, WorkshopWish::Paste),
        ("duplicate", chosen, WorkshopWish::Duplicate),
        ("array", chosen, WorkshopWish::AskArray),
        ("group", chosen, WorkshopWish::Group),
        ("ungroup", chosen, WorkshopWish::Ungroup),
        ("delete", chosen, WorkshopWish::Delete),
        ("choose-all", true, WorkshopWish::ChooseAll(true)),
    ] {
        if line(ui, model, id, (false, enabled)).clicked() {
            wishes.push(wish);
            ui.close();
        }
    }
}

fn view_menu(ui: &mut Ui, model: &WorkshopModel<'_>, wishes: &mut Vec<WorkshopWish>) {
    let bar = model.bar;
    let mut pushed = Vec::new();
    if line(ui, model, "focus", (false, bar.has_chosen)).clicked() {
        pushed.push(WorkshopWish::Focus);
    }
    for side in ViewSide::ALL {
        if line(ui, model, side.id(), (false, true)).clicked() {
            pushed.push(WorkshopWish::Face(side));
        }
    }
    if line(ui, model, "parallel", (bar.parallel, true)).clicked() {
        pushed.push(WorkshopWish::Parallel(!bar.parallel));
    }
    if line(ui, model, "walls", (bar.hides_walls, true)).clicked() {
        pushed.push(WorkshopWish::HideWalls(!bar.hides_walls));
    }
    if line(ui, model, "flies", (bar.flies, true)).clicked() {
        pushed.push(WorkshopWish::Flies(!bar.flies));
    }
    if line(ui, model, "raster", (bar.raster, true)).clicked() {
        pushed.push(WorkshopWish::Raster(!bar.raster));
    }
    if !pushed.is_empty() {
        wishes.append(&mut pushed);
        ui.close();
    }
}

/// A line of a menu, with its key beside it.
fn line(
    ui: &mut Ui,
    model: &WorkshopModel<'_>,
    id: &'static str,
    (chosen, enabled): (bool, bool),
) -> Response {
    let label = model.texts.say(&format!("workshop-do-{id}"));
    let mut button = egui::Button::new(label).selected(chosen);
    if let Some(key) = shortcut_label(model.texts, id) {
        button = button.shortcut_text(key);
    }
    let response = ui.add_enabled(enabled, button);
    focus_ring(ui, &response);
    response
}

/// A button, with its key as what is told where the pointer rests.
fn entry(
    ui: &mut Ui,
    model: &WorkshopModel<'_>,
    id: &'static str,
    (chosen, enabled): (bool, bool),
) -> Response {
    let label = model.texts.say(&format!("workshop-do-{id}"));
    let response = ui.add_enabled(enabled, egui::Button::new(label).selected(chosen));
    focus_ring(ui, &response);
    lesson::point_out(ui, model, &LessonTarget::Do(id), response.rect);
    let about = matches!(id, "own-axes" | "snaps" | "on-surfaces")
        .then(|| model.texts.say(&format!("workshop-hover-{id}")));
    let told: Vec<_> = about
        .into_iter()
        .chain(shortcut_label(model.texts, id))
        .collect();
    if told.is_empty() {
        response
    } else {
        response.on_hover_text(told.join("\n"))
    }
}

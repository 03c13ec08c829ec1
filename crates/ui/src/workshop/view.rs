//! The view: what the pointer and keys do over the picture of the room, and the lines that lie on it.

use egui::{
    Align2, EventFilter, Key, Modifiers, PointerButton, Pos2, Rect, Response, Sense, Stroke, Ui,
    pos2, vec2,
};

use super::keys::held_with_button;
use super::model::{ViewEvent, ViewLine, WorkshopModel, WorkshopWish};
use crate::theme::{FOCUS, GRID, PLATE, TEXT, small};

/// How far beside the end of its line a label stands, points.
const LABEL_OFF: f32 = 10.0;

/// What the view remembers from pass to pass.
#[derive(Debug, Default)]
pub(super) struct ViewState {
    /// Whether the first button went down in it and is still down.
    is_held: bool,
    /// Whether the pointer has moved since.
    has_moved: bool,
    /// Whether the pointer was over it last.
    is_hovered: bool,
    /// Whether the view has been given the keyboard once.
    was_focused: bool,
}

/// Draws it, and tells what is done in it.
pub(super) fn show(
    ui: &mut Ui,
    rect: Rect,
    model: &WorkshopModel<'_>,
    state: &mut ViewState,
    wishes: &mut Vec<WorkshopWish>,
) {
    let response = ui.interact(rect, ui.scope_id().with("view"), Sense::click_and_drag());
    response.widget_info(|| {
        let label = model.texts.say("workshop-pane-view");
        egui::WidgetInfo::labeled(egui::Role::Canvas, true, label)
    });
    let mut push = |event| wishes.push(WorkshopWish::View(event));
    pointer(ui, &response, state, &mut push);
    camera(ui, &response, model, &mut push);
    if response.clicked()
        || response.drag_started()
        || !std::mem::replace(&mut state.was_focused, true)
    {
        response.request_focus();
    }
    if response.has_focus() {
        let filter = EventFilter {
            horizontal_arrows: true,
            vertical_arrows: true,
            tab: false,
            escape: false,
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        nudges(ui, model, wishes);
    }
    paint(ui, rect, model, response.has_focus());
}

fn place(rect: Rect, at: Pos2) -> [f64; 2] {
    let from = at - rect.center();
    let half = rect.size() * 0.5;
    [f64::from(from.x / half.x), f64::from(-from.y / half.y)]
}

/// What the first button does.
fn pointer(ui: &Ui, response: &Response, state: &mut ViewState, push: &mut impl FnMut(ViewEvent)) {
    let rect = response.rect;
    let (at, pressed, released, down) = ui.input(|input| {
        let pointer = &input.pointer;
        (
            pointer.latest_pos(),
            pointer.button_pressed(PointerButton::Primary),
            pointer.button_released(PointerButton::Primary),
            pointer.button_down(PointerButton::Primary),
        )
    });
    let held = held_with_button(ui);
    let Some(at) = at else { return };
    let there = place(rect, at);
    if pressed && response.contains_pointer() && !held.alt {
        (state.is_held, state.has_moved) = (true, false);
        push(ViewEvent::Grab(there));
    } else if state.is_held && down && response.dragged_by(PointerButton::Primary) {
        state.has_moved |= response
            .total_drag_delta()
            .is_some_and(|it| it.length() > 3.0);
        if state.has_moved {
            push(ViewEvent::Pull {
                at: there,
                free: held.alt,
            });
        }
    } else if response.contains_pointer() && !down {
        push(ViewEvent::Hover(there));
        state.is_hovered = true;
    } else if !down && std::mem::take(&mut state.is_hovered) {
        push(ViewEvent::Leave);
    }
    if state.is_held && (released || !down) {
        state.is_held = false;
        push(ViewEvent::Let {
            at: there,
            adds: held.shift || held.command,
            is_click: !state.has_moved,
        });
    }
}

/// What the other buttons, the wheel and the keys of flight do.
fn camera(
    ui: &Ui,
    response: &Response,
    model: &WorkshopModel<'_>,
    push: &mut impl FnMut(ViewEvent),
) {
    let delta = response.drag_delta();
    let way = [f64::from(delta.x), f64::from(delta.y)];
    let held = ui.input(|input| input.modifiers);
    if delta != egui::Vec2::ZERO {
        if response.dragged_by(PointerButton::Secondary) {
            push(ViewEvent::Look(way));
        } else if response.dragged_by(PointerButton::Middle) && held.shift {
            push(ViewEvent::Pan(way));
        } else if response.dragged_by(PointerButton::Middle)
            || (held.alt && response.dragged_by(PointerButton::Primary))
        {
            push(ViewEvent::Orbit(way));
        }
    }
    if response.contains_pointer() {
        let notches = ui.input(|input| input.smooth_scroll_delta().y) / 50.0;
        if notches != 0.0 {
            push(ViewEvent::Zoom(f64::from(notches)));
        }
    }
    let by_button = response.is_pointer_button_down_on()
        && ui.input(|input| input.pointer.button_down(PointerButton::Secondary));
    if by_button || (model.bar.flies && response.has_focus()) {
        fly(ui, model.bar.flies && !by_button, push);
    }
}

fn fly(ui: &Ui, by_keys_alone: bool, push: &mut impl FnMut(ViewEvent)) {
    let (by, turn, time_s, fast) = ui.input(|input| {
        let way = |more: Key, less: Key| {
            f64::from(u8::from(input.key_down(more))) - f64::from(u8::from(input.key_down(less)))
        };
        (
            [
                way(Key::W, Key::S),
                way(Key::D, Key::A),
                way(Key::E, Key::Q),
            ],
            [
                way(Key::ArrowRight, Key::ArrowLeft),
                way(Key::ArrowDown, Key::ArrowUp),
            ],
            f64::from(input.stable_dt.min(0.1)),
            input.modifiers.shift,
        )
    });
    if by != [0.0; 3] {
        push(ViewEvent::Fly(by, time_s, fast));
        ui.ctx().request_repaint();
    }
    if by_keys_alone && turn != [0.0; 2] {
        push(ViewEvent::Look(turn.map(|it| it * 400.0 * time_s)));
        ui.ctx().request_repaint();
    }
}

/// Exact steps by the arrow keys, while the view has the keyboard.
fn nudges(ui: &Ui, model: &WorkshopModel<'_>, wishes: &mut Vec<WorkshopWish>) {
    if model.bar.flies {
        return;
    }
    for (key, way) in [
        (Key::ArrowLeft, [-1, 0, 0]),
        (Key::ArrowRight, [1, 0, 0]),
        (Key::ArrowUp, [0, 0, -1]),
        (Key::ArrowDown, [0, 0, 1]),
        (Key::PageUp, [0, 1, 0]),
        (Key::PageDown, [0, -1, 0]),
    ] {
        if ui.input_mut(|input| input.consume_key(Modifiers::NONE, key)) {
            wishes.push(WorkshopWish::Nudge(way));
        }
    }
}

fn paint(ui: &Ui, rect: Rect, model: &WorkshopModel<'_>, is_focused: bool) {
    let painter = ui.painter_at(rect);
    let mut room = rect.shrink(GRID);
    let lines = |room: Rect| {
        // No label covers what can be taken hold of, and edges cover no label.
        let (held, edges): (Vec<_>, Vec<_>) = model.lines.iter().partition(|it| it.knob);
        for line in edges {
            paint_line(&painter, rect, line);
        }
        let points = held.iter().flat_map(|it| &it.points);
        let points: Vec<_> = points.map(|at| on_screen(rect, *at)).collect();
        for line in model.lines {
            paint_label(&painter, (rect, room), line, &points);
        }
        for line in held {
            paint_line(&painter, rect, line);
        }
    };
    if model.status.is_empty() {
        lines(room);
    } else {
        let words = painter.layout(
            model.status.to_owned(),
            small(),
            TEXT,
            rect.width() - 4.0 * GRID,
        );
        let at = rect.left_bottom() + vec2(GRID, -GRID - words.size().y);
        let plate = Rect::from_min_size(at, words.size()).expand(4.0);
        room.max.y = plate.min.y - GRID;
        lines(room);
        painter.rect_filled(plate, 4, PLATE);
        painter.galley(at, words, TEXT);
    }
    if is_focused {
        let stroke = Stroke::new(1.0, FOCUS);
        painter.rect_stroke(rect, 0, stroke, egui::StrokeKind::Inside);
    }
}

fn on_screen(rect: Rect, at: [f32; 2]) -> Pos2 {
    let (centre, half) = (rect.center(), rect.size() * 0.5);
    pos2(centre.x + at[0] * half.x, centre.y - at[1] * half.y)
}

/// Draws a line of the view.
fn paint_line(painter: &egui::Painter, rect: Rect, line: &ViewLine) {
    let points: Vec<_> = line.points.iter().map(|at| on_screen(rect, *at)).collect();
    // A dark edge, so that it is seen over snow and night.
    let edge = Stroke::new(line.width + 2.0, egui::Color32::from_black_alpha(120));
    painter.add(egui::Shape::line(points.clone(), edge));
    let stroke = Stroke::new(line.width, line.colour);
    painter.add(egui::Shape::line(points.clone(), stroke));
    if let (Some(end), true) = (points.last(), line.knob) {
        painter.circle_filled(*end, 2.2 * line.width, line.colour);
    }
}

/// Draws the label at the end of a line of the view, within a part of that, on the side where the fewest of some points are.
fn paint_label(
    painter: &egui::Painter,
    (rect, room): (Rect, Rect),
    line: &ViewLine,
    points: &[Pos2],
) {
    let (Some(end), Some(label)) = (line.points.last(), &line.label) else {
        return;
    };
    let end = on_screen(rect, *end);
    let words = painter.layout_no_wrap(label.clone(), small(), TEXT);
    let beside = |(side, x, y): (Align2, f32, f32)| {
        let at = side.anchor_size(end + vec2(x, y) * LABEL_OFF, words.size());
        // All of it is read, wherever the line ends.
        let at = at.translate((room.max - at.max).min(egui::Vec2::ZERO));
        at.translate((room.min - at.min).max(egui::Vec2::ZERO))
    };
    let covered = |at: &Rect| {
        let plate = at.expand(8.0);
        points.iter().filter(|it| plate.contains(**it)).count()
    };
    let sides = [
        (Align2::LEFT_CENTER, 1.0, 0.0),
        (Align2::RIGHT_CENTER, -1.0, 0.0),
        (Align2::CENTER_TOP, 0.0, 2.0),
        (Align2::CENTER_BOTTOM, 0.0, -2.0),
    ];
    let Some(at) = sides.map(beside).into_iter().min_by_key(covered) else {
        return;
    };
    painter.rect_filled(at.expand(4.0), 4, PLATE);
    painter.galley(at.min, words, TEXT);
}

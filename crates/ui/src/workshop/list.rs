//! The list of what stands in the room: searched, chosen, hidden, locked, renamed, and dragged into groups.

use std::collections::HashSet;
use std::ops::Range;

use egui::{Color32, Key, Response, RichText, ScrollArea, Sense, TextStyle, Ui, vec2};

use super::keys::held_with_button;
use super::lesson;
use super::model::{LessonTarget, ObjectRow, WorkshopModel, WorkshopWish};
use crate::entry::entry;
use crate::theme::{ACCENT, ACCENT_DIM, TEXT, WEAK};
use crate::widgets::focus_ring;

/// Height of a row, points.
const ROW: f32 = 24.0;
/// How much farther to the right what a group carries stands, points.
const INDENT: f32 = 14.0;

/// What is typed in the list.
#[derive(Debug, Default)]
pub(super) struct ListState {
    search: String,
    /// What gets another name, and which.
    pub renaming: Option<(String, String)>,
    /// Whether the field for that has just come up.
    begins: bool,
    /// What is to come into view.
    pub shows: Option<String>,
    /// Groups of which only the name is listed.
    folded: HashSet<String>,
    /// What was chosen last, and the rows that were in view.
    chosen: Option<String>,
    in_view: Range<usize>,
}

impl ListState {
    /// Unfolds every group that something is in.
    fn unfold_around(&mut self, objects: &[ObjectRow], name: &str) {
        let Some(place) = objects.iter().position(|it| it.name == name) else {
            return;
        };
        let mut depth = objects[place].depth;
        for row in objects[..place].iter().rev() {
            if row.depth < depth {
                depth = row.depth;
                self.folded.remove(&row.name);
            }
        }
    }

    /// What is listed: all that is searched for, or all but what folded groups carry.
    fn listed<'m>(&self, objects: &'m [ObjectRow]) -> Vec<&'m ObjectRow> {
        let wanted = self.search.trim().to_lowercase();
        let mut folded_at = usize::MAX;
        let is_listed = |row: &&ObjectRow| {
            if !wanted.is_empty() {
                let words = format!("{} {}", row.name, row.kind).to_lowercase();
                return words.contains(&wanted);
            }
            if row.depth > folded_at {
                return false;
            }
            let is_folded = row.is_group && self.folded.contains(&row.name);
            folded_at = if is_folded { row.depth } else { usize::MAX };
            true
        };
        objects.iter().filter(is_listed).collect()
    }
}

/// Draws it.
pub(super) fn show(
    ui: &mut Ui,
    model: &WorkshopModel<'_>,
    state: &mut ListState,
    wishes: &mut Vec<WorkshopWish>,
) {
    let texts = model.texts;
    let hint = texts.say("workshop-search");
    let is_sought_anew = entry(ui, &mut state.search, &hint, &hint).changed();
    if let Some(name) = state.shows.clone() {
        state.unfold_around(model.objects, &name);
    }
    let rows = state.listed(model.objects);
    if rows.is_empty() {
        ui.label(RichText::new(texts.say("workshop-none-found")).color(WEAK));
    }
    begin_to_rename(ui, model, state);
    let chosen = model.objects.iter().rfind(|it| it.selected);
    let chosen = chosen.map(|it| it.name.clone());
    let is_new = chosen.is_some() && chosen != state.chosen;
    state.chosen.clone_from(&chosen);
    let of = |name: &str| rows.iter().position(|row| row.name == name);
    if is_new && chosen.as_deref().and_then(of).is_none() {
        // What is sought is another thing than what was chosen or put in now.
        state.search.clear();
    }
    // What is chosen in the view comes into view here.
    let chosen = chosen.as_deref().filter(|_| is_new).and_then(of);
    let chosen = chosen.filter(|place| !state.in_view.contains(place));
    let mut area = ScrollArea::vertical();
    if is_sought_anew {
        area = area.vertical_scroll_offset(0.0);
    }
    let wanted = state.shows.as_deref().and_then(of);
    if let Some(place) = wanted.or(chosen) {
        state.shows = state.shows.take().filter(|_| wanted.is_none());
        let above = (place as f32 - 2.0).max(0.0) * (ROW + ui.spacing().item_spacing.y);
        area = area.vertical_scroll_offset(above);
    }
    area.auto_shrink(false)
        .show_rows(ui, ROW, rows.len(), |ui, range| {
            state.in_view = range.start + 1..range.end.saturating_sub(1);
            for row in &rows[range] {
                ui.push_id(&row.name, |ui| self::row(ui, model, row, state, wishes));
            }
            let rest = ui.available_size_before_wrap().max(vec2(1.0, 12.0));
            let (_, rest) = ui.allocate_exact_size(rest, Sense::hover());
            if let Some(name) = rest.dnd_release_payload::<String>() {
                wishes.push(WorkshopWish::Carry((*name).clone(), None));
            }
        });
}

/// The key that renames what is chosen.
fn begin_to_rename(ui: &Ui, model: &WorkshopModel<'_>, state: &mut ListState) {
    if state.renaming.is_some() || !ui.input(|input| input.key_pressed(Key::F2)) {
        return;
    }
    if let Some(row) = model.objects.iter().find(|it| it.selected) {
        state.renaming = Some((row.name.clone(), row.name.clone()));
        state.begins = true;
    }
}

fn row(
    ui: &mut Ui,
    model: &WorkshopModel<'_>,
    row: &ObjectRow,
    state: &mut ListState,
    wishes: &mut Vec<WorkshopWish>,
) {
    ui.spacing_mut().interact_size.y = ROW - 4.0;
    ui.spacing_mut().button_padding.y = 0.0;
    ui.horizontal(|ui| {
        ui.set_height(ROW - 4.0);
        ui.add_space(INDENT * row.depth.min(8) as f32);
        if rename(ui, model, row, state, wishes) {
            return;
        }
        marks(ui, model, row, wishes);
        if row.is_group {
            fold(ui, model, row, &mut state.folded);
        }
        let response = name(ui, row);
        let target = LessonTarget::Object(row.name.clone());
        lesson::point_out(ui, model, &target, response.rect);
        if response.double_clicked() {
            state.renaming = Some((row.name.clone(), row.name.clone()));
            state.begins = true;
        } else if response.clicked() {
            let held = held_with_button(ui);
            wishes.push(if held.shift {
                WorkshopWish::ChooseTo(row.name.clone())
            } else {
                WorkshopWish::Choose {
                    name: row.name.clone(),
                    adds: held.command,
                }
            });
        }
        response.dnd_set_drag_payload(row.name.clone());
        if row.is_group {
            if response.dnd_hover_payload::<String>().is_some() {
                ui.painter().rect_filled(response.rect, 4, ACCENT_DIM);
            }
            if let Some(dropped) = response.dnd_release_payload::<String>()
                && *dropped != row.name
            {
                let group = Some(row.name.clone());
                wishes.push(WorkshopWish::Carry((*dropped).clone(), group));
            }
        }
    });
}

/// The field for another name, if that is what is typed of this row.
fn rename(
    ui: &mut Ui,
    model: &WorkshopModel<'_>,
    row: &ObjectRow,
    state: &mut ListState,
    wishes: &mut Vec<WorkshopWish>,
) -> bool {
    let Some((of, name)) = &mut state.renaming else {
        return false;
    };
    if *of != row.name {
        return false;
    }
    let label = model.texts.say("workshop-rename");
    let response = entry(ui, name, &label, "");
    if std::mem::take(&mut state.begins) {
        response.request_focus();
    } else if response.lost_focus() {
        let takes = ui.input(|input| !input.key_pressed(Key::Escape));
        if takes && name.trim() != *of && !name.trim().is_empty() {
            wishes.push(WorkshopWish::Rename(of.clone(), name.trim().to_owned()));
        }
        state.renaming = None;
    }
    true
}

/// The marks that hide and lock: an eye and a lock, drawn.
fn marks(ui: &mut Ui, model: &WorkshopModel<'_>, row: &ObjectRow, wishes: &mut Vec<WorkshopWish>) {
    let texts = model.texts;
    let values = [("name", row.name.as_str().into())];
    let eye = mark(
        ui,
        &texts.say_with("workshop-hide", &values),
        row.hidden,
        |painter, rect, colour, on| {
            let radii = vec2(6.5, 4.0);
            let stroke = egui::Stroke::new(1.2, colour);
            painter.add(egui::epaint::EllipseShape::stroke(
                rect.center(),
                radii,
                stroke,
            ));
            painter.circle_filled(rect.center(), 1.8, colour);
            if on {
                painter.line_segment([rect.left_bottom(), rect.right_top()], stroke);
            }
        },
    );
    if eye.clicked() {
        wishes.push(WorkshopWish::Hide(row.name.clone(), !row.hidden));
    }
    let lock = mark(
        ui,
        &texts.say_with("workshop-lock", &values),
        row.locked,
        |painter, rect, colour, on| {
            let body = egui::Rect::from_center_size(rect.center() + vec2(0.0, 2.5), vec2(9.0, 7.0));
            let stroke = egui::Stroke::new(1.2, colour);
            if on {
                painter.rect_filled(body, 1, colour);
            } else {
                painter.rect_stroke(body, 1, stroke, egui::StrokeKind::Inside);
            }
            let aside = if on { 0.0 } else { 3.0 };
            let top = body.center_top() + vec2(aside, 0.0);
            painter.circle_stroke(top - vec2(0.0, 1.0), 3.0, stroke);
        },
    );
    if lock.clicked() {
        wishes.push(WorkshopWish::Lock(row.name.clone(), !row.locked));
    }
}

/// The triangle that folds a group.
fn fold(ui: &mut Ui, model: &WorkshopModel<'_>, row: &ObjectRow, folded: &mut HashSet<String>) {
    let values = [("name", row.name.as_str().into())];
    let label = model.texts.say_with("workshop-fold", &values);
    let is_folded = folded.contains(&row.name);
    let triangle = mark(ui, &label, is_folded, |painter, rect, colour, on| {
        let at = rect.center();
        // To the right where it is folded, down where it is not.
        let (along, across) = if on {
            (vec2(4.0, 0.0), vec2(0.0, 5.0))
        } else {
            (vec2(0.0, 4.0), vec2(5.0, 0.0))
        };
        let corners = vec![at + along, at - along + across, at - along - across];
        painter.add(egui::Shape::convex_polygon(
            corners,
            colour,
            egui::Stroke::NONE,
        ));
    });
    if triangle.clicked() && !folded.remove(&row.name) {
        folded.insert(row.name.clone());
    }
}

fn mark(
    ui: &mut Ui,
    label: &str,
    on: bool,
    paint: impl FnOnce(&egui::Painter, egui::Rect, Color32, bool),
) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(16.0, 16.0), Sense::click());
    response.widget_info(|| egui::WidgetInfo::selected(egui::Role::CheckBox, true, on, label));
    let colour = if on { ACCENT } else { WEAK };
    paint(ui.painter(), rect, colour, on);
    focus_ring(ui, &response);
    response.on_hover_text(label)
}

/// How wide words are, points.
fn width(ui: &Ui, words: &str, style: &TextStyle) -> f32 {
    let font = style.resolve(ui.style());
    let galley = ui.painter().layout_no_wrap(words.to_owned(), font, TEXT);
    galley.size().x
}

fn name(ui: &mut Ui, row: &ObjectRow) -> Response {
    let colour = if row.hidden { WEAK } else { TEXT };
    let mut words = RichText::new(&row.name).color(colour);
    if row.is_group {
        words = words.strong();
    }
    let size = vec2(ui.available_width(), ROW - 4.0);
    // The name comes first where there is no room for both.
    let both = [
        (&row.name, TextStyle::Button),
        (&row.kind, TextStyle::Small),
    ];
    let wide: f32 = both.iter().map(|(it, style)| width(ui, it, style)).sum();
    let gaps = 3.0 * ui.spacing().button_padding.x;
    let kind = if wide + gaps < size.x {
        row.kind.as_str()
    } else {
        ""
    };
    let button = egui::Button::new(words)
        .selected(row.selected)
        .frame(row.selected)
        .right_text(RichText::new(kind).color(WEAK).small())
        .sense(Sense::click_and_drag())
        .truncate();
    let response = ui.add_sized(size, button);
    focus_ring(ui, &response);
    // Whole, where the list is too narrow for it.
    response.on_hover_text(format!("{} ({})", row.name, row.kind))
}

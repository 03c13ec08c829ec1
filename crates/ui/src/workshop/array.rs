//! The form that says how what is chosen is repeated in a row: how often, which way, how far apart, and how much turned.

use egui::{DragValue, Grid, Id, Modal, RichText, Ui, WidgetInfo, vec2};

use super::field::said;
use super::model::{Unit, WorkshopModel, WorkshopWish};
use crate::entry::parse_number;
use crate::theme::{GRID, TEXT};
use crate::widgets::{button, focus_ring, primary_button};

/// How something is repeated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArrayForm {
    /// How many copies are made, 1 to 200.
    pub count: u32,
    /// Along which axis of the room: x, y or z.
    pub axis: usize,
    /// What is left free between one and the next, metres.
    pub gap_m: f64,
    /// How much each is turned from the one before, about the upright, degrees.
    pub turn_deg: f64,
}

impl Default for ArrayForm {
    fn default() -> Self {
        Self {
            count: 4,
            axis: 0,
            gap_m: 0.0,
            turn_deg: 0.0,
        }
    }
}

/// Draws it while it is open.
pub(super) fn show(
    ui: &Ui,
    model: &WorkshopModel<'_>,
    open: &mut Option<ArrayForm>,
    wishes: &mut Vec<WorkshopWish>,
) {
    let Some(mut form) = *open else { return };
    let texts = model.texts;
    let mut is_made = false;
    let mut is_closed = false;
    let response = Modal::new(Id::unique("antipode-workshop-array")).show(ui.ctx(), |ui| {
        ui.style_mut().override_font_id = Some(egui::FontId::proportional(14.0));
        ui.spacing_mut().item_spacing = vec2(GRID, 6.0);
        ui.spacing_mut().interact_size.y = 26.0;
        let title = texts.say("workshop-do-array");
        ui.label(RichText::new(title).color(TEXT).size(20.0));
        Grid::new("array").num_columns(2).show(ui, |ui| {
            fields(ui, model, &mut form);
        });
        ui.horizontal(|ui| {
            is_made = primary_button(ui, &texts.say("workshop-array-make"), true).clicked();
            is_closed = button(ui, &texts.say("workshop-array-close")).clicked();
        });
    });
    if is_made {
        wishes.push(WorkshopWish::Array(form));
    }
    let stays = !is_made && !is_closed && !response.should_close();
    *open = stays.then_some(form);
}

fn fields(ui: &mut Ui, model: &WorkshopModel<'_>, form: &mut ArrayForm) {
    let texts = model.texts;
    let number = |ui: &mut Ui, label: &str, drag: DragValue<'_>| {
        ui.label(label);
        let response = ui.add_sized(vec2(120.0, 26.0), drag.update_while_editing(false));
        response.widget_info(|| WidgetInfo::labeled(egui::Role::TextInput, true, label));
        focus_ring(ui, &response);
        ui.end_row();
    };
    // An arrow key goes on by the speed, which more than half of one makes one.
    let count = DragValue::new(&mut form.count).range(1..=200).speed(0.6);
    number(ui, &texts.say("workshop-array-count"), count);
    ui.label(texts.say("workshop-array-axis"));
    ui.horizontal(|ui| {
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let response = ui.selectable_label(form.axis == axis, format!("  {name}  "));
            focus_ring(ui, &response);
            if response.clicked() {
                form.axis = axis;
            }
        }
    });
    ui.end_row();
    let gap = DragValue::new(&mut form.gap_m)
        .range(0.0..=1000.0)
        .speed(0.05)
        .custom_formatter(|value, _| said(texts, value, Unit::Metres))
        .custom_parser(parse_number);
    number(ui, &texts.say("workshop-array-gap"), gap);
    let turn = DragValue::new(&mut form.turn_deg)
        .range(-360.0..=360.0)
        .speed(1.0)
        .custom_formatter(|value, _| said(texts, value, Unit::Degrees))
        .custom_parser(parse_number);
    number(ui, &texts.say("workshop-array-turn"), turn);
}

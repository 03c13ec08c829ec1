//! The Controls screen, generated from the bindings: what happens on the left,
//! the keys on the right, under the headings of their groups.

use egui::{Label, RichText, Sense, Ui};

use crate::layout::{Stops, pane};
use crate::model::{Binding, Screen};
use crate::shell::Pass;
use crate::theme::{ACCENT, TEXT};
use crate::widgets::{button, focus_ring};

/// Draws the screen.
pub(crate) fn show(ui: &mut Ui, pass: &mut Pass<'_>) {
    let bindings = pass.model.bindings;
    let regions = pass.regions;
    let mut back = false;
    let body = |ui: &mut Ui, stops: &mut Stops| {
        // Close lines, so that a window of 720 pixels shows them all without scrolling.
        ui.spacing_mut().item_spacing.y = 2.0;
        for group in groups(bindings) {
            ui.label(RichText::new(group).color(ACCENT));
            for binding in bindings.iter().filter(|binding| binding.group == group) {
                let response = line(ui, binding);
                stops.add(&response);
                pass.offer_focus(&response);
            }
            ui.separator();
        }
    };
    pane(ui, regions.pane, "Controls", body, |ui| {
        back = button(ui, "Back").clicked();
    });
    if back {
        pass.go = Some(Screen::Main);
    }
}

/// A line can hold the focus, so that Tab and the arrows walk through the list.
fn line(ui: &mut Ui, binding: &Binding) -> egui::Response {
    let rect = ui.columns_const(|[left, right]| {
        left.add(Label::new(&binding.action).wrap());
        let keys = RichText::new(&binding.keys).monospace().color(TEXT);
        right.add(Label::new(keys).wrap());
        left.min_rect().union(right.min_rect())
    });
    let id = ui
        .scope_id()
        .with((&binding.group, &binding.action, &binding.keys));
    let response = ui.interact(rect, id, Sense::focusable_noninteractive());
    response.widget_info(|| {
        let words = format!("{}: {}", binding.action, binding.keys);
        egui::WidgetInfo::labeled(egui::Role::ListItem, true, words)
    });
    focus_ring(ui, &response);
    response
}

/// The groups in the order of their first binding.
fn groups(bindings: &[Binding]) -> Vec<&str> {
    let mut groups: Vec<&str> = Vec::new();
    for binding in bindings {
        if !groups.contains(&binding.group.as_str()) {
            groups.push(&binding.group);
        }
    }
    groups
}

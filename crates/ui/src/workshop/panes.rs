//! The panes as tiles, and what each of them shows.

use egui::{Color32, Context, Id, LayerId, Rect, Ui, UiBuilder, WidgetText};
use egui_tiles::{Behavior, SimplificationOptions, TileId, Tiles, Tree, UiResponse};

use super::layout::{Pane, text, tree, usual};
use super::list::ListState;
use super::model::{LessonTarget, WorkshopModel, WorkshopWish};
use super::{array, bar, chooser, examples, inspector, keys, lesson, list, notes, parts, view};
use crate::layout::inset;
use crate::theme::{ACCENT, FOCUS, GRID, LINE, PANEL, TEXT, WEAK};

/// The panes of the workshop, and what is typed in them.
pub struct WorkshopPanes {
    tree: Tree<Pane>,
    list: ListState,
    view: view::ViewState,
    rect: Rect,
    /// How the panes lay when they were drawn first.
    first: Option<String>,
    is_changed: bool,
    /// Whether the page of what is possible is up.
    examples: bool,
    /// The form of how something is repeated, while it is up.
    array: Option<array::ArrayForm>,
    chooser: chooser::ChooserState,
    /// The step of the lesson for which panes were brought to the front.
    shown_for: Option<(usize, LessonTarget)>,
}

impl std::fmt::Debug for WorkshopPanes {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("WorkshopPanes").finish_non_exhaustive()
    }
}

impl WorkshopPanes {
    /// The panes as `layout` has them, which is what [`Self::layout`] gave once; as they are at first in a window of that width
    /// where it says nothing.
    pub fn new(layout: &str, width: f32) -> Self {
        Self {
            tree: tree(layout, width),
            list: ListState::default(),
            view: view::ViewState::default(),
            rect: Rect::NOTHING,
            first: None,
            is_changed: false,
            examples: false,
            array: None,
            chooser: chooser::ChooserState::default(),
            shown_for: None,
        }
    }

    /// Whether a page lies over the panes, which Esc closes.
    pub fn has_page(&self) -> bool {
        self.examples || self.array.is_some()
    }

    /// Brings what the lesson is done with to the front, once for each of its steps.
    fn show_target(&mut self, model: &WorkshopModel<'_>) {
        let wanted = model.lesson.map(|it| (it.number, it.target.clone()));
        if wanted == self.shown_for {
            return;
        }
        self.shown_for.clone_from(&wanted);
        let Some((_, target)) = wanted else { return };
        let pane = match &target {
            LessonTarget::Part(_) => Pane::Parts,
            LessonTarget::Object(name) => {
                self.list.shows = Some(name.clone());
                Pane::List
            }
            LessonTarget::Field(_) => Pane::Inspector,
            LessonTarget::Do(_) | LessonTarget::View => Pane::View,
        };
        self.tree
            .make_active(|_, tile| matches!(tile, egui_tiles::Tile::Pane(it) if *it == pane));
    }

    /// How the panes lie, as a text, if that was ever otherwise than when they were drawn first: what is put back is told, too.
    pub fn changed_layout(&self) -> Option<String> {
        self.is_changed.then(|| self.layout())
    }

    /// How the panes lie, as a text.
    pub fn layout(&self) -> String {
        text(&self.tree)
    }

    /// The panes lie as they do at first in a window of that width.
    pub fn lay_anew(&mut self, width: f32) {
        self.tree = tree(usual(width), width);
    }

    /// Where the picture of the room is seen, points; as of the last pass.
    pub fn view_rect(&self) -> Rect {
        self.rect
    }

    /// Draws the panes over the whole of the window, and returns what the player asked for.
    pub fn show(&mut self, context: &Context, model: &WorkshopModel<'_>) -> Vec<WorkshopWish> {
        let mut wishes = Vec::new();
        let screen = context.content_rect();
        let builder = UiBuilder::new()
            .layer_id(LayerId::background())
            .max_rect(screen);
        let mut ui = Ui::new(context.clone(), Id::unique("antipode-workshop"), builder);
        ui.spacing_mut().item_spacing = egui::vec2(6.0, 4.0);
        ui.spacing_mut().interact_size.y = 26.0;
        ui.spacing_mut().button_padding = egui::vec2(8.0, 3.0);
        let small = egui::FontId::proportional(14.0);
        ui.style_mut().override_font_id = Some(small);
        // Bars are painted in what words on buttons are; fine ones do not outshine the words.
        ui.spacing_mut().scroll.bar_width = 7.0;
        self.show_target(model);
        // Of a click and a key in one slow frame the first is done first.
        let late = keys::come_after_button(&ui);
        let is_elsewhere =
            self.list.renaming.is_some() || self.has_page() || model.chooser.is_some();
        let mut asked = Vec::new();
        keys::read(&ui, model, is_elsewhere, &mut asked);
        if !late {
            wishes.append(&mut asked);
        }
        let top = bar::show(&mut ui, screen, model, &mut wishes, &mut self.examples);
        let rest = screen.with_min_y(top);
        let mut below = ui.new_child(UiBuilder::new().id_salt("tiles").max_rect(rest));
        let mut panes = Panes {
            model,
            wishes: &mut wishes,
            list: &mut self.list,
            view: &mut self.view,
            rect: Rect::NOTHING,
        };
        self.tree.ui(&mut panes, &mut below);
        self.rect = panes.rect;
        lesson::show(&ui, self.rect, model, &mut wishes);
        examples::show(&ui, model, &mut self.examples, &mut wishes);
        array::show(&ui, model, &mut self.array, &mut wishes);
        chooser::show(&ui, model, &mut self.chooser, &mut wishes);
        wishes.append(&mut asked);
        if wishes.contains(&WorkshopWish::AskArray) {
            wishes.retain(|it| *it != WorkshopWish::AskArray);
            self.array = Some(array::ArrayForm::default());
        }
        // What was typed is of what was chosen until now, whatever a click chooses in the same pass.
        wishes.sort_by_key(|it| !matches!(it, WorkshopWish::Set { .. }));
        let now = self.layout();
        self.is_changed |= *self.first.get_or_insert_with(|| now.clone()) != now;
        wishes
    }
}

struct Panes<'a, 'm> {
    model: &'a WorkshopModel<'m>,
    wishes: &'a mut Vec<WorkshopWish>,
    list: &'a mut ListState,
    view: &'a mut view::ViewState,
    rect: Rect,
}

impl Behavior<Pane> for Panes<'_, '_> {
    fn pane_ui(&mut self, ui: &mut Ui, _: TileId, pane: &mut Pane) -> UiResponse {
        let rect = ui.max_rect();
        if *pane == Pane::View {
            self.rect = rect;
            view::show(ui, rect, self.model, self.view, self.wishes);
            return UiResponse::None;
        }
        ui.painter().rect_filled(rect, 0, PANEL);
        let inner = inset(rect, GRID);
        let mut ui = ui.new_child(UiBuilder::new().max_rect(inner));
        ui.set_clip_rect(rect);
        match pane {
            Pane::View => {}
            Pane::List => list::show(&mut ui, self.model, self.list, self.wishes),
            Pane::Inspector => inspector::show(&mut ui, self.model, self.wishes),
            Pane::Parts => parts::show(&mut ui, self.model, self.wishes),
            Pane::Messages => notes::messages(&mut ui, self.model, self.wishes),
            Pane::History => notes::history(&mut ui, self.model, self.wishes),
        }
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, pane: &Pane) -> WidgetText {
        let texts = self.model.texts;
        let title = texts.say(&format!("workshop-pane-{}", pane.id()));
        match pane {
            Pane::Messages if !self.model.messages.is_empty() => {
                format!("{title} ({})", self.model.messages.len()).into()
            }
            _ => title.into(),
        }
    }

    fn on_tab_button(
        &mut self,
        _: &mut Tiles<Pane>,
        _: TileId,
        response: egui::Response,
    ) -> egui::Response {
        if response.has_focus() {
            let painter = response.ctx.layer_painter(response.layer_id);
            let stroke = egui::Stroke::new(2.0, FOCUS);
            let rect = response.rect.shrink(1.0);
            painter.rect_stroke(rect, 2, stroke, egui::StrokeKind::Inside);
        }
        response
    }

    fn tab_bar_color(&self, _: &egui::Visuals) -> Color32 {
        PANEL
    }

    fn tab_bg_color(
        &self,
        _: &egui::Visuals,
        _: &Tiles<Pane>,
        _: TileId,
        state: &egui_tiles::TabState,
    ) -> Color32 {
        Color32::from_white_alpha(if state.active { 18 } else { 0 })
    }

    fn tab_text_color(
        &self,
        _: &egui::Visuals,
        _: &Tiles<Pane>,
        _: TileId,
        state: &egui_tiles::TabState,
    ) -> Color32 {
        if state.active { TEXT } else { WEAK }
    }

    fn resize_stroke(&self, _: &egui::Style, state: egui_tiles::ResizeState) -> egui::Stroke {
        match state {
            egui_tiles::ResizeState::Idle => egui::Stroke::new(1.0, LINE),
            _ => egui::Stroke::new(2.0, ACCENT),
        }
    }

    fn tab_bar_height(&self, _: &egui::Style) -> f32 {
        28.0
    }

    fn gap_width(&self, _: &egui::Style) -> f32 {
        4.0
    }

    fn simplification_options(&self) -> SimplificationOptions {
        SimplificationOptions {
            all_panes_must_have_tabs: true,
            ..SimplificationOptions::default()
        }
    }
}

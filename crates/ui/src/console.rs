//! The console: a sheet over the upper half of the picture, with what was typed and what came of it.

use antipode_language::Texts;
use egui::text::{CCursor, CCursorRange};
use egui::{
    Align, Context, Event, EventFilter, Id, Key, Label, LayerId, Layout, Order, Rect, RichText,
    Role, ScrollArea, TextEdit, Ui, UiBuilder, WidgetInfo, vec2,
};

use crate::layout::inset;
use crate::theme::{ACCENT, BAD, GRID, TEXT, WEAK, panel};

/// Lines that are kept to scroll back to.
const MOST_LINES: usize = 400;
/// Entries that the arrow keys bring back.
const MOST_ENTRIES: usize = 200;
/// Longest line that can be typed.
const LONGEST: usize = 400;

/// What kind of line it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineKind {
    /// What was typed.
    Entry,
    /// What came of it.
    Answer,
    /// Why nothing came of it.
    Problem,
}

/// How a line goes on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Completion {
    /// The line, as far as it is certain.
    pub line: String,
    /// What its last word may be, where there are several.
    pub options: Vec<String>,
}

/// The console.
#[derive(Default)]
pub struct Console {
    open: bool,
    input: String,
    lines: Vec<(String, LineKind)>,
    /// What was entered, the oldest first.
    history: Vec<String>,
    /// The entry that is shown, and what was being typed before.
    recalled: Option<(usize, String)>,
    /// The cursor is to be put at the end.
    to_end: bool,
    /// What came in after a key that ended a line, for the next frame.
    waiting: Vec<Event>,
}

impl Console {
    /// Whether it is up and takes the keys.
    pub fn is_open(&self) -> bool {
        self.open
    }

    /// Brings it up, with an empty line.
    pub fn open(&mut self) {
        self.open = true;
        self.input.clear();
        self.waiting.clear();
        self.recalled = None;
    }

    /// Takes it down; what it says is kept.
    pub fn close(&mut self) {
        self.open = false;
    }

    /// Forgets what came of it all; what was entered can still be brought back.
    pub fn clear(&mut self) {
        self.lines.clear();
    }

    /// Adds lines below the others.
    pub fn say(&mut self, text: &str, kind: LineKind) {
        let lines = text.lines().map(|line| (line.to_owned(), kind));
        self.lines.extend(lines);
        let over = self.lines.len().saturating_sub(MOST_LINES);
        self.lines.drain(..over);
    }

    /// What was entered, the oldest first.
    pub fn history(&self) -> &[String] {
        &self.history
    }

    /// Takes over what was entered in an earlier run, the oldest first.
    pub fn remember(&mut self, entries: impl IntoIterator<Item = String>) {
        for entry in entries {
            self.note(entry);
        }
    }

    /// What it covers of a screen.
    pub fn panel(screen: Rect) -> Rect {
        let height = (0.5 * screen.height()).max(screen.height().min(160.0));
        Rect::from_min_size(screen.min, vec2(screen.width(), height))
    }

    /// Draws it if it is open, and returns the line that was entered. `complete` says how a line goes on.
    pub fn show(
        &mut self,
        ctx: &Context,
        texts: &Texts,
        complete: &dyn Fn(&str) -> Completion,
    ) -> Option<String> {
        if !self.open {
            return None;
        }
        let key = self.next_key(ctx);
        let rect = Self::panel(ctx.content_rect());
        let builder = UiBuilder::new()
            .layer_id(LayerId::new(Order::Middle, Id::unique("antipode-console")))
            .max_rect(inset(rect, 1.5 * GRID));
        let mut ui = Ui::new(ctx.clone(), Id::unique("antipode-console-ui"), builder);
        ui.set_clip_rect(rect);
        ui.painter().add(panel(rect));
        ui.with_layout(Layout::bottom_up(Align::Min), |ui| {
            self.entry(ui, texts);
            ui.separator();
            let left = ui.available_size();
            ui.allocate_ui_with_layout(left, Layout::top_down(Align::Min), |ui| self.log(ui));
        });
        // Only now has the line what was typed before the key.
        key.and_then(|key| self.press(key, complete))
    }

    /// The first key of this frame that means something else here than in a line of text. What was typed after it
    /// waits for the next frame: between two frames a fast hand enters a line and begins another.
    fn next_key(&mut self, ctx: &Context) -> Option<Key> {
        let own = |event: &Event| match event {
            Event::Key {
                key: key @ (Key::ArrowUp | Key::ArrowDown | Key::Tab | Key::Enter),
                pressed: true,
                modifiers,
                ..
            } if !modifiers.any() => Some(*key),
            _ => None,
        };
        let found = ctx.input_mut(|input| {
            self.waiting.append(&mut input.events);
            // The cursor goes to the end of a line that was put there when that is drawn, and only then is typed on.
            if self.to_end {
                return None;
            }
            let place = self.waiting.iter().position(|event| own(event).is_some());
            let after = place.map_or(self.waiting.len(), |place| place + 1);
            input.events = self.waiting.drain(..after).collect();
            place.and_then(|_| input.events.pop())
        });
        let key = found.as_ref().and_then(own);
        if key.is_some() || self.to_end {
            ctx.request_repaint();
        }
        key
    }

    /// Does what such a key does; returns the line that was entered.
    fn press(&mut self, key: Key, complete: &dyn Fn(&str) -> Completion) -> Option<String> {
        match key {
            Key::ArrowUp => self.recall(true),
            Key::ArrowDown => self.recall(false),
            Key::Tab => self.complete(complete),
            _ => return self.enter(),
        }
        None
    }

    fn complete(&mut self, complete: &dyn Fn(&str) -> Completion) {
        let completion = complete(&self.input);
        self.input = completion.line;
        self.to_end = true;
        if !completion.options.is_empty() {
            self.say(&completion.options.join("   "), LineKind::Answer);
        }
    }

    fn enter(&mut self) -> Option<String> {
        let line = std::mem::take(&mut self.input).trim().to_owned();
        self.recalled = None;
        if line.is_empty() {
            return None;
        }
        self.say(&line, LineKind::Entry);
        self.note(line.clone());
        Some(line)
    }

    fn note(&mut self, line: String) {
        if self.history.last() != Some(&line) {
            self.history.push(line);
        }
        let over = self.history.len().saturating_sub(MOST_ENTRIES);
        self.history.drain(..over);
    }

    /// Brings back an older entry, or a newer one and at last what was being typed.
    fn recall(&mut self, older: bool) {
        let (place, typed) = match self.recalled.take() {
            Some((place, typed)) => (place, typed),
            None => (self.history.len(), self.input.clone()),
        };
        let place = if older {
            place.saturating_sub(1)
        } else {
            (place + 1).min(self.history.len())
        };
        if let Some(entry) = self.history.get(place) {
            self.input.clone_from(entry);
            self.recalled = Some((place, typed));
        } else {
            self.input = typed;
        }
        self.to_end = true;
    }

    fn entry(&mut self, ui: &mut Ui, texts: &Texts) {
        ui.horizontal(|ui| {
            ui.label(RichText::new(">").monospace().color(ACCENT));
            let filter = EventFilter {
                tab: true,
                horizontal_arrows: true,
                vertical_arrows: true,
                ..Default::default()
            };
            let mut output = TextEdit::singleline(&mut self.input)
                .font(egui::TextStyle::Monospace)
                .hint_text(texts.say("console-hint"))
                .char_limit(LONGEST)
                .desired_width(f32::INFINITY)
                .event_filter(filter)
                .show(ui);
            let name = texts.say("console-entry");
            let response = &output.response;
            response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, &name));
            // Nothing else here takes keys.
            response.request_focus();
            if std::mem::take(&mut self.to_end) {
                let end = CCursor::new(self.input.chars().count());
                output
                    .state
                    .cursor
                    .set_char_range(Some(CCursorRange::one(end)));
                output.state.store(ui.ctx(), output.response.id);
            }
        });
    }

    fn log(&self, ui: &mut Ui) {
        let page = ui.available_height() - 2.0 * GRID;
        let pages = ui.input(|input| {
            let pressed = |key, amount: f32| if input.key_pressed(key) { amount } else { 0.0 };
            pressed(Key::PageUp, 1.0) + pressed(Key::PageDown, -1.0)
        });
        ScrollArea::vertical()
            .auto_shrink(false)
            .stick_to_bottom(true)
            .show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 2.0;
                if pages != 0.0 {
                    ui.scroll_with_delta(vec2(0.0, pages * page));
                }
                for (text, kind) in &self.lines {
                    let (mark, colour) = match kind {
                        LineKind::Entry => ("> ", WEAK),
                        LineKind::Answer => ("", TEXT),
                        LineKind::Problem => ("", BAD),
                    };
                    let words = RichText::new(format!("{mark}{text}"))
                        .monospace()
                        .color(colour);
                    ui.add(Label::new(words).wrap());
                }
            });
    }
}

//! The question for a flag's name, over the world that goes on behind it.

use antipode_language::Texts;
use egui::{Context, FontId, Id, Key, LayerId, Order, Rect, RichText, Ui, UiBuilder, vec2};

use crate::entry;
use crate::layout::inset;
use crate::theme::{GRID, panel};
use crate::widgets::{button, primary_button};

/// Size where there is room, in points.
const SIZE: egui::Vec2 = vec2(420.0, 148.0);

/// The question, and what has been typed so far.
#[derive(Debug, Default)]
pub struct Naming {
    text: Option<String>,
    /// The line has not been given the keys yet.
    is_new: bool,
}

impl Naming {
    /// Whether it is up and takes the keys.
    pub fn is_open(&self) -> bool {
        self.text.is_some()
    }

    /// Brings it up with the name that there is.
    pub fn open(&mut self, name: &str) {
        self.text = Some(name.to_owned());
        self.is_new = true;
    }

    /// Takes it down, and returns whether it was up.
    pub fn close(&mut self) -> bool {
        self.text.take().is_some()
    }

    /// What it covers of a screen.
    pub fn panel(screen: Rect) -> Rect {
        let room = inset(screen, GRID);
        let size = SIZE.min(room.size());
        let centre = room.center() - vec2(0.0, 0.2 * room.height());
        let low = room.min + 0.5 * size;
        Rect::from_center_size(centre.max(low), size)
    }

    /// Draws it if it is up, with room for so many characters. Returns the name that is given; it is down then, and where
    /// the player leaves the one that there is.
    pub fn show(&mut self, ctx: &Context, texts: &Texts, longest: usize) -> Option<String> {
        let text = self.text.as_mut()?;
        let rect = Self::panel(ctx.content_rect());
        let builder = UiBuilder::new()
            .layer_id(LayerId::new(Order::Middle, Id::unique("antipode-naming")))
            .max_rect(inset(rect, 2.0 * GRID));
        let mut ui = Ui::new(ctx.clone(), Id::unique("antipode-naming-ui"), builder);
        ui.set_clip_rect(rect);
        ui.painter().add(panel(rect));
        let title = texts.say("flag-name-title");
        ui.label(RichText::new(title).font(FontId::proportional(20.0)));
        ui.add_space(0.5 * GRID);
        let name = texts.say("flag-name");
        let line = entry::named_line(&mut ui, text, &name, &name, longest);
        if std::mem::take(&mut self.is_new) {
            line.request_focus();
        }
        // In a line the key ends it, and on a button it presses that.
        let entered = line.lost_focus() && ctx.input(|input| input.key_pressed(Key::Enter));
        ui.add_space(GRID);
        let (mut taken, mut kept) = (false, false);
        ui.horizontal(|ui| {
            taken = primary_button(ui, &texts.say("ok"), true).clicked();
            kept = button(ui, &texts.say("flag-name-keep")).clicked();
        });
        if kept {
            self.close();
            return None;
        }
        (taken || entered).then(|| self.text.take()).flatten()
    }
}

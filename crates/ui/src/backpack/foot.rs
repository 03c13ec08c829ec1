//! What stands round the slots or what can be made: the title, the help, and the buttons that throw away, turn the page
//! and close.

use antipode_language::Texts;
use egui::{Context, Rect, RichText, TextStyle, Ui, UiBuilder};

use super::layout::Places;
use super::{Backpack, BackpackModel, BackpackWish};
use crate::theme::{WEAK, small};
use crate::widgets::button;

/// Width from which on there is room for three buttons of the usual size, in points.
const THREE: f32 = 380.0;

/// What the buttons cover; something may be dragged to one of them.
pub(super) struct Buttons {
    pub throw: Rect,
    /// All of them together.
    pub all: Rect,
}

impl Backpack {
    /// Turns from the slots to what can be made, or back; what is at the pointer stays there.
    fn turn(&mut self, ctx: &Context) {
        self.makes = !self.makes;
        self.fresh = true;
        self.presses.end_drag();
        ctx.request_repaint();
    }

    /// The title, and of the slots what the mouse or the keys do.
    pub(super) fn head(&self, ui: &mut Ui, places: &Places, texts: &Texts) {
        if let Some(title) = places.title {
            let key = if self.makes {
                "backpack-make"
            } else {
                "backpack-title"
            };
            let mut head = ui.new_child(UiBuilder::new().id_salt("title").max_rect(title));
            head.label(RichText::new(texts.say(key)).heading());
        }
        if let Some(help) = places.help.filter(|_| !self.makes) {
            let key = if self.by_keys {
                "backpack-how-keys"
            } else {
                "backpack-how"
            };
            let words = RichText::new(texts.say(key)).font(small()).color(WEAK);
            let mut below = ui.new_child(UiBuilder::new().id_salt("how").max_rect(help));
            below.set_clip_rect(help);
            below.add(egui::Label::new(words).wrap());
        }
    }

    /// The buttons below; what they cover.
    pub(super) fn foot(
        &mut self,
        ui: &mut Ui,
        places: &Places,
        model: &BackpackModel<'_>,
        takes_focus: bool,
        wishes: &mut Vec<BackpackWish>,
    ) -> Buttons {
        let texts = model.texts;
        let mut foot = ui.new_child(UiBuilder::new().id_salt("foot").max_rect(places.foot));
        foot.spacing_mut().interact_size.y = places.foot.height();
        foot.spacing_mut().button_padding.y = 0.0;
        if model.making.is_some() && places.foot.width() < THREE {
            foot.spacing_mut().button_padding.x = 6.0;
            let styles = &mut foot.style_mut().text_styles;
            styles.insert(TextStyle::Button, small());
        }
        let row = foot.horizontal(|ui| {
            let throw = ui
                .add_enabled_ui(model.carried.is_some(), |ui| {
                    button(ui, &texts.say("backpack-throw"))
                })
                .inner;
            if throw.clicked() {
                wishes.push(BackpackWish::LetGo { whole: true });
            }
            let turn = model.making.map(|_| {
                let key = if self.makes {
                    "backpack-slots"
                } else {
                    "backpack-make"
                };
                button(ui, &texts.say(key))
            });
            let close = button(ui, &texts.say("backpack-close"));
            if close.clicked() {
                wishes.push(BackpackWish::Close);
            }
            if takes_focus {
                let first = [Some(&throw), turn.as_ref()].into_iter().flatten();
                let first = first.into_iter().find(|it| it.enabled());
                first.unwrap_or(&close).request_focus();
            }
            if turn.is_some_and(|turn| turn.clicked()) {
                self.turn(ui.ctx());
            }
            throw.rect
        });
        Buttons {
            throw: row.inner,
            all: row.response.rect,
        }
    }
}

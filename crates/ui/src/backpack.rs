//! The backpack over the running world. It shows all slots and the stack at the pointer, and returns what the player
//! asks for. The game owns the items and decides what happens.

mod layout;
mod pointer;
mod tip;

use antipode_language::Texts;
use egui::{
    Context, Event, EventFilter, Id, Key, LayerId, Modifiers, Order, Rect, Response, RichText,
    Role, Sense, Ui, UiBuilder, WidgetInfo,
};

use crate::hud::{SlotView, hotbar};
use crate::theme::{SCRIM, WEAK, panel, small};
use crate::widgets::{button, focus_ring};
use layout::Places;
use pointer::Presses;

/// Slots of the hotbar, and with the backpack's.
const HOTBAR: u8 = 10;
const SLOTS: u8 = 40;

/// What the screen shows.
pub struct BackpackModel<'a> {
    /// The words of the player's language.
    pub texts: &'a Texts,
    /// All forty slots: those of the hotbar, then the backpack's line by line.
    pub slots: &'a [SlotView],
    /// Index of the slot in hand, from 0.
    pub selected: u8,
    /// What is at the pointer.
    pub carried: Option<&'a SlotView>,
}

/// What the player asked for; slots count from 0, those of the hotbar first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BackpackWish {
    /// The main button on a slot: take, put down, merge, swap.
    Click(u8),
    /// The other button on a slot: take half, put one down.
    ClickOther(u8),
    /// Send a stack from the hotbar to the backpack, or back.
    Send(u8),
    /// A stack was dragged onto a slot; onto one past the last where it goes back to where it came from.
    EndDrag(u8),
    /// Swap a slot with one of the hotbar.
    Swap(u8, u8),
    /// Throw away what is at the pointer, or one of it.
    LetGo {
        /// All of it.
        whole: bool,
    },
    /// Throw away one of what lies in a slot.
    Throw(u8),
    /// Close the backpack.
    Close,
}

/// The screen's own state.
#[derive(Debug, Default)]
pub struct Backpack {
    open: bool,
    /// It has not been drawn yet: a slot takes the focus then.
    fresh: bool,
    /// Whether the player last used keys rather than the pointer.
    by_keys: bool,
    /// The slot that keys speak of: under the pointer, or with the focus.
    at: Option<u8>,
    presses: Presses,
    /// What keys have asked for since the last frame.
    asked: Vec<BackpackWish>,
}

impl Backpack {
    /// Whether it is up and takes keys and pointer.
    pub fn is_open(&self) -> bool {
        self.open
    }

    /// Brings it up.
    pub fn open(&mut self) {
        *self = Self {
            open: true,
            fresh: true,
            ..Self::default()
        };
    }

    /// Takes it down; what is at the pointer is the game's to put back.
    pub fn close(&mut self) {
        self.open = false;
    }

    /// Asks to swap the slot that is pointed at with one of the hotbar, from 0.
    pub fn swap_with(&mut self, hotbar: u8) {
        if let Some(slot) = self.at.filter(|_| hotbar < HOTBAR) {
            self.asked.push(BackpackWish::Swap(slot, hotbar));
        }
    }

    /// Asks to throw one away: of what is at the pointer, else of the slot that is pointed at.
    pub fn throw_one(&mut self, carries: bool) {
        if carries {
            self.asked.push(BackpackWish::LetGo { whole: false });
        } else if let Some(slot) = self.at {
            self.asked.push(BackpackWish::Throw(slot));
        }
    }

    /// What it covers of a screen.
    pub fn panel(screen: Rect) -> Rect {
        Places::new(screen).panel
    }

    /// Draws it if it is open, and returns what the player asked for, in order.
    pub fn show(&mut self, ctx: &Context, model: &BackpackModel<'_>) -> Vec<BackpackWish> {
        if !self.open {
            return Vec::new();
        }
        let mut wishes = std::mem::take(&mut self.asked);
        let screen = ctx.content_rect();
        let places = Places::new(screen);
        self.note_device(ctx);
        let builder = UiBuilder::new()
            .layer_id(LayerId::new(Order::Middle, Id::unique("antipode-backpack")))
            .max_rect(screen);
        let mut ui = Ui::new(ctx.clone(), Id::unique("antipode-backpack-ui"), builder);
        ui.painter().rect_filled(screen, 0, SCRIM);
        ui.painter().add(panel(places.panel));
        // What lies below takes none of what is meant for this.
        ui.interact(
            screen,
            Id::unique("antipode-backpack-ground"),
            Sense::click_and_drag(),
        );
        self.at = None;
        let mut focused = None;
        for slot in 0..SLOTS {
            let response = self.slot(&mut ui, &places, model, slot, &mut wishes);
            focused = focused.or(response.has_focus().then_some((slot, response)));
        }
        // Once all are there: a slot that gets the focus now would hand it on.
        let leaves = focused.is_some_and(|(slot, response)| walk(&ui, slot, &response));
        self.fresh = false;
        let buttons = self.foot(&mut ui, &places, model, leaves, &mut wishes);
        let carries = model.carried.is_some();
        wishes.extend(
            self.presses
                .take(ctx, &places, &buttons, carries, model.slots),
        );
        self.show_at_pointer(ctx, &places, model);
        wishes
    }

    fn note_device(&mut self, ctx: &Context) {
        ctx.input(|input| {
            for event in &input.events {
                match event {
                    Event::Key { pressed: true, .. } => self.by_keys = true,
                    Event::PointerMoved(_) | Event::PointerButton { .. } => self.by_keys = false,
                    _ => {}
                }
            }
        });
    }

    fn slot(
        &mut self,
        ui: &mut Ui,
        places: &Places,
        model: &BackpackModel<'_>,
        slot: u8,
        wishes: &mut Vec<BackpackWish>,
    ) -> Response {
        let rect = places.slot(slot);
        let response = ui.interact(rect, id(slot), Sense::click());
        let empty = SlotView::default();
        let view = model.slots.get(usize::from(slot)).unwrap_or(&empty);
        let name = slot_name(model.texts, slot, view);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        let in_hand = slot == model.selected;
        hotbar::frame(ui.painter(), rect, in_hand);
        hotbar::contents(ui.painter(), rect, view);
        if slot < HOTBAR {
            hotbar::number(ui.painter(), rect, usize::from(slot), in_hand);
        }
        if self.fresh && in_hand {
            response.request_focus();
        }
        focus_ring(ui, &response);
        if (self.by_keys && response.has_focus()) || (!self.by_keys && response.hovered()) {
            self.at = Some(slot);
        }
        // The pointer's clicks are followed on their own, since they may be drags; this is a key or a screen reader.
        if response.clicked() && !response.clicked_by(egui::PointerButton::Primary) {
            wishes.push(by_key(ui, slot));
        }
        response
    }

    /// The buttons below, and what the mouse or the keys do; what the buttons cover.
    fn foot(
        &mut self,
        ui: &mut Ui,
        places: &Places,
        model: &BackpackModel<'_>,
        takes_focus: bool,
        wishes: &mut Vec<BackpackWish>,
    ) -> Buttons {
        let texts = model.texts;
        if let Some(title) = places.title {
            let mut head = ui.new_child(UiBuilder::new().id_salt("title").max_rect(title));
            head.label(RichText::new(texts.say("backpack-title")).heading());
        }
        if let Some(help) = places.help {
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
        let mut foot = ui.new_child(UiBuilder::new().id_salt("foot").max_rect(places.foot));
        foot.spacing_mut().interact_size.y = places.foot.height();
        foot.spacing_mut().button_padding.y = 0.0;
        foot.horizontal(|ui| {
            let throw = ui
                .add_enabled_ui(model.carried.is_some(), |ui| {
                    button(ui, &texts.say("backpack-throw"))
                })
                .inner;
            if throw.clicked() {
                wishes.push(BackpackWish::LetGo { whole: true });
            }
            let close = button(ui, &texts.say("backpack-close"));
            if close.clicked() {
                wishes.push(BackpackWish::Close);
            }
            if takes_focus {
                let first = if throw.enabled() { &throw } else { &close };
                first.request_focus();
            }
            Buttons { throw: throw.rect }
        })
        .inner
    }

    /// The stack at the pointer, or by the slot with the focus; without one, what lies in the slot pointed at.
    fn show_at_pointer(&self, ctx: &Context, places: &Places, model: &BackpackModel<'_>) {
        let at = self.at.map(|slot| places.slot(slot));
        let painter =
            ctx.layer_painter(LayerId::new(Order::Tooltip, Id::unique("antipode-carried")));
        match (model.carried, at, self.by_keys) {
            (Some(carried), Some(at), true) => {
                let half = 0.5 * at.width();
                hotbar::contents(&painter, at.translate(egui::vec2(half, -half)), carried);
            }
            (Some(carried), _, _) => {
                let pointer = ctx.pointer_latest_pos().unwrap_or(places.panel.center());
                let side = places.slot(0).size();
                hotbar::contents(&painter, Rect::from_center_size(pointer, side), carried);
            }
            (None, Some(at), _) => {
                let slot = self.at.map(usize::from);
                if let Some(view) = slot.and_then(|slot| model.slots.get(slot)) {
                    tip::show(&painter, ctx.content_rect(), at, model.texts, view);
                }
            }
            (None, None, _) => {}
        }
    }
}

/// What the buttons cover that something may be dragged to.
struct Buttons {
    throw: Rect,
}

fn id(slot: u8) -> Id {
    Id::unique(("antipode-backpack-slot", slot))
}

/// What a slot is called for those who do not see it.
fn slot_name(texts: &Texts, slot: u8, view: &SlotView) -> String {
    let number = (slot + 1).into();
    if view.item.is_none() {
        return texts.say_with("backpack-slot-empty", &[("number", number)]);
    }
    let item = item_name(texts, view).into();
    texts.say_with("backpack-slot", &[("number", number), ("item", item)])
}

/// A thing and how many of it.
fn item_name(texts: &Texts, view: &SlotView) -> String {
    match view.count {
        None => view.label.clone(),
        Some(count) => {
            let values = [
                ("item", view.label.as_str().into()),
                ("count", count.into()),
            ];
            texts.say_with("backpack-item", &values)
        }
    }
}

/// Moves the focus along the slots by the arrow keys. Whether it leaves them, below the last line, for the buttons.
fn walk(ui: &Ui, slot: u8, response: &Response) -> bool {
    let last_line = slot < HOTBAR;
    let lock = EventFilter {
        horizontal_arrows: true,
        vertical_arrows: true,
        ..Default::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, lock));
    let presses = |key| ui.input(|input| input.num_presses(key) as i32);
    let by = [
        presses(Key::ArrowRight) - presses(Key::ArrowLeft),
        presses(Key::ArrowDown) - presses(Key::ArrowUp),
    ];
    if by == [0, 0] {
        return false;
    }
    // In the first frame of a focus the lock does not hold yet, and egui would move it on.
    ui.memory_mut(|memory| memory.move_focus(egui::FocusDirection::None));
    let leaves = last_line && by[1] > 0;
    if !leaves {
        ui.memory_mut(|memory| memory.request_focus(id(layout::beside(slot, by))));
    }
    leaves
}

/// What Enter on a slot asks for, with what is held beside it.
fn by_key(ui: &Ui, slot: u8) -> BackpackWish {
    let held = ui.input(|input| {
        let enter = |event: &Event| match event {
            Event::Key {
                key: Key::Enter | Key::Space,
                pressed: true,
                modifiers,
                ..
            } => Some(*modifiers),
            _ => None,
        };
        input.events.iter().find_map(enter).unwrap_or_default()
    });
    wish(slot, held)
}

/// What the main button, or Enter, asks for on a slot.
fn wish(slot: u8, held: Modifiers) -> BackpackWish {
    if held.shift {
        BackpackWish::Send(slot)
    } else if held.command || held.ctrl {
        BackpackWish::ClickOther(slot)
    } else {
        BackpackWish::Click(slot)
    }
}

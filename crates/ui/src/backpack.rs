//! The backpack over the running world. It shows all slots, or what can be made of ground, and the stack at the pointer,
//! and returns what the player asks for. The game owns the items and decides what happens.

mod foot;
mod layout;
mod making;
mod pointer;
mod tip;

use antipode_language::Texts;
use egui::{
    Context, Event, EventFilter, Id, Key, LayerId, Modifiers, Order, Rect, Response, Role, Sense,
    Ui, UiBuilder, WidgetInfo,
};

use crate::hud::{SlotView, hotbar};
use crate::layout::Stops;
use crate::theme::{SCRIM, panel};
use crate::widgets::focus_ring;
use foot::Buttons;
use layout::Places;
pub use making::{EarthView, MakingModel, PartView, RecipeView};
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
    /// What can be made of ground; none where nothing is.
    pub making: Option<&'a MakingModel>,
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
    /// Make what the recipe at that index of [`MakingModel::recipes`] is of; it is possible.
    Make(usize),
    /// Close the backpack.
    Close,
}

/// The screen's own state.
#[derive(Debug, Default)]
pub struct Backpack {
    open: bool,
    /// Whether what can be made is shown in place of the slots.
    makes: bool,
    /// What is shown has not been drawn yet: a slot or a recipe takes the focus then.
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
        let making = model.making.filter(|_| self.makes);
        self.makes = making.is_some();
        let mut places = Places::new(screen);
        places.has_slots = making.is_none();
        self.note_device(ctx);
        if model.making.is_some() {
            drop_repeats(ctx);
        }
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
        self.head(&mut ui, &places, model.texts);
        let fresh = self.fresh;
        let (mut stops, mut leaves) = (None, false);
        if let Some(making) = making {
            let (rows, asked) = making::show(&mut ui, places.page, model.texts, making, fresh);
            wishes.extend(asked.map(BackpackWish::Make));
            stops = Some(rows);
        } else {
            leaves = self.slots(&mut ui, &places, model, &mut wishes);
        }
        self.fresh = false;
        let buttons = self.foot(&mut ui, &places, model, leaves, &mut wishes);
        if let Some(stops) = stops {
            stops.step(&ui, &Stops::within(&ui, buttons.all));
        }
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

    /// All slots; whether the focus leaves them for the buttons below.
    fn slots(
        &mut self,
        ui: &mut Ui,
        places: &Places,
        model: &BackpackModel<'_>,
        wishes: &mut Vec<BackpackWish>,
    ) -> bool {
        let mut focused = None;
        for slot in 0..SLOTS {
            let response = self.slot(ui, places, model, slot, wishes);
            focused = focused.or(response.has_focus().then_some((slot, response)));
        }
        // Once all are there: a slot that gets the focus now would hand it on.
        focused.is_some_and(|(slot, response)| walk(ui, slot, &response))
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
            // Beside the buttons, where it lies on no words.
            (Some(carried), None, true) if self.makes => {
                let side = egui::Vec2::splat(places.foot.height());
                let corner = places.foot.right_top() - egui::vec2(side.x, 0.0);
                hotbar::contents(&painter, Rect::from_min_size(corner, side), carried);
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

/// Forgets repeats of keys that press: the press that turns the page, held a little long, would spend what is carried on
/// what has the focus there.
fn drop_repeats(ctx: &Context) {
    let repeats = |event: &Event| {
        matches!(
            event,
            Event::Key {
                key: Key::Enter | Key::Space,
                repeat: true,
                ..
            }
        )
    };
    ctx.input_mut(|input| input.events.retain(|event| !repeats(event)));
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

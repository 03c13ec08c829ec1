//! The backpack in the game: the world goes on behind it while keys and pointer move what is carried.

use antipode_scene::Scene;
use antipode_settings::Lesson;
use antipode_ui::{BackpackModel, BackpackWish, SlotView};

use super::game::Game;
use super::phase::Phase;
use crate::bindings::{Action, Input};
use crate::hud;

impl Game {
    /// Whether the backpack is up and has keys and pointer.
    pub fn is_packing(&self) -> bool {
        self.backpack.is_open()
    }

    pub(super) fn open_backpack(&mut self) {
        self.controls.release_all();
        self.has_done(Lesson::Backpack);
        self.backpack.open();
    }

    /// Takes the backpack down. What is at the pointer goes back into the slots; what finds no room there is thrown
    /// away, and can be picked up again.
    pub(super) fn close_backpack(&mut self) {
        if !self.is_packing() {
            return;
        }
        self.backpack.close();
        self.controls.release_all();
        if let Some(session) = self.phase.session_mut()
            && let Some(left) = session.scene.inventory_mut().put_back()
        {
            session.scene.throw_away(left);
        }
    }

    /// A key or button while the backpack is up. Returns whether it was meant for it and is nobody else's.
    pub fn backpack_key(&mut self, input: Input) -> bool {
        let does = |action| self.controls.does(input, action);
        if does(Action::Backpack) || does(Action::Menu) {
            self.close_backpack();
            return true;
        }
        if does(Action::Drop) {
            let session = self.phase.session();
            let carried = session.and_then(|session| session.scene.inventory().carried());
            self.backpack.throw_one(carried.is_some());
            return true;
        }
        let slot = (0..antipode_scene::inventory::HOTBAR_SLOTS)
            .find(|slot| self.controls.does(input, Action::Slot(*slot)));
        if let Some(slot) = slot {
            self.backpack.swap_with(slot);
        }
        slot.is_some()
    }

    /// Draws the backpack and does what is asked for there.
    pub(super) fn show_backpack(&mut self, context: &egui::Context) {
        if !self.is_packing() {
            return;
        }
        let Phase::Playing(session) = &mut self.phase else {
            return;
        };
        let inventory = session.scene.inventory();
        let view = |stack| hud::slot(&self.menus.texts, stack);
        let slots: Vec<SlotView> = inventory.slots().iter().copied().map(view).collect();
        let carried = inventory.carried().map(|stack| view(Some(stack)));
        let model = BackpackModel {
            texts: &self.menus.texts,
            slots: &slots,
            selected: inventory.selected(),
            carried: carried.as_ref(),
        };
        let wishes = self.backpack.show(context, &model);
        let mut closes = false;
        for wish in wishes {
            closes |= wish == BackpackWish::Close;
            follow(&mut session.scene, wish);
        }
        if closes {
            self.close_backpack();
        }
    }
}

/// Moves what is carried as the player asked.
fn follow(scene: &mut Scene, wish: BackpackWish) {
    tracing::debug!("in the backpack: {wish:?}");
    let inventory = scene.inventory_mut();
    let thrown = match wish {
        BackpackWish::Click(slot) => {
            inventory.click(slot);
            None
        }
        BackpackWish::ClickOther(slot) => {
            inventory.click_other(slot);
            None
        }
        BackpackWish::Send(slot) => {
            inventory.send(slot);
            None
        }
        BackpackWish::EndDrag(slot) => {
            inventory.end_drag(slot);
            None
        }
        BackpackWish::Swap(slot, hotbar) => {
            inventory.swap(slot, hotbar);
            None
        }
        BackpackWish::LetGo { whole } => inventory.let_go(whole),
        BackpackWish::Throw(slot) => inventory.take_from(slot, false),
        BackpackWish::Close => None,
    };
    if let Some(stack) = thrown {
        scene.throw_away(stack);
    }
}

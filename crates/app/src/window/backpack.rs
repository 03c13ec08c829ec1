//! The backpack in the game: the world goes on behind it while keys and pointer move what is carried.

use antipode_language::Texts;
use antipode_scene::inventory::HOTBAR_SLOTS;
use antipode_scene::{Recipe, Scene};
use antipode_ui::{BackpackModel, BackpackWish, SlotView};

use super::devices::Devices;
use super::phase::Phase;
use super::play::Play;
use super::press::{Press, Taken};
use crate::bindings::{Action, Input};
use crate::{hud, hud_brush};

/// The backpack, up or not.
#[derive(Default)]
pub struct Backpack(pub(super) antipode_ui::Backpack);

impl Backpack {
    /// Brings it up.
    pub fn open(&mut self, devices: &mut Devices) {
        devices.release_all();
        self.0.open();
    }

    /// Takes it down, and returns whether it was up. What is at the pointer goes back into the slots; what finds no room
    /// there is thrown away, and can be picked up again.
    pub fn close(&mut self, devices: &mut Devices, play: &mut Play) -> bool {
        if !self.0.is_open() {
            return false;
        }
        self.0.close();
        devices.release_all();
        if let Some(session) = play.phase.session_mut()
            && let Some(left) = session.scene.inventory_mut().put_back()
        {
            session.scene.throw_away(left);
        }
        true
    }

    /// The layer of the backpack. The buttons of a mouse work in it, but for one that closes it; a pad's are translated to
    /// keys.
    pub fn press(&mut self, press: &Press, devices: &mut Devices, play: &mut Play) -> Taken {
        let input = press.fresh().filter(|input| match input {
            Input::Key(_) => true,
            Input::Mouse(_) => devices.controls.does(*input, Action::Backpack),
            _ => false,
        });
        Taken::if_true(input.is_some_and(|input| self.input(input, devices, play)))
    }

    /// A key or button goes down. Returns whether it was meant for the backpack, which is up, and is nobody else's.
    pub fn input(&mut self, input: Input, devices: &mut Devices, play: &mut Play) -> bool {
        let does = |action| devices.controls.does(input, action);
        if !self.0.is_open() {
            return false;
        }
        if does(Action::Backpack) || does(Action::Menu) {
            return self.close(devices, play);
        }
        if does(Action::Drop) {
            let session = play.phase.session();
            let carried = session.and_then(|session| session.scene.inventory().carried());
            self.0.throw_one(carried.is_some());
            return true;
        }
        let slot = (0..HOTBAR_SLOTS).find(|slot| does(Action::Slot(*slot)));
        if let Some(slot) = slot {
            self.0.swap_with(slot);
        }
        slot.is_some()
    }

    /// Draws it and does what is asked for there.
    pub fn show(
        &mut self,
        context: &egui::Context,
        texts: &Texts,
        devices: &mut Devices,
        play: &mut Play,
    ) {
        let session = match &mut play.phase {
            Phase::Playing(session) if self.0.is_open() => session,
            _ => return,
        };
        let inventory = session.scene.inventory();
        let view = |stack| hud::slot(texts, stack);
        let slots: Vec<SlotView> = inventory.slots().iter().copied().map(view).collect();
        let carried = inventory.carried().map(|stack| view(Some(stack)));
        let making = hud_brush::making(texts, &session.scene);
        let model = BackpackModel {
            texts,
            making: making.as_ref(),
            slots: &slots,
            selected: inventory.selected(),
            carried: carried.as_ref(),
        };
        let wishes = self.0.show(context, &model);
        let closes = wishes.contains(&BackpackWish::Close);
        for wish in wishes {
            follow(&mut session.scene, wish);
        }
        if closes {
            self.close(devices, play);
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
        BackpackWish::Make(at) => {
            if let Some(recipe) = Recipe::all().get(at) {
                scene.make(recipe);
            }
            None
        }
        BackpackWish::Close => None,
    };
    if let Some(stack) = thrown {
        scene.throw_away(stack);
    }
}

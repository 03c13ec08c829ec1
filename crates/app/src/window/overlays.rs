//! The overlays over the open world, which take keys and pointer while they are up: console, backpack, photo mode and the
//! question for a flag's name.

use antipode_ui::{Console, photo_panel};
use egui::Rect;

use super::backpack::Backpack;
use super::console::ConsoleLayer;
use super::devices::Devices;
use super::menus::Menus;
use super::naming::Naming;
use super::photo::Photographer;
use super::play::Play;

/// All of them, up or not.
#[derive(Default)]
pub struct Overlays {
    pub(super) console: ConsoleLayer,
    pub(super) backpack: Backpack,
    pub(super) photo: Photographer,
    pub(super) naming: Naming,
}

impl Overlays {
    /// Whether the console is up.
    pub fn is_typing(&self) -> bool {
        self.console.view.is_open()
    }

    /// Whether the photo mode is on: the world stands still, keys fly the camera or belong to the panel.
    pub fn is_photographing(&self) -> bool {
        self.photo.is_on()
    }

    /// Whether the backpack is up.
    pub fn is_packing(&self) -> bool {
        self.backpack.0.is_open()
    }

    /// Whether a flag's name is asked for.
    pub fn is_naming(&self) -> bool {
        self.naming.is_open()
    }

    /// Whether anything is up.
    pub fn are_up(&self) -> bool {
        self.is_typing() || self.is_photographing() || self.is_packing() || self.is_naming()
    }

    /// Takes everything down, since the world is left or paused.
    pub fn close_all(&mut self, devices: &mut Devices, play: &mut Play, menus: &mut Menus) {
        self.console.view.close();
        self.photo.leave(devices, play, menus);
        self.backpack.close(devices, play);
        self.naming.close();
    }

    /// Leads back from what is up. Returns whether anything was.
    pub fn escape(&mut self, devices: &mut Devices, play: &mut Play, menus: &mut Menus) -> bool {
        if self.is_typing() || self.is_photographing() {
            self.console.view.close();
            self.photo.leave(devices, play, menus);
            return true;
        }
        self.naming.close() || self.backpack.close(devices, play)
    }

    /// What lies on the world while no menu does.
    pub fn covered(&self, screen: Rect) -> Option<Rect> {
        if self.is_typing() {
            Some(Console::panel(screen))
        } else if self.is_packing() {
            Some(antipode_ui::Backpack::panel(screen))
        } else if self.is_naming() {
            Some(antipode_ui::Naming::panel(screen))
        } else {
            self.is_photographing().then(|| photo_panel(screen))
        }
    }
}

//! The name of a flag in the game: asked for where the player clicks on one, while the world goes on.

use antipode_language::Texts;
use antipode_scene::actors::ActorId;
use antipode_scene::flag::LONGEST_NAME;
use antipode_ui::Named;

use super::devices::Devices;
use super::phase::Phase;
use super::play::Play;

/// The question, up or not, and which flag it is about.
#[derive(Default)]
pub struct Naming {
    view: antipode_ui::Naming,
    flag: Option<ActorId>,
}

impl Naming {
    /// Whether it is up.
    pub fn is_open(&self) -> bool {
        self.view.is_open()
    }

    /// Takes it down, and returns whether it was up.
    pub fn close(&mut self) -> bool {
        self.view.close()
    }

    /// Brings it up if the player has clicked on a flag, shows it, and does what is answered.
    pub fn show(
        &mut self,
        context: &egui::Context,
        texts: &Texts,
        devices: &mut Devices,
        play: &mut Play,
    ) {
        let Phase::Playing(session) = &mut play.phase else {
            return;
        };
        let scene = &mut session.scene;
        if let Some(id) = scene.take_flag_to_name() {
            let ways = scene.flag_ways();
            if let Some(way) = ways.iter().find(|way| way.id == id) {
                devices.release_all();
                self.view.open(&way.name);
                self.flag = Some(id);
            }
        }
        if let Some(Named::As(name)) = self.view.show(context, texts, LONGEST_NAME)
            && let Some(id) = self.flag
        {
            scene.name_flag(id, &name);
        }
    }
}

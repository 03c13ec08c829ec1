//! The name of a flag in the game: asked for where the player clicks on one, while the world goes on.

use antipode_language::Texts;
use antipode_scene::actors::ActorId;
use antipode_scene::flag::LONGEST_NAME;

use super::devices::Devices;
use super::phase::Phase;
use super::play::Play;
use super::press::{Press, Taken};

/// The question, up or not, and which flag it is about.
#[derive(Default)]
pub struct Naming {
    view: antipode_ui::Naming,
    flag: Option<ActorId>,
    /// No key has gone down since it came up: those that repeat were held before, to walk.
    is_untouched: bool,
}

impl Naming {
    /// Whether it is up.
    pub fn is_open(&self) -> bool {
        self.view.is_open()
    }

    /// Takes it down, and returns whether it was up.
    pub fn close(&mut self) -> bool {
        self.flag = None;
        self.view.close()
    }

    /// The layer of the question: what is held from before it came up is not typed into it.
    pub fn press(&mut self, press: &Press) -> Taken {
        if press.down && !press.repeats {
            self.is_untouched = false;
        }
        Taken::if_true(self.is_open() && self.is_untouched && press.down)
    }

    /// Brings it up if the player has clicked on a flag and nothing else is up.
    pub fn ask(&mut self, is_free: bool, devices: &mut Devices, play: &mut Play) {
        let Some(session) = play.phase.session_mut() else {
            return;
        };
        let scene = &mut session.scene;
        let asked = scene.take_flag_to_name().filter(|_| is_free);
        let ways = asked.map_or(Vec::new(), |_| scene.flag_ways());
        if let Some(way) = ways.iter().find(|way| Some(way.id) == asked) {
            devices.release_all();
            self.view.open(&way.name);
            self.flag = asked;
            self.is_untouched = true;
        }
    }

    /// Shows it, and does what is answered.
    pub fn show(&mut self, context: &egui::Context, texts: &Texts, play: &mut Play) {
        let Phase::Playing(session) = &mut play.phase else {
            return;
        };
        if let Some(name) = self.view.show(context, texts, LONGEST_NAME)
            && let Some(id) = self.flag.take()
        {
            session.scene.name_flag(id, &name);
        }
    }
}

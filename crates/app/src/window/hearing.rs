//! Connects the game in its window to the sound: hands over what there is to hear, and follows the settings.

use antipode_audio::{Audio, Cue, Heard, Status, Volumes};
use antipode_settings::Settings;
use egui::output::OutputEvent;

/// The game's ears.
#[derive(Debug)]
pub(super) struct Ears {
    audio: Audio,
    volumes: Volumes,
    muted: bool,
}

impl Ears {
    /// Begins to play.
    pub fn new(settings: &Settings) -> Self {
        let volumes = volumes(settings);
        Self {
            audio: Audio::start(volumes),
            volumes,
            muted: false,
        }
    }

    /// Lets be heard what there is to hear; to be called once a frame. Never waits. `elsewhere`: the player has turned to
    /// another window. Returns the key of the words for a player who hears nothing.
    pub fn listen(
        &mut self,
        settings: &Settings,
        elsewhere: bool,
        heard: Heard,
    ) -> Option<&'static str> {
        let volumes = volumes(settings);
        if volumes != self.volumes {
            self.volumes = volumes;
            self.audio.set_volumes(volumes);
        }
        if (settings.mute_elsewhere && elsewhere) != self.muted {
            self.muted = !self.muted;
            self.audio.set_muted(self.muted);
        }
        self.audio.hear(heard);
        trouble(self.audio.status())
    }

    /// Lets the interface be heard: at most one sound for a frame.
    pub fn interface(&self, events: &[OutputEvent]) {
        for event in events {
            note(event);
        }
        if let Some(cue) = cue(events) {
            self.audio.cue(cue);
        }
    }
}

/// Key of the words for a player who hears nothing, if so.
fn trouble(status: &Status) -> Option<&'static str> {
    match status {
        Status::Opening | Status::Playing => None,
        Status::NoDevice(_) => Some("sound-none"),
        Status::Lost => Some("sound-lost"),
        Status::LeftOut => Some("sound-left-out"),
    }
}

/// What a screen reader would say of it goes to the log.
fn note(event: &OutputEvent) {
    let what = match event {
        OutputEvent::FocusGained(_) => "focus",
        OutputEvent::Clicked(_) => "pressed",
        OutputEvent::ValueChanged(_) => "changed",
        _ => return,
    };
    tracing::debug!("{what}: {}", event.widget_info().description());
}

fn cue(events: &[OutputEvent]) -> Option<Cue> {
    let of = |event: &OutputEvent| match event {
        OutputEvent::Clicked(_) => Some(Cue::Pressed),
        OutputEvent::FocusGained(_) | OutputEvent::ValueChanged(_) => Some(Cue::Moved),
        _ => None,
    };
    let mut cues = events.iter().filter_map(of);
    // A press that opens a screen moves the focus as well.
    let first = cues.next()?;
    Some(cues.find(|cue| *cue == Cue::Pressed).unwrap_or(first))
}

fn volumes(settings: &Settings) -> Volumes {
    let share = |percent: f64| (percent / 100.0) as f32;
    Volumes {
        master: share(settings.volume_master_pc),
        effects: share(settings.volume_effects_pc),
        ambience: share(settings.volume_ambience_pc),
        music: share(settings.volume_music_pc),
        interface: share(settings.volume_interface_pc),
    }
}

#[cfg(test)]
mod tests {
    use egui::{Role, WidgetInfo};

    use super::*;

    #[test]
    fn settings_begin_with_the_volumes_of_the_sounds_own_defaults() {
        assert_eq!(volumes(&Settings::default()), Volumes::default());
    }

    #[test]
    fn a_press_is_heard_before_the_focus_that_it_moves() {
        let info = || WidgetInfo::new(Role::Button);
        let moved = OutputEvent::FocusGained(info());
        let pressed = OutputEvent::Clicked(info());
        assert_eq!(cue(&[]), None);
        assert_eq!(cue(std::slice::from_ref(&moved)), Some(Cue::Moved));
        assert_eq!(cue(&[moved, pressed]), Some(Cue::Pressed));
    }

    #[test]
    fn who_hears_nothing_is_told_why_and_who_hears_is_not() {
        assert_eq!(trouble(&Status::Playing), None);
        let none = Status::NoDevice("there is none".to_owned());
        assert_eq!(trouble(&none), Some("sound-none"));
        assert_eq!(trouble(&Status::Lost), Some("sound-lost"));
    }
}

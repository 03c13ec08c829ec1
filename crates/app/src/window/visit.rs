//! A room that is played in the window: who walks in it, how it is looked at, and what its picture is of.

use std::path::PathBuf;
use std::time::Duration;

use antipode_language::Language;
use antipode_room_scene::{Difference, RoomScene, RoomSound};
use antipode_rooms::files::ROOM_FILE;
use antipode_scene::frame::Quality;
use antipode_scene::{Shutter, SoundEvent};
use antipode_terrain::Cover;
use antipode_ui::workshop::{BarModel, WorkshopPanes};
use glam::DVec2;

use super::devices::Devices;
use super::pace::Pace;
use super::placelist::ROOM_PICTURE;
use super::reading::Reading;
use super::workshop::{Lesson, Workshop};
use crate::pad::Feel;
use crate::room_picture::RoomView;
use crate::rooms::OpenRoom;

/// How long one is told what is strange in a room that one has just entered, seconds.
const TOLD_S: f64 = 9.0;

/// A frame counts for so much of that at most, seconds.
const READ_S: f64 = 0.25;

/// Tells pictures of a room from those of others, and of the same before it was changed.
pub type RoomId = (u64, u64);

/// An open room, played or paused.
#[derive(Debug)]
pub struct Visit {
    pub(super) room: OpenRoom,
    /// The room's number among those that were entered.
    number: u64,
    /// How long one has been in it, seconds.
    time_s: f64,
    /// Whether a picture of it is there.
    pub(super) is_drawn: bool,
    /// Whether that is of how it was a while ago.
    pub(super) is_late: bool,
    /// In which language what is read in it is drawn, once it is known, and how often that was another one.
    language: Option<Language>,
    pub(super) reworded: u64,
    /// Where rooms are.
    pub(super) dir: PathBuf,
    /// What it is built with, while it is.
    pub(super) workshop: Option<Box<Workshop>>,
    /// Its panes while it is not: folds and scrolled lists are as they were left.
    pub(super) panes: Option<WorkshopPanes>,
    /// Its tools while it is not.
    pub(super) bar: Option<BarModel>,
    /// The lesson of that, if it is taken.
    pub(super) lesson: Option<Lesson>,
    /// What is asked of it and waits for the disk.
    pub(super) reading: Reading,
    /// Width over height of its pictures.
    pub(super) aspect: f64,
}

impl Visit {
    /// The room with that number, of rooms in `dir`, has just been entered.
    pub fn new(room: OpenRoom, number: u64, dir: PathBuf) -> Self {
        Self {
            room,
            dir,
            workshop: None,
            panes: None,
            bar: None,
            lesson: None,
            reading: Reading::default(),
            number,
            time_s: 0.0,
            is_drawn: false,
            is_late: false,
            language: None,
            reworded: 0,
            aspect: 16.0 / 9.0,
        }
    }

    /// What happens in it.
    pub fn scene(&self) -> &RoomScene {
        &self.room.scene
    }

    /// Tells its picture from others.
    pub fn id(&self) -> RoomId {
        (self.number, self.scene().revision() + self.reworded)
    }

    /// What is read in it is to be in that language.
    pub fn speak(&mut self, language: Language) {
        let before = self.language.replace(language);
        self.reworded += u64::from(before.is_some_and(|before| before != language));
    }

    /// What the menu knows it by; empty for a room that is not kept.
    pub fn slug(&self) -> String {
        let kept = self.room.kept.as_ref();
        kept.map_or_else(String::new, super::placelist::Kept::slug)
    }

    /// The file of a room of the player's own.
    pub fn file(&self) -> Option<PathBuf> {
        let kept = self.room.kept.as_ref().filter(|kept| !kept.shipped)?;
        Some(self.dir.join(&kept.slug).join(ROOM_FILE))
    }

    /// Who walks begins anew in it, and is told again what is strange there.
    pub fn begin_anew(&mut self) {
        self.room.scene.begin_anew();
        self.tell_again();
    }

    /// One is told again what is strange in it.
    pub fn tell_again(&mut self) {
        self.time_s = 0.0;
    }

    /// The file of the menu's picture of a room of the player's own. No room uses it, so no export has it.
    pub fn portrait_file(&self) -> Option<PathBuf> {
        Some(self.file()?.with_file_name(ROOM_PICTURE))
    }

    /// Whether one is still told what is strange in it.
    pub fn is_new(&self) -> bool {
        self.time_s < TOLD_S
    }

    /// Lets time pass: as many steps as are due. `feel`: how the sticks answer, where they are for the room.
    pub fn advance(
        &mut self,
        passed: Duration,
        pace: &mut Pace,
        devices: &mut Devices,
        feel: Option<Feel>,
    ) {
        // What a slow frame takes nobody has had to read in.
        self.time_s += passed.as_secs_f64().min(READ_S);
        let (steps, passed_s) = pace.go_on(passed);
        devices.turn(feel, passed_s);
        for _ in 0..steps {
            let actions = devices.take(feel);
            self.room.step(&actions);
            if actions.talk || actions.flip_car {
                self.tell_again();
            }
            devices.step();
        }
    }

    /// What a picture of this moment is of: a share of the way of the last step, and turned as no step knows yet. `with_hand`:
    /// whether it shows what is held.
    pub fn view(&self, shutter: Shutter, quality: Quality, with_hand: bool) -> RoomView {
        let turn = (shutter.turned.right_rad, shutter.turned.up_rad);
        let moment = self.scene().moment(shutter.share, turn);
        RoomView {
            id: self.id(),
            moment: self.room.shown(moment, with_hand),
            options: self.room.picture_options(quality, 1),
            tile: None,
        }
    }

    /// What there was to hear since it was last asked. Floors of rooms sound as rock does.
    pub fn take_sounds(&mut self) -> Vec<SoundEvent> {
        let cover = Cover::Rock;
        let all = self.room.scene.take_sounds().into_iter();
        let heard = all.map(|sound| match sound {
            RoomSound::Step(speed_m_s) => SoundEvent::Step { cover, speed_m_s },
            RoomSound::Landed(speed_m_s) | RoomSound::Knocked(speed_m_s) => {
                SoundEvent::Landed { cover, speed_m_s }
            }
            RoomSound::Shot => SoundEvent::Shot,
        });
        heard.collect()
    }

    /// What the middle of the picture shows by the exact rule and by that of the thesis.
    pub fn difference(&self) -> Difference {
        self.scene().difference(DVec2::ZERO, self.aspect)
    }
}

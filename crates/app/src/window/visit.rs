//! A room that is played in the window: who walks in it, how it is looked at, and what its picture is of.

use std::time::Duration;

use antipode_room_scene::RoomScene;
use antipode_scene::Actions;

use super::devices::Devices;
use super::pace::Pace;
use crate::pad::Feel;
use crate::room_picture::RoomView;
use crate::rooms::OpenRoom;
use crate::script::steer;

/// How long one is told what is strange in a room that one has just entered, seconds.
const TOLD_S: f64 = 9.0;

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
}

impl Visit {
    /// The room with that number has just been entered.
    pub fn new(room: OpenRoom, number: u64) -> Self {
        Self {
            room,
            number,
            time_s: 0.0,
            is_drawn: false,
        }
    }

    /// What happens in it.
    pub fn scene(&self) -> &RoomScene {
        &self.room.scene
    }

    /// Tells its picture from others.
    pub fn id(&self) -> RoomId {
        (self.number, self.scene().revision())
    }

    /// What the menu knows it by; empty for a room that is not kept.
    pub fn slug(&self) -> String {
        let kept = self.room.kept.as_ref();
        kept.map_or_else(String::new, super::placelist::Kept::slug)
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
        self.time_s += passed.as_secs_f64();
        let (steps, passed_s) = pace.go_on(passed);
        devices.turn(feel, passed_s);
        for _ in 0..steps {
            let actions = devices.take(feel);
            self.step(&actions);
            devices.step();
        }
    }

    fn step(&mut self, actions: &Actions) {
        self.room.scene.step(&steer(actions));
    }

    /// What a picture of this moment is of.
    pub fn view(&self) -> RoomView {
        RoomView {
            id: self.id(),
            eye: self.scene().eye(),
            options: antipode_rays::Options::default(),
        }
    }
}

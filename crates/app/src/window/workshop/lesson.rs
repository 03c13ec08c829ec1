//! The lesson: five deeds by which one builds a house that is larger inside. Each is done by the reader's own hand, and told by what
//! the room has become.

use antipode_language::Texts;
use antipode_room_scene::RoomScene;
use antipode_rooms::{Object, Room, What, poses};
use antipode_ui::workshop::{LessonModel, LessonTarget};
use glam::DVec3;

/// How much larger inside the house is to become, as a share of what it was.
const LARGER: f64 = 1.3;
/// How far it is to be moved, metres.
const MOVED_M: f64 = 0.2;

/// The deeds, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Deed {
    Put,
    Move,
    Choose,
    Stretch,
    Enter,
}

const DEEDS: [Deed; 5] = [
    Deed::Put,
    Deed::Move,
    Deed::Choose,
    Deed::Stretch,
    Deed::Enter,
];

/// What of the room a deed changes.
#[derive(Clone, Debug, Default, PartialEq)]
struct Before {
    /// How many spaces there are.
    spaces: usize,
    /// Where the house stands.
    at: DVec3,
    /// How many times as much room its inside has.
    times: f64,
}

/// The lesson, as far as it has come.
#[derive(Clone, Debug)]
pub struct Lesson {
    step: usize,
    before: Before,
}

impl Lesson {
    /// Its beginning.
    pub fn begin(scene: &RoomScene) -> Self {
        Self {
            step: 0,
            before: before(scene.room()),
        }
    }

    /// Goes on to the next deed, if this one is done. While something is dragged nothing is.
    pub fn pass(&mut self, scene: &RoomScene) {
        if scene.document().is_dragging() {
            return;
        }
        let now = before(scene.room());
        let is_done = match self.deed() {
            Deed::Put => now.spaces > self.before.spaces,
            Deed::Move => now.at.distance(self.before.at) > MOVED_M,
            Deed::Choose => {
                matches!(scene.document().selection(), [name] if is_space(scene.room(), name))
            }
            Deed::Stretch => now.times > LARGER * self.before.times,
            Deed::Enter => false,
        };
        if is_done {
            self.skip(scene);
        }
    }

    /// Leaves a deed out. Returns whether there is another.
    pub fn skip(&mut self, scene: &RoomScene) -> bool {
        self.before = before(scene.room());
        self.step += 1;
        self.step < DEEDS.len()
    }

    /// Whether who walks has done the last deed.
    pub fn is_ended_by(&self, scene: &RoomScene) -> bool {
        self.deed() == Deed::Enter && !scene.eye().place.stack.is_empty()
    }

    /// Whether all that is left is to go in.
    pub fn is_at_the_door(&self) -> bool {
        self.deed() == Deed::Enter
    }

    fn deed(&self) -> Deed {
        DEEDS[self.step.min(DEEDS.len() - 1)]
    }

    /// In words, and what it is done with.
    pub fn model(&self, texts: &Texts, room: &Room) -> LessonModel {
        let inside = last_space(room).map(|it| it.name.clone());
        let (key, target) = match self.deed() {
            Deed::Put => ("put", LessonTarget::Part("house".to_owned())),
            Deed::Move => ("move", LessonTarget::View),
            Deed::Choose => {
                let object = inside.clone().map(LessonTarget::Object);
                ("choose", object.unwrap_or(LessonTarget::View))
            }
            Deed::Stretch => ("stretch", LessonTarget::Field("times-all".to_owned())),
            Deed::Enter => ("enter", LessonTarget::Do("play")),
        };
        let values = [("name", inside.unwrap_or_default().into())];
        LessonModel {
            number: self.step.min(DEEDS.len() - 1) + 1,
            of: DEEDS.len(),
            text: texts.say_with(&format!("workshop-lesson-{key}"), &values),
            target,
        }
    }
}

fn is_space(room: &Room, name: &str) -> bool {
    let found = room.find(name);
    found.is_some_and(|(_, it)| matches!(it.what, What::Aberration(_)))
}

/// The space that was put in last.
fn last_space(room: &Room) -> Option<&Object> {
    room.aberrations()
        .last()
        .map(|(index, _)| &room.objects[index])
}

fn before(room: &Room) -> Before {
    let Some((index, it)) = room.aberrations().last() else {
        return Before::default();
    };
    Before {
        spaces: room.aberrations().count(),
        at: poses(room)[index].translation,
        times: it.stretch().element_product(),
    }
}

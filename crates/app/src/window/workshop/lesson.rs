//! The lessons: a few deeds by which one builds a house that is larger inside, or a tunnel and two portals. Each is done by the reader's
//! own hand, and told by what the room has become. A lesson is about the things that were put in for it, or that were there already.

use antipode_language::Texts;
use antipode_room_scene::RoomScene;
use antipode_rooms::aberration::Lengths;
use antipode_rooms::{Object, Room, What, poses};
use antipode_ui::workshop::{LessonChoice, LessonModel, LessonTarget};
use glam::DVec3;

/// How much larger inside something is to become, as a share of what it was.
const LARGER: f64 = 1.3;
/// How far it is to be moved, metres.
const MOVED_M: f64 = 0.2;

/// What is to be done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Deed {
    /// A part is put in.
    Put(&'static str),
    /// What was put in last is moved.
    Move,
    /// It is chosen.
    Choose,
    /// It is stretched, by that field.
    Stretch(&'static str),
    /// The two that were put in last lead to each other.
    Link,
    /// Who walks is in a space.
    Enter,
    /// Who walks has been in a space, and is out of it.
    Leave,
    /// Who walks has gone through a portal.
    Pass,
}

/// A step: its words, and what is done in it.
type Step = (&'static str, Deed);

const HOUSE: &[Step] = &[
    ("put", Deed::Put("house")),
    ("move", Deed::Move),
    ("choose", Deed::Choose),
    ("stretch", Deed::Stretch("times-all")),
    ("enter", Deed::Enter),
];
const DOORS: &[Step] = &[
    ("tunnel", Deed::Put("tunnel")),
    ("longer", Deed::Stretch("times")),
    ("portal", Deed::Put("portal")),
    ("portal-again", Deed::Put("portal")),
    ("link", Deed::Link),
    ("through", Deed::Leave),
    ("pass", Deed::Pass),
];

/// What of a thing a deed changes.
#[derive(Clone, Debug, Default, PartialEq)]
struct Before {
    /// Where it stands.
    at: DVec3,
    /// How many times as much room its inside has.
    times: f64,
}

/// A lesson, as far as it has come.
#[derive(Clone, Debug)]
pub struct Lesson {
    choice: LessonChoice,
    step: usize,
    /// What it is about: in which step it was put in, and its name.
    about: Vec<(usize, String)>,
    before: Before,
    /// Whether who walks has been in a space.
    was_inside: bool,
}

impl Lesson {
    /// Its beginning. What is there already need not be put in.
    pub fn begin(choice: LessonChoice, room: &Room) -> Self {
        let mut lesson = Self {
            choice,
            step: 0,
            about: Vec::new(),
            before: Before::default(),
            was_inside: false,
        };
        lesson.settle(room);
        lesson
    }

    /// Which lesson it is.
    pub fn choice(&self) -> LessonChoice {
        self.choice
    }

    fn steps(&self) -> &'static [Step] {
        match self.choice {
            LessonChoice::House => HOUSE,
            LessonChoice::Doors => DOORS,
        }
    }

    fn current(&self) -> Step {
        let steps = self.steps();
        steps[self.step.min(steps.len() - 1)]
    }

    /// Goes on past parts that are there already, and looks how things are before the deed.
    fn settle(&mut self, room: &Room) {
        while let (_, Deed::Put(part)) = self.current() {
            let known = |name: &str| self.about.iter().any(|(_, it)| it == name);
            let mut there = room.objects.iter().filter(|it| fits(it, part));
            let Some(found) = there.find(|it| !known(&it.name)) else {
                break;
            };
            self.about.push((self.step, found.name.clone()));
            self.step += 1;
        }
        self.before = self.now(room);
    }

    fn now(&self, room: &Room) -> Before {
        let last = self.about.last().and_then(|(_, name)| room.find(name));
        let Some((index, object)) = last else {
            return Before::default();
        };
        let times = match &object.what {
            What::Aberration(it) => it.stretch().element_product(),
            _ => 1.0,
        };
        Before {
            at: poses(room)[index].translation,
            times,
        }
    }

    /// Goes on to the next deed, if this one is done; back to where something was put in that is there no more. While something is
    /// dragged nothing is done. Returns whether it has come to another deed.
    pub fn pass(&mut self, scene: &RoomScene) -> bool {
        if scene.document().is_dragging() {
            return false;
        }
        let before = self.step;
        let room = scene.room();
        let gone = self
            .about
            .iter()
            .position(|(_, it)| room.find(it).is_none());
        if let Some(gone) = gone {
            self.step = self.about[gone].0;
            self.about.truncate(gone);
            self.settle(room);
        }
        let now = self.now(room);
        let chosen = scene.document().selection();
        let is_done = match self.current().1 {
            Deed::Put(_) => {
                self.settle(room);
                false
            }
            Deed::Move => now.at.distance(self.before.at) > MOVED_M,
            Deed::Choose => {
                let last = self.about.last().map(|(_, name)| name);
                matches!(chosen, [name] if Some(name) == last)
            }
            Deed::Stretch(_) => now.times > LARGER * self.before.times,
            Deed::Link => self.is_linked(room),
            // A walk ends these.
            Deed::Enter | Deed::Leave | Deed::Pass => false,
        };
        if is_done {
            self.skip(room);
        }
        self.step != before
    }

    /// What one has to see at once for the deed, by its places among all objects.
    pub fn seen_together(&self, room: &Room) -> Vec<usize> {
        let about = match self.current().1 {
            Deed::Link => &self.about[self.about.len().saturating_sub(2)..],
            _ => &[],
        };
        let found = about.iter().filter_map(|(_, name)| room.find(name));
        found.map(|(index, _)| index).collect()
    }

    /// Whether the two portals that it is about lead to each other.
    fn is_linked(&self, room: &Room) -> bool {
        let [.., (_, a), (_, b)] = &self.about[..] else {
            return false;
        };
        let leads = |from: &str, to: &str| {
            let found = room.find(from);
            found.is_some_and(|(_, it)| matches!(&it.what, What::Portal(it) if it.to == to))
        };
        leads(a, b) && leads(b, a)
    }

    /// Leaves a deed out. Returns whether there is another.
    pub fn skip(&mut self, room: &Room) -> bool {
        self.step += 1;
        let goes_on = self.step < self.steps().len();
        if goes_on {
            self.settle(room);
        }
        goes_on
    }

    /// Goes on to the next deed, if who walks has done this one. Returns whether that was the last.
    pub fn walk(&mut self, scene: &RoomScene) -> bool {
        let place = scene.eye().place;
        let is_inside = !place.stack.is_empty();
        let is_done = match self.current().1 {
            Deed::Enter => is_inside,
            Deed::Leave => self.was_inside && !is_inside,
            Deed::Pass => place.passage.count > 0,
            _ => false,
        };
        self.was_inside = is_inside;
        is_done && !self.skip(scene.room())
    }

    /// What is said to who walks, where all that is left is to walk.
    pub fn walking_words(&self) -> Option<&'static str> {
        match self.current().0 {
            "enter" => Some("workshop-lesson-walk"),
            "through" => Some("workshop-lesson-walk-tunnel"),
            "pass" => Some("workshop-lesson-walk-doors"),
            _ => None,
        }
    }

    /// In words, and what it is done with.
    pub fn model(&self, texts: &Texts, room: &Room) -> LessonModel {
        let names = || self.about.iter().rev().map(|(_, name)| name.clone());
        let last = names().next().filter(|it| room.find(it).is_some());
        let (key, deed) = self.current();
        let target = match deed {
            Deed::Put(part) => LessonTarget::Part(part.to_owned()),
            Deed::Choose => last
                .clone()
                .map_or(LessonTarget::View, LessonTarget::Object),
            Deed::Stretch(field) => LessonTarget::Field(field.to_owned()),
            Deed::Move | Deed::Link => LessonTarget::View,
            Deed::Enter | Deed::Leave | Deed::Pass => LessonTarget::Do("play"),
        };
        let values = [
            ("name", last.unwrap_or_default().into()),
            ("other", names().nth(1).unwrap_or_default().into()),
        ];
        LessonModel {
            number: self.step.min(self.steps().len() - 1) + 1,
            of: self.steps().len(),
            text: texts.say_with(&format!("workshop-lesson-{key}"), &values),
            target,
        }
    }
}

/// Whether a thing is what a part puts in, as far as the lesson needs it.
fn fits(object: &Object, part: &str) -> bool {
    match (&object.what, part) {
        (What::Aberration(it), "house") => {
            object.group.is_some() && matches!(it.lengths, Lengths::Stretch(_))
        }
        (What::Aberration(it), "tunnel") => matches!(it.lengths, Lengths::Felt { .. }),
        // One that leads to itself: it is free to be linked.
        (What::Portal(it), "portal") => it.to == object.name,
        _ => false,
    }
}

//! What is under the crosshair, found by the path that light and walkers take.

use antipode_deformation::{End, Event, EventKind, Traveller, What, trace};
use antipode_rays::Eye;
use antipode_rooms::What as Kind;
use serde::Serialize;

use crate::bodies::Owner;
use crate::scene::RoomScene;
use crate::tuning::{PICK_M, READS_M};

/// What the crosshair is on.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Pick {
    /// The object, or `ball` for one that was thrown; null for the sky.
    pub object: Option<String>,
    /// How far off it feels, metres.
    pub felt: Option<f64>,
    /// How long the way there is in the scene, metres.
    pub scene: Option<f64>,
    /// Faces and portals on the way, in their order.
    pub events: Vec<PickEvent>,
}

/// A face or a portal on the way.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PickEvent {
    /// `entered`, `left` or `reflected`, of an aberration; `portal`.
    pub kind: &'static str,
    /// The aberration, or the portal that is gone into.
    pub name: String,
}

impl RoomScene {
    /// What the crosshair is on.
    pub fn pick(&self) -> Pick {
        let Eye { place, front, .. } = self.eye();
        let path = trace(
            &self.space,
            &place,
            front,
            PICK_M,
            &self.all_solids(),
            &Traveller::Body,
        );
        let hit = match path.end {
            End::Hit(hit) => Some(self.name_hit(hit.what)),
            End::Spent | End::TooManyEvents => None,
        };
        let corners = path.events.iter().map(|event| (event.point, event.onward));
        let mut from = place.point;
        let end = (path.place.point, path.place.point);
        let scene = corners.chain([end]).fold(0.0, |sum, (to, onward)| {
            let piece = from.distance(to);
            from = onward;
            sum + piece
        });
        Pick {
            felt: hit.as_ref().map(|_| path.length),
            scene: hit.as_ref().map(|_| scene),
            object: hit,
            events: path.events.iter().map(|it| self.told(it)).collect(),
        }
    }

    /// Whether the crosshair is on a sign that is near enough to read.
    pub(crate) fn reads_sign(&self) -> bool {
        let Eye { place, front, .. } = self.eye();
        let who = Traveller::Body;
        let path = trace(
            &self.space,
            &place,
            front,
            READS_M,
            &self.all_solids(),
            &who,
        );
        let hit = path.hit().and_then(|hit| self.object_of(hit.what));
        hit.is_some_and(|object| {
            let what = &self.room().objects[object].what;
            matches!(what, Kind::Sign { .. })
        })
    }

    /// The object that something belongs to; none of what was thrown.
    pub(crate) fn object_of(&self, what: What) -> Option<usize> {
        match what {
            What::Object(number, _) => match Owner::numbered(number) {
                Owner::Object(object) => Some(object),
                Owner::Thrown(_) | Owner::Walker => None,
            },
            What::Wall(number, _) => Some(self.boxes[number]),
        }
    }

    /// What that is called.
    pub(crate) fn name_hit(&self, what: What) -> String {
        let owner = self.object_of(what).map(Owner::Object);
        self.name_of(owner.unwrap_or(Owner::Thrown(0)))
    }

    /// What somebody's body is called.
    pub(crate) fn name_of(&self, owner: Owner) -> String {
        match owner {
            Owner::Object(object) => self.room().objects[object].name.clone(),
            Owner::Thrown(_) => "ball".to_owned(),
            Owner::Walker => "player".to_owned(),
        }
    }

    fn told(&self, event: &Event) -> PickEvent {
        let object = match event.kind {
            EventKind::Passed => self.portals[event.number],
            _ => self.boxes[event.number],
        };
        PickEvent {
            kind: match event.kind {
                EventKind::Entered => "entered",
                EventKind::Left => "left",
                EventKind::Reflected => "reflected",
                EventKind::Passed => "portal",
            },
            name: self.room().objects[object].name.clone(),
        }
    }
}

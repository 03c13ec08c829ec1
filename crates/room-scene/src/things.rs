//! Things that come and go while one is in a room: bullets and their marks, and lamps that were put down. Balls that were thrown
//! are loose bodies (`bodies/thrown.rs`), but counted here with the rest. Nothing of them is kept: who leaves a room, or begins
//! anew in it, finds it as its file says.

use antipode_deformation::{Flyer, Hit, Place, SceneQuery, Space, What};
use glam::{DQuat, DVec3};
use serde::Serialize;

use crate::tuning::{
    BULLET_RADIUS_M, BULLET_REACH_M, LAMP_BODY_M, MARK_RADIUS_M, MOST_BULLETS, MOST_MARKS, STEP_S,
    THROWN,
};

/// What kind of thing it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ThingKind {
    /// A bullet in flight.
    Bullet,
    /// What a bullet has left where it hit.
    Mark,
    /// A ball that was thrown.
    Ball,
    /// A lamp that was put down.
    Lamp,
}

/// A thing as it is to be drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thing {
    /// Its own number, counted from when the room was opened.
    pub id: u64,
    /// What it is.
    pub kind: ThingKind,
    /// Where its middle is.
    pub place: Place,
    /// Felt radius, metres: in the scene a thing is K times a ball of it.
    pub radius_m: f64,
    /// How it is turned, as it feels.
    pub turn: DQuat,
    /// Felt normal, of length 1, of what a mark is on or a lamp stands on; the upright for the rest.
    pub normal: DVec3,
}

impl Thing {
    /// One that is not turned.
    pub(crate) fn new(id: u64, kind: ThingKind, place: Place) -> Self {
        Self {
            id,
            kind,
            place,
            radius_m: match kind {
                ThingKind::Bullet => BULLET_RADIUS_M,
                ThingKind::Mark => MARK_RADIUS_M,
                ThingKind::Ball => THROWN.radius_m,
                ThingKind::Lamp => LAMP_BODY_M,
            },
            turn: DQuat::IDENTITY,
            normal: DVec3::Y,
        }
    }
}

/// What the last bullet that hit something has hit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Struck {
    /// The object.
    pub object: String,
    /// Felt metres that the bullet flew.
    pub felt: f64,
}

/// What each kind knows of itself.
#[derive(Clone, Copy, Debug)]
enum Life {
    Bullet { body: Flyer, flown_m: f64 },
    Still { place: Place, normal: DVec3 },
}

#[derive(Clone, Copy, Debug)]
struct One {
    id: u64,
    kind: ThingKind,
    life: Life,
    /// Where it was before the last step.
    was: Place,
}

/// All things in a room.
#[derive(Clone, Debug, Default)]
pub struct Things {
    all: Vec<One>,
    made: u64,
    /// What bullets have hit since it was last asked: what, where, and in which felt direction they flew.
    pub blows: Vec<(What, Place, DVec3)>,
    /// What was hit last: what it belongs to, and felt metres flown.
    pub struck: Option<(What, f64)>,
}

impl One {
    fn place(&self) -> Place {
        match self.life {
            Life::Bullet { body, .. } => body.place,
            Life::Still { place, .. } => place,
        }
    }

    fn shown(&self, place: Place) -> Thing {
        let normal = match self.life {
            Life::Bullet { .. } => DVec3::Y,
            Life::Still { normal, .. } => normal,
        };
        Thing {
            normal,
            ..Thing::new(self.id, self.kind, place)
        }
    }
}

impl Things {
    /// All of them, the oldest first, at a share of the way of the last step.
    pub fn shown(&self, space: &Space, share: f64) -> Vec<Thing> {
        let place = |it: &One| Place::between(space, &it.was, &it.place(), share);
        self.all.iter().map(|it| it.shown(place(it))).collect()
    }

    /// How many there are of a kind.
    pub fn count(&self, kind: ThingKind) -> usize {
        self.all.iter().filter(|it| it.kind == kind).count()
    }

    /// A bullet leaves the muzzle.
    pub fn shoot(&mut self, mut body: Flyer) {
        body.straighten();
        let life = Life::Bullet { body, flown_m: 0.0 };
        self.add(ThingKind::Bullet, life, MOST_BULLETS);
    }

    /// The number of one more that is kept elsewhere.
    pub fn count_one(&mut self) -> u64 {
        self.made += 1;
        self.made
    }

    /// A lamp is put down on something of that felt normal; of more than `most` the oldest goes.
    pub fn put_lamp(&mut self, place: Place, normal: DVec3, most: usize) {
        self.add(ThingKind::Lamp, Life::Still { place, normal }, most);
    }

    /// Takes a thing away.
    pub fn remove(&mut self, id: u64) {
        self.all.retain(|it| it.id != id);
    }

    /// The room has changed: what lay still may fall, and places are in the boxes that there are now.
    pub fn wake(&mut self, space: &Space) {
        let anew = |place: &mut Place| {
            *place = Place {
                scale: place.scale,
                ..Place::at(space, place.point)
            };
        };
        self.struck = None;
        // A mark may be on nothing now.
        self.all.retain(|it| it.kind != ThingKind::Mark);
        for one in &mut self.all {
            anew(&mut one.was);
            match &mut one.life {
                Life::Bullet { body, .. } => anew(&mut body.place),
                Life::Still { place, .. } => anew(place),
            }
        }
    }

    fn add(&mut self, kind: ThingKind, life: Life, most: usize) {
        let over = (self.count(kind) + 1).saturating_sub(most.max(1));
        let mut oldest = 0;
        self.all.retain(|it| {
            oldest += usize::from(it.kind == kind);
            it.kind != kind || oldest > over
        });
        let mut one = One {
            id: self.count_one(),
            kind,
            life,
            was: Place::default(),
        };
        one.was = one.place();
        self.all.push(one);
    }

    /// Keeps what is at places of which that is true.
    pub fn keep(&mut self, is_here: impl Fn(DVec3) -> bool) {
        self.all.retain(|one| is_here(one.place().point));
    }

    /// Goes on by a step.
    pub fn step(
        &mut self,
        space: &Space,
        solids: &dyn SceneQuery,
        g: DVec3,
        is_loose: impl Fn(What) -> bool,
    ) {
        let mut hits = Vec::new();
        for one in &mut self.all {
            one.was = one.place();
            match &mut one.life {
                Life::Bullet { body, flown_m } => {
                    if let Some(hit) = fly(body, flown_m, space, solids, g) {
                        hits.push((one.id, *body, *flown_m, hit));
                    }
                }
                Life::Still { .. } => {}
            }
        }
        for (id, body, flown_m, hit) in hits {
            self.remove(id);
            self.struck = Some((hit.what, flown_m));
            let way = body.velocity.normalize_or_zero();
            self.blows.push((hit.what, body.place, way));
            if is_loose(hit.what) {
                // A mark would stay in the air.
                continue;
            }
            let normal = hit.felt_normal;
            let life = Life::Still {
                place: body.place,
                normal,
            };
            self.add(ThingKind::Mark, life, MOST_MARKS);
        }
        let is_spent = |one: &One| matches!(one.life, Life::Bullet { flown_m, .. } if flown_m >= BULLET_REACH_M);
        self.all.retain(|one| !is_spent(one));
    }
}

/// A bullet flies for a step; what it hits.
fn fly(
    body: &mut Flyer,
    flown_m: &mut f64,
    space: &Space,
    solids: &dyn SceneQuery,
    g: DVec3,
) -> Option<Hit> {
    let before = body.velocity.length();
    let hit = body.fly(space, solids, g, STEP_S);
    let time = STEP_S - hit.map_or(0.0, |(_, left)| left);
    *flown_m += 0.5 * (before + body.velocity.length()) * time;
    let turn = body.straighten();
    hit.map(|(hit, _)| Hit {
        felt_normal: turn * hit.felt_normal,
        ..hit
    })
}

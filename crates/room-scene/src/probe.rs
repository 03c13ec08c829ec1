//! The state of an open room, for scripts.

use antipode_deformation::Traveller;
use glam::DMat3;
use serde::Serialize;

use crate::bodies::Owner;
use crate::pick::Pick;
use crate::scene::RoomScene;
use crate::things::{Struck, Thing, ThingKind};

/// The state of an open room. Places are metres of the scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RoomProbe {
    /// Simulated time since the room was opened, seconds.
    pub t: f64,
    /// The room's name.
    pub room: String,
    /// What is in it.
    pub objects: Vec<ObjectProbe>,
    /// What is under the crosshair.
    pub pick: Pick,
    /// Speed as it is felt, metres per second.
    pub felt_speed: f64,
    /// How large the player is in the scene, to what it was at first: the cube root of what a felt cubic metre takes up there, with
    /// what portals have made of it.
    pub scale: f64,
    /// Bullets in flight.
    pub bullets: usize,
    /// Bullets, marks, balls and lamps, the oldest first.
    pub things: Vec<ThingProbe>,
    /// What the last bullet that hit something has hit; null if none has.
    pub hit: Option<Struck>,
    /// The player.
    pub player: PlayerProbe,
    /// The camera.
    pub camera: CameraProbe,
}

/// Something in a room.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ObjectProbe {
    /// Its name.
    pub name: String,
    /// What it is: `box`, `aberration` and so on.
    pub kind: &'static str,
    /// Where it is; of what is loose, where its centre of mass is now.
    pub pos: [f64; 3],
}

/// Something that was shot, thrown or put down.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ThingProbe {
    /// Its own number.
    pub id: u64,
    /// What it is: `bullet`, `mark`, `ball` or `lamp`.
    pub kind: ThingKind,
    /// Where its middle is.
    pub pos: [f64; 3],
}

/// The player in a room.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlayerProbe {
    /// Feet.
    pub pos: [f64; 3],
    /// Velocity in the scene, metres per second.
    pub vel: [f64; 3],
    /// Heading, degrees.
    pub yaw: f64,
    /// Elevation of the view, degrees.
    pub pitch: f64,
    /// Whether the feet stand on ground.
    pub grounded: bool,
}

/// The camera in a room.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CameraProbe {
    /// Eye.
    pub pos: [f64; 3],
    /// `first` or `third`.
    pub mode: &'static str,
}

/// How large the player is in the scene, to what they are outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// In height.
    pub up: f64,
    /// Along the ground, where it is least and where it is most.
    pub level: [f64; 2],
}

impl ThingProbe {
    fn of(thing: &Thing) -> Self {
        Self {
            id: thing.id,
            kind: thing.kind,
            pos: thing.place.point.to_array(),
        }
    }
}

impl RoomScene {
    /// How large the player is in the scene, to what it is outside: the cube root of what a felt cubic metre takes up there.
    pub fn scale(&self) -> f64 {
        self.squeeze_here().determinant().abs().cbrt()
    }

    /// How large the player is here, to what they are outside. Along the ground K stretches a felt direction
    /// v = a cos t + b sin t to |K v|^2 = m + r cos(2 t - t0), with m = (|Ka|^2 + |Kb|^2) / 2 and
    /// r^2 = (|Ka|^2 - |Kb|^2)^2 / 4 + (Ka Kb)^2.
    pub fn sizes(&self) -> Sizes {
        let k = self.squeeze_here();
        let up = self.up();
        let (a, b) = up.any_orthonormal_pair();
        let (a, b) = (k * a, k * b);
        let mean = 0.5 * (a.length_squared() + b.length_squared());
        let off = 0.5 * (a.length_squared() - b.length_squared());
        let r = off.hypot(a.dot(b));
        Sizes {
            up: (k * up).length(),
            level: [(mean - r).max(0.0).sqrt(), (mean + r).sqrt()],
        }
    }

    /// What a felt vector is in the scene where the player is.
    pub(crate) fn squeeze_here(&self) -> DMat3 {
        let body = &self.walker.body;
        self.space
            .carry(&body.place, body.velocity, &Traveller::Body)
    }

    /// What the last bullet that hit something has hit.
    fn struck(&self) -> Option<Struck> {
        let (what, felt) = self.things.struck?;
        Some(Struck {
            object: self.name_hit(what),
            felt,
        })
    }

    /// The state of the room.
    pub fn probe(&self) -> RoomProbe {
        let body = &self.walker.body;
        let aim = self.look.degrees();
        let room = self.room();
        let mut at: Vec<_> = self.poses().iter().map(|it| it.translation).collect();
        for body in self.bodies.loose() {
            if let Owner::Object(object) = body.owner {
                at[object] = body.place.point;
            }
        }
        let objects = room.objects.iter().zip(at);
        RoomProbe {
            t: self.time_s,
            room: room.name.clone(),
            objects: objects
                .map(|(object, at)| ObjectProbe {
                    name: object.name.clone(),
                    kind: object.what.kind(),
                    pos: at.to_array(),
                })
                .collect(),
            pick: self.pick(),
            felt_speed: body.velocity.length(),
            scale: self.scale(),
            bullets: self.things.count(ThingKind::Bullet),
            things: self.things().iter().map(ThingProbe::of).collect(),
            hit: self.struck(),
            player: PlayerProbe {
                pos: self.feet().to_array(),
                vel: (self.squeeze_here() * body.velocity).to_array(),
                yaw: aim.x,
                pitch: aim.y,
                grounded: self.walker.grounded,
            },
            camera: CameraProbe {
                pos: self.eye().place.point.to_array(),
                mode: if self.third_person() {
                    "third"
                } else {
                    "first"
                },
            },
        }
    }
}

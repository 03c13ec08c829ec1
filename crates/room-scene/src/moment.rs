//! A moment of a room, as a picture shows it: from where it is seen, who walks, what flies and lies there, and what lightens.

use antipode_rays::{Eye, Lamp, MAX_LAMPS};
use antipode_rooms::Colour;
use glam::{Affine3A, DMat3, DQuat, DVec3};

use crate::figure::RoomFigure;
use crate::light::{lamp, lamps};
use crate::scene::RoomScene;
use crate::things::{Thing, ThingKind};
use crate::tuning::{MARK_THICKNESS, PUT_LAMP};

/// What a picture of a moment shows beside what stays.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// From where it is seen.
    pub eye: Eye,
    /// Who walks.
    pub figure: RoomFigure,
    /// What has come into the room since it was entered.
    pub things: Vec<ShownThing>,
    /// All that lightens, the room's own lamps first; at most 8.
    pub lamps: Vec<Lamp>,
}

/// A thing in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShownThing {
    /// What it is.
    pub kind: ThingKind,
    /// From a ball of radius 1 to the scene. It keeps its felt size.
    pub pose: Affine3A,
    /// What it is called where it is seen.
    pub object: u32,
}

/// How far the view is turned that no step has taken in yet, radians to the right and upwards.
pub type Turn = (f64, f64);

impl RoomScene {
    /// The moment after the last step.
    pub fn now(&self) -> Moment {
        self.moment(1.0, (0.0, 0.0))
    }

    /// The moment at a share of the way of the last step, 0 at its beginning and 1 at its end, along the way that was gone.
    pub fn moment(&self, share: f64, (right_rad, up_rad): Turn) -> Moment {
        let (head, middle) = self.walker.between(&self.space, self.up(), share);
        let mut look = self.look;
        look.turn(right_rad, up_rad);
        let camera = self.camera_of(head, look.front());
        let figure = self.figure_of(&middle, &look, &camera);
        let all = self.things_between(share);
        let mut lamps = lamps(self.room(), &self.space);
        lamps.extend(
            all.iter()
                .filter(|it| it.kind == ThingKind::Lamp)
                .map(put_lamp),
        );
        lamps.truncate(MAX_LAMPS);
        let things = all.iter().map(|it| self.shown(it)).collect();
        Moment {
            eye: camera.eye(),
            figure,
            things,
            lamps,
        }
    }

    fn shown(&self, thing: &Thing) -> ShownThing {
        let size = DVec3::splat(thing.radius_m);
        let felt = match thing.kind {
            // Flat on what was hit.
            ThingKind::Mark => {
                let turn = DQuat::from_rotation_arc(DVec3::Y, thing.normal);
                DMat3::from_quat(turn)
                    * DMat3::from_diagonal(size * DVec3::new(1.0, MARK_THICKNESS, 1.0))
            }
            _ => DMat3::from_quat(thing.turn) * DMat3::from_diagonal(size),
        };
        ShownThing {
            kind: thing.kind,
            pose: self.felt_pose(&thing.place, thing.place.point, felt),
            object: self.figure_number() + 1,
        }
    }
}

fn put_lamp(thing: &Thing) -> Lamp {
    let (power, colour) = PUT_LAMP;
    lamp(thing.place, Colour(colour), power as f32)
}

//! Light in a room: sky, sun, fog and lamps.

use antipode_deformation::{Place, Traveller};
use antipode_rays::{Lamp, Sky, Sun};
use antipode_rooms::{Colour, Room, What, direction};
use glam::{DVec3, Vec3};

use crate::looks::linear;
use crate::scene::RoomScene;
use crate::things::ThingKind;
use crate::tuning::{DAYLIGHT, LAMP_FAINT, LAMP_RADIUS_M, LAMP_SHARE, NO_FOG_M};

/// Light of a lamp that was put down, as of one in worlds.
const PUT_DOWN_COLOUR: Colour = Colour([255, 214, 160]);
/// How strong it is.
const PUT_DOWN_POWER: f32 = 14.0;

/// The sky, and the light from everywhere; fog is what is seen at the horizon and below it.
pub fn sky(room: &Room) -> Sky {
    let colour = linear(room.sky.colour);
    let pale = colour.lerp(Vec3::splat(colour.max_element()), 0.45);
    let everywhere = room.sky.light as f32 * DAYLIGHT;
    let grey =
        colour.lerp(Vec3::splat(colour.element_sum() / 3.0), 0.6) / colour.max_element().max(1e-3);
    let (horizon, ground) = match &room.fog {
        Some(fog) => (linear(fog.colour), linear(fog.colour)),
        None => (pale, pale * 0.35),
    };
    Sky {
        zenith: DVec3::Y,
        top: colour,
        horizon,
        ground,
        ambient_sky: grey * everywhere,
        ambient_ground: grey * (everywhere * 0.6),
    }
}

/// The sun, if it shines.
pub fn sun(room: &Room) -> Option<Sun> {
    room.sun.map(|sun| Sun {
        direction: direction(sun.aim),
        colour: linear(sun.colour) * (sun.power as f32 * DAYLIGHT),
    })
}

/// Felt metres at which nothing is seen any more.
pub fn fog_m(room: &Room) -> f32 {
    room.fog.map_or(NO_FOG_M, |fog| fog.reach as f32)
}

impl RoomScene {
    /// All lamps, at a share of the way of the last step: those of the room, and those that were put down, and a shot.
    pub fn lamps_between(&self, share: f64) -> Vec<Lamp> {
        let mut all = self.own_lamps();
        let things = self.things_between(share);
        let put_down = things.iter().filter(|it| it.kind == ThingKind::Lamp);
        let put_down = put_down.map(|thing| {
            let k = self.space.carry(&thing.place, self.up(), &Traveller::Body);
            let longest = (0..3).map(|axis| k.col(axis).length()).fold(0.0, f64::max);
            Lamp {
                // It shines out of its own globe.
                radius_m: (1.05 * thing.radius_m * longest) as f32,
                ..lamp(thing.place, linear(PUT_DOWN_COLOUR), PUT_DOWN_POWER)
            }
        });
        all.extend(put_down);
        all.extend(self.shot_light(all.len()));
        all
    }

    /// Those of the room.
    pub(crate) fn own_lamps(&self) -> Vec<Lamp> {
        let all = self.room().objects.iter().zip(self.poses());
        all.filter_map(|(object, pose)| match object.what {
            What::Light { colour, power } => Some(lamp(
                Place::at(&self.space, pose.translation),
                linear(colour),
                power as f32,
            )),
            _ => None,
        })
        .collect()
    }
}

fn lamp(place: Place, colour: Vec3, power: f32) -> Lamp {
    Lamp {
        place,
        colour: colour * (power * LAMP_SHARE * DAYLIGHT),
        reach_m: (power / LAMP_FAINT).sqrt().max(1.0),
        radius_m: LAMP_RADIUS_M,
    }
}

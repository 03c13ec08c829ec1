//! Light in a room: sky, sun, fog and lamps.

use antipode_deformation::{Place, Space};
use antipode_rays::{Lamp, Sky, Sun};
use antipode_rooms::{Colour, Room, What, direction, poses};
use glam::{DVec3, Vec3};

use crate::looks::linear;
use crate::tuning::{DAYLIGHT, LAMP_FAINT, LAMP_RADIUS_M, LAMP_SHARE, NO_FOG_M};

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

/// A lamp of that power, in noon suns at a felt metre.
pub fn lamp(place: Place, colour: Colour, power: f32) -> Lamp {
    Lamp {
        place,
        colour: linear(colour) * (power * LAMP_SHARE * DAYLIGHT),
        reach_m: (power / LAMP_FAINT).sqrt().max(1.0),
        radius_m: LAMP_RADIUS_M,
    }
}

/// The lamps, where they are in the space.
pub fn lamps(room: &Room, space: &Space) -> Vec<Lamp> {
    let all = room.objects.iter().zip(poses(room));
    all.filter_map(|(object, pose)| match object.what {
        What::Light { colour, power } => {
            let place = Place::at(space, pose.translation);
            Some(lamp(place, colour, power as f32))
        }
        _ => None,
    })
    .collect()
}

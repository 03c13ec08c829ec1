//! Eyes from which a room is looked at by rays and by a raster, and light as bytes.

use antipode_deformation::Place;
use antipode_rays::Eye;
use antipode_room_scene::RoomScene;
use glam::DVec3;

/// Where one begins; about each of up to two aberrations before an entrance, aside of it, within, and looking back out; and before
/// each of up to two portals.
pub fn of(room: &RoomScene) -> Vec<Eye> {
    let mut eyes = vec![room.eye()];
    let boxes = antipode_rooms::space(room.room()).unwrap_or_default();
    let mut look = |from: DVec3, to: DVec3| {
        let place = Place::at(&boxes, from);
        eyes.push(Eye::looking(
            place,
            to - from,
            DVec3::Y,
            75_f64.to_radians(),
        ));
    };
    for placed in boxes.placed().iter().take(2) {
        let it = &placed.aberration;
        let longest = if it.half.x > it.half.z { 0 } else { 2 };
        let (along, half) = (placed.axes.col(longest), it.half[longest]);
        let aside = placed.axes.col(2 - longest) * it.half[2 - longest];
        let up = DVec3::Y * (0.3 * it.half.y);
        look(it.centre + along * (half + 2.1) + up, it.centre);
        look(
            it.centre + along * (half + 3.3) + 1.9 * aside + 2.0 * up,
            it.centre,
        );
        look(
            it.centre + along * (0.83 * half) + up + 0.2 * aside,
            it.centre - along * half,
        );
        look(
            it.centre + 0.13 * along + 0.1 * up,
            it.centre + along * (half + 4.0) + aside,
        );
    }
    for portal in boxes.portals().iter().take(2) {
        let (at, ahead, right) = (portal.portal.at, portal.normal, portal.right);
        let size = (portal.corners[0] - at).length();
        look(at + (1.9 * ahead + 0.1 * portal.up) * size, at);
        look(at + (1.1 * ahead + 0.7 * right) * size, at + 0.1 * right);
        look(at + 0.4 * ahead * size, at - ahead + 0.2 * right);
    }
    eyes
}

/// Light in bytes as the display shows it; the curve of tonemap.wgsl without its noise.
pub fn bytes(light: [f32; 3]) -> [u8; 3] {
    light.map(|part| {
        let s = part.max(0.0).sqrt();
        let shown = s * (5.072_28 * s - 0.091_362_8) / (s * (5.101_752 * s - 0.506_305_8) + 1.0);
        (255.0 * shown.clamp(0.0, 1.0)).round() as u8
    })
}

//! In which directions the sun is seen.

use glam::DVec3;

use crate::place::Place;
use crate::scene::SceneQuery;
use crate::space::{Space, Traveller};
use crate::trace::{End, trace};

/// Felt directions are the same to rounding.
const SAME: f64 = 1e-9;

/// Whether the sun, in felt direction `sun` of length 1, is seen straight from a place: it is the same direction behind every
/// box, since no face turns w. Behind a turned portal it is another one, and there is no sun. `far` is how far off nothing
/// stands any more, felt metres.
pub fn sun_is_seen(
    space: &Space,
    place: &Place,
    sun: DVec3,
    far: f64,
    scene: &dyn SceneQuery,
) -> bool {
    let path = trace(space, place, sun, far, scene, &Traveller::Body);
    let is_turned = place.turn.angle_between(path.place.turn) > SAME;
    path.end == End::Spent && !is_turned
}

/// All felt directions in which the sun is seen from a place where `place.turn` is none: straight, and through each turned portal
/// by itself.
pub fn sun_ways(
    space: &Space,
    place: &Place,
    sun: DVec3,
    far: f64,
    scene: &dyn SceneQuery,
) -> Vec<DVec3> {
    let straight = sun_is_seen(space, place, sun, far, scene).then_some(sun);
    let turned = space.portals().iter().filter(|it| it.is_turned());
    let beams = turned.filter_map(|portal| {
        // What has direction `sun` behind it has this before it.
        let w = portal.back(sun);
        let path = trace(space, place, w, far, scene, &Traveller::Body);
        let passed = path.place.turn * w;
        let is_one_hop = path.place.passage.count == place.passage.count + 1
            && usize::from(path.place.passage.portal) == portal.portal.to;
        (path.end == End::Spent && is_one_hop && (passed - sun).length() < SAME).then_some(w)
    });
    straight.into_iter().chain(beams).collect()
}

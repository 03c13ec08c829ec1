//! Where one begins: in the middle of something, in the air, or where it is well.

use antipode_deformation::Place;
use antipode_rooms::Room;

use super::Finding;
use super::ground::{Ground, Under};
use crate::said::Said;

/// What one falls at the beginning without notice, felt metres.
const HIGHEST_M: f64 = 0.5;
/// Heights at which a body is looked at, felt metres.
const HEIGHTS_M: [f64; 3] = [0.1, 0.9, 1.7];

/// Looks at the spawn; where one stands who begins there, if that can be told.
pub(crate) fn find(room: &Room, ground: &Ground<'_>, found: &mut Vec<Finding>) -> Option<Place> {
    let feet = Place::at(ground.space, room.spawn.at);
    let up = ground.up(&feet);
    let finding = |said, objects| Finding {
        said,
        is_grave: true,
        objects,
        at: room.spawn.at,
    };
    for height in HEIGHTS_M {
        let at = ground.beyond(&feet, up, height);
        let within = ground.solids_around(at.point);
        let object = within.first().and_then(|it| room.objects.get(*it as usize));
        if let Some(object) = object {
            let said = Said::new("spawn-in-solid").with("name", object.name.clone());
            found.push(finding(said, vec![object.name.clone()]));
            return None;
        }
    }
    // Nobody falls where nothing draws.
    if room.gravity.length() == 0.0 {
        return None;
    }
    let above = ground.beyond(&feet, up, HEIGHTS_M[0]);
    match ground.under(&above) {
        Under::Floor(below, _) if below - HEIGHTS_M[0] > HIGHEST_M => {
            let metres = ((below - HEIGHTS_M[0]) * 10.0).round() / 10.0;
            let said = Said::new("spawn-in-air").with_number("metres", metres);
            found.push(finding(said, Vec::new()));
        }
        Under::Void => {
            // Told by a distance of none: there is no ground at all.
            found.push(finding(
                Said::new("spawn-in-air").with_number("metres", 0.0),
                Vec::new(),
            ));
        }
        _ => {}
    }
    ground.standing_below(&above)
}

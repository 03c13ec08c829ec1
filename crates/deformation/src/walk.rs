//! Walking: the feet follow the floor, walls push sideways, low steps are climbed. It goes as in worlds.

use glam::DVec3;

use crate::column::{Around, Frame};
use crate::place::Place;
use crate::tuning::{LEAST_SIDEWAYS, LONGEST_PUSH_M, PUSHES, SLOPE_RISE_M, TOUCH_M};
use crate::walker::WalkerShape;

/// How often a push may go against the one before: between walls that face each other, pushes only go back and forth.
const MOST_RETURNS: usize = 1;

/// Cosine and sine of the turns that are tried in order where the straight way ends in a place too tight to be pushed out
/// of, as between a rising floor and a sinking roof: 0, 25, 50 and 75 degrees.
const DETOURS: [(f64, f64); 7] = [
    (1.0, 0.0),
    (0.906_307_787, 0.422_618_262),
    (0.906_307_787, -0.422_618_262),
    (0.642_787_610, 0.766_044_443),
    (0.642_787_610, -0.766_044_443),
    (0.258_819_045, 0.965_925_826),
    (0.258_819_045, -0.965_925_826),
];

/// Where somebody walks.
#[derive(Clone, Copy, Debug)]
pub struct Walked {
    /// The middle of the lowest ball.
    pub place: Place,
    /// Felt velocity along the ground, without what ran into walls.
    pub velocity: DVec3,
}

/// How a part of a walk ends.
enum Ending {
    /// On ground.
    Stands(Walked),
    /// Where there is none.
    Falls,
    /// Nowhere: walls on all sides, or a ceiling, leave no place.
    Tight,
}

/// Walks for a part of a step. None where the ground ends on the way: then nothing has happened, and one falls instead.
pub fn walk_part(
    around: &Around<'_>,
    shape: &WalkerShape,
    from: &Walked,
    time: f64,
) -> Option<Walked> {
    let here = around.frame(&from.place);
    let up = here.upright.transpose() * DVec3::Y;
    let allowed = around
        .overlap(&here, shape, TOUCH_M)
        .map_or(TOUCH_M, |contact| contact.depth);
    let level = from.velocity.reject_from_normalized(up);
    for (cos, sin) in DETOURS {
        let start = Walked {
            velocity: (level * cos + up.cross(level) * sin) * cos,
            ..*from
        };
        for rise in [shape.step_m, SLOPE_RISE_M.min(shape.step_m)] {
            match push_through(around, shape, &start, (time, rise, allowed)) {
                Ending::Stands(walked) => return Some(walked),
                Ending::Falls => return None,
                Ending::Tight => {}
            }
        }
    }
    let radius = shape.radius_m;
    let floor = around.floor(&here, shape, -radius, (shape.step_m, shape.step_m))?;
    let stood = around.carried(&from.place, up * floor);
    let fits = around
        .overlap(&around.frame(&stood), shape, allowed)
        .is_none();
    Some(Walked {
        place: if fits { stood } else { from.place },
        velocity: DVec3::ZERO,
    })
}

/// How high the feet at another place are in the frame about this one.
fn feet_of(other: &Frame, frame: &Frame, radius: f64) -> f64 {
    let is_beyond = other.place.passage != frame.place.passage;
    if other.place.stack == frame.place.stack || is_beyond {
        return -radius;
    }
    // They stay where they are in the scene, whatever the size of things there.
    (frame.into * (other.out * DVec3::new(0.0, -radius, 0.0))).y
}

fn push_through(
    around: &Around<'_>,
    shape: &WalkerShape,
    from: &Walked,
    (time, rise, allowed): (f64, f64, f64),
) -> Ending {
    let here = around.frame(&from.place);
    let mut velocity = from.velocity;
    let mut at = around.carried(&from.place, velocity * time);
    let (mut last_way, mut returns) = (DVec3::ZERO, 0);
    for _ in 0..PUSHES {
        let frame = around.frame(&at);
        let up = frame.upright.transpose() * DVec3::Y;
        let feet_y = feet_of(&here, &frame, shape.radius_m);
        let floor = around.floor(&frame, shape, feet_y, (rise, shape.step_m));
        let stands = floor.map_or(at, |y| around.carried(&at, up * y));
        let stood = around.frame(&stands);
        let Some(wall) = around.overlap(&stood, shape, allowed) else {
            return floor.map_or(Ending::Falls, |_| {
                Ending::Stands(Walked {
                    place: stands,
                    velocity,
                })
            });
        };
        let sideways = wall.normal.with_y(0.0);
        let share = sideways.length();
        if share < LEAST_SIDEWAYS {
            break;
        }
        let way = stood.upright.transpose() * (sideways / share);
        returns += usize::from(way.dot(last_way) < 0.0);
        if returns > MOST_RETURNS {
            break;
        }
        last_way = way;
        at = around.carried(&at, way * (wall.depth / share).min(LONGEST_PUSH_M));
        velocity -= velocity.dot(way).min(0.0) * way;
    }
    let slid = Walked { velocity, ..*from };
    lean(around, shape, from, (time, allowed))
        .or_else(|| lean(around, shape, &slid, (time, allowed)))
        .map_or(Ending::Tight, Ending::Stands)
}

/// In a gully the way off a steep side can lead down as fast as it leads away. There the ball leans on the side instead,
/// above the floor, so long as that does not climb.
fn lean(
    around: &Around<'_>,
    shape: &WalkerShape,
    from: &Walked,
    (time, allowed): (f64, f64),
) -> Option<Walked> {
    let here = around.frame(&from.place);
    let at = around.carried(&from.place, from.velocity * time);
    let frame = around.frame(&at);
    let feet_y = feet_of(&here, &frame, shape.radius_m);
    let heights = (feet_y - shape.step_m, feet_y + shape.step_m);
    let y = around.touch(&frame, shape, heights, |touch| touch.contact_y <= heights.1)?;
    let gentle = -shape.radius_m + y;
    let is_gentle = gentle <= feet_y + TOUCH_M && gentle >= heights.0;
    let up = frame.upright.transpose() * DVec3::Y;
    let place = around.carried(&at, up * y);
    let fits = || {
        around
            .overlap(&around.frame(&place), shape, allowed)
            .is_none()
    };
    (is_gentle && fits()).then_some(Walked {
        place,
        velocity: from.velocity,
    })
}

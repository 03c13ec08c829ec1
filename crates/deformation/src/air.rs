//! Jumping, falling and sliding: flight that slides along whatever it meets until it lands. It goes as in worlds.

use glam::DVec3;

use crate::column::{Around, Contact, Frame};
use crate::gravity::Flyer;
use crate::scene::Void;
use crate::tuning::{CEILING_UP, LEAST_LANDING_LIP_UP, LEFT_OVER_M, PUSHES, TOUCH_M, WEDGED_SHARE};
use crate::walker::WalkerShape;

/// What steep contacts a flight has slid along.
#[derive(Default)]
struct Slides {
    ways: Vec<DVec3>,
}

impl Slides {
    fn note(&mut self, normal: DVec3) {
        if normal.y > 0.0
            && let Some(way) = normal.with_y(0.0).try_normalize()
        {
            self.ways.push(way);
        }
    }

    fn face_each_other(&self) -> bool {
        let before = |i: usize| &self.ways[..i];
        let all = self.ways.iter().enumerate();
        all.into_iter()
            .any(|(i, a)| before(i).iter().any(|b| a.dot(*b) < 0.0))
    }
}

/// Flies for a part of a step. Whether it lands.
pub fn fly_part(around: &Around<'_>, shape: &WalkerShape, body: &mut Flyer, time: f64) -> bool {
    let before = *body;
    if let Some((hit, _)) = body.fly(around.space, &Void, around.g, time) {
        // A wall of an aberration, which is nearer than a radius only to who has just grown.
        let into = body.velocity.dot(hit.felt_normal).min(0.0);
        body.velocity -= into * hit.felt_normal;
    }
    let mut slides = Slides::default();
    if leave_contacts(around, shape, (body, &before), &mut slides) {
        settle(around, shape, body);
        return true;
    }
    let start = around.frame(&before.place);
    let wanted = (start.upright * (before.velocity * time)).y;
    let made = (start.into * (body.place.point - before.place.point)).y;
    let is_here = body.place.passage == before.place.passage;
    let is_wedged =
        is_here && wanted < 0.0 && made > WEDGED_SHARE * wanted && slides.face_each_other();
    if is_wedged {
        let up = around.up(&body.place);
        body.velocity -= body.velocity.dot(up) * up;
    }
    is_wedged
}

/// Goes out of whatever the body overlaps. Whether it has landed.
fn leave_contacts(
    around: &Around<'_>,
    shape: &WalkerShape,
    (body, before): (&mut Flyer, &Flyer),
    slides: &mut Slides,
) -> bool {
    let mut landed = false;
    for _ in 0..PUSHES {
        let frame = around.frame(&body.place);
        let Some(contact) = around.overlap(&frame, shape, TOUCH_M) else {
            return landed;
        };
        landed |= leave(around, shape, body, (&frame, &contact), slides);
    }
    let frame = around.frame(&body.place);
    let had = around.overlap(&around.frame(&before.place), shape, LEFT_OVER_M);
    let allowed = had.map_or(LEFT_OVER_M, |contact| contact.depth + TOUCH_M);
    if around.overlap(&frame, shape, allowed).is_some() {
        *body = Flyer {
            velocity: DVec3::ZERO,
            ..*before
        };
    }
    landed
}

/// Goes out of one contact. Whether it carries.
fn leave(
    around: &Around<'_>,
    shape: &WalkerShape,
    body: &mut Flyer,
    (frame, contact): (&Frame, &Contact),
    slides: &mut Slides,
) -> bool {
    let out_of = frame.upright.transpose();
    let mut velocity = frame.upright * body.velocity;
    let mut landed = false;
    let way = if shape.carries(contact.normal.y, contact.face_up, LEAST_LANDING_LIP_UP) {
        if velocity.y <= 0.0 {
            landed = true;
            velocity.y = 0.0;
        }
        DVec3::Y * (contact.depth / contact.normal.y).min(shape.radius_m)
    } else {
        slides.note(contact.normal);
        velocity = slide(velocity, contact.normal);
        contact.normal * contact.depth
    };
    body.velocity = out_of * velocity;
    // A thing in the axis is left by up to the length of the body. No such push leads through what stands there, as a floor: then
    // what the lowest ball meets is left, and the thing has to go.
    let is_long = contact.depth > shape.radius_m;
    if !is_long || around.is_free(&body.place, out_of * way) {
        body.place = around.carried(&body.place, out_of * way);
    } else if let Some(lowest) = around.in_ball(frame, shape.radius_m, TOUCH_M) {
        return leave(around, shape, body, (frame, &lowest), slides);
    }
    landed
}

/// After a landing, puts the feet where walking would.
fn settle(around: &Around<'_>, shape: &WalkerShape, body: &mut Flyer) {
    let (frame, near) = (around.frame(&body.place), 0.5 * shape.radius_m);
    let Some(y) = around.floor(&frame, shape, -shape.radius_m, (near, near)) else {
        return;
    };
    let up = frame.upright.transpose() * DVec3::Y;
    let place = around.carried(&body.place, up * y);
    if around
        .overlap(&around.frame(&place), shape, TOUCH_M)
        .is_none()
    {
        body.place = place;
    }
}

/// What is left of a motion along a contact that does not carry. A run against a steep slope is stopped before it can
/// turn into a climb, and a ceiling stops a rise.
fn slide(mut motion: DVec3, normal: DVec3) -> DVec3 {
    let clip = |motion: DVec3, normal: DVec3| motion - normal * motion.dot(normal).min(0.0);
    if normal.y < CEILING_UP {
        motion.y = motion.y.min(0.0);
    } else if normal.y > 0.0
        && let Some(way) = normal.with_y(0.0).try_normalize()
    {
        motion = clip(motion, way);
    }
    clip(motion, normal)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_against_a_steep_slope_does_not_climb() {
        let normal = DVec3::new(-55f64.to_radians().sin(), 55f64.to_radians().cos(), 0.0);
        let after = slide(DVec3::new(6.0, 0.0, 1.0), normal);
        assert!(after.y <= 1e-12, "{after}");
        let along = (after.z - 1.0).abs();
        assert!(along < 1e-12, "along the slope it goes on: {after}");
    }

    #[test]
    fn a_ceiling_stops_a_rise_but_not_a_run() {
        let after = slide(DVec3::new(3.0, 4.0, 0.0), DVec3::NEG_Y);
        assert_eq!(after, DVec3::new(3.0, 0.0, 0.0));
    }
}

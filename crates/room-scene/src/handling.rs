//! What who walks does to what is loose: pushes it by walking into it, lifts, carries and throws it, and shoots at it.
//!
//! All of it goes by `trace`, so through faces and portals too. What is held is drawn towards a place before the eye; on which way
//! it is seen from there is tried in turn: straight, and through each portal that is near.

use antipode_deformation::{Place, Trace, Traveller, What, trace};
use glam::{DQuat, DVec3};

use crate::bodies::{Body, Load, Owner};
use crate::hints::RoomHint;
use crate::scene::RoomScene;
use crate::tuning::{
    BULLET_PUSH_N_S, GRASP_REACH_M, HOLD_M, HOLD_RATE, HURL_SPEED_M_S, LIFT_KG, LIGHT_KG, PUSH_N,
    PUSH_REACH_M, RADIUS_M, SHAPE, SLIPS_AFTER_S, SLIPS_M, SPRINT_FACTOR, STEP_S, SWINGS_RAD,
    THROW_RISE, WALK_SPEED_M_S, WALKER_MASS_KG,
};
use crate::walk::Steer;

/// How high above the middle of the lowest ball who walks pushes, as shares of the body, and to which sides, radians.
const HEIGHTS: [f64; 3] = [0.0, 0.45, 0.9];
const SIDES: [f64; 3] = [0.0, 0.6, -0.6];
/// A push is so much of the way from the middle to where it is felt: who pushes sees to it that it does not topple.
const OFF_MIDDLE: f64 = 0.25;
/// What is nearer below the feet than this, felt metres, is stood on.
const STANDS_M: f64 = 0.06;
/// What of its size a way may miss what it is to lead to.
const MISSES: f64 = 0.2;

/// What is in the hands of who walks.
#[derive(Clone, Copy, Debug, Default)]
pub struct Grasp {
    /// Whose body is held.
    pub held: Option<Owner>,
    /// For how long it has been farther than [`SLIPS_M`] from where it is to be held, seconds.
    astray_s: f64,
}

/// How something loose is seen from the eye.
struct Sighted {
    /// Felt displacement from the eye in the axes of who looks.
    away: DVec3,
    /// From those axes to the scene's where it is.
    turn: DQuat,
    /// How large who looks would be there.
    scale: f64,
}

impl RoomScene {
    /// Pushes what is in the way of who walks.
    pub(crate) fn push_bodies(&mut self, steer: &Steer) {
        let up = self.up();
        let (ahead, right) = self.look.level(up);
        let asked = (ahead * steer.forward + right * steer.strafe).clamp_length_max(1.0);
        let Some(way) = asked.try_normalize() else {
            return;
        };
        let pace = if steer.sprint { SPRINT_FACTOR } else { 1.0 };
        let speed = WALK_SPEED_M_S * pace * asked.length();
        let mut pushed = Vec::new();
        for height in HEIGHTS {
            let from = self.above(&self.walker.body.place, SHAPE.axis_m() * height);
            for side in SIDES {
                let w = DQuat::from_axis_angle(up, side) * way;
                let path = self.reach_for(&from, w, RADIUS_M + PUSH_REACH_M);
                if let Some(owner) = self.loose_hit(&path)
                    && !pushed.contains(&owner)
                {
                    pushed.push(owner);
                    self.push(owner, &path, way * speed);
                }
            }
        }
    }

    fn reach_for(&self, from: &Place, w: DVec3, length: f64) -> Trace {
        let solids = self.all_solids();
        trace(&self.space, from, w, length, &solids, &Traveller::Body)
    }

    /// Whose body a path has hit, if that is loose.
    fn loose_hit(&self, path: &Trace) -> Option<Owner> {
        match path.hit()?.what {
            What::Object(number, _) => match Owner::numbered(number) {
                Owner::Object(object) if self.room().objects[object].mass.is_none() => None,
                owner => Some(owner),
            },
            What::Wall(..) => None,
        }
    }

    /// Who stands on something loose weighs on it.
    pub(crate) fn weigh_on_bodies(&mut self) {
        let load = self.load();
        self.bodies.bear(load);
    }

    fn load(&self) -> Option<(Owner, Load)> {
        if !self.walker.grounded {
            return None;
        }
        let middle = self.walker.body.place;
        let down = -self.felt_up(&middle);
        let path = self.reach_for(&middle, down, RADIUS_M + STANDS_M);
        let owner = self.loose_hit(&path)?;
        let at = path.place.point;
        let mass_kg = WALKER_MASS_KG * path.place.scale.powi(3);
        Some((owner, Load { at, mass_kg }))
    }

    /// Pushes a body for a step, at most until it goes at that felt velocity of who pushes.
    fn push(&mut self, owner: Owner, path: &Trace, velocity: DVec3) {
        let there = path.place;
        let wish = there.turn * velocity * there.scale;
        let force = PUSH_N * there.scale.powi(4);
        let Some(body) = self.bodies.of(owner) else {
            return;
        };
        let way = wish.normalize_or_zero();
        let scale = body.place.scale;
        let lacks = wish.length() - body.velocity.dot(way) * scale;
        let gives = lacks.min(force * STEP_S / body.mass_kg());
        if gives > 0.0 {
            let at = body.place.point.lerp(there.point, OFF_MIDDLE);
            body.strike(at, way * (gives / scale));
        }
    }

    /// Takes hold of what the crosshair is on, or lets go of what is held.
    pub(crate) fn grasp(&mut self) {
        if self.release().is_some() {
            return;
        }
        let eye = self.walker.eye_place(&self.space, self.up());
        let path = self.reach_for(&eye, self.look.front(), GRASP_REACH_M);
        let Some(owner) = self.loose_hit(&path) else {
            self.hint(RoomHint::NothingToLift);
            return;
        };
        let most = LIFT_KG * path.place.scale.powi(3);
        match self.bodies.of(owner) {
            Some(body) if body.mass_kg() <= most => {
                body.held = true;
                self.grasp = Grasp {
                    held: Some(owner),
                    astray_s: 0.0,
                };
            }
            _ => self.hint(RoomHint::TooHeavy),
        }
    }

    /// Lets go of what is held; whose body it is.
    pub(crate) fn release(&mut self) -> Option<Owner> {
        let owner = self.grasp.held.take()?;
        if let Some(body) = self.bodies.of(owner) {
            (body.held, body.leaves) = (false, true);
        }
        Some(owner)
    }

    /// Throws what is held, to where the crosshair is and a little above; whether something was.
    pub(crate) fn hurl(&mut self) -> bool {
        let Some(owner) = self.grasp.held else {
            return false;
        };
        let sighted = self.sighted(owner);
        self.release();
        let up = self.up();
        let front = self.look.front();
        let own = self.walker.body.velocity;
        if let (Some(seen), Some(body)) = (sighted, self.bodies.of(owner)) {
            let mass = body.mass_kg() / seen.scale.powi(3);
            let speed = HURL_SPEED_M_S * (LIGHT_KG / mass).sqrt().min(1.0);
            let velocity = (front + up * THROW_RISE) * speed + own;
            let wish = seen.turn * velocity * (seen.scale / body.place.scale);
            let by = wish - body.velocity;
            body.strike(body.place.point, by);
        }
        true
    }

    /// Draws what is held to before the eye.
    pub(crate) fn carry_held(&mut self) {
        let Some(owner) = self.grasp.held else {
            return;
        };
        let front = self.look.front();
        let own = self.walker.body.velocity;
        let sighted = self.sighted(owner);
        let held = sighted.zip(self.bodies.of(owner));
        let lacks_m = held.map_or(f64::INFINITY, |(seen, body)| {
            let larger = body.place.scale / seen.scale;
            let hold_m = HOLD_M + body.reach_m * larger;
            // It goes round who turns about, and not through them.
            let next = turned_at_most(seen.away, front, SWINGS_RAD) * hold_m;
            let pull = (next - seen.away) * HOLD_RATE.0;
            let velocity = pull.clamp_length_max(HOLD_RATE.1) + own;
            let wish = seen.turn * velocity / larger;
            let by = wish - body.velocity;
            body.hold(by);
            (front * hold_m - seen.away).length()
        });
        // A picture that comes late turns far in one step.
        let astray_s = &mut self.grasp.astray_s;
        *astray_s = if lacks_m > SLIPS_M {
            *astray_s + STEP_S
        } else {
            0.0
        };
        let slips = lacks_m.is_infinite() || *astray_s > SLIPS_AFTER_S;
        if slips {
            self.release();
        }
    }

    /// How something loose is seen from the eye, if it is.
    fn sighted(&mut self, owner: Owner) -> Option<Sighted> {
        let eye = self.walker.eye_place(&self.space, self.up());
        let body = self.bodies.of(owner)?;
        let (point, size) = (body.place.point, body.reach_m * body.place.scale);
        let front = self.look.front();
        let into = self.space.carry(&eye, front, &Traveller::Body).inverse();
        let ways = self.space.portals().iter().map(|it| it.map.inverse());
        let images = ways.map(|back| back.transform_point3(point));
        let images: Vec<_> = std::iter::once(point).chain(images).collect();
        images.into_iter().find_map(|image| {
            let away = into * (image - eye.point);
            let length = away.length();
            if length > GRASP_REACH_M + SLIPS_M + size {
                return None;
            }
            let w = away.try_normalize()?;
            let path = trace(&self.space, &eye, w, length, &self.solids, &Traveller::Body);
            let near =
                path.hit().is_none() && path.place.point.distance(point) < MISSES * size.max(0.1);
            near.then_some(Sighted {
                away,
                turn: path.place.turn,
                scale: path.place.scale,
            })
        })
    }

    /// Bullets give what they hit a push.
    pub(crate) fn push_by_bullets(&mut self) {
        for (what, place, w) in std::mem::take(&mut self.things.blows) {
            let What::Object(number, _) = what else {
                continue;
            };
            if let Some(body) = self.bodies.of(Owner::numbered(number)) {
                let gives = BULLET_PUSH_N_S * place.scale.powi(4) / body.mass_kg();
                body.strike(place.point, w * (gives / body.place.scale));
            }
        }
    }
}

/// The direction that is turned from one towards another, of length 1, by at most so many radians.
fn turned_at_most(from: DVec3, to: DVec3, most_rad: f64) -> DVec3 {
    let angle = from.angle_between(to);
    // Opposite directions have every perpendicular for an axis.
    let axis = from.cross(to).try_normalize();
    let axis = axis.unwrap_or_else(|| to.any_orthonormal_vector());
    let back = (angle - most_rad).max(0.0);
    DQuat::from_axis_angle(axis, -back) * to
}

impl Body {
    /// Is held for a step, and stops turning.
    fn hold(&mut self, by: DVec3) {
        self.strike(self.place.point, by);
        self.spin *= 0.8;
    }
}

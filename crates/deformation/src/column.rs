//! The body of who walks: balls above each other along felt up, and what they touch.
//!
//! The lowest ball's middle is where the body is; the rest is found by `trace` upwards, so that a head that reaches into
//! another box has the size that things have there. Solids are met in felt metres: corners are carried there by
//! A = K^-1, K being that of the boxes that a ball's middle is in.

use glam::{DMat3, DQuat, DVec3};

use crate::cut::show_cut;
use crate::gravity::felt_gravity;
use crate::place::Place;
use crate::scene::{SceneQuery, Void};
use crate::space::{Space, Traveller};
use crate::trace::trace;
use crate::triangle::{Touch, catch_ball, closest_to_origin};
use crate::tuning::{BALLS_APART, LEAST_LIP_UP, TOUCH_M};
use crate::walker::WalkerShape;

/// What surrounds a body.
#[derive(Clone, Copy)]
pub struct Around<'a> {
    /// The boxes.
    pub space: &'a Space,
    /// The solids.
    pub scene: &'a dyn SceneQuery,
    /// Gravity of the scene, m/s^2.
    pub g: DVec3,
    /// Felt direction that boxes of one way are told by.
    pub heading: DVec3,
}

/// Felt metres of the body's own size about a place, turned so that y is felt up.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// The place.
    pub place: Place,
    /// Turns felt directions of the body's own axes so that felt up is y.
    pub upright: DMat3,
    /// From the scene.
    pub into: DMat3,
    /// To the scene.
    pub out: DMat3,
}

/// Something that reaches into a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Direction of length 1 in which the body leaves it, in its frame.
    pub normal: DVec3,
    /// How upright its face is, to the side of the body.
    pub face_up: f64,
    /// How far it has to leave, felt metres.
    pub depth: f64,
}

impl Around<'_> {
    /// Takes the body's own felt displacements at a place to those of the scene.
    pub fn carry(&self, place: &Place) -> DMat3 {
        self.space.carry(place, self.heading, &Traveller::Body)
    }

    /// Felt up at a place in the body's own axes, of length 1.
    pub fn up(&self, place: &Place) -> DVec3 {
        -felt_gravity(self.carry(place), self.g)
            .try_normalize()
            .unwrap_or(DVec3::NEG_Y)
    }

    /// The frame about a place.
    pub fn frame(&self, place: &Place) -> Frame {
        let k = self.carry(place);
        let up = self.up(place);
        let upright = DMat3::from_quat(DQuat::from_rotation_arc(up, DVec3::Y));
        Frame {
            place: *place,
            upright,
            into: upright * k.inverse(),
            out: k * upright.transpose(),
        }
    }

    /// Where somebody gets to who goes that far, felt metres, unless a wall of an aberration is in the way.
    pub fn carried(&self, place: &Place, felt: DVec3) -> Place {
        let length = felt.length();
        if length == 0.0 {
            return *place;
        }
        let (space, w) = (self.space, felt / length);
        trace(space, place, w, length, &Void, &Traveller::Body).place
    }

    /// Whether nothing solid is on a way from a place, in felt metres by its axes.
    pub fn is_free(&self, place: &Place, felt: DVec3) -> bool {
        let length = felt.length();
        if length == 0.0 {
            return true;
        }
        let w = felt / length;
        let path = trace(self.space, place, w, length, self.scene, &Traveller::Body);
        path.hit().is_none()
    }

    /// Shows triangles near a place, in a frame about it, and whether they are solid from both sides: those within `reach`
    /// of it along each axis of the frame, `low` and `high` along up.
    fn show(
        &self,
        frame: &Frame,
        reach: f64,
        (low, high): (f64, f64),
        look: &mut dyn FnMut([DVec3; 3], bool),
    ) {
        let middle = frame.place.point + frame.out * DVec3::new(0.0, 0.5 * (low + high), 0.0);
        let half = frame.out.abs() * DVec3::new(reach, 0.5 * (high - low), reach);
        let (from, to) = (middle - half, middle + half);
        let felt = |corners: [DVec3; 3]| corners.map(|it| frame.into * (it - frame.place.point));
        let mut show = |corners, two_sided| look(felt(corners), two_sided);
        show_cut(self.space, self.scene, &frame.place, (from, to), &mut show);
    }

    /// What reaches deepest into a ball about a place, if it does by more than `tolerance`. A ball is pushed to the side
    /// of a surface that its middle is on.
    pub fn in_ball(&self, frame: &Frame, radius: f64, tolerance: f64) -> Option<Contact> {
        let mut deepest: Option<Contact> = None;
        let mut nearest = radius - tolerance;
        self.show(frame, radius, (-radius, radius), &mut |corners, _| {
            let closest = closest_to_origin(corners);
            let away = closest.length();
            if away >= nearest {
                return;
            }
            nearest = away;
            let [a, b, c] = corners;
            let face = (b - a).cross(c - a).normalize_or(DVec3::Y);
            let normal = if away > 1e-9 * radius {
                -closest / away
            } else {
                face
            };
            deepest = Some(Contact {
                normal,
                face_up: face.y * normal.dot(face).signum(),
                depth: radius - away,
            });
        });
        deepest
    }

    /// Where the lowest ball stands: the height, in a frame about it, at which it is carried at points no more than `rise`
    /// above `feet_y`, with its feet no more than `snap` below that. Ground is read off, not integrated: where one
    /// stands depends on the place alone, not on how one came there.
    pub fn floor(
        &self,
        frame: &Frame,
        shape: &WalkerShape,
        feet_y: f64,
        (rise, snap): (f64, f64),
    ) -> Option<f64> {
        self.touch(frame, shape, (feet_y - snap, feet_y + rise), |touch| {
            let normal_up = (touch.centre_y - touch.contact_y) / shape.radius_m;
            touch.centre_y - shape.radius_m >= feet_y - snap
                && touch.contact_y <= feet_y + rise + TOUCH_M
                && shape.carries(normal_up, touch.face_up, LEAST_LIP_UP)
        })
    }

    /// The greatest height of the lowest ball's middle at a touch that is wanted, with what lies between two heights.
    pub fn touch(
        &self,
        frame: &Frame,
        shape: &WalkerShape,
        heights: (f64, f64),
        wanted: impl Fn(&Touch) -> bool,
    ) -> Option<f64> {
        let mut highest: Option<f64> = None;
        let radius = shape.radius_m;
        let mut look = |corners: [DVec3; 3]| {
            if let Some(touch) = catch_ball(corners, radius)
                && highest.is_none_or(|best| touch.centre_y > best)
                && wanted(&touch)
            {
                highest = Some(touch.centre_y);
            }
        };
        self.show(frame, radius, heights, &mut |corners, two_sided| {
            look(corners);
            if two_sided {
                let [a, b, c] = corners;
                look([a, c, b]);
            }
        });
        highest
    }

    /// What reaches deepest into a body, if it does by more than `tolerance`, in the frame about its lowest ball.
    pub fn overlap(&self, frame: &Frame, shape: &WalkerShape, tolerance: f64) -> Option<Contact> {
        let mut deepest = self.in_ball(frame, shape.radius_m, tolerance);
        let axis_m = shape.axis_m();
        let up = frame.upright.transpose() * DVec3::Y;
        let balls = (axis_m / (shape.radius_m * BALLS_APART)).ceil() as usize;
        let mut at = frame.place;
        for ball in 1..=balls {
            let (space, between) = (self.space, axis_m / balls as f64);
            let path = trace(space, &at, up, between, self.scene, &Traveller::Body);
            if let Some(hit) = path.hit() {
                // The axis goes through something: the whole of what is beyond has to come out.
                let normal = self.felt_in(frame, &path.place, hit.felt_normal);
                let passed = between * (ball - 1) as f64 + path.length;
                let contact = Contact {
                    normal: normal.normalize_or(DVec3::NEG_Y),
                    face_up: normal.y,
                    depth: (axis_m - passed) * normal.y.abs() + shape.radius_m,
                };
                return if contact.depth > tolerance {
                    Some(contact)
                } else {
                    deepest
                };
            }
            at = path.place;
            let upper = Frame {
                place: at,
                ..if is_alike(&at, &frame.place) {
                    *frame
                } else {
                    self.frame(&at)
                }
            };
            let least = deepest.map_or(tolerance, |contact| contact.depth);
            if let Some(contact) = self.in_ball(&upper, shape.radius_m, least) {
                let away = upper.upright.transpose() * (contact.normal * contact.depth);
                let way = self.felt_in(frame, &at, away);
                deepest = Some(Contact {
                    normal: way.normalize_or(contact.normal),
                    depth: way.length(),
                    ..contact
                });
            }
        }
        deepest
    }

    /// A felt direction at a place, in the frame about another.
    fn felt_in(&self, frame: &Frame, there: &Place, felt: DVec3) -> DVec3 {
        // Behind a portal own axes and sizes are the same.
        if there.stack == frame.place.stack || there.passage != frame.place.passage {
            return frame.upright * felt;
        }
        frame.into * (self.carry(there) * felt)
    }
}

/// Whether the same frame does for two places near each other.
fn is_alike(one: &Place, other: &Place) -> bool {
    one.stack == other.stack && one.passage == other.passage
}

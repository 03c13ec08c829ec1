//! What a drag of a handle does to what is held: the point of the room that was taken hold of stays under the pointer, on its line
//! or plane, and through the chain by which it was seen when the drag began.

use antipode_deformation::Chain;
use glam::{DVec2, DVec3};

use super::handles::{Handle, Handles, Held};
use super::snap::Snap;
use super::through::Through;

/// The least size that a drag makes of something, as a share.
const SMALLEST: f64 = 0.01;
/// A drag that goes up or down by less than this share of its way aside is meant to go aside.
const ASIDE: f64 = 0.5;
/// A plane that is seen at less than this, a sine, is not dragged in.
const EDGE_ON: f64 = 0.06;

/// What a drag does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// Moves it, metres of the scene.
    Move(DVec3),
    /// Turns it about an axis of the scene, of length 1, by the right-hand rule; radians.
    Turn(DVec3, f64),
    /// Makes it so many times as large along each of the handles' axes.
    Scale(DVec3),
    /// Makes it feel so many times as long.
    Feel(f64),
}

/// A drag of a handle.
#[derive(Clone, Debug, PartialEq)]
pub struct Drag {
    /// Which handle.
    pub handle: Handle,
    /// Through what it is seen.
    pub chain: Chain,
    held: Held,
    reach_m: f64,
    /// The normal of the plane in which it is dragged, if it is.
    normal: DVec3,
    /// The point that was taken hold of.
    grabbed: DVec3,
}

impl Drag {
    /// Takes hold of a handle at a place of the picture.
    pub fn begin(
        through: &Through<'_>,
        handles: &Handles,
        handle: Handle,
        at: DVec2,
    ) -> Option<Self> {
        let mut drag = Self {
            handle,
            chain: through.chain.clone(),
            held: handles.held,
            reach_m: handles.reach_m,
            normal: DVec3::Y,
            grabbed: handles.held.origin,
        };
        if let Handle::Across(axis) | Handle::About(axis) = handle {
            drag.normal = handles.held.axes.col(axis);
        }
        drag.grabbed = drag.under(through, at)?;
        Some(drag)
    }

    /// Takes hold of what is held itself, where it is seen: it is moved level, or upright where the ground is seen edge-on.
    pub fn begin_body(
        through: &Through<'_>,
        held: Held,
        grabbed: DVec3,
        at: DVec2,
    ) -> Option<Self> {
        let v = through.leg(at)?.velocity.normalize();
        let normal = if v.y.abs() < 4.0 * EDGE_ON {
            // In a plane of the room, so that what goes to the side goes neither nearer nor farther.
            if v.x.abs() > v.z.abs() {
                DVec3::X
            } else {
                DVec3::Z
            }
        } else {
            DVec3::Y
        };
        Some(Self {
            handle: Handle::Body,
            chain: through.chain.clone(),
            held,
            reach_m: 1.0,
            normal,
            grabbed,
        })
    }

    /// The point that was taken hold of, if it were under that place of the picture.
    fn under(&self, through: &Through<'_>, at: DVec2) -> Option<DVec3> {
        let line = |axis: usize| through.on_line(at, self.held.origin, self.held.axes.col(axis));
        match self.handle {
            Handle::Along(axis) | Handle::Size(axis) | Handle::Felt(axis) => line(axis),
            Handle::Across(_) | Handle::About(_) | Handle::Body => {
                let origin = match self.handle {
                    Handle::Body => self.grabbed,
                    _ => self.held.origin,
                };
                let v = through.leg(at)?.velocity.normalize();
                let is_flat = v.dot(self.normal).abs() < EDGE_ON;
                (!is_flat).then(|| through.on_plane(at, origin, self.normal))?
            }
        }
    }

    /// What it does when the pointer has come to a place of the picture. None where nothing of the line or plane is seen there.
    pub fn change(&self, through: &Through<'_>, at: DVec2, snap: &Snap) -> Option<Change> {
        let now = self.under(through, at)?;
        let moved = now - self.grabbed;
        let arm = |point: DVec3| point - self.held.origin;
        Some(match self.handle {
            Handle::Along(axis) => {
                let along = self.held.axes.col(axis);
                Change::Move(along * self.stepped(along, moved, snap))
            }
            Handle::Across(axis) => {
                let sum = [(axis + 1) % 3, (axis + 2) % 3].map(|it| {
                    let along = self.held.axes.col(it);
                    along * self.stepped(along, moved, snap)
                });
                Change::Move(sum[0] + sum[1])
            }
            Handle::Body if snap.grid_m <= 0.0 => Change::Move(moved),
            Handle::Body => {
                // What is dragged aside stays on the ground that it stands on: no hand is level to the pixel.
                let aside_m = moved.with_y(0.0).length();
                let moved = if self.normal.y == 0.0 && moved.y.abs() < ASIDE * aside_m {
                    moved.with_y(0.0)
                } else {
                    moved
                };
                let all = DVec3::AXES.map(|along| along * self.stepped(along, moved, snap));
                let is_free = |along: &DVec3| along.dot(self.normal).abs() < 0.99;
                Change::Move(all.into_iter().filter(is_free).sum())
            }
            Handle::About(_) => {
                let (a, b) = (arm(self.grabbed), arm(now));
                let rad = self.normal.dot(a.cross(b)).atan2(a.dot(b));
                Change::Turn(self.normal, snap.turn(rad))
            }
            Handle::Size(axis) => {
                let along = self.held.axes.col(axis);
                // From the side that stays, so that what was taken hold of is where the pointer is.
                let reach = |point: DVec3| arm(point).dot(along) + self.held.stays_m[axis];
                let times = reach(now) / reach(self.grabbed);
                let mut factors = DVec3::ONE;
                factors[axis] = self.sized(axis, times, snap);
                Change::Scale(factors)
            }
            Handle::Felt(axis) => {
                let along = self.held.axes.col(axis);
                let outward = arm(self.grabbed).dot(along).signum();
                Change::Feel(2f64.powf(2.0 * outward * moved.dot(along) / self.reach_m))
            }
        })
    }

    /// How far it is moved along an axis, so that its origin lies on the grid of that axis.
    fn stepped(&self, along: DVec3, moved: DVec3, snap: &Snap) -> f64 {
        let from = self.held.origin.dot(along);
        let way = moved.dot(along);
        // What lies off the grid stays there until it is meant to be moved along this axis: else a drag to the side would take it
        // along the other axis of the plane, too.
        if way.abs() < (0.5 * snap.grid_m).max(1e-9) {
            return 0.0;
        }
        snap.length(from + way) - from
    }

    fn sized(&self, axis: usize, times: f64, snap: &Snap) -> f64 {
        let times = times.max(SMALLEST);
        let size = 2.0 * self.held.half[axis];
        // What grows about its own origin, as a group does, has no side that could come to the grid.
        let has_side = self.held.stays_m[axis] > 0.0;
        if size <= 0.0 || snap.grid_m <= 0.0 || !has_side {
            return times;
        }
        snap.length(size * times).max(snap.grid_m) / size
    }
}

//! What of a vehicle is there to be met by those who walk and by what is thrown: all of it, or, of one that stands in a door, what is
//! on one side of the leaf.
//!
//! The part on the other side lies there as the door takes it, rigid in the metres that vehicles move in. The cut itself is open: who is
//! beyond the leaf sees other land there, and no body.

use antipode_geometry::{Crossing, LevelMap, Metric};
use glam::{DQuat, DVec3, Vec3};
use rapier3d::math::Pose;
use rapier3d::parry::query;
use rapier3d::parry::query::details::ShapeCastOptions;
use rapier3d::parry::shape::{Ball, Capsule, SharedShape};

use super::cut::cut;
use super::{VehicleMotion, VehiclePhysics};
use crate::Obstacle;

/// Where a ray or a thrown thing meets a hull is looked for no nearer than this, in metres.
const NO_WAY_M: f64 = 1e-9;

/// An upright plane of a chart: there is something where `way . (p - at) >= 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// A point of the plane, metres of the chart.
    pub at: DVec3,
    /// A unit vector of the chart, away from what is cut off.
    pub way: DVec3,
}

impl Side {
    /// How far a point is from the plane, metres; negative where it is cut off.
    fn depth_m(&self, pos: DVec3) -> f64 {
        self.way.dot(pos - self.at)
    }

    /// The share of a straight way at which its part on this side begins, and the one at which that ends.
    fn shares(&self, from: DVec3, to: DVec3) -> Option<(f64, f64)> {
        let (a, b) = (self.depth_m(from), self.depth_m(to));
        let edge = a / (a - b);
        match (a >= 0.0, b >= 0.0) {
            (true, true) => Some((0.0, 1.0)),
            (true, false) => Some((0.0, edge)),
            (false, true) => Some((edge, 1.0)),
            (false, false) => None,
        }
    }
}

/// What of a vehicle is in one place.
#[derive(Clone)]
pub struct VehiclePart {
    /// Where the whole vehicle is, and how it moves, as this part has it.
    motion: VehicleMotion,
    /// The same in the vehicle's own chart.
    own: VehicleMotion,
    /// How the metres of its axes lie in the chart.
    level: LevelMap,
    /// The same in the vehicle's own chart.
    own_level: LevelMap,
    side: Option<Side>,
    mass_centre: DVec3,
    /// In the vehicle's axes, about its place.
    shape: SharedShape,
    triangles: Vec<[DVec3; 3]>,
}

impl std::fmt::Debug for VehiclePart {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("VehiclePart")
            .field("motion", &self.motion)
            .field("side", &self.side)
            .finish_non_exhaustive()
    }
}

impl VehiclePhysics {
    /// All of a vehicle.
    pub fn whole(&self, motion: &VehicleMotion) -> VehiclePart {
        let level = self.level_at(motion.point());
        VehiclePart {
            motion: *motion,
            own: *motion,
            level,
            own_level: level,
            side: None,
            mass_centre: self.tuning.mass_centre,
            shape: self.hull.shape.clone(),
            triangles: self.hull.triangles(DVec3::ZERO, DQuat::IDENTITY).collect(),
        }
    }

    /// What of a vehicle is on a side, with the vehicle where `crossing` takes it; none if nothing is.
    pub fn part(
        &self,
        motion: &VehicleMotion,
        crossing: &Crossing,
        side: Side,
    ) -> Option<VehiclePart> {
        let there = motion.carried(crossing);
        let level = self.level_at(there.point());
        let inside = |at: DVec3| side.depth_m(there.place + level.in_chart(there.turn * at));
        let mut triangles = Vec::new();
        for corners in self.hull.triangles(DVec3::ZERO, DQuat::IDENTITY) {
            cut(corners, inside, &mut triangles);
        }
        let corners: Vec<Vec3> = triangles.iter().flatten().map(|it| it.as_vec3()).collect();
        let shape = SharedShape::convex_hull(&corners)?;
        Some(VehiclePart {
            motion: there,
            level,
            own_level: self.level_at(motion.point()),
            side: Some(side),
            shape,
            triangles,
            own: *motion,
            mass_centre: self.tuning.mass_centre,
        })
    }
}

impl VehiclePart {
    /// Where the whole vehicle is, and how it moves, as this part has it.
    pub fn motion(&self) -> &VehicleMotion {
        &self.motion
    }

    /// The same part in another chart.
    #[must_use]
    pub fn carried(&self, space: &dyn Metric, crossing: &Crossing) -> Self {
        let side = self.side.map(|side| Side {
            at: crossing.point.pos + crossing.turn_vector(side.at - self.motion.place),
            way: crossing.turn_vector(side.way),
        });
        let is_same = self.level == LevelMap::SAME;
        Self {
            motion: self.motion.carried(crossing),
            level: if is_same {
                self.level
            } else {
                LevelMap::at(space, crossing.point)
            },
            side,
            ..self.clone()
        }
    }

    /// A place of the chart and a vector of it as the vehicle's own chart has them.
    pub fn taken_home(&self, at: DVec3, way: DVec3) -> (DVec3, DVec3) {
        if self.motion == self.own {
            return (at, way);
        }
        let back = self.own.turn * self.motion.turn.inverse();
        let arm = back * self.level.in_space(at - self.motion.place);
        let home = self.own.place + self.own_level.in_chart(arm);
        (home, back * way)
    }

    /// What characters cannot walk through.
    pub fn obstacle(&self) -> Obstacle {
        let (place, turn) = (self.motion.place, self.motion.turn);
        let placed = |corner: DVec3| place + self.level.in_chart(turn * corner);
        let corners = |it: &[DVec3; 3]| it.map(placed);
        Obstacle::new(
            self.motion.chart,
            self.triangles.iter().map(corners).collect(),
        )
    }

    /// The share of the way from `from` to `to` (m) at which something `radius_m` wide meets it, both
    /// in its chart. What begins inside meets it at once.
    pub fn meets(&self, from: DVec3, to: DVec3, radius_m: f64) -> Option<f64> {
        let (first, last) = match &self.side {
            Some(side) => side.shares(from, to)?,
            None => (0.0, 1.0),
        };
        let start = self
            .level
            .in_space(from.lerp(to, first) - self.motion.place);
        let way = self.level.in_space((to - from) * (last - first));
        if !way.is_finite() || way.length() < NO_WAY_M {
            return None;
        }
        let at = Pose::from_parts(DVec3::ZERO.as_vec3(), self.motion.turn.as_quat());
        let start = Pose::from_translation(start.as_vec3());
        let hit = query::cast_shapes(
            &start,
            way.as_vec3(),
            &Ball::new(radius_m as f32),
            &at,
            DVec3::ZERO.as_vec3(),
            self.shape.0.as_ref(),
            ShapeCastOptions::with_max_time_of_impact(1.0),
        );
        let share = f64::from(hit.ok().flatten()?.time_of_impact);
        Some(first + share * (last - first))
    }

    /// How an upright capsule with its feet at `feet` (m) touches it, if it is within `gap_m` of it: the
    /// level direction away from the body, and the velocity that the body has there in m/s.
    pub fn touches_capsule(
        &self,
        feet: DVec3,
        height_m: f64,
        radius_m: f64,
        gap_m: f64,
    ) -> Option<(DVec3, DVec3)> {
        if self.side.is_some_and(|side| side.depth_m(feet) < 0.0) {
            return None;
        }
        let motion = &self.motion;
        let body = Pose::from_parts(DVec3::ZERO.as_vec3(), motion.turn.as_quat());
        let half_m = (0.5 * height_m - radius_m).max(0.0);
        let capsule = Capsule::new_y(half_m as f32, radius_m as f32);
        let middle = feet + DVec3::Y * (0.5 * height_m);
        let off = self.level.in_space(middle - motion.place);
        let at = Pose::from_translation(off.as_vec3());
        let gap = query::distance(&body, self.shape.0.as_ref(), &at, &capsule);
        if f64::from(gap.ok()?.distance) > gap_m {
            return None;
        }
        let away = self.level.in_space(middle - motion.middle());
        let away = away.with_y(0.0).normalize_or(motion.ahead());
        let arm = off - motion.turn * self.mass_centre;
        Some((away, motion.velocity + motion.spin.cross(arm)))
    }
}

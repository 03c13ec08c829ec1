//! A pair of doors: two upright frames, and the isometry by which what goes into one comes out of the other.
//!
//! A leaf is a rectangle that stands upright. Its own axes are x through it, the way its front looks, y up
//! and z to the right of that, from its foot, in metres of the space there ([`LevelMap`]). Whoever passes one leaf keeps his place and his way in those axes and
//! has them in the axes of the other: in at the front, out at the back. Both faces work alike, and there and back
//! is the identity.
//!
//! Bodies go by these axes ([`Doorway::pass`]): with yaws a and b of the leaves a heading h becomes h + b - a, and with the
//! level maps M a place p becomes `foot_b + M_b R(b) R(a)^-1 M_a^-1 (p - foot_a)`. Pictures go by the isometry of the space ([`Doorway::eye`]): a place that one leaf's
//! foot sees at v is taken to the place that the other's foot sees at v. Where maps are symmetric about the upright, as
//! in flat space and through a hyperbolic lens, both are the same; on the sphere they are at the foot.

use glam::DVec3;

use crate::{Atlas, ChartPoint, Crossing, Eye, LevelMap, Map, Metric};

/// Half the width of the opening, metres.
pub const HALF_WIDTH_M: f64 = 0.95;
/// Height of the opening over the foot, metres.
pub const HEIGHT_M: f64 = 2.2;
/// How far the opening reaches below the foot, for ground that falls away to its sides, metres.
pub const BELOW_FOOT_M: f64 = 1.1;
/// A way is looked at as near as this to a foot, metres of the chart: the longest step of anything and the longest arm of a
/// camera, and the leaf itself.
const NEAR_M: f64 = 12.0;
/// Who has passed is so far behind the leaf at least, metres: no rounding brings anybody back.
const PAST_M: f64 = 1e-6;
/// How far ahead of an eye the points lie by which its axes are carried, metres.
const AXIS_M: f64 = 0.5;

/// One of the pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leaf {
    /// The middle of its lower edge.
    pub foot: ChartPoint,
    /// The heading that its front looks along, radians from +x towards +z of the frame at its foot, in which bodies have theirs.
    pub yaw: f64,
    /// How its metres lie in its chart.
    pub level: LevelMap,
}

impl Leaf {
    /// One that stands somewhere in a space.
    pub fn at<M: Metric + ?Sized>(space: &M, foot: ChartPoint, yaw: f64) -> Self {
        Self {
            foot,
            yaw,
            level: LevelMap::at(space, foot),
        }
    }

    /// The unit direction of its front, through it, in the frame at its foot.
    pub fn through(&self) -> DVec3 {
        DVec3::new(self.yaw.cos(), 0.0, self.yaw.sin())
    }

    /// The unit direction to the right of that.
    pub fn aside(&self) -> DVec3 {
        DVec3::new(-self.yaw.sin(), 0.0, self.yaw.cos())
    }

    /// A place of its chart in its own axes, metres.
    pub fn local(&self, pos: DVec3) -> DVec3 {
        let off = self.level.in_space(pos - self.foot.pos);
        DVec3::new(off.dot(self.through()), off.y, off.dot(self.aside()))
    }

    /// A place of its own axes in its chart.
    pub fn place(&self, local: DVec3) -> ChartPoint {
        let level = self.through() * local.x + self.aside() * local.z;
        self.foot
            .moved(self.level.in_chart(level) + DVec3::Y * local.y)
    }

    /// The upright plane through it in a chart that its foot was carried to: the unit direction across it, and how many metres of
    /// the chart one along it is.
    pub fn plane<M: Metric + ?Sized>(&self, space: &M, there: &Crossing) -> (DVec3, f64) {
        if self.level == LevelMap::SAME {
            return (there.turn_vector(self.through()), 1.0);
        }
        let aside = there.turn_vector(self.aside());
        let along = LevelMap::at(space, there.point).in_chart(aside);
        let across = DVec3::new(along.z, 0.0, -along.x);
        (across.normalize_or(DVec3::X), along.length())
    }

    /// The corners of the opening, metres of its own axes: from below on its left side round to below on its right.
    pub fn corners() -> [DVec3; 4] {
        let at = |y, z| DVec3::new(0.0, y, z);
        [
            at(-BELOW_FOOT_M, -HALF_WIDTH_M),
            at(HEIGHT_M, -HALF_WIDTH_M),
            at(HEIGHT_M, HALF_WIDTH_M),
            at(-BELOW_FOOT_M, HALF_WIDTH_M),
        ]
    }

    /// The eye of one who lies at its foot and looks along its front, through the picture of another.
    fn eye(&self, like: &Eye) -> Eye {
        Eye {
            point: self.foot,
            yaw: self.yaw,
            pitch: 0.0,
            roll: 0.0,
            ..*like
        }
    }
}

/// A way that leads through a leaf.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passing {
    /// Which leaf it goes into, 0 or 1.
    pub leaf: usize,
    /// The share of the way before it.
    pub share: f64,
    /// Whether it goes the way that the leaf's front looks.
    pub forward: bool,
}

/// A pair of leaves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Doorway {
    /// The older and the newer.
    pub leaves: [Leaf; 2],
}

impl Doorway {
    /// Where the straight way between two places of the charts goes through a leaf, if it does: through the first one of
    /// those that it goes through.
    pub fn met(&self, atlas: &dyn Atlas, from: ChartPoint, to: ChartPoint) -> Option<Passing> {
        let met = (0..2).filter_map(|leaf| self.met_one(atlas, leaf, from, to));
        met.min_by(|a, b| a.share.total_cmp(&b.share))
    }

    fn met_one(
        &self,
        atlas: &dyn Atlas,
        leaf: usize,
        from: ChartPoint,
        to: ChartPoint,
    ) -> Option<Passing> {
        let door = &self.leaves[leaf];
        let written = |point: ChartPoint| {
            let there = atlas.carry_near(point, door.foot)?.point;
            let is_near = there.pos.distance(door.foot.pos) < NEAR_M;
            is_near.then(|| door.local(there.pos))
        };
        let (from, to) = (written(from)?, written(to)?);
        let forward = to.x >= 0.0;
        if (from.x >= 0.0) == forward {
            return None;
        }
        let share = (from.x / (from.x - to.x)).clamp(0.0, 1.0);
        let at = from.lerp(to, share);
        let is_in = at.z.abs() <= HALF_WIDTH_M && (-BELOW_FOOT_M..=HEIGHT_M).contains(&at.y);
        is_in.then_some(Passing {
            leaf,
            share,
            forward,
        })
    }

    /// Takes a place of the charts near a leaf through it, as a body goes; none where the leaf's chart does not reach so far.
    pub fn carry(&self, atlas: &dyn Atlas, leaf: usize, point: ChartPoint) -> Option<Crossing> {
        self.taken(atlas, leaf, point, |local| local)
    }

    /// The same of who has gone through by a [`Passing`], and is behind the other leaf now.
    pub fn pass(&self, atlas: &dyn Atlas, by: Passing, point: ChartPoint) -> Option<Crossing> {
        self.taken(atlas, by.leaf, point, |local| {
            let x = if by.forward {
                local.x.max(PAST_M)
            } else {
                local.x.min(-PAST_M)
            };
            DVec3 { x, ..local }
        })
    }

    fn taken(
        &self,
        atlas: &dyn Atlas,
        leaf: usize,
        point: ChartPoint,
        amend: impl Fn(DVec3) -> DVec3,
    ) -> Option<Crossing> {
        let (from, to) = (&self.leaves[leaf], &self.leaves[1 - leaf]);
        let near = atlas.carry_near(point, from.foot)?;
        let there = to.place(amend(from.local(near.point.pos)));
        let own = atlas.cross(there).unwrap_or(Crossing::within(there));
        Some(Crossing {
            point: own.point,
            turn_rad: near.turn_rad + from.yaw - to.yaw + own.turn_rad,
        })
    }

    /// A place taken through a leaf by that isometry, in the picture of an eye.
    pub fn pictured(
        &self,
        space: &dyn Map,
        leaf: usize,
        eye: &Eye,
        point: ChartPoint,
    ) -> ChartPoint {
        let (from, to) = (self.leaves[leaf].eye(eye), self.leaves[1 - leaf].eye(eye));
        space.chart_point(&to, space.view_point(&from, point))
    }

    /// The eye that sees through a leaf what a given one sees through it, by the isometry of the space that takes that leaf
    /// to the other.
    pub fn eye(&self, space: &dyn Map, leaf: usize, eye: &Eye) -> Eye {
        let taken = |point| self.pictured(space, leaf, eye, point);
        let point = taken(eye.point);
        let level = Eye {
            point,
            yaw: 0.0,
            pitch: 0.0,
            roll: 0.0,
            ..*eye
        };
        // An isometry takes geodesics to geodesics: the way to a point ahead is taken to the way to where that point is.
        let axis = |view: DVec3| {
            let end = taken(space.along(eye, view, AXIS_M));
            let way = space.view_point(&level, end).truncate();
            level.to_chart(way).normalize_or(DVec3::X)
        };
        let (front, right) = (axis(DVec3::NEG_Z), axis(DVec3::X));
        let upright = Eye {
            yaw: front.z.atan2(front.x),
            pitch: front.y.clamp(-1.0, 1.0).asin(),
            ..level
        };
        let up = upright.up();
        Eye {
            roll: (-right.dot(up)).atan2(right.dot(upright.right())),
            ..upright
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use std::f64::consts::{PI, TAU};

    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    use super::*;
    use crate::{ChartId, Geometry, strategy};

    const RADIUS_M: f64 = 32.0;

    fn fixed() -> ProptestConfig {
        ProptestConfig {
            rng_seed: RngSeed::Fixed(23),
            failure_persistence: None,
            ..ProptestConfig::default()
        }
    }

    /// A leaf of a space: on a sphere in either hemisphere, up to the equator; of squares in the first or the next.
    fn leaf(geometry: Geometry, [far, angle, y, yaw]: [f64; 4], second: bool) -> Leaf {
        let (farthest_m, has_second) = match geometry {
            Geometry::Euclidean | Geometry::Hyperbolic => (200.0, false),
            Geometry::Spherical => (0.5 * PI * RADIUS_M, true),
            Geometry::HyperbolicWorld => (15.0, true),
        };
        let level_m = far * farthest_m;
        let height_m = RADIUS_M * (0.15 + 0.35 * y);
        let chart = if second && has_second {
            ChartId::SECOND
        } else {
            ChartId::FIRST
        };
        let pos = DVec3::new(level_m * angle.cos(), height_m, level_m * angle.sin());
        let space = strategy(geometry, RADIUS_M);
        Leaf::at(&*space, ChartPoint::new(chart, pos), yaw)
    }

    fn numbers() -> impl Strategy<Value = [f64; 4]> {
        (0.0..1.0f64, 0.0..TAU, 0.0..1.0f64, -PI..PI).prop_map(|(a, b, c, d)| [a, b, c, d])
    }

    fn doorway(geometry: Geometry, a: [f64; 4], b: [f64; 4], second: bool) -> Doorway {
        Doorway {
            leaves: [leaf(geometry, a, false), leaf(geometry, b, second)],
        }
    }

    proptest! {
        #![proptest_config(fixed())]

        #[test]
        fn there_and_back_is_the_identity_and_turns_nothing(
            a in numbers(), b in numbers(), second: bool,
            x in -0.9..0.9f64, y in 0.0..2.0f64, z in -0.9..0.9f64,
        ) {
            for geometry in Geometry::ALL {
                let space = strategy(geometry, RADIUS_M);
                let pair = doorway(geometry, a, b, second);
                let start = pair.leaves[0].place(DVec3::new(x, y, z));
                let there = pair.carry(&*space, 0, start).unwrap();
                let back = pair.carry(&*space, 1, there.point).unwrap();
                let home = space.carry(back.point, start.chart).unwrap();
                prop_assert!(home.point.pos.distance(start.pos) < 1e-12 * (1.0 + start.pos.length()));
                let turn = (there.turn_rad + back.turn_rad + home.turn_rad) / TAU;
                prop_assert!((turn - turn.round()).abs() < 1e-12, "{turn}");
            }
        }

        #[test]
        fn who_looks_through_sees_all_as_far_off_as_from_the_other_side_and_where_it_is(
            a in numbers(), b in numbers(), second: bool, yaw in -PI..PI, pitch in -1.2..1.2f64,
            x in -3.0..3.0f64, z in -3.0..3.0f64, u in -9.0..9.0f64, v in -9.0..9.0f64,
        ) {
            for geometry in Geometry::ALL {
                let space = strategy(geometry, RADIUS_M);
                let pair = doorway(geometry, a, b, second);
                let [near, far] = pair.leaves;
                let stand = near.place(DVec3::new(x, 1.6, z));
                let eye = Eye { point: stand, yaw, pitch, roll: 0.0, dial: 8.0, lift_m: 1.6 };
                let seen = pair.eye(&*space, 0, &eye);
                let back = pair.eye(&*space, 1, &seen);
                let home = space.carry(back.point, stand.chart).unwrap();
                prop_assert!(home.point.pos.distance(stand.pos) < 1e-9, "{geometry}");
                // A place that the leaf's foot sees at some view is seen by the eye as the other's foot sees it.
                let ahead = DVec3::new(u, 2.0, v);
                let (from, to) = (near.eye(&eye), far.eye(&eye));
                let here = near.place(ahead);
                let there = space.chart_point(&to, space.view_point(&from, here));
                let (own, other) = (space.view_point(&eye, here), space.view_point(&seen, there));
                let scale = 1.0 + own.truncate().length();
                prop_assert!((own - other).truncate().length() < 1e-8 * scale, "{geometry} {own} {other}");
                let (own_m, other_m) = (space.distance_m(stand, here, &eye), space.distance_m(seen.point, there, &seen));
                prop_assert!((own_m - other_m).abs() < 1e-8 * (1.0 + own_m), "{geometry} {own_m} {other_m}");
            }
        }
    }

    #[test]
    fn a_way_goes_through_the_opening_from_either_side_and_nowhere_else() {
        for geometry in Geometry::ALL {
            let space = strategy(geometry, RADIUS_M);
            let pair = doorway(geometry, [0.5, 1.0, 0.2, 0.7], [0.9, 4.0, 0.8, -2.0], true);
            let [near, far] = pair.leaves;
            for (side, y, z, is_through) in [
                (-0.2, 1.0, 0.9, true),
                (0.2, 0.0, -0.9, true),
                (-0.2, 2.1, 0.0, true),
                (-0.2, 1.0, 1.1, false),
                (0.2, 2.4, 0.0, false),
                (0.2, -1.0, 0.0, true),
                (0.2, -1.2, 0.0, false),
            ] {
                let from = near.place(DVec3::new(side, y, z));
                let to = near.place(DVec3::new(-0.5 * side, y, z));
                let met = pair.met(&*space, from, to);
                assert_eq!(met.is_some(), is_through, "{geometry} {side} {y} {z}");
                let Some(by) = met else { continue };
                assert!(by.leaf == 0 && (by.share - 2.0 / 3.0).abs() < 1e-9);
                let out = pair.pass(&*space, by, to).unwrap().point;
                let out = space.carry_near(out, far.foot).unwrap().point;
                let local = far.local(out.pos);
                assert!((local - DVec3::new(-0.5 * side, y, z)).length() < 1e-9);
                // Straight on it does not come back.
                let on = far.place(local + DVec3::X * (-2.0 * side));
                assert_eq!(pair.met(&*space, out, on), None);
            }
        }
    }

    /// To 1 %, wherever a leaf stands and however it looks: between its posts, over its sill, and as bodies find it.
    #[test]
    fn an_opening_is_as_large_in_the_space_wherever_it_stands() {
        for (geometry, radius_m, pos) in [
            (
                Geometry::HyperbolicWorld,
                60.305,
                DVec3::new(29.0, 9.0, 30.5),
            ),
            (
                Geometry::HyperbolicWorld,
                30.152,
                DVec3::new(-14.0, 5.0, 14.5),
            ),
            (
                Geometry::HyperbolicWorld,
                120.61,
                DVec3::new(2.0, 12.0, -60.0),
            ),
            (Geometry::Spherical, 64.0, DVec3::new(60.0, 8.0, 66.0)),
        ] {
            let space = strategy(geometry, radius_m);
            let eye = Eye::default();
            for turn in 0..12 {
                let foot = ChartPoint::new(ChartId::FIRST, pos);
                let leaf = Leaf::at(&*space, foot, f64::from(turn) * 0.5);
                let far_m = |a, b| space.distance_m(leaf.place(a), leaf.place(b), &eye);
                let post = DVec3::Z * HALF_WIDTH_M;
                let wide = far_m(-post, post) / (2.0 * HALF_WIDTH_M);
                let deep = far_m(-DVec3::X, DVec3::X) / 2.0;
                let high = far_m(DVec3::ZERO, DVec3::Y * HEIGHT_M) / HEIGHT_M;
                for share in [wide, deep, high] {
                    assert!(
                        (share - 1.0).abs() < 0.01,
                        "{geometry} {pos} {turn}: {share}"
                    );
                }
                let [a, b] = [-DVec3::X, DVec3::X].map(|it| it * 0.3);
                let pair = Doorway {
                    leaves: [leaf, leaf],
                };
                let beside = |z: f64| {
                    let [from, to] = [a, b].map(|it| leaf.place(it + DVec3::Z * z));
                    pair.met(&*space, from, to).is_some()
                };
                assert!(beside(0.99 * HALF_WIDTH_M) && !beside(1.01 * HALF_WIDTH_M));
            }
        }
    }

    #[test]
    fn who_stops_on_the_very_sill_does_not_go_back_by_going_on() {
        let space = strategy(Geometry::Euclidean, 0.0);
        let pair = doorway(
            Geometry::Euclidean,
            [0.3, 1.0, 0.2, 0.7],
            [0.9, 4.0, 0.8, 2.1],
            false,
        );
        let [near, far] = pair.leaves;
        let (from, to) = (near.place(DVec3::X * -0.1), near.place(DVec3::X * 1e-17));
        let by = pair.met(&*space, from, to).unwrap();
        let out = pair.pass(&*space, by, to).unwrap().point;
        assert_eq!(pair.met(&*space, out, far.place(DVec3::X * 0.1)), None);
    }
}

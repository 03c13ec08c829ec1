//! The plan: which chunks are to be there and at which level. Made on a worker, since a wide range
//! has tens of thousands of chunks to ask about; only the first is made on the spot.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use antipode_geometry::{ChunkCoord, Strategy};
use antipode_terrain::{Content, Field, Level, RIM_REACH_M};
use glam::{DVec2, Vec3Swizzles};

use crate::api::Detail;
use crate::levels::{choose, relax};
use crate::range::Range;
use crate::reaches::Reaches;

/// Chunks that take fewer pixels than this are not loaded, and those that are there already go
/// below half of it.
const LEAST_SPAN_PX: f64 = 0.5;
const KEPT_SPAN_PX: f64 = LEAST_SPAN_PX / 2.0;

/// Where the charts of a closed world meet, two meshes that do not know of each other end at one
/// line; there only this share of the error is let pass.
const RIM_SHARE: f64 = 0.25;

/// Share of [`Field::level_error_m`] that levels are chosen by. That is the error of the one vertex in
/// a hundred; it is far from what the land as a whole is off by, of which half is within a seventh.
/// With this share most of the land is within what is let pass, and levels stay in proportion: by
/// the whole of it rough biomes would be made in full as far as one can see.
const ERROR_SHARE: f64 = 0.2;

/// What is planned for a chunk that has a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Target {
    pub(crate) level: Level,
    /// To be loaded; else only kept if it is there already.
    pub(crate) wanted: bool,
}

/// Targets of every chunk with a surface in range and a little beyond.
#[derive(Debug)]
pub(crate) struct Plan {
    pub(crate) targets: HashMap<ChunkCoord, Target>,
    pub(crate) range: Range,
}

impl Plan {
    /// Nothing is to be there.
    pub(crate) fn nothing() -> Self {
        Self {
            targets: HashMap::new(),
            range: Range::Nothing,
        }
    }
}

/// What a plan is made from.
#[derive(Clone, Debug)]
pub(crate) struct Request {
    pub(crate) range: Range,
    pub(crate) detail: Option<Arc<dyn Detail>>,
    pub(crate) bodies: Reaches,
    /// Chunks that may have a surface because of an edit.
    pub(crate) near_edits: Arc<HashSet<ChunkCoord>>,
    pub(crate) before: Arc<Plan>,
}

/// A plan, and what it changes.
#[derive(Debug)]
pub(crate) struct Planned {
    pub(crate) plan: Plan,
    /// Chunks with another target than before, or none before.
    pub(crate) changed: Vec<ChunkCoord>,
}

impl Request {
    /// Makes the plan.
    pub(crate) fn plan(&self, field: &Field) -> Planned {
        let mut levels = HashMap::new();
        let mut unwanted = HashSet::new();
        for coord in self.range.kept() {
            if !self.near_edits.contains(&coord) && field.content(coord) != Content::Surface {
                continue;
            }
            let span_px = self.span_px(coord);
            if span_px < KEPT_SPAN_PX {
                continue;
            }
            if span_px < LEAST_SPAN_PX || !self.range.contains(coord) {
                unwanted.insert(coord);
            }
            levels.insert(coord, self.level(field, coord));
        }
        relax(&mut levels);
        let target = |(coord, level)| {
            let wanted = !unwanted.contains(&coord);
            (coord, Target { level, wanted })
        };
        let targets: HashMap<_, _> = levels.into_iter().map(target).collect();
        let before = &self.before.targets;
        let differs = |(coord, target): &(&ChunkCoord, &Target)| before.get(coord) != Some(target);
        let changed = targets.iter().filter(differs).map(|(&coord, _)| coord);
        Planned {
            changed: changed.collect(),
            plan: Plan {
                targets,
                range: self.range.clone(),
            },
        }
    }

    /// The level of a chunk as such, whatever its neighbours have.
    pub(crate) fn level(&self, field: &Field, coord: ChunkCoord) -> Level {
        let Some(detail) = &self.detail else {
            return Level::FULL;
        };
        let tolerance_px = detail.tolerance_px();
        if tolerance_px <= 0.0 || self.bodies.keeps(coord) {
            return Level::FULL;
        }
        let share = if meets_rim(&**field.strategy(), coord) {
            RIM_SHARE
        } else {
            1.0
        };
        let errors_m = errors_m(field, self.near_edits.contains(&coord));
        let before = self.before.targets.get(&coord).map(|target| target.level);
        choose(
            &errors_m,
            detail.pixels_per_metre(coord),
            tolerance_px * share,
            before,
        )
    }

    /// Pixels that a chunk takes from one end to the other; ground near bodies always counts.
    fn span_px(&self, coord: ChunkCoord) -> f64 {
        match &self.detail {
            Some(detail) if !self.bodies.keeps(coord) => detail.span_px(coord),
            _ => f64::INFINITY,
        }
    }
}

/// What each level may be off by, in metres. What was dug or built may be as thin as a cell of any
/// level, and is wholly lost then.
fn errors_m(field: &Field, edited: bool) -> [f64; Level::ALL.len()] {
    Level::ALL.map(|level| match level {
        Level::FULL => 0.0,
        _ if edited => f64::from(level.step_m()),
        _ => field.level_error_m(level) * ERROR_SHARE,
    })
}

/// Does the chunk touch the line where its chart ends?
fn meets_rim(strategy: &dyn Strategy, coord: ChunkCoord) -> bool {
    strategy.rim_m().is_some_and(|rim_m| {
        let (low, high) = (coord.min().xz(), coord.max().xz());
        let nearest_m = DVec2::ZERO.clamp(low, high).length();
        let farthest_m = low.abs().max(high.abs()).length();
        nearest_m <= rim_m + RIM_REACH_M && farthest_m >= rim_m
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::expect_used, reason = "tests fail by panicking")]
    use super::*;
    use antipode_geometry::{ChartPoint, Geometry, Hemisphere, strategy};
    use glam::DVec3;

    use crate::api::Reach;
    use crate::levels::faces;

    /// A flat picture with a pixel of that many radians, seen from a point.
    #[derive(Debug)]
    struct Flat {
        eye: DVec3,
        pixels_per_rad: f64,
        tolerance_px: f64,
    }

    impl Detail for Flat {
        fn pixels_per_metre(&self, coord: ChunkCoord) -> f64 {
            let nearest = self.eye.clamp(coord.min(), coord.max());
            self.pixels_per_rad / nearest.distance(self.eye).max(1e-6)
        }

        fn span_px(&self, coord: ChunkCoord) -> f64 {
            32.0 * self.pixels_per_metre(coord)
        }

        fn tolerance_px(&self) -> f64 {
            self.tolerance_px
        }
    }

    fn request(geometry: Geometry, radius_m: f64, flat: Flat, distance: u32) -> (Request, Field) {
        let space = strategy(geometry, radius_m);
        let field = Field::new(11, Arc::clone(&space));
        let eye = ChartPoint::a(flat.eye);
        let request = Request {
            range: Range::wished(&*space, eye, distance),
            detail: Some(Arc::new(flat)),
            bodies: Reaches::of(&[Reach::around(eye, 30.0)]),
            near_edits: Arc::default(),
            before: Arc::new(Plan::nothing()),
        };
        (request, field)
    }

    fn eye() -> Flat {
        Flat {
            eye: DVec3::new(16.0, 40.0, 16.0),
            pixels_per_rad: 700.0,
            tolerance_px: 0.5,
        }
    }

    #[test]
    fn levels_grow_coarser_with_distance_and_neighbours_differ_by_one() {
        let (request, field) = request(Geometry::Euclidean, f64::INFINITY, eye(), 16);
        let plan = request.plan(&field).plan;
        let mut counts = [0; 4];
        for (&coord, target) in &plan.targets {
            counts[target.level.index()] += 1;
            for next in faces(coord).filter_map(|next| plan.targets.get(&next)) {
                assert!(next.level.index().abs_diff(target.level.index()) <= 1);
            }
            if request.bodies.wants(coord) {
                assert_eq!(target.level, Level::FULL);
            }
        }
        assert!(counts[0] > 20 && counts[1] > counts[0], "{counts:?}");
    }

    #[test]
    fn exact_pictures_and_wishes_without_a_picture_are_full_throughout() {
        let exact = Flat {
            tolerance_px: 0.0,
            ..eye()
        };
        let (mut request, field) = request(Geometry::Euclidean, f64::INFINITY, exact, 10);
        let full = |request: &Request| {
            let plan = request.plan(&field).plan;
            plan.targets
                .values()
                .all(|target| target.level == Level::FULL)
        };
        assert!(full(&request));
        request.detail = None;
        assert!(full(&request));
    }

    #[test]
    fn chunks_under_half_a_pixel_are_not_loaded_but_those_near_bodies_are() {
        let tiny = Flat {
            pixels_per_rad: 1.0,
            ..eye()
        };
        let (mut request, field) = request(Geometry::Euclidean, f64::INFINITY, tiny, 4);
        let near = |plan: &Plan| {
            let wanted = plan.targets.iter().filter(|(_, target)| target.wanted);
            wanted.map(|(&coord, _)| coord).collect::<HashSet<_>>()
        };
        let small = near(&request.plan(&field).plan);
        // 32 m make half a pixel at 64 m.
        assert!(!small.is_empty());
        assert!(small.iter().all(|coord| coord.index.x.abs() <= 3));
        request.bodies = Reaches::of(&[Reach::whole(Hemisphere::A)]);
        assert!(near(&request.plan(&field).plan).len() > small.len());
    }

    #[test]
    fn edited_chunks_are_as_fine_as_what_may_be_lost_of_them() {
        let (mut request, field) = request(Geometry::Euclidean, f64::INFINITY, eye(), 16);
        let plan = request.plan(&field).plan;
        let coarse = plan
            .targets
            .iter()
            .find(|(_, target)| target.level.index() == 1);
        let (&coord, _) = coarse.expect("a coarse chunk");
        request.near_edits = Arc::new(HashSet::from([coord]));
        assert_eq!(request.plan(&field).plan.targets[&coord].level, Level::FULL);
    }

    #[test]
    fn a_plan_tells_what_it_changes() {
        let (mut request, field) = request(Geometry::Euclidean, f64::INFINITY, eye(), 8);
        let first = request.plan(&field);
        assert_eq!(first.changed.len(), first.plan.targets.len());
        request.before = Arc::new(first.plan);
        assert!(request.plan(&field).changed.is_empty());
        let moved = ChartPoint::a(eye().eye + DVec3::X * 32.0);
        request.range = Range::wished(&**field.strategy(), moved, 8);
        let second = request.plan(&field);
        assert!(!second.changed.is_empty() && second.changed.len() < second.plan.targets.len());
    }

    #[test]
    fn at_the_rim_both_charts_are_finer() {
        let far = Flat {
            eye: DVec3::new(0.0, 40.0, 0.0),
            ..eye()
        };
        let (request, field) = request(Geometry::Spherical, 256.0, far, 1);
        let space = field.strategy();
        let chunk_at = |x: f64| ChunkCoord::containing(ChartPoint::a(DVec3::new(x, 60.0, 0.0)));
        let rim_m = space.rim_m().unwrap_or_default();
        assert!(meets_rim(&**space, chunk_at(rim_m)));
        assert!(!meets_rim(&**space, chunk_at(rim_m - 64.0)));
        assert!(
            request.level(&field, chunk_at(rim_m)) <= request.level(&field, chunk_at(rim_m - 64.0))
        );
    }
}

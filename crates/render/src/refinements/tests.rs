//! What is drawn while the eye runs, against where it truly is.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use antipode_frame::{ChunkChange, Frame, Land};
use antipode_geometry::{ChartId, ChartPoint, Geometry, HyperbolicMap, picture};
use antipode_terrain::{Content, Field, march};
use glam::{DVec2, DVec3, IVec3};

use super::*;
use crate::gpu::Gpu;
use crate::plan::Planner;
use crate::plan::testing;

const HEIGHT_PX: u32 = 720;

/// Generated land ahead and about.
fn land(field: &Field, reach: i32) -> Arc<Land> {
    let mut land = Land::default();
    for x in -2..=reach {
        for (y, z) in (-2..=2).flat_map(|y| (-3..=3).map(move |z| (y, z))) {
            let coord = ChunkCoord {
                chart: ChartId::FIRST,
                index: IVec3::new(x, y, z),
            };
            if field.content(coord) == Content::Surface {
                let mesh = march(&field.samples(coord), field, coord);
                land.change(ChunkChange::Put(coord, Arc::new(mesh)));
            }
        }
    }
    Arc::new(land)
}

fn to_px(frame: &Frame, v: DVec3) -> DVec2 {
    let at = DVec2::new(
        frame.view.projection.sx * v.x,
        frame.view.projection.sy * v.y,
    ) / -v.z;
    let aspect = frame.view.projection.sy / frame.view.projection.sx;
    at * 0.5 * f64::from(HEIGHT_PX) * DVec2::new(aspect, 1.0)
}

/// The most that an edge in the picture strays, pixels.
fn true_error_px(store: &ChunkStore, frame: &Frame, land: &[ChunkLand], plan: &FramePlan) -> f64 {
    let view = frame.view.strategy.viewer(&frame.view.eye);
    let mut worst: f64 = 0.0;
    for choice in plan.chunks.iter().filter(|c| c.refine) {
        let coord = land[choice.place].coord;
        let chunk = &store.chunks[&coord];
        let refined = chunk.refined.as_ref().map(|r| {
            let eyes = r.rules.eyes_from(frame, &chunk.land);
            Subdivider::default().refine(&r.rules, &eyes, &chunk.source)
        });
        let mut triangles: Vec<[DVec3; 3]> = Vec::new();
        if let Some(refined) = refined.filter(|r| r.halved > 0) {
            for part in &refined.parts {
                let at = |i: u16| part.vertices[usize::from(i)].position().as_dvec3();
                let surface = part.sections[0].start as usize..part.sections[0].end as usize;
                let corners = part.indices[surface].as_chunks::<3>().0;
                triangles.extend(corners.iter().map(|c| c.map(at)));
            }
        } else {
            let at = |i: u32| chunk.source.vertices[i as usize].position().as_dvec3();
            let corners = chunk.source.indices.as_chunks::<3>().0;
            triangles.extend(corners.iter().map(|c| c.map(at)));
        }
        let of = |p: DVec3| view(ChartPoint::new(coord.chart, coord.origin() + p)).truncate();
        for corners in triangles {
            let seen = corners.map(of);
            if seen.iter().any(|v| v.z > -1e-3) {
                continue;
            }
            for i in 0..3 {
                let (a, b) = (corners[i], corners[(i + 1) % 3]);
                let middle = of(a.midpoint(b));
                let m = to_px(frame, middle);
                let half = DVec2::new(
                    0.5 * f64::from(HEIGHT_PX) * 16.0 / 9.0,
                    0.5 * f64::from(HEIGHT_PX),
                );
                if middle.z > -1e-3 || m.x.abs() > half.x || m.y.abs() > half.y {
                    continue;
                }
                let (p, q) = (to_px(frame, seen[i]), to_px(frame, seen[(i + 1) % 3]));
                let along = q - p;
                let off = if along.length() < 1e-6 {
                    0.0
                } else {
                    along.perp_dot(m - p).abs() / along.length()
                };
                worst = worst.max(off);
            }
        }
    }
    worst
}

/// Land, and an eye that looks along it, complete.
struct Run {
    store: ChunkStore,
    planner: Planner,
    frame: Frame,
    field: Field,
}

impl Run {
    fn begin(map: HyperbolicMap, dial: f64) -> Option<Self> {
        let gpu = Gpu::for_test()?;
        let space = picture(Geometry::Hyperbolic, 20.0, map, false);
        let field = Field::new(4, space.clone());
        let mut frame = testing::frame(&space);
        (frame.view.eye.dial, frame.view.eye.pitch) = (dial, -0.15);
        frame.view.fog_distance_m = 150.0;
        frame.content_mut().land = land(&field, 3);
        let mut run = Self {
            store: ChunkStore::new(&gpu),
            planner: Planner::default(),
            frame,
            field,
        };
        run.store.rush();
        run.go_to(4.0);
        run.store.end_rush();
        Some(run)
    }

    /// One frame, `x` metres east: how far off what is drawn is, and how far off it is said to be at most, pixels.
    fn go_to(&mut self, x: f64) -> (f64, f64) {
        let ground_m = self.field.surface_height(ChartId::FIRST, x, 4.0);
        self.frame.view.eye.point = ChartPoint::a(DVec3::new(x, ground_m + 1.62, 4.0));
        self.store.apply(&self.frame);
        let land_index = self.store.land();
        let mut plan = self.planner.plan(&self.frame, HEIGHT_PX, &land_index);
        self.store.refine(&self.frame, land_index.land(), &mut plan);
        let truth_px = true_error_px(&self.store, &self.frame, land_index.land(), &plan);
        (truth_px, plan.stats.error_px)
    }
}

const VIEWS: [(HyperbolicMap, f64); 3] = [
    (HyperbolicMap::Raised, 20.0),
    (HyperbolicMap::Horizon, 20.0),
    (HyperbolicMap::Raised, 10.0),
];
/// What a sprint covers in six steps of the world, the most that a frame takes: five frames a second, or fewer.
const SPRINT_M: f64 = 6.0 * 7.65 / 60.0;

#[test]
fn a_sprint_at_five_frames_a_second_is_drawn_true_however_slow_the_thread_is() {
    for (map, dial) in VIEWS {
        // Frames that the thread takes for what it was given.
        for slow in [1, 3, usize::MAX] {
            let Some(mut run) = Run::begin(map, dial) else {
                return;
            };
            for step in 1..=20 {
                run.store.refinements.hold(step % slow != 0);
                let (truth_px, told_px) = run.go_to(4.0 + SPRINT_M * step as f64);
                let at = format!("{map:?} {dial}, {slow}, {step}: {truth_px} {told_px}");
                assert!(truth_px <= told_px.min(2.0), "{at}");
                // The word for it, which the frame figures show, allows for more than there is, and for most above the
                // eye of the horizon map.
                let is_bounded = map == HyperbolicMap::Raised && slow <= 3;
                assert!(told_px <= 8.0 || !is_bounded, "{at}");
            }
        }
    }
}

#[test]
fn a_slow_thread_is_given_longer_ways_and_frames_leave_the_work_to_it() {
    for slow in [6, 9] {
        let Some(mut run) = Run::begin(HyperbolicMap::Raised, 20.0) else {
            return;
        };
        let mut left_behind = 0;
        for step in 1..=36 {
            run.store.refinements.hold(step % slow != 0);
            run.go_to(4.0 + SPRINT_M * step as f64);
            // The next frame, where it would refine all that it shows itself.
            run.frame.view.eye.point.pos.x += SPRINT_M;
            left_behind += usize::from(run.store.refinements.is_left_behind(&run.frame));
        }
        assert!(left_behind <= 3, "{slow}: {left_behind} of 36 frames");
    }
}

#[test]
fn who_comes_out_somewhere_else_sees_true_land_at_once() {
    for (map, dial) in VIEWS {
        let Some(mut run) = Run::begin(map, dial) else {
            return;
        };
        run.go_to(5.0);
        run.store.refinements.hold(true);
        let (truth_px, told_px) = run.go_to(40.0);
        assert!(truth_px <= 2.0, "{map:?} {dial}: {truth_px} {told_px}");
    }
}

#[test]
fn who_turns_round_sees_true_land_at_once() {
    for (map, dial) in VIEWS {
        let Some(mut run) = Run::begin(map, dial) else {
            return;
        };
        // A step, so that a set is made; and some frames to make it.
        let x = 5.0;
        for _ in 0..12 {
            run.go_to(x);
        }
        for yaw in [1.5, 3.0, 4.5] {
            run.frame.view.eye.yaw = yaw;
            run.store.refinements.hold(true);
            let (truth_px, told_px) = run.go_to(x);
            let at = format!("{map:?} {dial}, {yaw}: {truth_px} {told_px}");
            assert!(truth_px <= 2.0, "{at}");
        }
    }
}

#[test]
fn who_stands_still_again_is_drawn_with_no_more_than_before() {
    let Some(mut run) = Run::begin(HyperbolicMap::Raised, 20.0) else {
        return;
    };
    for step in 1..=8 {
        run.go_to(4.0 + SPRINT_M * f64::from(step));
    }
    for _ in 0..20 {
        run.go_to(4.0 + SPRINT_M * 8.0);
    }
    let shown = run.store.refinements.shown.clone();
    assert!(shown.is_some_and(|rules| rules.key.way.is_place()));
    assert!(!run.store.refinements.is_busy());
}

#[test]
fn nothing_is_under_way_for_ever_when_the_land_is_left_behind_and_none_of_the_next_needs_work() {
    for (map, dial) in VIEWS {
        let Some(mut run) = Run::begin(map, dial) else {
            return;
        };
        run.store.refinements.hold(true);
        run.go_to(5.5);
        assert!(run.store.refinements.is_busy(), "{map:?}");
        run.store.refinements.forget();
        run.frame.content_mut().land = Arc::new(Land::default());
        run.store.refinements.hold(false);
        for _ in 0..4 {
            run.go_to(5.5);
        }
        assert!(!run.store.refinements.is_busy(), "{map:?}");
    }
}

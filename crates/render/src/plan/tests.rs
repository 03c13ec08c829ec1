//! The planner looks at tile groups, and only at what may hide something: what it decides must not depend on that.

use std::collections::{BTreeMap, HashSet};

use antipode_frame::Quality;
use antipode_geometry::{CHUNK_CELLS, ChartId, ChunkCoord};
use antipode_terrain::{ChunkMesh, Level, Vertex};
use glam::{DVec3, IVec2, IVec3, Vec3};

use super::testing::{Numbers, frame, spaces};
use super::*;

mod tiles;

const HEIGHT_PX: u32 = 720;

/// Land as chunks have it: some of their boxes, mostly solid below.
fn land(numbers: &mut Numbers, frame: &Frame) -> Vec<ChunkLand> {
    let mut found = BTreeMap::new();
    let home = ChunkCoord::containing(frame.view.eye.point).index;
    for _ in 0..600 {
        let closed = frame.view.strategy.is_closed();
        let reach = frame
            .view
            .strategy
            .domain(ChartId::FIRST)
            .radius_m()
            .map_or(14.0, |rim_m| 1.0 + rim_m / 32.0);
        let index = DVec3::new(
            numbers.between(-reach, reach),
            numbers.between(-2.0, 1.0),
            numbers.between(-reach, reach),
        );
        let mut index = index.floor().as_ivec3();
        index += if closed {
            IVec3::new(0, home.y, 0)
        } else {
            home
        };
        let other = closed && numbers.between(0.0, 1.0) > 0.5;
        let chart = if other {
            ChartId::SECOND
        } else {
            ChartId::FIRST
        };
        let coord = ChunkCoord { chart, index };
        let mut corner = || {
            DVec3::from_array(std::array::from_fn(|_| {
                numbers.between(-4.0, 36.0).clamp(0.0, 32.0)
            }))
        };
        let (a, b) = (corner(), corner());
        let (min, max) = (coord.origin() + a.min(b), coord.origin() + a.max(b));
        let over_m = (numbers.between(-20.0, 20.0)).max(0.0);
        let around_m = DVec3::new(0.1, 0.0, 0.1) * over_m;
        let level = Level::ALL[(numbers.between(0.0, 4.0)) as usize];
        let chunk = ChunkLand {
            coord,
            level,
            min,
            max,
            whole: [min - around_m, max + around_m + DVec3::Y * over_m],
            triangles: numbers.between(1.0, 5000.0) as usize,
            error_m: numbers.between(0.0, 2.0),
            ground: Ground::random(numbers),
        };
        found.insert(coord, chunk);
    }
    found.into_values().collect()
}

/// The same decisions, chunk by chunk and column by column.
fn plainly(frame: &Frame, land: &[ChunkLand]) -> (Vec<ChunkChoice>, PlanStats) {
    let scale = PictureScale::new(&frame.view.projection, HEIGHT_PX);
    let tolerance = Tolerance::of(frame.view.quality);
    let mut stats = PlanStats::default();
    let (space, eye) = (frame.view.strategy.as_ref(), &frame.view.eye);
    let frustum = space.frustum(eye, &frame.view.projection);
    let home = ChunkCoord::containing(eye.point).index;
    let mut seen = Vec::new();
    for (place, chunk) in land.iter().enumerate() {
        let cell = frustum.cell_seen(
            space,
            eye,
            chunk.coord.chart,
            chunk.whole[0],
            chunk.whole[1],
        );
        match cell.filter(|cell| cell.nearest_m <= f64::from(frame.view.fog_distance_m)) {
            Some(cell) if scale.spans_px(&cell) < tolerance.small_px => {
                stats.triangles_small += chunk.triangles;
                stats.error_at_least(scale.spans_px(&cell));
            }
            Some(cell) => {
                let steps = chunk.coord.index - home;
                let ring = steps.x.unsigned_abs() + steps.z.unsigned_abs();
                seen.push(Candidate {
                    place,
                    cell,
                    ring,
                    shows_land: true,
                });
            }
            None => stats.triangles_outside += chunk.triangles,
        }
    }
    let land_index = LandIndex::new(land.to_vec());
    let mut rings = Rings::of(frame);
    if hides(frame, &mut rings, &land_index, &tolerance) {
        seen.sort_by_key(|candidate| candidate.ring);
        let mut columns = land_index.columns().to_vec();
        let ring_of = |column: &skyline::Column| {
            column.place.x.abs_diff(home.x) + column.place.y.abs_diff(home.z)
        };
        columns.sort_by_key(ring_of);
        let mut skyline = Skyline::new(frame, scale);
        skyline.want(&SightCell::EVERYWHERE, u32::MAX);
        let (mut next, mut left_out) = (0, HashSet::new());
        seen.retain_mut(|candidate| {
            while next < columns.len() && ring_of(&columns[next]) < candidate.ring {
                if !left_out.contains(&columns[next].place) {
                    let grid = rings.grid(columns[next].chart);
                    skyline.raise(&columns[next], &grid, ring_of(&columns[next]));
                }
                next += 1;
            }
            let chunk = &land[candidate.place];
            let over_px = skyline.rises_px(&candidate.cell);
            let land = space.sight_cell(eye, chunk.coord.chart, chunk.min, chunk.max);
            candidate.shows_land = over_px > 0.0 && skyline.rises_px(&land) > 0.0;
            if !candidate.shows_land {
                stats.triangles_hidden += chunk.triangles;
            } else if over_px < tolerance.small_px {
                stats.triangles_small += chunk.triangles;
            }
            if over_px > 0.0 && over_px < tolerance.small_px {
                stats.error_at_least(over_px);
                left_out.insert(IVec2::new(chunk.coord.index.x, chunk.coord.index.z));
            }
            over_px >= tolerance.small_px
        });
    }
    seen.sort_by_key(|candidate| candidate.place);
    seen.sort_by(|a, b| a.cell.nearest_m.total_cmp(&b.cell.nearest_m));
    let bounds = Bounds::measure(frame, scale);
    let choices = seen.iter().map(|candidate| {
        let chunk = &land[candidate.place];
        let metre_px = scale.spans_px(&candidate.cell) / f64::from(CHUNK_CELLS);
        stats.level_error_at_least(chunk.error_m * metre_px);
        let choice = choice::choose(frame, chunk, candidate, &bounds, &tolerance);
        stats.count(&choice, chunk);
        choice
    });
    (choices.collect(), stats)
}

/// A frame from somewhere, looking somewhere.
fn pose(numbers: &mut Numbers, frame: &mut Frame, dials: [f64; 2]) {
    let space = Arc::clone(&frame.view.strategy);
    let reach_m = space.domain(ChartId::FIRST).radius_m().unwrap_or(500.0);
    let level = numbers.turn() * numbers.between(0.0, reach_m);
    let (low, high) = space
        .limits()
        .map_or((-40.0, 40.0), |l| (l.ground_min_m, l.ceiling_m));
    frame.view.eye = Eye {
        point: frame.view.eye.point,
        yaw: numbers.between(-3.2, 3.2),
        pitch: numbers.between(-1.5, 1.5) * numbers.between(0.0, 1.0),
        roll: 0.0,
        dial: numbers.between(dials[0], dials[1]),
        lift_m: 1.62,
    };
    frame.view.eye.point.pos = DVec3::new(level.x, numbers.between(low, high), level.y);
    frame.view.fog_distance_m = numbers.between(50.0, 600.0) as f32;
    frame.view.quality = Quality::ALL[numbers.between(0.0, 3.0) as usize];
}

#[test]
fn tracts_and_what_is_wanted_of_the_skyline_change_no_decision() {
    let mut numbers = Numbers::new(11);
    for (name, space, dials) in spaces() {
        let mut frame = frame(&space);
        let mut planner = Planner::default();
        let (mut drawn, mut hidden, mut outside, mut tops) = (0, 0, 0, 0);
        for round in 0..40 {
            pose(&mut numbers, &mut frame, dials);
            let land = land(&mut numbers, &frame);
            let land_index = LandIndex::new(land.clone());
            for turn in 0..4 {
                frame.view.eye.yaw += f64::from(turn);
                let planned = planner.plan(&frame, HEIGHT_PX, &land_index);
                let (choices, stats) = plainly(&frame, &land);
                let at = format!("{name}, round {round}, {:?}", frame.view.eye);
                assert_eq!(planned.chunks, choices, "{at}");
                assert_eq!(planned.stats, stats, "{at}");
                drawn += stats.chunks_by_level.iter().sum::<usize>();
                hidden += stats.triangles_hidden;
                outside += stats.triangles_outside;
                tops += choices.iter().filter(|it| !it.shows_land).count();
            }
        }
        // The comparison is of something.
        assert!(drawn > 500 && outside > 1000, "{name}: {drawn} {outside}");
        let hides = [hidden > 1000, tops > 0];
        assert_eq!(
            hides,
            [space.keeps_azimuths(); 2],
            "{name}: {hidden} {tops}"
        );
    }
}

/// The land of a chunk where the ground is as high as `height_m` says at x and z in whole metres of the chart, and
/// straight between; nothing where none of it lies in the chunk.
fn chunk(index: IVec3, height_m: impl Fn(f64, f64) -> f64) -> Option<ChunkLand> {
    chunk_of(ChunkCoord::new(ChartId::FIRST, index), height_m)
}

fn chunk_of(coord: ChunkCoord, height_m: impl Fn(f64, f64) -> f64) -> Option<ChunkLand> {
    let cells = CHUNK_CELLS as u32;
    let over = |x: u32, z: u32| {
        let at = coord.origin() + DVec3::new(f64::from(x), 0.0, f64::from(z));
        height_m(at.x, at.z) - at.y
    };
    let mut mesh = ChunkMesh::default();
    for (x, z) in (0..cells).flat_map(|x| (0..cells).map(move |z| (x, z))) {
        let corners = [(x, z), (x, z + 1), (x + 1, z + 1), (x + 1, z)];
        let heights = corners.map(|(x, z)| over(x, z));
        if heights.iter().any(|h| (0.0..=32.0).contains(h)) {
            let first = mesh.vertices.len() as u32;
            for ((x, z), height) in corners.into_iter().zip(heights) {
                let place = Vec3::new(x as f32, height.clamp(0.0, 32.0) as f32, z as f32);
                mesh.vertices.push(Vertex::new(place, Vec3::Y, [0; 3]));
            }
            mesh.indices.extend([0, 1, 2, 0, 2, 3].map(|i| first + i));
        }
    }
    (!mesh.indices.is_empty()).then(|| ChunkLand::of(coord, &mesh))
}

#[test]
fn parts_of_a_column_are_told_to_be_solid_up_to_the_ground_and_no_higher() {
    let height_m = |x: f64, z: f64| {
        34.0 + 16.0 * (0.071 * x).sin() * (0.053 * z).cos() + 7.0 * (0.31 * x + 0.23 * z).sin()
    };
    let (mut told, mut tight) = (0, 0);
    for (x, z) in (-3..3).flat_map(|x| (-3..3).map(move |z| (x, z))) {
        let chunks = (0..2).filter_map(|y| chunk(IVec3::new(x, y, z), height_m));
        let chunks: Vec<_> = chunks.collect();
        let Some(solid_below_m) = Ground::solid_below_m(chunks.iter()) else {
            continue;
        };
        for (part, solid_m) in solid_below_m.into_iter().enumerate() {
            let from = |chunk: i32, part: usize| f64::from(32 * chunk + 8 * part as i32);
            let (from_x, from_z) = (from(x, part % 4), from(z, part / 4));
            let steps = || (0..=8).map(f64::from);
            let all = steps().flat_map(|i| steps().map(move |j| height_m(from_x + i, from_z + j)));
            let lowest_m = all.fold(f64::INFINITY, f64::min);
            assert!(
                solid_m <= lowest_m + 1e-3,
                "{x} {z} {part}: {solid_m} {lowest_m}"
            );
            told += 1;
            tight += u32::from(solid_m > lowest_m - 1e-3);
        }
    }
    assert!(told > 300 && 10 * tight > 9 * told, "{told} {tight}");
}

#[test]
fn a_ridge_hides_what_is_behind_it_and_a_gap_in_it_does_not() {
    let (_, space, _) = spaces().swap_remove(0);
    let mut frame = frame(&space);
    frame.view.eye.point.pos = DVec3::new(16.0, 6.0, 16.0);
    // A ridge from 36 to 60 m off, in the second row of chunks; the gap is as wide as two parts of one.
    let ridge = |x: f64| 4.0 + 20.0 * (3.0 - (x - 48.0).abs() / 4.0).clamp(0.0, 1.0);
    let gap = |z: f64| if (8.0..=24.0).contains(&z) { 0.0 } else { 1.0 };
    let seen = |height_m: &dyn Fn(f64, f64) -> f64| -> Vec<IVec3> {
        let indices = (0..6).flat_map(|x| (-4..5).map(move |z| IVec3::new(x, 0, z)));
        let land: Vec<_> = indices.filter_map(|index| chunk(index, height_m)).collect();
        let planned = plan(&frame, HEIGHT_PX, &land);
        planned
            .chunks
            .iter()
            .map(|choice| land[choice.place].coord.index)
            .collect()
    };
    let flat = seen(&|_, _| 4.0);
    assert!(flat.iter().any(|index| index.x == 5), "{flat:?}");
    let behind = seen(&|x, _| ridge(x));
    assert!(behind.contains(&IVec3::new(1, 0, 0)), "{behind:?}");
    assert!(behind.iter().all(|index| index.x < 2), "{behind:?}");
    let through = seen(&|x, z| 4.0 + (ridge(x) - 4.0) * gap(z));
    for x in 2..6 {
        assert!(through.contains(&IVec3::new(x, 0, 0)), "{through:?}");
    }
    // What is aside of the gap stays hidden.
    assert!(!through.contains(&IVec3::new(2, 0, 2)), "{through:?}");
}

//! The hyperbolic world in squares: what is drawn of it is true over all edges, and the light is the same on both sides.

use std::sync::Arc;

use crate::common::{Studio, difference, frame, seen_at};
use antipode_frame::{ChunkChange, Frame, Land};
use antipode_geometry::tiling::APOTHEM;
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Eye, HyperbolicWorld, Strategy};
use antipode_render::ShadowQuality;
use antipode_terrain::{ChunkMesh, Field, Vertex, march};
use glam::{DVec3, IVec3, Vec2, Vec3};
use image::{Rgba, RgbaImage};

pub const SIZE: (u32, u32) = (320, 240);
pub const ASPECT: f64 = 4.0 / 3.0;
/// Half the width of a square, metres of its chart.
pub const HALF_M: f64 = 32.0;

pub fn world() -> Arc<dyn Strategy> {
    let world: Arc<dyn Strategy> = Arc::new(HyperbolicWorld::new(60.305));
    assert!((APOTHEM * world.radius_m() - HALF_M).abs() < 1e-9);
    world
}

/// The tiles within so many metres of a place.
fn tiles(world: &dyn Strategy, about: ChartPoint, within_m: f64) -> Vec<ChartId> {
    let eye = Eye::default();
    let numbers = (0..400).map(ChartId::new);
    let near = |chart: &ChartId| {
        let middle = ChartPoint::new(*chart, DVec3::ZERO);
        world.distance_m(about, middle, &eye) < within_m
    };
    numbers.filter(near).collect()
}

/// The four columns of a square.
fn columns() -> impl Iterator<Item = (i32, i32)> {
    [(-1, -1), (-1, 0), (0, -1), (0, 0)].into_iter()
}

/// A chunk of level ground at y = 0 in squares of a metre.
pub fn level(kind: [u8; 3]) -> Arc<ChunkMesh> {
    let mut mesh = ChunkMesh::default();
    for (i, j) in (0..=32_u32).flat_map(|i| (0..=32).map(move |j| (i, j))) {
        let at = Vec3::new(i as f32, 0.0, j as f32);
        mesh.vertices.push(Vertex::new(at, Vec3::Y, kind));
    }
    for (i, j) in (0..32_u32).flat_map(|i| (0..32).map(move |j| (i, j))) {
        let at = i * 33 + j;
        let across = at + 33;
        mesh.indices
            .extend([at, at + 1, across, at + 1, across + 1, across]);
    }
    Arc::new(mesh)
}

pub fn plain(world: &dyn Strategy, about: ChartPoint, within_m: f64) -> Arc<Land> {
    let mesh = level([90, 120, 60]);
    let mut land = Land::default();
    for chart in tiles(world, about, within_m) {
        for (x, z) in columns() {
            let index = IVec3::new(x, 0, z);
            land.change(ChunkChange::Put(
                ChunkCoord { chart, index },
                Arc::clone(&mesh),
            ));
        }
    }
    Arc::new(land)
}

/// Generated land of the tiles within so many metres of a place.
fn grown(world: &Arc<dyn Strategy>, about: ChartPoint, within_m: f64) -> Arc<Land> {
    let field = Field::new(2, world.clone());
    let mut land = Land::default();
    for chart in tiles(&**world, about, within_m) {
        for (x, z) in columns() {
            for y in -2..3 {
                let coord = ChunkCoord {
                    chart,
                    index: IVec3::new(x, y, z),
                };
                let mesh = march(&field.samples(coord), &field, coord);
                if !mesh.indices.is_empty() {
                    land.change(ChunkChange::Put(coord, Arc::new(mesh)));
                }
            }
        }
    }
    Arc::new(land)
}

fn corner(height_m: f64) -> ChartPoint {
    ChartPoint::a(DVec3::new(HALF_M, height_m, HALF_M))
}

/// The same picture from a place told in another chart.
fn told_in(frame: &Frame, crossing: antipode_geometry::Crossing) -> Frame {
    frame.clone().with_view(|it| {
        it.eye.point = crossing.point;
        it.eye.yaw -= crossing.turn_rad;
    })
}

#[test]
fn the_picture_is_the_same_whichever_of_five_charts_the_eye_is_told_in() {
    let Some(mut studio) = Studio::shadowed(SIZE, ShadowQuality::High) else {
        return;
    };
    let world = world();
    let ground = Field::new(2, world.clone()).surface_height(ChartId::FIRST, HALF_M, HALF_M);
    let at = corner(ground + 6.0);
    let land = grown(&world, at, 110.0);
    for (yaw, pitch) in [(0.3, -0.5), (2.4, -0.15), (-1.7, -1.2)] {
        let mut frame = frame(&world, at, ASPECT).with_content(|it| it.land = Arc::clone(&land));
        frame.view.eye = Eye {
            yaw,
            pitch,
            ..frame.view.eye
        };
        let one = studio.picture(&frame);
        let images = world.images(at, 1.0);
        assert_eq!(images.len(), 4);
        let stepped = frame.clone().with_view(|it| it.eye.point.pos.x += 0.02);
        let (_, step) = difference(&one, &studio.picture(&stepped));
        for crossing in images {
            let other = studio.picture(&told_in(&frame, crossing));
            let (_, mean) = difference(&one, &other);
            assert!(
                mean < 0.1 * step && mean < 0.02,
                "{yaw} {pitch}: {mean}, a step {step}"
            );
        }
    }
}

/// Who passes the corner sees nothing jump: from step to step the picture changes as much in the next chart as in the last.
#[test]
fn over_a_corner_pictures_change_as_from_step_to_step() {
    let Some(mut studio) = Studio::shadowed(SIZE, ShadowQuality::Low) else {
        return;
    };
    let world = world();
    let ground = Field::new(2, world.clone()).surface_height(ChartId::FIRST, HALF_M, HALF_M);
    let land = grown(&world, corner(ground), 110.0);
    let mut frame = frame(&world, corner(ground + 4.0), ASPECT).with_content(|it| it.land = land);
    frame.view.eye.yaw = 0.7;
    frame.view.eye.pitch = -0.4;
    let mut changes = Vec::new();
    let (mut last, mut charts) = (None, vec![ChartId::FIRST]);
    frame.view.eye.point.pos -= DVec3::new(0.3, 0.0, 0.32);
    for _ in 0..14 {
        let picture = studio.picture(&frame);
        if let Some(last) = last.replace(picture.clone()) {
            changes.push(difference(&last, &picture).1);
        }
        frame.view.eye.point.pos += 0.06 * frame.view.eye.front().with_y(0.0).normalize();
        if let Some(crossing) = world.cross(frame.view.eye.point) {
            frame = told_in(&frame, crossing);
            charts.push(crossing.point.chart);
        }
    }
    assert!(charts.len() > 1, "a corner is passed");
    let mut sorted = changes.clone();
    sorted.sort_by(f64::total_cmp);
    let (middle, most) = (sorted[sorted.len() / 2], sorted[sorted.len() - 1]);
    assert!(most < 1.5 * middle + 0.1, "{changes:?}");
}

/// At noon level ground is as bright on both sides of every edge and everywhere, since the sun stands as high; and by a low sun its slopes
/// are lit as the north of their place says.
#[test]
fn the_day_is_the_same_in_all_squares() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let world = world();
    let mut seen = Vec::new();
    for chart in [0, 1, 3, 9, 40, 200].map(ChartId::new) {
        let at = ChartPoint::new(chart, DVec3::new(11.0, 6.0, -7.0));
        let mut frame = frame(&world, at, ASPECT);
        let axis = |axis: DVec3| world.in_sky_axes(at, axis).x;
        // A wall that looks east in the axes of the sky.
        let south = DVec3::new(axis(DVec3::X), 0.0, axis(DVec3::Z));
        frame.view.eye.yaw = south.z.atan2(south.x);
        let face = -2.0 * south;
        let across = DVec3::Y.cross(south);
        let middle = at.pos + 8.0 * south;
        let corner = |a: f64, b: f64| (middle + 3.0 * (a * across + b * DVec3::Y)).as_vec3();
        let wall = [
            corner(1.0, -1.0),
            corner(-1.0, -1.0),
            corner(-1.0, 1.0),
            corner(1.0, 1.0),
        ];
        let coord = ChunkCoord::containing(ChartPoint::new(chart, middle));
        let origin = coord.origin().as_vec3();
        assert!(
            (wall[1] - wall[0])
                .cross(wall[3] - wall[0])
                .dot(face.as_vec3())
                > 0.0
        );
        let mesh = crate::common::plates(&[wall.map(|at| at - origin)]);
        frame.content_mut().land = crate::common::one_chunk(coord, mesh);
        frame.content_mut().sky.key_direction = [-0.8, 0.6, 0.0];
        let picture = studio.picture(&frame);
        seen.push(picture.get_pixel(SIZE.0 / 2, SIZE.1 / 2).0);
    }
    assert!(seen[0][0] > 150, "the wall looks to the sun: {seen:?}");
    for pixel in &seen {
        let off = (0..3).map(|i| pixel[i].abs_diff(seen[0][i])).max();
        assert!(off <= Some(3), "{seen:?}");
    }
}

pub fn keep(picture: &RgbaImage, name: &str) {
    if let Some(folder) = std::env::var_os("ANTIPODE_TEST_PICTURES") {
        let path = std::path::Path::new(&folder)
            .join(name)
            .with_extension("png");
        picture.save(path).unwrap();
    }
}

/// Whether a pixel is the magenta that stands in for the sky.
fn is_sky(pixel: Rgba<u8>) -> bool {
    let [r, g, b, _] = pixel.0;
    r > 200 && b > 200 && g < 60
}

#[test]
fn five_squares_meet_at_a_corner_without_a_hole() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let world = world();
    for height_m in [1.7, 9.0, 40.0] {
        let at = ChartPoint::a(DVec3::new(HALF_M - 0.3, height_m, HALF_M - 0.4));
        let land = plain(&*world, at, 260.0);
        for turn in 0..10 {
            let mut frame = frame(&world, at, ASPECT).with_content(|it| {
                it.land = Arc::clone(&land);
                it.sky.top = [9.0, 0.0, 9.0];
                it.sky.horizon = [9.0, 0.0, 9.0];
                it.sky.glare = [0.0; 3];
            });
            frame.view.fog_distance_m = antipode_frame::View::NO_FOG_M;
            frame.view.eye.yaw = 0.63 * f64::from(turn);
            frame.view.eye.pitch = -1.5;
            let picture = studio.picture(&frame);
            let holes = picture.pixels().filter(|it| is_sky(**it)).count();
            keep(&picture, &format!("holes-{height_m}-{turn}"));
            assert_eq!(holes, 0, "{height_m} {turn}");
        }
    }
}

/// A red plate a metre wide in a tile is seen where the space says, however far the tile.
#[test]
fn what_stands_in_far_tiles_is_seen_where_the_space_says() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let world = world();
    let eye = ChartPoint::new(ChartId::new(9), DVec3::new(20.0, 12.0, -28.0));
    for chart in [0, 1, 2, 9, 10, 30].map(ChartId::new) {
        let place = ChartPoint::new(chart, DVec3::new(16.0, 8.0, 16.0));
        let mut frame = frame(&world, eye, ASPECT);
        frame.view.fog_distance_m = antipode_frame::View::NO_FOG_M;
        let way = world
            .view_point(&frame.view.eye, place)
            .truncate()
            .normalize();
        let way = frame.view.eye.to_chart(way);
        let plate = |half: f32, across: Vec2| {
            let at = |x: f32, y: f32| Vec3::new(16.0 + x * across.x, 8.0 + y, 16.0 + x * across.y);
            let round = [
                at(-half, -half),
                at(half, -half),
                at(half, half),
                at(-half, half),
            ];
            let mut back = round;
            back.reverse();
            [round, back]
        };
        let cross = [plate(6.0, Vec2::X), plate(6.0, Vec2::Y)];
        let coord = ChunkCoord {
            chart,
            index: IVec3::ZERO,
        };
        frame.content_mut().land =
            crate::common::one_chunk(coord, crate::common::plates(cross.as_flattened()));
        frame.view.eye.yaw = way.z.atan2(way.x) + 0.2;
        frame.view.eye.pitch = way.y.asin() - 0.1;
        let picture = studio.picture(&frame);
        let (x, y) = seen_at(&frame, place, SIZE);
        let red = picture
            .enumerate_pixels()
            .filter(|(.., p)| p.0[0] > p.0[2].saturating_add(50));
        let (sum, count) = red.fold(((0.0, 0.0), 0.0), |((sx, sy), n), (i, j, _)| {
            ((sx + f64::from(i) + 0.5, sy + f64::from(j) + 0.5), n + 1.0)
        });
        let off = (sum.0 / count - x).hypot(sum.1 / count - y);
        println!("{chart}: {count} pixels, {off} off");
        keep(&picture, &format!("plate-{}", chart.number()));
        assert!(
            count > 3.0 && off < 1.0,
            "{chart}: {count} pixels, {off} off"
        );
    }
}

/// Pictures to be looked at, where `ANTIPODE_TEST_PICTURES` names a folder.
#[test]
fn pictures_of_a_corner_for_the_eye() {
    if std::env::var_os("ANTIPODE_TEST_PICTURES").is_none() {
        return;
    }
    let Some(mut studio) = Studio::shadowed((640, 480), ShadowQuality::High) else {
        return;
    };
    let world = world();
    let ground = Field::new(2, world.clone()).surface_height(ChartId::FIRST, HALF_M, HALF_M);
    let land = grown(&world, corner(ground), 190.0);
    let views = [
        ("overhead", 70.0, 0.0, -1.5),
        ("ahead", 3.0, 0.8, -0.1),
        ("high", 25.0, 2.5, -0.45),
    ];
    for (name, height_m, yaw, pitch) in views {
        for (light, minutes) in [("noon", 150.0), ("dusk", 285.0), ("morning", 60.0)] {
            let at = ChartPoint::a(DVec3::new(HALF_M - 2.0, ground + height_m, HALF_M - 3.0));
            let mut frame = frame(&world, at, ASPECT);
            frame.content_mut().sky = antipode_scene::day::sky(minutes, &*world, &frame.view.eye);
            frame.content_mut().land = Arc::clone(&land);
            frame.view.fog_distance_m = 300.0;
            frame.view.eye.yaw = yaw;
            frame.view.eye.pitch = pitch;
            keep(&studio.picture(&frame), &format!("{name}-{light}"));
        }
    }
    let Some(mut card) = Studio::for_card((640, 480)) else {
        return;
    };
    for (name, height_m, pitch) in [("near", 1.7, -0.9), ("above", 7.0, -1.4)] {
        let at = ChartPoint::a(DVec3::new(HALF_M - 1.0, ground + height_m, HALF_M - 0.7));
        let mut frame = frame(&world, at, ASPECT).with_content(|it| it.land = Arc::clone(&land));
        frame.view.eye.yaw = 0.7;
        frame.view.eye.pitch = pitch;
        keep(&card.picture(&frame), &format!("card-{name}"));
    }
}

//! What must hold in every space: the marker stands where it points, letters read, nothing is turned inside out,
//! and crossing the equator changes nothing.

use std::sync::Arc;

use crate::common::triangles::{Surface, triangles};
use crate::common::worlds::World;
use crate::common::{
    GEOMETRIES, Studio, difference, frame, land, middle_of_change, one_chunk, plates, seen_at,
    space,
};
use antipode_frame::{ChunkChange, Frame, Marker, MarkerShape};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Eye, Geometry, Strategy, strategy};
use antipode_terrain::{ChunkMesh, Kind};
use glam::{DVec3, IVec3, Vec3};
use image::RgbaImage;

const SIZE: (u32, u32) = (240, 180);
const ASPECT: f64 = 4.0 / 3.0;

#[test]
fn the_marker_is_within_a_pixel_of_what_it_points_at() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for geometry in GEOMETRIES {
        let space = space(geometry);
        let mut frame = frame(&space, ChartPoint::a(DVec3::new(3.0, 9.0, -2.0)), ASPECT);
        frame.view.eye.pitch = -0.2;
        let without = studio.picture(&frame);
        for (direction, distance_m) in [
            (DVec3::NEG_Z, 4.0),
            (DVec3::NEG_Z, 16.0),
            (DVec3::new(0.3, -0.2, -1.0), 9.0),
        ] {
            let point = space.along(&frame.view.eye, direction.normalize(), distance_m);
            let marked = frame.clone().with_content(|it| {
                it.lights = antipode_frame::Lights::default();
                it.marker = Some(Marker {
                    point,
                    radius_m: 0.8,
                    active: false,
                    shape: MarkerShape::Ball,
                    ground: None,
                });
            });
            let picture = studio.picture(&marked);
            let (x, y) = middle_of_change(&picture, &without).expect("the marker is seen");
            let (want_x, want_y) = seen_at(&frame, point, SIZE);
            assert!(
                (x - want_x).hypot(y - want_y) <= 1.0,
                "{geometry} {distance_m} m: {x} {y}, not {want_x} {want_y}"
            );
        }
    }
}

/// A letter F, 8 m tall in a chunk's plane x = 16, to be read by an eye that looks along +x.
fn letter_f() -> Arc<ChunkMesh> {
    let bar = |z: f32, y: f32, width: f32, height: f32| {
        let at = |dz: f32, dy: f32| Vec3::new(16.0, y + dy, z + dz);
        [
            at(0.0, 0.0),
            at(0.0, height),
            at(width, height),
            at(width, 0.0),
        ]
        .map(|p| p)
    };
    // Counter-clockwise seen from -x: right of the picture is +z.
    let flip = |[a, b, c, d]: [Vec3; 4]| [a, d, c, b];
    plates(
        &[
            bar(6.0, 2.0, 1.5, 8.0),
            bar(7.5, 8.5, 3.5, 1.5),
            bar(7.5, 5.5, 2.5, 1.5),
        ]
        .map(flip),
    )
}

fn reading(space: &Arc<dyn Strategy>, chart: ChartId, mesh: Arc<ChunkMesh>) -> Frame {
    let corner = ChunkCoord {
        chart,
        index: IVec3::ZERO,
    };
    let eye = ChartPoint::new(chart, DVec3::new(6.0, 6.0, 8.5));
    frame(space, eye, ASPECT).with_content(|it| it.land = one_chunk(corner, mesh))
}

fn red(picture: &RgbaImage, x: std::ops::Range<f64>, y: std::ops::Range<f64>) -> usize {
    let inside =
        |i: u32, size: u32, r: &std::ops::Range<f64>| r.contains(&(f64::from(i) / f64::from(size)));
    picture
        .enumerate_pixels()
        .filter(|(i, j, p)| {
            inside(*i, SIZE.0, &x)
                && inside(*j, SIZE.1, &y)
                && u16::from(p.0[0]) > u16::from(p.0[2]) + 60
        })
        .count()
}

#[test]
fn the_letter_f_reads_as_f_in_every_space_and_hemisphere() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for geometry in GEOMETRIES {
        let space = space(geometry);
        let charts: &[_] = if space.is_closed() {
            &[ChartId::FIRST, ChartId::SECOND]
        } else {
            &[ChartId::FIRST]
        };
        for &chart in charts {
            let mut frame = reading(&space, chart, letter_f());
            frame.content_mut().loaded_world =
                geometry as u64 * 2 + u64::from(chart == ChartId::SECOND);
            let picture = studio.picture(&frame);
            let [upper_left, upper_right, lower_left, lower_right] = [
                red(&picture, 0.0..0.5, 0.0..0.5),
                red(&picture, 0.5..1.0, 0.0..0.5),
                red(&picture, 0.0..0.5, 0.5..1.0),
                red(&picture, 0.5..1.0, 0.5..1.0),
            ];
            let quarters = (upper_left, upper_right, lower_left, lower_right);
            assert!(
                upper_right > 300,
                "{geometry} {chart:?}: arms at the upper right, {quarters:?}"
            );
            assert!(
                lower_left > 200 && lower_left > 4 * lower_right,
                "{geometry} {chart:?}: {quarters:?}"
            );
        }
    }
}

#[test]
fn surfaces_are_seen_from_outside_only_in_every_space_and_hemisphere() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let mut world = 0;
    for geometry in GEOMETRIES {
        let space = space(geometry);
        for chart in [ChartId::FIRST, ChartId::SECOND] {
            if chart == ChartId::SECOND && !space.is_closed() {
                continue;
            }
            let mut turned = ChunkMesh::clone(&letter_f());
            turned
                .indices
                .chunks_exact_mut(3)
                .for_each(|t| t.swap(1, 2));
            for (mesh, seen) in [(letter_f(), true), (Arc::new(turned), false)] {
                world += 1;
                let frame = reading(&space, chart, mesh).with_content(|it| it.loaded_world = world);
                let found = red(&studio.picture(&frame), 0.0..1.0, 0.0..1.0);
                assert_eq!(found > 500, seen, "{geometry} {chart:?} {seen}: {found}");
            }
        }
    }
}

#[test]
fn the_picture_is_the_same_before_and_after_crossing_the_equator() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let space = space(Geometry::Spherical);
    let rim_m = space.domain(ChartId::FIRST).radius_m().unwrap();
    let angle = 0.7_f64;
    let ground = DVec3::new(angle.cos(), 0.0, angle.sin()) * (rim_m + 0.1);
    let before = ChartPoint::a(ground + DVec3::Y * 22.0);
    let mut frame =
        frame(&space, before, ASPECT).with_content(|it| it.land = land(&space, before, 0));
    for (yaw, pitch) in [(angle, -0.3), (angle + 2.0, -0.9), (angle - 1.2, 0.9)] {
        frame.view.eye = Eye {
            point: before,
            yaw,
            pitch,
            ..frame.view.eye
        };
        let one = studio.picture(&frame);
        let crossing = space.images(before, f64::INFINITY)[0];
        frame.view.eye = Eye {
            point: crossing.point,
            yaw: yaw - crossing.turn_rad,
            pitch,
            ..frame.view.eye
        };
        let other = studio.picture(&frame);
        let (_, mean) = difference(&one, &other);
        assert!(mean < 0.25, "{yaw} {pitch}: {mean}");
    }
}

/// The two charts overlap by some metres; each draws its own side only, so that nothing lies in the same place
/// twice. Land of chart A alone must end 5 cm past the equator, in small worlds and in large ones.
#[test]
fn land_past_the_equator_is_left_to_the_other_chart() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for radius_m in [32.0, 100.0, 256.0] {
        land_ends_at_the_equator(&mut studio, &strategy(Geometry::Spherical, radius_m));
    }
}

fn land_ends_at_the_equator(studio: &mut Studio, space: &Arc<dyn Strategy>) {
    let rim_m = space.domain(ChartId::FIRST).radius_m().unwrap();
    let column = (rim_m / 32.0).floor();
    let corner = ChunkCoord {
        chart: ChartId::FIRST,
        index: IVec3::new(column as i32, 0, -1),
    };
    let reach = (rim_m - 32.0 * column) as f32;
    // A strip along x, at z = -2..0, seen from above: it passes the equator well inside the chunk.
    let strip = [
        [1.0, 30.0],
        [1.0, 32.0],
        [reach + 6.0, 32.0],
        [reach + 6.0, 30.0],
    ]
    .map(|[x, z]: [f32; 2]| Vec3::new(x, 2.0, z));
    let eye = ChartPoint::a(DVec3::new(rim_m, 8.0, -1.0));
    let mut frame =
        frame(space, eye, ASPECT).with_content(|it| it.land = one_chunk(corner, plates(&[strip])));
    frame.view.eye.pitch = -std::f64::consts::FRAC_PI_2 + 1e-3;
    let picture = studio.picture(&frame);
    let (_, line) = seen_at(
        &frame,
        ChartPoint::a(DVec3::new(rim_m + 0.05, 2.0, -1.0)),
        SIZE,
    );
    let column = SIZE.0 / 2;
    let is_red = |y: u32| {
        picture.get_pixel(column, y).0[0] > picture.get_pixel(column, y).0[2].saturating_add(60)
    };
    let first_red = (0..SIZE.1).find(|&y| is_red(y)).expect("the strip is seen");
    assert!(
        (f64::from(first_red) - line).abs() <= 1.5,
        "{rim_m}: {first_red}, not {line}"
    );
    assert!(is_red(SIZE.1 - 5), "this side stays");
}

#[test]
fn a_marker_behind_land_still_shows_but_faintly() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let space = space(Geometry::Euclidean);
    let wall = plates(&[[
        [20.0, 0.0, 0.0],
        [20.0, 0.0, 20.0],
        [20.0, 20.0, 20.0],
        [20.0, 20.0, 0.0],
    ]
    .map(Vec3::from)]);
    let frame = reading(&space, ChartId::FIRST, wall);
    let plain = studio.picture(&frame);
    let mut change = |x: f64| {
        let point = ChartPoint::a(DVec3::new(x, 6.0, 8.5));
        let marked = frame.clone().with_content(|it| {
            it.marker = Some(Marker {
                point,
                radius_m: 4.0,
                active: false,
                shape: MarkerShape::Ball,
                ground: None,
            });
        });
        let (x, y) = seen_at(&marked, point, SIZE);
        let (p, q) = (studio.picture(&marked), &plain);
        let at = |picture: &RgbaImage| picture.get_pixel(x as u32, y as u32).0.map(i32::from);
        let (p, q) = (at(&p), at(q));
        (0..3).map(|i| (p[i] - q[i]).abs()).sum::<i32>()
    };
    let (before, behind) = (change(15.0), change(25.0));
    assert!(before > 2 * behind && behind > 2, "{before} {behind}");
}

#[test]
fn the_ring_about_a_brush_is_thin_lies_on_the_land_and_leaves_its_middle_free() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let space = space(Geometry::Euclidean);
    let wall = plates(&[[
        [20.0, 0.0, 0.0],
        [20.0, 0.0, 20.0],
        [20.0, 20.0, 20.0],
        [20.0, 20.0, 0.0],
    ]
    .map(Vec3::from)]);
    let frame = reading(&space, ChartId::FIRST, wall);
    let plain = studio.picture(&frame);
    let middle = ChartPoint::a(DVec3::new(20.0, 6.0, 8.5));
    let radius_m = 4.0;
    let mut shares = Vec::new();
    for shape in [MarkerShape::Ring, MarkerShape::SafeRing] {
        let marker = Some(Marker {
            point: middle,
            radius_m,
            active: true,
            shape,
            ground: None,
        });
        let marked = frame.clone().with_content(|it| it.marker = marker);
        let picture = studio.picture(&marked);
        let (x, y) = seen_at(&marked, middle, SIZE);
        let (at_rim, _) = seen_at(&marked, middle.moved(DVec3::Z * radius_m), SIZE);
        let radius = (at_rim - x).abs();
        let mut changed = 0.0;
        for (p, q, pixel) in picture.enumerate_pixels() {
            if pixel == plain.get_pixel(p, q) {
                continue;
            }
            changed += 1.0;
            let away = (f64::from(p) + 0.5 - x).hypot(f64::from(q) + 0.5 - y);
            assert!((away - radius).abs() < 6.0, "{away} of {radius} px");
        }
        shares.push(changed / (std::f64::consts::TAU * radius));
    }
    // Widths in pixels, edges included.
    assert!(shares[0] > 1.0 && shares[0] < 5.0, "{shares:?}");
    assert!(shares[1] > shares[0] && shares[1] < 8.0, "{shares:?}");
}

#[test]
fn the_ring_is_as_large_as_what_the_brush_digs_in_every_space() {
    const SIZE: (u32, u32) = (480, 360);
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let radius_m = 4.0;
    for (geometry, chunk, chart, east_m) in [
        (Geometry::Euclidean, 0, ChartId::FIRST, 16.0),
        (Geometry::Hyperbolic, 0, ChartId::FIRST, 16.0),
        // The equator is 50.3 m from the middle of each chart.
        (Geometry::Spherical, 1, ChartId::FIRST, 44.0),
        (Geometry::Spherical, 1, ChartId::SECOND, 44.0),
    ] {
        let space = space(geometry);
        let at = |east_m: f64, y: f64, z: f64| ChartPoint::new(chart, DVec3::new(east_m, y, z));
        let mut frame = frame(&space, at(east_m - 8.0, 13.0, 8.0), ASPECT);
        frame.view.eye.pitch = -0.95;
        let cell = |x: u8, z: u8| {
            let [x, z] = [x, z].map(|it| 2.0 * f32::from(it));
            [
                [x, 2.0, z],
                [x, 2.0, z + 2.0],
                [x + 2.0, 2.0, z + 2.0],
                [x + 2.0, 2.0, z],
            ]
            .map(Vec3::from)
        };
        let cells: Vec<_> = (0..16)
            .flat_map(|x| (0..9).map(move |z| cell(x, z)))
            .collect();
        let coord = ChunkCoord::new(chart, IVec3::new(chunk, 0, 0));
        frame.change_land([ChunkChange::Put(coord, plates(&cells))]);
        let plain = studio.picture(&frame);
        let middle = at(east_m, 2.0, 8.0);
        frame.content_mut().marker = Some(Marker {
            point: middle,
            radius_m,
            active: true,
            shape: MarkerShape::Ring,
            ground: None,
        });
        let marked = studio.picture(&frame);
        let is_changed = |(x, y): (f64, f64)| {
            let near = [-1.0, 0.0, 1.0].map(|by| [-1.0, 0.0, 1.0].map(|of| (x + by, y + of)));
            near.iter().flatten().any(|(x, y)| {
                let (x, y) = (*x as u32, *y as u32);
                marked.get_pixel(x, y) != plain.get_pixel(x, y)
            })
        };
        for turn in 0..16 {
            let way = DVec3::new(f64::from(turn).cos(), 0.0, f64::from(turn).sin());
            let seen = |share: f64| seen_at(&frame, middle.moved(way * radius_m * share), SIZE);
            let said = format!("{geometry} {chart:?}, turn {turn}: {:?}", seen(1.0));
            assert!(is_changed(seen(1.0)), "not on the ring, {said}");
            assert!(
                !is_changed(seen(0.8)) && !is_changed(seen(1.2)),
                "too wide, {said}"
            );
        }
        // What was chosen to build of is seen within it.
        for (kind, channel) in [(Kind::Crystal, 2), (Kind::Clay, 0)] {
            let offered = frame.clone().with_content(|it| {
                let marker = it.marker.as_mut().expect("it has a ring");
                marker.ground = Some(kind);
            });
            let shown = studio.picture(&offered);
            for turn in 0..16 {
                let way = DVec3::new(f64::from(turn).cos(), 0.0, f64::from(turn).sin());
                let pixels = |share: f64| {
                    let (x, y) = seen_at(&frame, middle.moved(way * radius_m * share), SIZE);
                    [&plain, &shown].map(|it| it.get_pixel(x as u32, y as u32).0)
                };
                let [was, is] = pixels(0.4);
                let strongest = (0..3).max_by_key(|c| is[*c]);
                let changed = was[1].abs_diff(is[1]) > 20;
                assert!(
                    strongest == Some(channel) && changed,
                    "{geometry} {chart:?}: {was:?} {is:?}"
                );
                let [was, is] = pixels(1.2);
                assert_eq!(was, is, "{geometry} {chart:?} outside");
            }
        }
    }
}

/// Where land ends before other land, a pixel and the next are metres apart: that makes no ring.
#[test]
fn the_ring_is_nowhere_but_on_its_circle_however_rugged_the_land() {
    for seed in [5, 7] {
        let mut world = World::new(Geometry::Euclidean, seed, 32.0, 4).of_lines(360);
        let Some(mut studio) = Studio::new(world.size()) else {
            return;
        };
        for yaw_deg in [0.0, 90.0, 180.0, 270.0] {
            world.aim(yaw_deg, -6.0);
            let marker = world.scene.marker().expect("a pickaxe is in hand");
            let plain = world.frame();
            let ringed = plain.clone().with_content(|it| {
                it.marker = Some(Marker {
                    active: true,
                    ..marker
                });
            });
            let pictures = [studio.picture(&plain), studio.picture(&ringed)];
            let triangles = triangles(&plain.content.land);
            let surface = Surface::of(&plain, &triangles, world.size());
            for (x, y, pixel) in pictures[1].enumerate_pixels() {
                let is_ring =
                    (0..3).any(|c| pixel.0[c].abs_diff(pictures[0].get_pixel(x, y).0[c]) > 24);
                if let (true, Some(seen)) = (is_ring, surface.get(x, y)) {
                    let at = triangles[seen.triangle as usize].at(seen.weights);
                    let off_m = (at.distance(marker.point.pos) - marker.radius_m).abs();
                    assert!(
                        off_m < 1.5,
                        "{seed} {yaw_deg}: {x} {y}, {off_m} m off the ring"
                    );
                }
            }
        }
    }
}
